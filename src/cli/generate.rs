//! `raytoy generate`: the shader of a scene.

use std::io::IsTerminal;
use std::path::Path;

use super::args::GenerateOptions;
use super::{Failure, Result, compiled, write_output};
use crate::export::{Language, export};
use crate::wgsl::Mode;

pub fn run(options: &GenerateOptions) -> Result {
    let output = options.output.as_deref().unwrap_or(Path::new("-"));
    let is_seen = output == Path::new("-") && std::io::stdout().is_terminal();
    if is_seen && options.lang == Some(Language::Spirv) {
        let why = "SPIR-V is no text for a terminal; name a file, as in `-o scene.spv`";
        return Err(Failure::Call(why.into()));
    }
    let mode = if options.live { Mode::Live } else { Mode::Baked };
    let compiled = compiled(&options.scene, mode)?;
    let bytes = match options.lang {
        None if !options.standalone => compiled.source.text().into_bytes(),
        language => export(&compiled, language.unwrap_or(Language::Wgsl))?,
    };
    write_output(output, &bytes)
}
