//! Each shape's crossings and normals beside the reference's: from outside, from inside, moved, turned and stretched.

use crate::common::{expect_compiled, expect_none, outcome_of};
use crate::device;
use crate::reference;
use raytoy::frame::{Moment, View};
use raytoy::gpu::{Gpu, Picture, render};
use raytoy::library::{Family, Library, Type};
use raytoy::sources::Sources;
use raytoy::wgsl::Mode;

/// A shape with arguments, and a point inside it, or beside its middle where it has no inside.
const SHAPES: [(&str, [f32; 3]); 20] = [
    ("Sphere(center: (0.2, 0, 0), radius: 0.9", [0.4, 0.1, -0.2]),
    ("Plane(normal: (1, 3, 1), offset: -2", [0.3, 0.4, 0.2]),
    ("Box(min: (-1, -0.5, 0), max: (0.5, 1, 1)", [-0.2, 0.3, 0.4]),
    ("RoundedBox(min: (-1, -0.5, 0), max: (0.5, 1, 1), radius: 0.3", [-0.2, 0.3, 0.4]),
    ("Cylinder(base: (0, -0.5, 0.1), top: (0.3, 0.8, 0.1), radius: 0.6", [0.1, 0.2, 0.2]),
    ("Cone(base: (0, -0.5, 0), top: (0.2, 1, 0), base_radius: 0.9, top_radius: 0.3", [0.1, 0.1, 0.2]),
    ("Capsule(base: (0, 0, -0.7), top: (0, 0.3, 0.5), radius: 0.4", [0.1, 0.1, 0.0]),
    (
        "Torus(center: (0, 0.1, 0), axis: (0.3, 1, 0.2), major_radius: 0.8, minor_radius: 0.3",
        [0.8, -0.1, 0.0],
    ),
    ("Ellipsoid(center: (0, 0, 0.3), radii: (1, 0.4, 0.6)", [0.2, 0.1, 0.2]),
    ("Disk(center: (0, 0.1, 0), normal: (1, 2, 1), radius: 1, inner_radius: 0.3", [0.3, 0.8, 0.2]),
    ("Triangle(a: (-1, -0.5, 0), b: (1, -0.4, 0.3), c: (0.1, 1, -0.4)", [0.2, 0.1, 0.8]),
    ("Quad(corner: (-0.8, -0.6, 0.2), u: (1.5, 0.2, 0), v: (0.1, 1.2, -0.5)", [0.2, 0.1, 0.9]),
    (
        "RoundedCone(base: (0, -0.5, 0.1), top: (0.3, 0.7, 0), base_radius: 0.6, top_radius: 0.3",
        [0.1, 0.1, 0.2],
    ),
    ("HexPrism(center: (0.1, 0.2, 0), axis: (0.3, 1, 0.2), radius: 0.9, height: 1.2", [0.2, 0.1, 0.3]),
    (
        "RoundedCylinder(base: (0, -0.5, 0.1), top: (0.3, 0.8, 0.1), radius: 0.7, rounding: 0.2",
        [0.1, 0.2, 0.2],
    ),
    ("Wedge(min: (-1, -0.5, -0.6), max: (0.6, 0.7, 0.9)", [0.2, -0.1, 0.2]),
    ("Pyramid(base: (0, -0.5, 0), top: (0.2, 1, 0.3), base_size: 1.6, top_size: 0.4", [0.1, 0.1, 0.2]),
    ("Paraboloid(base: (0, -0.5, 0), top: (0.2, 1, 0.1), radius: 0.9", [0.1, 0.1, 0.2]),
    (
        "Hyperboloid(base: (0, -0.8, 0), top: (0.3, 0.8, 0.2), end_radius: 0.9, waist_radius: 0.4",
        [0.2, 0.1, 0.2],
    ),
    (
        "Superellipsoid(center: (0, 0, 0.2), radii: (1, 0.6, 0.7), east_west: 0.5, north_south: 1.3",
        [0.2, 0.1, 0.3],
    ),
];

/// The second object of each scene: it reaches the corners of all that a transform can do but shear.
const MOVED: &str = "translate: (1.5, 3.5, -1), rotate_deg: (25, -40, 70), scale: (1.4, 0.6, -0.9)";

const SIZE: [u32; 2] = [120, 90];

/// Of the distance.
const DEPTH_TOLERANCE: f64 = 2e-5;
/// Of a normal's components.
const NORMAL_TOLERANCE: f64 = 2e-3;
/// The share of pixels in which they hold; at a silhouette a rounding moves the crossing by more.
const LEAST_AGREEMENT: f64 = 0.996;

