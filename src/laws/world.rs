//! The files around a texture or shape that is tested, and small scenes among them.

use std::path::{Path, PathBuf};

use crate::compile::{Compiled, compile};
use crate::diagnostic::Report;
use crate::library::knot;
use crate::sources::{Disk, Sources};
use crate::wgsl::Mode;

/// Where scenes look for names: on this machine or in memory.
#[derive(Clone, Debug, Default)]
pub struct World {
    /// None where no disk is asked.
    pub disk: Option<Disk>,
    /// The folder of the scenes: `textures/` and `shapes/` beside it count.
    pub folder: PathBuf,
    /// Paths and texts that take the place of what is on the disk.
    pub files: Vec<(String, String)>,
}

impl World {
    pub fn sources(&self) -> Sources {
        let bare = self.disk.as_ref().map_or_else(Sources::in_memory, Disk::sources);
        let bare = bare.with(self.folder.join(knot::FILE), &knot::obj());
        self.files.iter().fold(bare, |sources, (path, text)| sources.with(path, text))
    }

    /// A scene of the world's folder. Where its text comes out as `before`, naga is not asked again.
    ///
    /// # Errors
    /// What is wrong with it, or with the files that it names.
    pub fn compiled(&self, objects: &str, mode: Mode, before: Option<&Compiled>) -> Result<Compiled, Report> {
        let scene = self.folder.join(Path::new("-"));
        let sources = self.sources().with(&scene, &format!("(objects: [\n{objects}])"));
        let outcome = compile(&sources, &scene, mode, before);
        outcome.compiled.ok_or(outcome.report)
    }
}
