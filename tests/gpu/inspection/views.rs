//! Two views in one picture, and numbers as colors.

use crate::{device, draw};
use glam::Vec3;
use raytoy::export::{Language, export};
use raytoy::frame::{Moment, Split, View};
use raytoy::gpu::{Gpu, Picture, render};
use raytoy::ir::Measure;
use raytoy::sources::Sources;
use raytoy::wgsl::Mode;
use raytoy::{Compiled, compile};

use super::{SIZE, identity, middles, scene};
use crate::common::{expect_compiled, outcome_of};

/// The colors of shaders/number_color.wgsl.
const BELOW: Vec3 = Vec3::new(0.08, 0.28, 0.72);
const ABOVE: Vec3 = Vec3::new(0.75, 0.12, 0.1);

const BALLS: &str = "(camera: (eye: (1, 2, 6), target: (0, 0, 0)), background: 2.5,
    render: (tone_map: Aces, exposure: -1, max_bounces: 2),
    lights: [Point(position: (3, 5, 4), radius: 0.5)],
    objects: [Plane(offset: -1, material: (color: Checker())), Sphere(material: (reflectivity: 0.4))])";

fn drawn(gpu: &Gpu, compiled: &Compiled, moment: &Moment) -> Picture {
    render(gpu, compiled, moment, SIZE, 3, &mut |_| ()).unwrap_or_else(|e| panic!("{e}"))
}

#[test]
fn each_half_of_a_split_picture_is_that_of_its_view_alone() {
    let Some(gpu) = device::gpu() else { return };
    let compiled = scene(BALLS);
    let own = Moment::of(&compiled.scene);
    let alone = |view| drawn(gpu, &compiled, &Moment { view, ..own });
    let pairs = [
        (View::Color, View::Normal),
        (View::Normal, View::Color),
        (View::Depth, View::Object),
        (View::Color, View::Color),
    ];
    for (left, right) in pairs {
        let (a, b) = (alone(left), alone(right));
        for at in [0.0, 0.3, 0.5, 1.0] {
            let split = Split { view: right, at };
            let both = drawn(gpu, &compiled, &Moment { view: left, split: Some(split), ..own });
            assert_eq!(split.column(SIZE[0]), (at * SIZE[0] as f32).round() as u32);
            for (x, y, _) in middles(SIZE) {
                let i = (y * SIZE[0] + x) as usize;
                let half = if x < split.column(SIZE[0]) { &a } else { &b };
                assert_eq!(both.radiance[i], half.radiance[i], "{left:?} | {right:?} at {at}: {x}, {y}");
                assert_eq!(
                    both.rgba[4 * i..][..4],
                    half.rgba[4 * i..][..4],
                    "{left:?} | {right:?}: {x}, {y}"
                );
                assert_eq!(both.depth[i], half.depth[i]);
            }
        }
    }
}

#[test]
fn light_is_told_from_values_column_by_column() {
    let views = [View::Color, View::Normal, View::Cost];
    for (left, right) in views.into_iter().flat_map(|left| views.map(|right| (left, right))) {
        for (width, at) in [(1, 0.4), (1, 0.6), (97, 0.5), (640, 0.123), (640, -1.0), (640, 2.0)] {
            let split = Split { view: right, at };
            let light = left.columns_of_light(Some(split), width);
            let shown = |x: u32| if x < split.column(width) { left } else { right };
            assert!(
                (0..width).all(|x| light.contains(&x) == (shown(x) == View::Color)),
                "{left:?} {split:?}"
            );
        }
        assert_eq!(left.columns_of_light(None, 9).len(), if left == View::Color { 9 } else { 0 });
    }
}

/// One sample of `measure` in colors up to `reach`.
fn colors(gpu: &Gpu, compiled: &Compiled, measure: &str, reach: f32) -> Picture {
    let measure = Measure::named(&compiled.scene, measure).expect("the scene has it");
    let measuring = compiled.measuring(measure).unwrap_or_else(|e| panic!("{e:?}"));
    let moment = Moment { view: View::Value, reach, ..Moment::of(&compiled.scene) };
    render(gpu, &measuring, &moment, SIZE, 1, &mut |_| ()).unwrap_or_else(|e| panic!("{e}"))
}

