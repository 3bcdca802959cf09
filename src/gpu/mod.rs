//! The GPU: a device, a scene's pipeline, a picture that gathers samples, and what a screen shows of it.
//!
//! In: [`crate::compile::Compiled`]. Out: pixels, or from a [`Probe`] single values. The only room that knows
//! wgpu, the window's surface aside.

mod adapters;
mod assets;
mod batches;
mod device;
mod display;
mod error;
pub mod gizmo;
mod guard;
mod identity;
mod image;
mod layouts;
mod lines;
mod pace;
pub mod parts;
mod pipeline;
mod probe;
mod region;
mod slices;
mod tracer;

pub use adapters::{AdapterChoice, ask_no_absent_display};
pub use device::{Gpu, prefer_quick_compiles};
pub use display::{Display, LitColumns, Target};
pub use error::GpuError;
pub use identity::{Identity, Seen, Survey};
pub use image::{MAX_SIDE, Picture, PictureTimes, Renderer, render};
pub use lines::{Line, Lines};
pub use pace::Pace;
pub use pipeline::Pipeline;
pub use probe::{Crossing, MaterialSample, Probe, Ray, SurfacePoint};
pub use region::Region;
pub use slices::SMALL;
pub use tracer::Tracer;
