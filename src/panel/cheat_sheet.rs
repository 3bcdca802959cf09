//! The cheat sheet: all commands with their keys, and what the mouse does.

use egui::{Align, Color32, Frame, Id, KeyboardShortcut, Layout, Modal, Modifiers, RichText, Ui};

use super::Panel;
use super::commands::keys_of;
use crate::panel::commands::{COMMANDS, DIGITS, GESTURES};

/// The groups, column by column.
const COLUMNS: [&[&str]; 2] = [&["Scene", "Camera", "Time", "Window"], &["Picture", "Mouse"]];
/// Points, of a column.
const WIDTH: f32 = 260.0;

impl Panel {
    pub(super) fn sheet(&mut self, ui: &Ui) {
        if !self.shows_cheat_sheet {
            return;
        }
        let id = Id::unique("sheet");
        let area = Modal::default_area(id).fade_in(false).accessible_name("cheat sheet");
        let modal = Modal::new(id).area(area).backdrop_color(Color32::from_black_alpha(70));
        let frame = Frame::popup(ui.style()).inner_margin(20.0);
        let shown = modal.frame(frame).show(ui.ctx(), |ui| {
            ui.horizontal_top(|ui| {
                ui.spacing_mut().item_spacing.x = 32.0;
                for groups in COLUMNS {
                    ui.vertical(|ui| {
                        ui.set_width(WIDTH);
                        groups.iter().for_each(|name| group(ui, name));
                    });
                }
            });
        });
        self.shows_cheat_sheet = !shown.should_close();
    }
}

fn group(ui: &mut Ui, name: &str) {
    ui.spacing_mut().item_spacing = egui::vec2(6.0, 3.0);
    ui.label(RichText::new(name).strong());
    ui.add_space(2.0);
    if name == "Mouse" {
        GESTURES.iter().for_each(|(does, how)| line(ui, does, how));
    }
    for entry in COMMANDS.iter().filter(|entry| entry.group == name) {
        let keys = keys_of(ui.ctx(), entry);
        line(ui, entry.name, &keys);
    }
    if name == "Camera" {
        let first = KeyboardShortcut::new(Modifiers::COMMAND, DIGITS[0]);
        line(ui, "Go to a bookmark", "1 to 9");
        line(ui, "Save a bookmark", &format!("{} to 9", ui.ctx().format_shortcut(&first)));
    }
    ui.add_space(12.0);
}

fn line(ui: &mut Ui, name: &str, how: &str) {
    ui.horizontal(|ui| {
        ui.label(RichText::new(name).weak());
        ui.with_layout(Layout::right_to_left(Align::Center), |ui| ui.label(how));
    });
}
