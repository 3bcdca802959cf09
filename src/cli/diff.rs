//! `raytoy diff`: what differs between two scenes.

use std::path::Path;

use super::args::{DiffFormat, DiffOptions};
use super::progress::with_progress;
use super::scene::{bytes, origin};
use super::{Failure, Result, print_report, print_result, write_output};
use crate::compile::{Compiled, compile};
use crate::difference::{self, Drawing, PictureDifference, SceneDifference};
use crate::gpu::Gpu;
use crate::sources::Disk;
use crate::wgsl::Mode;

pub fn run(options: &DiffOptions) -> Result {
    let [old, new] = [&options.old, &options.new];
    if [old, new].iter().all(|path| is_input(path)) {
        return Err(Failure::Call("only one of the two scenes can come from standard input".into()));
    }
    let disk = super::disk(&options.root, [old, new])?;
    // Both are read before one is refused, so that the mistakes of both are printed.
    let (old, new) = (compiled(&disk, old, new)?, compiled(&disk, new, old)?);
    let (Some(old), Some(new)) = (old, new) else {
        return Err(match options.exit_code {
            true => Failure::Call("a scene with mistakes cannot be compared".into()),
            false => Failure::Scene,
        });
    };
    let mut difference = SceneDifference::between(&old, &new);
    if !options.no_picture {
        let gpu = Gpu::headless(&options.adapter)?;
        let drawing = Drawing { size: options.size, samples: options.samples, time: options.time };
        let picture = with_progress("drawing both", |progress| {
            PictureDifference::between(&gpu, [&old, &new], drawing, &mut |share| {
                let _ = progress(share);
            })
        });
        let picture = picture.map_err(|error| match (Failure::from(error), options.exit_code) {
            (Failure::Endless(report), true) => {
                print_report(&report);
                Failure::Call("a scene with mistakes cannot be compared".into())
            }
            (failure, _) => failure,
        });
        difference.picture = Some(picture?);
        difference.adapter = Some(gpu.describe());
    }
    if let Some(path) = &options.report {
        write_output(path, difference::page(&difference).as_bytes())?;
        eprintln!("The report is {}.", path.display());
    }
    print_result(&match options.format {
        DiffFormat::Human => difference::human(&difference),
        DiffFormat::Json => difference::json(&difference),
    })?;
    let has_code = options.exit_code && !difference.is_none();
    if has_code { Err(Failure::Scene) } else { Ok(()) }
}

/// The scene at `path`, read beside `other`. Prints the mistakes of a wrong scene, and returns None.
fn compiled(disk: &Disk, path: &Path, other: &Path) -> Result<Option<Compiled>> {
    let bytes = bytes(path)?;
    let place = if is_input(path) { other.with_file_name("-") } else { path.to_path_buf() };
    let sources = disk.sources();
    let sources = match text(path, &bytes)? {
        Some(text) => sources.with(&place, &text),
        None => sources,
    };
    let outcome = compile(&sources, &place, Mode::Baked, None);
    print_report(&outcome.report);
    Ok(outcome.compiled)
}

/// The text of a scene that is not in the file at `path` as it is.
fn text(path: &Path, bytes: &[u8]) -> Result<Option<String>> {
    if bytes.starts_with(b"\x89PNG") {
        return Ok(Some(origin(path, bytes)?.scene));
    }
    if !is_input(path) {
        return Ok(None);
    }
    let text = String::from_utf8(bytes.to_vec());
    text.map(Some).map_err(|_| Failure::Call("standard input is not UTF-8 text".into()))
}

fn is_input(path: &Path) -> bool {
    path == Path::new("-")
}
