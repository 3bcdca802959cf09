//! Textures: their values are finite, in their range, the same each time and in both number modes; a filter
//! begins with the hard pattern and ends in one color.

use std::sync::Arc;

use glam::Vec3;

use super::arguments::{call, random_argument, stand_in, texture_argument};
use super::values::{Found, alike, even, finite, in_range, same_bits};
use super::{Broken, Law, Panel, Problem, Random, World, on_floor};
use crate::gpu::{Gpu, SurfacePoint};
use crate::library::{Function, Kind};
use crate::wgsl::Mode;

/// What each texture is given, one after the other.
const SETS: [Set; 6] =
    [Set::Defaults, Set::Random(0), Set::Random(1), Set::Random(2), Set::Random(3), Set::Textures];
/// One after the other, on all points.
const FOOTPRINTS: [f32; 5] = [0.0, 1e-3, 0.1, 1.0, 100.0];

/// A step of a channel: less cannot be seen.
const STEP: f32 = 1.0 / 255.0;
/// The share of points in which live and baked numbers agree to a step.
const LEAST_AGREEMENT: f64 = 0.999;
/// That far out they agree: the driver multiplies literals beforehand, and farther out the last digit of a
/// coordinate is a step of a fine pattern.
const FAR: f32 = 1e3;
/// The share of points that a filter of next to no width leaves as they are. Others may lie on an edge.
const LEAST_HARD: f64 = 0.99;
const NARROW: f32 = 1e-6;
/// The difference of two places that are next to no width apart has few digits.
const HARD_TOLERANCE: f32 = 5.0 * STEP;
/// Where this many scene units are one pixel, the pixels differ by this at most.
const WIDE: f32 = 1e4;
const MAX_DEVIATION: f32 = 0.03;

/// The arguments of a texture.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Set {
    Defaults,
    /// Anything within their ranges.
    Random(u64),
    /// Other textures, where a color is wanted or a number from 0 to 1.
    Textures,
}

/// A texture of the library, a mapping behind another one.
struct Subject {
    function: Arc<Function>,
    behind: Option<&'static str>,
}

/// The laws that textures break, asked together: a driver compiles them sooner in one shader.
///
/// # Errors
/// What is wrong with their files, or why the GPU refuses them.
pub fn check_textures(gpu: &Gpu, world: &World, functions: &[Arc<Function>]) -> Result<Vec<Broken>, Problem> {
    let group: Vec<Subject> = functions.iter().flat_map(subjects_of).collect();
    let (everywhere, free) = (everywhere(), free());
    let with = |footprint| free.iter().map(|p| SurfacePoint { footprint, ..*p }).collect::<Vec<_>>();
    let calls = |set| group.iter().map(|subject| subject.call(set)).collect::<Vec<_>>();
    let mut live = Panel::new(gpu, world, &calls(Set::Defaults), Mode::Live)?;
    let mut found = vec![];
    for set in SETS {
        let calls = calls(set);
        live.renumber(gpu, world, &calls)?;
        let values = live.values(&everywhere)?;
        let again = live.values(&everywhere)?;
        // It takes long to compile, so one set is enough.
        let literal = match set {
            Set::Defaults => Some(Panel::new(gpu, world, &calls, Mode::Baked)?.values(&everywhere)?),
            _ => None,
        };
        let [hard, soft, wide] = [0.0, NARROW, WIDE].map(|footprint| live.values(&with(footprint)));
        let (hard, soft, wide) = (hard?, soft?, wide?);
        for (n, (subject, call)) in group.iter().zip(&calls).enumerate() {
            let mut note = |law, points: &[SurfacePoint], what: Found| {
                let Some((i, what)) = what else { return };
                let SurfacePoint { position, normal, footprint, .. } = points[i];
                let place = format!("position {position}, normal {normal}, footprint {footprint:e}");
                let name = subject.function.name.clone();
                found.push(Broken { name, law, example: format!("{call} at {place} is {what}") });
            };
            let values = &values[n];
            note(Law::IsFinite, &everywhere, finite(values));
            note(Law::IsFinite, &with(NARROW), finite(&soft[n]));
            note(Law::IsFinite, &with(WIDE), finite(&wide[n]));
            note(Law::StaysInRange, &everywhere, in_range(values, subject.range()));
            note(Law::IsTheSameAgain, &everywhere, same_bits(values, &again[n]));
            if let Some(literal) = &literal {
                let is_near = |i: usize| everywhere[i].position.abs().max_element() <= FAR;
                let what = alike(values, &literal[n], STEP, 1.0 - LEAST_AGREEMENT, is_near);
                note(Law::IsTheSameLiveAndBaked, &everywhere, what);
            }
            if subject.function.text.contains("footprint") {
                let what = alike(&hard[n], &soft[n], HARD_TOLERANCE, 1.0 - LEAST_HARD, |_| true);
                note(Law::IsHardUpClose, &with(NARROW), what);
                note(Law::IsEvenFromAfar, &with(WIDE), even(&wide[n], MAX_DEVIATION));
            }
        }
    }
    Ok(found)
}

