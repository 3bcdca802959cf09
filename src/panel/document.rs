//! The text of the open scene: what is done to it here, what its file says, and what is still to be saved.

use std::io;
use std::path::{Path, PathBuf};
use std::sync::Arc;

use crate::edit::{Conflict, Edit, History, Refusal};
use crate::files::write_file;

/// A scene's text between the panel and the file. It has none until the file was read once.
pub struct Document {
    path: PathBuf,
    history: Option<History>,
    /// Whether edits are only tried and not written to the file.
    pub tries_only: bool,
    /// What was changed here and in the file, and waits for the author's choice.
    pub conflicts: Vec<Conflict>,
    /// Why the last edit or save did not succeed.
    pub failure: Option<String>,
    /// Edits with the same number are undone at once.
    gesture: u64,
}

impl Document {
    pub fn new(path: &Path) -> Self {
        let (history, conflicts, failure) = (None, vec![], None);
        Self { path: path.to_owned(), history, tries_only: false, conflicts, failure, gesture: 0 }
    }

    pub fn text(&self) -> Option<&str> {
        self.history.as_ref().map(History::text)
    }

    /// What to show instead of the file, if that is another text.
    pub fn overlay(&self) -> Option<Arc<str>> {
        let history = self.history.as_ref().filter(|history| !history.is_saved());
        history.map(|history| history.text().into())
    }

    pub fn is_saved(&self) -> bool {
        self.history.as_ref().is_none_or(History::is_saved)
    }

    pub fn can_undo(&self) -> bool {
        self.history.as_ref().is_some_and(History::can_undo)
    }

    /// Whether [`Document::undo`] takes back what an editor has saved.
    pub fn undoes_outside(&self) -> bool {
        self.history.as_ref().is_some_and(History::undoes_outside)
    }

    pub fn can_redo(&self) -> bool {
        self.history.as_ref().is_some_and(History::can_redo)
    }

    /// Makes an edit, one step with those since the last [`Document::rest`]; whether the text has changed.
    pub fn edit(&mut self, edit: Edit) -> bool {
        let Some(history) = &mut self.history else { return false };
        let result = history.edit(edit, Some(self.gesture));
        self.failure = result.as_ref().err().map(Refusal::to_string);
        result.unwrap_or(false)
    }

    /// The hand rests: what follows is another step.
    pub fn rest(&mut self) {
        self.gesture += 1;
    }

    /// Takes back for good what was edited since the last [`Document::rest`]; whether that was anything.
    pub fn abandon(&mut self) -> bool {
        let gesture = self.gesture;
        self.rest();
        self.history.as_mut().is_some_and(|history| history.abandon(gesture))
    }

    pub fn undo(&mut self) -> bool {
        self.rest();
        self.history.as_mut().is_some_and(History::undo)
    }

    pub fn redo(&mut self) -> bool {
        self.rest();
        self.history.as_mut().is_some_and(History::redo)
    }

    /// The file says `text`. What is not saved stays, on top of it.
    pub fn file_says(&mut self, text: &str) {
        match &mut self.history {
            None => self.history = Some(History::new(text)),
            Some(history) => match history.outside(text) {
                Ok(conflicts) => self.conflicts.extend(conflicts),
                // The mistakes of the file are shown with the next verdict.
                Err(_) => self.failure = Some("the file has mistakes: correct them to continue here".into()),
            },
        }
    }

    /// Ends a conflict: with what was done here, or with what the file says.
    pub fn settle(&mut self, index: usize, with_mine: bool) -> bool {
        let conflict = self.conflicts.remove(index);
        self.rest();
        match conflict.again.filter(|_| with_mine) {
            Some(edit) => self.edit(edit),
            None => false,
        }
    }

    /// Writes the text to the file, all of it or nothing.
    pub fn save(&mut self) {
        let Some(history) = &mut self.history else { return };
        if history.is_behind() {
            return;
        }
        match write(&self.path, history.file_text(), history.text()) {
            Ok(true) => {
                history.saved();
                self.failure = None;
            }
            // Somebody has just written it. The news is on its way, and is merged first.
            Ok(false) => {}
            Err(error) => self.failure = Some(format!("cannot write {}: {error}", self.path.display())),
        }
    }
}

/// Puts `new` in place of the file at `path`, if that still holds `old`: whether it did.
fn write(path: &Path, old: &str, new: &str) -> io::Result<bool> {
    if std::fs::read(path)? != old.as_bytes() {
        return Ok(false);
    }
    write_file(path, new.as_bytes()).map(|()| true)
}
