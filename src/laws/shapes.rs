//! Shapes: crossings lie on the ray and on the surface, normals face who comes from outside, and what a ray
//! enters it leaves.

use std::sync::Arc;

use super::arguments::{call, nearby_argument};
use super::crossings::{MAX_CROSSINGS, Target};
use super::values::first;
use super::{Broken, Law, Problem, Random, World};
use crate::gpu::{Crossing, Gpu, Ray};
use crate::library::{Function, sample};
use crate::wgsl::Mode;

/// The arguments besides the defaults: so many sets near them.
const SETS: u64 = 2;
/// From outside, for each set.
const RAYS: usize = 2000;

/// How far the surface may lie from the crossing, in radii. A marched surface is not met to the last digit.
const SURFACE_TOLERANCE: f32 = 2e-3;
const LENGTH_TOLERANCE: f32 = 1e-3;
/// Rays that graze more than this, the cosine to the normal, are not asked whether they enter or leave.
const GRAZING: f32 = 0.02;
/// The share of rays in which a law may break: through an edge or a film that is thinner than a step.
const MAX_WRONG: f64 = 0.005;
/// The same where a shape is marched to, which may pass through what is thin.
const MAX_WRONG_MARCHED: f64 = 0.03;
/// The doc line of a shape whose normals do not separate inside from outside.
const ROUGH: &str = "/// has a rough surface";
/// The share of rays that numbers as data and as text may lead to different crossings.
const MAX_DIFFERENT: f64 = 0.005;

/// The laws that a shape breaks.
///
/// # Errors
/// What is wrong with its file, or why the GPU refuses it.
pub fn check_shape(gpu: &Gpu, world: &World, function: &Arc<Function>) -> Result<Vec<Broken>, Problem> {
    let mut random = Random(5);
    let mut found = vec![];
    for set in 0..=SETS {
        let mut index = 0;
        let written = match set {
            0 => sample::shape(function),
            _ => call(function, |parameter| {
                let required = parameter.default.is_none().then(|| {
                    index += 1;
                    sample::stand_in(parameter, index - 1)
                });
                required.or_else(|| nearby_argument(parameter, &mut random))
            }),
        };
        found.extend(check_call(gpu, world, function, &written, set == 0)?);
    }
    Ok(found)
}

