//! A sample drawn in slices of rows, so that no submit keeps the GPU for long.

use std::ops::ControlFlow;
use std::time::{Duration, Instant};

use super::{Gpu, GpuError, Moment, Pipeline, Tracer};
use crate::ir;

/// How many rows go at once, learned from those before.
#[derive(Debug)]
pub(super) struct Slices {
    rows: u32,
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

impl Slices {
    /// For pictures that are `height` rows high.
    pub fn new(height: u32) -> Self {
        // The first slice is small: on a software driver it also compiles.
        Self { rows: (height / 16).max(1), is_first: true }
    }

    /// Draws all rows of the next sample, and makes it count. `progress` is told the share done, 0 to 1, and
    /// says whether to go on; what is returned says the same.
    ///
    /// # Errors
    /// Where the device stops to answer.
    pub fn draw(
        &mut self,
        tracer: &mut Tracer,
        subject: Subject<'_>,
        jitter: [f32; 2],
        progress: &mut dyn FnMut(f32) -> ControlFlow<()>,
    ) -> Result<ControlFlow<()>, GpuError> {
        let Subject { gpu, pipeline, render, moment } = subject;
        let height = tracer.size()[1];
        let mut row = 0;
        while row < height {
            let begun = Instant::now();
            let end = (row + self.rows).min(height);
            tracer.draw(pipeline, moment, render, jitter, row..end);
            gpu.wait()?;
            if !self.is_first {
                self.rows = next_slice(end - row, begun.elapsed());
            }
            self.is_first = false;
            row = end;
            if progress(row as f32 / height as f32).is_break() {
                return Ok(ControlFlow::Break(()));
            }
        }
        tracer.next();
        Ok(ControlFlow::Continue(()))
    }
}

/// The rows that fit into [`SLICE`] where `rows` took `time`.
fn next_slice(rows: u32, time: Duration) -> u32 {
    let fitting = f64::from(rows) * SLICE.as_secs_f64() / time.as_secs_f64().max(1e-6);
    (fitting as u32).clamp(1, rows.saturating_mul(4))
}
