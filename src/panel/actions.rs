//! What is done to the scene while one frame is laid out.
//!
//! In: [`Actions`] of the panel's parts. Out: the scene's next text, in the document and on the disk.

use egui::Ui;

use super::Panel;
use crate::edit::{Edit, copy_of, found_at};
use crate::engine::builder_messages::BuilderCommand;
use crate::scene::Path;

/// What is gathered while one frame is laid out.
#[derive(Default)]
pub struct Actions {
    pub edits: Vec<Edit>,
    pub orders: Vec<BuilderCommand>,
    pub undo: bool,
    pub redo: bool,
    pub quits: bool,
}

impl Panel {
    /// Turns what was done into the scene's next text, and this into the file's once the hand rests.
    pub fn act(&mut self, ui: &Ui, actions: &mut Actions) {
        let mut is_new = false;
        for edit in actions.edits.drain(..) {
            is_new |= self.make(edit);
        }
        let takes_back = std::mem::take(&mut self.handles.takes_back);
        let before =
            (takes_back || actions.undo || actions.redo).then(|| self.document.text().map(str::to_owned));
        if (takes_back && self.document.abandon())
            || (actions.undo && self.document.undo())
            || (actions.redo && self.document.redo())
        {
            self.pending.clear();
            is_new = true;
            self.follow_choice(before.flatten().as_deref());
        }
        let rests = !ui.input(|input| input.pointer.any_down());
        if rests {
            self.document.rest();
        }
        let saves = rests && !self.document.tries_only && !self.document.is_saved();
        if saves {
            self.document.save();
        }
        if is_new || (saves && self.document.is_saved()) {
            actions.orders.push(BuilderCommand::Edited(self.document.overlay()));
        }
    }

    /// Makes an edit; whether the text has changed. What is new is chosen.
    fn make(&mut self, edit: Edit) -> bool {
        let edit = match (edit, &self.outline) {
            (Edit::Set { path, value }, Some((outline, _))) => {
                let order = outline.order_at(&path);
                if order.is_empty() { Edit::Set { path, value } } else { Edit::Add { path, value, order } }
            }
            (edit, _) => edit,
        };
        self.pending.note(&edit);
        let before = matches!(edit, Edit::Insert { .. } | Edit::Duplicate { .. } | Edit::Remove { .. })
            .then(|| self.document.text().map(str::to_owned))
            .flatten();
        let is_new = self.document.edit(edit.clone());
        if is_new {
            let text = self.document.text().unwrap_or_default();
            let new = match &edit {
                Edit::Insert { list, index, .. } if list.0.len() == 1 => Some(list.item(*index)),
                Edit::Duplicate { path } => copy_of(path, text),
                _ => None,
            };
            self.follow_choice(before.as_deref());
            if new.is_some() {
                self.left = std::mem::replace(&mut self.selected, new);
            }
        }
        is_new
    }

    /// Lets the choice go on with what it was in the text `before`; where that is gone, it is what was
    /// chosen before it was added.
    pub(super) fn follow_choice(&mut self, before: Option<&str>) {
        let (Some(before), Some(after)) = (before, self.document.text()) else { return };
        let follow = |path: Option<Path>| path.and_then(|path| found_at(&path, before, after));
        let (chosen, left) = (follow(self.selected.take()), follow(self.left.take()));
        (self.selected, self.left) = if chosen.is_some() { (chosen, left) } else { (left, None) };
    }
}
