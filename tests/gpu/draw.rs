//! A picture of a scene, for the tests that look at one.

use raytoy::Compiled;
use raytoy::frame::{Moment, View};
use raytoy::gpu::{Gpu, Picture, render};

/// One sample of `compiled`, as its own camera sees it.
pub fn picture(gpu: &Gpu, compiled: &Compiled, size: [u32; 2], view: View) -> Picture {
    let moment = Moment { view, ..Moment::of(&compiled.scene) };
    render(gpu, compiled, &moment, size, 1, &mut |_| ())
        .unwrap_or_else(|e| panic!("{}: {e}", compiled.scene.name))
}
