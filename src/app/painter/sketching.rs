//! What there is to see before a driver has compiled: a sketch.

use std::time::{Duration, Instant};

use super::{Painter, SAMPLES};
use crate::app::messages::Notice;
use crate::gpu::{Frame, GpuError, sample_offset};

/// What a pixel takes, before one has been drawn.
pub const FIRST_COST: Duration = Duration::from_micros(5);
/// A sketch is so coarse that it takes about this long.
const WANTED: Duration = Duration::from_millis(40);
/// Screen pixels to one of a sketch, at least and at most.
const COARSENESS: [f64; 2] = [4.0, 16.0];
/// One that would take longer is not worth its time.
const PATIENCE: Duration = Duration::from_millis(200);

impl Painter {
    /// Whether a sketch is all that there can be.
    pub(super) fn needs_sketch(&self) -> bool {
        let views = self.look.has_views();
        !self.is_sketched && self.scene.as_ref().is_some_and(|scene| scene.sketch_for(views).is_some())
    }

    pub(super) fn sketch(&mut self) -> Result<(), GpuError> {
        let Some(scene) = &self.scene else { return Ok(()) };
        let Some(sketch) = scene.sketch.clone() else { return Ok(()) };
        let compiled = scene.version.compiled.clone();
        self.time = if scene.moves { self.look.clock.time() } else { 0.0 };
        let [width, height] = self.look.size.map(f64::from);
        let cost = self.sketch_cost.as_secs_f64() * width * height / WANTED.as_secs_f64();
        self.coarseness = cost.sqrt().ceil().clamp(COARSENESS[0], COARSENESS[1]) as u32;
        self.is_sketched = true;
        let (size, render) = (self.picture_size(), &compiled.scene.render);
        let (moment, jitter) = (self.moment(&compiled), sample_offset(0, SAMPLES));
        let frame = Frame::new(&moment, render, compiled.scene.casters(), size, 0, jitter);
        let begun = Instant::now();
        let Some(pixels) = sketch.draw(&frame, PATIENCE) else {
            (self.notify)(Notice::Unsketched(compiled));
            return Ok(());
        };
        self.sketch_cost = begun.elapsed() / (size[0] * size[1]);
        self.stretch()?;
        self.tracer.as_mut().expect("it was just made").fill(&pixels);
        self.show(begun.elapsed())
    }
}
