//! A whole picture without a window.

use std::time::{Duration, Instant};

use super::{Display, Gpu, GpuError, Moment, Pipeline, Target, Tracer, View, sample_offset};
use crate::Compiled;

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
    let start = Instant::now();
    let pipeline = Pipeline::build(gpu, compiled)?;
    let built = start.elapsed();
    let mut picture = draw(gpu, &pipeline, compiled, moment, size, samples, progress)?;
    picture.times.pipeline = built;
    Ok(picture)
}

/// The same as [`render`] with a pipeline that is there already: that of `compiled`, or of a scene with the
/// same text and other numbers.
///
/// # Errors
/// Where the driver refuses the size, or stops to answer.
pub fn draw(
    gpu: &Gpu,
    pipeline: &Pipeline,
    compiled: &Compiled,
    moment: &Moment,
    size: [u32; 2],
    samples: u32,
    progress: &mut dyn FnMut(f32),
) -> Result<Picture, GpuError> {
    let mut times = PictureTimes::default();
    let mut tracer = Tracer::new(gpu, size)?;
    let render = &compiled.scene.render;
    // The first slice is small: on a software driver it also compiles.
    let mut rows_at_once = (size[1] / 16).max(1);
    let mut after_first = Duration::ZERO;
    for sample in 0..samples {
        let begun = Instant::now();
        let mut row = 0;
        while row < size[1] {
            let slice = Instant::now();
            let end = (row + rows_at_once).min(size[1]);
            tracer.draw(pipeline, moment, render, sample_offset(sample, samples), row..end);
            gpu.wait()?;
            if sample > 0 || row > 0 {
                rows_at_once = next_slice(end - row, slice.elapsed());
            }
            row = end;
            progress((sample as f32 + row as f32 / size[1] as f32) / samples as f32);
        }
        tracer.next();
        if sample == 0 {
            times.first_frame = begun.elapsed();
        } else {
            after_first += begun.elapsed();
        }
    }
    times.frame = if samples > 1 { after_first / (samples - 1) } else { times.first_frame };
    finish(gpu, &tracer, compiled, moment.view, times)
}

/// The rows that fit into [`SLICE`] where `rows` took `time`.
fn next_slice(rows: u32, time: Duration) -> u32 {
    let fitting = f64::from(rows) * SLICE.as_secs_f64() / time.as_secs_f64().max(1e-6);
    (fitting as u32).clamp(1, rows.saturating_mul(4))
}

fn finish(
    gpu: &Gpu,
    tracer: &Tracer,
    compiled: &Compiled,
    view: View,
    times: PictureTimes,
) -> Result<Picture, GpuError> {
    let format = wgpu::TextureFormat::Rgba8Unorm;
    let display = Display::new(gpu, format);
    let canvas = display.canvas(tracer.picture(), format);
    let target = canvas.create_view(&Default::default());
    let whole = Target { corner: [0.0; 2], zoom: 1.0 };
    let light = (view == View::Color).then_some(&compiled.scene.render);
    display.draw(tracer.picture(), light, &target, whole);
    let rgba = display.read(&canvas)?;
    let bytes = gpu.read_texture(tracer.picture(), 16)?;
    let texels: Vec<[f32; 4]> = bytemuck::pod_collect_to_vec(&bytes);
    Ok(Picture {
        size: tracer.size(),
        rgba,
        radiance: texels.iter().map(|t| [t[0], t[1], t[2]]).collect(),
        depth: texels.iter().map(|t| if t[3] < 0.0 { f32::INFINITY } else { t[3] }).collect(),
        times,
    })
}
