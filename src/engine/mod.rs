//! The threads that compile and draw while a scene is edited, and what they and the window send each other.
//!
//! In: commands. Out: events, with pictures. It knows neither windows nor widgets. Its threads
//! only ever send:
//!
//! ```text
//! watcher ─► builder (compile, make the pipeline) ─► painter (draw) ─► window (show, ask for another look)
//! ```

pub mod album;
pub mod builder;
pub mod builder_messages;
mod compositor;
pub mod crash_guard;
mod drawable;
pub mod events;
pub mod focus;
pub mod messages;
pub mod painter;
pub mod thumbnails;

pub use self::builder_messages::BuilderCommand;
pub use self::events::Change;
pub use self::focus::Focus;
pub use self::messages::{Clock, Picture, Slow, Texels, ViewRequest};
