//! A version of the scene with its pipelines, as the painter keeps it.

use super::builder::Version;
use super::events::Change;
use crate::gpu::Pipeline;

/// A scene on the GPU.
pub struct Drawable {
    pub version: Box<Version>,
    pub baked: Option<Pipeline>,
    pub live: Option<Pipeline>,
    /// Whether the live pipeline has drawn, in which some drivers compile.
    pub is_warm: bool,
    /// Whether a picture of it went to the window.
    pub is_shown: bool,
    pub edit: u64,
    /// Whether a snippet reads the clock, or the mouse.
    pub moves: bool,
    pub reads_mouse: bool,
}

impl Drawable {
    /// `version`, which took the place of `before`: where only numbers differ, that one's pipeline goes on.
    pub fn new(mut version: Box<Version>, before: Option<Drawable>) -> Self {
        let snippets = version.compiled.source.sections.iter().filter(|s| !s.name.starts_with("shaders/"));
        let reads = |what: &str| snippets.clone().any(|s| s.text.contains(what));
        let (moves, reads_mouse) = (reads("frame.time"), reads("frame.mouse"));
        let edit = before.as_ref().map_or(0, |scene| scene.edit + 1);
        let baked = version.baked.take();
        let live = before.filter(|_| version.change == Change::Numbers).and_then(|before| before.live);
        let is_warm = live.is_some();
        Self { version, baked, live, is_warm, is_shown: false, edit, moves, reads_mouse }
    }

    /// The baked pipeline until a number is edited, then the live one.
    pub fn pipeline(&self) -> &Pipeline {
        let pipeline = self.baked.as_ref().or(self.live.as_ref());
        pipeline.expect("a scene comes with a baked pipeline, and loses it only to a live one")
    }
}
