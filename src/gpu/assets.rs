//! What a scene takes from files: images and models, all as textures.

use half::f16;

use super::{Gpu, GpuError};
use crate::ir::Scene;
use crate::library::{Image, Model};

/// Bind group 1 of a scene's shader: a sampler, the images, the models.
#[derive(Debug)]
pub struct Assets {
    pub layout: wgpu::BindGroupLayout,
    pub group: wgpu::BindGroup,
}

/// Holds light beyond 1 in half the bytes of a float, and every device filters it.
const FORMAT: wgpu::TextureFormat = wgpu::TextureFormat::Rgba16Float;

/// As shaders/model.wgsl says.
const MODELS: u32 = 15;
const MODEL_ROW: u32 = 2048;

impl Assets {
    /// None where the scene takes nothing from files.
    pub fn new(gpu: &Gpu, scene: &Scene) -> Option<Self> {
        let device = &gpu.device;
        let sampler = (!scene.images.is_empty()).then(|| sampler(device));
        let images: Vec<_> =
            scene.images.iter().map(|image| upload_image(device, &gpu.queue, image)).collect();
        let models = (!scene.models.is_empty()).then(|| upload_models(gpu, &scene.models));
        let seen = wgpu::TextureSampleType::Float { filterable: true };
        let words = wgpu::TextureSampleType::Uint;
        let bound = (1..).zip(images.iter().map(|view| (view, seen)));
        let bound: Vec<_> = bound.chain(models.iter().map(|view| (MODELS, (view, words)))).collect();
        if bound.is_empty() {
            return None;
        }
        let texture = |sample_type| wgpu::BindingType::Texture {
            sample_type,
            view_dimension: wgpu::TextureViewDimension::D2,
            multisampled: false,
        };
        let filtering = wgpu::BindingType::Sampler(wgpu::SamplerBindingType::Filtering);
        let kinds = sampler.iter().map(|_| (0, filtering));
        let kinds = kinds.chain(bound.iter().map(|(binding, (_, kind))| (*binding, texture(*kind))));
        let layout = device.create_bind_group_layout(&wgpu::BindGroupLayoutDescriptor {
            label: Some("assets"),
            entries: &kinds.map(|(binding, ty)| layout_entry(binding, ty)).collect::<Vec<_>>(),
        });
        let entry = |(binding, resource)| wgpu::BindGroupEntry { binding, resource };
        let entries = sampler.iter().map(|sampler| (0, wgpu::BindingResource::Sampler(sampler)));
        let views = bound.iter().map(|(n, (view, _))| (*n, wgpu::BindingResource::TextureView(view)));
        let group = device.create_bind_group(&wgpu::BindGroupDescriptor {
            label: Some("assets"),
            layout: &layout,
            entries: &entries.chain(views).map(entry).collect::<Vec<_>>(),
        });
        Some(Self { layout, group })
    }
}

/// # Errors
/// Where the GPU does not hold the scene's models.
pub fn check_models(gpu: &Gpu, scene: &Scene) -> Result<(), GpuError> {
    let texels: usize = scene.models.iter().map(Model::texels).sum();
    let most = (MODEL_ROW * gpu.device.limits().max_texture_dimension_2d) as usize;
    if texels > most {
        let triangles: usize = scene.models.iter().map(|model| model.triangles.len()).sum();
        let why =
            format!("the scene's models have {triangles} triangles, and the GPU takes about {}", most / 9);
        return Err(GpuError::Refused(why));
    }
    Ok(())
}

fn layout_entry(binding: u32, ty: wgpu::BindingType) -> wgpu::BindGroupLayoutEntry {
    let visibility = wgpu::ShaderStages::FRAGMENT | wgpu::ShaderStages::COMPUTE;
    wgpu::BindGroupLayoutEntry { binding, visibility, ty, count: None }
}

/// All models in a row, as shaders/model.wgsl says.
fn upload_models(gpu: &Gpu, models: &[Model]) -> wgpu::TextureView {
    let mut words: Vec<[u32; 4]> = vec![];
    for model in models {
        words.extend(model.words(words.len() as u32));
    }
    let rows = (words.len() as u32).div_ceil(MODEL_ROW);
    words.resize((rows * MODEL_ROW) as usize, [0; 4]);
    let size = wgpu::Extent3d { width: MODEL_ROW, height: rows, depth_or_array_layers: 1 };
    let texture = gpu.device.create_texture(&wgpu::TextureDescriptor {
        label: Some("models"),
        size,
        mip_level_count: 1,
        sample_count: 1,
        dimension: wgpu::TextureDimension::D2,
        format: wgpu::TextureFormat::Rgba32Uint,
        usage: wgpu::TextureUsages::TEXTURE_BINDING | wgpu::TextureUsages::COPY_DST,
        view_formats: &[],
    });
    let layout =
        wgpu::TexelCopyBufferLayout { offset: 0, bytes_per_row: Some(MODEL_ROW * 16), rows_per_image: None };
    gpu.queue.write_texture(texture.as_image_copy(), bytemuck::cast_slice(&words), layout, size);
    texture.create_view(&Default::default())
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

fn upload_image(device: &wgpu::Device, queue: &wgpu::Queue, image: &Image) -> wgpu::TextureView {
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
