//! Messages between the painter and the window.

use std::sync::Arc;
use std::time::{Duration, Instant};

use super::builder_messages::BuilderEvent;
use super::events::Change;
use super::thumbnails;
use crate::compile::Compiled;
use crate::diagnostic::Report;
use crate::frame::{Split, View};
use crate::gpu::{GpuError, Identity};
use crate::ir::Camera;
use crate::outline::Outline;

/// What the window wants to see.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ViewRequest {
    /// Where in the window the picture's top left is, pixels.
    pub corner: [u32; 2],
    /// Pixels.
    pub size: [u32; 2],
    /// None for the scene's own.
    pub camera: Option<Camera>,
    pub view: View,
    /// What lies over the right part of it.
    pub split: Option<Split>,
    /// The number at which the colors of [`View::Value`] end.
    pub reach: f32,
    /// Pixels from the top left.
    pub mouse: [f32; 2],
    pub clock: Clock,
    /// Whether lights, the camera's target and bounds are drawn over the picture.
    pub gizmos: bool,
    /// Whether the window wants to know what lies under each pixel.
    pub asks: bool,
}

impl ViewRequest {
    /// Whether any of it is a debug view.
    pub fn has_views(&self) -> bool {
        self.view != View::Color || self.split.is_some()
    }
}

/// The time that a scene shows which reads it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Clock {
    /// It stands at a time, seconds.
    Stopped(f32),
    /// It was this late at that moment, and goes on.
    Running { then: f32, at: Instant },
}

impl Clock {
    /// Seconds, now.
    pub fn time(self) -> f32 {
        match self {
            Clock::Stopped(time) => time,
            Clock::Running { then, at } => then + at.elapsed().as_secs_f32(),
        }
    }
}

/// Something for the painter to do.
pub enum PainterCommand {
    Built(BuilderEvent),
    View(ViewRequest),
    /// The last picture is on the screen.
    Shown,
}

/// Something for the window to show.
pub enum EngineEvent {
    Picture(Picture),
    /// What became of the frame that was sent to the screen.
    Frame {
        is_shown: bool,
    },
    /// A version of which there is no picture before its pipeline.
    Unsketched(Arc<Compiled>),
    /// What the files say is what is shown; with its warnings.
    Unchanged(Report),
    /// Numbers can be edited without another pipeline; how many were made so far.
    Ready {
        pipelines: u32,
    },
    /// The scene's file holds another text than before.
    File(Arc<str>),
    /// What the scene's text offers to change.
    Outline {
        outline: Box<Outline>,
        text: Arc<str>,
    },
    /// What lies under each pixel of the picture that was asked for last.
    Identity(Box<Identity>),
    /// What a gallery asked for.
    Gallery(thumbnails::ThumbnailEvent),
    /// A capture has come further.
    Captured,
    /// The scene is wrong; nothing else changes.
    Broken(Report),
    /// The scene is right, and these warnings are all that there is to say of it.
    Warned(Report),
    /// A version is about to be drawn for the first time.
    Tries(Arc<Compiled>),
    /// A device is gone, and all that stood on it.
    Lost(String),
    /// What a driving program asks for.
    Remote(Remote),
    /// Drawing is slow, and goes on; None where it is slow no more.
    Slow(Option<Slow>),
    /// The GPU failed.
    Failed(GpuError),
}

/// How far a picture is that takes long.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Slow {
    /// What one sample takes at the size of the picture.
    pub sample: Duration,
    /// The share of the sample being drawn that is there, 0 to 1.
    pub done: f32,
    /// Less than 1 where that sample is coarser than the screen.
    pub resolution: f32,
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
    /// Whether no GPU has drawn it.
    pub is_sketch: bool,
    /// Of one sample at the shown resolution.
    pub frame_time: Duration,
    /// Whether the scene reads the clock.
    pub moves: bool,
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

/// Something that a driving program can do and a hand cannot.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Remote {
    /// Ends the devices, as a driver does that gives up.
    LoseDevice,
}
