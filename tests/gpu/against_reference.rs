//! raytoy's pictures beside those of an independent renderer in f64: light, depth and object of each pixel.

use crate::common::{expect_compiled, expect_none, outcome_of, read};
use crate::device;
use crate::draw::picture;
use crate::reference;
use raytoy::frame::{Moment, View};
use raytoy::gpu::{Gpu, Identity, Pipeline};
use raytoy::wgsl::Mode;

/// The share of pixels that must agree; edges that round the other way, and what mirrors make of them, may not.
const LEAST_AGREEMENT: f64 = 0.995;
/// Steps of a channel, 0 to 255.
const COLOR_TOLERANCE: f64 = 2.0;
/// Of the distance.
const DEPTH_TOLERANCE: f64 = 2e-5;

const SIZE: [u32; 2] = [480, 270];

#[test]
fn gallery_scenes_agree() {
    let hard = |name: &str| {
        let text = read(&format!("scenes/{name}.ron"));
        unfiltered(
            &text.replace(", radius: 0.4)]", ")]").replace("intensity: 0.7, radius: 0.6", "intensity: 0.7"),
        )
    };
    check_all(["table", "two_suns", "mirror_room", "shapes"].map(|name| (name.to_owned(), hard(name))), SIZE);
}

#[test]
fn glass_agrees() {
    let text = read("scenes/glass.ron").replace("Brick(scale: 2)", "Stripes(scale: 2, even: 0.9, odd: 0.4)");
    // Where the rod stands on the floor, two surfaces are one, and rounding tells which is seen.
    let text = text.replace("base: (1.6, 0, 0.5)", "base: (1.6, 0.1, 0.5)");
    check_all([("glass".to_owned(), unfiltered(&text))], SIZE);
}

#[test]
fn media_in_each_other_agree() {
    let glass = |shape: &str, ior: f64| {
        format!("{shape}, casts_shadow: false, material: (color: 0, transmission: 1, ior: {ior}))")
    };
    let objects = [
        // Water in water, of which nothing is seen; a bubble in glass; three media in each other.
        glass("Sphere(center: (-2.4, 0, 0)", 1.33),
        glass("Sphere(center: (-2.4, 0, 0), radius: 0.6", 1.33),
        glass("Sphere(radius: 1", 1.5),
        glass("Sphere(radius: 0.5", 1.0),
        glass("Box(min: (1.4, -1, -1), max: (3.4, 1, 1)", 1.5),
        glass("Sphere(center: (2.4, 0, 0), radius: 0.9", 1.33),
        glass("Sphere(center: (2.4, 0, 0), radius: 0.5", 2.4),
        // Water that reaches into its glass.
        glass("Cylinder(base: (-1.2, -1, 2), top: (-1.2, 0, 2), radius: 0.3", 1.5),
        glass("Cylinder(base: (-1.2, -0.1, 2), top: (-1.2, 0.6, 2), radius: 0.2", 1.33),
    ];
    let text = format!(
        "(camera: (eye: (0, 1.5, 7), target: (0, 0, 0)), background: \"skyblue\", objects: [
            Plane(offset: -1.1, material: (color: Checker(even: 0.9, odd: 0.2))), {}],
          render: (max_bounces: 10, texture_filter: false))",
        objects.join(",\n")
    );
    check_all([("media".to_owned(), text)], [320, 180]);
}

#[test]
fn lights_agree() {
    let text = read("tests/cases/lights/kinds.ron");
    check_all([("lights/kinds".to_owned(), unfiltered(&text))], [320, 180]);
}

#[test]
fn random_scenes_agree() {
    check_all((1..=4).map(|seed| (format!("random {seed}"), random_scene(seed))), [240, 135]);
}

