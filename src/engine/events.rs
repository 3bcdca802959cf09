//! What happens in the window, for programs that drive it.

use serde::Serialize;

/// One thing that happened. Counts go on from the window's start.
#[derive(Clone, Debug, Serialize)]
#[serde(tag = "event", rename_all = "snake_case")]
pub enum Event {
    /// The window is there.
    Opened { adapter: String },
    /// The device was lost, and this one took its place.
    Restarted { adapter: String, why: String },
    /// A version of the scene is drawn for the first time.
    Begun,
    /// From now on numbers can be edited without another pipeline.
    Ready { pipelines: u32 },
    /// A click has chosen an object, or nothing.
    Chosen { object: Option<String> },
    /// The files have changed, and what is shown is still right.
    Unchanged,
    /// The scene has mistakes; the last good picture stays.
    Broken { errors: usize, text: String },
    /// The scene is right, but there is something new to say of its picture.
    Warned { text: String },
    /// One sample of the picture takes this long; it is drawn all the same.
    Slow { seconds: f64 },
    /// A picture is on the screen.
    Presented {
        /// How many versions of the scene's files were shown before.
        edit: u64,
        /// What the edit changed.
        change: Change,
        /// Samples that each pixel holds.
        samples: u32,
        /// Less than 1 while the picture is coarser than the screen.
        resolution: f32,
        /// Scene pipelines made so far.
        pipelines: u32,
        /// Milliseconds from when the change was noticed to now.
        since_change_ms: f64,
        /// The longest time that the window's thread took for one event since the last picture, milliseconds.
        blocked_ms: f64,
    },
}

/// The three kinds of edit.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
#[serde(rename_all = "snake_case")]
pub enum Change {
    /// Comments and blanks: nothing is drawn again.
    Cosmetic,
    /// Numbers: one upload.
    Numbers,
    /// Another shader.
    Structure,
}
