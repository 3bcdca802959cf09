//! A sample drawn in slices, so that no submit keeps the GPU for long.

use std::ops::ControlFlow;
use std::time::{Duration, Instant};

use super::{Gpu, GpuError, Pace, Pipeline, Region, Tracer};
use crate::frame::Moment;
use crate::ir;

/// What is drawn, and by what.
#[derive(Clone, Copy)]
pub(super) struct Subject<'a> {
    pub gpu: &'a Gpu,
    pub pipeline: &'a Pipeline,
    pub render: &'a ir::Render,
    pub moment: &'a Moment,
}

/// A submit that keeps the GPU for longer than this is cut into shorter ones.
pub(super) const SLICE: Duration = Duration::from_millis(100);

/// Draws all of the next sample, and makes it count. `progress` gets the share done, 0 to 1, and returns
/// whether to go on; what is returned says the same.
///
/// # Errors
/// Where a loop of the author's had to be ended, or the device stops to answer.
pub(super) fn draw_sample(
    pace: &mut Pace,
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
        let region = Region::after(done, pace.pixels(), size);
        tracer.draw(pipeline, moment, render, jitter, &region);
        pipeline.finish(gpu)?;
        pace.learn(region.pixels(), begun.elapsed());
        done += region.pixels();
        if progress(done as f32 / all as f32).is_break() {
            return Ok(ControlFlow::Break(()));
        }
    }
    tracer.next();
    Ok(ControlFlow::Continue(()))
}

/// Pixels of [`Pipeline::small`].
pub const SMALL: [u32; 2] = [16, 16];

impl Pipeline {
    /// One sample of a picture in the size [`SMALL`], by which a driver is held to account: linear red,
    /// green, blue and depth of each pixel, by rows from the top.
    ///
    /// # Errors
    /// Where a loop of the author's had to be ended, or the device stops to answer.
    pub fn small(&self, gpu: &Gpu, render: &ir::Render, moment: &Moment) -> Result<Vec<[f32; 4]>, GpuError> {
        let mut tracer = Tracer::new(gpu, SMALL)?;
        let mut pace = Pace::new(SLICE, gpu.is_software());
        let subject = Subject { gpu, pipeline: self, render, moment };
        let mut goes_on = |_| ControlFlow::Continue(());
        let _ = draw_sample(&mut pace, &mut tracer, subject, [0.0; 2], &mut goes_on)?;
        let bytes = gpu.read_texture(tracer.picture(), 16)?;
        Ok(bytemuck::pod_collect_to_vec(&bytes))
    }
}
