//! From gathered light to what a screen shows: the second, small pass.

use std::ops::Range;

use bytemuck::{Pod, Zeroable};

use super::layouts::{entry, layout_entry};
use super::pipeline::uniform_buffer;
use super::{Gpu, GpuError};
use crate::bindings::{DISPLAY, PICTURE};
use crate::ir;
use crate::library::built_in;

/// The pass of shaders/display.wgsl, for targets of one format.
#[derive(Debug)]
pub struct Display {
    gpu: Gpu,
    /// For light, and for values that are shown as they are.
    pipelines: [wgpu::RenderPipeline; 2],
    layout: wgpu::BindGroupLayout,
    options: wgpu::Buffer,
}

/// Where on a target the picture goes.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Target {
    /// Top left, pixels of the target.
    pub corner: [f32; 2],
    /// Pixels of the target to one of the picture.
    pub zoom: f32,
}

/// The part of a picture that holds light, and how it is to be shown. The rest are values.
#[derive(Clone, Debug)]
pub struct LitColumns<'a> {
    pub render: &'a ir::Render,
    /// Pixels of the picture, from the left.
    pub columns: Range<u32>,
}

/// `Display` of shaders/display.wgsl.
#[repr(C)]
#[derive(Clone, Copy, Pod, Zeroable)]
struct Options {
    gain: f32,
    tone_map: u32,
    transfer: u32,
    gamma: f32,
    corner: [f32; 2],
    zoom: f32,
    padding: u32,
}

impl Display {
    pub fn new(gpu: &Gpu, format: wgpu::TextureFormat) -> Self {
        let text = ["shaders/display.wgsl", "shaders/tone.wgsl"]
            .map(|name| built_in(name).expect("it ships with raytoy"))
            .join("\n");
        let module = gpu.device.create_shader_module(wgpu::ShaderModuleDescriptor {
            label: Some("shaders/display.wgsl"),
            source: wgpu::ShaderSource::Wgsl(text.into()),
        });
        let stages = wgpu::ShaderStages::VERTEX_FRAGMENT;
        let layout = gpu.device.create_bind_group_layout(&wgpu::BindGroupLayoutDescriptor {
            label: Some("display"),
            entries: &[
                layout_entry(DISPLAY, size_of::<Options>() as u64, stages),
                layout_entry(PICTURE, 0, stages),
            ],
        });
        let pipelines = ["showLight", "showValue"].map(|fragment| {
            full_screen_pipeline(&gpu.device, &module, &[Some(&layout)], ["coverTarget", fragment], format)
        });
        let options = uniform_buffer(gpu, "display", size_of::<Options>() as u64);
        Self { gpu: gpu.clone(), pipelines, layout, options }
    }

    /// Draws `picture` on `target`: its light as that is to be shown, other values as they are.
    pub fn draw(
        &self,
        picture: &wgpu::Texture,
        light: Option<LitColumns<'_>>,
        target: &wgpu::TextureView,
        place: Target,
    ) {
        let render = light.as_ref().map(|light| light.render);
        let columns = light.map_or(0..0, |light| light.columns);
        let is_all_light = columns == (0..picture.width());
        let [values, lights] = [&self.pipelines[1], &self.pipelines[0]];
        let transfer = render.map_or(ir::Transfer::Linear, |r| r.transfer);
        let (transfer, gamma) = match transfer {
            ir::Transfer::Linear => (0, 1.0),
            ir::Transfer::Srgb => (1, 1.0),
            ir::Transfer::Gamma(gamma) => (2, gamma),
        };
        let options = Options {
            gain: render.map_or(1.0, |r| r.gain),
            tone_map: render.map_or(0, |r| r.tone_map as u32),
            transfer,
            gamma,
            corner: place.corner,
            zoom: place.zoom,
            padding: 0,
        };
        let Gpu { device, queue, .. } = &self.gpu;
        queue.write_buffer(&self.options, 0, bytemuck::bytes_of(&options));
        let picture = picture.create_view(&Default::default());
        let bindings = device.create_bind_group(&wgpu::BindGroupDescriptor {
            label: Some("display"),
            layout: &self.layout,
            entries: &[
                entry(DISPLAY, self.options.as_entire_binding()),
                entry(PICTURE, wgpu::BindingResource::TextureView(&picture)),
            ],
        });
        let mut encoder = device.create_command_encoder(&Default::default());
        {
            let mut pass = begin_pass(&mut encoder, target, wgpu::LoadOp::Clear(wgpu::Color::BLACK));
            pass.set_bind_group(0, &bindings, &[]);
            if !is_all_light {
                pass.set_pipeline(values);
                pass.draw(0..3, 0..1);
            }
            if !columns.is_empty() {
                let texture = target.texture();
                if !is_all_light {
                    let edge = |column: u32| place.corner[0] + place.zoom * column as f32;
                    let [start, end] = [columns.start, columns.end]
                        .map(|column| (edge(column).round() as u32).min(texture.width()));
                    pass.set_scissor_rect(start, 0, end - start, texture.height());
                }
                pass.set_pipeline(lights);
                pass.draw(0..3, 0..1);
            }
        }
        queue.submit([encoder.finish()]);
    }

