//! The models that rays are shot at: those of the gallery, and some that are made here.

use std::f64::consts::TAU;
use std::fmt::Write;

use glam::DVec3;

/// All of them closed.
pub const MODELS: [&str; 5] = ["knot.obj", "gem.glb", "cube.obj", "torus.obj", "ball.obj"];

/// The text of a model that is not in scenes/models/.
pub fn made(name: &str) -> Option<String> {
    match name {
        "cube.obj" => Some(cube()),
        "torus.obj" => Some(torus()),
        "ball.obj" => Some(ball(24)),
        _ => None,
    }
}

/// Flat sides along the axes; each is a face of four corners.
fn cube() -> String {
    let mut text = String::new();
    for i in 0..8 {
        let side = |bit: i32| if i >> bit & 1 == 1 { 1 } else { -1 };
        vertex(&mut text, DVec3::new(side(0).into(), side(1).into(), side(2).into()));
    }
    text + "f 1 3 4 2\nf 5 6 8 7\nf 1 2 6 5\nf 3 7 8 4\nf 1 5 7 3\nf 2 4 8 6\n"
}

/// A ring around y, whose faces are no parallelograms.
fn torus() -> String {
    const AROUND: [usize; 2] = [48, 20];
    grid(AROUND, |[a, b]| {
        let out = 1.0 + 0.35 * b.cos();
        DVec3::new(out * a.sin(), 0.35 * b.sin(), out * a.cos())
    })
}

/// A ball of radius 1 in twice as many meridians as parallels; at the poles many triangles meet.
pub fn ball(parallels: usize) -> String {
    let meridians = 2 * parallels;
    let mut text = String::new();
    vertex(&mut text, DVec3::Y);
    for i in 1..parallels {
        for j in 0..meridians {
            let (down, around) = (TAU * 0.5 * i as f64 / parallels as f64, TAU * j as f64 / meridians as f64);
            vertex(&mut text, DVec3::new(down.sin() * around.sin(), down.cos(), down.sin() * around.cos()));
        }
    }
    vertex(&mut text, DVec3::NEG_Y);
    let corner = |i: usize, j: usize| match i {
        0 => 1,
        i => (2 + (i.min(parallels) - 1) * meridians + if i < parallels { j % meridians } else { 0 }) as i32,
    };
    for (i, j) in (0..parallels).flat_map(|i| (0..meridians).map(move |j| (i, j))) {
        let [a, b, c, d] = [corner(i, j), corner(i + 1, j), corner(i + 1, j + 1), corner(i, j + 1)];
        let face = match i {
            0 => format!("f {a} {b} {c}"),
            i if i + 1 == parallels => format!("f {a} {b} {d}"),
            _ => format!("f {a} {b} {c} {d}"),
        };
        writeln!(text, "{face}").expect("a String takes all text");
    }
    text
}

/// A surface that closes in both directions, in faces of four corners; `point` takes angles.
fn grid(count: [usize; 2], point: impl Fn([f64; 2]) -> DVec3) -> String {
    let mut text = String::new();
    let all = || (0..count[0]).flat_map(|i| (0..count[1]).map(move |j| [i, j]));
    for at in all() {
        vertex(&mut text, point([0, 1].map(|k| TAU * at[k] as f64 / count[k] as f64)));
    }
    let corner = |i: usize, j: usize| i % count[0] * count[1] + j % count[1] + 1;
    for [i, j] in all() {
        let [a, b, c, d] = [corner(i, j), corner(i + 1, j), corner(i + 1, j + 1), corner(i, j + 1)];
        writeln!(text, "f {a} {b} {c} {d}").expect("a String takes all text");
    }
    text
}

fn vertex(text: &mut String, p: DVec3) {
    writeln!(text, "v {} {} {}", p.x, p.y, p.z).expect("a String takes all text");
}

/// Ways from zero to where surveys lie.
pub const FAR: [DVec3; 3] = [
    DVec3::new(512_345.625, 5_401_234.375, 431.5),
    DVec3::new(-500_000.0, 0.1, 5_000_000.0),
    DVec3::new(0.0, 0.0, 20_000.3),
];

/// The torus, moved by all digits.
pub fn far_torus(by: DVec3) -> String {
    let torus = made("torus.obj").unwrap();
    let moved = torus.lines().map(|line| match line.strip_prefix("v ") {
        Some(numbers) => {
            let p: Vec<f64> = numbers.split(' ').map(|x| x.parse().unwrap()).collect();
            let p = DVec3::from_slice(&p) + by;
            format!("v {} {} {}\n", p.x, p.y, p.z)
        }
        None => format!("{line}\n"),
    });
    moved.collect()
}
