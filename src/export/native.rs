//! A scene for WebGPU as it is, and for the drivers of each system by naga's writers.
//!
//! In: a module by itself. Out: WGSL, SPIR-V, or text in the languages of Metal and Direct3D.

use std::collections::BTreeMap;

use naga::back::{hlsl, msl, spv};

use super::beside::{MSL_SAMPLES, Resource};
use super::standalone::Standalone;
use super::{ExportError, head};
use crate::bindings::{Binding, Content, FRAME, SAMPLER, SAMPLES};
use crate::ir::Scene;

/// The text that naga writes for the sampler of shaders/image.wgsl.
const HEAP: &str = "\
SamplerState nagaSamplerHeap[2048]: register(s0, space0);
SamplerComparisonState nagaComparisonSamplerHeap[2048]: register(s0, space1);
StructuredBuffer<uint> nagaGroup1SamplerIndexArray : register(t1, space255);
static const SamplerState image_sampler = nagaSamplerHeap[nagaGroup1SamplerIndexArray[0]];
";
const OWN_SAMPLER: &str = "SamplerState image_sampler : register(s0, space1);\n";

/// The module as text, which opens with how to draw it.
pub fn wgsl(scene: &Scene, alone: &Standalone) -> String {
    head::standalone(scene, alone, &head::WGSL) + &alone.source.text()
}

/// For Vulkan. The bindings are those of the WGSL.
pub fn spirv(Standalone { module, info, .. }: &Standalone) -> Result<Vec<u8>, ExportError> {
    let options = spv::Options {
        // Names, whether or not raytoy is a debug build; and y upwards, as WGSL has it.
        flags: spv::WriterFlags::DEBUG
            | spv::WriterFlags::LABEL_VARYINGS
            | spv::WriterFlags::ADJUST_COORDINATE_SPACE,
        // All loops of a scene end.
        force_loop_bounding: false,
        ..Default::default()
    };
    let words = spv::write_vec(module, info, &options, None).map_err(refused)?;
    Ok(words.into_iter().flat_map(u32::to_le_bytes).collect())
}

pub fn msl(scene: &Scene, alone: &Standalone) -> Result<String, ExportError> {
    let Standalone { module, info, beside, .. } = alone;
    let frame = msl::BindTarget { buffer: Some(FRAME.number as u8), ..Default::default() };
    let texture = |slot| msl::BindTarget { texture: Some(slot), ..Default::default() };
    let sampler = |slot| msl::BindTarget {
        sampler: Some(msl::BindSamplerTarget::Resource(slot)),
        ..Default::default()
    };
    let mut resources = BTreeMap::from([(place(FRAME), frame), (place(SAMPLES), texture(MSL_SAMPLES))]);
    // Each has the number that it has in WGSL, where textures of files begin at 1.
    resources.extend(beside.resources.iter().map(|Resource { binding, .. }| {
        let slot = binding.number as u8;
        (place(*binding), if binding.content == Content::Sampler { sampler(slot) } else { texture(slot) })
    }));
    let resources = msl::EntryPointResources { resources, ..Default::default() };
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
    Ok(head::translated(scene, alone, &head::MSL) + &text)
}

pub fn hlsl(scene: &Scene, alone: &Standalone) -> Result<String, ExportError> {
    let Standalone { module, info, .. } = alone;
    // Bindings that are in no map become registers of the same numbers, in the space of their group.
    let options = hlsl::Options { force_loop_bounding: false, ..Default::default() };
    let pipeline = hlsl::PipelineOptions::default();
    let mut text = String::new();
    let translated =
        hlsl::Writer::new(&mut text, &options, &pipeline).write(module, info, None).map_err(refused)?;
    for name in translated.entry_point_names {
        name.map_err(refused)?;
    }
    Ok(head::translated(scene, alone, &head::HLSL) + &with_own_sampler(text, alone)?)
}

/// naga takes samplers out of a heap of 2048, by a buffer of indices: more than a host wants to bind for one.
fn with_own_sampler(text: String, alone: &Standalone) -> Result<String, ExportError> {
    if !alone.beside.resources.iter().any(|resource| resource.binding == SAMPLER) {
        return Ok(text);
    }
    if text.matches(HEAP).count() != 1 {
        return Err(refused("naga wrote the samplers in an unexpected way"));
    }
    Ok(text.replacen(HEAP, OWN_SAMPLER, 1))
}

fn place(binding: Binding) -> naga::ResourceBinding {
    naga::ResourceBinding { group: binding.group, binding: binding.number }
}

fn refused(error: impl std::fmt::Display) -> ExportError {
    ExportError::Refused(error.to_string())
}