fn subjects_of(function: &Arc<Function>) -> Vec<Subject> {
    let subject = |behind| Subject { function: function.clone(), behind };
    if function.kind == Kind::Mapping {
        return vec![subject(Some("Checker")), subject(Some("Noise"))];
    }
    vec![subject(None)]
}

impl Subject {
    /// The seed is the name, so that no texture changes the arguments of another.
    fn call(&self, set: Set) -> String {
        let name = self.function.name.bytes();
        let seed = name.fold(7, |hash: u64, byte| hash.wrapping_mul(31) ^ u64::from(byte));
        let mut random = Random(seed ^ if let Set::Random(n) = set { n << 40 } else { 0 });
        let own = call(&self.function, |parameter| match (parameter.default, set) {
            (None, _) => Some(stand_in(parameter)),
            (Some(_), Set::Defaults) => None,
            (Some(_), Set::Random(_)) => Some(random_argument(parameter, &mut random)),
            (Some(_), Set::Textures) => texture_argument(parameter, &mut random),
        });
        self.behind.map_or(own.clone(), |behind| format!("{behind}(at: {own})"))
    }

    /// What its values lie between: `/// gives LOW to HIGH` in its file, else 0 and 1.
    fn range(&self) -> (f32, f32) {
        let line = self.function.text.lines().find_map(|line| line.strip_prefix("/// gives "));
        let ends = line.filter(|_| self.behind.is_none()).and_then(|line| line.split_once(" to "));
        let number = |text: &str| text.trim().parse().ok();
        ends.and_then(|(low, high)| Some((number(low)?, number(high)?))).unwrap_or((0.0, 1.0))
    }
}

/// Each footprint on 4000 points: half lie nowhere in particular, half on corners and edges of a lattice.
fn everywhere() -> Vec<SurfacePoint> {
    const POINTS: usize = 4000;
    let mut random = Random(1);
    let place = |i: usize| {
        let place = 10_f32.powf(7.0 * random.unit() - 3.0) * random.vector();
        let bits = Vec3::new(((i >> 3) & 1) as f32, ((i >> 4) & 1) as f32, ((i >> 5) & 1) as f32);
        let place = match i % 8 {
            0 => place.round(),
            1 => (2.0 * place).round() / 2.0,
            2 => (10.0 * random.vector()).round(),
            // On the axes and their planes, and in the origin.
            3 => place * bits,
            _ => place,
        };
        SurfacePoint { normal: random.vector().normalize_or(Vec3::Y), ..on_floor(place, 0.0) }
    };
    let points: Vec<SurfacePoint> = (0..POINTS).map(place).collect();
    let with = |footprint| points.iter().map(move |point| SurfacePoint { footprint, ..*point });
    FOOTPRINTS.into_iter().flat_map(with).collect()
}

/// Points near the origin, but not so near that what has its middle there is seen under a lens.
fn free() -> Vec<SurfacePoint> {
    let mut random = Random(2);
    let place = |_| {
        let place = 10_f32.powf(2.0 * random.unit() - 1.0) * random.vector().normalize_or(Vec3::Y);
        SurfacePoint { normal: random.vector().normalize_or(Vec3::Y), ..on_floor(place, 0.0) }
    };
    (0..2000).map(place).collect()
}
