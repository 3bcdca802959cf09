//! One entry point of a compute shader that answers each question of a list by itself.
//!
//! The questions are a storage buffer, and so are the answers. Long lists go in batches: a batch stays far
//! below what any device takes in one buffer, and does not keep the GPU for long.

use bytemuck::{AnyBitPattern, NoUninit};

use super::assets::Assets;
use super::layouts::{self, layout_entry};
use super::{Gpu, GpuError};
use crate::bindings::Binding;

/// A compute pipeline with questions and answers in group 2.
#[derive(Debug)]
pub(super) struct Kernel {
    pipeline: wgpu::ComputePipeline,
    layout: wgpu::BindGroupLayout,
    /// Questions and answers.
    lists: [Binding; 2],
}

/// What all of a scene's shaders share.
#[derive(Debug)]
pub(super) struct Scene {
    /// Frame and numbers.
    pub values: wgpu::BindGroup,
    pub assets: Option<Assets>,
}

/// As shaders/probe.wgsl says.
const WORKGROUP: u32 = 64;

/// Questions of one submit.
const BATCH: usize = 1 << 16;

impl Kernel {
    /// # Errors
    /// Where the device has no compute shaders, as with OpenGL before 4.3.
    pub fn check(gpu: &Gpu) -> Result<(), GpuError> {
        let limits = gpu.device.limits();
        let has_buffers = limits.max_storage_buffers_per_shader_stage >= 2;
        if has_buffers && limits.max_compute_invocations_per_workgroup >= WORKGROUP {
            return Ok(());
        }
        Err(GpuError::Refused("it has no compute shaders".into()))
    }

    /// `entry` of `module`, whose groups 0 and 1 have the layouts `scene`; `lists` are its questions and
    /// answers.
    pub fn new(
        gpu: &Gpu,
        module: &wgpu::ShaderModule,
        scene: [Option<&wgpu::BindGroupLayout>; 2],
        entry: &str,
        lists: [Binding; 2],
    ) -> Self {
        let device = &gpu.device;
        let layout = device.create_bind_group_layout(&wgpu::BindGroupLayoutDescriptor {
            label: Some(entry),
            entries: &lists.map(|list| layout_entry(list, 0, wgpu::ShaderStages::COMPUTE)),
        });
        let pipeline_layout = device.create_pipeline_layout(&wgpu::PipelineLayoutDescriptor {
            label: Some(entry),
            bind_group_layouts: &[scene[0], scene[1], Some(&layout)],
            immediate_size: 0,
        });
        let pipeline = device.create_compute_pipeline(&wgpu::ComputePipelineDescriptor {
            label: Some(entry),
            layout: Some(&pipeline_layout),
            module,
            entry_point: Some(entry),
            compilation_options: Default::default(),
            cache: None,
        });
        Self { pipeline, layout, lists }
    }

    /// The answers to `items`, one for each; `question` and `answer` know the shader's structs.
    ///
    /// # Errors
    /// Where the device stops to answer.
    pub fn ask<I, Q: NoUninit, A: AnyBitPattern + NoUninit, R>(
        &self,
        gpu: &Gpu,
        scene: &Scene,
        items: &[I],
        question: impl Fn(&I) -> Q,
        answer: impl Fn(&A) -> R,
    ) -> Result<Vec<R>, GpuError> {
        if items.is_empty() {
            return Ok(vec![]);
        }
        let most = items.len().min(BATCH);
        let buffer = |label, size: usize, usage| {
            gpu.device.create_buffer(&wgpu::BufferDescriptor {
                label: Some(label),
                size: size as u64,
                usage,
                mapped_at_creation: false,
            })
        };
        let storage = wgpu::BufferUsages::STORAGE;
        let asked = buffer("questions", most * size_of::<Q>(), storage | wgpu::BufferUsages::COPY_DST);
        let told = buffer("answers", most * size_of::<A>(), storage | wgpu::BufferUsages::COPY_SRC);
        let mut answers = Vec::with_capacity(items.len());
        for batch in items.chunks(BATCH) {
            let questions: Vec<Q> = batch.iter().map(&question).collect();
            gpu.queue.write_buffer(&asked, 0, bytemuck::cast_slice(&questions));
            let bytes = (batch.len() * size_of::<A>()) as u64;
            // The shader counts its questions by the size of what is bound.
            let part = |buffer, size: usize| {
                let size = wgpu::BufferSize::new(size as u64);
                wgpu::BindingResource::Buffer(wgpu::BufferBinding { buffer, offset: 0, size })
            };
            let lists = gpu.device.create_bind_group(&wgpu::BindGroupDescriptor {
                label: Some("questions and answers"),
                layout: &self.layout,
                entries: &[
                    layouts::entry(self.lists[0], part(&asked, size_of_val(&*questions))),
                    layouts::entry(self.lists[1], part(&told, bytes as usize)),
                ],
            });
            let mut encoder = gpu.device.create_command_encoder(&Default::default());
            {
                let mut pass = encoder.begin_compute_pass(&Default::default());
                pass.set_pipeline(&self.pipeline);
                pass.set_bind_group(0, &scene.values, &[]);
                if let Some(assets) = &scene.assets {
                    pass.set_bind_group(1, &assets.group, &[]);
                }
                pass.set_bind_group(2, &lists, &[]);
                pass.dispatch_workgroups((batch.len() as u32).div_ceil(WORKGROUP), 1, 1);
            }
            let bytes = gpu.read_back(encoder, bytes, |encoder, target| {
                encoder.copy_buffer_to_buffer(&told, 0, target, 0, bytes);
            })?;
            answers.extend(bytemuck::pod_collect_to_vec::<u8, A>(&bytes).iter().map(&answer));
        }
        Ok(answers)
    }
}
