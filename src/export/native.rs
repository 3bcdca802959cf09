//! A scene for the drivers of each system, by naga's writers.
//!
//! In: a scene without files. Out: SPIR-V, or text in the languages of Metal and Direct3D.

use naga::back::{hlsl, msl, spv};

use super::standalone::Standalone;
use super::{ExportError, head};
use crate::ir::Scene;
use crate::wgsl::Host;

/// For Vulkan. The bindings are those of the WGSL.
pub fn spirv(scene: &Scene) -> Result<Vec<u8>, ExportError> {
    let Standalone { module, info, .. } = Standalone::new(scene, Host::Any)?;
    let options = spv::Options {
        // Names, whether or not raytoy is a debug build; and y upwards, as WGSL has it.
        flags: spv::WriterFlags::DEBUG
            | spv::WriterFlags::LABEL_VARYINGS
            | spv::WriterFlags::ADJUST_COORDINATE_SPACE,
        // All loops of a scene end.
        force_loop_bounding: false,
        ..Default::default()
    };
    let words = spv::write_vec(&module, &info, &options, None).map_err(refused)?;
    Ok(words.into_iter().flat_map(u32::to_le_bytes).collect())
}

pub fn msl(scene: &Scene) -> Result<String, ExportError> {
    let alone = Standalone::new(scene, Host::Any)?;
    let Standalone { module, info, .. } = &alone;
    let slot = |binding| naga::ResourceBinding { group: 0, binding };
    let frame = msl::BindTarget { buffer: Some(0), ..Default::default() };
    let samples = msl::BindTarget { texture: Some(0), ..Default::default() };
    let resources = msl::EntryPointResources {
        resources: [(slot(0), frame), (slot(1), samples)].into(),
        ..Default::default()
    };
    let entries = module.entry_points.iter().map(|entry| (entry.name.clone(), resources.clone()));
    let options = msl::Options {
        lang_version: (2, 0),
        per_entry_point_map: entries.collect(),
        fake_missing_bindings: false,
        force_loop_bounding: false,
        ..Default::default()
    };
    let pipeline = msl::PipelineOptions {
        entry_point: None,
        allow_and_force_point_size: false,
        vertex_pulling_transform: false,
        vertex_buffer_mappings: vec![],
        binding_array_length_map: Default::default(),
    };
    let (text, translated) = msl::write_string(module, info, &options, &pipeline).map_err(refused)?;
    for name in translated.entry_point_names {
        name.map_err(refused)?;
    }
    Ok(head::translated(scene, &alone, &head::MSL) + &text)
}

pub fn hlsl(scene: &Scene) -> Result<String, ExportError> {
    let alone = Standalone::new(scene, Host::Any)?;
    let Standalone { module, info, .. } = &alone;
    // Bindings that no map tells of become registers of the same numbers.
    let options = hlsl::Options { force_loop_bounding: false, ..Default::default() };
    let pipeline = hlsl::PipelineOptions::default();
    let mut text = String::new();
    let translated =
        hlsl::Writer::new(&mut text, &options, &pipeline).write(module, info, None).map_err(refused)?;
    for name in translated.entry_point_names {
        name.map_err(refused)?;
    }
    Ok(head::translated(scene, &alone, &head::HLSL) + &text)
}

fn refused(error: impl std::fmt::Display) -> ExportError {
    ExportError::Refused(error.to_string())
}
