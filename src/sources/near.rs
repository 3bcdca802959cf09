//! Files that a scene could name, found by how their names end.
//!
//! In: a [`Reach`]. Out: paths as the scene would write them.

use std::collections::VecDeque;
use std::ffi::OsStr;
use std::fs;

use super::Reach;

/// How many folders away from the scene's files are looked for, and among how many.
const FAR: usize = 3;
const MANY: usize = 5000;

impl Reach<'_> {
    /// The files in the scene's reach that end in one of `extensions`, nearest first: beside the scene,
    /// below, and around it up to its root. Links, hidden files and names that are no text are left out.
    pub fn files_near(&self, extensions: &[&str]) -> Vec<String> {
        let mut found = vec![];
        let here = (self.folder.clone(), String::new(), 0);
        let mut folders = VecDeque::from_iter(self.sources.on_disk.then_some(here));
        let mut left = MANY;
        while let Some((here, written, steps)) = folders.pop_front() {
            for entry in fs::read_dir(&here).into_iter().flatten().flatten().take(left) {
                left -= 1;
                let (path, name) = (entry.path(), entry.file_name());
                let (Ok(kind), Some(name)) = (entry.file_type(), name.to_str()) else { continue };
                // The way up has come from there.
                if name.starts_with('.') || kind.is_symlink() || self.folder.starts_with(&path) {
                    continue;
                }
                let written = format!("{written}{name}");
                let is_one = |own: &OsStr| extensions.iter().any(|e| own.eq_ignore_ascii_case(e));
                if kind.is_dir() {
                    folders.extend((steps < FAR).then_some((path, written + "/", steps + 1)));
                } else if path.extension().is_some_and(is_one) {
                    found.push((steps, written));
                }
            }
            if let Some(above) = here.parent()
                && self.folder.starts_with(&here)
                && here != self.root
                && steps < FAR
            {
                folders.push_back((above.to_owned(), format!("{written}../"), steps + 1));
            }
        }
        found.sort();
        found.into_iter().map(|(_, path)| path).collect()
    }
}
