//! The bars above and below the picture: scene, view, undo, saving; and the clock of scenes that move.

use std::path::Path;
use std::time::Instant;

use egui::{Align, Color32, Key, KeyboardShortcut, Layout, Modifiers, RichText, Ui};

use super::{Deeds, Panel};
use crate::app::builder::Order;
use crate::app::focus::Focus;
use crate::app::messages::Clock;
use crate::edit::{Edit, NewValue};
use crate::gpu::View;
use crate::outline::NodeKind;

const UNDO: KeyboardShortcut = KeyboardShortcut::new(Modifiers::COMMAND, Key::Z);
const REDO: KeyboardShortcut = KeyboardShortcut::new(Modifiers::COMMAND.plus(Modifiers::SHIFT), Key::Z);
const REDO_TOO: KeyboardShortcut = KeyboardShortcut::new(Modifiers::COMMAND, Key::Y);
const HOME: KeyboardShortcut = KeyboardShortcut::new(Modifiers::NONE, Key::Home);
const PAUSE: KeyboardShortcut = KeyboardShortcut::new(Modifiers::NONE, Key::Space);

const GIZMOS: KeyboardShortcut = KeyboardShortcut::new(Modifiers::NONE, Key::G);
const NOTHING: KeyboardShortcut = KeyboardShortcut::new(Modifiers::NONE, Key::Escape);

/// Seconds from one frame to the next when time is stepped by hand.
const FRAME: f32 = 1.0 / 60.0;
/// Seconds that the scrubber spans.
const SPAN: f32 = 20.0;

impl Panel {
    pub(super) fn keys(&mut self, ui: &Ui, deeds: &mut Deeds) {
        let pressed = |shortcut| ui.input_mut(|input| input.consume_shortcut(&shortcut));
        deeds.redo |= pressed(REDO) || pressed(REDO_TOO);
        deeds.undo |= pressed(UNDO);
        if ui.memory(|memory| memory.focused().is_some()) {
            return;
        }
        if pressed(HOME) {
            self.camera = None;
        }
        if pressed(PAUSE) {
            self.toggle_clock();
        }
        if pressed(GIZMOS) {
            self.gizmos = !self.gizmos;
        }
        if pressed(NOTHING) {
            self.selected = None;
        }
    }

    pub(super) fn bar(&mut self, ui: &mut Ui, deeds: &mut Deeds) {
        ui.add_space(3.0);
        ui.horizontal(|ui| {
            ui.label(RichText::new("raytoy").strong().size(15.0));
            ui.separator();
            self.scene_menu(ui, deeds);
            self.view_menu(ui);
            ui.separator();
            let button = |ui: &mut Ui, on: bool, text: &str, shortcut: KeyboardShortcut| {
                let help = ui.ctx().format_shortcut(&shortcut);
                ui.add_enabled(on, egui::Button::new(text)).on_hover_text(help).clicked()
            };
            deeds.undo |= button(ui, self.document.can_undo(), "Undo", UNDO);
            deeds.redo |= button(ui, self.document.can_redo(), "Redo", REDO);
            self.camera_buttons(ui, deeds);
            ui.separator();
            let help = "show lights, the camera's target and bounds (G)";
            ui.toggle_value(&mut self.gizmos, "Gizmos").on_hover_text(help);
            self.focus_button(ui, deeds);
            if ui.button("Save picture").on_hover_text("as PNG or EXR of any size, or as a movie").clicked() {
                self.dialog.toggle();
            }
            ui.with_layout(Layout::right_to_left(Align::Center), |ui| self.saving(ui));
        });
        ui.add_space(1.0);
    }

    fn camera_buttons(&mut self, ui: &mut Ui, deeds: &mut Deeds) {
        let moved = self.camera;
        let help = "back to the scene's camera (Home)\ndrag: turn, right drag: move, wheel: zoom";
        if ui.add_enabled(moved.is_some(), egui::Button::new("Home")).on_hover_text(help).clicked() {
            self.camera = None;
        }
        let help = "write this camera into the scene";
        let keep = ui.add_enabled(moved.is_some(), egui::Button::new("Keep view")).on_hover_text(help);
        if keep.clicked()
            && let Some(camera) = moved
        {
            let path = crate::scene::Path::default().field("camera");
            for (name, point) in [("eye", camera.eye), ("target", camera.target)] {
                let numbers = point.to_array().map(|x| (x * 1e3).round() / 1e3).to_vec();
                let value = NewValue::Vector(numbers);
                deeds.edits.push(Edit::Set { path: path.field(name), value });
            }
        }
    }

