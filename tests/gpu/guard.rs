//! Scenes that would keep the GPU for ever: they are stopped and told, and a window keeps the last good one.

use std::process::Command;

use crate::common::folder::{Folder, stderr, stdout};
use crate::common::{check_text, expect_compiled, expect_none, outcome_of};
use crate::device::gpu;
use naga::back::glsl;
use naga::valid::{Capabilities, ValidationFlags, Validator};
use raytoy::frame::Moment;
use raytoy::gpu::{Gpu, GpuError, Pipeline, Region, Renderer};
use raytoy::module;
use raytoy::sources::Sources;
use raytoy::wgsl::Mode;
use raytoy::{Compiled, compile};

/// Loops of each kind, one in another, and behind branches.
const WINDING: &str = "/// Loops.
///
/// count = 10: how often
fn winding(at: Surface, count: u32) -> f32 {
    var x = at.uv.x;
    for (var i = 0u; i < count; i++) {
        if i % 3u == 0u {
            continue;
        }
        while x < 0.5 {
            x += windingPart(x);
        }
    }
    switch count {
        case 1u: {
            loop {
                x -= 0.25;
                continuing {
                    break if x < 0.5;
                }
            }
        }
        default: {}
    }
    return x;
}

fn windingPart(x: f32) -> f32 {
    return 0.1 + 0.1 * x * x;
}
";

/// A loop that ends after `count` steps.
const STEPS: &str = "/// Steps.
///
/// count = 10: how many
fn steps(at: Surface, count: u32) -> f32 {
    var x = 0u;
    for (var i = 0u; i < count; i++) {
        x += 1u + (u32(abs(at.uv.x)) >> 31u);
    }
    return f32(x) / 65536.0;
}
";

/// A texture that never ends, for no number ends its loop.
const ENDLESS: &str = "/// A loop that does not end.
fn endless(at: Surface) -> f32 {
    var x = 0.0;
    while x < 2.0 {
        x = fract(x + at.uv.x);
    }
    return x;
}
";

/// A shape that never ends, in a function that it calls.
const HOLLOW: &str = "/// A ball that does not end.
fn hollowDistance(p: vec3f) -> f32 {
    return length(p) - hollowRadius(p);
}

fn hollowRadius(p: vec3f) -> f32 {
    var radius = 1.0;
    loop {
        if radius > 2.0 {
            break;
        }
        radius = 1.0 + fract(radius + p.x * p.x);
    }
    return radius;
}

fn hollowBounds() -> Bounds {
    return Bounds(vec3f(-2.0), vec3f(2.0));
}
";

fn scene_of(color: &str) -> String {
    format!("(objects: [Plane(material: (color: {color}))])")
}

/// The scene in which everything has the color of `call`, which the file says.
fn compiled(name: &str, file: &str, call: &str, mode: Mode) -> Compiled {
    let sources = Sources::in_memory()
        .with("scene.ron", &format!("(background: {call}, objects: [Sphere(material: (color: {call}))])"))
        .with(format!("textures/{name}.wgsl"), file);
    expect_compiled(compile(&sources, "scene.ron".as_ref(), mode, None))
}

/// The functions called so in a module, as naga writes them.
fn functions(compiled: &Compiled, names: &[&str]) -> String {
    let module = compiled.module.naga();
    let info = Validator::new(ValidationFlags::all(), Capabilities::default()).validate(module);
    let info = info.expect("it has been validated before");
    let options = glsl::Options { version: glsl::Version::Desktop(450), ..Default::default() };
    let entry = glsl::PipelineOptions {
        shader_stage: naga::ShaderStage::Fragment,
        entry_point: "tracePixel".into(),
        multiview: None,
    };
    let mut text = String::new();
    let writer = glsl::Writer::new(&mut text, module, &info, &options, &entry, Default::default());
    writer.expect("it has the entry point").write().expect("a String takes all text");
    let function = |name: &&str| {
        let head = text.find(&format!(" {name}(")).unwrap_or_else(|| panic!("no {name} in {text}"));
        let start = text[..head].rfind('\n').map_or(0, |at| at + 1);
        let end = start + text[start..].find("\n}\n").expect("functions end") + 3;
        text[start..end].to_owned()
    };
    names.iter().map(function).collect::<Vec<_>>().join("\n")
}

#[test]
fn loops_of_snippets_are_counted() {
    let scene = compiled("winding", WINDING, "Winding()", Mode::Baked);
    expect_none(
        check_text("tests/gpu/guard/winding.glsl", &functions(&scene, &["winding", "background"])).err(),
    );
    let told: String = scene.module.loops().iter().map(|report| report.to_string()).collect();
    expect_none(check_text("tests/gpu/guard/winding.txt", &told).err());
}

