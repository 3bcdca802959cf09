//! The tabs beside the scene: its shader, what an edit has changed in it, exports, and what a picture costs.

use std::time::{Duration, Instant};

use egui::OutputCommand;
use egui::accesskit::Role;
use egui_kittest::kittest::Queryable;

use super::SCENE;
use super::harness::{Studio, is};

/// So long an export may take.
const PATIENCE: Duration = Duration::from_secs(60);

fn opened() -> Studio {
    let mut studio = Studio::open(SCENE);
    studio.press("Shader");
    studio
}

/// Takes an offer of the export menu, and tells what was copied.
fn copied(studio: &mut Studio, offer: &str) -> String {
    studio.press("Export");
    studio.find(Role::Button, "Export").get_by(is(Role::Button, offer)).click();
    let until = Instant::now() + PATIENCE;
    loop {
        studio.harness.step();
        let commands = &studio.harness.output().platform_output.commands;
        let text = commands.iter().find_map(|command| match command {
            OutputCommand::CopyText(text) => Some(text.clone()),
            _ => None,
        });
        if let Some(text) = text {
            studio.settle();
            return text;
        }
        assert!(Instant::now() < until, "nothing was copied");
    }
}

#[test]
fn the_shader_is_that_of_the_version_that_is_shown() {
    let mut studio = opened();
    assert!(studio.says("fn rayTraceScene(ray: Ray) -> Hit {") && !studio.says("torus(ray"));
    assert!(studio.says("return sphere(ray, vec3f(0.0), 1.0);"));
    studio.save(&SCENE.replace("radius: 1 /*", "radius: 1.25 /*"));
    assert!(studio.says("return sphere(ray, vec3f(0.0), 1.25);"));
}

#[test]
fn what_changed_is_told_line_by_line_unless_it_is_numbers() {
    let mut studio = opened();
    studio.press("What changed");
    assert!(studio.says("No changes since the scene was opened."));
    studio.save(&SCENE.replace("radius: 1 /*", "radius: 1.25 /*"));
    assert!(studio.says("Only numbers have changed since the scene was opened."));
    studio.save(&SCENE.replace("objects: [", "objects: [Torus(name: \"ring\"), "));
    assert!(
        studio.says(" lines removed, ")
            && studio.says("+     hit = nearer(hit, ringCrossing(ray), OBJECT_RING);")
    );
    assert!(!studio.says("fn lightAt("), "what stays is left out");
    studio.press("What changed");
    assert!(studio.says("fn sceneBlocks(ray: Ray) -> bool {"));
}

#[test]
fn exports_are_copied_but_for_what_is_no_text() {
    let mut studio = opened();
    let section = copied(&mut studio, "copy This section, WGSL");
    assert!(section.contains("fn rayTraceScene(") && !section.contains("@fragment"), "{section}");
    assert!(studio.says(&format!("copied {} lines", section.lines().count())));
    let glsl = copied(&mut studio, "copy GLSL for Shadertoy");
    assert!(glsl.contains("void mainImage("), "{glsl}");
    studio.press("Export");
    let spirv = studio.find(Role::Button, "copy SPIR-V for Vulkan");
    assert!(egui_kittest::kittest::NodeT::accesskit_node(&spirv).is_disabled());
    for name in ["Standalone WGSL", "MSL for Metal", "HLSL for Direct3D"] {
        assert!(studio.has(Role::Button, &format!("copy {name}")), "{name}");
        assert!(studio.has(Role::Button, &format!("save {name}")), "{name}");
    }
}

#[test]
fn a_picture_s_cost_is_told() {
    let mut studio = Studio::open(SCENE);
    studio.press("Timings");
    for words in ["a GPU of paper", "20.0 ms", "50 per second", "naga", "KB"] {
        assert!(studio.says(words), "{words}");
    }
    let objects = studio.stage().panel.compiled().expect("there is a picture").scene.primitives.len();
    assert!(studio.says(&objects.to_string()));
    assert!(!studio.has(Role::TreeItem, "ball"));
    studio.press("Scene");
    assert!(studio.has(Role::TreeItem, "ball"));
}
