//! Author's names as identifiers that meet no other.

use std::collections::BTreeSet;

/// The identifiers given so far.
#[derive(Default)]
pub struct Names(BTreeSet<String>);

/// The most letters that an author's name lends to an identifier.
const LONGEST: usize = 24;

impl Names {
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
            let (first, rest) = word.split_at(1);
            if camel.is_empty() {
                camel += &first.to_lowercase();
            } else {
                camel += &first.to_uppercase();
            }
            camel += rest;
        }
        // An identifier starts with a letter; the suffix keeps it apart from the library's functions.
        if !camel.starts_with(|c: char| c.is_ascii_alphabetic()) {
            camel.insert(0, 'x');
        }
        camel.truncate(LONGEST);
        self.unique(&(camel + suffix), "")
    }

    fn unique(&mut self, wanted: &str, separator: &str) -> String {
        let mut name = wanted.to_owned();
        let mut n = 2;
        while !self.0.insert(name.clone()) {
            name = format!("{wanted}{separator}{n}");
            n += 1;
        }
        name
    }
}

/// The stretches of letters and digits that WGSL takes everywhere.
fn words(name: &str) -> Vec<&str> {
    name.split(|c: char| !c.is_ascii_alphanumeric()).filter(|w| !w.is_empty()).collect()
}
