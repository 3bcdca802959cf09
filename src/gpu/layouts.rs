//! Rows of [`crate::bindings`] as wgpu takes them.
//!
//! In: a [`Binding`]. Out: its entry in a bind group, and in the layout of one.

use crate::bindings::{Binding, Content, Stage};

/// Its entry in the layout of a bind group, for those of its stages that are among `stages`. `bytes` is the
/// least size of a buffer; 0 leaves it open, as for what is no buffer.
pub fn layout_entry(binding: Binding, bytes: u64, stages: wgpu::ShaderStages) -> wgpu::BindGroupLayoutEntry {
    let buffer = |ty| wgpu::BindingType::Buffer {
        ty,
        has_dynamic_offset: false,
        min_binding_size: wgpu::BufferSize::new(bytes),
    };
    let texture = |sample_type| wgpu::BindingType::Texture {
        sample_type,
        view_dimension: wgpu::TextureViewDimension::D2,
        multisampled: false,
    };
    let ty = match binding.content {
        Content::Uniform => buffer(wgpu::BufferBindingType::Uniform),
        Content::Storage { is_writable } => {
            buffer(wgpu::BufferBindingType::Storage { read_only: !is_writable })
        }
        Content::Texels => texture(wgpu::TextureSampleType::Float { filterable: false }),
        Content::Image => texture(wgpu::TextureSampleType::Float { filterable: true }),
        Content::Words => texture(wgpu::TextureSampleType::Uint),
        Content::Sampler => wgpu::BindingType::Sampler(wgpu::SamplerBindingType::Filtering),
    };
    let visibility = stages_of(binding) & stages;
    wgpu::BindGroupLayoutEntry { binding: binding.number, visibility, ty, count: None }
}

/// Its entry in a bind group.
pub fn entry(binding: Binding, resource: wgpu::BindingResource<'_>) -> wgpu::BindGroupEntry<'_> {
    wgpu::BindGroupEntry { binding: binding.number, resource }
}

fn stages_of(binding: Binding) -> wgpu::ShaderStages {
    let stage = |stage: &Stage| match stage {
        Stage::Vertex => wgpu::ShaderStages::VERTEX,
        Stage::Fragment => wgpu::ShaderStages::FRAGMENT,
        Stage::Compute => wgpu::ShaderStages::COMPUTE,
    };
    binding.stages.iter().map(stage).collect()
}
