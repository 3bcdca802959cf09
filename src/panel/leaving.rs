//! Leaving a scene: at once, or after the author has said what is to become of changes that no file has.

use std::path::PathBuf;

use egui::{Align, Button, Color32, Frame, Id, Key, Layout, Modal, Modifiers, RichText, Ui};

use super::{ACCENT, Actions, Panel};
use crate::panel::templates;

/// Where the author goes from here.
pub enum Leaving {
    Open(PathBuf),
    NewScene,
    Quit,
}

#[derive(Clone, Copy)]
enum Answer {
    Write,
    Drop,
    Stay,
}

const QUESTION: &str = "Save your changes?";
/// Points.
const WIDTH: f32 = 380.0;

impl Panel {
    /// Leaves the scene when the next frame begins, or asks there: by then this frame's edits are written,
    /// and its keys answer no question.
    pub fn leave(&mut self, to: Leaving) {
        self.leaving = Some(to);
    }

    /// Whether the window may be closed. If not, the next frame asks the author.
    pub fn closes(&mut self) -> bool {
        let is_saved = self.document.is_saved();
        if !is_saved {
            self.leave(Leaving::Quit);
        }
        is_saved
    }

    /// Does what [`Panel::leave`] was called for, unless changes would be lost: then it asks.
    pub(super) fn depart(&mut self, ui: &Ui, actions: &mut Actions) {
        let Some(to) = self.leaving.take() else { return };
        let answer = if self.document.is_saved() { Some(Answer::Drop) } else { self.ask(ui) };
        if matches!(answer, Some(Answer::Write)) {
            self.document.save();
        }
        match answer {
            Some(Answer::Stay) => {}
            Some(Answer::Drop) => self.go(to, actions),
            Some(Answer::Write) if self.document.is_saved() => self.go(to, actions),
            // Not written: the reason stands in the question.
            Some(Answer::Write) | None => self.leaving = Some(to),
        }
    }

    fn go(&mut self, to: Leaving, actions: &mut Actions) {
        match to {
            Leaving::Open(scene) => actions.orders.push(self.open(&scene)),
            Leaving::NewScene => match templates::new_scene(&self.scene) {
                Ok(scene) => actions.orders.push(self.open(&scene)),
                Err(error) => self.notice = Some(format!("the new scene cannot be written: {error}")),
            },
            Leaving::Quit => actions.quits = true,
        }
    }

    /// What is to become of the changes, once the author has said it.
    fn ask(&self, ui: &Ui) -> Option<Answer> {
        let id = Id::unique("leaving");
        let area = Modal::default_area(id).fade_in(false).accessible_name(QUESTION);
        let modal = Modal::new(id).area(area).backdrop_color(Color32::from_black_alpha(70));
        let shown = modal.frame(Frame::popup(ui.style()).inner_margin(20.0)).show(ui.ctx(), |ui| {
            ui.set_width(WIDTH);
            self.question(ui)
        });
        shown.inner.or_else(|| shown.should_close().then_some(Answer::Stay))
    }

    fn question(&self, ui: &mut Ui) -> Option<Answer> {
        let file = self.scene.file_name().unwrap_or_default().to_string_lossy();
        let why = match self.document.tries_only {
            true => "were only tried and are not saved",
            false => "are not saved yet",
        };
        ui.label(RichText::new(QUESTION).strong().size(15.0));
        ui.add_space(4.0);
        ui.label(format!("The changes to {file} {why}."));
        if let Some(failure) = &self.document.failure {
            ui.colored_label(ui.visuals().error_fg_color, failure);
        }
        ui.add_space(12.0);
        let mut answer =
            ui.input_mut(|i| i.consume_key(Modifiers::NONE, Key::Enter)).then_some(Answer::Write);
        ui.with_layout(Layout::right_to_left(Align::Center), |ui| {
            let write = RichText::new("Save").color(Color32::WHITE);
            let buttons = [
                (Button::new(write).fill(ACCENT), "Enter", Answer::Write),
                (Button::new("Discard"), "the file does not change", Answer::Drop),
                (Button::new("Stay"), "Escape", Answer::Stay),
            ];
            for (button, help, what) in buttons {
                if ui.add(button).on_hover_text(help).clicked() {
                    answer = Some(what);
                }
            }
        });
        answer
    }
}
