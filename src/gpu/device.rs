//! A device on an adapter, and a count of what is made on it.

use std::sync::atomic::{AtomicBool, AtomicU32, Ordering};
use std::sync::{Arc, Mutex};
use std::time::Duration;

use super::adapters::{AdapterChoice, find_adapter};
use super::error::GpuError;

/// A device with its queue. Clones share both.
#[derive(Clone, Debug)]
pub struct Gpu {
    pub adapter: wgpu::Adapter,
    pub device: wgpu::Device,
    pub queue: wgpu::Queue,
    made: Arc<AtomicU32>,
    lost: Arc<AtomicBool>,
    /// What went wrong outside of all error scopes, until somebody asks.
    trouble: Arc<Mutex<Option<GpuError>>>,
}

/// A device that has not answered for this long will not.
const PATIENCE: Duration = Duration::from_secs(60);

/// A driver that runs on the processor compiles in that time, too: a minute for some 300 objects.
const PATIENCE_WITH_SOFTWARE: Duration = Duration::from_secs(900);

/// Asks Mesa's software driver to compile sooner, for shaders that draw half as fast: an author waits for the
/// compile at each structural edit, and a picture comes coarse first. Other drivers do not look at it.
///
/// # Safety
/// No other thread runs yet, as [`std::env::set_var`] demands.
pub unsafe fn prefer_quick_compiles() {
    const FLAGS: &str = "GALLIVM_PERF";
    if std::env::var_os(FLAGS).is_none() {
        // SAFETY: the caller's promise.
        unsafe { std::env::set_var(FLAGS, "nopt") };
    }
}

impl Gpu {
    /// A device without a window.
    pub fn headless(choice: &AdapterChoice) -> Result<Self, GpuError> {
        let mut descriptor = wgpu::InstanceDescriptor::new_without_display_handle();
        descriptor.backends = wgpu::Backends::PRIMARY;
        let instance = wgpu::Instance::new(descriptor.with_env());
        Self::open(&instance, choice, None)
    }

    /// A device that can draw on `surface`, if there is one.
    pub fn open(
        instance: &wgpu::Instance,
        choice: &AdapterChoice,
        surface: Option<&wgpu::Surface<'_>>,
    ) -> Result<Self, GpuError> {
        let adapter = pollster::block_on(find_adapter(instance, choice, surface))?;
        // A headless picture may be as large as the adapter's textures. A probe needs compute shaders; all
        // else does without.
        let limits = adapter.limits();
        let required_limits = wgpu::Limits {
            max_texture_dimension_2d: limits.max_texture_dimension_2d,
            max_uniform_buffer_binding_size: limits.max_uniform_buffer_binding_size,
            ..wgpu::Limits::downlevel_defaults()
                .using_resolution(limits.clone())
                .or_worse_values_from(&limits)
        };
        let descriptor = wgpu::DeviceDescriptor { required_limits, ..Default::default() };
        let (device, queue) = pollster::block_on(adapter.request_device(&descriptor))
            .map_err(|error| GpuError::Refused(error.to_string()))?;
        let gpu = Self {
            adapter,
            device,
            queue,
            made: Arc::default(),
            lost: Arc::default(),
            trouble: Arc::default(),
        };
        gpu.when_lost(|_| ());
        let (lost, trouble) = (gpu.lost.clone(), gpu.trouble.clone());
        // Errors are caught in scopes; one that slips through must not end the program, but whoever waits for
        // the picture is told. All that is made on a lost device is invalid, as wgpu says at each use, and
        // that is no news; nor is what follows from the first error.
        gpu.device.on_uncaptured_error(Arc::new(move |error: wgpu::Error| {
            if !lost.load(Ordering::Relaxed) {
                let told = GpuError::Refused(match error {
                    wgpu::Error::OutOfMemory { .. } => "it does not have enough memory".into(),
                    other => other.to_string(),
                });
                trouble.lock().expect("no holder panics").get_or_insert(told);
            }
        }));
        Ok(gpu)
    }

    /// Calls `told` from another thread, with the reason, when the device is gone, and what was made on it.
    pub fn when_lost(&self, told: impl Fn(String) + Send + 'static) {
        let lost = self.lost.clone();
        self.device.set_device_lost_callback(move |_, why| {
            lost.store(true, Ordering::Relaxed);
            told(why);
        });
    }

    /// Whether the device is gone.
    pub fn is_lost(&self) -> bool {
        self.lost.load(Ordering::Relaxed)
    }

    /// Ends the device as a driver does that gives up.
    pub fn lose(&self) {
        // Other threads may fail over it before they hear of it.
        self.lost.store(true, Ordering::Relaxed);
        self.device.destroy();
        // A device reports only while it is polled.
        let _ = self.device.poll(wgpu::PollType::Poll);
    }

