//! What the author sees: the picture, what it costs, and what is wrong with the scene.

use std::path::{Path, PathBuf};

use egui::{Color32, Frame, PointerButton, RichText, Sense, Ui};
use glam::Vec2;

use super::camera;
use super::messages::{Look, Picture};
use crate::diagnostic::Report;
use crate::gpu::View;
use crate::ir::Camera;

/// What is shown, and what the author has chosen.
pub struct Panel {
    scene: PathBuf,
    scenes: Vec<PathBuf>,
    adapter: String,
    view: View,
    /// Where the author has moved the camera to.
    camera: Option<Camera>,
    /// The scene's own.
    home: Option<Camera>,
    mouse: [f32; 2],
    facts: Vec<(&'static str, String)>,
    /// Mistakes, or warnings of a scene that is shown.
    report: Option<(Report, String)>,
}

/// What the author has done.
pub struct Reply {
    pub look: Look,
    pub open: Option<PathBuf>,
}

impl Panel {
    pub fn new(scene: &Path, adapter: String) -> Self {
        Self {
            scene: scene.to_owned(),
            scenes: neighbours(scene),
            adapter,
            view: View::Color,
            camera: None,
            home: None,
            mouse: [0.0; 2],
            facts: vec![],
            report: None,
        }
    }

    /// A new picture is there. Its scene's camera wins over the author's where the file moved it.
    pub fn take(&mut self, picture: &Picture, is_new_edit: bool) {
        let camera = picture.compiled.scene.camera;
        if self.home != Some(camera) {
            self.home = Some(camera);
            self.camera = None;
        }
        if is_new_edit {
            self.mend(&picture.warnings);
        }
        let ms = |time: std::time::Duration| format!("{:.1} ms", time.as_secs_f64() * 1e3);
        let times = picture.compiled.times;
        let per_second = 1.0 / picture.frame_time.as_secs_f64().max(1e-6);
        self.facts = vec![
            ("frame", ms(picture.frame_time)),
            ("rate", format!("{per_second:.0} a second")),
            ("samples", format!("{}", picture.samples)),
            ("parse", ms(times.parse)),
            ("resolve", ms(times.resolve)),
            ("generate", ms(times.generate)),
            ("naga", ms(times.naga)),
            ("pipeline", ms(picture.pipeline_time)),
            ("objects", format!("{}", picture.compiled.scene.objects.len())),
            ("shader", format!("{:.1} KB", picture.compiled.source.text().len() as f64 / 1e3)),
        ];
    }

    /// The scene is right, but for `warnings`.
    pub fn mend(&mut self, warnings: &Report) {
        self.report = (!warnings.diagnostics.is_empty()).then(|| (warnings.clone(), warnings.to_string()));
    }

    /// The scene is wrong: the picture stays, the mistakes come over it.
    pub fn break_with(&mut self, report: Report) {
        let text = report.to_string();
        self.report = Some((report, text));
    }

    /// Lays everything out.
    pub fn show(&mut self, ui: &mut Ui, has_picture: bool) -> Reply {
        let open = egui::Panel::right("panel").exact_size(250.0).show(ui, |ui| self.side(ui)).inner;
        let look = egui::CentralPanel::no_frame().show(ui, |ui| self.picture(ui, has_picture)).inner;
        Reply { look, open }
    }

    fn side(&mut self, ui: &mut Ui) -> Option<PathBuf> {
        let mut open = None;
        ui.add_space(8.0);
        ui.horizontal(|ui| {
            ui.heading("raytoy");
            ui.with_layout(egui::Layout::right_to_left(egui::Align::Center), |ui| {
                ui.label(RichText::new(&self.adapter).weak().small());
            });
        });
        ui.separator();
        title(ui, "Scene");
        egui::ComboBox::from_id_salt("scene")
            .width(ui.available_width())
            .selected_text(stem(&self.scene))
            .show_ui(ui, |ui| {
                for scene in &self.scenes {
                    if ui.selectable_label(*scene == self.scene, stem(scene)).clicked()
                        && *scene != self.scene
                    {
                        open = Some(scene.clone());
                    }
                }
            });
        if let Some(scene) = &open {
            self.scene = scene.clone();
            self.camera = None;
        }
        title(ui, "View");
        let name = |view: View| View::ALL.iter().find(|(_, v)| *v == view).map_or("", |(name, _)| name);
        egui::ComboBox::from_id_salt("view")
            .width(ui.available_width())
            .selected_text(name(self.view))
            .show_ui(ui, |ui| {
                for (name, view) in View::ALL {
                    ui.selectable_value(&mut self.view, view, name);
                }
            });
        title(ui, "Camera");
        if let Some(camera) = self.camera.or(self.home) {
            let point = |p: glam::Vec3| format!("({:.2}, {:.2}, {:.2})", p.x, p.y, p.z);
            facts(ui, "camera", &[("eye", point(camera.eye)), ("target", point(camera.target))]);
        }
        ui.add_enabled_ui(self.camera.is_some(), |ui| {
            if ui.button("Back to the scene's camera").clicked() {
                self.camera = None;
            }
        });
        ui.label(RichText::new("drag: turn   right drag: move   wheel: zoom").weak().small());
        title(ui, "Cost");
        facts(ui, "cost", &self.facts);
        open
    }

