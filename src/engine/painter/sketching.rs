//! What there is to see before a driver has compiled: a sketch.

use std::time::{Duration, Instant};

use super::{Painter, SAMPLES};
use crate::engine::messages::EngineEvent;
use crate::frame::{FrameUniforms, sample_offset};
use crate::gpu::GpuError;

/// A sketch is so coarse that it takes about this long, between the finest that is worth it and one that is
/// still a picture. One of a slow scene gets more time before it gets coarser than that.
const WANTED: Duration = Duration::from_millis(40);
const FINE: f64 = 4.0;
const COARSE: f64 = 16.0;
const SLOW: Duration = Duration::from_millis(100);
const COARSEST: f64 = 32.0;
/// One that would take longer is not worth its time.
const PATIENCE: Duration = Duration::from_millis(200);

impl Painter {
    /// Whether a sketch is all that there can be.
    pub(super) fn needs_sketch(&self) -> bool {
        let views = self.look.has_views();
        !self.is_sketched && self.scene.as_ref().is_some_and(|scene| scene.sketch_for(views).is_some())
    }

    pub(super) fn sketch(&mut self) -> Result<(), GpuError> {
        self.is_sketched = true;
        let Some(scene) = &self.scene else { return Ok(()) };
        let Some(sketch) = scene.sketch.clone() else { return Ok(()) };
        let (compiled, mut cost) = (scene.version.compiled.clone(), scene.sketch_cost);
        self.time = if scene.moves { self.look.clock.time() } else { 0.0 };
        loop {
            self.coarseness = coarseness(self.look.size, cost);
            let (size, render) = (self.picture_size(), &compiled.scene.render);
            let (moment, jitter) = (self.moment(&compiled), sample_offset(0, SAMPLES));
            let frame = FrameUniforms::new(&moment, render, compiled.scene.casters(), size, 0, jitter);
            let begun = Instant::now();
            let drawn = sketch.draw(&frame, PATIENCE);
            let time = drawn.as_ref().map_or_else(|too_slow| too_slow.0, |_| begun.elapsed());
            cost = time / (size[0] * size[1]);
            if let Some(scene) = &mut self.scene {
                scene.sketch_cost = cost;
            }
            match drawn {
                Ok(pixels) => {
                    self.stretch()?;
                    self.tracer.as_mut().expect("it was just made").fill(&pixels);
                    return self.show(time);
                }
                // Now it is known what a pixel takes.
                Err(_) if coarseness(self.look.size, cost) > self.coarseness => {}
                Err(_) => {
                    (self.notify)(EngineEvent::Unsketched(compiled));
                    return Ok(());
                }
            }
        }
    }
}

/// Screen pixels to one of a sketch in which a pixel takes `cost`.
fn coarseness(size: [u32; 2], cost: Duration) -> u32 {
    let whole = cost.as_secs_f64() * f64::from(size[0]) * f64::from(size[1]);
    let within = |time: Duration| (whole / time.as_secs_f64()).sqrt().ceil();
    within(WANTED).clamp(FINE, COARSE).max(within(SLOW).min(COARSEST)) as u32
}
