//! What can go wrong on the GPU.

use crate::diagnostic::Report;

/// Why something on the GPU did not work.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum GpuError {
    /// There is no adapter of the wanted kind: what there is instead, or what to do about it.
    NoAdapter(String),
    /// The driver refused, or the scene needs more than it has.
    Refused(String),
    /// The device is gone or does not answer.
    Lost(String),
    /// raytoy itself is wrong: it has not guarded the loop of the author's at this place.
    Unguarded(String),
    /// A loop of the author's did not end by itself: which.
    Endless(Report),
}

impl std::fmt::Display for GpuError {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        match self {
            GpuError::NoAdapter(why) => f.write_str(why),
            GpuError::Refused(why) => write!(f, "the GPU's driver refuses: {why}"),
            GpuError::Lost(why) => write!(f, "the GPU does not respond: {why}"),
            GpuError::Unguarded(place) => write!(
                f,
                "internal error: the loop at {place} has no guard, and could keep the GPU for ever; \
                 please report this, with that file"
            ),
            GpuError::Endless(report) => write!(f, "{report}"),
        }
    }
}

impl std::error::Error for GpuError {}
