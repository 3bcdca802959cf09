//! `raytoy render` as a shell sees it: the files that it writes, their sizes and formats, adapters.

use std::ops::ControlFlow;
use std::path::Path;

use raytoy::frame::{Moment, Split, View};
use raytoy::gpu::Renderer;
use raytoy::wgsl::Mode;

use crate::common;
use crate::common::program::{command, raytoy, stderr, with_input};
use crate::device;

#[test]
fn render_writes_pictures_of_the_asked_size() {
    if device::gpu().is_none() {
        return;
    }
    let folder = tempfile::tempdir().expect("a temporary folder");
    let path = |name: &str| folder.path().join(name).to_string_lossy().into_owned();
    let (picture, normals, stats) = (path("a.png"), path("n.png"), path("stats.json"));
    render(&["scenes/two_suns.ron", "-o", &picture, "--size", "64x36", "--samples", "2", "--stats", &stats]);
    render(&["scenes/two_suns.ron", "-o", &normals, "--size", "64x36", "--view", "normal", "--live"]);
    let [a, n] = [&picture, &normals].map(|file| image::open(file).expect("a PNG").to_rgb8());
    assert_eq!((a.dimensions(), n.dimensions()), ((64, 36), (64, 36)));
    // The sphere faces the camera in the middle.
    assert_eq!(n.get_pixel(32, 18).0.map(|c| c / 16), [8, 7, 15]);

    let stats = std::fs::read_to_string(stats).expect("the statistics are there");
    let stats: serde_json::Value = serde_json::from_str(&stats).expect("they are JSON");
    for field in
        ["parse_ms", "resolve_ms", "generate_ms", "naga_ms", "pipeline_ms", "first_frame_ms", "frame_ms"]
    {
        assert!(stats[field].as_f64().is_some_and(|ms| ms > 0.0), "{field}: {stats}");
    }
    assert_eq!(stats["scene"], "scenes/two_suns.ron");
    assert_eq!([&stats["width"], &stats["height"], &stats["samples"], &stats["objects"]], [64, 36, 2, 1]);
    assert!(stats["adapter"].is_string() && stats["wgsl_bytes"].as_u64().is_some_and(|n| n > 1000));
}

#[test]
fn render_reads_stdin_and_writes_stdout() {
    if device::gpu().is_none() {
        return;
    }
    let arguments = ["render", "-", "-o", "-", "--size", "32x18", "--adapter", "software"];
    let drawn = with_input(&arguments, "(objects: [Sphere()])");
    assert!(drawn.stdout.starts_with(b"\x89PNG\r\n\x1a\n"), "{}", stderr(&drawn));
    let wrong = with_input(&arguments, "(objects: [Spere()])");
    assert_eq!((wrong.status.code(), wrong.stdout.len()), (Some(1), 0));
    assert!(stderr(&wrong).contains("did you mean `Sphere`?"));
}

#[test]
fn several_scenes_go_to_a_folder_and_a_wrong_one_stops_no_other() {
    if device::gpu().is_none() {
        return;
    }
    let folder = tempfile::tempdir().expect("a temporary folder");
    let out = format!("{}/", folder.path().join("gallery").to_string_lossy());
    let scenes = ["scenes/two_suns.ron", "tests/cases/errors/empty.ron", "tests/cases/geometry/defaults.ron"];
    let arguments =
        ["render", scenes[0], scenes[1], scenes[2], "-o", &out, "--size", "16x9", "--adapter", "software"];
    let drawn = raytoy(&arguments);
    assert_eq!(drawn.status.code(), Some(1));
    let is_there = |name: &str| Path::new(&out).join(name).exists();
    assert!(is_there("two_suns.png") && is_there("defaults.png") && !is_there("empty.png"));
}

#[test]
fn exr_holds_light_depth_and_objects() {
    if device::gpu().is_none() {
        return;
    }
    use exr::prelude::*;
    let folder = tempfile::tempdir().expect("a temporary folder");
    let file = folder.path().join("a.exr");
    let scene = folder.path().join("a.ron");
    let text = "(camera: (eye: (0, 0, 5), target: (0, 0, 0)), ambient: 1, background: (0, 0, 2),
        objects: [Box(min: (9, 9, 9), max: (10, 10, 10)), Sphere(material: (color: (0.5, 0.25, 0)))])";
    std::fs::write(&scene, text).expect("it is writable");
    render(&[&scene.to_string_lossy(), "-o", &file.to_string_lossy(), "--size", "33x17"]);
    let image = read_first_flat_layer_from_file(&file).expect("an EXR file");
    let channels = &image.layer_data.channel_data.list;
    let names: Vec<String> = channels.iter().map(|channel| channel.name.to_string()).collect();
    assert_eq!(names, ["B", "G", "R", "Z", "object"]);
    let at = |name: &str, pixel: usize| {
        let channel = channels.iter().find(|c| c.name.eq(name)).expect("it is one of the names");
        channel.sample_data.values_as_f32().nth(pixel).expect("33 x 17 pixels")
    };
    let (corner, middle) = (0, 8 * 33 + 16);
    let read = |pixel| ["R", "G", "B", "Z", "object"].map(|name| at(name, pixel));
    assert_eq!(read(corner), [0.0, 0.0, 2.0, f32::INFINITY, -1.0]);
    let [r, g, b, z, object] = read(middle);
    assert_eq!([r, g, b, object], [0.5, 0.25, 0.0, 1.0]);
    assert!((z - 4.0).abs() < 1e-4, "{z}");
}

