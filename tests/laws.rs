//! Laws that each texture of the library keeps, whatever its arguments: its values are finite, in their range,
//! the same each time and in both number modes; a filter begins with the hard pattern and ends in one color.

mod common;
mod patterns;

use std::collections::BTreeMap;
use std::sync::Arc;

use common::expect_none;
use glam::Vec3;
use patterns::{
    Panel, Random, World, by_devices, call, on_floor, random_argument, stand_in, texture_argument,
};
use raytoy::gpu::{Gpu, SurfacePoint};
use raytoy::library::{Function, Kind};
use raytoy::wgsl::Mode;

/// Textures of one scene. The software driver computes all of them for each point, so few are faster.
const AT_ONCE: usize = 4;
/// What each texture is given, one after the other.
const SETS: [Set; 6] =
    [Set::Defaults, Set::Random(0), Set::Random(1), Set::Random(2), Set::Random(3), Set::Textures];
/// One after the other, on all points.
const FOOTPRINTS: [f32; 5] = [0.0, 1e-3, 0.1, 1.0, 100.0];

/// Rounding may carry a value this far out of its range.
const RANGE_TOLERANCE: f32 = 1e-4;
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
const MOST_DEVIATION: f32 = 0.03;

/// The arguments of a texture.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Set {
    Defaults,
    /// Anything within their ranges.
    Random(u64),
    /// Other textures, where a color is wanted or a number from 0 to 1.
    Textures,
}

#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
enum Law {
    IsFinite,
    StaysInRange,
    IsTheSameAgain,
    IsTheSameLiveAndBaked,
    IsHardUpClose,
    IsEvenFromAfar,
}

#[test]
fn textures_keep_the_laws() {
    let Some(broken) = check_all(&World::default()) else { return };
    expect_none(broken.into_values());
}

#[test]
fn each_law_can_be_broken() {
    let wrong = [
        ("infinite", "return 1.0 / (at.position.x - at.position.x);", Law::IsFinite),
        ("boundless", "return at.uv.x;", Law::StaysInRange),
        ("rough", "return fract(at.position.x * a * 1.7 * a * 1e5);", Law::IsTheSameLiveAndBaked),
        ("jumpy", "return select(0.0, 1.0, at.footprint > 0.0);", Law::IsHardUpClose),
        ("harsh", "return fract(at.uv.x + 0.0 * at.footprint);", Law::IsEvenFromAfar),
    ];
    let files = wrong.map(|(name, body, _)| {
        let text = format!(
            "/// Wrong.\n///\n/// a = 1.3: a\nfn {name}(at: Surface, a: f32) -> f32 {{\n    {body}\n}}\n"
        );
        (format!("textures/{name}.wgsl"), text)
    });
    let world = World { files: files.into(), only: true };
    let Some(broken) = check_all(&world) else { return };
    for (name, _, law) in wrong {
        let name = raytoy::library::name_of(name);
        assert!(broken.contains_key(&(name.clone(), law)), "{name} keeps {law:?}; broken are {broken:#?}");
    }
    // No text makes a shader forgetful, so this law is asked by itself.
    let (values, again) = ([Vec3::ONE, Vec3::ZERO], [Vec3::ONE, -Vec3::ZERO]);
    assert!(same_bits(&values, &values).is_none());
    assert!(same_bits(&values, &again).is_some_and(|(i, _)| i == 1));
}

/// What is broken by which texture; nothing where there is no device.
fn check_all(world: &World) -> Option<BTreeMap<(String, Law), String>> {
    let subjects: Vec<Subject> = world.textures().iter().flat_map(subjects_of).collect();
    let groups: Vec<&[Subject]> = subjects.chunks(AT_ONCE).collect();
    let found = by_devices(&groups, |gpu, group| check(gpu, world, group))?;
    let mut broken = BTreeMap::new();
    for (name, law, what) in found.into_iter().flatten() {
        broken.entry((name, law)).or_insert(what);
    }
    Some(broken)
}

