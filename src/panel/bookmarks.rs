//! Cameras to come back to: by their digits, and in the camera's part of the panel.

use egui::{Align, Button, Layout, Modifiers, RichText, Ui};

use super::{Panel, widgets};
use crate::panel::commands::{Command, DIGITS};
use crate::panel::settings::{Bookmark, free_digit};
use crate::scene::Path;

impl Panel {
    /// Goes to the bookmark whose digit was pressed; with Ctrl it is kept there.
    pub(super) fn digits(&mut self, ui: &Ui, is_typing: bool) {
        for (digit, key) in (1..).zip(DIGITS) {
            if ui.input_mut(|input| input.consume_key(Modifiers::COMMAND, key)) {
                self.keep_bookmark(digit);
            }
            if !is_typing && ui.input_mut(|input| input.consume_key(Modifiers::NONE, key)) {
                self.go_to(digit);
            }
        }
    }

    /// Keeps the camera under the first digit that has none.
    pub(super) fn keep_next_bookmark(&mut self) {
        match free_digit(self.settings.bookmarks(&self.scene)) {
            Some(digit) => self.keep_bookmark(digit),
            None => {
                self.notice =
                    Some("all nine bookmarks are used: remove one, or replace one with Ctrl+1".into())
            }
        }
    }

    pub(super) fn go_to(&mut self, digit: u8) {
        let known = self.settings.bookmarks(&self.scene).iter().find(|known| known.digit == digit);
        match known {
            // Where no picture was ever shown, the scene's own camera is about to come.
            Some(known) if self.home.is_some() => self.camera = Some(known.camera()),
            _ => {}
        }
    }

    fn keep_bookmark(&mut self, digit: u8) {
        let Some(camera) = self.camera.or(self.home) else { return };
        self.settings.change_bookmarks(&self.scene, |kept| kept.keep(digit, &camera));
        self.notice = Some(format!("camera saved as bookmark {digit}: press {digit} to return to it"));
    }

    /// All of them, each with what can be done with it.
    pub(super) fn bookmarks(&mut self, ui: &mut Ui) {
        ui.add_space(10.0);
        ui.horizontal(|ui| {
            ui.label(RichText::new("bookmarks").strong());
            ui.with_layout(Layout::right_to_left(Align::Center), |ui| {
                let entry = Command::Bookmark.entry();
                let button = Button::new("Save this camera").small();
                let response = ui.add_enabled(self.can(Command::Bookmark), button);
                if response.on_hover_text(format!("{} (B)", entry.does)).clicked() {
                    self.keep_next_bookmark();
                }
            });
        });
        let kept: Vec<Bookmark> = self.settings.bookmarks(&self.scene).to_vec();
        if kept.is_empty() {
            ui.label(RichText::new("Saved cameras appear here.").weak().small());
        }
        for known in &kept {
            self.bookmark(ui, known);
        }
    }

    fn bookmark(&mut self, ui: &mut Ui, known: &Bookmark) {
        let digit = known.digit;
        let is_here = self.camera.or(self.home) == Some(known.camera());
        ui.horizontal(|ui| {
            let go = Button::selectable(is_here, digit.to_string());
            let go = ui.add(go).on_hover_text(format!("go there ({digit})"));
            if go.accessible_name(format!("bookmark {digit}")).clicked() {
                self.go_to(digit);
            }
            ui.with_layout(Layout::right_to_left(Align::Center), |ui| {
                let cross = ui.small_button("×").on_hover_text("remove");
                if cross.accessible_name(format!("remove bookmark {digit}")).clicked() {
                    self.settings.change_bookmarks(&self.scene, |kept| kept.remove(digit));
                }
                let again = format!("replace it with the current camera (Ctrl+{digit})");
                let replace = ui.small_button("Replace").on_hover_text(again);
                if replace.accessible_name(format!("replace bookmark {digit}")).clicked() {
                    self.keep_bookmark(digit);
                }
                if ui.small_button("Go").accessible_name(format!("go to bookmark {digit}")).clicked() {
                    self.go_to(digit);
                }
                ui.with_layout(Layout::left_to_right(Align::Center), |ui| {
                    let path = Path::default().field("bookmarks").item(digit.into());
                    let called = format!("name of bookmark {digit}");
                    let name = ui.name_inputs(called, |ui| widgets::text(ui, &path, &known.title()));
                    if let Some(name) = name {
                        self.settings
                            .change_bookmarks(&self.scene, |kept| kept.rename(digit, name.trim().to_owned()));
                    }
                });
            });
        });
    }
}
