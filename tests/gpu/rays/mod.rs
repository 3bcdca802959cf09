//! Rays at one shape, random and nasty ones, and how far a probe's crossings lie from those of the reference
//! in f64.
// Each binary uses a part of it.

mod aim;
mod judge;
mod tally;

use std::path::Path;
use std::sync::Mutex;
use std::sync::atomic::{AtomicU64, Ordering};

use glam::DVec3;
use raytoy::frame::Moment;
use raytoy::gpu::{Gpu, Probe, Ray};
use raytoy::ir::Value;
use raytoy::library::Const;
use raytoy::sources::Sources;
use raytoy::wgsl::Mode;
use raytoy::{Compiled, compile};

use self::aim::Random;
pub use self::tally::{Tally, extent};
use crate::reference::{Shape, nearest_hit, outward_normal};

/// A shape with arguments, and the radius of a ball around its middle that holds what is looked at.
pub type Call = (&'static str, f64);

/// Each shape of the library: plain, and turned or squeezed.
pub const SHAPES: [(&str, &[Call]); 20] = [
    ("Sphere", &[("Sphere()", 1.0), ("Sphere(center: (0.2, 0, 0), radius: 0.9)", 0.9)]),
    ("Plane", &[("Plane()", 1.0), ("Plane(normal: (1, 3, 1), offset: -2)", 1.0)]),
    ("Box", &[("Box()", 1.74), ("Box(min: (-1, -0.5, 0), max: (0.5, 1, 1))", 1.18)]),
    (
        "RoundedBox",
        &[("RoundedBox()", 1.74), ("RoundedBox(min: (-1, -0.5, 0), max: (0.5, 1, 1), radius: 0.3)", 1.18)],
    ),
    (
        "Cylinder",
        &[("Cylinder()", 1.12), ("Cylinder(base: (0, -0.5, 0.1), top: (0.3, 0.8, 0.1), radius: 0.6)", 0.9)],
    ),
    (
        "Cone",
        &[
            ("Cone()", 1.12),
            ("Cone(base: (0, -0.5, 0), top: (0.2, 1, 0), base_radius: 0.9, top_radius: 0.3)", 1.18),
        ],
    ),
    (
        "Capsule",
        &[("Capsule()", 1.0), ("Capsule(base: (0, 0, -0.7), top: (0, 0.3, 0.5), radius: 0.4)", 1.08)],
    ),
    (
        "Torus",
        &[
            ("Torus()", 1.25),
            ("Torus(center: (0, 0.1, 0), axis: (0.3, 1, 0.2), major_radius: 0.8, minor_radius: 0.3)", 1.1),
        ],
    ),
    ("Ellipsoid", &[("Ellipsoid()", 1.0), ("Ellipsoid(center: (0, 0, 0.3), radii: (1, 0.4, 0.6))", 1.0)]),
    (
        "Disk",
        &[
            ("Disk()", 1.0),
            ("Disk(center: (0, 0.1, 0), normal: (1, 2, 1), radius: 1, inner_radius: 0.3)", 1.0),
        ],
    ),
    ("Triangle", &[("Triangle(a: (-1, -0.5, 0), b: (1, -0.4, 0.3), c: (0.1, 1, -0.4))", 1.15)]),
    (
        "Quad",
        &[
            ("Quad(corner: (-0.5, 0, -0.5), u: (1, 0, 0), v: (0, 0, 1))", 0.71),
            ("Quad(corner: (-0.8, -0.6, 0.2), u: (1.5, 0.2, 0), v: (0.1, 1.2, -0.5))", 1.05),
        ],
    ),
    (
        "RoundedCone",
        &[("RoundedCone()", 1.0), ("RoundedCone(base: (0, -0.3, 0), top: (0.3, 0.4, 0.2))", 1.0)],
    ),
    ("RoundedCylinder", &[("RoundedCylinder()", 1.12), ("RoundedCylinder(rounding: 0.4)", 1.12)]),
    ("HexPrism", &[("HexPrism()", 1.12), ("HexPrism(axis: (0.3, 1, -0.2), radius: 0.8)", 0.95)]),
    ("Wedge", &[("Wedge()", 1.74), ("Wedge(min: (-1, -0.5, 0), max: (0.5, 1, 1))", 1.18)]),
    ("Pyramid", &[("Pyramid()", 1.5), ("Pyramid(top_size: 0.8)", 1.5)]),
    ("Paraboloid", &[("Paraboloid()", 1.12), ("Paraboloid(top: (0.3, 1, 0.1), radius: 0.7)", 0.9)]),
    ("Hyperboloid", &[("Hyperboloid()", 1.12), ("Hyperboloid(waist_radius: 0.2)", 1.12)]),
    (
        "Superellipsoid",
        &[("Superellipsoid()", 1.74), ("Superellipsoid(east_west: 1, north_south: 0.6)", 1.5)],
    ),
];

/// Where rays start: this far outside the ball around a shape, or inside that ball and on the shape.
pub const DISTANCES: [Option<f64>; 6] = [None, Some(1.0), Some(10.0), Some(100.0), Some(1e3), Some(1e4)];

/// A shape before the probe and before the reference.
pub struct Subject {
    probe: Probe,
    shape: Shape,
    middle: DVec3,
    radius: f64,
    /// What its arguments give away: corners and middles, sides and axes.
    places: Vec<DVec3>,
    ways: Vec<DVec3>,
}

impl Subject {
    pub fn new(gpu: &Gpu, (call, radius): Call) -> Self {
        let compiled = compiled(call);
        let probe = Probe::build(gpu, &compiled, &Moment::of(&compiled.scene), [480, 270]);
        let probe = probe.unwrap_or_else(|error| panic!("{call}: {error}"));
        let shape = Shape::parse(call).unwrap_or_else(|why| panic!("{call}: {why}"));
        let middle = DVec3::from_array(shape.center().0);
        let vectors: Vec<DVec3> = compiled.scene.primitives[0].arguments.iter().filter_map(vector).collect();
        let pairs = vectors.iter().flat_map(|a| vectors.iter().map(move |b| (*a, *b)));
        // A corner and two sides give three more corners; two corners of a box all eight.
        let mixed = pairs.clone().flat_map(|(a, b)| {
            [
                a + b,
                vectors.iter().sum(),
                DVec3::new(a.x, b.y, b.z),
                DVec3::new(a.x, a.y, b.z),
                DVec3::new(a.x, b.y, a.z),
            ]
        });
        let places: Vec<DVec3> = vectors.iter().copied().chain(mixed).chain([middle]).collect();
        let places = places.into_iter().filter(|p| p.distance(middle) <= 1.01 * radius).collect();
        let sides = pairs.map(|(a, b)| b - a);
        let ways = [DVec3::X, DVec3::Y, DVec3::Z].into_iter().chain(vectors.iter().copied()).chain(sides);
        let ways = ways.filter(|way| way.length() > 1e-6).map(DVec3::normalize).collect();
        Self { probe, shape, middle, radius, places, ways }
    }

    /// Shoots `count` rays from `distance`, on all processors.
    pub fn shoot(&self, distance: Option<f64>, count: u64) -> Tally {
        const AT_ONCE: u64 = 20_000;
        let (left, total) = (AtomicU64::new(0), Mutex::new(Tally::default()));
        let worker = || {
            loop {
                let start = left.fetch_add(AT_ONCE, Ordering::Relaxed);
                if start >= count {
                    break;
                }
                let mut random = Random(start ^ distance.map_or(0, f64::to_bits));
                let rays: Vec<Ray> =
                    (start..count.min(start + AT_ONCE)).map(|_| self.ray(&mut random, distance)).collect();
                let tally = self.ask(&rays);
                total.lock().unwrap().join(tally);
            }
        };
        std::thread::scope(|scope| {
            let threads = std::thread::available_parallelism().map_or(2, usize::from);
            (0..threads).for_each(|_| drop(scope.spawn(worker)));
        });
        total.into_inner().unwrap()
    }

    /// What comes of these rays.
    pub fn ask(&self, rays: &[Ray]) -> Tally {
        let found = self.probe.rays(rays).unwrap_or_else(|error| panic!("{error}"));
        let mut tally = Tally::default();
        rays.iter().zip(&found).for_each(|(ray, found)| self.judge(&mut tally, ray, found.as_ref()));
        tally
    }

    /// The reference's crossing and its normal.
    fn meets(&self, origin: DVec3, direction: DVec3, t_min: f64) -> Option<(f64, DVec3)> {
        let t = nearest_hit(&self.shape, origin.to_array(), direction.to_array(), t_min, 1e30)?;
        let normal = outward_normal(&self.shape, (origin + t * direction).to_array());
        Some((t, DVec3::from_array(normal)))
    }
}

fn vector(argument: &Value) -> Option<DVec3> {
    match argument {
        Value::Const(Const::Vec3(v)) => Some(v.as_dvec3()),
        _ => None,
    }
}

fn compiled(call: &str) -> Compiled {
    let sources = Sources::in_memory().with("shape.ron", &format!("(objects: [{call}])"));
    let outcome = compile(&sources, Path::new("shape.ron"), Mode::Live, None);
    outcome.compiled.unwrap_or_else(|| panic!("{}", outcome.report))
}
