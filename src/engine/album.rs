//! Pictures and movies of the scene as files, drawn on a thread of their own while the author goes on.

use std::ops::ControlFlow;
use std::path::PathBuf;
use std::sync::Arc;
use std::sync::atomic::{AtomicBool, AtomicU32, Ordering};
use std::sync::mpsc::{Receiver, TryRecvError, channel};

use crate::capture::{CaptureError, Format, Frames, MovieFormat, Shot, movie, still};
use crate::compile::Compiled;
use crate::files::write_file;
use crate::frame::Moment;
use crate::gpu::Gpu;

/// What to take, and where to put it.
pub struct CaptureRequest {
    pub compiled: Arc<Compiled>,
    pub moment: Moment,
    pub size: [u32; 2],
    pub samples: u32,
    /// Of a movie.
    pub frames: Frames,
    pub path: PathBuf,
}

/// Takes one capture at a time.
pub struct Album {
    gpu: Gpu,
    /// Makes the window look again.
    wake: Arc<dyn Fn() + Send + Sync>,
    running: Option<Running>,
}

struct Running {
    /// Thousandths that are done.
    done: Arc<AtomicU32>,
    stops: Arc<AtomicBool>,
    result: Receiver<Result<String, String>>,
}

impl Album {
    pub fn new(gpu: Gpu, wake: impl Fn() + Send + Sync + 'static) -> Self {
        Self { gpu, wake: Arc::new(wake), running: None }
    }

    pub fn take(&mut self, order: CaptureRequest) {
        let (done, stops) = (Arc::new(AtomicU32::new(0)), Arc::new(AtomicBool::new(false)));
        let (sender, result) = channel();
        self.running = Some(Running { done: done.clone(), stops: stops.clone(), result });
        let (gpu, wake) = (self.gpu.clone(), self.wake.clone());
        std::thread::spawn(move || {
            let mut progress = |share: f32| {
                done.store((share * 1000.0) as u32, Ordering::Relaxed);
                wake();
                if stops.load(Ordering::Relaxed) { ControlFlow::Break(()) } else { ControlFlow::Continue(()) }
            };
            let result = order.carry_out(&gpu, &mut progress);
            let told = result.map(|()| format!("wrote {}", order.path.display()));
            // A window that was closed wants to know nothing.
            let _ = sender.send(told.map_err(|error| error.to_string()));
            wake();
        });
    }

    /// The share that is done of what is being taken.
    pub fn progress(&self) -> Option<f32> {
        self.running.as_ref().map(|running| running.done.load(Ordering::Relaxed) as f32 / 1000.0)
    }

    pub fn stop(&self) {
        if let Some(running) = &self.running {
            running.stops.store(true, Ordering::Relaxed);
        }
    }

    /// What came of a capture that has just ended.
    pub fn result(&mut self) -> Option<Result<String, String>> {
        let running = self.running.as_ref()?;
        let result = match running.result.try_recv() {
            Ok(result) => result,
            Err(TryRecvError::Empty) => return None,
            Err(TryRecvError::Disconnected) => Err("the capture has failed".into()),
        };
        self.running = None;
        Some(result)
    }
}

impl CaptureRequest {
    fn carry_out(
        &self,
        gpu: &Gpu,
        progress: &mut dyn FnMut(f32) -> ControlFlow<()>,
    ) -> Result<(), CaptureError> {
        let CaptureRequest { compiled, moment, size, samples, .. } = self;
        let shot = Shot { gpu, compiled, moment: *moment, size: *size, samples: *samples };
        if let Some(format) = MovieFormat::of(&self.path) {
            return movie(&shot, &self.frames, &self.path, format, progress).map(drop);
        }
        let Some(format) = Format::of(&self.path) else {
            return Err(CaptureError::Format("name a .png, .exr, .mp4, .webm or .gif file".into()));
        };
        let still = still(&shot, format, progress)?;
        let unwritten = |error| CaptureError::File(self.path.clone(), error);
        write_file(&self.path, &still.bytes).map_err(unwritten)
    }
}
