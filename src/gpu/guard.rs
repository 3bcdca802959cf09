//! The report of a draw about loops that had to be ended: see shaders/guard.wgsl.
//!
//! In: a scene with loops of its author's. Out: which of them went on for too long.

use std::sync::Arc;

use super::layouts::{entry, layout_entry};
use super::{Gpu, GpuError};
use crate::bindings::ENDED_LOOP;
use crate::compile::Compiled;
use crate::diagnostic::Report;

/// The number of the loop that was ended, on the GPU, and the report of each loop.
#[derive(Debug)]
pub(super) struct Guard {
    ended: wgpu::Buffer,
    loops: Arc<[Report]>,
}

const NUMBER_BYTES: u64 = 4;

impl Guard {
    /// # Errors
    /// If the scene needs a guard, and the GPU cannot report what a draw has met.
    pub fn check(gpu: &Gpu, compiled: &Compiled) -> Result<(), GpuError> {
        let flags = gpu.adapter.get_downlevel_capabilities().flags;
        let can_tell = flags.contains(wgpu::DownlevelFlags::FRAGMENT_WRITABLE_STORAGE);
        if can_tell || compiled.module.loops().is_empty() {
            return Ok(());
        }
        let why = "it cannot stop endless loops, and a texture or shape of the scene has loops";
        Err(GpuError::Refused(why.into()))
    }

    /// None where all loops of the scene are raytoy's own.
    pub fn new(gpu: &Gpu, compiled: &Compiled) -> Option<Self> {
        let loops = compiled.module.loops().clone();
        let ended = (!loops.is_empty()).then(|| {
            gpu.device.create_buffer(&wgpu::BufferDescriptor {
                label: Some("ended loop"),
                size: NUMBER_BYTES,
                usage: wgpu::BufferUsages::STORAGE
                    | wgpu::BufferUsages::COPY_SRC
                    | wgpu::BufferUsages::COPY_DST,
                mapped_at_creation: false,
            })
        })?;
        Some(Self { ended, loops })
    }

    /// Its place in the layout of bind group 0, for a shader that runs in `visibility`.
    pub fn layout(visibility: wgpu::ShaderStages) -> wgpu::BindGroupLayoutEntry {
        layout_entry(ENDED_LOOP, NUMBER_BYTES, visibility)
    }

    pub fn entry(&self) -> wgpu::BindGroupEntry<'_> {
        entry(ENDED_LOOP, self.ended.as_entire_binding())
    }

    /// Waits until all submitted work is done. Another draw with other numbers may be better.
    ///
    /// # Errors
    /// Which loop had to be ended; or where the device stops to answer.
    pub fn verdict(&self, gpu: &Gpu) -> Result<(), GpuError> {
        let encoder = gpu.device.create_command_encoder(&Default::default());
        let bytes = gpu.read_back(encoder, NUMBER_BYTES, |encoder, target| {
            encoder.copy_buffer_to_buffer(&self.ended, 0, target, 0, NUMBER_BYTES);
            encoder.clear_buffer(&self.ended, 0, None);
        })?;
        let number: u32 = bytemuck::pod_read_unaligned(&bytes);
        match number.checked_sub(1).and_then(|i| self.loops.get(i as usize)) {
            Some(report) => Err(GpuError::Endless(report.clone())),
            None => Ok(()),
        }
    }
}
