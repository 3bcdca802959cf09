//! The scene's tree, and below it all values of what is chosen there.

use std::cell::RefCell;
use std::path::Path;

use egui::{RichText, Ui};

use super::changing::with_library;
use super::fields::Fields;
use super::tree::Tree;
use super::{Actions, Panel, changing, picking, widgets};
use crate::outline::{self, Field, Node, NodeKind, Role};
use crate::sources::Disk;

/// The room for the kind of a thing beside its name, points.
const KIND: f32 = 130.0;

impl Panel {
    pub(super) fn inspector(&mut self, ui: &mut Ui, actions: &mut Actions) {
        self.conflicts(ui, actions);
        let Some((outline, text)) = self.outline.take() else { return };
        let scene = self.scene.clone();
        let disk = self.disk.clone();
        let lacking = RefCell::default();
        let example = |role: Role, name: &str| match example(&disk, &scene, role, name) {
            Ok(words) => Some(words),
            Err(why) => {
                lacking.replace(Some(why));
                None
            }
        };
        let search =
            egui::TextEdit::singleline(&mut self.wanted).hint_text("find").desired_width(f32::INFINITY);
        ui.add(search).accessible_name("find in the scene");
        let height = ui.available_height();
        let before = self.selected.clone();
        egui::ScrollArea::vertical()
            .id_salt("tree")
            .max_height(0.42 * height)
            .auto_shrink([false, true])
            .show(ui, |ui| {
                let Actions { edits, .. } = actions;
                let (selected, wanted) = (&mut self.selected, self.wanted.as_str());
                Tree { edits, selected, wanted, example: &example, text: &text }.show(ui, &outline);
            });
        if self.selected != before {
            // An answer that is still on its way comes too late.
            self.picking.give_up();
        }
        ui.separator();
        let chosen = self.selected.as_ref().and_then(|path| picking::find(&outline.nodes, path));
        egui::ScrollArea::vertical().id_salt("fields").auto_shrink([false, false]).show(
            ui,
            |ui| match chosen {
                Some(node) => self.node(ui, node, actions, &example),
                None => {
                    ui.label(RichText::new("Choose a line of the tree to see its values.").weak());
                }
            },
        );
        if let Some(why) = lacking.take() {
            self.notice = Some(why);
        }
        self.outline = Some((outline, text));
    }

    fn node(
        &mut self,
        ui: &mut Ui,
        node: &Node,
        actions: &mut Actions,
        example: &dyn Fn(Role, &str) -> Option<String>,
    ) {
        ui.horizontal(|ui| {
            let beside = if node.names.is_empty() { 0.0 } else { KIND };
            let label = egui::Label::new(RichText::new(&node.label).strong().size(14.0)).truncate();
            ui.scope(|ui| {
                ui.set_max_width((ui.available_width() - beside).max(KIND));
                ui.add(label);
            });
            if !node.names.is_empty() {
                self.rename(ui, node, actions, example);
            }
        });
        ui.label(RichText::new(&node.doc).weak().small());
        ui.add_space(4.0);
        let texture = |name: &str| example(Role::Texture, name);
        let place = (&self.disk, self.scene.as_path());
        let becomes = |field: &Field, name: &str| match texture(name) {
            Some(_) => changing::replaced(place, field, name),
            None => vec![],
        };
        let (edits, pending) = (&mut actions.edits, &self.pending);
        let files = |extensions: &[&str]| with_library(place.0, place.1, |library| library.files(extensions));
        let mut fields = Fields { edits, pending, example: &texture, files: &files, becomes: &becomes };
        widgets::group(ui, &node.label, |ui| fields.show(ui, &node.fields));
        if node.kind == NodeKind::Camera {
            self.bookmarks(ui);
        }
    }

    /// What kind of thing it is, which can be another one.
    fn rename(
        &self,
        ui: &mut Ui,
        node: &Node,
        actions: &mut Actions,
        example: &dyn Fn(Role, &str) -> Option<String>,
    ) {
        let role = if node.kind == NodeKind::Light { Role::Light } else { Role::Solid };
        let shown = node.name.as_deref().unwrap_or_default();
        let menu = egui::ComboBox::from_id_salt("kind").selected_text(shown);
        let shown = menu.show_ui(ui, |ui| {
            for name in node.names.iter() {
                let is_new = ui.selectable_label(name == shown, name).clicked() && name != shown;
                if is_new && example(role, name).is_some() {
                    actions.edits.extend(changing::renamed((&self.disk, &self.scene), node, name));
                }
            }
        });
        shown.response.accessible_name("kind");
    }

    /// What was changed here and in the file, for the author to choose.
    fn conflicts(&mut self, ui: &mut Ui, actions: &mut Actions) {
        let mut choice = None;
        for (i, conflict) in self.document.conflicts.iter().enumerate() {
            egui::Frame::group(ui.style()).show(ui, |ui| {
                ui.label(RichText::new("The file has changed in the same place").strong());
                let theirs = conflict.theirs.as_deref().unwrap_or("nothing");
                ui.label(format!("the file has {theirs}"));
                ui.horizontal(|ui| {
                    if ui.button("Use the file's value").clicked() {
                        choice = Some((i, false));
                    }
                    let mine = egui::Button::new("Use my value");
                    if ui.add_enabled(conflict.again.is_some(), mine).clicked() {
                        choice = Some((i, true));
                    }
                });
            });
        }
        if let Some((i, with_mine)) = choice
            && self.document.settle(i, with_mine)
        {
            actions
                .orders
                .push(crate::engine::builder_messages::BuilderCommand::Edited(self.document.overlay()));
        }
    }
}

/// RON text of a `name` with no more than it must be given.
///
/// # Errors
/// Which file is missing for it.
pub fn example(disk: &Disk, scene: &Path, role: Role, name: &str) -> Result<String, String> {
    with_library(disk, scene, |library| {
        let needed = outline::needed_file(role, name, library);
        match needed.filter(|needed| library.files(needed.extensions).is_empty()) {
            Some(needed) => {
                let (noun, endings) = (needed.noun, needed.extensions.join(", ."));
                Err(format!("{name} shows a {noun}: put a file (.{endings}) into the scene's folder first"))
            }
            None => Ok(outline::example(role, name, library).unwrap_or_else(|| format!("{name}()"))),
        }
    })
}