#[test]
fn a_split_picture_is_both_and_says_so() {
    if device::gpu().is_none() {
        return;
    }
    let folder = tempfile::tempdir().expect("a temporary folder");
    let draw = |name: &str, arguments: &[&str]| {
        let file = folder.path().join(name).to_string_lossy().into_owned();
        let scene = ["tests/cases/materials/bump.ron", "-o", file.as_str(), "--size", "40x20"];
        render(&[&scene, arguments].concat());
        (image::open(&file).expect("it is a picture").to_rgb8(), stderr(&raytoy(&["scene", &file])))
    };
    let (left, _) = draw("a.png", &[]);
    let (right, _) = draw("b.png", &["--view", "value", "--value", "u", "--reach", "2"]);
    let split = ["--split", "value", "--split-at", "0.25", "--value", "u", "--reach", "2"];
    let (both, told) = draw("c.png", &split);
    assert!(left != right);
    for (x, y, pixel) in both.enumerate_pixels() {
        let half = if x < 10 { &left } else { &right };
        assert_eq!(pixel, half.get_pixel(x, y), "{x}, {y}");
    }
    let walnut = ["render", "--adapter", "software", "scenes/table.ron", "-o", "a.png", "--view", "value"];
    let wrong = raytoy(&[&walnut[..], &["--value", "walnut"]].concat());
    let names = "pattern, distance, facing, u, v, footprint, tiles";
    let why = format!("raytoy: `scenes/table.ron` has no value `walnut`: it has {names}\n");
    assert_eq!((wrong.status.code(), stderr(&wrong)), (Some(2), why));
    assert!(told.contains("value from 0.25 on") && told.contains("u, to 2"), "{told}");
}

#[test]
fn an_adapter_that_is_not_there_is_refused_by_naming_those_that_are() {
    let Some(gpu) = device::gpu() else { return };
    let refused = raytoy(&["render", "scenes/table.ron", "-o", "a.png", "--adapter", "nope"]);
    let told = stderr(&refused);
    assert_eq!(refused.status.code(), Some(2), "{told}");
    assert!(told.starts_with("raytoy: no GPU has `nope` in its name; the GPUs are\n"), "{told}");
    let name = gpu.describe();
    assert!(told.contains(name.split(" (").next().unwrap_or(&name)), "{told} lacks {name}");
}

#[test]
fn drawing_without_a_display_says_nothing_of_displays() {
    let Some(_) = device::gpu() else { return };
    let out = tempfile::tempdir().expect("a temporary folder");
    let file = out.path().join("a.png");
    let name = file.to_string_lossy();
    let mut call = command(&["render", "scenes/table.ron", "-o", &name, "--size", "8x8"]);
    let drawn = call.env_remove("XDG_RUNTIME_DIR").output().expect("raytoy runs");
    assert_eq!(stderr(&drawn), format!("{name}: 8x8\n"));
}

#[test]
fn a_picture_drawn_in_parts_is_the_whole_one_to_the_byte() {
    let Some(gpu) = device::gpu() else { return };
    let compiled = common::outcome("scenes/glass.ron", Mode::Baked).compiled.expect("it is right");
    let size = [53, 31];
    let split = Some(Split { view: View::Normal, at: 0.4 });
    for moment in [Moment::of(&compiled.scene), Moment { split, ..Moment::of(&compiled.scene) }] {
        let drawn = |parts: Option<(u32, u32)>| {
            let renderer = Renderer::new(gpu, &compiled, size).expect("a small picture");
            let mut renderer = match parts {
                Some((pixels, side)) => renderer.in_parts_of(pixels, side),
                None => renderer,
            };
            let mut shares = vec![];
            let picture = renderer.draw(&moment, 3, &mut |share| {
                shares.push(share);
                ControlFlow::Continue(())
            });
            assert!(
                shares.is_sorted() && shares.last().is_some_and(|s| (s - 1.0).abs() < 1e-4),
                "{shares:?}"
            );
            picture.expect("it draws").expect("nobody stops it")
        };
        let whole = drawn(None);
        for parts in [(53 * 8, 4096), (53 * 4, 16), (1, 2)] {
            let parted = drawn(Some(parts));
            assert_eq!(parted.rgba, whole.rgba, "{parts:?}");
            assert_eq!((parted.radiance, parted.depth), (whole.radiance.clone(), whole.depth.clone()));
        }
    }
}

#[test]
fn sizes_beyond_the_limits_are_refused_by_saying_them() {
    let Some(_) = device::gpu() else { return };
    let out = tempfile::tempdir().expect("a temporary folder");
    for (name, size, limit) in [
        ("a.png", "65537x8", "the size must be from 1x1 to 65536x65536"),
        ("a.png", "0x8", "the size must be from 1x1 to 65536x65536"),
        ("a.exr", "20000x20000", "which takes 67108864 pixels"),
    ] {
        let file = out.path().join(name);
        let refused =
            raytoy(&["render", "scenes/two_suns.ron", "-o", &file.to_string_lossy(), "--size", size]);
        assert_eq!(refused.status.code(), Some(2), "{}", stderr(&refused));
        assert!(stderr(&refused).contains(limit), "{}", stderr(&refused));
        assert!(!file.exists(), "{name}");
    }
    // Wider than the textures of most GPUs.
    let file = out.path().join("long.png");
    render(&["scenes/two_suns.ron", "-o", &file.to_string_lossy(), "--size", "40000x2"]);
    assert_eq!(image::image_dimensions(&file).expect("a PNG"), (40_000, 2));
}

fn render(arguments: &[&str]) {
    let done = raytoy(&[&["render", "--adapter", "software"], arguments].concat());
    assert!(done.status.success() && done.stdout.is_empty(), "{arguments:?}: {}", stderr(&done));
}
