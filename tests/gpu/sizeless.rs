//! Shapes without a size: each is refused with its place, or draws nothing beyond where it lies, be the numbers
//! data or text.

use std::path::Path;
use std::sync::Arc;
use std::time::Duration;

use crate::common::{expect_compiled, expect_none, outcome_of};
use raytoy::Compiled;
use raytoy::frame::{FrameUniforms, Moment};
use raytoy::ir::Value;
use raytoy::library::{Const, Family, Function, Library, Parameter, Type, sample};
use raytoy::sketch::Sketch;
use raytoy::sources::Sources;
use raytoy::wgsl::{Mode, Target, generate};

/// Each is refused at the last value that is named.
const REFUSED: [(&str, &str); 29] = [
    ("Box(max: (-1, -1, -1))", "`min` and `max` differ along fewer than two axes"),
    ("Box(min: (3, 2, 2), max: (3, 2, 7))", "`min` and `max` differ along fewer than two axes"),
    ("RoundedBox(min: (1, 1, 1))", "`min` and `max` differ along fewer than two axes"),
    (
        "Difference(parts: [Sphere(), Box(min: (0, -2, -2), max: (0, 2, 2))])",
        "this `Box` is flat and has no inside",
    ),
    ("Union(parts: [Wedge(min: (-1, 1, -1))])", "this `Wedge` is flat and has no inside"),
    ("Wedge(min: (1, 1, 1))", "`min` and `max` differ along fewer than two axes"),
    ("Cylinder(top: (0, 0, 0))", "`base` and `top` are the same point"),
    ("Cylinder(base: (5, 1e6, 0), top: (5, 1000000.01, 0))", "`base` and `top` are the same point"),
    ("Cone(base: (0, 1, 0))", "`base` and `top` are the same point"),
    ("RoundedCylinder(top: (0, 1e-12, 0))", "`base` and `top` are the same point"),
    ("Pyramid(top: (0, 0, 0))", "`base` and `top` are the same point"),
    ("Paraboloid(top: (0, 0, 0))", "`base` and `top` are the same point"),
    ("Hyperboloid(top: (0, 0, 0))", "`base` and `top` are the same point"),
    ("Triangle(a: (1, 2, 3), b: (1, 2, 3), c: (1, 2, 3))", "`a`, `b` and `c` are on one line"),
    ("Triangle(a: (0, 0, 0), b: (1, 1, 1), c: (1, 1, 1))", "`a`, `b` and `c` are on one line"),
    (
        "Triangle(a: (0.1, 0.1, 0.1), b: (0.2, 0.2, 0.2), c: (0.3, 0.3, 0.3))",
        "`a`, `b` and `c` are on one line",
    ),
    ("Quad(corner: (0, 0, 0), u: (1, 0, 0), v: (2, 0, 0))", "`u` and `v` are parallel"),
    ("Quad(corner: (0, 0, 0), u: (1, 0, 0), v: (-2, 0, 0))", "`u` and `v` are parallel"),
    ("Quad(corner: (0, 0, 0), u: (1, 0, 0), v: (0, 0, 0))", "`u` and `v` are parallel"),
    ("Disk(inner_radius: 1)", "`inner_radius` must be less than `radius`"),
    ("Disk(radius: 0.25, inner_radius: 0.5)", "`inner_radius` must be less than `radius`"),
    ("Plane(normal: (0, 1e-30, 0))", "`normal` has no length"),
    ("Torus(axis: (0, 0, 0))", "`axis` has no length"),
    ("HexPrism(axis: (1e-20, 0, 0))", "`axis` has no length"),
    ("Sphere(radius: 0)", "0 is out of range"),
    ("Ellipsoid(radii: (1, 0, 1))", "0 is out of range"),
    ("Gyroid(thickness: 0)", "0 is out of range"),
    ("Heightfield(size: (4, 0, 4))", "0 is out of range"),
    ("Sphere(scale: (1, 0, 1))", "`scale` must not be 0"),
];

