//! Crossings of nasty rays, near and far, beside the reference, and the triangles that they are found on.

use std::f64::consts::{FRAC_PI_4, PI};

use glam::DVec3;
use raytoy::gpu::{Crossing, Gpu, Ray};

use super::Subject;
use super::aim::{DISTANCES, ray};
use super::brute_force::{Met, Soup, distance};
use super::random::Random;
use super::shapes::MODELS;
use crate::common::expect_none;
use crate::device::gpu;

/// At each model.
const RAYS: usize = 12_000;

/// The share of rays that may meet what is not there, or miss what is.
const MAX_WRONG: f64 = 1e-4;
/// From the crossing to the triangle, of the distance, or of the model's radius if that is more.
const SURFACE_TOLERANCE: f64 = 2e-5;
/// Radians, between the normals of facets.
const NORMAL_TOLERANCE: f64 = 1e-3;
/// The share of rays that may meet either side of an edge, since they are aimed at it or go along it.
const MAX_UNCLEAR: f64 = 0.15;

#[test]
fn rays_meet_the_triangles_that_are_there() {
    let Some(gpu) = gpu() else { return };
    expect_none(MODELS.iter().flat_map(|name| check(gpu, name)));
}

#[derive(Default)]
struct Tally {
    met: usize,
    wrong: Vec<String>,
    turned: Vec<String>,
    unclear: usize,
}

fn check(gpu: &Gpu, name: &'static str) -> Vec<String> {
    let subject = Subject::new(gpu, name, "smooth: false");
    let mut total = Tally::default();
    for distance in DISTANCES {
        let mut random = Random(distance.map_or(0, f64::to_bits));
        let count = RAYS / DISTANCES.len();
        let rays: Vec<Ray> = (0..count).map(|_| ray(&subject.soup, &mut random, distance)).collect();
        let found = subject.ask(&rays);
        let all: Vec<(Ray, Option<Crossing>)> = rays.into_iter().zip(found).collect();
        let threads = std::thread::available_parallelism().map_or(2, usize::from);
        std::thread::scope(|scope| {
            let parts = all.chunks(count.div_ceil(threads));
            let workers: Vec<_> = parts.map(|part| scope.spawn(|| judged(&subject.soup, part))).collect();
            for worker in workers {
                let tally = worker.join().expect("no worker panics");
                total.met += tally.met;
                total.unclear += tally.unclear;
                total.wrong.extend(tally.wrong);
                total.turned.extend(tally.turned);
            }
        });
    }
    eprintln!(
        "{name}: {} of {RAYS} rays meet it, {} wrongly, {} turned, {} pass an edge",
        total.met,
        total.wrong.len(),
        total.turned.len(),
        total.unclear
    );
    let mut problems = vec![];
    let most = (MAX_WRONG * RAYS as f64) as usize;
    for (what, rays) in [("are wrong", &total.wrong), ("have a wrong normal", &total.turned)] {
        if rays.len() > most {
            problems.push(format!("{name}: {} of {RAYS} rays {what}, such as {}", rays.len(), rays[0]));
        }
    }
    if total.unclear as f64 > MAX_UNCLEAR * RAYS as f64 {
        problems.push(format!("{name}: {} of {RAYS} rays are unclear", total.unclear));
    }
    if total.met < RAYS / 4 {
        problems.push(format!("{name}: only {} of {RAYS} rays meet it: aim better", total.met));
    }
    problems
}

fn judged(soup: &Soup, all: &[(Ray, Option<Crossing>)]) -> Tally {
    let mut tally = Tally::default();
    for (ray, found) in all {
        let (origin, direction) = (ray.origin.as_dvec3(), ray.direction.as_dvec3());
        let expected = soup.first(origin, direction, 0.0);
        tally.met += usize::from(found.is_some());
        let told = || format!("{ray:?} expected {expected:?} found {found:?}");
        let agree = match (&expected, found) {
            (None, None) => continue,
            (Some(expected), Some(found)) => off(soup, expected, f64::from(found.t), direction),
            _ => f64::INFINITY,
        };
        let is_turned = match (&expected, found) {
            (Some(expected), Some(found)) if agree <= SURFACE_TOLERANCE => {
                !has_normal_near(soup, origin, direction, expected, found)
            }
            _ => false,
        };
        if agree <= SURFACE_TOLERANCE && !is_turned {
            continue;
        }
        if !is_clear(soup, origin, direction, expected) {
            tally.unclear += 1;
        } else if is_turned {
            tally.turned.push(told());
        } else {
            tally.wrong.push(told());
        }
    }
    tally
}

/// From the point at `t` to the plane of the triangle that is expected, of the distance.
fn off(soup: &Soup, expected: &Met, t: f64, direction: DVec3) -> f64 {
    let scale = (expected.t * direction.length()).max(soup.radius);
    ((t - expected.t) * direction).dot(expected.normal).abs() / scale
}

/// Whether the normal is that of the triangle which the ray meets, or of one beside it, if the ray passes the
/// edge between them.
fn has_normal_near(soup: &Soup, origin: DVec3, direction: DVec3, expected: &Met, found: &Crossing) -> bool {
    let turn = |normal: DVec3| {
        let actual = found.normal.as_dvec3();
        actual.cross(normal).length().atan2(actual.dot(normal)).min(PI)
    };
    if turn(expected.normal) <= NORMAL_TOLERANCE {
        return true;
    }
    let point = origin + expected.t * direction;
    let near = near(soup, expected.t * direction.length());
    // What a grazing ray meets is as uncertain as it is slanted.
    let reach = near / direction.normalize().dot(expected.normal).abs().max(1e-3);
    let is_beside = |i: &usize| {
        let corners = soup.triangles[*i];
        let meets = corners.iter().any(|corner| soup.triangles[expected.triangle].contains(corner));
        meets && distance(&corners, point) <= reach
    };
    let mut beside = (0..soup.triangles.len()).filter(is_beside);
    beside.any(|i| turn(soup.normal(i)) <= NORMAL_TOLERANCE)
}

/// How far from an edge a ray must pass to be judged.
fn near(soup: &Soup, away: f64) -> f64 {
    1e-4 * soup.radius + 2e-6 * away
}

/// Whether all rays that pass near by meet the same surface.
pub fn is_clear(soup: &Soup, origin: DVec3, direction: DVec3, expected: Option<Met>) -> bool {
    let unit = direction.normalize();
    let away = expected.map_or((soup.middle - origin).dot(unit), |met| met.t * direction.length());
    let away = away.max(0.1 * soup.radius);
    let near = near(soup, away);
    // A ray that starts on the surface may or may not meet it there.
    let start = 2e-6 * soup.radius / direction.length();
    let same_from = |t_min: f64| match (expected, soup.first(origin, direction, t_min)) {
        (Some(a), Some(b)) => a.t == b.t,
        (a, b) => a.is_none() && b.is_none(),
    };
    let (u, v) = unit.any_orthonormal_pair();
    let same_beside = |i: i32| {
        let (sin, cos) = (f64::from(i) * FRAC_PI_4).sin_cos();
        let beside = unit * away + near * (cos * u + sin * v);
        match (expected, soup.first(origin, beside, 0.0)) {
            (None, None) => true,
            (Some(a), Some(b)) => {
                let step = b.t * beside - a.t * direction;
                step.dot(a.normal).abs() < 2.0 * near && b.normal.dot(a.normal) > 0.94
            }
            _ => false,
        }
    };
    same_from(start) && same_from(-start) && (0..8).all(same_beside)
}
