//! A picture that takes long: it starts coarser, and the window shows how far it is.

use std::time::{Duration, Instant};

use super::Painter;
use crate::engine::messages::{EngineEvent, Slow};

/// A sample that takes longer is called slow.
const LONG: Duration = Duration::from_secs(60);
/// The first slices of a sample on a busy machine say little about the rest.
const EVIDENCE: Duration = Duration::from_secs(10);
/// The time from one word of it to the next.
const PAUSE: Duration = Duration::from_millis(500);
/// A first sample of which, after so long, still so much is left, gives way to one that is coarser, down to
/// the coarsest.
const TRIED: Duration = Duration::from_millis(500);
const LEFT: Duration = Duration::from_secs(2);
const COARSEST: u32 = 16;

impl Painter {
    /// Whether a coarser sample is to be drawn in place of this one, since the author has nothing to look at.
    pub(super) fn is_better_coarser(&self) -> bool {
        let [width, height] = self.picture_size();
        let may_be = self.is_first_pass && !self.is_moving() && self.coarseness < COARSEST;
        may_be && self.sample_started.elapsed() > TRIED && self.forecast.rest(width * height) > LEFT
    }

    /// Reports to the window that drawing is slow, how slow, and when it is slow no more.
    pub(super) fn tell_slowness(&mut self) {
        let slow = self.slowness();
        let is_other = slow.is_some() != self.slow.is_some();
        if is_other || (slow != self.slow && self.slow_told.elapsed() > PAUSE) {
            self.slow = slow;
            self.slow_told = Instant::now();
            (self.notify)(EngineEvent::Slow(slow));
        }
    }

    fn slowness(&self) -> Option<Slow> {
        let is_early = self.slow.is_none() && self.sample_started.elapsed() < EVIDENCE;
        if self.is_done() || is_early {
            return None;
        }
        let [width, height] = self.look.size;
        let known = self.forecast.of(width * height);
        // Between two samples nothing new is known.
        let sample = known.or(self.slow.map(|slow| slow.sample)).filter(|sample| *sample > LONG)?;
        let [wide, high] = self.picture_size();
        let done = f64::from(self.pixels_done) / f64::from((wide * high).max(1));
        Some(Slow { sample, done: done as f32, resolution: 1.0 / self.coarseness as f32 })
    }
}