    /// Whether the adapter is the processor itself.
    pub fn is_software(&self) -> bool {
        self.adapter.get_info().device_type == wgpu::DeviceType::Cpu
    }

    /// "llvmpipe (LLVM 15.0.6, 256 bits), Vulkan"
    pub fn describe(&self) -> String {
        let info = self.adapter.get_info();
        format!("{}, {}", info.name, info.backend)
    }

    /// How many scene shaders and pipelines were made on this device so far, one of each at a time.
    pub fn pipelines_made(&self) -> u32 {
        self.made.load(Ordering::Relaxed)
    }

    pub(super) fn count_pipeline(&self) {
        self.made.fetch_add(1, Ordering::Relaxed);
    }

    /// # Errors
    /// What went wrong since somebody last asked: most often there is too little memory.
    pub(super) fn check(&self) -> Result<(), GpuError> {
        self.trouble.lock().expect("no holder panics").take().map_or(Ok(()), Err)
    }

    /// Waits until all submitted work is done.
    ///
    /// # Errors
    /// Where something went wrong meanwhile, or the device stops to answer.
    pub fn wait(&self) -> Result<(), GpuError> {
        self.check()?;
        let patience = if self.is_software() { PATIENCE_WITH_SOFTWARE } else { PATIENCE };
        let wait = wgpu::PollType::Wait { submission_index: None, timeout: Some(patience) };
        self.device.poll(wait).map(drop).map_err(|error| match error {
            wgpu::PollError::Timeout if self.is_software() => GpuError::Refused(format!(
                "{} minutes were not enough to compile and draw; a driver that runs on the processor takes \
                 long where a scene has many objects or parts: take a GPU, or leave some of them out",
                patience.as_secs() / 60
            )),
            wgpu::PollError::Timeout => GpuError::Lost(format!("not within {} s", patience.as_secs())),
            other => GpuError::Lost(other.to_string()),
        })
    }

    /// The bytes of a texture whose texels have `texel_bytes`, by rows from the top.
    pub(super) fn read_texture(
        &self,
        texture: &wgpu::Texture,
        texel_bytes: u32,
    ) -> Result<Vec<u8>, GpuError> {
        let row = texture.width() * texel_bytes;
        let padded = row.next_multiple_of(wgpu::COPY_BYTES_PER_ROW_ALIGNMENT);
        let most =
            (self.device.limits().max_buffer_size / u64::from(padded)).min(u64::from(texture.height()));
        let mut texels = vec![];
        for first in (0..texture.height()).step_by(most as usize) {
            let height = (texture.height() - first).min(most as u32);
            let encoder = self.device.create_command_encoder(&Default::default());
            let bytes =
                self.read_back(encoder, u64::from(padded) * u64::from(height), |encoder, buffer| {
                    let mut rows = texture.as_image_copy();
                    rows.origin.y = first;
                    let layout = wgpu::TexelCopyBufferLayout {
                        offset: 0,
                        bytes_per_row: Some(padded),
                        rows_per_image: None,
                    };
                    encoder.copy_texture_to_buffer(
                        rows,
                        wgpu::TexelCopyBufferInfo { buffer, layout },
                        wgpu::Extent3d { width: texture.width(), height, depth_or_array_layers: 1 },
                    );
                })?;
            bytes.chunks_exact(padded as usize).for_each(|r| texels.extend_from_slice(&r[..row as usize]));
        }
        Ok(texels)
    }

    /// Submits what `encoder` holds and, last, what `copy` adds; returns the bytes that it copies.
    pub(super) fn read_back(
        &self,
        mut encoder: wgpu::CommandEncoder,
        size: u64,
        copy: impl FnOnce(&mut wgpu::CommandEncoder, &wgpu::Buffer),
    ) -> Result<Vec<u8>, GpuError> {
        let buffer = self.device.create_buffer(&wgpu::BufferDescriptor {
            label: Some("read back"),
            size,
            usage: wgpu::BufferUsages::COPY_DST | wgpu::BufferUsages::MAP_READ,
            mapped_at_creation: false,
        });
        copy(&mut encoder, &buffer);
        self.queue.submit([encoder.finish()]);
        let (sender, receiver) = std::sync::mpsc::channel();
        buffer.slice(..).map_async(wgpu::MapMode::Read, move |result| {
            let _ = sender.send(result);
        });
        self.wait()?;
        let lost = |why: String| GpuError::Lost(why);
        // Another thread that waits too may have taken this news, and be about to report it.
        let mapped = receiver.recv_timeout(PATIENCE).map_err(|e| lost(e.to_string()))?;
        mapped.map_err(|e| lost(e.to_string()))?;
        let bytes = buffer.slice(..).get_mapped_range().map_err(|e| lost(e.to_string()))?;
        Ok(bytes.to_vec())
    }
}