/// What is flat or has no middle, and is drawn all the same.
const DRAWN: [&str; 9] = [
    "Box(min: (-1, 0, -1), max: (1, 0, 1), rotate_deg: (40, 0, 0))",
    "RoundedBox(min: (-1, -1, 0.5), max: (1, 1, 0.5))",
    "Wedge(min: (-3, -3, 0), max: (3, 3, 0))",
    "Box(min: (1, 1, 1), max: (-1, -1, -1))",
    "Capsule(top: (0, 0, 0), radius: 2)",
    "RoundedCone(top: (0, 0, 0), base_radius: 2)",
    "Torus(axis: (0, 0, 1e-9), major_radius: 0.00001, minor_radius: 1.5)",
    "SmoothBalls(b: (-0.6, 0, 0), radius_b: 2)",
    "Hyperboloid(base: (0, -2, 0), end_radius: 2, waist_radius: 0)",
];

/// A wall behind the shape, by itself or with the shape cut out of a block far before it.
const PLAIN: &str = "SHAPE, Box(min: (-99, -99, -6), max: (99, 99, -5))";
const PART: &str = "Difference(parts: [Box(min: (-99, -99, -6), max: (99, 99, -5)), SHAPE])";
const WALL: f32 = -5.0;
const EYE: f32 = 8.0;
/// All shapes here lie within this distance from the origin.
const REACH: f32 = 3.5;
const SIDE: u32 = 16;
const FOV_DEG: f32 = 75.0;

#[test]
fn what_has_no_size_is_refused_at_its_place() {
    expect_none(REFUSED.into_iter().filter_map(|(call, message)| {
        let outcome = outcome_of("a.ron", &format!("(objects: [{call}])"), Mode::Live);
        let told = outcome.report.to_string();
        let is_told = outcome.compiled.is_none() && told.contains(message) && told.contains("a.ron:1:");
        (!is_told).then(|| format!("{call}: expected \"{message}\", found\n{told}"))
    }));
}

#[test]
fn what_is_flat_is_seen() {
    expect_none(DRAWN.into_iter().filter_map(|call| {
        let compiled = expect_compiled(outcome_of("a.ron", &scene(PLAIN, call), Mode::Baked));
        let nearer = depths(&compiled).into_iter().filter(|(_, behind)| *behind < -0.1).count();
        (nearer < 4).then(|| format!("{call}: {nearer} pixels show it"))
    }));
}

/// The light on a ball of radius 2 is the light on what shrinks to one.
#[test]
fn what_has_its_ends_in_one_point_is_a_ball() {
    let shape = |call: &str| pixels(&expect_compiled(outcome_of("a.ron", &scene(PLAIN, call), Mode::Baked)));
    let ball = shape("Sphere(radius: 2)");
    let balls = [
        "Capsule(top: (0, 0, 0), radius: 2)",
        "RoundedCone(top: (0, 0, 0), base_radius: 2)",
        "RoundedCone(top: (0, 0, 0), top_radius: 2)",
    ];
    expect_none(balls.into_iter().filter_map(|call| {
        let near = |(a, b): (&[f32; 4], &[f32; 4])| a.iter().zip(b).all(|(a, b)| (a - b).abs() < 1e-3);
        let other = shape(call).iter().zip(&ball).filter(|(a, b)| !near((a, b))).count();
        (other > 0).then(|| format!("{call}: {other} pixels are not the ball's"))
    }));
}

#[test]
fn no_value_makes_a_shape_leave_its_place() {
    let sources = Sources::in_memory();
    let library = Library::new(&sources, Path::new(""));
    let shapes = library.names(Family::Shape);
    assert_eq!(shapes.len(), 26);
    let functions =
        shapes.iter().map(|name| library.find(Family::Shape, name).expect("it ships with raytoy"));
    // A model has only what its file has, and a plane has no end.
    let bounded =
        |f: &Arc<Function>| !f.traits.is_endless && f.parameters.iter().all(|p| p.ty != Type::Model);
    expect_none(functions.filter(bounded).flat_map(|function| check(&function)));
}

