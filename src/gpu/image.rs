//! Whole pictures without a window.

use std::ops::ControlFlow;
use std::time::{Duration, Instant};

use super::{Display, Gpu, GpuError, Moment, Pipeline, Target, Tracer, View, sample_offset};
use crate::{Compiled, ir};

/// A finished picture, by rows from the top.
#[derive(Clone, Debug, PartialEq)]
pub struct Picture {
    pub size: [u32; 2],
    /// Red, green, blue, opaque: as a screen shows it.
    pub rgba: Vec<u8>,
    /// Linear light before exposure, red, green, blue; with another view than the color its values.
    pub radiance: Vec<[f32; 3]>,
    /// Distance along the ray through the pixel's centre, scene units; infinite where it leaves the scene.
    pub depth: Vec<f32>,
    pub times: PictureTimes,
}

/// How long the stages of drawing took.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct PictureTimes {
    /// Zero where a picture before had the same pipeline.
    pub pipeline: Duration,
    /// The first sample, in which some drivers compile.
    pub first_frame: Duration,
    /// The mean of the other samples, or the first one drawn again.
    pub frame: Duration,
}

/// A submit that keeps the GPU for longer than this is cut into shorter ones.
const SLICE: Duration = Duration::from_millis(100);

/// Draws `samples` samples a pixel. `progress` is told the share done, 0 to 1.
///
/// # Errors
/// Where the driver refuses the scene or the size, or stops to answer.
pub fn render(
    gpu: &Gpu,
    compiled: &Compiled,
    moment: &Moment,
    size: [u32; 2],
    samples: u32,
    progress: &mut dyn FnMut(f32),
) -> Result<Picture, GpuError> {
    let mut tell = |share| {
        progress(share);
        ControlFlow::Continue(())
    };
    let picture = Renderer::new(gpu, compiled, size)?.draw(moment, samples, &mut tell)?;
    Ok(picture.expect("nobody stops it"))
}

/// Draws pictures of one scene in one size, with a pipeline that is built once.
#[derive(Debug)]
pub struct Renderer {
    gpu: Gpu,
    pipeline: Pipeline,
    tracer: Tracer,
    display: Display,
    canvas: wgpu::Texture,
    options: ir::Render,
    /// What the next picture tells of the pipeline.
    pipeline_time: Duration,
    rows_at_once: u32,
    /// Whether the first slice, in which a software driver compiles, has been drawn.
    is_warm: bool,
}

impl Renderer {
    /// # Errors
    /// Where the driver refuses the scene or the size.
    pub fn new(gpu: &Gpu, compiled: &Compiled, size: [u32; 2]) -> Result<Self, GpuError> {
        let start = Instant::now();
        let pipeline = Pipeline::build(gpu, compiled)?;
        let pipeline_time = start.elapsed();
        let tracer = Tracer::new(gpu, size)?;
        let format = wgpu::TextureFormat::Rgba8Unorm;
        let display = Display::new(gpu, format);
        let canvas = display.canvas(tracer.picture(), format);
        Ok(Self {
            gpu: gpu.clone(),
            pipeline,
            tracer,
            display,
            canvas,
            options: compiled.scene.render,
            pipeline_time,
            rows_at_once: (size[1] / 16).max(1),
            is_warm: false,
        })
    }

    /// Goes on with a scene that has the same text and other numbers.
    pub fn take(&mut self, compiled: &Compiled) {
        self.pipeline.upload(&self.gpu, &compiled.source.numbers);
        self.options = compiled.scene.render;
    }

    /// Draws `samples` samples a pixel. `progress` is told the share done, 0 to 1, some ten times a second,
    /// and says whether to go on; where it stops, there is no picture.
    ///
    /// # Errors
    /// Where the driver stops to answer.
    pub fn draw(
        &mut self,
        moment: &Moment,
        samples: u32,
        progress: &mut dyn FnMut(f32) -> ControlFlow<()>,
    ) -> Result<Option<Picture>, GpuError> {
        let mut times =
            PictureTimes { pipeline: std::mem::take(&mut self.pipeline_time), ..Default::default() };
        self.tracer.restart();
        let height = self.tracer.size()[1];
        let mut after_first = Duration::ZERO;
        for sample in 0..samples {
            let begun = Instant::now();
            let mut row = 0;
            while row < height {
                row = self.draw_slice(moment, sample_offset(sample, samples), row)?;
                if progress((sample as f32 + row as f32 / height as f32) / samples as f32).is_break() {
                    return Ok(None);
                }
            }
            self.tracer.next();
            if sample == 0 {
                times.first_frame = begun.elapsed();
            } else {
                after_first += begun.elapsed();
            }
        }
        times.frame = if samples > 1 { after_first / (samples - 1) } else { times.first_frame };
        self.read(moment.view, times).map(Some)
    }

    /// Draws some rows of a sample, from `row`; returns the row after them.
    fn draw_slice(&mut self, moment: &Moment, jitter: [f32; 2], row: u32) -> Result<u32, GpuError> {
        let begun = Instant::now();
        let end = (row + self.rows_at_once).min(self.tracer.size()[1]);
        self.tracer.draw(&self.pipeline, moment, &self.options, jitter, row..end);
        self.gpu.wait()?;
        if self.is_warm {
            self.rows_at_once = next_slice(end - row, begun.elapsed());
        }
        self.is_warm = true;
        Ok(end)
    }

    fn read(&self, view: View, times: PictureTimes) -> Result<Picture, GpuError> {
        let target = self.canvas.create_view(&Default::default());
        let whole = Target { corner: [0.0; 2], zoom: 1.0 };
        let light = (view == View::Color).then_some(&self.options);
        self.display.draw(self.tracer.picture(), light, &target, whole);
        let rgba = self.display.read(&self.canvas)?;
        let bytes = self.gpu.read_texture(self.tracer.picture(), 16)?;
        let texels: Vec<[f32; 4]> = bytemuck::pod_collect_to_vec(&bytes);
        Ok(Picture {
            size: self.tracer.size(),
            rgba,
            radiance: texels.iter().map(|t| [t[0], t[1], t[2]]).collect(),
            depth: texels.iter().map(|t| if t[3] < 0.0 { f32::INFINITY } else { t[3] }).collect(),
            times,
        })
    }
}

/// The rows that fit into [`SLICE`] where `rows` took `time`.
fn next_slice(rows: u32, time: Duration) -> u32 {
    let fitting = f64::from(rows) * SLICE.as_secs_f64() / time.as_secs_f64().max(1e-6);
    (fitting as u32).clamp(1, rows.saturating_mul(4))
}
