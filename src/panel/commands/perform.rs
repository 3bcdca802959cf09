//! What becomes of a command, whether a key, a button, a menu or the palette gave it.

use egui::{Button, Context, KeyboardShortcut, Ui};

use super::table::{COMMANDS, Command, Entry};
use crate::edit::{Edit, NewValue};
use crate::engine::builder_messages::BuilderCommand;
use crate::engine::focus::Focus;
use crate::frame::View;
use crate::outline::NodeKind;
use crate::panel::settings::Theme;
use crate::panel::{Actions, Leaving, Panel, editor, style, templates};

/// Told before an undo that takes back what was done elsewhere.
const OUTSIDE: &str = "the next undo reverts changes that your editor saved: undo again to do so";

impl Panel {
    /// Does what the keys say that were pressed.
    pub(in crate::panel) fn keys(&mut self, ui: &Ui, actions: &mut Actions) {
        for command in self.pressed(ui) {
            self.perform(command, ui.ctx(), actions);
        }
        if self.cover().is_none() && self.leaving.is_none() {
            self.digits(ui, is_typing(ui));
        }
    }

    /// What opened the sheet that lies over all, which takes the keys for itself.
    fn cover(&self) -> Option<Command> {
        let covers = [
            (self.palette.is_open(), Command::Palette),
            (self.gallery.is_open(), Command::Gallery),
            (self.shows_cheat_sheet, Command::CheatSheet),
        ];
        covers.into_iter().find(|(is_open, _)| *is_open).map(|(_, command)| command)
    }

    /// The commands whose keys were pressed. While somebody types, letters are no commands.
    fn pressed(&self, ui: &Ui) -> Vec<Command> {
        if self.leaving.is_some() {
            return vec![];
        }
        let is_typing = is_typing(ui);
        let is_free = |command: Command| match self.cover() {
            Some(cover) => command == cover,
            None => self.can(command),
        };
        let mut commands = vec![];
        // egui takes Ctrl+Shift+Z for Ctrl+Z too, so keys with Shift are asked for first.
        for with_shift in [true, false] {
            for entry in COMMANDS.iter().filter(|entry| is_free(entry.command)) {
                let keys = entry.keys.iter().filter(|key| key.modifiers.shift == with_shift);
                let mut keys = keys.filter(|key| key.modifiers.command || !is_typing);
                if keys.any(|key| ui.input_mut(|input| input.consume_shortcut(key))) {
                    commands.push(entry.command);
                }
            }
        }
        commands
    }

    pub(in crate::panel) fn button(&mut self, ui: &mut Ui, command: Command, actions: &mut Actions) {
        self.button_called(ui, command.entry().name, command, actions);
    }

    pub(in crate::panel) fn button_called(
        &mut self,
        ui: &mut Ui,
        text: &str,
        command: Command,
        actions: &mut Actions,
    ) {
        let button = match self.is_on(command) {
            Some(is_on) => Button::selectable(is_on, text),
            None => Button::new(text),
        };
        let entry = command.entry();
        let help = format!("{} ({})", entry.does, keys_of(ui.ctx(), entry));
        let response = ui.add_enabled(self.can(command), button).accessible_name(entry.name);
        if response.on_hover_text(&help).on_disabled_hover_text(&help).clicked() {
            self.perform(command, ui.ctx(), actions);
        }
    }

    pub(in crate::panel) fn menu_item(&mut self, ui: &mut Ui, command: Command, actions: &mut Actions) {
        let entry = command.entry();
        let button = Button::new(entry.name).shortcut_text(keys_of(ui.ctx(), entry));
        let button = match self.is_on(command) {
            Some(is_on) => button.selected(is_on),
            None => button,
        };
        let item = ui.add_enabled(self.can(command), button).accessible_name(entry.name);
        if item.on_hover_text(entry.does).clicked() {
            self.perform(command, ui.ctx(), actions);
            ui.close();
        }
    }

    /// Whether it would do something now.
    pub(in crate::panel) fn can(&self, command: Command) -> bool {
        match command {
            Command::Undo => self.document.can_undo(),
            Command::Redo => self.document.can_redo(),
            Command::Bookmark => self.home.is_some(),
            Command::Home | Command::KeepView => self.camera.is_some(),
            Command::ChooseNothing => self.selected.is_some() && !self.handles.is_held(),
            Command::OnlyThis => self.focus != Focus::All || self.focus_of_choice().is_some(),
            Command::Pause | Command::Rewind | Command::StepBack | Command::StepForward => self.moves,
            _ => true,
        }
    }

