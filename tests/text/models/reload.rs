//! Edits: a model that has not changed is not read again, and one that has makes another scene.

use std::path::Path;
use std::sync::Arc;

use raytoy::sources::Sources;
use raytoy::wgsl::Mode;
use raytoy::{Compiled, compile};

use super::shapes;
use crate::common::expect_compiled;

const SCENE: &str =
    "(objects: [Mesh(file: \"a.obj\"), Mesh(file: \"b.obj\", smooth: false), Mesh(file: \"a.obj\")])";

fn compiled(scene: &str, [a, b]: [&str; 2], before: Option<&Compiled>) -> Compiled {
    let sources = Sources::in_memory().with("scene.ron", scene).with("a.obj", a).with("b.obj", b);
    expect_compiled(compile(&sources, Path::new("scene.ron"), Mode::Live, before))
}

#[test]
fn a_model_is_read_again_only_if_it_has_changed() {
    let [cube, torus] = ["cube.obj", "torus.obj"].map(|name| shapes::made(name).unwrap());
    let first = compiled(SCENE, [&cube, &torus], None);
    assert_eq!(first.scene.models.len(), 2, "two objects share a model");
    let is_kept = |after: &Compiled, i: usize| {
        let (before, after) = (&first.scene.models[i], &after.scene.models[i]);
        Arc::ptr_eq(&before.triangles, &after.triangles) && Arc::ptr_eq(&before.nodes, &after.nodes)
    };
    let again = compiled(SCENE, [&cube, &torus], Some(&first));
    assert!(is_kept(&again, 0) && is_kept(&again, 1));
    assert_eq!(first.scene.models, again.scene.models);
    let moved =
        compiled(&SCENE.replace("smooth: false", "translate: (1, 2, 3)"), [&cube, &torus], Some(&first));
    assert!(is_kept(&moved, 0) && is_kept(&moved, 1));
    // What decides whether the window takes an edit for a structural one: the text, or the models.
    let edited = torus.replace("v 0 0 1.35", "v 0 0 1.4");
    let other = compiled(SCENE, [&cube, &edited], Some(&first));
    assert_eq!(other.source.sections, first.source.sections);
    assert_ne!(other.scene.models, first.scene.models);
    assert!(is_kept(&other, 0) && !is_kept(&other, 1));
    // Two files that change places.
    let swapped = compiled(SCENE, [&torus, &cube], Some(&first));
    assert_ne!(swapped.scene.models, first.scene.models);
    assert_eq!(swapped.scene.models[0].triangles.len(), first.scene.models[1].triangles.len());
}

#[test]
fn files_of_models_are_watched() {
    let sources = Sources::in_memory().with("scenes/a.ron", "(objects: [Mesh(file: \"models/b.obj\")])");
    let outcome = compile(&sources, Path::new("scenes/a.ron"), Mode::Live, None);
    assert!(outcome.report.has_errors());
    let is_asked = sources.asked().keys().any(|path| path.ends_with("scenes/models/b.obj"));
    assert!(is_asked, "a file that is not there yet");
}
