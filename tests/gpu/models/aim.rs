//! Rays that are hard to get right: through corners and edges, along axes and faces, grazing, from inside.

use glam::DVec3;
use raytoy::gpu::Ray;

use super::brute_force::Soup;
use super::random::Random;

/// Where rays start: this far outside the ball around a model, or inside that ball and on the surface.
pub const DISTANCES: [Option<f64>; 6] = [None, Some(1.0), Some(10.0), Some(100.0), Some(1e3), Some(1e4)];

pub fn ray(soup: &Soup, random: &mut Random, distance: Option<f64>) -> Ray {
    let (origin, direction) = match distance {
        Some(distance) => from_outside(soup, random, distance + soup.radius),
        None => from_inside(soup, random),
    };
    // Most with length 1, some longer or shorter.
    let stretch = if random.below(4) == 0 { 10_f64.powf(random.signed()) } else { 1.0 };
    let direction = (direction.normalize() * stretch).as_vec3();
    Ray { origin: origin.as_vec3(), t_min: 0.0, direction, t_max: 1e30 }
}

fn from_outside(soup: &Soup, random: &mut Random, away: f64) -> (DVec3, DVec3) {
    let triangle = *random.pick(&soup.triangles);
    let [a, b, c] = triangle;
    let share = random.share();
    let at = a.lerp(b, share).lerp(c, random.share());
    let target = match random.below(8) {
        0 => a,
        1 => a.midpoint(b),
        2 => a.lerp(b, share),
        3 => at,
        4 => a + random.unit() * 1e-5 * soup.radius,
        _ => soup.middle + soup.radius * random.signed().abs().cbrt() * random.unit(),
    };
    match random.below(8) {
        // Along an axis.
        0 => {
            let way = *random.pick(&DVec3::AXES) * random.signed().signum();
            (target - way * away, way)
        }
        // Along a face or an edge, in its plane or a little above.
        1..3 => {
            let normal = (b - a).cross(c - a).normalize_or(DVec3::Y);
            let way = if random.below(2) == 0 { b - a } else { random.unit().cross(normal) };
            let way = way.normalize_or(DVec3::X);
            let above = 10_f64.powf(2.0 * random.signed() - 4.0) * f64::from(random.below(2) as u8);
            (at + above * soup.radius * normal - way * away, way)
        }
        _ => {
            let origin = (soup.middle + away * random.unit()).as_vec3().as_dvec3();
            (origin, target - origin)
        }
    }
}

fn from_inside(soup: &Soup, random: &mut Random) -> (DVec3, DVec3) {
    let [a, b, c] = *random.pick(&soup.triangles);
    let normal = (b - a).cross(c - a).normalize_or(DVec3::Y);
    let at = a.lerp(b, random.share()).lerp(c, random.share());
    let target = if random.below(2) == 0 { a } else { a.lerp(b, random.share()) };
    let anywhere = soup.middle + soup.radius * random.signed().abs().cbrt() * random.unit();
    let side = random.signed().signum();
    match random.below(4) {
        // From a surface, as far off it as raytoy starts a ray, and now and then along it.
        0 => (at + side * 1e-5 * soup.radius * normal, random.unit()),
        1 => {
            let way = random.unit().cross(normal) + side * 1e-2 * random.share() * normal;
            (at + side * 1e-5 * soup.radius * normal, way)
        }
        2 => (anywhere, *random.pick(&DVec3::AXES) * side),
        _ => (anywhere, (target - anywhere).normalize_or(DVec3::X)),
    }
}
