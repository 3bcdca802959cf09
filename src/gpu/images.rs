//! The images of a scene as textures.

use half::f16;

use crate::library::Image;

/// Bind group 1 of a scene's shader: a sampler, then the images.
#[derive(Debug)]
pub struct Images {
    pub layout: wgpu::BindGroupLayout,
    pub group: wgpu::BindGroup,
}

/// Holds light beyond 1 in half the bytes of a float, and every device filters it.
const FORMAT: wgpu::TextureFormat = wgpu::TextureFormat::Rgba16Float;

impl Images {
    /// None where there are no images.
    pub fn new(device: &wgpu::Device, queue: &wgpu::Queue, images: &[Image]) -> Option<Self> {
        if images.is_empty() {
            return None;
        }
        let entry = |binding, ty| wgpu::BindGroupLayoutEntry {
            binding,
            visibility: wgpu::ShaderStages::FRAGMENT | wgpu::ShaderStages::COMPUTE,
            ty,
            count: None,
        };
        let texture = wgpu::BindingType::Texture {
            sample_type: wgpu::TextureSampleType::Float { filterable: true },
            view_dimension: wgpu::TextureViewDimension::D2,
            multisampled: false,
        };
        let sampler = entry(0, wgpu::BindingType::Sampler(wgpu::SamplerBindingType::Filtering));
        let textures = (1..).zip(images).map(|(binding, _)| entry(binding, texture));
        let layout = device.create_bind_group_layout(&wgpu::BindGroupLayoutDescriptor {
            label: Some("images"),
            entries: &[sampler].into_iter().chain(textures).collect::<Vec<_>>(),
        });
        let sampler = device.create_sampler(&wgpu::SamplerDescriptor {
            label: Some("images"),
            address_mode_u: wgpu::AddressMode::Repeat,
            address_mode_v: wgpu::AddressMode::Repeat,
            mag_filter: wgpu::FilterMode::Linear,
            min_filter: wgpu::FilterMode::Linear,
            mipmap_filter: wgpu::MipmapFilterMode::Linear,
            ..Default::default()
        });
        let views: Vec<wgpu::TextureView> = images.iter().map(|image| upload(device, queue, image)).collect();
        let sampler = wgpu::BindGroupEntry { binding: 0, resource: wgpu::BindingResource::Sampler(&sampler) };
        let views = (1..).zip(&views).map(|(binding, view)| wgpu::BindGroupEntry {
            binding,
            resource: wgpu::BindingResource::TextureView(view),
        });
        let group = device.create_bind_group(&wgpu::BindGroupDescriptor {
            label: Some("images"),
            layout: &layout,
            entries: &[sampler].into_iter().chain(views).collect::<Vec<_>>(),
        });
        Some(Self { layout, group })
    }
}

fn upload(device: &wgpu::Device, queue: &wgpu::Queue, image: &Image) -> wgpu::TextureView {
    let extent =
        |size: [u32; 2]| wgpu::Extent3d { width: size[0], height: size[1], depth_or_array_layers: 1 };
    let texture = device.create_texture(&wgpu::TextureDescriptor {
        label: Some(&image.file),
        size: extent(image.levels[0].size),
        mip_level_count: image.levels.len() as u32,
        sample_count: 1,
        dimension: wgpu::TextureDimension::D2,
        format: FORMAT,
        usage: wgpu::TextureUsages::TEXTURE_BINDING | wgpu::TextureUsages::COPY_DST,
        view_formats: &[],
    });
    for (level, mip_level) in image.levels.iter().zip(0..) {
        let texels: Vec<[u16; 4]> = level
            .texels
            .iter()
            .map(|rgb| rgb.extend(1.0).to_array().map(|x| f16::from_f32(x.min(65504.0)).to_bits()))
            .collect();
        queue.write_texture(
            wgpu::TexelCopyTextureInfo { mip_level, ..texture.as_image_copy() },
            bytemuck::cast_slice(&texels),
            wgpu::TexelCopyBufferLayout {
                offset: 0,
                bytes_per_row: Some(level.size[0] * 8),
                rows_per_image: None,
            },
            extent(level.size),
        );
    }
    texture.create_view(&Default::default())
}
