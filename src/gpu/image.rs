//! Whole pictures without a window.

use std::ops::ControlFlow;
use std::time::{Duration, Instant};

use super::slices::{SLICE, Subject, draw_sample};
use super::{Display, Gpu, GpuError, Identity, Light, Moment, Pace, Pipeline, Target, Tracer, sample_offset};
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
    pace: Pace,
    display: Display,
    canvas: wgpu::Texture,
    options: ir::Render,
    /// What the next picture tells of the pipeline.
    pipeline_time: Duration,
}

impl Renderer {
    /// # Errors
    /// Where the driver refuses the scene or the size.
    pub fn new(gpu: &Gpu, compiled: &Compiled, size: [u32; 2]) -> Result<Self, GpuError> {
        let start = Instant::now();
        let pipeline = Pipeline::build(gpu, compiled)?;
        let pipeline_time = start.elapsed();
        let tracer = Tracer::new(gpu, size)?;
        let pace = Pace::new(SLICE, gpu.is_software());
        let format = wgpu::TextureFormat::Rgba8Unorm;
        let display = Display::new(gpu, format);
        let canvas = display.canvas(tracer.picture(), format);
        let (gpu, options) = (gpu.clone(), compiled.scene.render);
        Ok(Self { gpu, pipeline, tracer, pace, display, canvas, options, pipeline_time })
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
    /// Where a loop of the author's had to be ended, or the driver stops to answer.
    pub fn draw(
        &mut self,
        moment: &Moment,
        samples: u32,
        progress: &mut dyn FnMut(f32) -> ControlFlow<()>,
    ) -> Result<Option<Picture>, GpuError> {
        let mut times =
            PictureTimes { pipeline: std::mem::take(&mut self.pipeline_time), ..Default::default() };
        self.tracer.restart();
        let mut after_first = Duration::ZERO;
        for sample in 0..samples {
            let begun = Instant::now();
            let subject = Subject { gpu: &self.gpu, pipeline: &self.pipeline, render: &self.options, moment };
            let mut tell = |share| progress((sample as f32 + share) / samples as f32);
            let jitter = sample_offset(sample, samples);
            if draw_sample(&mut self.pace, &mut self.tracer, subject, jitter, &mut tell)?.is_break() {
                return Ok(None);
            }
            if sample == 0 {
                times.first_frame = begun.elapsed();
            } else {
                after_first += begun.elapsed();
            }
        }
        times.frame = if samples > 1 { after_first / (samples - 1) } else { times.first_frame };
        self.read(moment, times).map(Some)
    }

    /// What lies under each pixel of such a picture.
    ///
    /// # Errors
    /// Where the driver stops to answer.
    pub fn identity(&self, moment: &Moment) -> Result<Identity, GpuError> {
        Identity::draw(&self.gpu, &self.pipeline, moment, &self.options, self.tracer.size())
    }

    /// Light and depth of each pixel of one sample in another size, by rows from the top.
    ///
    /// # Errors
    /// Where the driver stops to answer.
    pub fn sample(&self, moment: &Moment, size: [u32; 2]) -> Result<Vec<[f32; 4]>, GpuError> {
        let mut tracer = Tracer::new(&self.gpu, size)?;
        let mut pace = Pace::new(SLICE, self.gpu.is_software());
        let subject = Subject { gpu: &self.gpu, pipeline: &self.pipeline, render: &self.options, moment };
        let mut goes_on = |_| ControlFlow::Continue(());
        let _ = draw_sample(&mut pace, &mut tracer, subject, [0.0; 2], &mut goes_on)?;
        let bytes = self.gpu.read_texture(tracer.picture(), 16)?;
        Ok(bytemuck::pod_collect_to_vec(&bytes))
    }

    fn read(&self, moment: &Moment, times: PictureTimes) -> Result<Picture, GpuError> {
        let target = self.canvas.create_view(&Default::default());
        let whole = Target { corner: [0.0; 2], zoom: 1.0 };
        let columns = moment.view.columns_of_light(moment.split, self.tracer.size()[0]);
        let light = Light { render: &self.options, columns };
        self.display.draw(self.tracer.picture(), Some(light), &target, whole);
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
