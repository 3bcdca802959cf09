//! The window.
use std::path::PathBuf;
pub struct Options {
    pub scene: PathBuf,
    pub size: [u32; 2],
    pub adapter: crate::gpu::AdapterChoice,
}
#[derive(serde::Serialize)]
pub enum Event {}
pub fn run(_o: Options, _e: &dyn Fn(&Event)) -> Result<(), String> {
    Ok(())
}
