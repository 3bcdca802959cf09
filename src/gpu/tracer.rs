//! A picture that gathers samples, drawn in slices so that no submit keeps the GPU for long.

use super::guard::Guard;
use super::layouts::entry;
use super::pipeline::{FORMAT, uniform_buffer};
use super::{Gpu, GpuError, Pipeline, Region};
use crate::bindings::{ACCUMULATED, CORNER, FRAME, NUMBERS};
use crate::frame::{FrameUniforms, Moment};
use crate::ir;

/// Two textures, of which one holds the samples so far and the other takes the next.
#[derive(Debug)]
pub struct Tracer {
    gpu: Gpu,
    frame: wgpu::Buffer,
    corner: wgpu::Buffer,
    /// The picture that this is a part of, and where it begins there.
    whole: ([u32; 2], [u32; 2]),
    textures: [wgpu::Texture; 2],
    samples: u32,
}

impl Tracer {
    /// # Errors
    /// Where the GPU has no texture of `size`, or no memory for it.
    pub fn new(gpu: &Gpu, size: [u32; 2]) -> Result<Self, GpuError> {
        let most = gpu.device.limits().max_texture_dimension_2d;
        if size.iter().any(|n| *n > most || *n == 0) {
            let why =
                format!("a picture of {}x{}; its pictures go from 1x1 to {most}x{most}", size[0], size[1]);
            return Err(GpuError::Refused(why));
        }
        let corner = uniform_buffer(gpu, "corner", size_of::<[f32; 2]>() as u64);
        let frame = uniform_buffer(gpu, "frame", size_of::<FrameUniforms>() as u64);
        let texture = |label| {
            gpu.device.create_texture(&wgpu::TextureDescriptor {
                label: Some(label),
                size: wgpu::Extent3d { width: size[0], height: size[1], depth_or_array_layers: 1 },
                mip_level_count: 1,
                sample_count: 1,
                dimension: wgpu::TextureDimension::D2,
                format: FORMAT,
                usage: wgpu::TextureUsages::RENDER_ATTACHMENT
                    | wgpu::TextureUsages::TEXTURE_BINDING
                    | wgpu::TextureUsages::COPY_SRC
                    | wgpu::TextureUsages::COPY_DST,
                view_formats: &[],
            })
        };
        let textures = [texture("even samples"), texture("odd samples")];
        gpu.check()?;
        Ok(Self { gpu: gpu.clone(), frame, corner, whole: (size, [0; 2]), textures, samples: 0 })
    }

    /// Goes on as a part of a picture of `size` pixels, at `corner`, without any samples.
    pub(super) fn aim(&mut self, size: [u32; 2], corner: [u32; 2]) {
        self.whole = (size, corner);
        self.restart();
    }

    pub fn size(&self) -> [u32; 2] {
        [self.textures[0].width(), self.textures[0].height()]
    }

    /// Forgets all samples.
    pub fn restart(&mut self) {
        self.samples = 0;
    }

    /// How many samples each pixel holds.
    pub fn samples(&self) -> u32 {
        self.samples
    }

    /// The samples so far: linear light with the depth of the first, which is negative where it met nothing.
    pub fn picture(&self) -> &wgpu::Texture {
        &self.textures[(self.samples as usize + 1) % 2]
    }

    /// Draws a part of the next sample. Once all parts are drawn, [`Tracer::next`] makes it count.
    pub fn draw(
        &mut self,
        pipeline: &Pipeline,
        moment: &Moment,
        render: &ir::Render,
        jitter: [f32; 2],
        region: &Region,
    ) {
        let Gpu { device, queue, .. } = &self.gpu;
        let (size, corner) = self.whole;
        let frame = FrameUniforms::new(moment, render, pipeline.casters, size, self.samples, jitter);
        queue.write_buffer(&self.frame, 0, bytemuck::bytes_of(&frame));
        queue.write_buffer(&self.corner, 0, bytemuck::bytes_of(&corner.map(|n| n as f32)));
        let target = &self.textures[self.samples as usize % 2];
        let (before, target) =
            (self.picture().create_view(&Default::default()), target.create_view(&Default::default()));
        let mut entries = vec![
            entry(FRAME, self.frame.as_entire_binding()),
            entry(ACCUMULATED, wgpu::BindingResource::TextureView(&before)),
            entry(CORNER, self.corner.as_entire_binding()),
        ];
        entries.extend(pipeline.numbers.iter().map(|numbers| entry(NUMBERS, numbers.as_entire_binding())));
        entries.extend(pipeline.guard.iter().map(Guard::entry));
        let bindings = device.create_bind_group(&wgpu::BindGroupDescriptor {
            label: Some("scene"),
            layout: &pipeline.layout,
            entries: &entries,
        });
        let mut encoder = device.create_command_encoder(&Default::default());
        {
            let mut pass = super::display::begin_pass(&mut encoder, &target, wgpu::LoadOp::Load);
            pass.set_pipeline(&pipeline.pipeline);
            pass.set_bind_group(0, &bindings, &[]);
            if let Some(assets) = &pipeline.assets {
                pass.set_bind_group(1, &assets.group, &[]);
            }
            let Region { columns, rows } = region;
            pass.set_scissor_rect(columns.start, rows.start, columns.len() as u32, rows.len() as u32);
            pass.draw(0..3, 0..1);
        }
        queue.submit([encoder.finish()]);
    }

    /// Takes pixels that were drawn elsewhere as the first sample: light and depth, row by row from the top.
    pub fn fill(&mut self, pixels: &[[f32; 4]]) {
        let [width, height] = self.size();
        let layout = wgpu::TexelCopyBufferLayout {
            offset: 0,
            bytes_per_row: Some(width * size_of::<[f32; 4]>() as u32),
            rows_per_image: None,
        };
        let size = wgpu::Extent3d { width, height, depth_or_array_layers: 1 };
        let texture = self.textures[0].as_image_copy();
        self.gpu.queue.write_texture(texture, bytemuck::cast_slice(pixels), layout, size);
        self.samples = 1;
    }

    /// The sample that was drawn is complete.
    pub fn next(&mut self) {
        self.samples += 1;
    }
}
