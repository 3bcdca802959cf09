//! The default limits of a picture: 30 small scenes, each with six changes that a person would want to know of,
//! which are all caught, and what is no change, which never is. `RAYTOY_ADAPTER` brings in another driver.

use crate::patterns;
use std::ops::ControlFlow;

use crate::common::expect_none;
use image::RgbImage;
use raytoy::Compiled;
use raytoy::difference::rgb;
use raytoy::frame::Moment;
use raytoy::gpu::{Gpu, Renderer};
use raytoy::judge::{Limits, Verdict, judge};
use raytoy::laws::World;
use raytoy::suite::{Settings, by_devices};
use raytoy::wgsl::Mode;

const BODIES: [&str; 10] = [
    "Sphere(center: (0, 0.8, 0), radius: 0.8",
    "Box(min: (-0.6, 0, -0.6), max: (0.6, 1.1, 0.6), rotate_deg: (0, 25, 0)",
    "Cylinder(top: (0, 1.2, 0), radius: 0.6",
    "Cone(top: (0, 1.4, 0), base_radius: 0.8",
    "Torus(center: (0, 0.3, 0), major_radius: 0.8, minor_radius: 0.3",
    "Capsule(base: (-0.4, 0.4, 0), top: (0.4, 0.7, 0), radius: 0.4",
    "Ellipsoid(center: (0, 0.6, 0), radii: (0.9, 0.6, 0.5)",
    "RoundedBox(min: (-0.6, 0, -0.6), max: (0.6, 0.9, 0.6), radius: 0.2",
    "HexPrism(center: (0, 0.5, 0), radius: 0.7, height: 1",
    "Pyramid(base: (0, 0, 0), top: (0, 1.3, 0), base_size: 1.4",
];

/// From nearly black to nearly white, linear.
const COLORS: [[f32; 3]; 10] = [
    [0.7, 0.3, 0.2],
    [0.06, 0.07, 0.1],
    [0.2, 0.5, 0.3],
    [0.9, 0.85, 0.8],
    [0.1, 0.2, 0.6],
    [0.5, 0.5, 0.5],
    [0.8, 0.6, 0.1],
    [0.3, 0.1, 0.3],
    [0.15, 0.4, 0.45],
    [0.6, 0.2, 0.4],
];

/// Lights and what the ground is like.
const LOOKS: [(&str, &str); 3] = [
    ("Point(position: (L, 5, 3))", ""),
    ("Point(position: (L, 4, 4), radius: 0.4)", "specular: 0.4, "),
    ("Directional(direction: (L, -3, -2), intensity: 0.8)", "reflectivity: 0.15, "),
];

/// A ball whose normals can be turned over.
const BEAD: &str = "/// A ball.
///
/// center = (0, 0, 0): its middle
/// radius = 1, 0.1 to 10: its radius
/// facing = 1: of its normals, -1 is inwards
fn bead(ray: Ray, center: vec3f, radius: f32, facing: f32) -> f32 {
    let middle = nearestApproach(ray, center);
    let nearest = ray.origin - center + middle * ray.direction;
    let inside = radius * radius - dot(nearest, nearest);
    if inside < 0.0 {
        return NO_HIT;
    }
    let reach = sqrt(inside / dot(ray.direction, ray.direction));
    return firstOnRay(ray, middle - reach, middle + reach);
}

fn beadSurface(p: vec3f, center: vec3f, radius: f32, facing: f32) -> Surface {
    return surface(p, facing * normalize(p - center), p.xy);
}
";

/// One scene, in numbers that can be changed.
#[derive(Clone, Copy, Debug)]
struct Stage {
    body: &'static str,
    look: usize,
    color: [f32; 3],
    light: f32,
    scale: f32,
    swapped: bool,
    facing: f32,
    has_ball: bool,
}

#[derive(Clone, Copy, Debug, PartialEq)]
enum Change {
    /// By 0.2 scene units of about 6.
    LightMoved,
    /// 5 % more of the light that it sends back.
    ColorOff,
    /// A ball of a ninth of the picture's height.
    ObjectMissing,
    /// By 2 %.
    PatternScaled,
    ParitySwapped,
    NormalsFlipped,
}

const CHANGES: [Change; 6] = [
    Change::LightMoved,
    Change::ColorOff,
    Change::ObjectMissing,
    Change::PatternScaled,
    Change::ParitySwapped,
    Change::NormalsFlipped,
];

#[test]
fn changes_are_caught_and_nothing_else_is() {
    let jobs: Vec<Stage> = stages();
    let Some(devices) = patterns::devices() else { return };
    let found = by_devices(&devices, &jobs, |gpu, stage| check(gpu, &devices, stage), &mut |_| ());
    let all: Vec<(String, Verdict)> = found.concat();
    let mut names: Vec<&str> = all.iter().map(|(name, _)| name.as_str()).collect();
    names.sort_unstable();
    names.dedup();
    for name in names {
        let of = || all.iter().filter(|(other, _)| other == name).map(|(_, verdict)| verdict);
        let caught = of().filter(|verdict| !verdict.passes()).count();
        let span = |value: fn(&Verdict) -> f64| {
            let values: Vec<f64> = of().map(value).collect();
            let low = values.iter().copied().fold(f64::INFINITY, f64::min);
            format!("{low:.5} to {:.5}", values.iter().copied().fold(f64::NEG_INFINITY, f64::max))
        };
        eprintln!(
            "| {name} | {caught} of {} | {} | {} | {} | {} |",
            of().count(),
            span(|v| v.outliers.share()),
            span(|v| v.structure.mean),
            span(|v| v.structure.least),
            span(|v| v.flip),
        );
    }
    expect_none(all.iter().filter_map(|(name, verdict)| {
        let is_same = name.starts_with("same");
        (verdict.passes() != is_same).then(|| format!("{name}: {:?}", verdict.broken()))
    }));
}

