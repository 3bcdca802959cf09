//! A text, what was done to it in steps that can be undone, and what others did to its file meanwhile.

use super::inverse::inverse;
use super::merge::{Conflict, replay};
use super::{Edit, NewValue, Refusal, TextEdit};
use crate::diagnostic::Diagnostic;
use crate::scene::{self, Path};

/// The text of a scene that is edited here and maybe elsewhere, too.
#[derive(Clone, Debug)]
pub struct History {
    text: String,
    /// What the file holds, as far as is known.
    saved: String,
    done: Vec<Step>,
    undone: Vec<Step>,
    /// What makes the text of what is saved.
    pending: Vec<Edit>,
    /// How many of the steps that are done were done when it was saved.
    kept: usize,
    /// What the file holds and could not be merged.
    unmerged: bool,
}

/// What is undone at once.
#[derive(Clone, Debug)]
struct Step {
    gesture: Option<u64>,
    forth: TextEdit,
    back: TextEdit,
    /// None for what happened outside.
    edits: Option<Edits>,
}

#[derive(Clone, Debug, Default)]
struct Edits {
    forth: Vec<Edit>,
    /// In the order in which they take back.
    back: Vec<Edit>,
}

impl History {
    /// Begins with what the file holds.
    pub fn new(text: impl Into<String>) -> Self {
        let text = text.into();
        let (done, undone, pending) = (vec![], vec![], vec![]);
        Self { saved: text.clone(), text, done, undone, pending, kept: 0, unmerged: false }
    }

    pub fn text(&self) -> &str {
        &self.text
    }

    /// What the file holds, as far as is known.
    pub fn file_text(&self) -> &str {
        &self.saved
    }

    /// Makes an edit. Those that follow each other with the same `gesture`, such as a drag, are one step.
    /// False where all was so already.
    ///
    /// # Errors
    /// As [`Edit::on`] has them.
    pub fn edit(&mut self, edit: Edit, gesture: Option<u64>) -> Result<bool, Refusal> {
        let change = edit.on(&self.text)?;
        if change.is_empty() {
            return Ok(false);
        }
        let mut new = change.apply(&self.text);
        let back = inverse(&edit, &self.text, &new)?;
        self.undone.clear();
        let goes_on = |step: &&mut Step| gesture.is_some() && step.gesture == gesture;
        match self.done.last_mut().filter(goes_on) {
            Some(step) => {
                let before = step.back.apply(&self.text);
                let edits = step.edits.get_or_insert_default();
                let from = self.pending.len().saturating_sub(edits.forth.len());
                if !coalesced(&mut self.pending[from..], &edit) {
                    self.pending.push(edit.clone());
                }
                if !coalesced(&mut edits.forth, &edit) {
                    edits.forth.push(edit);
                    edits.back.insert(0, back);
                }
                // From where the gesture began: numbers on the way have left nothing of their style.
                new = edits.forth.iter().try_fold(before.clone(), |text, edit| {
                    edit.on(&text).map(|change| change.apply(&text))
                })?;
                (step.forth, step.back) = both_ways(&before, &new);
            }
            None => {
                let edits = Some(Edits { forth: vec![edit.clone()], back: vec![back] });
                self.done.push(Step::new(gesture, &self.text, &new, edits));
                self.pending.push(edit);
            }
        }
        self.text = new;
        // A drag that ends where it began is no step.
        if let Some(step) = self.done.pop_if(|step| step.forth.is_empty()) {
            self.take_back(&step);
        }
        self.forget_pending_if_saved();
        Ok(true)
    }

    /// Takes the last step back; false where there is none. Steps that happened outside are steps, too.
    pub fn undo(&mut self) -> bool {
        let Some(step) = self.done.pop() else { return false };
        self.text = step.back.apply(&self.text);
        self.take_back(&step);
        self.undone.push(step);
        self.forget_pending_if_saved();
        true
    }

    /// Takes the last step back for good, if `gesture` made it; whether it did. It cannot be made again.
    pub fn abandon(&mut self, gesture: u64) -> bool {
        let Some(step) = self.done.pop_if(|step| step.gesture == Some(gesture)) else { return false };
        self.text = step.back.apply(&self.text);
        self.take_back(&step);
        self.forget_pending_if_saved();
        true
    }

    /// Makes the last step again that was taken back; false where there is none.
    pub fn redo(&mut self) -> bool {
        let Some(step) = self.undone.pop() else { return false };
        self.text = step.forth.apply(&self.text);
        match &step.edits {
            Some(edits) => self.pending.extend(edits.forth.iter().cloned()),
            None => self.pending = vec![self.whole()],
        }
        // What follows it is no part of its gesture.
        self.done.push(Step { gesture: None, ..step });
        self.forget_pending_if_saved();
        true
    }

