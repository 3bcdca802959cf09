//! Solids made of solids, and shapes that give a distance, beside a plain shape that must look the same.

use crate::common::{expect_compiled, expect_none, outcome_of};
use crate::device;
use raytoy::frame::{Moment, View};
use raytoy::gpu::{Gpu, Picture, render};
use raytoy::wgsl::Mode;

/// A scene's objects, others that are the same body, and the share of pixels in which they agree.
const LAWS: [(&str, &str, &str); 15] = [
    ("a union of two halves is the whole", "Union(parts: [Box(max: (0, 1, 1)), Box(min: (0, -1, -1))])", "Box()"),
    (
        "a union forgets what lies inside",
        "Union(parts: [Sphere(radius: 0.5), Sphere(radius: 1.1), Box(min: (-0.5, -0.5, -0.5), max: (0.5, 0.5, 0.5))])",
        "Sphere(radius: 1.1)",
    ),
    (
        "an intersection is what both hold",
        "Intersection(parts: [Box(min: (-2, -1, -1)), Box(max: (2, 1, 1))])",
        "Box()",
    ),
    (
        "six planes enclose a box",
        "Intersection(parts: [Plane(normal: (1, 0, 0), offset: 1), Plane(normal: (-1, 0, 0), offset: 1),
            Plane(normal: (0, 1, 0), offset: 1), Plane(normal: (0, -1, 0), offset: 1),
            Plane(normal: (0, 0, 1), offset: 1), Plane(normal: (0, 0, -1), offset: 1)])",
        "Box()",
    ),
    (
        "a difference is what the first alone holds",
        "Difference(parts: [Box(max: (2, 1, 1)), Box(min: (1, -3, -3), max: (3, 3, 3))])",
        "Box()",
    ),
    (
        "a cut that ends in a face leaves no film",
        "Difference(parts: [Box(max: (2, 1, 1)), Box(min: (1, -1, -1), max: (2, 1, 1))])",
        "Box()",
    ),
    (
        "cutting a cut away brings the part back",
        "Difference(parts: [Box(), Difference(parts: [Box(min: (0, -2, -2), max: (2, 2, 2)), Box(min: (-9, -9, -9), max: (9, 9, 9))])])",
        "Box()",
    ),
    (
        "parts move with the whole",
        "Union(translate: (0.3, 0.1, 0), rotate_deg: (0, 90, 0), scale: 0.5, parts: [
            Box(min: (-1, -2, -1), max: (1, 2, 3), scale: (1, 0.5, 1), translate: (0, 0, -1)), Sphere(radius: 0.1)])",
        "Box(min: (-0.7, -0.4, -0.5), max: (1.3, 0.6, 0.5), translate: (0, 0, 0))",
    ),
    (
        "one part is the part",
        "Intersection(parts: [Torus()])",
        "Torus()",
    ),
    (
        "a distance leads to the surface",
        "MengerSponge(levels: 0)",
        "Box()",
    ),
    (
        "a blend of equal balls is the ball, larger by a quarter of its reach",
        "SmoothBalls(a: (0, 0, 0), b: (0, 0, 0), radius_a: 0.9, radius_b: 0.9, blend: 0.4)",
        "Sphere()",
    ),
    ("a sheet as thick as its ball fills it", "Gyroid(thickness: 10)", "Sphere()"),
    (
        "a moved distance is the moved shape",
        "MengerSponge(levels: 0, scale: (1, 0.5, 1.4), rotate_deg: (0, 90, 0), translate: (0.2, 0, 0))",
        "Box(min: (-1.2, -0.5, -1), max: (1.6, 0.5, 1))",
    ),
    (
        "level land is a box",
        "Heightfield(height: 0.75, size: (2, 2, 2), translate: (0, -0.5, 0))",
        "Box(min: (-1, -0.5, -1), max: (1, 1, 1))",
    ),
    (
        "a pattern shapes land as a number does",
        "Heightfield(height: Add(a: 0.25, b: 0.5), size: (2, 2, 2), translate: (0, -0.5, 0))",
        "Box(min: (-1, -0.5, -1), max: (1, 1, 1))",
    ),
];

const VIEWS: [(&str, [f32; 3], [f32; 3]); 3] = [
    ("outside", [3.0, 2.5, 4.0], [0.0, 0.0, 0.0]),
    ("inside", [0.3, 0.2, -0.1], [1.0, -0.5, 2.0]),
    ("far away", [60.0, 50.0, -80.0], [0.0, 0.0, 0.0]),
];

const SIZE: [u32; 2] = [96, 72];
/// Pixels in which an edge may fall on the other side.
const MAX_WRONG: usize = 30;

#[test]
fn combinations_are_the_bodies_that_they_describe() {
    let Some(gpu) = device::gpu() else { return };
    expect_none(LAWS.iter().flat_map(|(law, made, plain)| {
        VIEWS.iter().filter_map(move |(view, eye, target)| {
            let fov = if *view == "far away" { 3.0 } else { 60.0 };
            let draw = |objects: &str| picture(gpu, objects, *eye, *target, fov);
            let wrong = differing(&draw(made), &draw(plain));
            (wrong > MAX_WRONG).then(|| format!("{law}, {view}: {wrong} pixels differ"))
        })
    }));
}

/// The normals, and the depth.
fn picture(gpu: &Gpu, objects: &str, eye: [f32; 3], target: [f32; 3], fov: f32) -> Picture {
    let text = format!("(objects: [{objects}])");
    let compiled = expect_compiled(outcome_of("a.ron", &text, Mode::Baked));
    let camera = raytoy::ir::Camera {
        eye: eye.into(),
        target: target.into(),
        fov: fov.to_radians(),
        ..compiled.scene.camera
    };
    let moment = Moment { camera, view: View::Normal, ..Moment::of(&compiled.scene) };
    render(gpu, &compiled, &moment, SIZE, 1, &mut |_| ()).unwrap_or_else(|error| panic!("{text}: {error}"))
}

/// In how many pixels two pictures show another surface.
fn differing(a: &Picture, b: &Picture) -> usize {
    let close = |x: f32, y: f32, tolerance: f32| x == y || (x - y).abs() <= tolerance;
    let same = |i: usize| {
        let normals = a.radiance[i].iter().zip(&b.radiance[i]).all(|(x, y)| close(*x, *y, 5e-3));
        normals && close(a.depth[i], b.depth[i], 1e-4 * a.depth[i].abs())
    };
    (0..a.depth.len()).filter(|i| !same(*i)).count()
}