/// What goes wrong with the odd values of `function`, which raytoy refuses or takes; or that none was asked.
fn check(function: &Function) -> Vec<String> {
    let stages = if function.traits.is_open { vec![PLAIN] } else { vec![PLAIN, PART] };
    let mut problems = vec![];
    let mut asked = 0;
    for stage in stages {
        let good = expect_compiled(outcome_of("a.ron", &scene(stage, &sample::call(function)), Mode::Live));
        let at = good
            .scene
            .primitives
            .iter()
            .position(|o| o.shape.name == function.name && function.name != "Box");
        let at = at.unwrap_or(usize::from(stage == PART));
        for index in 0..function.parameters.len() {
            for value in odd_values(&function.parameters[index], &good.scene.primitives[at].arguments) {
                asked += 1;
                let mut odd = good.scene.clone();
                odd.primitives[at].arguments[index] = Value::Const(value);
                let mut live = good.clone();
                live.source.numbers = generate(&odd, &Target::raytoy(Mode::Live)).numbers;
                problems.extend(strays(&live).map(|why| {
                    format!(
                        "{}, {} = {value:?}, {stage}: {why}",
                        function.name, function.parameters[index].name
                    )
                }));
            }
        }
    }
    if asked == 0 {
        problems.push(format!("{} has no value to ask about", function.name));
    }
    problems
}

/// What a parameter might be given, also beyond its limits.
fn odd_values(parameter: &Parameter, others: &[Value]) -> Vec<Const> {
    let low = parameter.range.map_or(0.0, |(low, _)| low);
    match parameter.ty {
        Type::F32 => [0.0, low, 1e-30].map(Const::F32).to_vec(),
        Type::U32 => vec![Const::U32(0)],
        Type::Vec3 => {
            let flat = |v: glam::Vec3| [v, v * glam::vec3(1.0, 0.0, 1.0), v * 1e-12];
            let vectors = others.iter().filter_map(|other| match other {
                Value::Const(Const::Vec3(v)) => Some(*v),
                _ => None,
            });
            // As another point of the shape, so that the two coincide.
            vectors.flat_map(flat).chain([glam::Vec3::ZERO]).map(Const::Vec3).collect()
        }
        _ => vec![],
    }
}

/// Where something other than the wall is seen beyond the reach of all shapes, or a number is none.
fn strays(compiled: &Compiled) -> Option<String> {
    let depths = depths(compiled);
    let stray = depths.iter().filter(|(aside, behind)| *aside > REACH && behind.abs() > 1e-3).count();
    (stray > 0).then(|| format!("{stray} pixels beside it are not the wall's"))
}

/// Light and depth of each pixel.
fn pixels(compiled: &Compiled) -> Vec<[f32; 4]> {
    let moment = Moment::of(&compiled.scene);
    let (size, casters) = ([SIDE; 2], compiled.scene.casters());
    let frame = FrameUniforms::new(&moment, &compiled.scene.render, casters, size, 0, [0.0; 2]);
    let sketch = Sketch::new(compiled).expect("what ships with raytoy has a sketch");
    sketch.draw(&frame, Duration::from_secs(600)).expect("there is time")
}

/// How far the ray of each pixel passes the origin, and how far behind the wall it ends.
fn depths(compiled: &Compiled) -> Vec<(f32, f32)> {
    let pixels = pixels(compiled);
    let half = (0.5 * FOV_DEG).to_radians().tan();
    let slope = |i: u32| ((i as f32 + 0.5) / SIDE as f32 * 2.0 - 1.0) * half;
    let place = |(i, pixel): (usize, &[f32; 4])| {
        let across = slope(i as u32 % SIDE).hypot(slope(i as u32 / SIDE));
        let length = (1.0 + across * across).sqrt();
        assert!(pixel.iter().all(|x| x.is_finite()), "a pixel is no number");
        (EYE * across / length, pixel[3] / length - (EYE - WALL))
    };
    pixels.iter().enumerate().map(place).collect()
}

fn scene(stage: &str, shape: &str) -> String {
    let objects = stage.replace("SHAPE", shape);
    format!(
        "(camera: (eye: (0, 0, {EYE}), target: (0, 0, 0), fov_deg: {FOV_DEG}), lights: [Point(position: (4, 6, 9))], objects: [{objects}])"
    )
}
