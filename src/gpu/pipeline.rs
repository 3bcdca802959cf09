//! A scene's shader as a pipeline, and the buffer of its numbers.

use std::borrow::Cow;
use std::panic::{AssertUnwindSafe, catch_unwind};

use super::assets::{Assets, check_models};
use super::guard::Guard;
use super::layouts::layout_entry;
use super::{Gpu, GpuError};
use crate::bindings::{ACCUMULATED, CORNER, FRAME, NUMBERS};
use crate::compile::Compiled;
use crate::frame::FrameUniforms;
use crate::wgsl::Mode;

/// The texture that a picture gathers in: linear light, and depth.
pub(super) const FORMAT: wgpu::TextureFormat = wgpu::TextureFormat::Rgba32Float;

/// A scene, compiled by the driver. One whose text stays the same takes new numbers.
#[derive(Debug)]
pub struct Pipeline {
    pub(super) pipeline: wgpu::RenderPipeline,
    pub(super) layout: wgpu::BindGroupLayout,
    pub(super) numbers: Option<wgpu::Buffer>,
    pub(super) assets: Option<Assets>,
    pub(super) guard: Option<Guard>,
    /// Objects of the scene that cast shadows: they are text, so an upload does not change them.
    pub(super) casters: u32,
    /// Whether it draws debug views, too.
    pub has_views: bool,
}

impl Pipeline {
    /// Makes one shader module and one pipeline.
    ///
    /// # Errors
    /// Where the driver refuses, or the scene has more numbers than the GPU's uniform buffers hold.
    pub fn build(gpu: &Gpu, compiled: &Compiled) -> Result<Self, GpuError> {
        check_numbers(gpu, compiled)?;
        check_models(gpu, &compiled.scene)?;
        Guard::check(gpu, compiled)?;
        checked(gpu, compiled, || make(gpu, compiled))
    }

    /// Waits until what it draws is there.
    ///
    /// # Errors
    /// Where a loop of the author's had to be ended, or the device stops to answer.
    pub fn finish(&self, gpu: &Gpu) -> Result<(), GpuError> {
        self.guard.as_ref().map_or_else(|| gpu.wait(), |guard| guard.verdict(gpu))
    }

    /// Replaces the scene's numbers by those of a scene with the same text.
    pub fn upload(&self, gpu: &Gpu, numbers: &[f32]) {
        if let Some(buffer) = &self.numbers {
            gpu.queue.write_buffer(buffer, 0, bytemuck::cast_slice(numbers));
        }
    }
}

/// # Errors
/// Where the scene has more numbers than the GPU's uniform buffers hold.
pub(super) fn check_numbers(gpu: &Gpu, compiled: &Compiled) -> Result<(), GpuError> {
    let bytes = size_of_val(compiled.source.numbers.as_slice()) as u64;
    let most = gpu.device.limits().max_uniform_buffer_binding_size;
    if bytes <= most {
        return Ok(());
    }
    let why = format!(
        "the scene has {bytes} bytes of numbers, and the GPU takes {most} at once; \
         leave out --live, or some of its objects"
    );
    Err(GpuError::Refused(why))
}

/// What `make` makes of `compiled`, unless the driver has something against it.
///
/// # Errors
/// Where the driver refuses, or a loop could be endless.
pub(super) fn checked<T: Send>(
    gpu: &Gpu,
    compiled: &Compiled,
    make: impl FnOnce() -> T + Send,
) -> Result<T, GpuError> {
    if let Some(place) = compiled.module.unguarded() {
        return Err(GpuError::Unguarded(place.into()));
    }
    // Scopes belong to a thread, so they stand on the one that makes the pipeline.
    crate::compile::on_deep_stack(|| {
        let scope = gpu.device.push_error_scope(wgpu::ErrorFilter::Validation);
        let internal = gpu.device.push_error_scope(wgpu::ErrorFilter::Internal);
        // naga's writers panic at some text that naga's own check lets pass.
        let made = catch_unwind(AssertUnwindSafe(make));
        let errors = [pollster::block_on(internal.pop()), pollster::block_on(scope.pop())];
        let refused = errors.into_iter().flatten().next().map(|error| error.to_string());
        match (made, refused) {
            (Ok(made), None) => Ok(made),
            (_, Some(why)) => Err(GpuError::Refused(why)),
            (Err(panic), None) => Err(GpuError::Refused(format!(
                "naga cannot write this shader for the driver: {}",
                panic.downcast_ref::<String>().map_or("", String::as_str)
            ))),
        }
    })
}

