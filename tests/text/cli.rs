//! The program as a shell sees it: exit codes, what goes to which stream, and the files that it writes.

use crate::common;
use std::io::Write;
use std::ops::ControlFlow;
use std::path::Path;
use std::process::{Command, Output, Stdio};

use crate::common::{check_text, expect_none, files, root};
use raytoy::frame::{Moment, Split, View};
use raytoy::gpu::Renderer;
use raytoy::wgsl::Mode;

#[test]
fn a_right_scene_is_0_a_wrong_one_1_a_wrong_call_2() {
    let code = |arguments: &[&str]| raytoy(arguments).status.code();
    assert_eq!(code(&["check", "scenes/table.ron"]), Some(0));
    assert_eq!(code(&["check", "tests/cases/errors/scale_zero.ron"]), Some(1));
    assert_eq!(code(&["generate", "tests/cases/errors/scale_zero.ron"]), Some(1));
    for call in [
        &["check", "nothing.ron"][..],
        &["generate", "nothing.ron"],
        &["view", "nothing.ron"],
        &["paint"],
        &["render", "scenes/table.ron"],
        &["render", "scenes/table.ron", "-o", "a.jpg"],
        &["render", "scenes/table.ron", "-o", "a.png", "--size", "0x9"],
        &["render", "scenes/table.ron", "-o", "a.png", "--view", "heat"],
        &["render", "scenes/table.ron", "-o", "a.png", "--samples", "0"],
        &["render", "scenes/table.ron", "scenes/glass.ron", "-o", "a.png"],
    ] {
        assert_eq!(code(call), Some(2), "{call:?}");
    }
}

#[test]
fn results_go_to_stdout_and_talk_to_stderr() {
    let generated = raytoy(&["generate", "scenes/table.ron"]);
    assert!(stdout(&generated).starts_with("// Generated from scenes/table.ron\n"));
    assert!(!stderr(&generated).contains("fn "));
    let wrong = raytoy(&["generate", "tests/cases/errors/scale_zero.ron"]);
    assert_eq!(stdout(&wrong), "");
    assert!(stderr(&wrong).contains("`scale` must not be 0") && stderr(&wrong).ends_with("2 errors\n"));
    assert!(!stderr(&wrong).contains('\u{1b}'), "no escape codes where there is no terminal");
    let checked = raytoy(&["check", "scenes/table.ron"]);
    assert_eq!((stdout(&checked), stderr(&checked)), (String::new(), "scenes/table.ron is right\n".into()));
    let missing = raytoy(&["generate", "nothing.ron"]);
    assert_eq!(stderr(&missing), "raytoy: there is no file `nothing.ron`\n");
}

#[test]
fn generate_reads_stdin_and_writes_a_file() {
    let piped = with_input(&["generate", "-", "--live"], "(objects: [Sphere(radius: 2)])");
    assert!(stdout(&piped).contains("fn live(i: u32)"), "{}", stderr(&piped));
    let folder = tempfile::tempdir().expect("a temporary folder");
    let file = folder.path().join("table.wgsl");
    let written = raytoy(&["generate", "scenes/table.ron", "-o", &file.to_string_lossy()]);
    assert_eq!(stdout(&written), "");
    let baked = std::fs::read_to_string(&file).expect("the file is there");
    assert_eq!(baked, stdout(&raytoy(&["generate", "scenes/table.ron"])));
}

#[test]
fn check_takes_folders_and_snippets() {
    let all = raytoy(&["check", "scenes", "textures", "shaders/shapes"]);
    let count = files("scenes", "ron").len()
        + files("textures", "wgsl").len()
        + files("shaders/shapes", "wgsl").len();
    assert_eq!(stderr(&all), format!("all {count} files are right\n"));
    let snippets = raytoy(&["check", "tests/cases/errors/snippets"]);
    assert_eq!(snippets.status.code(), Some(1));
    let said = stderr(&snippets);
    assert!(
        said.contains("textures/syntax_error.wgsl:6:5") && said.contains("files with mistakes"),
        "{said}"
    );
}

