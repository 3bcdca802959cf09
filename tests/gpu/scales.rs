//! The same scene a thousand times smaller and ten thousand times larger is the same picture: no acne, no leaks.

use crate::common::{expect_compiled, expect_none, outcome_of};
use crate::device;
use raytoy::frame::Moment;
use raytoy::gpu::{Gpu, render};
use raytoy::wgsl::Mode;

const SIZE: [u32; 2] = [160, 120];

const SCALES: [f32; 4] = [1e-3, 0.1, 30.0, 1e4];

/// Lengths stand in angle brackets.
const SCENES: [(&str, &str); 3] = [
    (
        "shapes on a floor",
        "camera: (eye: (<0.5>, <3>, <7>), target: (0, <0.6>, 0)),
        lights: [Point(position: (<4>, <6>, <3>), radius: <0.3>), Directional(direction: (1, -1, -0.2), intensity: 0.4)],
        objects: [
            Plane(material: (color: 0.7, reflectivity: 0.2)),
            Sphere(center: (<-1.6>, <0.7>, 0), radius: <0.7>, material: (color: 0.4, reflectivity: 0.4)),
            Torus(center: (<0.3>, <0.3>, <0.8>), major_radius: <0.7>, minor_radius: <0.25>),
            Cone(base: (<1.8>, 0, 0), top: (<1.8>, <1.4>, 0), base_radius: <0.6>),
            Difference(translate: (<0.2>, <0.6>, <-1.2>), parts: [
                Box(min: (<-0.6>, <-0.6>, <-0.6>), max: (<0.6>, <0.6>, <0.6>)), Sphere(radius: <0.75>),
            ]),
        ]",
    ),
    (
        "a room from inside",
        "camera: (eye: (<0.6>, <0.9>, <0.7>), target: (<-0.4>, <0.4>, <-0.6>), fov_deg: 75),
        lights: [Point(position: (0, <0.9>, 0))],
        objects: [
            Box(min: (<-1>, 0, <-1>), max: (<1>, <1>, <1>)),
            RoundedBox(min: (<-0.6>, 0, <-0.6>), max: (<-0.1>, <0.4>, <-0.1>), radius: <0.05>),
            Cylinder(base: (<0.4>, 0, <-0.5>), top: (<0.4>, <0.5>, <-0.5>), radius: <0.15>),
        ]",
    ),
    (
        "glass and a shape that is marched to",
        "camera: (eye: (0, <2>, <5>), target: (0, <0.6>, 0)), background: 0.6,
        lights: [Point(position: (<4>, <6>, <3>))],
        objects: [
            Plane(), Sphere(center: (<-0.9>, <0.8>, 0), radius: <0.8>, material: (color: 0, transmission: 1)),
            MengerSponge(center: (<1>, <0.7>, 0), size: <1.4>, levels: 2, rotate_deg: (0, 30, 0)),
        ]",
    ),
];

/// The share of pixels that may differ by more than two steps of a channel: edges round another way.
const MAX_OFF: f64 = 0.004;

#[test]
fn a_scene_looks_the_same_at_every_scale() {
    let Some(gpu) = device::gpu() else { return };
    expect_none(SCENES.iter().flat_map(|(name, scene)| {
        let expected = draw(gpu, scene, 1.0);
        SCALES.iter().filter_map(move |scale| {
            let actual = draw(gpu, scene, *scale);
            let differs = |(a, b): &(&[u8], &[u8])| a.iter().zip(*b).any(|(x, y)| x.abs_diff(*y) > 2);
            let off = expected.chunks(4).zip(actual.chunks(4)).filter(differs).count();
            let share = off as f64 / f64::from(SIZE[0] * SIZE[1]);
            eprintln!("{name}, {scale} times as large: {share:.4} of the pixels differ");
            (share > MAX_OFF)
                .then(|| format!("{name}, {scale} times as large: {share:.4} of the pixels differ"))
        })
    }));
}

fn draw(gpu: &Gpu, scene: &str, scale: f32) -> Vec<u8> {
    let mut text = String::from("(");
    for (i, part) in scene.split(['<', '>']).enumerate() {
        match i % 2 {
            0 => text += part,
            _ => text += &(part.parse::<f32>().expect("a number in brackets") * scale).to_string(),
        }
    }
    text.push(')');
    let compiled = expect_compiled(outcome_of("a.ron", &text, Mode::Live));
    render(gpu, &compiled, &Moment::of(&compiled.scene), SIZE, 1, &mut |_| ())
        .unwrap_or_else(|error| panic!("{text}: {error}"))
        .rgba
}