/// Holds `picture` against the `number` of each pixel, away from edges and lines. Returns how many pixels were
/// held, and how many others have a line.
fn hold(picture: &Picture, reach: f32, number: impl Fn(u32, u32) -> Option<f32>) -> [usize; 2] {
    let mut counts = [0; 2];
    for (x, y, _) in middles(SIZE) {
        let beside = [(x + 1, y), (x.wrapping_sub(1), y), (x, y + 1), (x, y.wrapping_sub(1))];
        let around: Vec<f32> = beside.into_iter().filter_map(|(x, y)| number(x, y)).collect();
        let Some(here) = number(x, y).filter(|_| around.len() == 4) else { continue };
        let here = here / reach;
        let steps = around.iter().map(|there| (there / reach - here).abs());
        let slope = 10.0 * steps.fold(0.0, f32::max);
        let away = ((10.0 * here + 0.5).rem_euclid(1.0) - 0.5).abs();
        let end = if here > 0.0 { ABOVE } else { BELOW };
        let plain = Vec3::ONE.lerp(end, here.abs().min(1.0));
        let color = Vec3::from(picture.radiance[(y * SIZE[0] + x) as usize]);
        if away > 4.0 * slope + 1e-4 {
            assert!(color.distance(plain) < 0.01, "{color}, not {plain}, for {here} at {x}, {y}");
            counts[0] += 1;
        } else if color.distance(plain) > 0.1 {
            counts[1] += 1;
        }
    }
    counts
}

