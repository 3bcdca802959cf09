//! A version of the scene with its pipelines, as the painter keeps it.

use std::sync::Arc;
use std::time::Duration;

use super::builder_messages::Version;
use super::events::Change;
use crate::diagnostic::{Diagnostic, Report};
use crate::gpu::{Gpu, Pipeline};
use crate::sketch::Sketch;

/// What a pixel of a sketch takes, before one of the scene has been drawn.
const FIRST_COST: Duration = Duration::from_micros(5);

/// A scene on the GPU.
pub struct Drawable {
    pub version: Box<Version>,
    pub sketch: Option<Sketch>,
    /// What a pixel of a sketch takes.
    pub sketch_cost: Duration,
    pub baked: Option<Pipeline>,
    /// One for all versions that differ in numbers: it has those of the one drawn last.
    pub full: Option<Arc<Pipeline>>,
    /// Whether the full pipeline has drawn, in which some drivers compile.
    pub is_warm: bool,
    /// Whether a picture of it went to the window.
    pub is_shown: bool,
    /// Whether a picture of it was drawn whole, in which it did no harm.
    pub is_proven: bool,
    /// Whether the driver was held to account for it, and what it is doubted over.
    pub is_examined: bool,
    pub doubt: Option<Diagnostic>,
    pub edit: u64,
    /// Whether a snippet reads the clock, or the mouse.
    pub moves: bool,
    pub reads_mouse: bool,
}

impl Drawable {
    /// `version`, which follows `before`: where only numbers differ, that one's pipeline goes on.
    pub fn new(mut version: Box<Version>, before: Option<&Drawable>) -> Self {
        let snippets = version.compiled.source.sections.iter().filter(|s| !s.name.starts_with("shaders/"));
        let reads = |what: &str| snippets.clone().any(|s| s.text.contains(what));
        let (moves, reads_mouse) = (reads("frame.time"), reads("frame.mouse"));
        let edit = before.map_or(0, |scene| scene.edit + 1);
        let name = &version.compiled.scene.name;
        let same_file = before.filter(|before| before.version.compiled.scene.name == *name);
        let sketch_cost = same_file.map_or(FIRST_COST, |before| before.sketch_cost);
        let (sketch, baked) = (version.sketch.take(), version.baked.take());
        let same_text = before.filter(|_| version.change == Change::Numbers);
        let full = same_text.and_then(|before| before.full.clone());
        let is_warm = full.is_some();
        Self {
            version,
            sketch,
            sketch_cost,
            baked,
            full,
            is_warm,
            is_shown: false,
            is_proven: false,
            is_examined: same_text.is_some_and(|before| before.is_examined),
            doubt: same_text.and_then(|before| before.doubt.clone()),
            edit,
            moves,
            reads_mouse,
        }
    }

    /// The baked pipeline until a number is edited, then the full one; for debug views one that has them, if
    /// it is there already.
    pub fn pipeline(&self, for_views: bool) -> Option<&Pipeline> {
        self.baked_for(for_views).or(self.full.as_deref())
    }

    /// The baked pipeline, if it shows what is looked at.
    pub fn baked_for(&self, views: bool) -> Option<&Pipeline> {
        self.baked.as_ref().filter(|baked| baked.has_views || !views)
    }

    /// The sketch, while there is no pipeline to show what is looked at.
    pub fn sketch_for(&self, views: bool) -> Option<&Sketch> {
        let sketch = self.sketch.as_ref().filter(|sketch| sketch.has_views || !views);
        sketch.filter(|_| self.pipeline(views).is_none())
    }

    /// All that makes the picture doubtful; `warnings` are those of the scene's files.
    pub fn warned(&self, warnings: &Report) -> Report {
        let mut all = warnings.clone();
        all.diagnostics.extend(self.doubt.clone());
        all
    }

    /// The pipelines get this version's numbers, unless they have them written out.
    pub fn upload(&self, gpu: &Gpu) {
        if let Some(full) = &self.full {
            full.upload(gpu, &self.version.compiled.source.numbers);
        }
    }
}
