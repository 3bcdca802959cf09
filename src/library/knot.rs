//! A model to be looked at where nobody has given one.

use std::f32::consts::TAU;
use std::fmt::Write;

use glam::Vec3;

/// What scenes that have it in memory call it.
pub const FILE: &str = "knot.obj";

/// Corners along the knot, and around its tube.
const ALONG: u32 = 180;
const AROUND: u32 = 18;

/// A trefoil knot in OBJ, about two units wide: a tube around a line that goes twice around the axis and
/// three times around a ring.
pub fn obj() -> String {
    let mut text = String::new();
    for i in 0..ALONG {
        let turn = i as f32 / ALONG as f32 * TAU;
        let forward = (middle(turn + 0.01) - middle(turn - 0.01)).normalize();
        let away = middle(turn) - ring(turn);
        let side = (away - away.dot(forward) * forward).normalize();
        let up = forward.cross(side);
        for j in 0..AROUND {
            let around = j as f32 / AROUND as f32 * TAU;
            let p = middle(turn) + 0.2 * (around.cos() * side + around.sin() * up);
            line(&mut text, "v", p.to_array().map(|x| format!("{x:.4}")));
        }
    }
    let corner = |i: u32, j: u32| (i % ALONG) * AROUND + j % AROUND + 1;
    for (i, j) in (0..ALONG).flat_map(|i| (0..AROUND).map(move |j| (i, j))) {
        let corners = [corner(i, j), corner(i, j + 1), corner(i + 1, j + 1), corner(i + 1, j)];
        line(&mut text, "f", corners.map(|n| n.to_string()));
    }
    text
}

fn line<const N: usize>(text: &mut String, kind: &str, words: [String; N]) {
    writeln!(text, "{kind} {}", words.join(" ")).expect("a String takes all text");
}

fn ring(turn: f32) -> Vec3 {
    0.66 * Vec3::new((2.0 * turn).cos(), 0.0, (2.0 * turn).sin())
}

fn middle(turn: f32) -> Vec3 {
    let reach = 1.0 + 0.5 * (3.0 * turn).cos();
    reach * ring(turn) + Vec3::new(0.0, 0.33 * (3.0 * turn).sin(), 0.0)
}