#[test]
fn a_number_is_blue_below_0_and_red_above_with_lines_at_the_tenths() {
    let Some(gpu) = device::gpu() else { return };
    let text = "(camera: (eye: (0.3, 0.2, 5), target: (0, 0, 0)),
        objects: [Plane(normal: (0, 0, 1)), Sphere(name: \"ball\", center: (0, 0, 0.2))])";
    let compiled = scene(text);
    let seen = identity(gpu, &compiled, SIZE);
    let lens = raytoy::frame::Lens::new(&compiled.scene.camera, SIZE);
    let pixel = |x: u32, y: u32| lens.direction(glam::vec2(x as f32 + 0.5, y as f32 + 0.5));
    let of = |x: u32, y: u32, what: &dyn Fn(raytoy::gpu::Seen) -> f32| {
        let middle = seen.object(SIZE[0] / 2, SIZE[1] / 2);
        seen.at(x, y).filter(|s| Some(s.object) != middle).map(what)
    };
    for (name, reach) in [("distance", 8.0), ("facing", 1.0), ("u", 20.0), ("v", 12.0), ("footprint", 0.2)] {
        let picture = colors(gpu, &compiled, name, reach);
        let [held, lines] = hold(&picture, reach, |x, y| {
            let number = |s: raytoy::gpu::Seen| {
                let cosine = -s.normal.dot(pixel(x, y));
                match name {
                    "distance" => s.distance,
                    "facing" => cosine,
                    "u" => s.uv.x,
                    "v" => s.uv.y,
                    _ => 2.0 * lens.half / SIZE[1] as f32 * s.distance / cosine,
                }
            };
            of(x, y, &number)
        });
        assert!(held > 1000, "{name}: {held} held");
        // These change by a tenth of their reach within the picture.
        assert!(lines > 50 || name == "facing" || name == "footprint", "{name}: {lines} in lines");
    }
    // Both signs, and the sky, which is no surface, is black.
    let u = colors(gpu, &compiled, "u", 0.5);
    assert!(Vec3::from(u.radiance[(32 * SIZE[0]) as usize]).distance(BELOW) < 0.01);
    assert!(Vec3::from(u.radiance[(32 * SIZE[0] + 95) as usize]).distance(ABOVE) < 0.01);
    let above = scene("(camera: (eye: (0, 0, 5), target: (0, 0, 0)), background: 1, objects: [Sphere()])");
    assert_eq!(colors(gpu, &above, "distance", 1.0).radiance[0], [0.0; 3]);
}

#[test]
fn the_pattern_is_what_a_color_is_made_of() {
    let Some(gpu) = device::gpu() else { return };
    let with = |color: &str| {
        scene(&format!(
            "(camera: (eye: (0, 0, 5), target: (0, 0, 0)), ambient: 1, render: (texture_filter: false),
            textures: {{ \"p\": Noise(scale: 0.7), \"in color\": Ramp(by: \"p\", stops: [(0, (1, 0, 0)), (1, (0, 0, 1))]) }},
            objects: [Plane(normal: (0, 0, 1), material: (color: {color}))])"
        ))
    };
    // A color holds the number itself, in all of its range.
    let grey = draw::picture(gpu, &with("\"p\""), SIZE, View::Material);
    let number =
        |x: u32, y: u32| (x < SIZE[0] && y < SIZE[1]).then(|| grey.radiance[(y * SIZE[0] + x) as usize][0]);
    let ramp = "Ramp(by: \"p\", stops: [(0, (1, 0, 0)), (0.5, 0.2), (1, (0, 0, 1))])";
    for (color, measure) in
        [(ramp, "pattern"), ("\"p\"", "pattern"), ("\"in color\"", "pattern"), ("0.5", "p"), (ramp, "p")]
    {
        let compiled = with(color);
        let [held, lines] = hold(&colors(gpu, &compiled, measure, 1.0), 1.0, number);
        assert!(held > 200 && lines > 50, "{color}, {measure}: {held} held, {lines} in lines");
    }
    // Where there is no pattern, how bright the color is; a level number has no lines, not even on one.
    let [held, lines] =
        hold(&colors(gpu, &with("(0.5, 0.5, 0.5)"), "pattern", 1.0), 1.0, |x, y| number(x, y).map(|_| 0.5));
    assert_eq!(lines, 0);
    assert!(held < 10, "0.5 lies on a line");
    let level = colors(gpu, &with("(0.5, 0.5, 0.5)"), "pattern", 1.0);
    let half = Vec3::ONE.lerp(ABOVE, 0.5);
    assert!(level.radiance.iter().all(|pixel| Vec3::from(*pixel).distance(half) < 1e-3));
}

#[test]
fn what_is_measured_changes_nothing_else() {
    let Some(gpu) = device::gpu() else { return };
    let text = "(camera: (eye: (0, 1, 5), target: (0, 0, 0)), lights: [Point(position: (2, 4, 5))],
        textures: { \"p\": Noise(), \"unused\": Noise(scale: 3) },
        objects: [Sphere(material: (color: Ramp(by: \"p\", stops: [(0, 0.1), (1, 0.9)]))), Plane(offset: -1)])";
    for mode in [Mode::Baked, Mode::Live] {
        let plain = expect_compiled(outcome_of("a.ron", text, mode));
        assert!(!plain.source.generated().contains("measuredAt"), "nobody asks for it");
        let own = Moment::of(&plain.scene);
        let before = drawn(gpu, &plain, &own);
        for name in ["pattern", "unused", "footprint"] {
            let measure = Measure::named(&plain.scene, name).expect("the scene has it");
            assert_eq!(measure.name(&plain.scene), name);
            let measuring = plain.measuring(measure).unwrap_or_else(|e| panic!("{e:?}"));
            assert!(measuring.source.generated().contains("fn measuredAt("), "{name}");
            assert_eq!(drawn(gpu, &measuring, &own).rgba, before.rgba, "{name}");
            assert_eq!(export(&measuring, Language::Wgsl), export(&plain, Language::Wgsl));
        }
    }
    assert_eq!(Measure::named(&scene(text).scene, "nothing"), None);
}

#[test]
fn a_number_that_is_none_is_magenta() {
    let Some(gpu) = device::gpu() else { return };
    let texture =
        "/// Left of x = 0 no number.\nfn broken(at: Surface) -> f32 {\n    return sqrt(at.position.x);\n}\n";
    let text = "(camera: (eye: (0, 0, 5), target: (0, 0, 0)), textures: { \"b\": Broken() },
        objects: [Plane(normal: (0, 0, 1))])";
    let sources = Sources::in_memory().with("a.ron", text).with("textures/broken.wgsl", texture);
    let compiled = expect_compiled(compile(&sources, "a.ron".as_ref(), Mode::Baked, None));
    let picture = colors(gpu, &compiled, "b", 9.0);
    let at = |x: u32| picture.radiance[(32 * SIZE[0] + x) as usize];
    assert_eq!(at(20), [1.0, 0.0, 1.0]);
    assert!(at(80) != at(20) && at(80)[0] > 0.7);
}
