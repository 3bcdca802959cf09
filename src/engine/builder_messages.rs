//! What the builder is asked for, and what it answers.

use std::path::PathBuf;
use std::sync::Arc;
use std::time::{Duration, Instant};

use super::events::Change;
use super::focus::Focus;
use crate::compile::Compiled;
use crate::diagnostic::Report;
use crate::gpu::Pipeline;
use crate::outline::Outline;
use crate::sketch::Sketch;

/// What to build.
pub enum BuilderCommand {
    /// Another scene.
    Open(PathBuf),
    /// The same, whose files have changed.
    Changed,
    /// The same, with this text instead of what the scene's file holds; None for the file's again.
    Edited(Option<Arc<str>>),
    /// The same, of which only this is to be seen.
    Focus(Focus),
    /// The same, with the number of this name for the debug view `value`; None for none.
    Measure(Option<String>),
    /// Whether a debug view is looked at.
    Views(bool),
    /// This version is on the screen, or there is nothing to be shown of it yet: there is time for its next
    /// pipeline.
    Shown(Arc<Compiled>),
    /// No more.
    End,
}

/// What came of it.
pub enum BuilderEvent {
    /// Nothing yet: the files have changed, and a verdict follows.
    Begun,
    /// The scene's file holds another text than before.
    File(Arc<str>),
    /// What the scene's text, as it was shown or found wrong, offers to change.
    Outline {
        outline: Box<Outline>,
        text: Arc<str>,
    },
    Scene(Box<Version>),
    /// The baked pipeline of the last [`Change::Structure`], which came with a sketch; how long it took.
    Baked(Pipeline, Duration),
    /// The driver does not take the last [`Change::Structure`].
    Refused(Report),
    /// The pipeline of the last [`Change::Structure`] with all debug views, and with live numbers unless the
    /// GPU takes fewer.
    Full(Pipeline),
    Broken(Report),
}

/// A version of the scene that can be drawn.
pub struct Version {
    pub compiled: Arc<Compiled>,
    pub change: Change,
    /// What to show of a [`Change::Structure`] until there is a pipeline.
    pub sketch: Option<Sketch>,
    /// The baked pipeline of a [`Change::Structure`] that has no sketch; others keep the full one.
    pub baked: Option<Pipeline>,
    pub pipeline_time: Duration,
    /// Whether it is on the screen, since a device that is lost has drawn it.
    pub is_on_screen: bool,
    pub warnings: Report,
    /// When the change was noticed.
    pub noticed: Instant,
}
