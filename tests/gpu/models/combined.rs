//! Models as parts of solids: where rays go in and out, beside the parity of the reference's crossings.

use glam::DVec3;
use raytoy::gpu::{Probe, Ray};

use super::aim::ray;
use super::brute_force::Soup;
use super::crossings::is_clear;
use super::random::Random;
use super::{compiled, probe};
use crate::common::expect_none;
use crate::device::gpu;

const RAYS: usize = 1500;
/// The share of rays that may change sides where they should not, or not where they should.
const MAX_WRONG: f64 = 1e-3;
/// Of the distance along the ray, or of the model's radius if that is more.
const TOLERANCE: f64 = 1e-4;
/// A ray that has met something goes on from a little beyond.
const STEP: f32 = 2e-5;

/// A box from `LOW` to `HIGH`, and what a point is in if it is in the box or in the model.
const LOW: DVec3 = DVec3::new(-0.4, -2.0, -2.0);
const HIGH: DVec3 = DVec3::new(3.0, 0.21, 2.0);
type Rule = fn(bool, bool) -> bool;
const SOLIDS: [(&str, Rule); 4] = [
    ("Difference(parts: [BOX, MODEL])", |is_in_box, is_in_model| is_in_box && !is_in_model),
    ("Difference(parts: [MODEL, BOX])", |is_in_box, is_in_model| is_in_model && !is_in_box),
    ("Intersection(parts: [BOX, MODEL])", |is_in_box, is_in_model| is_in_box && is_in_model),
    ("Union(parts: [BOX, MODEL])", |is_in_box, is_in_model| is_in_box || is_in_model),
];

#[test]
fn solids_begin_and_end_where_models_do() {
    let Some(gpu) = gpu() else { return };
    let names = ["knot.obj", "gem.glb"];
    let cases = names.iter().flat_map(|name| SOLIDS.iter().map(move |(solid, rule)| (name, solid, rule)));
    expect_none(cases.filter_map(|(name, solid, rule)| {
        let vector = |v: DVec3| format!("({}, {}, {})", v.x, v.y, v.z);
        let of_box = format!("Box(min: {}, max: {})", vector(LOW), vector(HIGH));
        let of_model = format!("Mesh(file: \"{name}\")");
        let objects = solid.replace("BOX", &of_box).replace("MODEL", &of_model);
        let compiled = compiled(name, &format!("(objects: [{objects}])"));
        let soup = Soup::of(&compiled.scene.models[0]);
        let mut random = Random(5);
        let rays: Vec<Ray> =
            (0..RAYS).map(|i| ray(&soup, &mut random, [None, Some(1.0), Some(30.0)][i % 3])).collect();
        let found = crossings(&probe(gpu, &compiled), &rays);
        let mut unclear = 0;
        let wrong: Vec<String> = rays
            .iter()
            .zip(&found)
            .filter_map(|(ray, found)| {
                let expected = changes(&soup, ray, *rule);
                if agree(&soup, ray, &expected, found) {
                    return None;
                }
                if !all_clear(&soup, ray) {
                    unclear += 1;
                    return None;
                }
                Some(format!("{ray:?} changes sides at {found:?}, not at {expected:?}"))
            })
            .collect();
        eprintln!("{name}, {solid}: {} wrong, {unclear} unclear of {RAYS}", wrong.len());
        let is_too_many = wrong.len() as f64 > MAX_WRONG * RAYS as f64 || unclear > RAYS / 10;
        is_too_many.then(|| format!("{name}, {solid}: {} wrong, {unclear} unclear: {wrong:#?}", wrong.len()))
    }));
}

/// Where each ray meets the solid, again and again.
fn crossings(probe: &Probe, rays: &[Ray]) -> Vec<Vec<f64>> {
    let mut found = vec![vec![]; rays.len()];
    let mut rest: Vec<(usize, Ray)> = rays.iter().copied().enumerate().collect();
    while !rest.is_empty() {
        let asked: Vec<Ray> = rest.iter().map(|(_, ray)| *ray).collect();
        let hits = probe.rays(&asked).unwrap_or_else(|error| panic!("{error}"));
        let next = rest.into_iter().zip(hits).filter_map(|((i, ray), hit)| {
            let t = hit?.t;
            found[i].push(f64::from(t));
            let t_min = t + STEP * t.max(1.0 / ray.direction.length());
            (found[i].len() < 40).then_some((i, Ray { t_min, ..ray }))
        });
        rest = next.collect();
    }
    found
}

/// Where the reference goes into the solid and out of it.
fn changes(soup: &Soup, ray: &Ray, rule: Rule) -> Vec<f64> {
    let (origin, direction) = (ray.origin.as_dvec3(), ray.direction.as_dvec3());
    let (a, b) = ((LOW - origin) / direction, (HIGH - origin) / direction);
    let box_span = [a.min(b).max_element(), a.max(b).min_element()];
    let is_in_box = |t: f64| box_span[0] < t && t < box_span[1];
    let of_model = soup.all(origin, direction);
    let mut places: Vec<f64> = of_model.iter().copied().chain(box_span).filter(|t| *t > 0.0).collect();
    places.sort_by(f64::total_cmp);
    let is_in_first = soup.holds(origin);
    let is_in_model = |t: f64| (of_model.iter().filter(|other| **other < t).count() % 2 == 1) != is_in_first;
    let ends = places.iter().copied().chain([f64::INFINITY]).skip(1);
    let mut before = rule(is_in_box(0.0), is_in_first);
    let mut found = vec![];
    for (t, next) in places.iter().copied().zip(ends) {
        let middle = if next.is_finite() { 0.5 * (t + next) } else { t + 1.0 / direction.length() };
        let behind = rule(is_in_box(middle), is_in_model(middle));
        if before != behind {
            found.push(t);
        }
        before = behind;
    }
    found
}

fn agree(soup: &Soup, ray: &Ray, expected: &[f64], found: &[f64]) -> bool {
    let scale = |t: f64| t.max(soup.radius / f64::from(ray.direction.length()));
    let same = |(a, b): (&f64, &f64)| (a - b).abs() <= TOLERANCE * scale(*a);
    expected.len() == found.len() && expected.iter().zip(found).all(same)
}

/// Whether nothing happens at any crossing of the model and the box that a rounding could change.
fn all_clear(soup: &Soup, ray: &Ray) -> bool {
    let (origin, direction) = (ray.origin.as_dvec3(), ray.direction.as_dvec3());
    let (a, b) = ((LOW - origin) / direction, (HIGH - origin) / direction);
    let mut places = soup.all(origin, direction);
    places.extend(a.to_array().into_iter().chain(b.to_array()).filter(|t| t.is_finite()));
    places.sort_by(f64::total_cmp);
    let least = 1e-3 * soup.radius / direction.length();
    let is_apart = places.windows(2).all(|pair| pair[1] - pair[0] > least);
    let starts = |t: &f64| t.abs() < least;
    let mut from = origin;
    // From one crossing to the next, and past the last.
    for _ in 0..places.len() {
        let met = soup.first(from, direction, least);
        if !is_clear(soup, from, direction, met) {
            return false;
        }
        let Some(met) = met else { break };
        from += (met.t + 0.5 * least) * direction;
    }
    is_apart && !places.iter().any(starts)
}
