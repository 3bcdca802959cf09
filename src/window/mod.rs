//! The window: a scene that shows each save at once, and keeps its last good picture.
//!
//! In: a scene's path. Out: a window, until it is closed. Three threads stand behind it, and only ever send:
//!
//! ```text
//! watcher ─► builder (compile, make the pipeline) ─► painter (draw) ─► window (show, ask for another look)
//! ```

mod app;
mod backend;
mod open;
mod presenter;
mod screen;

use std::path::PathBuf;
use std::sync::mpsc::Receiver;
use std::sync::{Arc, Mutex};

pub use crate::engine::events::Event;
pub use crate::engine::messages::Remote;
use crate::gpu::AdapterChoice;
use crate::sources::Disk;

/// What to open.
#[derive(Clone, Debug)]
pub struct Options {
    pub scene: PathBuf,
    /// Where scenes lie.
    pub disk: Disk,
    /// Of the window's inside, in points; None for what it was last.
    pub size: Option<[u32; 2]>,
    pub adapter: AdapterChoice,
    /// What a program that drives the window asks for.
    pub remote: Option<Arc<Mutex<Receiver<Remote>>>>,
    /// The folder in which the window's [`crate::panel::Settings`] are kept, if they are.
    pub memory: Option<PathBuf>,
    /// The folder for pictures that can be drawn again, if they are kept.
    pub cache: Option<PathBuf>,
}

/// Opens a window and returns when it is closed. `on_event` gets all events.
///
/// # Errors
/// If there is no display or no GPU: a message for the user.
pub fn run(options: Options, on_event: &dyn Fn(&Event)) -> Result<(), String> {
    app::run(options, on_event)
}
