//! Each pixel's shadow bit beside the reference's in f64, where acne and leaks would be: in closed rooms and
//! where things touch, a thousand times smaller to ten thousand times larger.

// Its own tests are not run here.

use crate::device;
use std::ops::ControlFlow;

use crate::common::{expect_compiled, expect_none, outcome_of};
use crate::reference::Scene;
use raytoy::Compiled;
use raytoy::frame::{Moment, View};
use raytoy::gpu::{Gpu, Renderer};
use raytoy::wgsl::Mode;

/// The variable with how many bits to compare for each scene and scale.
const BITS: &str = "RAYTOY_SHADOW_BITS";
const FEW_BITS: f64 = 10_000.0;

const SCALES: [f32; 8] = [1e-3, 1e-2, 0.1, 1.0, 10.0, 100.0, 1e3, 1e4];

/// Rays start 1e-5 of the scene's size off the surface. What changes within twice as much is left out.
const NEAR: f64 = 2e-5;
/// The share that may be left out.
const MAX_UNCLEAR: f64 = 2e-3;

/// Lengths stand in angle brackets.
struct Place {
    name: &'static str,
    /// From where, and at what.
    views: [&'static str; 4],
    light: &'static str,
    objects: &'static [&'static str],
}

const QUADS: &str = "
    Quad(corner: (<-3>, 0, <-2>), u: (0, 0, <4>), v: (<6>, 0, 0)),
    Quad(corner: (<-3>, <3>, <-2>), u: (<6>, 0, 0), v: (0, 0, <4>)),
    Quad(corner: (<-3>, 0, <-2>), u: (<6>, 0, 0), v: (0, <3>, 0)),
    Quad(corner: (<-3>, 0, <2>), u: (0, <3>, 0), v: (<6>, 0, 0)),
    Quad(corner: (<-3>, 0, <-2>), u: (0, <3>, 0), v: (0, 0, <4>)),
    Quad(corner: (<3>, 0, <-2>), u: (0, 0, <4>), v: (0, <3>, 0)),";

const WALLS: &str = "
    Box(min: (<-3.1>, <-0.1>, <-2.1>), max: (<3.1>, 0, <2.1>)),
    Box(min: (<-3.1>, <3>, <-2.1>), max: (<3.1>, <3.1>, <2.1>)),
    Box(min: (<-3.1>, 0, <-2.1>), max: (<3.1>, <3>, <-2>)),
    Box(min: (<-3.1>, 0, <2>), max: (<3.1>, <3>, <2.1>)),
    Box(min: (<-3.1>, 0, <-2>), max: (<-3>, <3>, <2>)),
    Box(min: (<3>, 0, <-2>), max: (<3.1>, <3>, <2>)),";

const THINGS: &str = "
    Sphere(center: (<-1.5>, <0.7>, <-0.5>), radius: <0.7>),
    Cylinder(base: (<1>, 0, <-1>), top: (<1>, <3>, <-1>), radius: <0.2>),
    Torus(center: (<1.2>, <0.25>, <0.8>), major_radius: <0.6>, minor_radius: <0.25>),
    Cone(base: (<-2>, 0, <1.2>), top: (<-2>, <1>, <1.2>), base_radius: <0.5>),";

const IN_THE_ROOM: [&str; 4] = [
    "eye: (<2.7>, <2.5>, <1.7>), target: (<-1>, <0.5>, <-1>), fov_deg: 80",
    "eye: (<-2.8>, <0.2>, <-1.8>), target: (<3>, <1.5>, <2>), fov_deg: 80",
    // Into a corner, and along an edge.
    "eye: (<-2.6>, <2.5>, <1.5>), target: (<-3>, <3>, <2>), fov_deg: 60",
    "eye: (<2.9>, <0.05>, <-1.95>), target: (<-3>, 0, <-2>), fov_deg: 30",
];

const UNDER_THE_BALLS: [&str; 4] = [
    "eye: (<3>, <1.5>, <5>), target: (0, <0.8>, 0), fov_deg: 50",
    "eye: (<0.2>, <6>, <1>), target: (0, 0, 0), fov_deg: 50",
    // At a ball's foot, and where two meet.
    "eye: (<-2.2>, <0.15>, <1.2>), target: (<-1>, 0, 0), fov_deg: 30",
    "eye: (<0.1>, <1.6>, <1.4>), target: (0, <1>, 0), fov_deg: 30",
];

const BALLS: &str = "
    Plane(), Sphere(center: (<-1>, <1>, 0), radius: <1>), Sphere(center: (<1>, <1>, 0), radius: <1>),
    Sphere(center: (0, <0.25>, 0), radius: <0.25>), Sphere(center: (<3>, <0.5>, <-1>), radius: <0.5>),
    Box(min: (<-2.5>, 0, <-1>), max: (<-2>, <2>, <1>)),
    Cylinder(base: (<-1>, <2>, 0), top: (<-1>, <3>, 0), radius: <0.4>),";

