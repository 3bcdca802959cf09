//! One filtered sample beside many plain ones: a checkered floor to the horizon, seen directly and in a mirror.

use crate::common::{expect_compiled, expect_none, outcome_of};
use crate::device;
use raytoy::frame::Moment;
use raytoy::gpu::{Gpu, render};
use raytoy::wgsl::Mode;

const SIZE: [usize; 2] = [96, 72];
/// The truth is the mean of this many by this many plain samples to a pixel.
const FINE: usize = 32;
/// The plain samples that one filtered one is to be better than: this many by this many.
const PLAIN: usize = 4;

const SCENES: [(&str, &str); 3] = [
    (
        "to the horizon",
        "camera: (eye: (0.3, 1, 0), target: (4.3, 0.85, 9)), objects: [Plane(material: FLOOR)]",
    ),
    (
        "in a mirror",
        "camera: (eye: (0.3, 1.5, 0), target: (2.3, 1.2, -9)), objects: [Plane(material: FLOOR),
            Plane(normal: (0.1, 0, 1), offset: -3, material: (color: 0, reflectivity: 1))]",
    ),
    (
        "through a pane of glass",
        "camera: (eye: (0.3, 1, 0), target: (4.3, 0.85, 9)), objects: [Plane(material: FLOOR),
            Box(min: (-9, 0, 1), max: (9, 4, 1.2), material: (color: 0, transmission: 1, ior: 1.3))]",
    ),
];

#[test]
fn one_filtered_sample_is_better_than_sixteen_plain_ones() {
    let Some(gpu) = device::gpu() else { return };
    expect_none(SCENES.iter().filter_map(|(name, scene)| {
        let truth = means(gpu, scene, FINE);
        let error = |picture: &[f32]| {
            let squares = picture.iter().zip(&truth).map(|(a, b)| f64::from(a - b).powi(2));
            (squares.sum::<f64>() / truth.len() as f64).sqrt()
        };
        let filtered = error(&brightness(gpu, scene, true, 1));
        let plain = error(&means(gpu, scene, PLAIN));
        eprintln!("{name}: root mean square error {filtered:.4} filtered, {plain:.4} of 16 plain samples");
        (filtered >= plain).then(|| format!("{name}: {filtered:.4} filtered, but {plain:.4} plain"))
    }));
}

/// Means of `n` by `n` plain samples.
fn means(gpu: &Gpu, scene: &str, n: usize) -> Vec<f32> {
    let fine = brightness(gpu, scene, false, n);
    let [width, height] = SIZE;
    let mean = |x: usize, y: usize| {
        let rows = (0..n).flat_map(|j| {
            let from = (y * n + j) * width * n + x * n;
            &fine[from..from + n]
        });
        rows.sum::<f32>() / (n * n) as f32
    };
    (0..height).flat_map(|y| (0..width).map(move |x| mean(x, y))).collect()
}

/// The brightness of a picture `zoom` times as large, one sample to a pixel.
fn brightness(gpu: &Gpu, scene: &str, is_filtered: bool, zoom: usize) -> Vec<f32> {
    let scene = scene.replace("FLOOR", "(color: Checker(even: 1.0, odd: 0.0))");
    let text = format!("({scene}, ambient: 1, background: 0.5, render: (texture_filter: {is_filtered}))");
    let compiled = expect_compiled(outcome_of("a.ron", &text, Mode::Baked));
    let size = SIZE.map(|n| (n * zoom) as u32);
    let picture = render(gpu, &compiled, &Moment::of(&compiled.scene), size, 1, &mut |_| ());
    let picture = picture.unwrap_or_else(|error| panic!("{text}: {error}"));
    picture.radiance.iter().map(|rgb| rgb[0]).collect()
}
