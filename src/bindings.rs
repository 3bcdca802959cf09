//! What shaders are bound to: each resource with its group, its number, its name and its content.
//!
//! In: nothing. Out: [`Binding`]s, from which the declarations of generated text, the layouts of bind groups
//! and the heads of exports are made.

/// A resource that a shader declares.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Binding {
    pub group: u32,
    pub number: u32,
    /// The variable in the text.
    pub name: &'static str,
    pub content: Content,
    /// The stages in which a shader reads it.
    pub stages: &'static [Stage],
}

/// What a host binds there.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Content {
    Uniform,
    /// A storage buffer.
    Storage {
        is_writable: bool,
    },
    /// A texture of floats that is read texel by texel.
    Texels,
    /// A texture of floats that is read through a sampler.
    Image,
    /// A texture of whole numbers that is read texel by texel.
    Words,
    Sampler,
}

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Stage {
    Vertex,
    Fragment,
    Compute,
}

use Stage::{Compute, Fragment, Vertex};

// Group 0 of a scene's shader: the picture.
pub const FRAME: Binding = row(0, 0, "frame", Content::Uniform, &[Fragment, Compute]);
pub const ACCUMULATED: Binding = row(0, 1, "accumulated", Content::Texels, &[Fragment]);
/// In place of `ACCUMULATED` in exports.
pub const SAMPLES: Binding = row(0, 1, "samples", Content::Texels, &[Fragment]);
/// The scene's numbers, where they are live.
pub const NUMBERS: Binding = row(0, 2, "scene", Content::Uniform, &[Fragment, Compute]);
pub const ENDED_LOOP: Binding =
    row(0, 3, "ended_loop", Content::Storage { is_writable: true }, &[Fragment, Compute]);
pub const CORNER: Binding = row(0, 4, "corner", Content::Uniform, &[Fragment]);

// Group 1 of a scene's shader: files.
pub const SAMPLER: Binding = row(1, 0, "image_sampler", Content::Sampler, &[Fragment, Compute]);
/// The first image; the others follow: see [`Binding::image`].
pub const IMAGES: Binding = row(1, 1, "image", Content::Image, &[Fragment, Compute]);
pub const MODELS: Binding = row(1, 15, "models", Content::Words, &[Fragment, Compute]);

// Group 2 of a scene's shader: questions of the probe, and answers. Each entry point has two of its own.
pub const PROBE_POINTS: Binding = question("probe_points");
pub const PROBE_LOOKS: Binding = answer("probe_looks");
pub const PROBE_RAYS: Binding = question("probe_rays");
pub const PROBE_CROSSINGS: Binding = answer("probe_crossings");

// Passes over a finished picture.
pub const DISPLAY: Binding = row(0, 0, "display", Content::Uniform, &[Fragment]);
pub const OVER: Binding = row(0, 0, "over", Content::Uniform, &[Vertex, Fragment]);
pub const PICTURE: Binding = row(0, 1, "picture", Content::Texels, &[Fragment]);

/// All but the images after the first.
pub const ALL: [Binding; 16] = [
    FRAME,
    ACCUMULATED,
    SAMPLES,
    NUMBERS,
    ENDED_LOOP,
    CORNER,
    SAMPLER,
    IMAGES,
    MODELS,
    PROBE_POINTS,
    PROBE_LOOKS,
    PROBE_RAYS,
    PROBE_CROSSINGS,
    DISPLAY,
    OVER,
    PICTURE,
];

impl Binding {
    /// The image with this index among those in use.
    pub fn image(index: u32) -> Self {
        Self { number: IMAGES.number + index, ..IMAGES }
    }

    /// Its attributes in WGSL.
    pub fn attributes(self) -> String {
        format!("@group({}) @binding({})", self.group, self.number)
    }
}

const fn row(
    group: u32,
    number: u32,
    name: &'static str,
    content: Content,
    stages: &'static [Stage],
) -> Binding {
    Binding { group, number, name, content, stages }
}

const fn question(name: &'static str) -> Binding {
    row(2, 0, name, Content::Storage { is_writable: false }, &[Compute])
}

const fn answer(name: &'static str) -> Binding {
    row(2, 1, name, Content::Storage { is_writable: true }, &[Compute])
}
