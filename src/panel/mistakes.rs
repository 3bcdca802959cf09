//! What is wrong with the scene, over its last good picture: a card for each mistake, with a way to its line.

use std::path::Path;

use egui::{Color32, Frame, Label, RichText, ScrollArea, TextWrapMode, Ui};

use super::Panel;
use super::style::{LINK_OVER_PICTURE, PALE};
use crate::diagnostic::{Diagnostic, Report};
use crate::panel::editor;

const ERROR: Color32 = Color32::from_rgb(255, 110, 100);
const WARNING: Color32 = Color32::from_rgb(245, 190, 80);

/// A report as it is shown.
pub struct Told {
    report: Report,
    /// The lines around each mistake.
    excerpts: Vec<String>,
    /// The mistake whose line could not be opened, and why.
    failure: Option<(usize, String)>,
}

impl Told {
    pub fn new(report: Report) -> Self {
        let excerpts = report.diagnostics.iter().map(|problem| excerpt(&report, problem)).collect();
        Self { report, excerpts, failure: None }
    }

    /// Shows it over the lower part of `area`; the number of the mistake whose place the author wants to see.
    fn show(&self, ui: &Ui, area: egui::Rect, has_picture: bool) -> Option<usize> {
        let (color, heading) = match (self.report.has_errors(), has_picture) {
            (true, true) => (ERROR, "The scene has mistakes. The picture is from its last correct version."),
            (true, false) => (ERROR, "The scene has mistakes."),
            (false, _) => (WARNING, "The scene has warnings."),
        };
        let frame = Frame::NONE.fill(Color32::from_black_alpha(225)).inner_margin(14.0);
        let mut wanted = None;
        egui::Area::new(egui::Id::unique("mistakes"))
            .accessible_name("mistakes")
            .role(egui::accesskit::Role::Alert)
            .fixed_pos(area.left_bottom() + egui::vec2(12.0, -12.0))
            .pivot(egui::Align2::LEFT_BOTTOM)
            .show(ui.ctx(), |ui| {
                frame.stroke((1.0, color)).corner_radius(6).show(ui, |ui| {
                    ui.set_width((area.width() - 54.0).max(100.0));
                    ui.set_max_height(0.6 * area.height());
                    ui.label(RichText::new(heading).color(color).strong());
                    ui.add_space(4.0);
                    ScrollArea::vertical().max_height(0.6 * area.height()).show(ui, |ui| {
                        for number in 0..self.excerpts.len() {
                            if self.card(ui, number) {
                                wanted = Some(number);
                            }
                        }
                    });
                });
            });
        wanted
    }

    /// Whether its line is to be opened.
    fn card(&self, ui: &mut Ui, number: usize) -> bool {
        let (problem, excerpt) = (&self.report.diagnostics[number], &self.excerpts[number]);
        let mut opens = false;
        Frame::NONE.fill(Color32::from_white_alpha(14)).corner_radius(4).inner_margin(10.0).show(ui, |ui| {
            ui.set_width(ui.available_width());
            ui.add(wrapped(RichText::new(&problem.message).color(Color32::WHITE).strong()));
            if let Some((file, line)) = line_of(&self.report, problem) {
                let link = RichText::new(format!("open {file}:{line}")).color(LINK_OVER_PICTURE);
                opens = ui.link(link).on_hover_text(&problem.message).clicked();
            }
            if let Some((_, why)) = self.failure.as_ref().filter(|(failed, _)| *failed == number) {
                ui.add(wrapped(RichText::new(why).color(WARNING)));
            }
            if !excerpt.is_empty() {
                ui.push_id(number, |ui| {
                    ScrollArea::horizontal().show(ui, |ui| {
                        let text = RichText::new(excerpt).monospace().color(PALE);
                        ui.add(Label::new(text).wrap_mode(TextWrapMode::Extend).selectable(true));
                    });
                });
            }
            for help in &problem.help {
                ui.add(wrapped(RichText::new(format!("help: {help}")).color(PALE)));
            }
        });
        opens
    }
}

impl Panel {
    /// Shows what is wrong, and opens the author's editor where that is asked for.
    pub(super) fn mistakes(&mut self, ui: &Ui, area: egui::Rect) {
        let has_picture = self.compiled.is_some();
        let Some(told) = &mut self.report else { return };
        let Some(number) = told.show(ui, area, has_picture) else { return };
        let place = line_of(&told.report, &told.report.diagnostics[number]);
        let failed = place.and_then(|(file, line)| editor::open(file.as_ref(), line).err());
        told.failure = failed.map(|why| (number, why));
    }
}

fn wrapped(text: RichText) -> Label {
    Label::new(text).wrap().selectable(true)
}

/// The lines around a mistake, marked, without the message and the help.
fn excerpt(report: &Report, problem: &Diagnostic) -> String {
    let bare = Diagnostic { help: vec![], ..problem.clone() };
    let text = Report { diagnostics: vec![bare], texts: report.texts.clone() }.to_string();
    // A message may have lines of its own.
    let rest = text.lines().skip(problem.message.lines().count().max(1));
    rest.collect::<Vec<_>>().join("\n").trim_end().to_owned()
}

/// The file in which `problem` is, and its line; None where that is no file's.
fn line_of(report: &Report, problem: &Diagnostic) -> Option<(String, usize)> {
    let (place, _) = problem.labels.first()?;
    let text = report.texts.get(&place.file)?;
    let line = 1 + text.get(..place.span.start)?.matches('\n').count();
    Path::new(&place.file).exists().then(|| (place.file.clone(), line))
}