/// Mesa's software driver forgets what more than 80 branches in each other are for.
#[test]
fn hundreds_of_objects_materials_textures_and_lights_agree() {
    let camera = "camera: (eye: (0, 0, 9), target: (0, 0, 0)), render: (texture_filter: false)";
    let light = "lights: [Directional(direction: (-1, -1, -2))]";
    let plain: Vec<String> =
        grid(100).map(|[x, y]| format!("Sphere(center: ({x}, {y}, 0), radius: 0.25)")).collect();
    let textured = grid(300).enumerate().map(|(i, [x, y])| {
        let [red, green] = [i % 7, i % 11].map(|n| 0.05 * n as f64 + 0.3);
        format!(
            "Sphere(center: ({x}, {y}, 0), radius: 0.16, material: (color: Checker(scale: 0.1, \
             even: ({red:.3}, {green:.3}, {:.3}), odd: 0.2)))",
            i as f64 / 300.0
        )
    });
    let textured: Vec<String> = textured.collect();
    let lights = grid(300).enumerate().map(|(i, [x, y])| {
        format!("Point(position: ({x}, {y}, {}), intensity: {:.4})", 2 + i % 5, 0.002 * (1 + i % 4) as f64)
    });
    let lights: Vec<String> = lights.collect();
    let scenes = [
        ("100 objects", format!("({camera}, {light}, objects: [{}])", plain.join(", "))),
        ("300 textures", format!("({camera}, {light}, objects: [{}])", textured.join(", "))),
        (
            "300 lights",
            format!(
                "({camera}, lights: [{}], objects: [Sphere(), Quad(corner: (-3, -3, -1), u: (6, 0, 0), v: (0, 6, 0))])",
                lights.join(", ")
            ),
        ),
    ];
    check_all(scenes.map(|(name, text)| (name.to_owned(), text)), [96, 64]);
}

/// So many places of a square, 6 wide.
fn grid(places: usize) -> impl Iterator<Item = [f64; 2]> {
    let columns = (places as f64).sqrt().ceil() as usize;
    let place = move |i: usize| (6.0 * (i as f64 + 0.5) / columns as f64 - 3.0) * 0.999;
    (0..places).map(move |i| [place(i % columns), place(i / columns)])
}

fn check_all(scenes: impl IntoIterator<Item = (String, String)>, size: [u32; 2]) {
    let Some(gpu) = device::gpu() else { return };
    expect_none(scenes.into_iter().flat_map(|(name, text)| check(gpu, &name, &text, size)));
}

/// What of a scene disagrees, if anything; the shares go to the test's output.
fn check(gpu: &Gpu, name: &str, text: &str, size: [u32; 2]) -> Vec<String> {
    let expected = reference::render(text, size[0] as usize, size[1] as usize)
        .unwrap_or_else(|why| panic!("{name}: {why}\n{text}"));
    let compiled = expect_compiled(outcome_of("scene.ron", text, Mode::Baked));
    let actual = picture(gpu, &compiled, size, View::Color);
    let pipeline = Pipeline::build(gpu, &compiled).unwrap_or_else(|e| panic!("{name}: {e}"));
    let moment = Moment::of(&compiled.scene);
    let seen = Identity::draw(gpu, &pipeline, &moment, &compiled.scene.render, size);
    let seen = seen.unwrap_or_else(|e| panic!("{name}: {e}"));

    let channel = |a: u8, b: f64| (f64::from(a) - (b * 255.0).round()).abs() <= COLOR_TOLERANCE;
    let color = |i: usize| (0..3).all(|c| channel(actual.rgba[4 * i + c], expected.display[i][c]));
    let same_object = |i: usize| {
        let (x, y) = (i as u32 % size[0], i as u32 / size[0]);
        seen.object(x, y).map_or(-1, i64::from) == expected.object[i]
    };
    let depth = |i: usize| {
        let (a, b) = (f64::from(actual.depth[i]), expected.depth[i]);
        a == b || (a - b).abs() <= DEPTH_TOLERANCE * b
    };
    let pixels = expected.depth.len();
    let share = |is_right: &dyn Fn(usize) -> bool| {
        (0..pixels).filter(|i| is_right(*i)).count() as f64 / pixels as f64
    };
    let shares = [("color", share(&color)), ("object", share(&same_object)), ("depth", share(&depth))];
    let percent = shares.map(|(what, share)| format!("{what} {:.3} %", share * 100.0)).join(", ");
    eprintln!("{name}: {percent}");
    let wrong = shares.into_iter().filter(|(_, share)| *share < LEAST_AGREEMENT);
    wrong.map(|(what, share)| format!("{name}: {what} agrees in {share:.5} of the pixels only")).collect()
}

