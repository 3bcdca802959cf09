//! The filtered value of a pattern with edges beside the mean of its hard values over the footprint: a square
//! of the floor as wide as a pixel.

use crate::common::expect_none;
use crate::device;
use crate::patterns::{built_in, by_devices, values};
use glam::{Vec2, Vec3};
use raytoy::gpu::Gpu;
use raytoy::laws::{Panel, Random, World, on_floor};
use raytoy::wgsl::Mode;

/// A call in black and white, how many scene units a cell of it has, and the most that the filter may be off,
/// as a mean over many places: measured, and rounded up. How pieces differ in brightness is left out: that is
/// no edge.
const PATTERNS: [(&str, f32, f64); 36] = [
    ("Checker(even: 1, odd: 0)", 1.0, 0.005),
    ("Stripes(even: 1, odd: 0)", 1.0, 0.005),
    ("Brick(variation: 0, clay: 1, joint: 0)", 0.25, 0.005),
    ("Grid(color: 1, ground: 0)", 0.5, 0.005),
    ("Herringbone(variation: 0, wood: 1, joint: 0)", 0.3333, 0.005),
    ("Dots(color: 1, ground: 0)", 0.5, 0.01),
    ("Cairo(variation: 0, stone: 1, joint: 0)", 0.5, 0.01),
    ("Rings(even: 1, odd: 0)", 0.4, 0.01),
    ("Spiral(even: 1, odd: 0)", 0.6, 0.01),
    ("Pavement(octagon: 1, square: 0, joint: 0.5)", 0.5, 0.01),
    ("Plaid(ground: 1, check: 0, stripe: 0.5, line: 0)", 1.0, 0.01),
    ("Hexagon(first: 1, second: 0.5, third: 0, joint: 0.5)", 0.5, 0.02),
    ("Weave(warp: 1, weft: 0.5, ground: 0)", 0.3333, 0.02),
    ("Scales(variation: 0, tip: 1, base: 0.5, rim: 0)", 0.3333, 0.015),
    ("Triangles(even: 1, odd: 0, joint: 0.5)", 0.6667, 0.01),
    ("Truchet(line: 0.5, even: 1, odd: 0)", 0.5, 0.02),
    ("Terrazzo(variation: 0, ground: 0, first: 1, second: 1, third: 1)", 0.3333, 0.02),
    ("Crackle(variation: 0, plate: 1, crack: 0)", 0.55, 0.02),
    ("Crackle(variation: 0, plate: 1, crack: 0, jitter: 0.5)", 0.55, 0.02),
    ("Crackle(variation: 0, plate: 1, crack: 0, width: 0.2)", 0.55, 0.02),
    ("Crackle(variation: 0, plate: 1, crack: 0, width: 0.2, jitter: 0)", 0.55, 0.02),
    ("Crackle(variation: 0, plate: 1, crack: 0, width: 0.5)", 0.55, 0.02),
    ("Cells(first: 1, second: 0)", 0.4, 0.02),
    ("Voronoi(feature: f1)", 0.5, 0.02),
    ("Voronoi(feature: f1, jitter: 0)", 0.5, 0.005),
    ("Voronoi(feature: f2)", 0.5, 0.02),
    ("Voronoi(feature: difference)", 0.5, 0.02),
    ("Voronoi(feature: difference, metric: manhattan, jitter: 0.5)", 0.5, 0.02),
    ("Voronoi(feature: difference, metric: chebyshev, jitter: 0.5)", 0.5, 0.02),
    ("Voronoi(feature: edge)", 0.5, 0.02),
    ("Voronoi(feature: edge, jitter: 0)", 0.5, 0.01),
    ("Voronoi(feature: edge, jitter: 0.4)", 0.5, 0.02),
    ("Voronoi(feature: edge, metric: chebyshev)", 0.5, 0.02),
    ("Voronoi(feature: cell)", 0.5, 0.02),
    ("Voronoi(feature: cell, metric: manhattan)", 0.5, 0.02),
    ("Voronoi(feature: cell, metric: chebyshev)", 0.5, 0.02),
];

/// Footprints, in cells.
const WIDTHS: [f32; 8] = [1.0 / 16.0, 0.25, 0.5, 1.0, 1.5, 2.0, 3.0, 4.0];
const CENTERS: usize = 256;
/// Hard values in each footprint.
const SAMPLES: u32 = 1024;

#[test]
fn filters_give_the_mean_over_the_footprint() {
    let world = built_in();
    let check = |gpu: &Gpu, (call, cell, most): &(&str, f32, f64)| check(gpu, &world, call, *cell, *most);
    let Some(found) = by_devices(&PATTERNS, check) else { return };
    expect_none(found.into_iter().flatten());
}

#[test]
fn a_pattern_without_a_filter_is_found() {
    let Some(gpu) = device::gpu() else { return };
    let text = "/// Hard.\nfn hard(at: Surface) -> f32 {\n    return step(0.5, fract(at.uv.x));\n}\n";
    let world = World { files: vec![("textures/hard.wgsl".into(), text.into())], ..World::default() };
    let found = check(gpu, &world, "Hard()", 1.0, 0.03);
    assert_eq!(found.len(), WIDTHS.len() - 1, "{found:?}");
}

fn check(gpu: &Gpu, world: &World, call: &str, cell: f32, most: f64) -> Vec<String> {
    let panel = Panel::new(gpu, world, &[call.to_owned()], Mode::Baked);
    let panel = panel.unwrap_or_else(|problem| panic!("{call}: {problem}"));
    let value = |points: &[_]| values(&panel, points);
    let mut errors = vec![];
    for width in WIDTHS {
        let mut random = Random(3);
        let centers: Vec<Vec3> =
            (0..CENTERS).map(|_| 16.0 * cell * random.vector() * Vec3::new(1.0, 0.0, 1.0)).collect();
        let filtered = value(&centers.iter().map(|p| on_floor(*p, width * cell)).collect::<Vec<_>>());
        // Roberts's R2 points (The Unreasonable Effectiveness of Quasirandom Sequences, 2018): no two share a row,
        // and they do not keep step with the cells, as points in steps of powers of two do.
        let place = |i: u32| {
            let along = |step: f64| ((f64::from(i) + 0.5) * step).fract() as f32;
            Vec2::new(along(0.754_877_666_246_692_7), along(0.569_840_290_998_053_2))
        };
        let inside = |p: Vec3| {
            let offset = move |i| width * cell * (place(i) - 0.5);
            (0..SAMPLES).map(move |i| on_floor(p + Vec3::new(offset(i).x, 0.0, offset(i).y), 0.0))
        };
        let hard = value(&centers.iter().flat_map(|p| inside(*p)).collect::<Vec<_>>());
        let mean = |hard: &[Vec3]| hard.iter().sum::<Vec3>() / hard.len() as f32;
        let off =
            |(hard, filtered): (&[Vec3], &Vec3)| f64::from((mean(hard) - *filtered).abs().max_element());
        let error = hard.chunks(SAMPLES as usize).zip(&filtered).map(off).sum::<f64>() / CENTERS as f64;
        errors.push(error);
    }
    eprintln!("{call}: {errors:.4?}");
    let wrong = WIDTHS.into_iter().zip(errors).filter(|(_, error)| *error > most);
    wrong
        .map(|(width, error)| {
            format!("{call}: off by {error:.4} where a pixel is {width} cells, {most} allowed")
        })
        .collect()
}
