//! `raytoy render`: scenes to picture files.

use std::io::Cursor;
use std::path::{Path, PathBuf};
use std::time::{Duration, Instant};

use image::{ImageFormat, RgbaImage};
use indicatif::{ProgressBar, ProgressStyle};

use super::args::RenderOptions;
use super::stats::Stats;
use super::{Failure, Result, compiled, write_output};
use crate::Compiled;
use crate::gpu::{self, Gpu, Moment, Picture, View};
use crate::suite::is_settings;
use crate::wgsl::Mode;

pub fn run(options: &RenderOptions) -> Result {
    // A shell that is given `scenes/*.ron` finds the settings of their tests, too.
    let scenes: Vec<PathBuf> = options.scenes.iter().filter(|path| !is_settings(path)).cloned().collect();
    if scenes.is_empty() {
        let path = options.scenes[0].display();
        return Err(Failure::Call(format!("`{path}` holds the settings of a test; name the scene")));
    }
    let outputs = outputs(&scenes, &options.output)?;
    let gpu = Gpu::headless(&options.adapter)?;
    let mode = if options.live { Mode::Live } else { Mode::Baked };
    let mut wrong = false;
    let mut all = vec![];
    for (scene, output) in scenes.iter().zip(&outputs) {
        match compiled(scene, mode) {
            Ok(compiled) => all.push(draw(options, &gpu, &compiled, output)?),
            Err(Failure::Scene) => wrong = true,
            Err(other) => return Err(other),
        }
    }
    if let Some(path) = &options.stats {
        write_output(path, Stats::json(&all).as_bytes())?;
    }
    if wrong { Err(Failure::Scene) } else { Ok(()) }
}

/// Where the picture of each scene goes.
fn outputs(scenes: &[PathBuf], output: &Path) -> Result<Vec<PathBuf>> {
    let extension = output.extension().and_then(|e| e.to_str()).map(str::to_lowercase);
    let is_file = output == Path::new("-") || matches!(extension.as_deref(), Some("png" | "exr"));
    if is_file && scenes.len() == 1 {
        return Ok(vec![output.to_path_buf()]);
    }
    if is_file {
        return Err(Failure::Call("several scenes need a folder: `-o gallery/`".into()));
    }
    let names_folder =
        output.is_dir() || output.to_string_lossy().ends_with(['/', std::path::MAIN_SEPARATOR]);
    if !names_folder {
        let message = format!("cannot tell the format of `{}`: name a .png or .exr file", output.display());
        return Err(Failure::Call(message));
    }
    std::fs::create_dir_all(output)?;
    let file =
        |scene: &PathBuf| output.join(scene.file_stem().unwrap_or("picture".as_ref())).with_extension("png");
    Ok(scenes.iter().map(file).collect())
}

fn draw(options: &RenderOptions, gpu: &Gpu, compiled: &Compiled, output: &Path) -> Result<Stats> {
    let moment = Moment { view: options.view, time: options.time, ..Moment::of(&compiled.scene) };
    let picture = with_progress(&compiled.scene.name, |progress| {
        gpu::render(gpu, compiled, &moment, options.size, options.samples, progress)
    })?;
    let is_exr = output.extension().is_some_and(|e| e.eq_ignore_ascii_case("exr"));
    let bytes = if is_exr {
        let seen = Moment { view: View::Object, ..moment };
        let objects = gpu::render(gpu, compiled, &seen, options.size, 1, &mut |_| ())?;
        exr(&picture, &objects)?
    } else {
        encoded(&picture, ImageFormat::Png)?
    };
    write_output(output, &bytes)?;
    if output != Path::new("-") {
        eprintln!("{}: {}x{}", output.display(), picture.size[0], picture.size[1]);
    }
    Ok(Stats::new(gpu, compiled, &picture, options.samples))
}

/// Shows a bar on the terminal once the work takes longer than a person likes to wait.
pub fn with_progress<T>(name: &str, work: impl FnOnce(&mut dyn FnMut(f32)) -> T) -> T {
    let style =
        ProgressStyle::with_template("{msg} [{bar:40}] {percent}%, {eta} left").expect("a valid template");
    let bar = ProgressBar::hidden().with_style(style.progress_chars("=> ")).with_message(name.to_owned());
    bar.set_length(1000);
    let start = Instant::now();
    let done = work(&mut |share| {
        if start.elapsed() > Duration::from_millis(500) && bar.is_hidden() {
            bar.set_draw_target(indicatif::ProgressDrawTarget::stderr());
        }
        bar.set_position((share * 1000.0) as u64);
    });
    bar.finish_and_clear();
    done
}

/// The picture as a screen shows it, in a file's format.
pub fn encoded(picture: &Picture, format: ImageFormat) -> Result<Vec<u8>> {
    let [width, height] = picture.size;
    let image = RgbaImage::from_raw(width, height, picture.rgba.clone()).expect("four bytes a pixel");
    let mut bytes = Cursor::new(vec![]);
    image::DynamicImage::from(image).to_rgb8().write_to(&mut bytes, format)?;
    Ok(bytes.into_inner())
}

/// R, G and B are linear light before exposure; Z is the distance, infinite where the ray leaves the scene;
/// `object` is the index in the scene's list, -1 for none.
fn exr(picture: &Picture, objects: &Picture) -> Result<Vec<u8>> {
    use exr::prelude::*;
    let channel = |name: &str, values: Vec<f32>| AnyChannel::new(name, FlatSamples::F32(values));
    let light = |i: usize| picture.radiance.iter().map(|texel| texel[i]).collect();
    // In this view the place of the depth holds the index, and misses are infinite.
    let index = objects.depth.iter().map(|d| if d.is_finite() { *d } else { -1.0 }).collect();
    let channels = AnyChannels::sort(SmallVec::from_vec(vec![
        channel("R", light(0)),
        channel("G", light(1)),
        channel("B", light(2)),
        channel("Z", picture.depth.clone()),
        channel("object", index),
    ]));
    let [width, height] = picture.size.map(|n| n as usize);
    let image = Image::from_layer(Layer::new(
        (width, height),
        LayerAttributes::named("raytoy"),
        Encoding::FAST_LOSSLESS,
        channels,
    ));
    let mut bytes = Cursor::new(vec![]);
    image.write().non_parallel().to_buffered(&mut bytes)?;
    Ok(bytes.into_inner())
}
