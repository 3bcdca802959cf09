//! The library's textures and shapes for the tests that ask laws of them, and two devices to ask.
// Each binary uses a part of it.

use crate::device;
use std::path::Path;
use std::sync::Arc;

use raytoy::gpu::{AdapterChoice, Gpu, SurfacePoint};
use raytoy::laws::{Panel, World};
use raytoy::library::{Family, Function, Library};
use raytoy::suite;

/// What ships with raytoy, and nothing else.
pub fn built_in() -> World {
    World::default()
}

/// All that a world has of a family, sorted by name.
pub fn functions(world: &World, family: Family) -> Vec<Arc<Function>> {
    let sources = world.sources();
    let library = Library::new(&sources, Path::new(""));
    let find =
        |name: &String| library.find(family, name).unwrap_or_else(|problems| panic!("{name}: {problems:?}"));
    library.names(family).iter().map(find).collect()
}

/// Calls `work` for each of `jobs` on two devices. Nothing where there is none.
pub fn by_devices<J: Sync, R: Send>(jobs: &[J], work: impl Fn(&Gpu, &J) -> R + Sync) -> Option<Vec<R>> {
    Some(suite::by_devices(&devices()?, jobs, work, &mut |_| ()))
}

/// The device of all tests, and one of the software driver. Nothing where there is none.
pub fn devices() -> Option<[Gpu; 2]> {
    let first = device::gpu()?;
    let second = Gpu::headless(&AdapterChoice::Software).expect("there is one, so there are two");
    Some([first.clone(), second])
}

/// What the only call of `panel` gives at each point.
pub fn values(panel: &Panel, points: &[SurfacePoint]) -> Vec<glam::Vec3> {
    panel.values(points).unwrap_or_else(|problem| panic!("{problem}")).remove(0)
}
