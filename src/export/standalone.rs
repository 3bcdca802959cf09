//! A scene as a WGSL module by itself, and that module as the writers of other languages take it.
//!
//! In: a scene. Out: text, or a [`Standalone`].

use naga::compact::{KeepUnused, compact};
use naga::valid::{Capabilities, ModuleInfo, ValidationFlags, Validator};

use super::beside::Beside;
use super::{ExportError, integers};
use crate::frame::{FrameUniforms, Moment};
use crate::ir::Scene;
use crate::library::Const;
use crate::module::validate;
use crate::wgsl::{Host, Source, Target, generate};

/// A module that needs no raytoy.
pub struct Standalone {
    pub source: Source,
    /// Only what its entry points use.
    pub module: naga::Module,
    pub info: ModuleInfo,
    pub beside: Beside,
}

impl Standalone {
    pub fn new(scene: &Scene, host: Host) -> Result<Self, ExportError> {
        let source = generate(scene, &Target::without_raytoy(host));
        let validated = validate(&source).map_err(|problem| {
            let place = problem.labels.first().map_or("its own text", |(place, _)| place.file.as_str());
            ExportError::Refused(format!("{} (in {place})", problem.message))
        })?;
        let mut module = validated.naga().clone();
        if let Host::Shadertoy { .. } = source.target.host {
            integers::define(&mut module, validated.info());
        }
        compact(&mut module, KeepUnused::No);
        let info = Validator::new(ValidationFlags::all(), Capabilities::default())
            .validate(&module)
            .map_err(|error| ExportError::Refused(error.to_string()))?;
        let beside = Beside::new(scene, &module);
        Ok(Self { source, module, info, beside })
    }
}

/// The scene's values for the fields of shaders/frame.wgsl, for a picture one pixel high.
pub fn settings(scene: &Scene) -> Vec<(&'static str, Const)> {
    let frame = FrameUniforms::new(&Moment::of(scene), &scene.render, 0, [1, 1], 0, [0.0; 2]);
    vec![
        ("eye", Const::Vec3(frame.eye.into())),
        ("right", Const::Vec3(frame.right.into())),
        ("up", Const::Vec3(frame.up.into())),
        ("forward", Const::Vec3(frame.forward.into())),
        ("pixel_spread", Const::F32(frame.pixel_spread)),
        ("max_bounces", Const::U32(frame.max_bounces)),
        ("shadow_samples", Const::U32(frame.shadow_samples)),
    ]
}
