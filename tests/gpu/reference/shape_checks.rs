//! Every shape against an implicit function of its own: the first sign change along a ray is its hit.

use super::shapes::Shape;
use super::vector::Vec3;
use super::{nearest_hit, outward_normal};

/// A solid as text, with a function that is negative inside it, positive outside.
type Solid = (&'static str, fn(Vec3) -> f64);

const SOLIDS: [Solid; 20] = [
    ("Sphere(center: (0.2, 0, 0), radius: 0.9)", |p| (p - Vec3::new(0.2, 0.0, 0.0)).length() - 0.9),
    ("Plane(normal: (1, 2, 2), offset: 0.6)", |p| (p[0] + 2.0 * p[1] + 2.0 * p[2]) / 3.0 - 0.2),
    ("Box(min: (-1, -0.5, 0), max: (0.5, 1, 1))", |p| {
        box_distance(p, Vec3::new(-0.25, 0.25, 0.5), Vec3::new(0.75, 0.75, 0.5))
    }),
    ("RoundedBox(min: (-1, -0.5, 0), max: (0.5, 1, 1), radius: 0.3)", |p| {
        box_distance(p, Vec3::new(-0.25, 0.25, 0.5), Vec3::new(0.45, 0.45, 0.2)) - 0.3
    }),
    ("Cylinder(base: (0, -0.5, 0.1), top: (0, 0.8, 0.1), radius: 0.6)", |p| {
        (p[0].hypot(p[2] - 0.1) - 0.6).max(p[1] - 0.8).max(-0.5 - p[1])
    }),
    ("Cone(base: (0, -0.5, 0), top: (0, 1, 0), base_radius: 0.9, top_radius: 0.3)", |p| {
        let side = (p[0].hypot(p[2]) - 0.9 + 0.4 * (p[1] + 0.5)) / 1.16_f64.sqrt();
        side.max(p[1] - 1.0).max(-0.5 - p[1])
    }),
    ("Cone(base: (1, 0, 0), top: (-0.5, 0, 0), base_radius: 0.9)", |p| {
        let side = (p[1].hypot(p[2]) - 0.6 * (p[0] + 0.5)) / 1.36_f64.sqrt();
        side.max(p[0] - 1.0).max(-0.5 - p[0])
    }),
    ("Capsule(base: (0, 0, -0.7), top: (0, 0, 0.5), radius: 0.4)", |p| {
        (p - Vec3::new(0.0, 0.0, p[2].clamp(-0.7, 0.5))).length() - 0.4
    }),
    ("Torus(center: (0, 0.1, 0), axis: (0, 0, 3), major_radius: 0.8, minor_radius: 0.3)", |p| {
        (p[0].hypot(p[1] - 0.1) - 0.8).hypot(p[2]) - 0.3
    }),
    ("Ellipsoid(center: (0, 0, 0.3), radii: (1, 0.4, 0.6))", |p| {
        (p - Vec3::new(0.0, 0.0, 0.3)).zip(Vec3::new(1.0, 0.4, 0.6), |x, r| x / r).length() - 1.0
    }),
    ("RoundedCone(base: (0, -0.5, 0.1), top: (0, 0.7, 0.1), base_radius: 0.6, top_radius: 0.25)", |p| {
        hull_of_balls([p[0].hypot(p[2] - 0.1), p[1] + 0.5], 1.2, 0.6, 0.25)
    }),
    ("RoundedCone(base: (-0.2, 0, 0), top: (0.1, 0, 0), base_radius: 0.1, top_radius: 0.8)", |p| {
        (p - Vec3::new(0.1, 0.0, 0.0)).length() - 0.8
    }),
    ("HexPrism(center: (0.1, 0, 0), radius: 0.9, height: 1.2)", |p| {
        let (x, z, apothem) = ((p[0] - 0.1).abs(), p[2].abs(), 0.75_f64.sqrt());
        (x * apothem + 0.5 * z).max(z).max(p[1].abs() - 0.6 + 0.9 * apothem) - 0.9 * apothem
    }),
    ("RoundedCylinder(base: (0, 0.1, -0.8), top: (0, 0.1, 0.6), radius: 0.7, rounding: 0.2)", |p| {
        let out = Vec3::new(p[0].hypot(p[1] - 0.1) - 0.5, (p[2] + 0.1).abs() - 0.5, -1.0);
        out.map(|x| x.max(0.0)).length() + out[0].max(out[1]).min(0.0) - 0.2
    }),
    ("Wedge(min: (-1, -0.5, -0.6), max: (0.6, 0.7, 0.9))", |p| {
        let ramp = 0.8 * (p[1] + 0.5) - 0.6 * (p[0] + 1.0);
        ramp.max(p[0] - 0.6).max(-0.5 - p[1]).max(p[2] - 0.9).max(-0.6 - p[2])
    }),
    ("Pyramid(base: (0.1, -0.6, 0), top: (0.1, 0.6, 0), base_size: 1.8)", |p| {
        let side = (0.8 * (p[0] - 0.1).abs().max(p[2].abs()) + 0.6 * p[1]) - 0.36;
        side.max(-0.6 - p[1])
    }),
    ("Pyramid(base: (-0.6, 0, 0), top: (0.9, 0, 0), base_size: 0.6, top_size: 1.6)", |p| {
        (p[1].abs().max(p[2].abs()) - 0.5 - p[0] / 3.0).max(p[0] - 0.9).max(-0.6 - p[0])
    }),
    ("Paraboloid(base: (0, -0.6, 0), top: (0, 0.9, 0), radius: 0.9)", |p| {
        (p[0] * p[0] + p[2] * p[2] - 0.54 * (0.9 - p[1])).max(-0.6 - p[1])
    }),
    ("Hyperboloid(base: (0, 0, -0.8), top: (0, 0, 0.8), end_radius: 1, waist_radius: 0.6)", |p| {
        (p[0] * p[0] + p[1] * p[1] - p[2] * p[2] - 0.36).max(p[2].abs() - 0.8)
    }),
    ("Superellipsoid(radii: (1, 0.5, 0.8), east_west: 0.5, north_south: 1)", |p| {
        (p[0].powi(4) + (p[2] / 0.8).powi(4)).sqrt() + 4.0 * p[1] * p[1] - 1.0
    }),
];

/// The distance to two balls on an axis and the cone around them, from a way off the axis and a height:
/// that to the nearest of all balls between the two.
fn hull_of_balls([off, height]: [f64; 2], length: f64, r0: f64, r1: f64) -> f64 {
    let sine = (r0 - r1) / length;
    let lean = sine / (1.0 - sine * sine).sqrt();
    let share = ((height - off * lean) / length).clamp(0.0, 1.0);
    off.hypot(height - share * length) - r0 - share * (r1 - r0)
}

fn box_distance(p: Vec3, center: Vec3, half: Vec3) -> f64 {
    let q = (p - center).map(f64::abs) - half;
    q.map(|x| x.max(0.0)).length() + q.largest().min(0.0)
}

/// SplitMix64, to -1..1.
struct Random(u64);

impl Random {
    fn next(&mut self) -> f64 {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let mut x = self.0;
        x = (x ^ (x >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        x = (x ^ (x >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        ((x ^ (x >> 31)) >> 11) as f64 / (1_u64 << 52) as f64 - 1.0
    }

    fn vector(&mut self) -> Vec3 {
        Vec3::new(self.next(), self.next(), self.next())
    }
}

#[test]
fn hits_are_the_first_sign_change_and_normals_the_gradient() {
    let mut random = Random(7);
    for (text, solid) in SOLIDS {
        let shape = Shape::parse(text).unwrap();
        let mut hits = 0;
        for _ in 0..2000 {
            let (o, target) = (random.vector() * 2.0, random.vector());
            let d = target - o;
            let found = nearest_hit(&shape, o.0, d.0, 0.0, 2.0);
            let end = found.unwrap_or(2.0);
            let steps = (end * 400.0) as usize;
            let start = solid(o) > 0.0;
            // Before the hit the sign is the origin's; slivers thinner than 1e-6 may hide.
            for t in (0..steps).map(|k| (k as f64 + 0.5) / 400.0).filter(|t| *t < end - 1e-6) {
                let value = solid(o + d * t);
                assert!((value > 0.0) == start || value.abs() < 1e-6, "{text} {o:?} {d:?} t {t}");
            }
            let Some(t) = found else { continue };
            hits += 1;
            let p = o + d * t;
            assert!(solid(p).abs() < 1e-12, "{text} {o:?} {d:?}: off by {}", solid(p));
            let slope = |axis: usize| {
                let step = Vec3(std::array::from_fn(|i| if i == axis { 1e-6 } else { 0.0 }));
                solid(p + step) - solid(p - step)
            };
            let gradient = Vec3(std::array::from_fn(slope)).unit();
            let normal = Vec3(outward_normal(&shape, p.0));
            assert!((normal.length() - 1.0).abs() < 1e-12);
            // A rim within the step of the gradient has two normals.
            let on_rim = (solid(p + gradient * 1e-5) - solid(p - gradient * 1e-5)).abs() < 1e-9;
            assert!(normal.dot(gradient) > 1.0 - 1e-6 || on_rim, "{text} {p:?} {normal:?}");
        }
        assert!(hits > 200, "{text}: only {hits} hits");
    }
}

#[test]
fn distance_costs_no_digits_and_length_only_scales() {
    for (text, solid) in SOLIDS.into_iter().filter(|(text, _)| !text.starts_with("Plane")) {
        let shape = Shape::parse(text).unwrap();
        let mut random = Random(11);
        for distance in [1e1, 1e3, 1e5] {
            for _ in 0..200 {
                let target = random.vector() * 0.5;
                let d = random.vector().unit();
                let o = target - d * distance;
                let hit = nearest_hit(&shape, o.0, d.0, 0.0, f64::INFINITY);
                let long = nearest_hit(&shape, o.0, (d * 8.0).0, 0.0, f64::INFINITY);
                assert_eq!(hit.is_some(), long.is_some(), "{text}");
                let (Some(t), Some(long)) = (hit, long) else {
                    continue;
                };
                assert!((t - 8.0 * long).abs() < 1e-12 * distance, "{text}: {t} {long}");
                let miss = solid(o + d * t).abs();
                assert!(miss < 1e-13 * distance.max(10.0) * 10.0, "{text} {distance}: {miss}");
            }
        }
    }
}

#[test]
fn flat_shapes_end_where_their_fields_say() {
    let down = |text: &str, x: f64, z: f64| {
        let shape = Shape::parse(text).unwrap();
        nearest_hit(&shape, [x, 2.0, z], [0.0, -1.0, 0.0], 0.0, f64::INFINITY)
    };
    let ring = "Disk(center: (0, 0.5, 0), radius: 1, inner_radius: 0.4)";
    let places = [(0.3, 0.0), (0.5, 0.0), (0.8, 0.7), (-0.7, 0.7)];
    assert_eq!(places.map(|(x, z)| down(ring, x, z)), [None, Some(1.5), None, Some(1.5)]);
    let triangle = "Triangle(a: (0, 0, 0), b: (2, 0, 0), c: (0, 2, 1))";
    let places = [(0.1, 0.5), (1.2, 0.5), (-0.1, 0.5), (0.5, -0.1)];
    assert_eq!(places.map(|(x, z)| down(triangle, x, z)), [Some(1.0), None, None, None]);
    let quad = "Quad(corner: (0, 0, 0), u: (2, 0, 0), v: (1, 0, 1))";
    let places = [(0.4, 0.5), (2.4, 0.5), (2.6, 0.5), (1.0, 1.1)];
    assert_eq!(places.map(|(x, z)| down(quad, x, z)), [None, Some(2.0), None, None]);
}
