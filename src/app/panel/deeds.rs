//! What is done to the scene while one frame is laid out.
//!
//! In: [`Deeds`] of the panel's parts. Out: the scene's next text, in the document and on the disk.

use egui::Ui;

use super::Panel;
use crate::app::orders::Order;
use crate::edit::Edit;

/// What is gathered while one frame is laid out.
#[derive(Default)]
pub struct Deeds {
    pub edits: Vec<Edit>,
    pub orders: Vec<Order>,
    pub undo: bool,
    pub redo: bool,
    pub quits: bool,
}

impl Panel {
    /// Turns what was done into the scene's next text, and this into the file's once the hand rests.
    pub fn act(&mut self, ui: &Ui, deeds: &mut Deeds) {
        let mut is_new = false;
        for edit in deeds.edits.drain(..) {
            self.pending.note(&edit);
            is_new |= self.document.edit(edit);
        }
        let takes_back = std::mem::take(&mut self.handles.takes_back);
        if (takes_back && self.document.abandon())
            || (deeds.undo && self.document.undo())
            || (deeds.redo && self.document.redo())
        {
            self.pending.clear();
            is_new = true;
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
            deeds.orders.push(Order::Edited(self.document.overlay()));
        }
    }
}