    /// Shows what is chosen alone, and then all again.
    fn focus_button(&mut self, ui: &mut Ui, deeds: &mut Deeds) {
        let chosen = self.chosen().and_then(|node| match node.kind {
            NodeKind::Object => Some(Focus::Object(node.label.clone())),
            NodeKind::Material => Some(Focus::Material(node.label.clone())),
            _ => None,
        });
        let mut is_on = self.focus != Focus::All;
        let help = "show only the chosen object, or the chosen material on a stage";
        let can = is_on || chosen.is_some();
        ui.add_enabled_ui(can, |ui| {
            if ui.toggle_value(&mut is_on, "Only this").on_hover_text(help).changed() {
                self.focus = if is_on { chosen.unwrap_or_default() } else { Focus::All };
                deeds.orders.push(Order::Focus(self.focus.clone()));
            }
        });
    }

    fn scene_menu(&mut self, ui: &mut Ui, deeds: &mut Deeds) {
        let mut chosen = None;
        egui::ComboBox::from_id_salt("scene").width(150.0).selected_text(stem(&self.scene)).show_ui(
            ui,
            |ui| {
                for scene in &self.scenes {
                    if ui.selectable_label(*scene == self.scene, stem(scene)).clicked()
                        && *scene != self.scene
                    {
                        chosen = Some(scene.clone());
                    }
                }
            },
        );
        if let Some(scene) = chosen {
            deeds.orders.push(self.open(&scene));
        }
    }

    fn view_menu(&mut self, ui: &mut Ui) {
        let name = |view: View| View::ALL.iter().find(|(_, v)| *v == view).map_or("", |(name, _)| name);
        egui::ComboBox::from_id_salt("view").width(90.0).selected_text(name(self.view)).show_ui(ui, |ui| {
            for (name, view) in View::ALL {
                ui.selectable_value(&mut self.view, view, name);
            }
        });
    }

    /// Where edits go, and what became of them.
    fn saving(&mut self, ui: &mut Ui) {
        let help = "off: what you change here goes to the scene's file at once\n\
                    on: it is only shown, and goes to the file when you switch this off";
        ui.toggle_value(&mut self.document.tries_only, "Only try").on_hover_text(help);
        let (text, color) = match (&self.document.failure, &self.notice, self.document.is_saved()) {
            (Some(failure), ..) => (failure.as_str(), Color32::from_rgb(255, 110, 100)),
            (None, Some(notice), _) => (notice.as_str(), Color32::from_rgb(245, 190, 80)),
            (None, None, false) => ("not saved", Color32::from_rgb(245, 190, 80)),
            (None, None, true) => ("saved", Color32::from_gray(120)),
        };
        ui.add(egui::Label::new(RichText::new(text).color(color).small()).truncate());
    }

    pub(super) fn clock_bar(&mut self, ui: &mut Ui) {
        ui.add_space(2.0);
        ui.horizontal(|ui| {
            let runs = matches!(self.clock, Clock::Running { .. });
            if ui.button(if runs { "⏸" } else { "▶" }).on_hover_text("Space").clicked() {
                self.toggle_clock();
            }
            if ui.button("⏮").on_hover_text("back to the beginning").clicked() {
                self.clock = match self.clock {
                    Clock::Running { .. } => Clock::Running { then: 0.0, at: Instant::now() },
                    Clock::Stopped(_) => Clock::Stopped(0.0),
                };
            }
            let mut time = self.clock.time();
            for (name, step) in [("−1", -FRAME), ("+1", FRAME)] {
                if ui.button(name).on_hover_text("one frame of a sixtieth of a second").clicked() {
                    self.clock = Clock::Stopped((time + step).max(0.0));
                }
            }
            ui.spacing_mut().slider_width = ui.available_width() - 80.0;
            let end = SPAN * (1.0 + (time / SPAN).floor());
            let slider = egui::Slider::new(&mut time, 0.0..=end).suffix(" s").fixed_decimals(2);
            // A slider says that it has changed when it rounds, too.
            let slider = ui.add(slider);
            if slider.dragged() || slider.clicked() || (slider.changed() && slider.has_focus()) {
                self.clock = Clock::Stopped(time);
            }
        });
        ui.add_space(2.0);
    }

    fn toggle_clock(&mut self) {
        self.clock = match self.clock {
            Clock::Running { .. } => Clock::Stopped(self.clock.time()),
            Clock::Stopped(then) => Clock::Running { then, at: Instant::now() },
        };
    }
}

fn stem(path: &Path) -> String {
    path.file_stem().unwrap_or_default().to_string_lossy().into_owned()
}
