//! The generated shader as rows of text, and what an edit of the scene's structure has changed in it.
//!
//! In: the versions of the scene, one after another. Out: [`Row`]s, made once somebody looks.

use std::sync::Arc;

use crate::compile::Compiled;
use crate::difference::{Hunk, TextDifference, with_origin_of};
use crate::engine::focus::Focus;
use crate::wgsl::{Mode, Target, generate};

/// A line, and before it what a diff says of it: ' ' for both versions, '-' for the old one, '+' for the new
/// one, '@' for where it is.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Row {
    pub sign: char,
    pub text: String,
}

/// Rows to scroll through.
#[derive(Default)]
pub struct Page {
    pub rows: Vec<Row>,
    /// Letters of the longest.
    pub width: usize,
}

/// The shader of the version that is shown, and of the one before its structure changed.
#[derive(Default)]
pub struct Listing {
    focus: Focus,
    whole: History,
    /// Of what is shown alone, since it is.
    part: History,
    page: Option<Page>,
    changes: Option<Changes>,
}

/// What has changed.
#[derive(Default)]
pub struct Changes {
    pub page: Page,
    /// In few words.
    pub told: String,
}

#[derive(Default)]
struct History {
    now: Option<Arc<Compiled>>,
    /// Before the last edit of the structure; before there was one, the first version.
    before: Option<Arc<Compiled>>,
    has_structural: bool,
}

impl Listing {
    /// Another version of the scene is shown, or the part of it that `focus` says.
    pub fn take(&mut self, compiled: &Arc<Compiled>, focus: &Focus) {
        if self.focus != *focus {
            self.focus = focus.clone();
            self.part = History::default();
        }
        let history = if self.focus == Focus::All { &mut self.whole } else { &mut self.part };
        history.take(compiled);
        (self.page, self.changes) = (None, None);
    }

    /// The scene's own section, with its numbers written out.
    pub fn page(&mut self) -> &Page {
        let history = if self.focus == Focus::All { &self.whole } else { &self.part };
        self.page.get_or_insert_with(|| {
            let text = history.now.as_deref().map_or(String::new(), baked);
            Page::of(text.lines().map(|line| Row { sign: ' ', text: line.to_owned() }).collect())
        })
    }

    /// What differs from the version before the last edit of the structure. Numbers are none.
    pub fn changes(&mut self) -> &Changes {
        let history = if self.focus == Focus::All { &self.whole } else { &self.part };
        self.changes.get_or_insert_with(|| history.changes())
    }
}

impl Page {
    fn of(rows: Vec<Row>) -> Self {
        let width = rows.iter().map(|row| row.text.chars().count()).max().unwrap_or(0);
        Self { rows, width }
    }
}

impl History {
    fn take(&mut self, compiled: &Arc<Compiled>) {
        match &self.now {
            None => self.before = Some(compiled.clone()),
            Some(now) if !has_same_structure(now, compiled) => {
                self.before = Some(now.clone());
                self.has_structural = true;
            }
            Some(_) => {}
        }
        self.now = Some(compiled.clone());
    }

    fn changes(&self) -> Changes {
        let (Some(before), Some(now)) = (&self.before, &self.now) else {
            return Changes::default();
        };
        let [old, new] = [baked(before), baked(now)];
        let mut rows = vec![];
        let mut add = |old: &str, new: &str| {
            let difference = TextDifference::between(old, new);
            rows.extend(difference.iter().flat_map(|difference| &difference.hunks).flat_map(rows_of));
        };
        let is_same = old == new;
        add(&with_origin_of(&new, &old), &new);
        for section in &now.source.sections[1..] {
            let other = before.source.sections[1..].iter().find(|other| other.name == section.name);
            if let Some(other) = other.filter(|other| other.text != section.text) {
                add(&other.text, &section.text);
            }
        }
        let told = match (self.has_structural, is_same && rows.is_empty()) {
            (false, true) => "No changes since the scene was opened.".to_owned(),
            (false, false) => "Only numbers have changed since the scene was opened.".to_owned(),
            (true, true) => "The text has not changed, but an image or a model has.".to_owned(),
            (true, false) => {
                let count = |sign| rows.iter().filter(|row| row.sign == sign).count();
                format!("{} lines removed, {} added", count('-'), count('+'))
            }
        };
        // An edit of numbers is not shown line by line.
        let rows = if self.has_structural { rows } else { vec![] };
        Changes { page: Page::of(rows), told }
    }
}

/// The own section of a version, with its numbers written out and without what is measured.
pub fn baked(compiled: &Compiled) -> String {
    own_text(compiled, Mode::Baked)
}

fn own_text(compiled: &Compiled, mode: Mode) -> String {
    let target = Target { views: false, ..Target::raytoy(mode) };
    generate(&compiled.scene, &target).generated().to_owned()
}

/// Whether both have the same text once their numbers are data. What is measured does not count.
fn has_same_structure(a: &Compiled, b: &Compiled) -> bool {
    if a.scene.measure == b.scene.measure {
        return a.has_structure_of(b);
    }
    a.scene.has_files_of(&b.scene) && own_text(a, Mode::Live) == own_text(b, Mode::Live)
}

fn rows_of(hunk: &Hunk) -> impl Iterator<Item = Row> + '_ {
    let head = Row { sign: '@', text: hunk.head() };
    let lines = hunk.lines.iter().map(|(sign, text)| Row { sign: *sign, text: text.clone() });
    std::iter::once(head).chain(lines)
}