#[test]
fn what_ships_is_not_guarded_and_what_hides_it_is() {
    let bare = expect_compiled(outcome_of("scene.ron", &scene_of("Mandelbrot()"), Mode::Baked));
    assert!(!bare.source.is_guarded() && bare.module.loops().is_empty());
    let commented =
        "/// Grey, for want of a better one.\nfn grey_(at: Surface) -> f32 {\n    return 0.5;\n}\n";
    let flat = compiled("flat", &commented.replace("grey_", "flat"), "Flat()", Mode::Baked);
    assert!(!flat.source.is_guarded(), "a word in a comment is no loop");
    // Where comments end, as WGSL has it, and not only at a line feed.
    for hidden in ["/* // */ for (", "// no loop\r    for (", "// no loop\u{2028}    for ("] {
        let hidden = compiled("steps", &STEPS.replace("for (", hidden), "Steps()", Mode::Baked);
        assert_eq!(hidden.module.loops().len(), 1);
    }
    let hiding = STEPS.replace("fn steps", "fn mandelbrot");
    let hiding = compiled("mandelbrot", &hiding, "Mandelbrot()", Mode::Baked);
    assert_eq!(hiding.module.loops().len(), 1);
}

/// Each kind of loop, in a module that lacks the guard as if no word of the text had begun a loop.
#[test]
fn a_loop_that_has_no_guard_is_not_drawn() {
    let within = |body: &str| {
        format!("/// A loop.\nfn steps(at: Surface) -> f32 {{\n    var x = 1.0;\n{body}\n    return x;\n}}\n")
    };
    for (body, line) in [
        ("    for (var i = 0; i < 9; i++) { x += at.uv.x; }", 4),
        ("    while x < 9.0 {\n        x += 1.0;\n    }", 4),
        (
            "    loop {\n        x += 1.0;\n        continuing {\n            break if x > 9.0;\n        }\n    }",
            4,
        ),
        (
            "    switch u32(x) {\n        case 1u: {\n            while x < 9.0 { x += 1.0; }\n        }\n        default: {}\n    }",
            6,
        ),
        ("    if x < 2.0 { x = 0.0; } else {\n        { while x < 9.0 { x += 1.0; } }\n    }", 5),
    ] {
        let guarded = compiled("steps", &within(body), "Steps()", Mode::Baked);
        assert_eq!(guarded.module.unguarded(), None, "{body}");
        let mut source = guarded.source.clone();
        source.sections.retain(|section| section.name != "shaders/guard.wgsl");
        let module = module::validate(&source).expect("it needs no guard to be valid");
        let place = format!("textures/steps.wgsl:{line}");
        assert_eq!(module.unguarded(), Some(place.as_str()), "{body}");
        let Some(gpu) = gpu() else { continue };
        let broken = Compiled { source, module, ..guarded };
        let refused = Pipeline::build(gpu, &broken).err();
        assert_eq!(refused, Some(GpuError::Unguarded(place)));
    }
}

/// Its author has called a function as the guard's is.
#[test]
fn a_function_of_the_authors_is_no_guard() {
    let asks = STEPS.replace("        x +=", "        if loopEnds(1u) { break; }\n        x +=");
    let asks = asks + "\nfn loopEnds(number: u32) -> bool {\n    return number == 0u;\n}\n";
    let plain = compiled(
        "flat",
        "/// Grey.\nfn flat(at: Surface) -> f32 {\n    return 0.5;\n}\n",
        "Flat()",
        Mode::Baked,
    );
    let mut source = plain.source;
    let snippet = source.sections.iter_mut().find(|section| section.name == "textures/flat.wgsl");
    let snippet = snippet.expect("the scene uses it");
    snippet.text = format!("{}{asks}", snippet.text).into();
    let module = module::validate(&source).expect("it is valid");
    assert_eq!(module.unguarded(), Some("textures/flat.wgsl:10"));
}

#[test]
fn a_loop_may_take_its_steps_and_no_more() {
    let Some(gpu) = gpu() else { return };
    let size = [48, 32];
    let scene = |count: u32| compiled("steps", STEPS, &format!("Steps(count: {count})"), Mode::Live);
    let (few, many) = (scene(32_000), scene(33_000));
    let mut renderer = Renderer::new(gpu, &few, size).unwrap_or_else(|e| panic!("{e}"));
    let mut draw = |compiled: &Compiled| {
        renderer.take(compiled);
        let mut goes_on = |_| std::ops::ControlFlow::Continue(());
        let picture = renderer.draw(&Moment::of(&compiled.scene), 2, &mut goes_on);
        picture.map(|picture| picture.expect("nobody stops it").radiance[0][0])
    };
    for _ in 0..2 {
        assert_eq!(draw(&few), Ok(32_000.0 / 65_536.0));
        assert_eq!(draw(&many), Err(GpuError::Endless(many.module.loops()[0].clone())));
    }
}

