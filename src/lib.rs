//! raytoy: procedural, ray-traced scenes from RON to WGSL to a picture, live.
//!
//! A scene goes down the rooms of this crate, and a room knows only those above it:
//!
//! ```text
//! RON text ─► scene::Value ─► ir::Scene ─► wgsl::Source ─► module::Module ─► gpu::Pipeline ─► gpu::Picture
//!            parse           resolve      generate        validate          build            draw
//! ```
//!
//! [`compile()`] is the front door to all that needs no GPU:
//!
//! ```
//! use raytoy::{compile, sources::Sources, wgsl::Mode};
//!
//! let sources = Sources::in_memory().with("ball.ron", "(objects: [Sphere(radius: 2)])");
//! let outcome = compile(&sources, "ball.ron".as_ref(), Mode::Baked, None);
//! assert!(outcome.compiled.unwrap().source.generated().contains("fn rayTraceScene"));
//! ```

pub mod assets;
pub mod bindings;
mod bvh;
pub mod capture;
pub mod cli;
pub mod compile;
pub mod diagnostic;
pub mod difference;
pub mod edit;
pub mod engine;
pub mod export;
mod files;
pub mod frame;
pub mod gpu;
pub mod ir;
pub mod judge;
pub mod laws;
pub mod library;
pub mod module;
pub mod outline;
pub mod panel;
pub mod scene;
pub mod sketch;
pub mod sources;
mod stage;
pub mod suite;
pub mod watch;
pub mod wgsl;
pub mod window;

pub use compile::{Compiled, Outcome, Times, compile, on_deep_stack};
