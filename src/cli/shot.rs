//! The scene and the picture of it that the options of `raytoy render` ask for.

use std::path::PathBuf;

use super::args::RenderOptions;
use super::{Failure, Result};
use crate::capture::{Shot, Small};
use crate::compile::Compiled;
use crate::frame::{Moment, Split, View};
use crate::gpu::{Gpu, SMALL};
use crate::ir::Measure;
use crate::sketch::canary;
use crate::wgsl::Mode;

/// The scene as the options ask for it, with the number that the view `value` shows, if it is to be seen.
pub fn compiled(options: &RenderOptions, scene: &PathBuf) -> Result<Compiled> {
    let disk = super::disk(&options.root, [scene])?;
    let mode = if options.live { Mode::Live } else { Mode::Baked };
    let compiled = super::compiled(&disk, scene, mode)?;
    if !shows_numbers(options) {
        return Ok(compiled);
    }
    let name = options.value.as_deref().unwrap_or("pattern");
    let Some(measure) = Measure::named(&compiled.scene, name) else {
        let known = Measure::ALL.iter().map(|(known, _)| *known);
        let declared = compiled.scene.textures.iter().map(|texture| texture.name.as_str());
        let names: Vec<&str> = known.chain(declared).collect();
        let message = format!("`{}` has no value `{name}`: it has {}", compiled.scene.name, names.join(", "));
        return Err(Failure::Call(message));
    };
    compiled.measuring(measure).map_err(|problem| Failure::Call(problem.message))
}

/// What the options ask for.
pub fn shot<'a>(options: &RenderOptions, gpu: &'a Gpu, compiled: &'a Compiled) -> Shot<'a> {
    let RenderOptions { view, time, reach, split_at: at, .. } = *options;
    let split = options.split.map(|view| Split { view, at });
    let moment = Moment { view, split, reach, time, ..Moment::of(&compiled.scene) };
    Shot { gpu, compiled, moment, size: options.size, samples: options.samples }
}

/// Prints a warning where the driver does not draw what the scene says; `small` is the shot as it drew it.
pub fn warn_of_driver(shot: &Shot<'_>, small: &Small) {
    let Some(small) = small else { return };
    let moment = Moment { split: None, ..shot.moment };
    if let Some(doubt) = canary::doubt(shot.compiled, &moment, SMALL, small, canary::PATIENCE) {
        let warning = doubt.warning(&shot.compiled.scene.name, &shot.gpu.describe());
        super::print_report(&warning.into());
    }
}

/// Whether the view `value` is to be seen.
pub fn shows_numbers(options: &RenderOptions) -> bool {
    options.view == View::Value || options.split == Some(View::Value)
}