/// A texture of the library, a mapping behind another one.
struct Subject {
    function: Arc<Function>,
    behind: Option<&'static str>,
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

/// What breaks a law first, and in which point.
type Broken = Option<(usize, String)>;

fn check(gpu: &Gpu, world: &World, group: &[Subject]) -> Vec<(String, Law, String)> {
    let (everywhere, free) = (everywhere(), free());
    let with = |footprint| free.iter().map(|p| SurfacePoint { footprint, ..*p }).collect::<Vec<_>>();
    let calls = |set| group.iter().map(|subject| subject.call(set)).collect::<Vec<_>>();
    let mut live = Panel::new(gpu, world, &calls(Set::Defaults), Mode::Live);
    let mut found = vec![];
    for set in SETS {
        let calls = calls(set);
        match set {
            Set::Textures => live = Panel::new(gpu, world, &calls, Mode::Live),
            _ => live.renumber(world, &calls),
        }
        // It takes long to compile, so one set is enough.
        let baked = (set == Set::Defaults).then(|| Panel::new(gpu, world, &calls, Mode::Baked));
        let values = live.values(&everywhere);
        let again = live.values(&everywhere);
        let literal = baked.map(|baked| baked.values(&everywhere));
        let [hard, soft, wide] = [0.0, NARROW, WIDE].map(|footprint| live.values(&with(footprint)));
        for (n, (subject, call)) in group.iter().zip(&calls).enumerate() {
            let mut note = |law, points: &[SurfacePoint], broken: Broken| {
                let Some((i, what)) = broken else { return };
                let SurfacePoint { position, normal, footprint, .. } = points[i];
                let name = subject.function.name.clone();
                let place = format!("position {position}, normal {normal}, footprint {footprint:e}");
                let told = format!("{name} breaks {law:?}: {call} at {place} is {what}");
                found.push((name, law, told));
            };
            let values = &values[n];
            note(Law::IsFinite, &everywhere, finite(values));
            note(Law::IsFinite, &with(NARROW), finite(&soft[n]));
            note(Law::IsFinite, &with(WIDE), finite(&wide[n]));
            note(Law::StaysInRange, &everywhere, in_range(values, subject.range()));
            note(Law::IsTheSameAgain, &everywhere, same_bits(values, &again[n]));
            if let Some(literal) = &literal {
                let is_near = |i: usize| everywhere[i].position.abs().max_element() <= FAR;
                let broken = alike(values, &literal[n], STEP, 1.0 - LEAST_AGREEMENT, is_near);
                note(Law::IsTheSameLiveAndBaked, &everywhere, broken);
            }
            if subject.function.text.contains("footprint") {
                let broken = alike(&hard[n], &soft[n], HARD_TOLERANCE, 1.0 - LEAST_HARD, |_| true);
                note(Law::IsHardUpClose, &with(NARROW), broken);
                note(Law::IsEvenFromAfar, &with(WIDE), even(&wide[n]));
            }
        }
    }
    found
}

fn finite(values: &[Vec3]) -> Broken {
    first(values.len(), 0.0, |i| !values[i].is_finite(), |i| values[i].to_string())
}

fn in_range(values: &[Vec3], (low, high): (f32, f32)) -> Broken {
    let (low, high) = (low - RANGE_TOLERANCE, high + RANGE_TOLERANCE);
    let is_out = |v: Vec3| v.is_finite() && (v.min_element() < low || v.max_element() > high);
    first(values.len(), 0.0, |i| is_out(values[i]), |i| values[i].to_string())
}

fn same_bits(one: &[Vec3], two: &[Vec3]) -> Broken {
    let bits = |v: Vec3| v.to_array().map(f32::to_bits);
    let both = |i: usize| format!("{} and {}", one[i], two[i]);
    first(one.len(), 0.0, |i| bits(one[i]) != bits(two[i]), both)
}

/// Equal to `tolerance` where they `count`, but for a share `most` of those.
fn alike(one: &[Vec3], two: &[Vec3], tolerance: f32, most: f64, counts: impl Fn(usize) -> bool) -> Broken {
    // What is not finite is another law's.
    let differs = |i: usize| (one[i] - two[i]).abs().max_element() > tolerance;
    let counted = (0..one.len()).filter(|i| counts(*i)).count() as f64;
    let most = most * counted / one.len() as f64;
    first(one.len(), most, |i| counts(i) && differs(i), |i| format!("{} and {}", one[i], two[i]))
}

fn even(values: &[Vec3]) -> Broken {
    let count = values.len() as f32;
    let mean = values.iter().sum::<Vec3>() / count;
    let square = values.iter().map(|v| (*v - mean) * (*v - mean)).sum::<Vec3>() / count;
    let deviation = square.max_element().sqrt();
    let off = |i: usize| (values[i] - mean).length();
    let farthest = (0..values.len()).max_by(|a, b| off(*a).total_cmp(&off(*b)))?;
    let what = || format!("{}, the mean {mean}, the standard deviation {deviation}", values[farthest]);
    (deviation > MOST_DEVIATION).then(|| (farthest, what()))
}

/// The first of `count` points that is wrong, if more than a share `most` is, with what there is to tell.
fn first(
    count: usize,
    most: f64,
    is_wrong: impl Fn(usize) -> bool,
    tell: impl Fn(usize) -> String,
) -> Broken {
    let wrong: Vec<usize> = (0..count).filter(|i| is_wrong(*i)).collect();
    let i = *wrong.first()?;
    let too_many = wrong.len() as f64 > most * count as f64;
    too_many.then(|| (i, format!("{}, and {} of {count} points are wrong", tell(i), wrong.len())))
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