    /// Whether it is on, if it is a switch.
    fn is_on(&self, command: Command) -> Option<bool> {
        match command {
            Command::OnlyTry => Some(self.document.tries_only),
            Command::OnlyThis => Some(self.focus != Focus::All),
            Command::Gizmos => Some(self.gizmos),
            Command::SplitView => Some(self.divider.split().is_some()),
            Command::Handles => Some(self.settings.handles),
            Command::Magnifier => Some(self.magnifies),
            _ => None,
        }
    }

    pub(in crate::panel) fn perform(&mut self, command: Command, context: &Context, actions: &mut Actions) {
        let told = self.notice.take();
        match command {
            Command::Gallery => self.toggle_gallery(),
            Command::NewScene => self.leave(Leaving::NewScene),
            Command::NewTexture => self.notice = Some(self.new_texture()),
            // It is not the hand's own work here that would be lost.
            Command::Undo if self.document.undoes_outside() && told.as_deref() != Some(OUTSIDE) => {
                self.notice = Some(OUTSIDE.into());
            }
            Command::Undo => actions.undo = true,
            Command::Redo => actions.redo = true,
            Command::OnlyTry => self.document.tries_only = !self.document.tries_only,
            Command::Home => self.camera = None,
            Command::KeepView => self.keep_view(actions),
            Command::Bookmark => self.keep_next_bookmark(),
            Command::ChooseNothing => self.selected = None,
            Command::OnlyThis => self.toggle_focus(actions),
            Command::Gizmos => self.gizmos = !self.gizmos,
            Command::Handles => self.settings.handles = !self.settings.handles,
            Command::NextView => self.change_view(1),
            Command::PreviousView => self.change_view(View::ALL.len() - 1),
            Command::SplitView => self.divider.toggle(self.view),
            Command::Magnifier => self.magnifies = !self.magnifies,
            Command::SavePicture => self.dialog.toggle(),
            Command::Pause => self.toggle_clock(),
            Command::StepBack => self.step(-1.0),
            Command::StepForward => self.step(1.0),
            Command::Rewind => self.rewind(),
            Command::Palette => self.palette.toggle(),
            Command::CheatSheet => self.shows_cheat_sheet = !self.shows_cheat_sheet,
            Command::Theme => {
                self.settings.theme = match self.settings.theme {
                    Theme::Dark => Theme::Light,
                    Theme::Light => Theme::Dark,
                };
                style::choose(context, self.settings.theme);
            }
            Command::Quit => self.leave(Leaving::Quit),
        }
    }

    /// Writes a texture and opens it. Returns a message about it.
    fn new_texture(&self) -> String {
        match templates::new_texture(&self.disk, &self.scene) {
            Ok(texture) => {
                let file = texture.path.display();
                let told = format!("{file} is written; use it in scenes as {}()", texture.name);
                editor::open(&texture.path, 1).err().map_or(told.clone(), |why| format!("{told}; {why}"))
            }
            Err(error) => format!("the new texture cannot be written: {error}"),
        }
    }

    fn keep_view(&self, actions: &mut Actions) {
        let Some(camera) = self.camera else { return };
        let path = crate::scene::Path::default().field("camera");
        for (name, point) in [("eye", camera.eye), ("target", camera.target)] {
            let numbers = point.to_array().map(|x| (x * 1e3).round() / 1e3).to_vec();
            actions.edits.push(Edit::Set { path: path.field(name), value: NewValue::Vector(numbers) });
        }
    }

    /// Shows what is chosen alone, and then all again.
    fn toggle_focus(&mut self, actions: &mut Actions) {
        self.focus = match self.focus {
            Focus::All => self.focus_of_choice().unwrap_or_default(),
            _ => Focus::All,
        };
        actions.orders.push(BuilderCommand::Focus(self.focus.clone()));
    }

    fn focus_of_choice(&self) -> Option<Focus> {
        let node = self.chosen()?;
        match node.kind {
            NodeKind::Object => Some(Focus::Object(node.label.clone())),
            NodeKind::Material => Some(Focus::Material(node.label.clone())),
            _ => None,
        }
    }

    fn change_view(&mut self, step: usize) {
        let now = View::ALL.iter().position(|(_, view)| *view == self.view).unwrap_or(0);
        self.view = View::ALL[(now + step) % View::ALL.len()].1;
    }
}

/// Whether keys are meant for something that has the focus.
fn is_typing(ui: &Ui) -> bool {
    ui.memory(|memory| memory.focused().is_some()) || egui::Popup::is_any_open(ui.ctx())
}

/// The keys of a command, as people call them.
pub fn keys_of(context: &Context, entry: &Entry) -> String {
    let name = |key: &KeyboardShortcut| {
        // egui spells signs out: "Comma".
        if key.modifiers.is_none() {
            key.logical_key.symbol_or_name().to_owned()
        } else {
            context.format_shortcut(key)
        }
    };
    entry.keys.iter().map(name).collect::<Vec<_>>().join(", ")
}
