//! Which triangles stand for one smooth surface where a file gives no normals.

use std::f64::consts::TAU;
use std::fmt::Write;

use glam::Vec3;
use raytoy::assets::Corner;

use super::reading_obj::faces;
use super::shapes;

fn geometric_normal(triangle: &[Corner; 3]) -> Vec3 {
    let [a, b, c] = triangle.map(|corner| corner.position);
    (b - a).cross(c - a).normalize()
}

/// The largest angle between the normal of a corner and that of its triangle, degrees.
fn bend(text: &str) -> f32 {
    let found = faces(text.as_bytes());
    let angles =
        found.iter().flat_map(|t| t.map(|c| c.normal.angle_between(geometric_normal(t)).to_degrees()));
    angles.fold(0.0, f32::max)
}

/// A wall of so many sides around y, without ends.
fn pipe(sides: usize) -> String {
    let mut text = String::new();
    for i in 0..sides {
        let (sin, cos) = (TAU * i as f64 / sides as f64).sin_cos();
        writeln!(text, "v {cos} 0 {sin}\nv {cos} 1 {sin}").expect("a String takes all text");
    }
    for i in 0..sides {
        let next = (i + 1) % sides;
        let corners = [2 * i + 1, 2 * i + 2, 2 * next + 2, 2 * next + 1];
        writeln!(text, "f {} {} {} {}", corners[0], corners[1], corners[2], corners[3])
            .expect("a String takes all text");
    }
    text
}

#[test]
fn sharp_edges_stay_sharp_and_round_ones_are_smooth() {
    // What a person sees as flat sides, and what as round.
    assert!(bend(&shapes::made("cube.obj").unwrap()) < 1e-3);
    assert!(bend(&pipe(4)) < 1e-3 && bend(&pipe(6)) < 1e-3);
    assert!((bend(&pipe(8)) - 22.5).abs() < 0.1 && (bend(&pipe(30)) - 6.0).abs() < 0.1);
    assert!(bend(&shapes::made("torus.obj").unwrap()) > 3.0);
}

#[test]
fn smoothing_is_as_the_file_says() {
    let cube = shapes::made("cube.obj").unwrap();
    let (corners, sides) = cube.split_at(cube.find("f ").unwrap());
    let of = |before: &str| bend(&format!("{corners}{before}\n{sides}"));
    for flat in ["s off", "s 0", "s\tnull"] {
        assert!(of(flat) < 1e-3, "{flat}");
        assert!(bend(&format!("{flat}\n{}", pipe(30))) < 1e-3, "{flat}");
    }
    // One group for all: a cube like a pillow, which is what it says.
    for round in ["s 1", "s 7", "s on"] {
        assert!((of(round) - 54.7).abs() < 0.1, "{round}: {}", of(round));
    }
    // A group for each side.
    let grouped = |group: fn(usize) -> usize| {
        let sides = sides.lines().enumerate().map(|(i, side)| format!("s {}\n{side}\n", group(i)));
        bend(&format!("{corners}{}", sides.collect::<String>()))
    };
    assert!(grouped(|i| i + 1) < 1e-3);
    // Opposite sides have no corner in common: the cube's come in pairs.
    assert!(grouped(|i| i / 2 + 1) < 1e-3);
    assert!(grouped(|i| i % 2 + 1) > 30.0);
    // Faces before the first `s` are flat, as the format has it.
    let later = format!("{corners}{sides}s 1\n");
    assert!(bend(&later) < 1e-3);
}

#[test]
fn a_face_that_lies_on_the_back_of_another_bends_neither() {
    let found = faces(b"v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\nf 3 2 1\n");
    assert!(found.iter().all(|t| t.iter().all(|corner| corner.normal.distance(geometric_normal(t)) < 1e-6)));
}
