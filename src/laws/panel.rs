//! Calls of textures, and their values at many points, which a probe finds.

use glam::{Vec2, Vec3};

use super::{Problem, World};
use crate::compile::Compiled;
use crate::frame::Moment;
use crate::gpu::{Gpu, Probe, SurfacePoint};
use crate::wgsl::Mode;

/// Calls that are asked for their values.
pub struct Panel {
    compiled: Compiled,
    probe: Probe,
    calls: usize,
}

/// The picture that pixels are said to be of, for textures that ask.
pub const SIZE: [u32; 2] = [480, 270];

impl Panel {
    /// # Errors
    /// What is wrong with the calls or their files, or why the GPU refuses them.
    pub fn new(gpu: &Gpu, world: &World, calls: &[String], mode: Mode) -> Result<Self, Problem> {
        let compiled = world.compiled(&objects(calls), mode, None)?;
        let probe = Probe::build(gpu, &compiled, &Moment::of(&compiled.scene), SIZE)?;
        Ok(Self { compiled, probe, calls: calls.len() })
    }

    /// Takes the numbers of other calls. Where they differ in more than numbers, a probe is made anew.
    ///
    /// # Errors
    /// As with [`Panel::new`].
    pub fn renumber(&mut self, gpu: &Gpu, world: &World, calls: &[String]) -> Result<(), Problem> {
        let next = world.compiled(&objects(calls), Mode::Live, Some(&self.compiled))?;
        if next.source.sections == self.compiled.source.sections {
            self.probe.upload(&next.source.numbers);
            self.compiled = next;
            return Ok(());
        }
        *self = Self::new(gpu, world, calls, Mode::Live)?;
        Ok(())
    }

    /// What each call gives at each point.
    ///
    /// # Errors
    /// Where the device stops to answer.
    pub fn values(&self, points: &[SurfacePoint]) -> Result<Vec<Vec<Vec3>>, Problem> {
        let of = |object| points.iter().map(move |point| SurfacePoint { object, ..*point });
        let asked: Vec<SurfacePoint> = (0..self.calls as u32).flat_map(of).collect();
        let looks = self.probe.materials(&asked)?;
        Ok(looks.chunks(points.len()).map(|looks| looks.iter().map(|look| look.emission).collect()).collect())
    }
}

/// Object i emits the value of the i-th call.
fn objects(calls: &[String]) -> String {
    calls.iter().map(|call| format!("    Sphere(material: (emission: {call})),\n")).collect()
}

/// A point of a floor: uv is (x, z).
pub fn on_floor(position: Vec3, footprint: f32) -> SurfacePoint {
    let uv = Vec2::new(position.x, position.z);
    SurfacePoint { object: 0, position, normal: Vec3::Y, uv, world: position, footprint }
}
