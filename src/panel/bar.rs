//! The bars above and below the picture: menus, buttons, saving; and the clock of scenes that move.

use std::time::Instant;

use egui::{Align, Layout, RichText, Ui};

use super::{Actions, Panel};
use crate::engine::messages::Clock;
use crate::frame::View;
use crate::panel::commands::Command;

/// Seconds from one frame to the next when time is stepped by hand.
const FRAME: f32 = 1.0 / 60.0;
/// Points that a button of the bar needs beside what stands at the right end.
const ENOUGH: f32 = 165.0;
/// Seconds that the scrubber spans.
const SPAN: f32 = 20.0;

impl Panel {
    pub(super) fn bar(&mut self, ui: &mut Ui, actions: &mut Actions) {
        ui.add_space(3.0);
        ui.horizontal(|ui| {
            self.main_menu(ui, actions);
            ui.separator();
            self.scene_menu(ui);
            view_menu(ui, "view", &mut self.view);
            ui.separator();
            for command in [Command::Undo, Command::Redo, Command::Home, Command::KeepView] {
                self.button(ui, command, actions);
            }
            ui.separator();
            for command in [
                Command::Gizmos,
                Command::OnlyThis,
                Command::SplitView,
                Command::SavePicture,
                Command::Gallery,
            ] {
                if ui.available_width() > ENOUGH {
                    self.button(ui, command, actions);
                }
            }
            ui.with_layout(Layout::right_to_left(Align::Center), |ui| self.saving(ui, actions));
        });
        ui.add_space(1.0);
    }

    fn main_menu(&mut self, ui: &mut Ui, actions: &mut Actions) {
        let title = egui::Button::new(RichText::new("☰ raytoy").strong().size(15.0));
        let (opener, _) = egui::containers::menu::MenuButton::from_button(title).ui(ui, |ui| {
            ui.set_min_width(180.0);
            self.menu_item(ui, Command::Gallery, actions);
            ui.separator();
            self.menu_item(ui, Command::NewScene, actions);
            self.menu_item(ui, Command::NewTexture, actions);
            ui.separator();
            for command in [
                Command::Gizmos,
                Command::Handles,
                Command::OnlyThis,
                Command::SplitView,
                Command::Magnifier,
                Command::SavePicture,
            ] {
                self.menu_item(ui, command, actions);
            }
            ui.separator();
            for command in [Command::Palette, Command::CheatSheet, Command::Theme, Command::Quit] {
                self.menu_item(ui, command, actions);
            }
        });
        opener.accessible_name("raytoy");
    }

    /// Where edits go, and what became of them.
    fn saving(&mut self, ui: &mut Ui, actions: &mut Actions) {
        self.button(ui, Command::OnlyTry, actions);
        let visuals = ui.visuals();
        let (text, color) = match (&self.document.failure, &self.notice, self.document.is_saved()) {
            (Some(failure), ..) => (failure.as_str(), visuals.error_fg_color),
            (None, Some(notice), _) => (notice.as_str(), visuals.warn_fg_color),
            (None, None, false) => ("not saved", visuals.warn_fg_color),
            (None, None, true) => ("saved", visuals.weak_text_color()),
        };
        ui.add(egui::Label::new(RichText::new(text).color(color).small()).truncate()).on_hover_text(text);
    }

    pub(super) fn clock_bar(&mut self, ui: &mut Ui, actions: &mut Actions) {
        ui.add_space(2.0);
        ui.horizontal(|ui| {
            let runs = matches!(self.clock, Clock::Running { .. });
            self.button_called(ui, if runs { "⏸" } else { "▶" }, Command::Pause, actions);
            self.button_called(ui, "⏮", Command::Rewind, actions);
            self.button_called(ui, "−1", Command::StepBack, actions);
            self.button_called(ui, "+1", Command::StepForward, actions);
            let mut time = self.clock.time();
            ui.spacing_mut().slider_width = ui.available_width() - 80.0;
            let end = SPAN * (1.0 + (time / SPAN).floor());
            let slider = egui::Slider::new(&mut time, 0.0..=end).suffix(" s").fixed_decimals(2);
            // A slider says that it has changed when it rounds, too.
            let slider = ui.add(slider).accessible_name("time");
            if slider.dragged() || slider.clicked() || (slider.changed() && slider.has_focus()) {
                self.clock = Clock::Stopped(time);
            }
        });
        ui.add_space(2.0);
    }

    pub(super) fn toggle_clock(&mut self) {
        self.clock = match self.clock {
            Clock::Running { .. } => Clock::Stopped(self.clock.time()),
            Clock::Stopped(then) => Clock::Running { then, at: Instant::now() },
        };
    }

    pub(super) fn rewind(&mut self) {
        self.clock = match self.clock {
            Clock::Running { .. } => Clock::Running { then: 0.0, at: Instant::now() },
            Clock::Stopped(_) => Clock::Stopped(0.0),
        };
    }

    /// Stops the clock so many frames further.
    pub(super) fn step(&mut self, frames: f32) {
        self.clock = Clock::Stopped((self.clock.time() + frames * FRAME).max(0.0));
    }
}

/// All views to choose from, below the one that is shown.
pub fn view_menu(ui: &mut Ui, called: &str, chosen: &mut View) {
    let menu = egui::ComboBox::from_id_salt(called).width(90.0).height(480.0);
    let shown = menu.selected_text(chosen.name()).show_ui(ui, |ui| {
        for (name, view) in View::ALL {
            ui.selectable_value(chosen, view, name);
        }
    });
    shown.response.accessible_name(called);
}
