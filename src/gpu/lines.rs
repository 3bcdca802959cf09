//! Lines of the world over a finished picture: lights, targets and boxes that rays do not meet.
//!
//! In: a picture with its distances, the camera that took it, [`Line`]s. Out: pixels on a target, faint where
//! the picture has something nearer.
//!
//! What is compared is the depth z along the view. On a screen 1/z of a line goes straight from end to end.
//! Of the picture it is z = d / |ray|, where d is the distance that it holds, and `ray` has length 1 along
//! the view. The shader compares, and not a depth buffer: so one pass draws both parts, and a line that
//! lies on a surface can be separated from one behind it by the pixels around.

use bytemuck::{Pod, Zeroable};
use glam::{Vec2, Vec3};

use super::layouts::{entry, layout_entry};
use super::pipeline::uniform_buffer;
use super::{Gpu, Target};
use crate::bindings::{OVER, PICTURE};
use crate::frame::Lens;
use crate::ir::Camera;
use crate::library::built_in;

/// The pass of shaders/lines.wgsl, for targets of one format.
#[derive(Debug)]
pub struct Lines {
    gpu: Gpu,
    pipeline: wgpu::RenderPipeline,
    layout: wgpu::BindGroupLayout,
    options: wgpu::Buffer,
}

/// A straight line in world space.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Line {
    pub from: Vec3,
    pub to: Vec3,
    /// Red, green and blue as a screen shows them, 0 to 1.
    pub color: Vec3,
    /// Pixels of the target.
    pub width: f32,
}

/// `Over` of shaders/lines.wgsl.
#[repr(C)]
#[derive(Clone, Copy, Pod, Zeroable)]
struct Options {
    corner: [f32; 2],
    zoom: f32,
    half_view: f32,
    target_size: [f32; 2],
    padding: [u32; 2],
}

/// `Line` of shaders/lines.wgsl.
#[repr(C)]
#[derive(Clone, Copy, Debug, PartialEq, Pod, Zeroable)]
struct SeenLine {
    start: [f32; 3],
    end: [f32; 3],
    color: [f32; 3],
    width: f32,
}

/// A line that comes from behind the eye begins at this share of the depth of its farther end.
const NEAREST: f32 = 1e-3;

impl Lines {
    pub fn new(gpu: &Gpu, format: wgpu::TextureFormat) -> Self {
        let device = &gpu.device;
        let text = built_in("shaders/lines.wgsl").expect("it ships with raytoy");
        let module = device.create_shader_module(wgpu::ShaderModuleDescriptor {
            label: Some("shaders/lines.wgsl"),
            source: wgpu::ShaderSource::Wgsl(text.into()),
        });
        let stages = wgpu::ShaderStages::VERTEX_FRAGMENT;
        let layout = device.create_bind_group_layout(&wgpu::BindGroupLayoutDescriptor {
            label: Some("lines"),
            entries: &[
                layout_entry(OVER, size_of::<Options>() as u64, stages),
                layout_entry(PICTURE, 0, stages),
            ],
        });
        let pipeline = line_pipeline(device, &module, &layout, format);
        let options = uniform_buffer(gpu, "lines", size_of::<Options>() as u64);
        Self { gpu: gpu.clone(), pipeline, layout, options }
    }