pub(super) fn shader_module(gpu: &Gpu, compiled: &Compiled) -> wgpu::ShaderModule {
    gpu.count_pipeline();
    let descriptor = wgpu::ShaderModuleDescriptor {
        label: Some(&compiled.scene.name),
        source: wgpu::ShaderSource::Naga(Cow::Owned(compiled.module.naga().clone())),
    };
    // wgpu would count the steps of every loop: a sixth of the compile on Mesa's software driver, and up to a
    // third of a frame on a GPU.
    let checks =
        wgpu::ShaderRuntimeChecks { force_loop_bounding: false, ..wgpu::ShaderRuntimeChecks::checked() };
    // SAFETY: no loop is endless. `module::guard` ends those of authors; where `module::bounded` finds one
    // without a guard, `checked` refuses the module. Those that ship are bounded.
    unsafe { gpu.device.create_shader_module_trusted(descriptor, checks) }
}

/// The buffer of a live scene's numbers, filled; none where they are literals.
pub(super) fn numbers_buffer(gpu: &Gpu, compiled: &Compiled) -> Option<wgpu::Buffer> {
    let numbers: &[u8] = bytemuck::cast_slice(&compiled.source.numbers);
    (compiled.source.target.mode == Mode::Live).then(|| {
        let buffer = uniform_buffer(gpu, "numbers", numbers.len() as u64);
        gpu.queue.write_buffer(&buffer, 0, numbers);
        buffer
    })
}

pub(super) fn uniform_buffer(gpu: &Gpu, label: &str, size: u64) -> wgpu::Buffer {
    gpu.device.create_buffer(&wgpu::BufferDescriptor {
        label: Some(label),
        size,
        usage: wgpu::BufferUsages::UNIFORM | wgpu::BufferUsages::COPY_DST,
        mapped_at_creation: false,
    })
}

fn make(gpu: &Gpu, compiled: &Compiled) -> Pipeline {
    let device = &gpu.device;
    let module = shader_module(gpu, compiled);
    let stage = wgpu::ShaderStages::FRAGMENT;
    let numbers = numbers_buffer(gpu, compiled);
    let mut entries = vec![
        layout_entry(FRAME, size_of::<FrameUniforms>() as u64, stage),
        layout_entry(ACCUMULATED, 0, stage),
        layout_entry(CORNER, size_of::<[f32; 2]>() as u64, stage),
    ];
    entries.extend(numbers.iter().map(|numbers| layout_entry(NUMBERS, numbers.size(), stage)));
    let guard = Guard::new(gpu, compiled);
    entries.extend(guard.iter().map(|_| Guard::layout(stage)));
    let layout = device.create_bind_group_layout(&wgpu::BindGroupLayoutDescriptor {
        label: Some("scene"),
        entries: &entries,
    });
    let assets = Assets::new(gpu, &compiled.scene);
    let layouts = [Some(&layout)].into_iter().chain(assets.iter().map(|assets| Some(&assets.layout)));
    let pipeline = super::display::full_screen_pipeline(
        device,
        &module,
        &layouts.collect::<Vec<_>>(),
        ["coverPicture", "tracePixel"],
        FORMAT,
    );
    let casters = compiled.scene.casters();
    let has_views = compiled.source.target.views;
    Pipeline { pipeline, layout, numbers, assets, guard, casters, has_views }
}
