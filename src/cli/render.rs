//! `raytoy render`: scenes to picture files.

use std::path::{Path, PathBuf};

use super::args::RenderOptions;
use super::progress::with_progress;
use super::shot::{compiled, shot, shows_numbers, warn_of_driver};
use super::stats::Stats;
use super::{Failure, Result, frames, print_report, write_output};
use crate::capture::{self, CaptureError, Format, MovieFormat, Shot};
use crate::files::write_file_with;
use crate::gpu::Gpu;
use crate::suite::is_settings;

pub fn run(options: &RenderOptions) -> Result {
    if let Some(name) = options.value.as_ref().filter(|_| !shows_numbers(options)) {
        let why = format!("`--value {name}` needs the view of numbers: add `--view value`");
        return Err(Failure::Call(why));
    }
    if let Some(numbers) = &options.frames {
        return frames::run(options, numbers.clone());
    }
    // A shell that is given `scenes/*.ron` finds the settings of their tests, too.
    let scenes: Vec<PathBuf> = options.scenes.iter().filter(|path| !is_settings(path)).cloned().collect();
    if scenes.is_empty() {
        let path = options.scenes[0].display();
        return Err(Failure::Call(format!("`{path}` contains the settings of a test; name the scene")));
    }
    let outputs = outputs(&scenes, &options.output)?;
    let gpu = Gpu::headless(&options.adapter)?;
    let mut wrong = false;
    let mut all = vec![];
    for (scene, output) in scenes.iter().zip(&outputs) {
        let drawn =
            compiled(options, scene).and_then(|compiled| draw(&shot(options, &gpu, &compiled), output));
        match drawn {
            Ok(stats) => all.push(stats),
            Err(Failure::Scene) => wrong = true,
            Err(Failure::Endless(report)) => {
                print_report(&report);
                wrong = true;
            }
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
    let is_file = output == Path::new("-") || Format::of(output).is_some();
    if is_file && scenes.len() == 1 {
        return Ok(vec![output.to_path_buf()]);
    }
    if is_file {
        return Err(Failure::Call("several scenes need a folder: `-o gallery/`".into()));
    }
    if MovieFormat::of(output).is_some() {
        let message =
            format!("`{}` is a movie: add the frames to draw, as in `--frames 0..120`", output.display());
        return Err(Failure::Call(message));
    }
    let names_folder =
        output.is_dir() || output.to_string_lossy().ends_with(['/', std::path::MAIN_SEPARATOR]);
    if !names_folder {
        let message = format!("the format of `{}` is unknown: name a .png or .exr file", output.display());
        return Err(Failure::Call(message));
    }
    std::fs::create_dir_all(output)?;
    let file =
        |scene: &PathBuf| output.join(scene.file_stem().unwrap_or("picture".as_ref())).with_extension("png");
    Ok(scenes.iter().map(file).collect())
}

fn draw(shot: &Shot<'_>, output: &Path) -> Result<Stats> {
    let format = Format::of(output).unwrap_or(Format::Png);
    let name = &shot.compiled.scene.name;
    let unwritten = |error| Failure::Call(format!("cannot write `{}`: {error}", output.display()));
    let drawn = with_progress(name, |progress| {
        if output == Path::new("-") {
            let still = capture::still(shot, format, progress)?;
            return write_output(output, &still.bytes).map(|()| still);
        }
        let written = write_file_with(output, |out| capture::still_to(out, shot, format, progress));
        written.map_err(unwritten)?.map_err(|error| match error {
            CaptureError::Output(error) => unwritten(error),
            error => error.into(),
        })
    })?;
    if output != Path::new("-") {
        eprintln!("{}: {}x{}", output.display(), shot.size[0], shot.size[1]);
    }
    warn_of_driver(shot, &drawn.small);
    Ok(Stats::new(shot, &drawn.times))
}
