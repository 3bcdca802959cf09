//! A shape before a probe: where it lies, and all that rays cross on their way.

use glam::Vec3;

use super::{Problem, Random, World, panel};
use crate::frame::Moment;
use crate::gpu::{Crossing, Gpu, Probe, Ray};
use crate::wgsl::Mode;

/// A shape that rays are sent to.
pub struct Target {
    probe: Probe,
    /// A ball around what is looked at.
    pub middle: Vec3,
    pub radius: f32,
}

/// Rays of the first look, from all sides, at balls of all sizes around the origin.
const SCOUTS: usize = 3000;
/// Of what goes on without end, this much is looked at.
const ENDLESS_RADIUS: f32 = 2.0;
/// Crossings that one ray is followed over.
pub const MAX_CROSSINGS: usize = 12;
/// The next crossing is looked for this far behind the last, in radii and in lengths of the way.
const STEP: f32 = 1e-4;

impl Target {
    /// The shape of `call`, found by rays; None where none meets it.
    ///
    /// # Errors
    /// What is wrong with the call or its file, or why the GPU refuses it.
    pub fn new(
        gpu: &Gpu,
        world: &World,
        call: &str,
        mode: Mode,
        is_endless: bool,
    ) -> Result<Option<Self>, Problem> {
        let compiled = world.compiled(call, mode, None)?;
        let probe = Probe::build(gpu, &compiled, &Moment::of(&compiled.scene), panel::SIZE)?;
        let mut random = Random(11);
        let scout = |_: usize| {
            let aim = random.vector() * 10_f32.powf(3.0 * random.unit() - 2.0);
            let direction = random.direction();
            Ray { origin: aim - 100.0 * direction, t_min: 0.0, direction, t_max: 1e30 }
        };
        let scouts: Vec<Ray> = (0..SCOUTS).map(scout).collect();
        let met = probe.rays(&scouts)?;
        let places: Vec<Vec3> =
            met.iter().flatten().map(|hit| hit.position).filter(|p| p.is_finite()).collect();
        if places.is_empty() {
            return Ok(None);
        }
        let low = places.iter().copied().fold(Vec3::INFINITY, Vec3::min);
        let high = places.iter().copied().fold(Vec3::NEG_INFINITY, Vec3::max);
        let (middle, radius) = match is_endless {
            // The nearest that was met: of a plane, its point by the origin.
            true => (places.into_iter().min_by(|a, b| a.length().total_cmp(&b.length())), ENDLESS_RADIUS),
            false => (Some(0.5 * (low + high)), 0.5 * (high - low).length()),
        };
        Ok(middle.map(|middle| Self { probe, middle, radius }))
    }

    /// A ray from outside at somewhere in the ball.
    pub fn ray(&self, random: &mut Random) -> Ray {
        let aim = self.middle + self.radius * random.unit().cbrt() * random.direction();
        let origin = self.middle + 3.0 * self.radius * random.direction();
        Ray { origin, t_min: 0.0, direction: (aim - origin).normalize(), t_max: 1e30 }
    }

    /// Where rays meet the shape first.
    pub fn first(&self, rays: &[Ray]) -> Result<Vec<Option<Crossing>>, Problem> {
        Ok(self.probe.rays(rays)?)
    }

    /// All that each ray crosses, [`MAX_CROSSINGS`] at most.
    pub fn all(&self, rays: &[Ray]) -> Result<Vec<Vec<Crossing>>, Problem> {
        let mut ways: Vec<Vec<Crossing>> = vec![vec![]; rays.len()];
        let mut going: Vec<usize> = (0..rays.len()).collect();
        for _ in 0..MAX_CROSSINGS {
            let next: Vec<Ray> = going
                .iter()
                .map(|i| Ray { t_min: ways[*i].last().map_or(0.0, |hit| self.behind(hit.t)), ..rays[*i] })
                .collect();
            let met = self.first(&next)?;
            let pairs: Vec<(usize, Crossing)> =
                going.iter().zip(met).filter_map(|(i, hit)| Some((*i, hit?))).collect();
            // A crossing that is no number leads nowhere.
            going = pairs.iter().filter(|(_, hit)| hit.t.is_finite()).map(|(i, _)| *i).collect();
            pairs.into_iter().for_each(|(i, hit)| ways[i].push(hit));
        }
        Ok(ways)
    }

    fn behind(&self, t: f32) -> f32 {
        t + STEP * self.radius
    }
}