/// The scene with patterns sampled at the pixel's centre, as the reference does it.
fn unfiltered(text: &str) -> String {
    if text.contains("render: (") {
        return text.replace("render: (", "render: (texture_filter: false, ");
    }
    let end = text.rfind(')').expect("a scene ends with a bracket");
    format!("{}render: (texture_filter: false),\n)", &text[..end])
}

/// A few shapes, moved, turned and stretched, in all the materials that the reference knows, under three lights.
fn random_scene(seed: u64) -> String {
    let mut random = Random(seed);
    let objects: Vec<String> = (0..9).map(|_| random_object(&mut random)).collect();
    let (x, z) = (random.between(-3.0, 3.0), random.between(7.0, 10.0));
    let light = format!(
        "Point(position: {}, intensity: 0.6), Directional(direction: (-1, -2, {:.3}), intensity: 0.4),
        Spot(position: ({x:.3}, 8, 3), target: (0, 0, 0), cone_deg: 60, blend: 0.2, falloff: InverseSquare, intensity: 30)",
        random.vector(4.0, 6.0),
        random.between(-1.0, 1.0),
    );
    format!(
        "(
    camera: (eye: ({x:.3}, 3, {z:.3}), target: (0, 0.5, 0)),
    background: Gradient(zenith: \"#5d88c9\", horizon: \"#dfe9f5\"),
    lights: [{light}],
    objects: [
        Quad(corner: (-8, -1.5, -8), u: (16, 0, 0), v: (0, 0, 16), material: (color: Checker(scale: 1, even: 0.7, odd: 0.3), reflectivity: 0.1)),
        {},
    ],
    render: (max_bounces: 4, texture_filter: false),
)",
        objects.join(",\n        "),
    )
}

fn random_object(random: &mut Random) -> String {
    const SHAPES: [&str; 9] = [
        "Sphere(radius: 0.8",
        "Box(min: (-0.6, -0.5, -0.7)",
        "RoundedBox(radius: 0.3",
        "Cylinder(radius: 0.6",
        "Cone(top_radius: 0.3",
        "Capsule(radius: 0.4",
        "Torus(minor_radius: 0.3",
        "Ellipsoid(radii: (1, 0.5, 0.7)",
        "Disk(inner_radius: 0.3",
    ];
    const MATERIALS: [&str; 4] = [
        "color: \"tomato\", specular: 0.5",
        "color: \"#4682b4\", reflectivity: 0.3",
        "color: 0.1, reflectivity: 0.2, fresnel: 4",
        "color: 0.1, transmission: 0.8, ior: 1.4",
    ];
    format!(
        "{}, translate: {}, rotate_deg: {}, scale: ({:.3}, {:.3}, {:.3}), material: ({}))",
        random.one_of(&SHAPES),
        random.vector(-2.5, 2.5),
        random.vector(-180.0, 180.0),
        random.between(0.4, 1.0),
        random.between(0.4, 1.0),
        random.between(0.4, 1.0),
        random.one_of(&MATERIALS),
    )
}

/// A linear congruential generator (Knuth's MMIX).
struct Random(u64);

impl Random {
    fn between(&mut self, low: f64, high: f64) -> f64 {
        self.0 = self.0.wrapping_mul(6364136223846793005).wrapping_add(1442695040888963407);
        low + (high - low) * (self.0 >> 33) as f64 / (1u64 << 31) as f64
    }

    fn vector(&mut self, low: f64, high: f64) -> String {
        let [x, y, z] = [(); 3].map(|()| self.between(low, high));
        format!("({x:.3}, {y:.3}, {z:.3})")
    }

    fn one_of<'a>(&mut self, all: &[&'a str]) -> &'a str {
        all[self.between(0.0, all.len() as f64) as usize]
    }
}
