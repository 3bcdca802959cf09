//! What is wrong with the scene, over its last good picture, each mistake a way to its line.

use std::path::Path;

use egui::{Color32, Frame, RichText, Ui};

use super::{ACCENT, Panel};
use crate::app::editor;
use crate::diagnostic::{Diagnostic, Report};

/// Shows the report over the lower part of `area`; the mistake whose place the author wants to see, if any.
pub fn show(ui: &mut Ui, area: egui::Rect, report: &Report, text: &str) -> Option<Diagnostic> {
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
    let mut wanted = None;
    egui::Area::new(egui::Id::unique("mistakes"))
        .accessible_name("mistakes")
        .role(egui::accesskit::Role::Alert)
        .fixed_pos(area.left_bottom() + egui::vec2(12.0, -12.0))
        .pivot(egui::Align2::LEFT_BOTTOM)
        .show(ui.ctx(), |ui| {
            frame.show(ui, |ui| {
                let width = (area.width() - 54.0).max(100.0);
                ui.set_width(width);
                ui.label(RichText::new(heading).color(color).strong());
                ui.horizontal_wrapped(|ui| {
                    for problem in &report.diagnostics {
                        let Some((file, line)) = line_of(report, problem) else { continue };
                        let link = RichText::new(format!("open {file}:{line}")).color(ACCENT).small();
                        if ui.link(link).on_hover_text(&problem.message).clicked() {
                            wanted = Some(problem.clone());
                        }
                    }
                });
                ui.add_space(6.0);
                egui::ScrollArea::both().max_height(area.height() * 0.6).max_width(width).show(ui, |ui| {
                    let text = RichText::new(text.trim_end()).monospace().color(Color32::from_gray(225));
                    ui.add(egui::Label::new(text).wrap_mode(egui::TextWrapMode::Extend).selectable(true));
                });
            });
        });
    wanted
}

impl Panel {
    /// Opens the author's editor at the place of `problem`.
    pub(super) fn open_place(&mut self, report: &Report, problem: &Diagnostic) {
        if let Some((file, line)) = line_of(report, problem) {
            self.notice = editor::open(file.as_ref(), line).err();
        }
    }
}

/// The file in which `problem` is, and its line; None where that is no file's.
fn line_of(report: &Report, problem: &Diagnostic) -> Option<(String, usize)> {
    let (place, _) = problem.labels.first()?;
    let text = report.texts.get(&place.file)?;
    let line = 1 + text.get(..place.span.start)?.matches('\n').count();
    Path::new(&place.file).exists().then(|| (place.file.clone(), line))
}
