//! Files that a scene could name, found by how their names end.
//!
//! In: a [`Reach`]. Out: paths as the scene would write them.

use std::fs;

use super::Reach;

/// How far below the scene's folder files are looked for, and among how many.
const DEEP: usize = 3;
const MANY: usize = 5000;

impl Reach<'_> {
    /// The files beside the scene and below that end in one of `extensions`, nearest first. Links and
    /// hidden files are left out.
    pub fn files_below(&self, extensions: &[&str]) -> Vec<String> {
        let mut found = vec![];
        let mut folders = if self.sources.on_disk { vec![(self.folder.clone(), 0)] } else { vec![] };
        let mut left = MANY;
        while let Some((here, depth)) = folders.pop() {
            for entry in fs::read_dir(here).into_iter().flatten().flatten().take(left) {
                left -= 1;
                let (path, name) = (entry.path(), entry.file_name());
                let Ok(kind) = entry.file_type() else { continue };
                if name.to_string_lossy().starts_with('.') || kind.is_symlink() {
                    continue;
                }
                let ends = path
                    .extension()
                    .is_some_and(|own| extensions.iter().any(|e| own.eq_ignore_ascii_case(e)));
                if kind.is_dir() {
                    folders.extend((depth < DEEP).then_some((path, depth + 1)));
                } else if ends && let Ok(path) = path.strip_prefix(&self.folder) {
                    let steps: Vec<_> = path.iter().map(|step| step.to_string_lossy()).collect();
                    found.push((depth, steps.join("/")));
                }
            }
        }
        found.sort();
        found.into_iter().map(|(_, path)| path).collect()
    }
}
