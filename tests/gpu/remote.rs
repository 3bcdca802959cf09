//! Scenes far from the origin: right as long as nothing is said of them, and a warning where numbers lose the digits.

use crate::common::{expect_compiled, expect_none, outcome_of};
use crate::device;
use crate::draw::picture;
use crate::reference;
use raytoy::frame::View;
use raytoy::wgsl::Mode;

const SIZE: [u32; 2] = [160, 120];
/// Steps of a channel, 0 to 255.
const TOLERANCE: f64 = 3.0;

/// A few things of size 1 beside the camera, all of them `far` from the origin, by their own numbers or by a move.
fn scene(far: f64, is_moved: bool) -> String {
    let there = |x: f64, y: f64, z: f64| format!("({}, {y}, {})", far + x, 0.5 * far + z);
    let place = |x: f64, y: f64, z: f64| if is_moved { format!("({x}, {y}, {z})") } else { there(x, y, z) };
    let moved = if is_moved { format!(", translate: {}", there(0.0, 0.0, 0.0)) } else { String::new() };
    format!(
        "(camera: (eye: {}, target: {}, fov_deg: 40),
          lights: [Point(position: {}), Directional(direction: (1, -1, -0.25), intensity: 0.4)],
          objects: [
            Box(min: {}, max: {}, material: (color: 0.6){moved}),
            Sphere(center: {}, radius: 0.75, material: (color: 0.4){moved}),
            Box(min: {}, max: {}{moved}),
            Cone(base: {}, top: {}, base_radius: 0.5{moved}),
            Triangle(a: {}, b: {}, c: {}{moved}),
          ])",
        there(0.5, 3.0, 7.0),
        there(0.0, 0.5, 0.0),
        there(4.0, 6.0, 3.0),
        place(-4.0, -0.5, -4.0),
        place(4.0, 0.0, 4.0),
        place(-1.5, 0.75, 0.0),
        place(-0.5, 0.0, -1.75),
        place(0.5, 1.25, -0.75),
        place(1.75, 0.0, 0.0),
        place(1.75, 1.5, 0.0),
        place(-0.5, 0.0, 1.0),
        place(0.5, 0.0, 1.0),
        place(0.0, 0.75, 1.25),
    )
}

#[test]
fn far_scenes_are_right_or_warned_of() {
    let Some(gpu) = device::gpu() else { return };
    // How far, and the share of the pixels that is right at least and at most.
    for (far, least, most) in [(1e3, 0.995, 1.0), (2e4, 0.975, 1.0), (1e5, 0.0, 0.95), (1e6, 0.0, 0.9)] {
        for is_moved in [false, true] {
            let text = scene(far, is_moved);
            let share = agreement(gpu, &text);
            eprintln!("{far} from the origin, moved: {is_moved}: {share:.4} of the pixels are right");
            assert!((least..=most).contains(&share), "{far}, moved: {is_moved}: {share}");
            assert_eq!(warning(&text).is_some(), most < 1.0, "{far}, moved: {is_moved}");
        }
    }
}

#[test]
fn only_what_is_seen_from_nearby_is_warned_of() {
    let near = "camera: (eye: (100000, 1, 5), target: (100000, 0, 0))";
    let cases = [
        (near, "Sphere(center: (1e5, 0, 0))", true),
        (near, "Sphere(translate: (1e5, 0, 0))", true),
        (near, "Union(translate: (1e5, 0, 0), parts: [Sphere(), Box()])", true),
        (near, "Plane()", true),
        (near, "Triangle(a: (99999, 0, 0), b: (1e5, 1, 0), c: (1e5, 0, 1))", true),
        (near, "Heightfield(height: Noise(), translate: (1e5, 0, 0))", true),
        // Large, or seen from so far that a pixel is wider than a step.
        (near, "Sphere(center: (1e5, -1e4, 0), radius: 10000)", false),
        (near, "Sphere(translate: (1e5, -100, 0), scale: 100)", false),
        (near, "Sphere()", false),
        ("camera: (eye: (0, 0, 0), target: (0, 0, -1))", "Sphere(center: (0, 0, -1e5), radius: 0.01)", false),
        ("camera: (eye: (3e5, 2e5, 2e5), target: (3e5, 0, 0))", "Plane()", false),
    ];
    expect_none(cases.into_iter().filter_map(|(camera, object, is_warned)| {
        let warning = warning(&format!("({camera}, objects: [{object}])"));
        (warning.is_some() != is_warned).then(|| format!("{camera}, {object}: {warning:?}"))
    }));
}

/// What is said of a far object, if anything.
fn warning(text: &str) -> Option<String> {
    let outcome = outcome_of("a.ron", text, Mode::Baked);
    assert!(outcome.compiled.is_some(), "{text}: {}", outcome.report);
    let messages = outcome.report.diagnostics.into_iter().map(|problem| problem.message);
    messages.into_iter().find(|message| message.contains("too far from the origin"))
}

/// The share of pixels that are as the reference has them.
fn agreement(gpu: &raytoy::gpu::Gpu, text: &str) -> f64 {
    let compiled = expect_compiled(outcome_of("a.ron", text, Mode::Baked));
    let expected =
        reference::render(text, SIZE[0] as usize, SIZE[1] as usize).expect("the reference knows all");
    let actual = picture(gpu, &compiled, SIZE, View::Color);
    let agrees = |(a, b): &(&[u8], &[f64; 3])| {
        a.iter().zip(*b).all(|(a, b)| (f64::from(*a) - 255.0 * b).abs() <= TOLERANCE)
    };
    actual.rgba.chunks(4).zip(&expected.display).filter(agrees).count() as f64 / f64::from(SIZE[0] * SIZE[1])
}
