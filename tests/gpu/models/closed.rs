//! Closed models seen from inside: no ray may leave between two triangles.

use glam::{DVec3, Vec3};
use raytoy::gpu::{Gpu, Ray};

use super::Subject;
use super::brute_force::Soup;
use super::random::Random;
use super::shapes::MODELS;
use crate::common::expect_none;
use crate::device::gpu;

/// From inside each model, through its edges and corners.
const RAYS: usize = 25_000;
/// Those along an axis, whose origins are looked for.
const ALONG_AXES: usize = 500;

#[test]
fn no_ray_leaves_between_triangles() {
    let Some(gpu) = gpu() else { return };
    let wide = ["", "scale: (1, -1, 1), rotate_deg: (0, 30, 0)"];
    expect_none(MODELS.iter().flat_map(|name| wide.iter().filter_map(|fields| leaks(gpu, name, fields))));
}

fn leaks(gpu: &Gpu, name: &'static str, fields: &str) -> Option<String> {
    let subject = Subject::new(gpu, name, fields);
    let soup = &subject.soup;
    let mut random = Random(17);
    let within = insiders(soup, &mut random);
    let mut rays: Vec<Ray> = (0..RAYS).map(|_| towards_an_edge(soup, &within, &mut random)).collect();
    rays.extend(along_axes(soup, &within, &mut random));
    if !fields.is_empty() {
        let (mirror, turn) = (Vec3::new(1.0, -1.0, 1.0), glam::Quat::from_rotation_y(30_f32.to_radians()));
        for ray in &mut rays {
            ray.origin = turn * (mirror * ray.origin);
            ray.direction = turn * (mirror * ray.direction);
        }
    }
    let found = subject.ask(&rays);
    let lost: Vec<&Ray> = rays.iter().zip(&found).filter(|(_, hit)| hit.is_none()).map(|(r, _)| r).collect();
    eprintln!("{name} {fields}: {} of {} rays leave", lost.len(), rays.len());
    let first = lost.first()?;
    Some(format!("{name} {fields}: {} of {} rays leave, such as {first:?}", lost.len(), rays.len()))
}

/// Points well inside.
fn insiders(soup: &Soup, random: &mut Random) -> Vec<Vec3> {
    let mut found = vec![];
    for _ in 0..1000 {
        let i = random.below(soup.triangles.len());
        let [a, b, c] = soup.triangles[i];
        let at = (a + b + c) / 3.0 - 0.3 * random.share() * soup.radius * soup.normal(i);
        let at = at.as_vec3();
        if soup.holds(at.as_dvec3()) && soup.distance(at.as_dvec3()) > 1e-3 * soup.radius {
            found.push(at);
        }
    }
    assert!(found.len() > 100, "only {} of 1000 points are inside", found.len());
    let middle = soup.middle.as_vec3();
    found.extend(soup.holds(middle.as_dvec3()).then_some(middle));
    found
}

fn towards_an_edge(soup: &Soup, within: &[Vec3], random: &mut Random) -> Ray {
    let origin = *random.pick(within);
    let direction = on_an_edge(soup, random) - origin;
    let direction = match random.below(3) {
        0 => direction,
        1 => direction.normalize(),
        _ => direction.map(|x| stepped(x, random)),
    };
    Ray { origin, t_min: 0.0, direction, t_max: 1e30 }
}

/// A corner, or a point of an edge.
fn on_an_edge(soup: &Soup, random: &mut Random) -> Vec3 {
    let corners = random.pick(&soup.triangles).map(DVec3::as_vec3);
    let (a, b) = (corners[random.below(3)], corners[random.below(3)]);
    let share = [0.0, 0.5, random.share() as f32][random.below(3)];
    let at = a + share * (b - a);
    if random.below(2) == 0 { at } else { at.map(|x| stepped(x, random)) }
}

/// A few floats up or down.
fn stepped(x: f32, random: &mut Random) -> f32 {
    let step = random.below(7) as i32 - 3;
    if x == 0.0 { step as f32 * 1e-8 } else { f32::from_bits(x.to_bits().wrapping_add_signed(step)) }
}

/// Rays along an axis that meet a corner or an edge to the last digit.
fn along_axes(soup: &Soup, within: &[Vec3], random: &mut Random) -> Vec<Ray> {
    let ray = |_| {
        let axis = random.below(3);
        let mut origin = on_an_edge(soup, random);
        origin[axis] = random.pick(within)[axis];
        let direction = Vec3::AXES[axis] * random.signed().signum() as f32;
        let at = origin.as_dvec3();
        let is_within = soup.holds(at) && soup.distance(at) > 1e-3 * soup.radius;
        is_within.then_some(Ray { origin, t_min: 0.0, direction, t_max: 1e30 })
    };
    (0..ALONG_AXES).filter_map(ray).collect()
}
