//! A sample drawn in slices, so that no submit keeps the GPU for long.

use std::ops::ControlFlow;
use std::time::{Duration, Instant};

use super::{Gpu, GpuError, Moment, Pipeline, Region, Tracer};
use crate::ir;

/// How many pixels go at once, learned from those before.
#[derive(Debug)]
pub(super) struct Slices {
    pixels: u32,
    is_first: bool,
}

/// What is drawn, and by what.
#[derive(Clone, Copy)]
pub(super) struct Subject<'a> {
    pub gpu: &'a Gpu,
    pub pipeline: &'a Pipeline,
    pub render: &'a ir::Render,
    pub moment: &'a Moment,
}

/// A submit that keeps the GPU for longer than this is cut into shorter ones.
const SLICE: Duration = Duration::from_millis(100);

/// The first slice is small: nobody knows what a pixel costs, and on a software driver it also compiles.
const FIRST: u32 = 512;

impl Slices {
    pub fn new() -> Self {
        Self { pixels: FIRST, is_first: true }
    }

    /// Draws all of the next sample, and makes it count. `progress` is told the share done, 0 to 1, and
    /// says whether to go on; what is returned says the same.
    ///
    /// # Errors
    /// Where a loop of the author's had to be ended, or the device stops to answer.
    pub fn draw(
        &mut self,
        tracer: &mut Tracer,
        subject: Subject<'_>,
        jitter: [f32; 2],
        progress: &mut dyn FnMut(f32) -> ControlFlow<()>,
    ) -> Result<ControlFlow<()>, GpuError> {
        let Subject { gpu, pipeline, render, moment } = subject;
        let size = tracer.size();
        let all = size[0] * size[1];
        let mut done = 0;
        while done < all {
            let begun = Instant::now();
            let region = Region::after(done, self.pixels, size);
            tracer.draw(pipeline, moment, render, jitter, &region);
            pipeline.finish(gpu)?;
            if !self.is_first {
                self.pixels = next_slice(region.pixels(), begun.elapsed());
            }
            self.is_first = false;
            done += region.pixels();
            if progress(done as f32 / all as f32).is_break() {
                return Ok(ControlFlow::Break(()));
            }
        }
        tracer.next();
        Ok(ControlFlow::Continue(()))
    }
}

/// The pixels that fit into [`SLICE`] where `pixels` took `time`.
fn next_slice(pixels: u32, time: Duration) -> u32 {
    let fitting = f64::from(pixels) * SLICE.as_secs_f64() / time.as_secs_f64().max(1e-6);
    (fitting as u32).clamp(1, pixels.saturating_mul(4).max(FIRST))
}
