//! What raytoy says of each mistake: the whole text, as an author reads it.

use crate::common::{check_text, expect_none, files, outcome, outcome_of, scenes};
use raytoy::compile;
use raytoy::sources::Sources;
use raytoy::wgsl::Mode;

#[test]
fn each_mistake_is_told_as_its_golden_says() {
    expect_none(scenes("tests/cases/errors").iter().filter_map(|scene| {
        let outcome = outcome(scene, Mode::Baked);
        let golden = scene.replace(".ron", ".txt");
        check_text(&golden, &outcome.report.to_string()).err()
    }));
}

#[test]
fn each_golden_has_a_scene() {
    let scenes = scenes("tests/cases/errors");
    let texts = files("tests/cases/errors", "txt");
    let orphans = texts.iter().filter(|text| !scenes.contains(&text.replace(".txt", ".ron")));
    expect_none(orphans.map(|text| format!("{text} belongs to no scene: remove it")));
}

#[test]
fn each_mistake_has_a_place_and_warnings_stop_nothing() {
    for scene in scenes("tests/cases/errors") {
        let outcome = outcome(&scene, Mode::Baked);
        assert!(!outcome.report.diagnostics.is_empty(), "{scene}: nothing is said of it");
        assert_ne!(outcome.compiled.is_some(), outcome.report.has_errors(), "{scene}");
        for problem in &outcome.report.diagnostics {
            let place = problem.labels.first().map(|(place, _)| place);
            let place = place.unwrap_or_else(|| panic!("{scene}: no place: {}", problem.message));
            let text = outcome.report.texts.get(&place.file);
            let text = text.unwrap_or_else(|| panic!("{scene}: the text of {} is not there", place.file));
            assert!(text.get(place.span.clone()).is_some(), "{scene}: {:?} is not in its text", place.span);
        }
    }
}

#[test]
fn messages_keep_their_style() {
    for scene in scenes("tests/cases/errors") {
        for problem in outcome(&scene, Mode::Baked).report.diagnostics {
            let message = &problem.message;
            let starts_low = !message.starts_with(|c: char| c.is_ascii_uppercase());
            assert!(starts_low && !message.ends_with('.'), "{scene}: {message}");
        }
    }
}

#[test]
fn a_missing_file_is_named() {
    let outcome = outcome("scenes/nothing_here.ron", Mode::Baked);
    assert_eq!(outcome.report.to_string(), "error: there is no file `scenes/nothing_here.ron`\n\n");
    assert!(outcome.compiled.is_none());
}

/// Files have the same name, and a path of their own.
#[test]
fn mistakes_are_reported_at_the_path_of_their_file() {
    let texture =
        |body: &str| format!("/// Rings.\nfn ripple(at: Surface) -> f32 {{\n    return {body};\n}}\n");
    let shape = "/// A pond.\nfn ripple(ray: Ray) -> f32 {\n    return onRay(ray, 1.0);\n}\n\n\
                 fn rippleSurface(p: vec3f) -> Surface {\n    return surface(p, vec3f(0.0, 0.0, 1.0), p.xy);\n}\n";
    let gems = "(objects: [Mesh(file: \"a/gem.obj\"), Mesh(file: \"b/gem.obj\")])";
    let rings = "(objects: [Sphere(material: (color: Ripple()))])";
    let [good, bad, worse] = ["at.uv.x", "at.uvw", "\n  at.uvw"].map(texture);
    let (good, bad, worse) = (good.as_str(), bad.as_str(), worse.as_str());
    let (near, far) = ("deep/textures/ripple.wgsl", "textures/ripple.wgsl");
    let [wrong_face, wrong_point] = ["v 0 0 0\nv 1 0 0\nf 1 2 9\n", "v 0 0 0\nv 1 0 x\n"];
    for (scene, files, places) in [
        (rings, [(near, bad), (far, good)], &["deep/textures/ripple.wgsl:3:15"][..]),
        (rings, [(near, good), (far, bad)], &[]),
        (rings, [(near, worse), (far, bad)], &["deep/textures/ripple.wgsl:4:6"]),
        (
            "(objects: [Ripple(material: (color: Ripple()))])",
            [(far, good), ("shapes/ripple.wgsl", shape)],
            &["─ textures/ripple.wgsl:2:4", "─ shapes/ripple.wgsl:2:4"],
        ),
        (
            gems,
            [("deep/a/gem.obj", wrong_face), ("deep/b/gem.obj", wrong_point)],
            &[
                "`deep/a/gem.obj` is damaged: line 3",
                "scene.ron:1:23",
                "`deep/b/gem.obj` has no triangles",
                "scene.ron:1:48",
            ],
        ),
    ] {
        let sources =
            files.iter().fold(Sources::in_memory().with("deep/scene.ron", scene), |sources, (name, text)| {
                sources.with(name, text)
            });
        let report = compile(&sources, "deep/scene.ron".as_ref(), Mode::Baked, None).report.to_string();
        for place in places {
            assert_eq!(report.matches(place).count(), 1, "{place}: {report}");
        }
        assert_eq!(
            report.matches(".wgsl:").count() + report.matches(".ron:").count(),
            report.matches("┌─").count()
        );
        assert_eq!(report.is_empty(), places.is_empty(), "{report}");
    }
}

#[test]
fn nesting_to_any_depth_does_not_overflow() {
    for (open, close) in [("(", ")"), ("[", "]"), ("Some(", ")"), ("Checker(even: ", ")"), ("{\"a\": ", "}")]
    {
        for depth in [100, 1_000, 100_000] {
            let text = format!(
                "(objects: [Sphere(material: (color: {}1{}))])",
                open.repeat(depth),
                close.repeat(depth)
            );
            let outcome = outcome_of("deep.ron", &text, Mode::Baked);
            assert!(outcome.report.has_errors() || outcome.compiled.is_some(), "{depth} times {open}");
        }
    }
}
