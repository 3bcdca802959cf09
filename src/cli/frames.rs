//! `raytoy render --frames`: a scene that moves, as pictures or as a movie.

use std::ops::Range;
use std::path::Path;

use super::args::RenderOptions;
use super::progress::with_progress;
use super::shot::{compiled, shot, warn_of_driver};
use super::stats::Stats;
use super::words::LONGEST_TIME;
use super::{Failure, Result, print_report, write_output};
use crate::capture::{self, Format, Frames, MovieFormat, Numbered};
use crate::diagnostic::Diagnostic;
use crate::gpu::Gpu;

/// Where frames go.
enum Output {
    Pictures(Numbered),
    Movie(MovieFormat),
}

pub fn run(options: &RenderOptions, numbers: Range<u32>) -> Result {
    let [scene] = options.scenes.as_slice() else {
        return Err(Failure::Call("--frames draws one scene: name one scene".into()));
    };
    let path = &options.output;
    let output = output(path)?;
    let frames = Frames { numbers, rate: options.fps };
    let last = frames.time(frames.numbers.end - 1);
    if last > LONGEST_TIME {
        let message =
            format!("the last frame is at {last} seconds; the latest time is {LONGEST_TIME} seconds");
        return Err(Failure::Call(message));
    }
    let gpu = Gpu::headless(&options.adapter)?;
    let compiled = compiled(options, scene)?;
    let count = frames.numbers.len();
    if !compiled.source.reads_time() && count > 1 {
        let message = format!("`{}` does not move: all {count} frames are equal", compiled.scene.name);
        let problem = Diagnostic::warning(message).help("textures and shapes move if they read `frame.time`");
        print_report(&problem.into());
    }
    let shot = shot(options, &gpu, &compiled);
    let (times, small) = with_progress(&compiled.scene.name, |progress| match &output {
        Output::Pictures(names) => capture::stills(&shot, &frames, names, progress),
        Output::Movie(format) => capture::movie(&shot, &frames, path, *format, progress),
    })?;
    let noun = if count == 1 { "frame" } else { "frames" };
    eprintln!("{}: {count} {noun} of {}x{}", path.display(), shot.size[0], shot.size[1]);
    warn_of_driver(&frames.shot(&shot, frames.numbers.start), &small);
    if let Some(path) = &options.stats {
        let all: Vec<Stats> = times.iter().map(|times| Stats::new(&shot, times)).collect();
        write_output(path, Stats::json(&all).as_bytes())?;
    }
    Ok(())
}

fn output(path: &Path) -> Result<Output> {
    if let Some(format) = MovieFormat::of(path) {
        return Ok(Output::Movie(format));
    }
    if let Some(names) = Numbered::of(path) {
        return Ok(Output::Pictures(names));
    }
    if Format::of(path).is_some() {
        let stem = path.file_stem().unwrap_or_default().to_string_lossy();
        let extension = path.extension().unwrap_or_default().to_string_lossy();
        let better = path.with_file_name(format!("{stem}####.{extension}"));
        return Err(Failure::Call(format!(
            "`{}` has no place for the number of the frame: write # for its digits, as in `{}`",
            path.display(),
            better.display()
        )));
    }
    let message = format!(
        "the format of `{}` is unknown: \
         name a .mp4, .webm or .gif movie, or pictures such as `frames/####.png`",
        path.display()
    );
    Err(Failure::Call(message))
}