fn check_call(
    gpu: &Gpu,
    world: &World,
    function: &Function,
    call: &str,
    is_first: bool,
) -> Result<Vec<Broken>, Problem> {
    let is_endless = function.traits.is_endless;
    let broken = |law, example: String| Broken { name: function.name.clone(), law, example };
    let Some(target) = Target::new(gpu, world, call, Mode::Live, is_endless)? else {
        let example = format!("{call}, looked for around the origin");
        return Ok(vec![broken(Law::IsMetByRays, example)]);
    };
    let mut random = Random(7);
    let rays: Vec<Ray> = (0..RAYS).map(|_| target.ray(&mut random)).collect();
    let ways = target.all(&rays)?;
    let mut found = vec![];
    let mut note = |law: Law, most: f64, wrong: &dyn Fn(usize) -> Option<String>| {
        let wrong: Vec<Option<String>> = (0..RAYS).map(wrong).collect();
        let tell = |i: usize| wrong[i].clone().unwrap_or_default();
        if let Some((i, what)) = first(RAYS, most, |i| wrong[i].is_some(), tell) {
            let Ray { origin, direction, .. } = rays[i];
            let place = format!("the ray from {origin} along {direction}");
            found.push(broken(law, format!("{call}, {place}: {what}").replace("points are", "rays are")));
        }
    };
    let most = if function.traits.is_distance { MAX_WRONG_MARCHED } else { MAX_WRONG };
    let any = |i: usize, tell: &dyn Fn(&Crossing) -> Option<String>| ways[i].iter().find_map(tell);
    note(Law::IsFinite, 0.0, &|i| any(i, &|hit| (!is_finite(hit)).then(|| format!("{hit:?}"))));
    note(Law::KeepsToTheRay, 0.0, &|i| leaves_the_ray(&rays[i], &ways[i]));
    note(Law::HasUnitNormals, 0.0, &|i| {
        let off = |hit: &Crossing| (hit.normal.length() - 1.0).abs() > LENGTH_TOLERANCE;
        any(i, &|hit| off(hit).then(|| format!("the normal is {}", hit.normal)))
    });
    note(Law::HasItsSurfaceThere, most, &|i| {
        let met = |hit: &Crossing| rays[i].origin + hit.t * rays[i].direction;
        let off = |hit: &Crossing| hit.position.distance(met(hit)) > SURFACE_TOLERANCE * target.radius;
        any(i, &|hit| off(hit).then(|| format!("it meets {}, the surface is at {}", met(hit), hit.position)))
    });
    let again = target.first(&rays)?;
    let start = |i: usize| ways[i].first();
    note(Law::IsTheSameAgain, 0.0, &|i| {
        let same = start(i).map(|hit| hit.t.to_bits()) == again[i].map(|hit| hit.t.to_bits());
        (!same).then(|| format!("{:?} and then {:?}", start(i), again[i]))
    });
    if is_first && let Some(baked) = Target::new(gpu, world, call, Mode::Baked, is_endless)? {
        let literal = baked.first(&rays)?;
        note(Law::IsTheSameLiveAndBaked, MAX_DIFFERENT, &|i| {
            let (a, b) = (start(i).map(|hit| hit.t), literal[i].map(|hit| hit.t));
            let same = match (a, b) {
                (Some(a), Some(b)) => (a - b).abs() <= SURFACE_TOLERANCE * target.radius,
                (a, b) => a.is_none() && b.is_none(),
            };
            (!same).then(|| format!("t is {a:?} and {b:?}"))
        });
    }
    let back =
        target.first(&rays.iter().zip(&ways).map(|(ray, way)| backwards(ray, way)).collect::<Vec<_>>())?;
    note(Law::IsTheSameFromBehind, most, &|i| {
        let last = ways[i].last().filter(|_| ways[i].len() < MAX_CROSSINGS)?;
        let length = backwards(&rays[i], &ways[i]).origin.distance(rays[i].origin);
        let t = back[i].map(|hit| length - hit.t);
        let same = t.is_some_and(|t| (t - last.t).abs() <= SURFACE_TOLERANCE * target.radius);
        (!same && !grazes(&rays[i], &ways[i])).then(|| format!("t is {} there and {t:?} back", last.t))
    });
    // Of a fractal, neighbouring normals have nothing to do with each other.
    let is_rough = function.text.lines().any(|line| line.trim_end() == ROUGH);
    if !function.traits.is_open && !is_rough {
        let is_outside = |i: usize| !is_endless || start(i).is_some_and(|hit| enters(&rays[i], hit));
        note(Law::FacesTheRay, most, &|i| {
            let hit = start(i).filter(|_| !is_endless && !grazes(&rays[i], &ways[i]))?;
            (!enters(&rays[i], hit)).then(|| format!("the normal at {} is {}", hit.position, hit.normal))
        });
        note(Law::IsEnteredAndLeft, most, &|i| {
            let is_judged = is_outside(i) && !grazes(&rays[i], &ways[i]) && ways[i].len() < MAX_CROSSINGS;
            let turns: Vec<bool> = ways[i].iter().map(|hit| enters(&rays[i], hit)).collect();
            let in_turn = turns.iter().enumerate().all(|(n, enters)| *enters == n.is_multiple_of(2));
            let ends = is_endless || turns.len().is_multiple_of(2);
            let words: Vec<&str> = turns.iter().map(|e| if *e { "enters" } else { "leaves" }).collect();
            (is_judged && !(in_turn && ends)).then(|| format!("it {}", words.join(", ")))
        });
    }
    Ok(found)
}

fn is_finite(hit: &Crossing) -> bool {
    hit.t.is_finite() && hit.position.is_finite() && hit.normal.is_finite() && hit.uv.is_finite()
}

/// Whether crossings come in order and behind the ray's start.
fn leaves_the_ray(ray: &Ray, way: &[Crossing]) -> Option<String> {
    let mut t_min = ray.t_min;
    for hit in way {
        if hit.t <= t_min {
            return Some(format!("t is {} where t_min is {t_min}", hit.t));
        }
        t_min = hit.t;
    }
    None
}

/// From beyond all that `ray` crosses, the same way back.
fn backwards(ray: &Ray, way: &[Crossing]) -> Ray {
    let start = way.last().map_or(0.0, |hit| if hit.t.is_finite() { hit.t } else { 0.0 });
    // As far beyond as the ray began before: the digits are the same.
    let beyond = ray.origin + (start + way.first().map_or(1.0, |hit| hit.t)) * ray.direction;
    Ray { origin: beyond, direction: -ray.direction, ..*ray }
}

fn enters(ray: &Ray, hit: &Crossing) -> bool {
    hit.normal.dot(ray.direction) < 0.0
}

fn grazes(ray: &Ray, way: &[Crossing]) -> bool {
    way.iter().any(|hit| hit.normal.dot(ray.direction).abs() < GRAZING)
}