    fn picture(&mut self, ui: &mut Ui, has_picture: bool) -> Look {
        let (area, response) = ui.allocate_exact_size(ui.available_size(), Sense::click_and_drag());
        if !has_picture && self.report.is_none() {
            let font = egui::FontId::proportional(16.0);
            ui.painter().text(area.center(), egui::Align2::CENTER_CENTER, "compiling…", font, Color32::GRAY);
        }
        self.move_camera(ui, &response, area);
        let points = ui.ctx().pixels_per_point();
        if let Some(pointer) = response.interact_pointer_pos() {
            self.mouse = [(pointer.x - area.min.x) * points, (pointer.y - area.min.y) * points];
        }
        if let Some((report, text)) = &self.report {
            overlay(ui, area, report, text);
        }
        let size = [(area.width() * points).round() as u32, (area.height() * points).round() as u32];
        Look { size, camera: self.camera, view: self.view, mouse: self.mouse }
    }

    fn move_camera(&mut self, ui: &Ui, response: &egui::Response, area: egui::Rect) {
        let Some(home) = self.home else { return };
        let mut moved = self.camera.unwrap_or(home);
        let before = moved;
        let drag = response.drag_delta() / area.height().max(1.0);
        let by = Vec2::new(drag.x, drag.y);
        let shift = ui.input(|input| input.modifiers.shift);
        if response.dragged_by(PointerButton::Primary) && !shift {
            camera::orbit(&mut moved, by);
        } else if response.dragged() {
            camera::pan(&mut moved, by);
        }
        if response.hovered() {
            let (scroll, pinch) = ui.input(|input| (input.smooth_scroll_delta.y, input.zoom_delta()));
            let amount = scroll * 0.004 + pinch.ln();
            if amount != 0.0 {
                camera::zoom(&mut moved, amount);
            }
        }
        if moved != before {
            self.camera = Some(moved);
        }
    }
}

/// Mistakes over the lower part of the picture.
fn overlay(ui: &mut Ui, area: egui::Rect, report: &Report, text: &str) {
    let (color, heading) = if report.has_errors() {
        (Color32::from_rgb(255, 110, 100), "The scene has mistakes. This is its last good picture.")
    } else {
        (Color32::from_rgb(245, 190, 80), "The scene has warnings.")
    };
    let frame = Frame::NONE
        .fill(Color32::from_black_alpha(215))
        .inner_margin(14.0)
        .stroke((1.0, color))
        .corner_radius(6);
    egui::Area::new(egui::Id::unique("mistakes"))
        .fixed_pos(area.left_bottom() + egui::vec2(12.0, -12.0))
        .pivot(egui::Align2::LEFT_BOTTOM)
        .show(ui.ctx(), |ui| {
            frame.show(ui, |ui| {
                let width = (area.width() - 54.0).max(100.0);
                ui.set_width(width);
                ui.label(RichText::new(heading).color(color).strong());
                ui.add_space(6.0);
                egui::ScrollArea::both().max_height(area.height() * 0.6).max_width(width).show(ui, |ui| {
                    let text = RichText::new(text.trim_end()).monospace().color(Color32::from_gray(225));
                    ui.add(egui::Label::new(text).wrap_mode(egui::TextWrapMode::Extend).selectable(true));
                });
            });
        });
}

fn title(ui: &mut Ui, text: &str) {
    ui.add_space(10.0);
    ui.label(RichText::new(text).strong());
}

fn facts(ui: &mut Ui, id: &str, facts: &[(&str, String)]) {
    egui::Grid::new(id).num_columns(2).spacing([16.0, 3.0]).show(ui, |ui| {
        for (name, value) in facts {
            ui.label(RichText::new(*name).weak());
            ui.label(RichText::new(value).monospace());
            ui.end_row();
        }
    });
}

fn stem(path: &Path) -> String {
    path.file_stem().unwrap_or_default().to_string_lossy().into_owned()
}

/// The scenes in the folder of `scene`, sorted.
fn neighbours(scene: &Path) -> Vec<PathBuf> {
    let folder = scene.parent().filter(|p| !p.as_os_str().is_empty()).unwrap_or(Path::new("."));
    let entries = std::fs::read_dir(folder).into_iter().flatten().flatten();
    let mut scenes: Vec<PathBuf> = entries
        .map(|entry| scene.with_file_name(entry.file_name()))
        .filter(|path| path.extension().is_some_and(|e| e == "ron"))
        .collect();
    scenes.sort();
    scenes
}
