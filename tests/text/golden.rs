//! The generated text: of each case as its golden has it, valid, within its limits, the same every time.

use crate::common;
use std::process::Command;

use crate::common::{
    check_text, expect_compiled, expect_none, files, good_scenes, outcome, outcome_of, root,
};
use raytoy::ir::{Measure, Scene};
use raytoy::module::nesting::deepest;
use raytoy::wgsl::{Mode, Target, generate};

/// The longest line and the longest function of the text that raytoy writes.
const MAX_COLUMNS: usize = 100;
const MAX_STATEMENTS: usize = 300;
/// Of which one is in the other.
const MAX_BRANCHES: usize = 50;

#[test]
fn each_scene_generates_its_golden() {
    expect_none(good_scenes().iter().filter_map(|scene| {
        let compiled = expect_compiled(outcome(scene, Mode::Baked));
        check_text(&golden_of(scene), compiled.source.generated()).err()
    }));
}

#[test]
fn each_golden_has_a_scene() {
    let goldens: Vec<String> = good_scenes().iter().map(|scene| golden_of(scene)).collect();
    let is_snippet =
        |file: &String| ["/textures/", "/shapes/", "/errors/"].iter().any(|folder| file.contains(folder));
    let orphans =
        files("tests/cases", "wgsl").into_iter().filter(|file| !is_snippet(file) && !goldens.contains(file));
    expect_none(orphans.map(|file| format!("{file} belongs to no scene: remove it")));
}

#[test]
fn each_scene_is_valid_in_both_modes_without_warnings() {
    for scene in good_scenes() {
        for mode in [Mode::Baked, Mode::Live] {
            let outcome = outcome(&scene, mode);
            assert!(outcome.report.diagnostics.is_empty(), "{scene}, {mode:?}:\n{}", outcome.report);
            let compiled = expect_compiled(outcome);
            assert_eq!(compiled.source.numbers.is_empty(), mode == Mode::Baked, "{scene}, {mode:?}");
        }
    }
}

#[test]
fn lines_and_functions_stay_short() {
    for scene in good_scenes() {
        for mode in [Mode::Baked, Mode::Live] {
            let compiled = expect_compiled(outcome(&scene, mode));
            let text = compiled.source.generated();
            for (number, line) in (1..).zip(text.lines()) {
                let columns = line.chars().count();
                assert!(columns <= MAX_COLUMNS, "{scene}, {mode:?}: line {number} has {columns}: {line}");
            }
            for function in text.split("\nfn ").skip(1) {
                let statements = function.matches(';').count();
                let name = function.split('(').next().unwrap_or_default();
                assert!(statements <= MAX_STATEMENTS, "{scene}, {mode:?}: {name} has {statements}");
            }
        }
    }
}

/// Mesa's software driver forgets those beyond 80, and snippets of authors come on top.
#[test]
fn branches_in_each_other_stay_few() {
    let list = |part: &dyn Fn(usize) -> String| (0..300).map(part).collect::<Vec<_>>().join(", ");
    let ball = |i: usize| {
        format!(
            "Sphere(center: ({i}, 0, 0), material: (color: Checker(even: 0.{i}), bump: (height: Noise(scale: {}))))",
            1 + i % 90
        )
    };
    let light = |i: usize| format!("Point(position: ({i}, 5, 0))");
    let part = |i: usize| format!("Sphere(center: ({i}, 9, 0), radius: 2)");
    let [balls, lights, parts] = [list(&ball), list(&light), list(&part)];
    let combined = ["Union", "Difference", "Intersection"].map(|kind| format!("{kind}(parts: [{parts}])"));
    let many = format!("(lights: [{lights}], objects: [{balls}, {}])", combined.join(", "));
    let many = expect_compiled(outcome_of("300 of each", &many, Mode::Baked));
    let measured = many.measuring(Measure::Pattern).expect("nothing has that name");
    let scenes = good_scenes().into_iter().map(|scene| expect_compiled(outcome(&scene, Mode::Baked)));
    for compiled in scenes.chain([many, measured]) {
        let depth = deepest(compiled.module.naga()).depth;
        assert!(depth <= MAX_BRANCHES, "{} has {depth} branches in each other", compiled.scene.name);
    }
}

#[test]
fn ten_runs_write_the_same_bytes() {
    for scene in good_scenes() {
        let first = expect_compiled(outcome(&scene, Mode::Live)).scene;
        let in_both =
            |scene: &Scene| [Mode::Baked, Mode::Live].map(|mode| generate(scene, &Target::raytoy(mode)));
        let sources = in_both(&first);
        for run in 1..10 {
            let again = resolved(&scene);
            assert_eq!(first, again, "{scene}: run {run} resolves to another scene");
            assert_eq!(sources, in_both(&again), "{scene}: run {run}");
        }
    }
}

#[test]
fn ten_processes_write_the_same_bytes() {
    let generate = || {
        let mut command = Command::new(env!("CARGO_BIN_EXE_raytoy"));
        let command = command.current_dir(root()).args(["generate", "tests/cases/names/odd_names.ron"]);
        command.output().expect("raytoy runs").stdout
    };
    let first = generate();
    assert!(first.starts_with(b"// Generated from tests/cases/names/odd_names.ron"));
    for run in 2..=10 {
        assert_eq!(first, generate(), "run {run}");
    }
}

#[test]
fn settings_of_the_picture_are_not_in_its_text() {
    let body = |scene: &str| {
        let compiled = expect_compiled(outcome(scene, Mode::Live));
        let text = compiled.source.generated().to_owned();
        text.split_once('\n').map(|(_, rest)| rest.to_owned())
    };
    assert_eq!(body("tests/cases/render/no_setting_is_text.ron"), body("tests/cases/geometry/defaults.ron"));
}

#[test]
fn numbers_are_not_in_the_live_text() {
    let live = |radius: &str, color: &str| {
        let text = format!(
            "(lights: [Point(position: (0, {radius}, 0), radius: {radius})],
            objects: [Sphere(radius: {radius}, translate: ({radius}, 0, 0), material: (color: Brick(scale: {radius}, clay: {color})))])"
        );
        expect_compiled(common::outcome_of("a.ron", &text, Mode::Live)).source
    };
    let (one, other) = (live("1.5", "\"tomato\""), live("0.25", "(0, 0.5, 0)"));
    assert_eq!(one.sections, other.sections);
    assert_ne!(one.numbers, other.numbers);
    assert_eq!(one.numbers.len(), other.numbers.len());
}

/// `tests/cases/scenes/` for the gallery, beside the scene for the rest.
fn golden_of(scene: &str) -> String {
    let stem = scene.trim_end_matches(".ron");
    if stem.starts_with("tests/") { format!("{stem}.wgsl") } else { format!("tests/cases/{stem}.wgsl") }
}

/// The resolved scene, without asking naga.
fn resolved(name: &str) -> raytoy::ir::Scene {
    use raytoy::{library::Library, scene::parse, sources::Sources};
    let sources = Sources::on_disk(&root());
    let text = common::read(name);
    let folder = std::path::Path::new(name).parent().expect("scenes lie in folders");
    let library = Library::new(&sources, folder);
    let value = parse(name, &text).expect("the scene parses");
    raytoy::ir::resolve(name, &text, &value, &library).expect("the scene resolves").0
}
