//! The hand-written shaders by themselves: with a stub of the scene's section they are valid for each target,
//! and the stub is what the generator writes, and nothing more than that.

use crate::common::{expect_compiled, expect_none, outcome_of};
use raytoy::ir::{Measure, Scene};
use raytoy::wgsl::{Host, Mode, Target, generate};

const STUB: &str = include_str!("scene_stub.wgsl");

/// It has a bump and a measure, and so all that the shaders may ask for.
const SCENE: &str = "(objects: [Sphere(material: (bump: (height: Noise())))])";

#[test]
fn the_shaders_are_valid_with_the_stub_of_a_scene() {
    let modules = modules(STUB);
    expect_none(modules.iter().filter_map(|(target, text)| Some(format!("{target:?}: {}", problem(text)?))));
}

#[test]
fn the_generator_writes_the_signatures_of_the_stub() {
    let scene = scene();
    let written: Vec<String> =
        targets().iter().map(|target| generate(&scene, target).generated().to_owned()).collect();
    let is_written =
        |signature: &str| written.iter().any(|text| text.lines().any(|l| l.starts_with(signature)));
    let missing = declarations().into_iter().map(signature).filter(|signature| !is_written(signature));
    expect_none(missing.map(|signature| format!("no generated text has `{signature}`")));
}

#[test]
fn the_shaders_need_all_of_the_stub() {
    expect_none(declarations().into_iter().filter_map(|declaration| {
        let without = STUB.replace(declaration, "");
        let is_needed = modules(&without).iter().any(|(_, text)| problem(text).is_some());
        (!is_needed).then(|| format!("no shader uses `{}`", signature(declaration)))
    }));
}

fn targets() -> [Target; 6] {
    [
        Target::raytoy(Mode::Live),
        Target::raytoy(Mode::Baked),
        Target { probe: true, ..Target::raytoy(Mode::Baked) },
        Target::plain(),
        Target::without_raytoy(Host::Any),
        Target::without_raytoy(Host::Shadertoy { settings: vec![] }),
    ]
}

fn scene() -> Scene {
    let scene = expect_compiled(outcome_of("a.ron", SCENE, Mode::Baked)).scene;
    Scene { measure: Some(Measure::Distance), ..scene }
}

/// For each target the files of shaders/, with `stub` in place of the scene's section, and without the shapes
/// and textures that only that section calls.
fn modules(stub: &str) -> Vec<(Target, String)> {
    let scene = scene();
    let is_ours = |name: &str| name.starts_with("shaders/") && !name.starts_with("shaders/shapes/");
    let module = |target: Target| {
        let mut source = generate(&scene, &target);
        source.sections[0].text = stub.into();
        let own = source.sections[0].name.clone();
        source.sections.retain(|section| section.name == own || is_ours(&section.name));
        (target, source.text())
    };
    targets().into_iter().map(module).collect()
}

/// What naga has against a module.
fn problem(text: &str) -> Option<String> {
    let module = match naga::front::wgsl::parse_str(text) {
        Ok(module) => module,
        Err(error) => return Some(error.emit_to_string(text)),
    };
    let flags = naga::valid::ValidationFlags::all();
    let verdict = naga::valid::Validator::new(flags, Default::default()).validate(&module);
    verdict.err().map(|error| error.emit_to_string(text))
}

/// The constants and functions of the stub.
fn declarations() -> Vec<&'static str> {
    let is_declaration = |text: &&str| text.starts_with("fn ") || text.starts_with("const ");
    let blocks = STUB.split("\n\n").map(str::trim).filter(is_declaration);
    blocks
        .flat_map(|block| if block.starts_with("const ") { block.lines().collect() } else { vec![block] })
        .collect()
}

/// A declaration up to its body or value.
fn signature(declaration: &str) -> &str {
    let end = declaration.find(" {").or_else(|| declaration.find(" ="));
    &declaration[..end.expect("each has one of the two")]
}
