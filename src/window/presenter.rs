//! The thread that gives frames to the screen: a software driver draws them only then, and keeps its caller.

use std::panic::{AssertUnwindSafe, catch_unwind, resume_unwind};
use std::sync::mpsc::{Sender, channel};
use std::thread::JoinHandle;

use crate::gpu::Gpu;

/// Ends its thread where it is dropped, after the last frame.
pub struct Presenter {
    frames: Option<Sender<wgpu::SurfaceTexture>>,
    thread: Option<JoinHandle<()>>,
}

impl Presenter {
    /// `told` gets for each frame whether the screen shows it.
    pub fn start(gpu: Gpu, told: impl Fn(bool) + Send + 'static) -> Self {
        let (frames, receiver) = channel();
        let thread = std::thread::spawn(move || {
            for frame in receiver {
                if gpu.is_lost() {
                    let_go(frame);
                    continue;
                }
                // The device may be lost meanwhile, and then wgpu panics.
                told(catch_unwind(AssertUnwindSafe(|| gpu.queue.present(frame))).is_ok());
            }
        });
        Self { frames: Some(frames), thread: Some(thread) }
    }

    /// Nothing may be asked of the surface before `told` was called.
    pub fn present(&self, frame: wgpu::SurfaceTexture) {
        if let Some(frames) = &self.frames {
            let _ = frames.send(frame);
        }
    }
}

/// Drops a frame of a lost device. wgpu keeps it where a thread does not unwind, and panics over it when the
/// surface ends.
fn let_go(frame: wgpu::SurfaceTexture) {
    let _ = catch_unwind(AssertUnwindSafe(|| {
        let _frame = frame;
        resume_unwind(Box::new(()))
    }));
}

impl Drop for Presenter {
    fn drop(&mut self) {
        self.frames = None;
        if let Some(thread) = self.thread.take() {
            let _ = thread.join();
        }
    }
}
