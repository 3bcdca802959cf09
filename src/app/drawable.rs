//! A version of the scene with its pipelines, as the painter keeps it.

use super::builder::Version;
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
    /// The baked pipeline until a number is edited, then the live one.
    pub fn pipeline(&self) -> &Pipeline {
        let pipeline = self.baked.as_ref().or(self.live.as_ref());
        pipeline.expect("a scene comes with a baked pipeline, and loses it only to a live one")
    }
}
