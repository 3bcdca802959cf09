//! A first, coarse picture of a scene by the processor alone, while a driver is still compiling.
//!
//! In: the module that the driver gets, too. Out: the pixels that it would draw. The module becomes a list of
//! steps, each of which is taken for a square of pixels at once; so no machine code is made, and a picture of
//! some ten thousand pixels is there in less time than most drivers take to compile.

pub mod canary;
mod images;

use std::sync::atomic::{AtomicU32, Ordering};
use std::sync::{Arc, Mutex};
use std::time::{Duration, Instant};

pub use raytoy_vm::Unsupported;
use raytoy_vm::{Inputs, Machine, Program, SIDE, lower};

use self::images::Images;
use crate::assets::Model;
use crate::compile::Compiled;
use crate::frame::FrameUniforms;

/// A prime near 2^32 over the golden ratio: in steps of it, the first squares already are from everywhere.
const SCATTER: u64 = 2_654_435_761;

/// Enough for as many blocks in each other as naga takes.
const STACK_BYTES: usize = 16 << 20;

/// Larger models take longer to bring here than a sketch is worth.
const MAX_TEXELS: usize = 1 << 20;

/// A scene that the processor can draw.
#[derive(Clone, Debug)]
pub struct Sketch {
    program: Arc<Program>,
    images: Arc<Images>,
    numbers: Arc<[f32]>,
    /// Whether it can show debug views.
    pub has_views: bool,
}

/// A sketch that was given up: how long it would have taken, as far as that is known.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct TooSlow(pub Duration);

impl Sketch {
    /// # Errors
    /// Where the module has something that only a driver can do; no file that ships with raytoy has.
    pub fn new(compiled: &Compiled) -> Result<Self, Unsupported> {
        if compiled.scene.models.iter().map(Model::texels).sum::<usize>() > MAX_TEXELS {
            return Err(Unsupported::of("models of so many triangles"));
        }
        let (module, info) = (compiled.module.naga(), compiled.module.info());
        let program = lower(module, info, "tracePixel")?;
        Ok(Self {
            program: Arc::new(program),
            images: Images::of(&compiled.scene).into(),
            numbers: compiled.source.numbers.as_slice().into(),
            has_views: compiled.source.target.views,
        })
    }

    /// The light and the depth of each pixel, row by row from the top.
    ///
    /// # Errors
    /// Where that would take longer than `patience`, which is known after a part of that time.
    pub fn draw(&self, frame: &FrameUniforms, patience: Duration) -> Result<Vec<[f32; 4]>, TooSlow> {
        let [width, height] = frame.resolution.map(|n| n as u32);
        let [columns, rows] = [width, height].map(|n| n.div_ceil(SIDE as u32));
        let begun = Instant::now();
        let images = self.images.bound();
        let inputs = Inputs {
            frame: bytemuck::cast_slice(std::slice::from_ref(frame)),
            numbers: bytemuck::cast_slice(&self.numbers),
            images: &images,
            until: begun + patience,
        };
        let squares = columns * rows;
        let picture = Mutex::new(vec![[0.0; 4]; (width * height) as usize]);
        let (begins, ended) = (AtomicU32::new(0), AtomicU32::new(0));
        let draw = || {
            let mut machine = Machine::new(&self.program, inputs);
            loop {
                let number = begins.fetch_add(1, Ordering::Relaxed);
                if number >= squares {
                    return;
                }
                let square = (u64::from(number) * SCATTER % u64::from(squares)) as u32;
                let corner = [square % columns, square / columns].map(|n| n * SIDE as u32);
                let Ok(pixels) = machine.square(corner) else { return };
                let mut picture = picture.lock().expect("no thread panics");
                for (i, pixel) in pixels.into_iter().enumerate() {
                    let [x, y] = [corner[0] + (i % SIDE) as u32, corner[1] + (i / SIDE) as u32];
                    if x < width && y < height {
                        picture[(y * width + x) as usize] = pixel;
                    }
                }
                drop(picture);
                let share = f64::from(ended.fetch_add(1, Ordering::Relaxed) + 1) / f64::from(squares);
                let time = begun.elapsed();
                if time > patience / 6 && time.as_secs_f64() > patience.as_secs_f64() * share {
                    return;
                }
            }
        };
        let threads = std::thread::available_parallelism().map_or(1, usize::from);
        std::thread::scope(|scope| {
            let thread = |_| std::thread::Builder::new().stack_size(STACK_BYTES).spawn_scoped(scope, draw);
            (0..threads).map_while(|i| thread(i).ok()).for_each(drop);
        });
        let ended = ended.into_inner();
        if ended == squares {
            return Ok(picture.into_inner().expect("no thread panics"));
        }
        // No square may have ended.
        let share = f64::from(ended.max(1)) / f64::from(squares);
        Err(TooSlow(begun.elapsed().div_f64(share)))
    }
}