#[test]
fn crossings_and_normals_are_those_of_the_reference() {
    let Some(gpu) = device::gpu() else { return };
    expect_none(SHAPES.iter().flat_map(|(shape, inside)| check(gpu, shape, *inside)));
}

#[test]
fn each_shape_is_checked() {
    let is_checked = |name: &String| SHAPES.iter().any(|(shape, _)| shape.starts_with(&format!("{name}(")));
    let missing = solved_shapes().into_iter().filter(|name| !is_checked(name));
    expect_none(missing.map(|name| format!("{name} has no line in SHAPES")));
}

/// What of one shape's pictures disagrees, if anything.
fn check(gpu: &Gpu, shape: &str, inside: [f32; 3]) -> Vec<String> {
    let views = [
        ("outside", [4.0, 3.0, 5.0], [0.6, 1.2, -0.3]),
        ("below", [-3.0, -2.5, -4.0], [0.6, 1.2, -0.3]),
        ("far away", [300.0, 200.0, -400.0], [0.6, 1.2, -0.3]),
        ("inside", inside, [inside[0] + 0.4, inside[1] - 0.3, inside[2] - 0.8]),
    ];
    // The numbers and the camera are data: one shader shows them all.
    let mut compiled = None;
    let mut problems = vec![];
    for (name, eye, target) in views {
        let fov = if name == "far away" { 0.8 } else { 60.0 };
        let text = scene(shape, eye, target, fov);
        let compiled =
            &*compiled.get_or_insert_with(|| expect_compiled(outcome_of("a.ron", &text, Mode::Live)));
        let camera = raytoy::ir::Camera {
            eye: eye.into(),
            target: target.into(),
            fov: f32::to_radians(fov),
            ..compiled.scene.camera
        };
        let moment = Moment { camera, view: View::Normal, ..Moment::of(&compiled.scene) };
        let actual = render(gpu, compiled, &moment, SIZE, 1, &mut |_| ())
            .unwrap_or_else(|error| panic!("{shape}: {error}"));
        let expected = reference::render(&text, SIZE[0] as usize, SIZE[1] as usize)
            .unwrap_or_else(|why| panic!("{shape}: {why}"));
        problems.extend(compare(&expected, &actual).err().map(|why| format!("{shape}), {name}: {why}")));
    }
    problems
}

fn scene(shape: &str, eye: [f32; 3], target: [f32; 3], fov: f32) -> String {
    let vector = |v: [f32; 3]| format!("({}, {}, {})", v[0], v[1], v[2]);
    format!(
        "(camera: (eye: {}, target: {}, fov_deg: {fov}), objects: [{shape}), {shape}, {MOVED})])",
        vector(eye),
        vector(target),
    )
}

fn compare(expected: &reference::Picture, actual: &Picture) -> Result<(), String> {
    let pixels = expected.depth.len();
    let met = expected.depth.iter().filter(|depth| depth.is_finite()).count();
    if met < pixels / 100 {
        return Err(format!("only {met} of {pixels} pixels show it: move the camera"));
    }
    let depth = |i: usize| {
        let (a, b) = (f64::from(actual.depth[i]), expected.depth[i]);
        a == b || (a - b).abs() <= DEPTH_TOLERANCE * b
    };
    let normal = |i: usize| {
        let decoded = actual.radiance[i].map(|x| 2.0 * f64::from(x) - 1.0);
        let misses = !expected.depth[i].is_finite();
        misses || decoded.iter().zip(expected.normal[i]).all(|(a, b)| (a - b).abs() <= NORMAL_TOLERANCE)
    };
    let wrong = |is_right: &dyn Fn(usize) -> bool| (0..pixels).filter(|i| !is_right(*i)).count();
    let most = ((1.0 - LEAST_AGREEMENT) * met as f64).ceil() as usize;
    for (what, wrong) in [("depth", wrong(&depth)), ("normal", wrong(&normal))] {
        if wrong > most {
            return Err(format!("{what} differs in {wrong} pixels of the {met} that show it; {most} may"));
        }
    }
    Ok(())
}

/// The shapes that find their crossings by equations, as the reference does. For what is marched to
/// tests/gpu/solids.rs has laws, and for models tests/gpu/models/.
pub fn solved_shapes() -> Vec<String> {
    let sources = Sources::in_memory();
    let library = Library::new(&sources, "".as_ref());
    let is_solved = |name: &String| {
        let function = library.find(Family::Shape, name);
        function.is_ok_and(|f| !f.traits.is_distance && f.parameters.iter().all(|p| p.ty != Type::Model))
    };
    library.names(Family::Shape).into_iter().filter(is_solved).collect()
}
