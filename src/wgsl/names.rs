//! Author's names as identifiers that meet no other.

use std::collections::{BTreeSet, HashSet};
use std::sync::LazyLock;

use super::sections::functions_in;
use crate::library::BUILT_IN;

/// The functions of raytoy's own files.
static SHIPPED: LazyLock<HashSet<&str>> =
    LazyLock::new(|| BUILT_IN.iter().flat_map(|(_, text)| functions_in(text)).collect());

/// The identifiers given so far.
pub struct Names<'a> {
    given: BTreeSet<String>,
    /// Words of the author's files.
    taken: HashSet<&'a str>,
}

/// The most letters that an author's name lends to an identifier.
const LONGEST: usize = 24;

impl<'a> Names<'a> {
    /// Identifiers that are no function of raytoy's files, and no word of `files`.
    pub fn beside(files: impl IntoIterator<Item = &'a str>) -> Self {
        Self { given: BTreeSet::new(), taken: files.into_iter().flat_map(words_in).collect() }
    }

    /// Whether `text` has one of them.
    pub fn meet(&self, text: &str) -> bool {
        words_in(text).any(|word| self.given.contains(word))
    }

    /// `OBJECT_LEG_1` for "leg 1".
    pub fn constant(&mut self, prefix: &str, name: &str) -> String {
        let words = words(name);
        let tail = if words.is_empty() { "X".into() } else { words.join("_").to_uppercase() };
        let tail = tail[..tail.len().min(LONGEST)].trim_end_matches('_');
        self.unique(&format!("{prefix}_{tail}"), "_")
    }

    /// `leg1Material` for "leg 1".
    pub fn function(&mut self, name: &str, suffix: &str) -> String {
        let mut camel = String::new();
        for word in words(name) {
            let is_shouted = word.chars().all(|c| !c.is_ascii_lowercase());
            let word = if is_shouted { word.to_lowercase() } else { word.to_owned() };
            let (first, rest) = word.split_at(1);
            if camel.is_empty() {
                camel += &first.to_lowercase();
            } else {
                camel += &first.to_uppercase();
            }
            camel += rest;
        }
        // An identifier starts with a letter.
        if !camel.starts_with(|c: char| c.is_ascii_alphabetic()) {
            camel.insert(0, 'x');
        }
        camel.truncate(LONGEST);
        self.unique(&(camel + suffix), "")
    }

    /// `leg_1_part` for "leg 1".
    pub fn variable(&mut self, name: &str, suffix: &str) -> String {
        let mut snake = words(name).join("_").to_lowercase();
        if !snake.starts_with(|c: char| c.is_ascii_alphabetic()) {
            snake.insert(0, 'x');
        }
        let own = snake[..snake.len().min(LONGEST)].trim_end_matches('_');
        self.unique(&format!("{own}_{suffix}"), "_")
    }

    fn unique(&mut self, wanted: &str, separator: &str) -> String {
        let mut name = wanted.to_owned();
        let mut n = 2;
        while self.is_taken(&name) || !self.given.insert(name.clone()) {
            name = format!("{wanted}{separator}{n}");
            n += 1;
        }
        name
    }

    fn is_taken(&self, name: &str) -> bool {
        SHIPPED.contains(name) || self.taken.contains(name)
    }
}

/// The words of a file, with those in its comments.
fn words_in(text: &str) -> impl Iterator<Item = &str> {
    text.split(|c: char| !c.is_alphanumeric() && c != '_').filter(|word| !word.is_empty())
}

/// The stretches of letters and digits that WGSL takes everywhere.
fn words(name: &str) -> Vec<&str> {
    name.split(|c: char| !c.is_ascii_alphanumeric()).filter(|w| !w.is_empty()).collect()
}