#[test]
fn render_tells_the_loop_and_draws_the_other_scenes() {
    if gpu().is_none() {
        return;
    }
    let folder = Folder::new();
    folder.write("textures/endless.wgsl", ENDLESS);
    folder.write("shapes/hollow.wgsl", HOLLOW);
    folder.write("endless.ron", &scene_of("Endless()"));
    folder.write("hollow.ron", "(objects: [Hollow()])");
    folder.write("good.ron", "(objects: [Sphere()])");
    let common = ["--size", "320x180", "--adapter", "software"];
    let run = |arguments: &[&str]| {
        let output = folder.run(&[arguments, &common].concat());
        (output.status.code(), stderr(&output))
    };
    let (code, told) = run(&["render", "endless.ron", "hollow.ron", "good.ron", "-o", "pictures/"]);
    assert_eq!(code, Some(1), "{told}");
    expect_none(check_text("tests/gpu/guard/render.txt", &told).err());
    let exists = |name: &str| folder.path().join("pictures").join(name).exists();
    assert_eq!(["endless.png", "hollow.png", "good.png"].map(exists), [false, false, true]);
    let blamed = |(code, told): (Option<i32>, String)| {
        code == Some(1) && told.contains("ran too long") && told.contains("textures/endless.wgsl:4:5")
    };
    assert!(blamed(run(&["render", "endless.ron", "-o", "a.png", "--live"])));
    assert!(blamed(run(&["render", "endless.ron", "-o", "a.exr", "--samples", "3"])));
    assert!(blamed(run(&["render", "endless.ron", "-o", "####.png", "--frames", "0..1"])));
    assert!(blamed(run(&["diff", "good.ron", "endless.ron"])));
}

#[test]
fn the_laws_are_not_asked_for_ever() {
    if gpu().is_none() {
        return;
    }
    let folder = Folder::new();
    folder.write("textures/endless.wgsl", ENDLESS);
    folder.write("shapes/hollow.wgsl", HOLLOW);
    for (file, place) in [("textures/endless.wgsl", 4), ("shapes/hollow.wgsl", 8)] {
        let output = folder.run(&["test", file]);
        let told = stdout(&output);
        assert_eq!(output.status.code(), Some(1), "{told}");
        assert!(told.contains("ran too long") && told.contains(&format!("{file}:{place}:5")), "{told}");
    }
}

/// Errors of a device that works, and of one that is lost.
fn provoke_both(gpu: &Gpu) {
    let buffer = |label, usage| {
        let descriptor =
            wgpu::BufferDescriptor { label: Some(label), size: 4, usage, mapped_at_creation: false };
        gpu.device.create_buffer(&descriptor)
    };
    buffer("of no use", wgpu::BufferUsages::empty());
    eprintln!("{}", gpu.wait().expect_err("a buffer of no use is refused"));
    gpu.lose();
    let late = buffer("too late", wgpu::BufferUsages::MAP_READ);
    late.slice(..).map_async(wgpu::MapMode::Read, |_| ());
    if let Err(error) = gpu.wait() {
        eprintln!("{error}");
    }
}

#[test]
fn what_a_lost_device_refuses_is_not_told_and_what_another_one_refuses_is() {
    // Set in the process that provokes them: standard error belongs to all of a process.
    const PROVOKES: &str = "RAYTOY_TEST_PROVOKES";
    let Some(gpu) = gpu() else { return };
    if std::env::var_os(PROVOKES).is_some() {
        return provoke_both(gpu);
    }
    let name = "guard::what_a_lost_device_refuses_is_not_told_and_what_another_one_refuses_is";
    let mut process = Command::new(std::env::current_exe().expect("it runs"));
    let process = process.args(["--exact", name, "--nocapture"]).env(PROVOKES, "yes");
    let output = process.output().expect("it runs once more");
    let told = stderr(&output);
    assert!(output.status.success(), "{told}");
    assert!(
        told.starts_with("the GPU's driver refuses: Validation Error") && told.contains("of no use"),
        "{told}"
    );
    assert!(!told.contains("too late") && told.matches("Validation Error").count() == 1, "{told}");
}

#[test]
fn regions_cover_a_picture_pixel_by_pixel() {
    for size in [[1, 1], [7, 5], [64, 3], [1, 40]] {
        for most in [0, 1, 3, 7, 8, 20, 63, 64, 65, 1000] {
            let mut seen = vec![];
            while seen.len() < (size[0] * size[1]) as usize {
                let region = Region::after(seen.len() as u32, most, size);
                assert!(region.pixels() <= most.max(1), "{region:?} of {size:?}, and at most {most}");
                let Region { columns, rows } = region;
                seen.extend(rows.flat_map(|y| columns.clone().map(move |x| y * size[0] + x)));
            }
            assert!(seen.iter().copied().eq(0..size[0] * size[1]), "{size:?}, at most {most}");
        }
    }
}
