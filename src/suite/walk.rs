//! The files below a folder, also by links to folders; each folder is walked once.
//!
//! In: a folder. Out: the paths of its files, or the folder that cannot be read.

use std::collections::BTreeSet;
use std::path::{Path, PathBuf};

/// A walk through several folders.
#[derive(Default)]
pub struct Walk {
    /// Where the folders really are that have been walked: a link may lead back to where it lies.
    walked: BTreeSet<PathBuf>,
}

impl Walk {
    /// The files below `folder`, sorted; hidden folders and `target` are left out. What a link leads to has
    /// the name that the folder has without it, if it lies below `folder` as well.
    ///
    /// # Errors
    /// Which folder cannot be read.
    pub fn files_below(&mut self, folder: &Path) -> Result<Vec<PathBuf>, String> {
        let (mut files, mut links) = (vec![], vec![]);
        self.collect(folder, &mut files, &mut links)?;
        while !links.is_empty() {
            links.sort();
            for link in std::mem::take(&mut links) {
                self.collect(&link, &mut files, &mut links)?;
            }
        }
        files.sort();
        Ok(files)
    }

    fn collect(
        &mut self,
        folder: &Path,
        files: &mut Vec<PathBuf>,
        links: &mut Vec<PathBuf>,
    ) -> Result<(), String> {
        let unreadable = |error| format!("cannot read `{}`: {error}", folder.display());
        if !self.walked.insert(folder.canonicalize().map_err(unreadable)?) {
            return Ok(());
        }
        for entry in std::fs::read_dir(folder).map_err(unreadable)? {
            let path = entry.map_err(unreadable)?.path();
            let name = path.file_name().unwrap_or_default().to_string_lossy();
            if !path.is_dir() {
                files.push(path);
            } else if name.starts_with('.') || name == "target" {
                continue;
            } else if path.is_symlink() {
                links.push(path);
            } else {
                self.collect(&path, files, links)?;
            }
        }
        Ok(())
    }
}
