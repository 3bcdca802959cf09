//! The files that one scene may name, and no others.
//!
//! In: [`Sources`], the folder of a scene, paths. Out: what is there, or that it lies out of reach.

use std::path::{Component, Path, PathBuf};
use std::sync::Arc;

use super::disk::{MAX_BYTES, MAX_TEXT, unread};
use super::{Answer, Sources};
use crate::diagnostic::Diagnostic;

/// The files that a scene may name: those below its root. That is the folder that raytoy runs in where the
/// scene lies below it, else the scene's own folder, unless [`Sources::below`] names another.
pub struct Reach<'a> {
    pub(super) sources: &'a Sources,
    pub(super) folder: PathBuf,
    pub(super) root: PathBuf,
}

impl Reach<'_> {
    /// The folder that the scene lies in.
    pub fn folder(&self) -> &Path {
        &self.folder
    }

    /// The content of `path`.
    pub fn read(&self, path: &Path) -> Answer {
        self.read_up_to(path, MAX_BYTES)
    }

    /// The text at `path`.
    ///
    /// # Errors
    /// Why there is none.
    pub fn text(&self, path: &Path) -> Result<Arc<str>, Diagnostic> {
        self.told(path, self.read_up_to(path, MAX_TEXT))
    }

    /// The bytes at `path`.
    ///
    /// # Errors
    /// Why there are none.
    pub fn bytes(&self, path: &Path) -> Result<Arc<[u8]>, Diagnostic> {
        match self.read(path) {
            Answer::Binary(bytes) => Ok(bytes),
            other => self.told(path, other).map(|text| text.as_bytes().into()),
        }
    }

    /// The stems of the `.wgsl` files in `folder`, sorted.
    pub fn snippets_in(&self, folder: &Path) -> Vec<String> {
        let folder = self.sources.absolute(folder);
        let given = self.sources.given.iter().filter(|path| path.parent() == Some(folder.as_path()));
        let mut stems: Vec<String> = given.filter_map(|path| snippet_stem(path)).collect();
        if self.sources.on_disk
            && let Ok(real) = self.judge(&folder)
            && let Ok(entries) = std::fs::read_dir(real)
        {
            stems.extend(entries.flatten().filter_map(|entry| snippet_stem(&entry.path())));
        }
        stems.sort();
        stems.dedup();
        stems
    }

    /// The folders in which names are looked up, nearest first.
    pub fn folders(&self) -> Vec<PathBuf> {
        let above = self.folder.ancestors().take_while(|above| above.starts_with(&self.root));
        above.map(Path::to_path_buf).collect()
    }

    fn read_up_to(&self, path: &Path, most: u64) -> Answer {
        let path = self.sources.absolute(path);
        self.sources.recall(&path, most, |path| self.judge(path))
    }

    fn told(&self, path: &Path, answer: Answer) -> Result<Arc<str>, Diagnostic> {
        let (path, is_outside) = (self.sources.absolute(path), answer == Answer::Outside);
        let told = self.sources.told(&path, answer);
        told.map_err(|problem| match is_outside {
            true => self.by_link(&path).unwrap_or(problem).help(format!(
                "the root folder is {}; `--root FOLDER` sets another one",
                match self.root == self.sources.here {
                    true => "the current folder".to_owned(),
                    false => format!("`{}`", self.sources.name(&self.root)),
                }
            )),
            false => problem,
        })
    }

    /// The problem of a link that leads out of the root; None where `path` itself lies outside.
    fn by_link(&self, path: &Path) -> Option<Diagnostic> {
        let why =
            format!("`{}` is a link to a file outside of the scene's root folder", self.sources.name(path));
        self.holds(path).then(|| Diagnostic::error(why))
    }

    /// Returns true if `path` is in the root, links aside.
    fn holds(&self, path: &Path) -> bool {
        path.starts_with(&self.root) && !names_drive(path)
    }

    /// The real path of the file at `path`, after all links.
    fn judge(&self, path: &Path) -> Result<PathBuf, Answer> {
        // Nothing outside is looked at, so that no message says what is there.
        if !self.holds(path) {
            return Err(Answer::Outside);
        }
        let real = path.canonicalize().map_err(|error| unread(&error))?;
        // A user may name a scene by a linked folder: then its files lie beside it, there.
        let places = [&self.root, &self.folder].map(|folder| folder.canonicalize());
        let is_inside = places.iter().flatten().any(|folder| real.starts_with(folder));
        is_inside.then_some(real).ok_or(Answer::Outside)
    }
}

/// Returns true if a part of `path` is a drive, as in `C:/model.obj`. Windows has it in front only.
fn names_drive(path: &Path) -> bool {
    let is_drive = |part: &str| matches!(part.as_bytes(), [letter, b':'] if letter.is_ascii_alphabetic());
    path.components()
        .filter(|part| matches!(part, Component::Normal(_)))
        .any(|part| part.as_os_str().to_str().is_some_and(is_drive))
}

fn snippet_stem(path: &Path) -> Option<String> {
    let is_snippet = path.extension().is_some_and(|e| e == "wgsl");
    is_snippet.then(|| path.file_stem()?.to_str().map(str::to_owned)).flatten()
}