#[test]
fn files_with_odd_names_are_told_not_fatal() {
    let folder = tempfile::tempdir().expect("a temporary folder");
    std::fs::create_dir(folder.path().join("textures")).expect("it is writable");
    for stem in ["ärger", "a__b", "_", "my-texture", "2d"] {
        let file = folder.path().join("textures").join(format!("{stem}.wgsl"));
        std::fs::write(file, "fn f() {}\n").expect("it is writable");
    }
    for arguments in [&["textures"][..], &["check", "."], &["textures", "Ärger"], &["textures", ""]] {
        let done = command(arguments).current_dir(folder.path()).output().expect("raytoy runs");
        assert!(matches!(done.status.code(), Some(0..=2)), "{arguments:?}: {}", stderr(&done));
    }
}

#[test]
fn render_writes_pictures_of_the_asked_size() {
    if common::gpu().is_none() {
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
    if common::gpu().is_none() {
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
    if common::gpu().is_none() {
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
    if common::gpu().is_none() {
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
fn lists_tell_all_names_and_all_about_one() {
    for (command, folder) in [("textures", "textures"), ("shapes", "shaders/shapes")] {
        let list = stdout(&raytoy(&[command]));
        let (of_files, own) = list.split_once("\n\n").expect("raytoy's own come last");
        assert_eq!(of_files.lines().count(), files(folder, "wgsl").len(), "{list}");
        assert_eq!(own.lines().count(), 4, "{own}");
        let bare = of_files.lines().filter(|line| line.split_whitespace().count() < 3);
        expect_none(bare.map(|line| format!("{command}: a line without a caption: {line}")));
    }
    let brick = stdout(&raytoy(&["textures", "Brick"]));
    assert!(brick.starts_with("Brick: ") && brick.contains("textures/brick.wgsl"), "{brick}");
    for parameter in ["scale", "mortar", "clay", "joint", "at"] {
        assert!(brick.contains(&format!("\n  {parameter}")), "{parameter}: {brick}");
    }
    let torus = stdout(&raytoy(&["shapes", "Torus"]));
    assert!(torus.contains("major_radius = 1") && !torus.contains("mapping"), "{torus}");
}

#[test]
fn an_unknown_name_gets_the_nearest() {
    let unknown = raytoy(&["textures", "Brik"]);
    assert_eq!(unknown.status.code(), Some(2));
    assert_eq!(stderr(&unknown), "raytoy: there is no texture `Brik`; did you mean `Brick`?\n");
    assert!(stderr(&raytoy(&["shapes", "Zzzzzzzzzz"])).contains("`raytoy shapes` lists them"));
}

#[test]
fn help_is_as_its_goldens_say() {
    let commands = [
        "",
        "view",
        "render",
        "scene",
        "check",
        "test",
        "diff",
        "generate",
        "textures",
        "shapes",
        "completions",
    ];
    expect_none(commands.into_iter().filter_map(|command| {
        let (arguments, golden) = match command {
            "" => (vec!["--help"], "tests/cases/help/raytoy.txt".to_owned()),
            command => (vec![command, "--help"], format!("tests/cases/help/{command}.txt")),
        };
        check_text(&golden, &stdout(&raytoy(&arguments))).err()
    }));
}

#[test]
fn wrong_views_are_told() {
    let mut told = String::new();
    for call in [
        "--split heat",
        "--split-at 0.3",
        "--split normal --split-at 1.5",
        "--value pattern",
        "--view value --reach 0",
    ] {
        let head = ["render", "scenes/table.ron", "-o", "a.png"];
        let done = raytoy(&[&head, &call.split(' ').collect::<Vec<_>>()[..]].concat());
        assert_eq!((done.status.code(), done.stdout.len()), (Some(2), 0), "{call}");
        told += &format!("$ raytoy render scenes/table.ron -o a.png {call}\n{}\n", stderr(&done));
    }
    check_text("tests/cases/help/wrong_views.txt", &told).unwrap_or_else(|difference| panic!("{difference}"));
}

#[test]
fn a_split_picture_is_both_and_says_so() {
    if common::gpu().is_none() {
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
fn numbers_that_no_picture_can_have_are_refused_with_their_limits() {
    for (option, limit) in [
        (&["--time", "NaN"][..], "from -1000000 to 1000000"),
        (&["--time", "inf"], "from -1000000 to 1000000"),
        (&["--time=-1e30"], "from -1000000 to 1000000"),
        (&["--frames", "0..2", "--fps", "NaN"], "from 0.01 to 1000"),
        (&["--frames", "0..2", "--fps", "0"], "from 0.01 to 1000"),
        (&["--frames", "5..3"], "up to a higher one"),
        (&["--frames", "0..4000000000", "--fps", "1"], "a scene has at most 1000000"),
        (&["--reach", "NaN"], "from 0.000001 to 1000000"),
        (&["--split", "normal", "--split-at", "NaN"], "from 0, the left edge, to 1"),
        (&["--samples", "0"], "1..=65536"),
        (&["--samples", "-1"], "'-1'"),
    ] {
        let refused = raytoy(&[&["render", "scenes/table.ron", "-o", "a###.png"], option].concat());
        assert_eq!(refused.status.code(), Some(2), "{option:?}");
        assert!(stderr(&refused).contains(limit), "{option:?}: {}", stderr(&refused));
    }
}

#[test]
fn an_adapter_that_is_not_there_is_refused_by_naming_those_that_are() {
    let Some(gpu) = common::gpu() else { return };
    let refused = raytoy(&["render", "scenes/table.ron", "-o", "a.png", "--adapter", "nope"]);
    let told = stderr(&refused);
    assert_eq!(refused.status.code(), Some(2), "{told}");
    assert!(told.starts_with("raytoy: no adapter has `nope` in its name; there are\n"), "{told}");
    let name = gpu.describe();
    assert!(told.contains(name.split(" (").next().unwrap_or(&name)), "{told} lacks {name}");
}

#[test]
fn drawing_without_a_display_says_nothing_of_displays() {
    let Some(_) = common::gpu() else { return };
    let out = tempfile::tempdir().expect("a temporary folder");
    let file = out.path().join("a.png");
    let name = file.to_string_lossy();
    let mut call = command(&["render", "scenes/table.ron", "-o", &name, "--size", "8x8"]);
    let drawn = call.env_remove("XDG_RUNTIME_DIR").output().expect("raytoy runs");
    assert_eq!(stderr(&drawn), format!("{name}: 8x8\n"));
}

#[test]
fn a_picture_drawn_in_parts_is_the_whole_one_to_the_byte() {
    let Some(gpu) = common::gpu() else { return };
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
    let Some(_) = common::gpu() else { return };
    let out = tempfile::tempdir().expect("a temporary folder");
    for (name, size, limit) in [
        ("a.png", "65537x8", "pictures go from 1x1 to 65536x65536"),
        ("a.png", "0x8", "pictures go from 1x1 to 65536x65536"),
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

#[test]
fn completions_are_for_the_shell_that_is_asked_for() {
    let bash = stdout(&raytoy(&["completions", "bash"]));
    assert!(bash.contains("_raytoy()") && bash.contains("generate"));
    assert_eq!(raytoy(&["completions", "tcl"]).status.code(), Some(2));
}

fn raytoy(arguments: &[&str]) -> Output {
    command(arguments).output().expect("raytoy runs")
}

fn with_input(arguments: &[&str], input: &str) -> Output {
    let mut child = command(arguments).stdin(Stdio::piped()).spawn().expect("raytoy runs");
    let mut stdin = child.stdin.take().expect("it is piped");
    stdin.write_all(input.as_bytes()).expect("raytoy reads");
    drop(stdin);
    child.wait_with_output().expect("raytoy ends")
}

fn render(arguments: &[&str]) {
    let done = raytoy(&[&["render", "--adapter", "software"], arguments].concat());
    assert!(done.status.success() && done.stdout.is_empty(), "{arguments:?}: {}", stderr(&done));
}

fn command(arguments: &[&str]) -> Command {
    let mut command = Command::new(env!("CARGO_BIN_EXE_raytoy"));
    command.current_dir(root()).args(arguments).stdin(Stdio::null());
    command.env_remove("COLUMNS").stdout(Stdio::piped()).stderr(Stdio::piped());
    command
}

fn stdout(output: &Output) -> String {
    String::from_utf8_lossy(&output.stdout).replace("raytoy.exe", "raytoy")
}

fn stderr(output: &Output) -> String {
    String::from_utf8_lossy(&output.stderr).into_owned()
}