    /// Draws `lines` over what `target` shows: `picture`, at `place`, as `camera` took it. Where the target
    /// is transparent, the lines come out with premultiplied opacity.
    pub fn draw(
        &self,
        picture: &wgpu::Texture,
        camera: &Camera,
        target: &wgpu::TextureView,
        place: Target,
        lines: &[Line],
    ) {
        let lens = Lens::new(camera, [picture.width(), picture.height()]);
        let seen: Vec<SeenLine> = lines.iter().filter_map(|line| SeenLine::of(line, &lens, place)).collect();
        if seen.is_empty() {
            return;
        }
        let Gpu { device, queue, .. } = &self.gpu;
        let target_size = [target.texture().width() as f32, target.texture().height() as f32];
        let Target { corner, zoom } = place;
        let options = Options { corner, zoom, half_view: lens.half, target_size, padding: [0; 2] };
        queue.write_buffer(&self.options, 0, bytemuck::bytes_of(&options));
        let instances = device.create_buffer(&wgpu::BufferDescriptor {
            label: Some("lines"),
            size: size_of_val(seen.as_slice()) as u64,
            usage: wgpu::BufferUsages::VERTEX | wgpu::BufferUsages::COPY_DST,
            mapped_at_creation: false,
        });
        queue.write_buffer(&instances, 0, bytemuck::cast_slice(&seen));
        let picture = picture.create_view(&Default::default());
        let bindings = device.create_bind_group(&wgpu::BindGroupDescriptor {
            label: Some("lines"),
            layout: &self.layout,
            entries: &[
                entry(OVER, self.options.as_entire_binding()),
                entry(PICTURE, wgpu::BindingResource::TextureView(&picture)),
            ],
        });
        let mut encoder = device.create_command_encoder(&Default::default());
        {
            let mut pass = super::display::begin_pass(&mut encoder, target, wgpu::LoadOp::Load);
            pass.set_pipeline(&self.pipeline);
            pass.set_bind_group(0, &bindings, &[]);
            pass.set_vertex_buffer(0, instances.slice(..));
            pass.draw(0..4, 0..seen.len() as u32);
        }
        queue.submit([encoder.finish()]);
    }
}

impl SeenLine {
    /// None where all of the line is behind the eye.
    fn of(line: &Line, lens: &Lens, place: Target) -> Option<Self> {
        let Line { from, to, color, width } = *line;
        let (a, b) = (lens.depth(from), lens.depth(to));
        let nearest = NEAREST * a.max(b);
        if nearest <= 0.0 {
            return None;
        }
        let cut = |end: Vec3, own: f32, other: Vec3, others: f32| match own < nearest {
            true => end.lerp(other, (nearest - own) / (others - own)),
            false => end,
        };
        let seen = |point: Vec3| {
            let pixel = Vec2::from(place.corner) + place.zoom * lens.pixel(point);
            pixel.extend(lens.depth(point)).to_array()
        };
        let (start, end) = (seen(cut(from, a, to, b)), seen(cut(to, b, from, a)));
        Some(Self { start, end, color: color.to_array(), width })
    }
}

fn line_pipeline(
    device: &wgpu::Device,
    module: &wgpu::ShaderModule,
    layout: &wgpu::BindGroupLayout,
    format: wgpu::TextureFormat,
) -> wgpu::RenderPipeline {
    let layout = device.create_pipeline_layout(&wgpu::PipelineLayoutDescriptor {
        label: Some("lines"),
        bind_group_layouts: &[Some(layout)],
        immediate_size: 0,
    });
    let line = wgpu::VertexBufferLayout {
        array_stride: size_of::<SeenLine>() as u64,
        step_mode: wgpu::VertexStepMode::Instance,
        attributes: &wgpu::vertex_attr_array![0 => Float32x3, 1 => Float32x3, 2 => Float32x3, 3 => Float32],
    };
    let painted = wgpu::ColorTargetState {
        format,
        blend: Some(wgpu::BlendState::PREMULTIPLIED_ALPHA_BLENDING),
        write_mask: wgpu::ColorWrites::ALL,
    };
    device.create_render_pipeline(&wgpu::RenderPipelineDescriptor {
        label: Some("lines"),
        layout: Some(&layout),
        vertex: wgpu::VertexState {
            module,
            entry_point: Some("coverLine"),
            compilation_options: Default::default(),
            buffers: &[Some(line)],
        },
        primitive: wgpu::PrimitiveState {
            topology: wgpu::PrimitiveTopology::TriangleStrip,
            ..Default::default()
        },
        depth_stencil: None,
        multisample: Default::default(),
        fragment: Some(wgpu::FragmentState {
            module,
            entry_point: Some("paintLine"),
            compilation_options: Default::default(),
            targets: &[Some(painted)],
        }),
        multiview_mask: None,
        cache: None,
    })
}
