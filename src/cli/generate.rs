//! `raytoy generate`: the shader of a scene.

use std::path::Path;

use super::{Result, compiled, write_output};
use crate::wgsl::Mode;

pub fn run(scene: &Path, live: bool, output: Option<&Path>) -> Result {
    let mode = if live { Mode::Live } else { Mode::Baked };
    let compiled = compiled(scene, mode)?;
    write_output(output.unwrap_or(Path::new("-")), compiled.source.text().as_bytes())
}
