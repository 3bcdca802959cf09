//! Whole pictures without a window.

use std::ops::ControlFlow;
use std::time::{Duration, Instant};

use super::parts::{Parts, lay};
use super::slices::{SLICE, Subject, draw_sample};
use super::{Display, Gpu, GpuError, Identity, LitColumns, Pace, Pipeline, Region, Target, Tracer};
use crate::compile::Compiled;
use crate::frame::{Moment, sample_offset};
use crate::ir;

/// The most pixels in a row or a column of a picture.
pub const MAX_SIDE: u32 = 65_536;

/// What the canvas of a picture is made of.
const CANVAS: wgpu::TextureFormat = wgpu::TextureFormat::Rgba8Unorm;

/// A finished picture or a part of one, by rows from the top.
#[derive(Clone, Debug, Default, PartialEq)]
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

/// Draws `samples` samples a pixel. `progress` gets the share done, 0 to 1.
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

/// Draws pictures of one scene in one size, with a pipeline that is built once. Large ones are drawn in
/// parts, so that they need no more of the GPU's memory than small ones.
#[derive(Debug)]
pub struct Renderer {
    gpu: Gpu,
    pipeline: Pipeline,
    size: [u32; 2],
    parts: Parts,
    /// What the last part was drawn on, and shown on: the next has the same size but at the edges.
    easel: Option<(Tracer, wgpu::Texture)>,
    pace: Pace,
    display: Display,
    options: ir::Render,
    /// The time that the next picture reports for the pipeline.
    pipeline_time: Duration,
}

impl Renderer {
    /// # Errors
    /// Where the driver refuses the scene, or no picture has this size.
    pub fn new(gpu: &Gpu, compiled: &Compiled, size: [u32; 2]) -> Result<Self, GpuError> {
        if size.iter().any(|n| !(1..=MAX_SIDE).contains(n)) {
            let why =
                format!("pictures are from 1x1 to {MAX_SIDE}x{MAX_SIDE} pixels, not {}x{}", size[0], size[1]);
            return Err(GpuError::Refused(why));
        }
        let start = Instant::now();
        let pipeline = Pipeline::build(gpu, compiled)?;
        Ok(Self {
            gpu: gpu.clone(),
            pipeline,
            size,
            parts: Parts::of(gpu),
            easel: None,
            pace: Pace::new(SLICE, gpu.is_software()),
            display: Display::new(gpu, CANVAS),
            options: compiled.scene.render,
            pipeline_time: start.elapsed(),
        })
    }

    /// The same, with parts of at most so many pixels, and so many in a row or a column.
    pub fn in_parts_of(self, pixels: u32, side: u32) -> Self {
        Self { parts: Parts { pixels, side }, ..self }
    }

    /// Goes on with a scene that has the same text and other numbers.
    pub fn take(&mut self, compiled: &Compiled) {
        self.pipeline.upload(&self.gpu, &compiled.source.numbers);
        self.options = compiled.scene.render;
    }

    /// Draws `samples` samples a pixel. `progress` gets the share done, 0 to 1, some ten times a second,
    /// and returns whether to go on; if it stops, there is no picture.
    ///
    /// # Errors
    /// Where a loop of the author's had to be ended, or the driver has no memory or stops to answer.
    pub fn draw(
        &mut self,
        moment: &Moment,
        samples: u32,
        progress: &mut dyn FnMut(f32) -> ControlFlow<()>,
    ) -> Result<Option<Picture>, GpuError> {
        let mut whole = Picture { size: self.size, ..Picture::default() };
        let times = self.draw_strips(moment, samples, progress, &mut |strip| {
            whole.rgba.extend(strip.rgba);
            whole.radiance.extend(strip.radiance);
            whole.depth.extend(strip.depth);
            ControlFlow::Continue(())
        })?;
        Ok(times.map(|times| Picture { times, ..whole }))
    }

    /// The same, a strip after the other from the top, for pictures that memory should not hold: `take` gets
    /// each, as wide as the picture, and says whether to go on, too.
    ///
    /// # Errors
    /// As with [`Renderer::draw`].
    pub fn draw_strips(
        &mut self,
        moment: &Moment,
        samples: u32,
        progress: &mut dyn FnMut(f32) -> ControlFlow<()>,
        take: &mut dyn FnMut(Picture) -> ControlFlow<()>,
    ) -> Result<Option<PictureTimes>, GpuError> {
        let mut times =
            PictureTimes { pipeline: std::mem::take(&mut self.pipeline_time), ..Default::default() };
        let all = self.size[0] as f32 * self.size[1] as f32;
        let mut done = 0.0;
        for regions in self.parts.strips(self.size) {
            let mut strip = Picture::blank([self.size[0], regions[0].rows.len() as u32]);
            for region in regions {
                let share = region.pixels() as f32 / all;
                let mut tell = |part| progress(done + share * part);
                if self.draw_part(&region, moment, samples, &mut times, &mut tell)?.is_break() {
                    return Ok(None);
                }
                self.read(&region, moment, &mut strip)?;
                done += share;
            }
            if take(strip).is_break() {
                return Ok(None);
            }
        }
        times.frame = if samples > 1 { times.frame / (samples - 1) } else { times.first_frame };
        Ok(Some(times))
    }

