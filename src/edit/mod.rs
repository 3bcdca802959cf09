//! A change of a value becomes a change of bytes: what an author wrote around it stays as it is.
//!
//! In: the text of a scene and an [`Edit`]. Out: a [`TextEdit`], or why not. [`History`] keeps them in order.

mod change;
mod color;
mod history;
mod inverse;
mod merge;
mod number;
mod place;
mod siblings;
mod text;
mod trivia;

use std::fmt;
use std::ops::Range;

use glam::Vec3;

pub use history::History;
pub use inverse::copy_of;
pub use merge::{Conflict, found_at};

use crate::diagnostic::Diagnostic;
use crate::scene::Path;

/// What a person does to a scene.
#[derive(Clone, Debug, PartialEq)]
pub enum Edit {
    /// Gives the value at `path`, and adds it where it was left out, with the groups that lead to it.
    Set { path: Path, value: NewValue },
    /// The same, but what was left out is added before the first of its siblings that stands behind it in
    /// `order`.
    Add { path: Path, value: NewValue, order: Vec<String> },
    /// Takes out a field with its name, an entry of a map, or an item of a list. Of what had brackets, empty
    /// ones remain.
    Remove { path: Path },
    /// Puts RON text into a list, as item `index`, or last where the list is shorter.
    Insert { list: Path, index: usize, item: String },
    /// Puts a copy of an item or entry behind it. Names of objects and keys in the copy become new ones.
    Duplicate { path: Path },
    /// Gives `Name(…)` another name, and keeps only those of its fields that are in `keep`.
    Rename { path: Path, name: String, keep: Vec<String> },
}

/// A value to be written.
#[derive(Clone, Debug, PartialEq)]
pub enum NewValue {
    Number(f32),
    /// Two to four numbers.
    Vector(Vec<f32>),
    /// Linear RGB.
    Color(Vec3),
    Flag(bool),
    /// A choice as RON has it: `None`, `Aces`, `Gamma(2.0)`.
    Word(String),
    /// What a string says: a name, a file, a declared texture.
    Text(String),
    /// RON text, such as `Noise(scale: 3)`.
    Code(String),
}

/// A stretch of a text, in bytes, and what takes its place.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct TextEdit {
    pub span: Range<usize>,
    pub with: String,
}

/// Why a scene cannot be edited so.
#[derive(Clone, Debug, PartialEq)]
pub enum Refusal {
    /// The text is no RON.
    Syntax(Vec<Diagnostic>),
    /// Nothing is at the path, and nothing can be added there.
    NotThere(Path),
    /// The new value cannot be written.
    Unfit { path: Path, why: String },
}

impl Edit {
    /// What this edit does to `text`. It is empty where all is so already.
    ///
    /// The RON parser recurses, at most 128 levels: it wants 2 MiB of stack, as threads have.
    ///
    /// # Errors
    /// Where `text` is no RON, has no place for the value, or where the value cannot be written.
    pub fn on(&self, text: &str) -> Result<TextEdit, Refusal> {
        match self {
            Edit::Set { path, value } => place::set(text, path, value, &[]),
            Edit::Add { path, value, order } => place::set(text, path, value, order),
            Edit::Remove { path } => place::remove(text, path),
            Edit::Insert { list, index, item } => place::insert(text, list, *index, item),
            Edit::Duplicate { path } => place::duplicate(text, path),
            Edit::Rename { path, name, keep } => place::rename(text, path, name, keep),
        }
    }
}

impl TextEdit {
    fn insert(at: usize, with: String) -> Self {
        Self { span: at..at, with }
    }

    /// `text` without `cuts`, which do not overlap.
    fn cut(text: &str, mut cuts: Vec<Range<usize>>) -> Self {
        cuts.sort_by_key(|cut| cut.start);
        Self::replace_all(text, cuts.into_iter().map(|cut| (cut, String::new())).collect())
    }

    /// `text` with several stretches replaced, which are in order and do not overlap.
    fn replace_all(text: &str, parts: Vec<(Range<usize>, String)>) -> Self {
        let (Some((first, _)), Some((last, _))) = (parts.first(), parts.last()) else {
            return Self::insert(0, String::new());
        };
        let (start, end) = (first.start, last.end);
        let (mut with, mut at) = (String::new(), start);
        for (span, new) in parts {
            with += &text[at..span.start];
            with += &new;
            at = span.end;
        }
        Self { span: start..end, with }
    }

    /// The smallest one that makes `new` of `old`.
    pub fn between(old: &str, new: &str) -> Self {
        let same = old.bytes().zip(new.bytes()).take_while(|(a, b)| a == b).count();
        let start = old.floor_char_boundary(same).min(new.floor_char_boundary(same));
        let tails = old[start..].bytes().rev().zip(new[start..].bytes().rev());
        let mut tail = tails.take_while(|(a, b)| a == b).count();
        while !old.is_char_boundary(old.len() - tail) || !new.is_char_boundary(new.len() - tail) {
            tail -= 1;
        }
        Self { span: start..old.len() - tail, with: new[start..new.len() - tail].to_owned() }
    }

    /// Whether it changes nothing.
    pub fn is_empty(&self) -> bool {
        self.span.is_empty() && self.with.is_empty()
    }

    /// `text` with this edit made.
    pub fn apply(&self, text: &str) -> String {
        [&text[..self.span.start], &self.with, &text[self.span.end..]].concat()
    }
}

impl fmt::Display for Refusal {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Refusal::Syntax(problems) => {
                let first = problems.first().map_or("the text is not a scene", |p| p.message.as_str());
                write!(f, "the scene cannot be read: {first}")
            }
            Refusal::NotThere(path) => write!(f, "the scene has no place for `{path}`"),
            Refusal::Unfit { path, why } => write!(f, "`{path}` cannot be set: {why}"),
        }
    }
}