fn stages() -> Vec<Stage> {
    let stage = |i: usize| Stage {
        body: BODIES[i % 10],
        look: i / 10,
        color: COLORS[(i * 7) % 10],
        light: 3.0,
        scale: 1.0 + 0.1 * (i % 5) as f32,
        swapped: false,
        facing: 1.0,
        has_ball: true,
    };
    (0..30).map(stage).collect()
}

impl Stage {
    fn objects(&self) -> String {
        let [r, g, b] = self.color;
        let (even, odd) =
            if self.swapped { ("(0.05, 0.06, 0.08)", "0.8") } else { ("0.8", "(0.05, 0.06, 0.08)") };
        let ball = "Sphere(center: (-1.4, 0.25, 0.8), radius: 0.25, material: (color: (0.4, 0.3, 0.6))),";
        format!(
            "Plane(material: ({} color: Checker(scale: {}, even: {even}, odd: {odd}))),
            {}, material: (color: ({r}, {g}, {b}))),
            Bead(center: (1.3, 0.45, 0.7), radius: 0.45, facing: {}, casts_shadow: false,
                material: (color: 0, transmission: 1)),
            {}",
            LOOKS[self.look].1,
            self.scale,
            self.body,
            self.facing,
            if self.has_ball { ball } else { "" },
        )
    }

    fn compiled(&self, mode: Mode, before: Option<&Compiled>) -> Compiled {
        let light = LOOKS[self.look].0.replace('L', &self.light.to_string());
        let text = format!(
            "(camera: (eye: (2.2, 2.4, 5.5), target: (0, 0.5, 0)),
            background: Gradient(zenith: (0.1, 0.25, 0.6), horizon: 0.7),
            lights: [{light}], render: (shadow_samples: 4, max_bounces: 3), objects: [{}])",
            self.objects()
        );
        let world = World { files: vec![("shapes/bead.wgsl".into(), BEAD.into())], ..World::default() };
        let sources = world.sources().with("stage.ron", &text);
        let outcome = raytoy::compile(&sources, "stage.ron".as_ref(), mode, before);
        outcome.compiled.unwrap_or_else(|| panic!("{}", outcome.report))
    }

    fn changed(self, change: Change) -> Self {
        match change {
            Change::LightMoved => Self { light: self.light + 0.2, ..self },
            Change::ColorOff => Self { color: self.color.map(|x| 1.05 * x), ..self },
            Change::ObjectMissing => Self { has_ball: false, ..self },
            Change::PatternScaled => Self { scale: 1.02 * self.scale, ..self },
            Change::ParitySwapped => Self { swapped: true, ..self },
            Change::NormalsFlipped => Self { facing: -1.0, ..self },
        }
    }
}

fn check(gpu: &Gpu, devices: &[Gpu], stage: &Stage) -> Vec<(String, Verdict)> {
    let baked = stage.compiled(Mode::Baked, None);
    let mut written = renderer(gpu, &baked);
    let golden = picture(&mut written, &baked);
    let verdict = |name: &str, actual: &RgbImage| {
        (name.to_owned(), judge(&golden, actual, Limits::default()).expect("all are of one size"))
    };
    let live = stage.compiled(Mode::Live, None);
    let mut shown = renderer(gpu, &live);
    let mut found = vec![
        verdict("same, with numbers as data", &picture(&mut shown, &live)),
        verdict("same, drawn again", &picture(&mut written, &baked)),
    ];
    for other in devices.iter().filter(|other| other.describe() != gpu.describe()) {
        let theirs = picture(&mut renderer(other, &baked), &baked);
        found.push(verdict("same, by another driver", &theirs));
    }
    for change in CHANGES {
        let next = stage.changed(change).compiled(Mode::Live, Some(&live));
        let actual = if next.source.sections == live.source.sections {
            shown.take(&next);
            picture(&mut shown, &next)
        } else {
            picture(&mut renderer(gpu, &next), &next)
        };
        found.push(verdict(&format!("{change:?}"), &actual));
    }
    found
}

fn renderer(gpu: &Gpu, compiled: &Compiled) -> Renderer {
    let size = Settings::default().size;
    Renderer::new(gpu, compiled, size).unwrap_or_else(|error| panic!("{error}"))
}

fn picture(renderer: &mut Renderer, compiled: &Compiled) -> RgbImage {
    let samples = Settings::default().samples;
    let drawn = renderer.draw(&Moment::of(&compiled.scene), samples, &mut |_| ControlFlow::Continue(()));
    rgb(&drawn.unwrap_or_else(|error| panic!("{error}")).expect("nobody stops it"))
}
