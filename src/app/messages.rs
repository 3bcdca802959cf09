//! What the painter and the window tell each other.

use std::sync::Arc;
use std::time::{Duration, Instant};

use super::builder::Built;
use super::events::Change;
use crate::Compiled;
use crate::diagnostic::Report;
use crate::gpu::{GpuError, View};
use crate::ir::Camera;

/// What the window wants to see.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Look {
    /// Pixels.
    pub size: [u32; 2],
    /// None for the scene's own.
    pub camera: Option<Camera>,
    pub view: View,
    /// Pixels from the top left.
    pub mouse: [f32; 2],
}

/// Something for the painter to do.
pub enum Wish {
    Built(Built),
    Look(Look),
    /// The last picture is on the screen.
    Shown,
}

/// Something for the window to show.
pub enum Notice {
    Picture(Picture),
    /// What the files say is what is shown; with its warnings.
    Unchanged(Report),
    /// Numbers can be edited without another pipeline; how many were made so far.
    Ready {
        pipelines: u32,
    },
    /// The scene is wrong; nothing else changes.
    Broken(Report),
    /// The GPU failed.
    Failed(GpuError),
}

/// A picture and where it came from.
pub struct Picture {
    pub texels: Texels,
    pub edit: u64,
    pub change: Change,
    pub samples: u32,
    pub resolution: f32,
    pub pipelines: u32,
    pub noticed: Instant,
    pub pipeline_time: Duration,
    /// Of one sample at the shown resolution.
    pub frame_time: Duration,
    pub compiled: Arc<Compiled>,
    pub warnings: Report,
}

/// How the picture gets to the window.
pub enum Texels {
    /// On the window's own device.
    Shared(wgpu::Texture),
    /// From a device of its own: a software driver compiles while it draws, and would stop the window.
    Bytes { size: [u32; 2], rgba: Vec<u8> },
}

/// Of the pictures that go to the window.
pub const FORMAT: wgpu::TextureFormat = wgpu::TextureFormat::Rgba8Unorm;