    pub fn can_undo(&self) -> bool {
        !self.done.is_empty()
    }

    /// Whether the step that [`History::undo`] takes back happened outside.
    pub fn undoes_outside(&self) -> bool {
        self.done.last().is_some_and(|step| step.edits.is_none())
    }

    pub fn can_redo(&self) -> bool {
        !self.undone.is_empty()
    }

    /// Whether the file holds this text, as far as is known.
    pub fn is_saved(&self) -> bool {
        self.text == self.saved
    }

    /// Whether the file holds something that [`History::outside`] could not merge: who saves now loses it.
    pub fn is_behind(&self) -> bool {
        self.unmerged
    }

    /// Tells that the text was written to the file.
    pub fn saved(&mut self) {
        self.saved.clone_from(&self.text);
        self.pending.clear();
        self.kept = self.done.len();
        self.unmerged = false;
    }

    /// Tells that the file holds `theirs`. What is not saved yet is done again on top of it, in steps of its
    /// own, but for what conflicts: there the text says what the file says, and [`Conflict::again`] overrules
    /// it.
    ///
    /// # Errors
    /// All mistakes of `theirs` where it cannot be read and there are edits to merge with it: then nothing
    /// changes, and [`History::is_behind`].
    pub fn outside(&mut self, theirs: &str) -> Result<Vec<Conflict>, Vec<Diagnostic>> {
        if theirs == self.saved {
            self.unmerged = false;
            return Ok(vec![]);
        }
        if theirs == self.text {
            self.saved();
            return Ok(vec![]);
        }
        let merged = if self.pending.is_empty() {
            Default::default()
        } else {
            self.unmerged = true;
            scene::parse("", theirs)?;
            replay(&self.saved, &self.pending, theirs)
        };
        self.unmerged = false;
        let mut text = self.text.clone();
        for step in self.done.drain(self.kept..).rev() {
            text = step.back.apply(&text);
        }
        self.undone.clear();
        self.done.push(Step::new(None, &text, theirs, None));
        self.kept = self.done.len();
        self.saved = theirs.to_owned();
        self.text = theirs.to_owned();
        self.pending.clear();
        for edit in merged.edits {
            // It was made on this very text.
            let again = self.edit(edit, None);
            debug_assert!(again.is_ok(), "{again:?}");
        }
        Ok(merged.conflicts)
    }

    /// The whole scene as one edit.
    fn whole(&self) -> Edit {
        Edit::Set { path: Path::default(), value: NewValue::Code(self.text.clone()) }
    }

    /// Keeps book of `step`, which was the last one, and is done no longer.
    fn take_back(&mut self, step: &Step) {
        let is_in_file = self.done.len() < self.kept;
        self.kept = self.kept.min(self.done.len());
        match &step.edits {
            Some(edits) if !is_in_file && self.pending.ends_with(&edits.forth) => {
                self.pending.truncate(self.pending.len() - edits.forth.len());
            }
            Some(edits) => self.pending.extend(edits.back.iter().cloned()),
            None => self.pending = vec![self.whole()],
        }
    }

    fn forget_pending_if_saved(&mut self) {
        if self.is_saved() {
            self.pending.clear();
        }
    }
}

impl Step {
    fn new(gesture: Option<u64>, before: &str, after: &str, edits: Option<Edits>) -> Self {
        let (forth, back) = both_ways(before, after);
        Self { gesture, forth, back, edits }
    }
}

fn both_ways(before: &str, after: &str) -> (TextEdit, TextEdit) {
    (TextEdit::between(before, after), TextEdit::between(after, before))
}

/// Whether one of `edits` sets the same value, with nothing behind it that has to do with that. It then sets
/// what `edit` does.
fn coalesced(edits: &mut [Edit], edit: &Edit) -> bool {
    let (Edit::Set { path, value } | Edit::Add { path, value, .. }) = edit else { return false };
    let is_apart = |other: &Path| !path.0.starts_with(&other.0) && !other.0.starts_with(&path.0);
    let behind = |known: &&mut Edit| match known {
        Edit::Set { path, .. } | Edit::Add { path, .. } => !is_apart(path),
        _ => true,
    };
    match edits.iter_mut().rev().find(behind) {
        Some(Edit::Set { path: same, value: old } | Edit::Add { path: same, value: old, .. })
            if same == path =>
        {
            *old = value.clone();
            true
        }
        _ => false,
    }
}