    /// A texture of the size of `picture` to draw on, which can be shown, and read by [`Display::read`].
    pub fn canvas(&self, picture: &wgpu::Texture, format: wgpu::TextureFormat) -> wgpu::Texture {
        self.gpu.device.create_texture(&wgpu::TextureDescriptor {
            label: Some("canvas"),
            size: picture.size(),
            mip_level_count: 1,
            sample_count: 1,
            dimension: wgpu::TextureDimension::D2,
            format,
            usage: wgpu::TextureUsages::RENDER_ATTACHMENT
                | wgpu::TextureUsages::TEXTURE_BINDING
                | wgpu::TextureUsages::COPY_SRC,
            view_formats: &[],
        })
    }

    /// The four bytes of each pixel of `canvas`, by rows from the top.
    pub fn read(&self, canvas: &wgpu::Texture) -> Result<Vec<u8>, GpuError> {
        self.gpu.read_texture(canvas, 4)
    }
}

/// A pipeline of one triangle that covers its target.
pub(super) fn full_screen_pipeline(
    device: &wgpu::Device,
    module: &wgpu::ShaderModule,
    layouts: &[Option<&wgpu::BindGroupLayout>],
    [vertex, fragment]: [&str; 2],
    format: wgpu::TextureFormat,
) -> wgpu::RenderPipeline {
    let layout = device.create_pipeline_layout(&wgpu::PipelineLayoutDescriptor {
        label: None,
        bind_group_layouts: layouts,
        immediate_size: 0,
    });
    device.create_render_pipeline(&wgpu::RenderPipelineDescriptor {
        label: Some(fragment),
        layout: Some(&layout),
        vertex: wgpu::VertexState {
            module,
            entry_point: Some(vertex),
            compilation_options: Default::default(),
            buffers: &[],
        },
        primitive: Default::default(),
        depth_stencil: None,
        multisample: Default::default(),
        fragment: Some(wgpu::FragmentState {
            module,
            entry_point: Some(fragment),
            compilation_options: Default::default(),
            targets: &[Some(format.into())],
        }),
        multiview_mask: None,
        cache: None,
    })
}

/// A pass over one target.
pub(super) fn begin_pass<'a>(
    encoder: &'a mut wgpu::CommandEncoder,
    target: &wgpu::TextureView,
    load: wgpu::LoadOp<wgpu::Color>,
) -> wgpu::RenderPass<'a> {
    encoder.begin_render_pass(&wgpu::RenderPassDescriptor {
        color_attachments: &[Some(wgpu::RenderPassColorAttachment {
            view: target,
            depth_slice: None,
            resolve_target: None,
            ops: wgpu::Operations { load, store: wgpu::StoreOp::Store },
        })],
        ..Default::default()
    })
}