    /// What lies under each pixel of such a picture.
    ///
    /// # Errors
    /// Where the driver stops to answer.
    pub fn identity(&self, moment: &Moment) -> Result<Identity, GpuError> {
        Identity::draw(&self.gpu, &self.pipeline, moment, &self.options, self.size)
    }

    /// A few pixels of a picture, as [`Pipeline::small`] draws them.
    ///
    /// # Errors
    /// As with [`Renderer::draw`].
    pub fn small(&self, moment: &Moment) -> Result<Vec<[f32; 4]>, GpuError> {
        self.pipeline.small(&self.gpu, &self.options, moment)
    }

    /// Draws all samples of a part; `times` gets what they took.
    fn draw_part(
        &mut self,
        region: &Region,
        moment: &Moment,
        samples: u32,
        times: &mut PictureTimes,
        progress: &mut dyn FnMut(f32) -> ControlFlow<()>,
    ) -> Result<ControlFlow<()>, GpuError> {
        let (mut tracer, canvas) = match self.easel.take() {
            Some(easel) if easel.0.size() == region.size() => easel,
            _ => {
                let tracer = Tracer::new(&self.gpu, region.size())?;
                let canvas = self.display.canvas(tracer.picture(), CANVAS);
                (tracer, canvas)
            }
        };
        tracer.aim(self.size, region.corner());
        for sample in 0..samples {
            let begun = Instant::now();
            let subject = Subject { gpu: &self.gpu, pipeline: &self.pipeline, render: &self.options, moment };
            let mut tell = |share| progress((sample as f32 + share) / samples as f32);
            let jitter = sample_offset(sample, samples);
            if draw_sample(&mut self.pace, &mut tracer, subject, jitter, &mut tell)?.is_break() {
                return Ok(ControlFlow::Break(()));
            }
            let time = if sample == 0 { &mut times.first_frame } else { &mut times.frame };
            *time += begun.elapsed();
        }
        self.easel = Some((tracer, canvas));
        Ok(ControlFlow::Continue(()))
    }

    /// Lays the part that was drawn into its strip.
    fn read(&self, region: &Region, moment: &Moment, strip: &mut Picture) -> Result<(), GpuError> {
        let (tracer, canvas) = self.easel.as_ref().expect("it was just drawn on");
        let target = canvas.create_view(&Default::default());
        let place = Target { corner: [0.0; 2], zoom: 1.0 };
        let light = moment.view.columns_of_light(moment.split, self.size[0]);
        let [left, right] = [light.start, light.end]
            .map(|column| column.clamp(region.columns.start, region.columns.end) - region.columns.start);
        let light = LitColumns { render: &self.options, columns: left..right };
        self.display.draw(tracer.picture(), Some(light), &target, place);
        let width = self.size[0];
        let rgba: Vec<[u8; 4]> = bytemuck::pod_collect_to_vec(&self.display.read(canvas)?);
        lay(bytemuck::cast_slice_mut(&mut strip.rgba), width, region, &rgba);
        let texels: Vec<[f32; 4]> =
            bytemuck::pod_collect_to_vec(&self.gpu.read_texture(tracer.picture(), 16)?);
        let light: Vec<[f32; 3]> = texels.iter().map(|t| [t[0], t[1], t[2]]).collect();
        lay(&mut strip.radiance, width, region, &light);
        let depth: Vec<f32> = texels.iter().map(|t| if t[3] < 0.0 { f32::INFINITY } else { t[3] }).collect();
        lay(&mut strip.depth, width, region, &depth);
        Ok(())
    }
}

impl Picture {
    fn blank(size: [u32; 2]) -> Self {
        let pixels = size[0] as usize * size[1] as usize;
        Self {
            size,
            rgba: vec![0; 4 * pixels],
            radiance: vec![[0.0; 3]; pixels],
            depth: vec![0.0; pixels],
            times: PictureTimes::default(),
        }
    }
}
