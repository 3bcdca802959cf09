//! `raytoy generate`: the shader of a scene.

use std::io::IsTerminal;
use std::path::Path;

use super::args::GenerateOptions;
use super::{Failure, Result, compiled, disk, write_output};
use crate::export::{Export, Language, export};
use crate::wgsl::Mode;

pub fn run(options: &GenerateOptions) -> Result {
    let output = options.output.as_deref().unwrap_or(Path::new("-"));
    let is_seen = output == Path::new("-") && std::io::stdout().is_terminal();
    if is_seen && options.lang == Some(Language::Spirv) {
        let why = "SPIR-V is binary and cannot be shown in a terminal; name a file, as in `-o scene.spv`";
        return Err(Failure::Call(why.into()));
    }
    let mode = if options.live { Mode::Live } else { Mode::Baked };
    let compiled = compiled(&disk(&options.root, [&options.scene])?, &options.scene, mode)?;
    let shader = match options.lang {
        None if !options.standalone => compiled.source.text().into_bytes(),
        language => {
            let export = export(&compiled, language.unwrap_or(Language::Wgsl))?;
            if !export.texels.is_empty() {
                write_beside(output, &export.texels)?;
            }
            export.shader
        }
    };
    write_output(output, &shader)
}

/// Writes what the shader at `output` takes from files, as its head says.
fn write_beside(output: &Path, texels: &[u8]) -> Result {
    // A stream or a device has nothing beside it.
    let is_file = output != Path::new("-") && std::fs::metadata(output).map_or(true, |found| found.is_file());
    if !is_file {
        let why = "the images and models of the scene go to a second file beside the shader; \
                   name a file for the shader, as in `-o scene.wgsl`";
        return Err(Failure::Call(why.into()));
    }
    let beside = Export::texels_file(output);
    write_output(&beside, texels)?;
    eprintln!("{}: {} bytes, the images and models of {}", beside.display(), texels.len(), output.display());
    Ok(())
}