const PLACES: [Place; 6] = [
    Place {
        name: "a closed room of quads, lit inside",
        views: IN_THE_ROOM,
        light: "Point(position: (<0.4>, <2.2>, <-0.3>))",
        objects: &[QUADS],
    },
    Place {
        name: "a closed room of quads, lit outside",
        views: IN_THE_ROOM,
        light: "Point(position: (<7>, <9>, <5>))",
        objects: &[QUADS],
    },
    Place {
        name: "a closed room of boxes with things in it, lit inside",
        views: IN_THE_ROOM,
        light: "Point(position: (<-0.4>, <2.9>, <0.3>))",
        objects: &[WALLS, THINGS],
    },
    Place {
        name: "a closed room of boxes, under the sun",
        views: IN_THE_ROOM,
        light: "Directional(direction: (-3, -4, -2))",
        objects: &[WALLS],
    },
    Place {
        name: "balls that touch, under a lamp",
        views: UNDER_THE_BALLS,
        light: "Point(position: (<2>, <5>, <3>))",
        objects: &[BALLS],
    },
    Place {
        name: "balls that touch, under a low sun",
        views: UNDER_THE_BALLS,
        light: "Directional(direction: (-5, -1, -2))",
        objects: &[BALLS],
    },
];

/// What came of some bits.
#[derive(Default)]
struct Bits {
    count: u64,
    unclear: u64,
    wrong: u64,
    example: String,
}

#[test]
fn no_shadow_bit_is_wrong() {
    let Some(gpu) = device::gpu() else { return };
    let bits = std::env::var(BITS).map_or(FEW_BITS, |bits| bits.parse().expect("a number of bits"));
    expect_none(PLACES.iter().flat_map(|place| place.check(gpu, bits)));
}

impl Place {
    fn check(&self, gpu: &Gpu, bits: f64) -> Vec<String> {
        let side = (bits / self.views.len() as f64).sqrt().ceil() as u32;
        let mut pictures: Option<(String, Renderer)> = None;
        let results = SCALES.map(|scale| {
            let mut sum = Bits::default();
            for view in self.views {
                let text = self.text(view, scale);
                let compiled = expect_compiled(outcome_of("place.ron", &text, Mode::Live));
                let shader = compiled.source.text();
                if pictures.as_ref().is_none_or(|(drawn, _)| *drawn != shader) {
                    let renderer = Renderer::new(gpu, &compiled, [side; 2]);
                    pictures = Some((shader, renderer.unwrap_or_else(|error| panic!("{text}: {error}"))));
                }
                let (_, renderer) = pictures.as_mut().expect("it was just made");
                sum.compare(renderer, &compiled, &text, side as usize);
            }
            let Bits { count, unclear, wrong, example } = sum;
            let told = format!("{}, {scale} times as large: {wrong} of {count} bits are wrong", self.name);
            eprintln!("{told}, {unclear} left out");
            let is_wrong = wrong > 0 || unclear as f64 > MAX_UNCLEAR * count as f64;
            is_wrong.then(|| format!("{told}, {unclear} left out; {example}"))
        });
        results.into_iter().flatten().collect()
    }

    fn text(&self, view: &str, scale: f32) -> String {
        let objects = self.objects.concat();
        let text = format!("(camera: ({view}), lights: [{}], objects: [{objects}])", self.light);
        let parts = text.split(['<', '>']).enumerate().map(|(i, part)| match i % 2 {
            0 => part.to_owned(),
            _ => (part.parse::<f32>().expect("a number in brackets") * scale).to_string(),
        });
        parts.collect()
    }
}

impl Bits {
    fn compare(&mut self, renderer: &mut Renderer, compiled: &Compiled, text: &str, side: usize) {
        let scene = Scene::parse(text).unwrap_or_else(|why| panic!("{text}: {why}"));
        renderer.take(compiled);
        let moment = Moment { view: View::Shadow, ..Moment::of(&compiled.scene) };
        let drawn = renderer.draw(&moment, 1, &mut |_| ControlFlow::Continue(()));
        let drawn = drawn.unwrap_or_else(|error| panic!("{text}: {error}")).expect("nobody stops it");
        for i in 0..side * side {
            let pixel = [i % side, i / side];
            let found = drawn.depth[i].is_finite().then_some(drawn.radiance[i][0] > 0.5);
            let expected = scene.is_lit(pixel, [side; 2]);
            self.count += 1;
            if found == expected {
                continue;
            }
            if scene.is_clear(pixel, [side; 2], NEAR) {
                self.wrong += 1;
                self.example = format!("pixel {pixel:?} is {found:?}, not {expected:?}, in {text}");
            } else {
                self.unclear += 1;
            }
        }
    }
}
