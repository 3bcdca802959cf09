//! What a scene takes from files, on the GPU: images and models, all as textures.

use super::layouts::{entry, layout_entry};
use super::{Gpu, GpuError};
use crate::assets::Model;
use crate::bindings::SAMPLER;
use crate::frame::{MODELS_ROW, TexelFormat, Texels, texels};
use crate::ir::Scene;

/// Bind group 1 of a scene's shader: a sampler, the images, the models.
#[derive(Debug)]
pub struct Assets {
    pub layout: wgpu::BindGroupLayout,
    pub group: wgpu::BindGroup,
}

impl Assets {
    /// None where the scene's shader takes nothing from files.
    pub fn new(gpu: &Gpu, scene: &Scene) -> Option<Self> {
        let device = &gpu.device;
        let textures: Vec<_> = texels(scene).map(|texels| (texels.binding, upload(gpu, &texels))).collect();
        if textures.is_empty() {
            return None;
        }
        let sampler = (!scene.images_in_use().is_empty()).then(|| sampler(device));
        let bindings = sampler.iter().map(|_| SAMPLER).chain(textures.iter().map(|(binding, _)| *binding));
        let layout = device.create_bind_group_layout(&wgpu::BindGroupLayoutDescriptor {
            label: Some("assets"),
            entries: &bindings
                .map(|binding| layout_entry(binding, 0, wgpu::ShaderStages::all()))
                .collect::<Vec<_>>(),
        });
        let views: Vec<_> = textures
            .iter()
            .map(|(binding, texture)| (*binding, texture.create_view(&Default::default())))
            .collect();
        let sampler = sampler.iter().map(|sampler| entry(SAMPLER, wgpu::BindingResource::Sampler(sampler)));
        let views = views.iter().map(|(n, view)| entry(*n, wgpu::BindingResource::TextureView(view)));
        let group = device.create_bind_group(&wgpu::BindGroupDescriptor {
            label: Some("assets"),
            layout: &layout,
            entries: &sampler.chain(views).collect::<Vec<_>>(),
        });
        Some(Self { layout, group })
    }
}

/// # Errors
/// Where the GPU does not hold the scene's models.
pub fn check_models(gpu: &Gpu, scene: &Scene) -> Result<(), GpuError> {
    let texels: usize = scene.models.iter().map(Model::texels).sum();
    let most = (MODELS_ROW * gpu.device.limits().max_texture_dimension_2d) as usize;
    if texels > most {
        let triangles: usize = scene.models.iter().map(|model| model.triangles.len()).sum();
        let why =
            format!("the scene's models have {triangles} triangles, and the GPU takes about {}", most / 9);
        return Err(GpuError::Refused(why));
    }
    Ok(())
}

fn sampler(device: &wgpu::Device) -> wgpu::Sampler {
    device.create_sampler(&wgpu::SamplerDescriptor {
        label: Some("images"),
        address_mode_u: wgpu::AddressMode::Repeat,
        address_mode_v: wgpu::AddressMode::Repeat,
        mag_filter: wgpu::FilterMode::Linear,
        min_filter: wgpu::FilterMode::Linear,
        mipmap_filter: wgpu::MipmapFilterMode::Linear,
        ..Default::default()
    })
}

fn upload(gpu: &Gpu, texels: &Texels) -> wgpu::Texture {
    let [width, height] = texels.size;
    let size = wgpu::Extent3d { width, height, depth_or_array_layers: 1 };
    let dimension = wgpu::TextureDimension::D2;
    let texture = gpu.device.create_texture(&wgpu::TextureDescriptor {
        label: Some(&texels.files[0]),
        size,
        mip_level_count: texels.levels.len() as u32,
        sample_count: 1,
        dimension,
        format: match texels.format {
            TexelFormat::Rgba16Float => wgpu::TextureFormat::Rgba16Float,
            TexelFormat::Rgba32Uint => wgpu::TextureFormat::Rgba32Uint,
        },
        usage: wgpu::TextureUsages::TEXTURE_BINDING | wgpu::TextureUsages::COPY_DST,
        view_formats: &[],
    });
    for (bytes, mip_level) in texels.levels.iter().zip(0..) {
        let size = size.mip_level_size(mip_level, dimension);
        let bytes_per_row = Some(bytes.len() as u32 / size.height);
        gpu.queue.write_texture(
            wgpu::TexelCopyTextureInfo { mip_level, ..texture.as_image_copy() },
            bytes,
            wgpu::TexelCopyBufferLayout { offset: 0, bytes_per_row, rows_per_image: None },
            size,
        );
    }
    texture
}
