//! Models that lie far from their zero, as surveys do: which of them are counted from their middle.

use glam::DVec3;
use raytoy::compile;
use raytoy::sources::Sources;
use raytoy::wgsl::Mode;
use serde_json::json;

use super::decoded;
use super::glb_writer::Writer;
use super::shapes::{FAR, far_torus};
use crate::common::expect_compiled;

#[test]
fn only_what_lies_far_from_zero_is_counted_from_its_middle() {
    let origin = |by: DVec3| decoded(far_torus(by).as_bytes()).unwrap().origin;
    assert_eq!(origin(DVec3::ZERO), DVec3::ZERO);
    assert_eq!(origin(DVec3::new(10.0, 0.0, 0.0)), DVec3::ZERO);
    for by in FAR {
        assert!(origin(by).distance(by) < 1.0, "{by}");
    }
}

#[test]
fn nodes_far_away_keep_all_digits() {
    let mut writer = Writer::default();
    let positions = writer.vectors(&[[0.0; 3], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0]]);
    writer.mesh(json!([{ "attributes": { "POSITION": positions } }]));
    let nodes = json!([
        { "children": [1], "translation": [5_000_000, 0, 0] },
        { "mesh": 0, "scale": [0.125, 0.125, 0.125], "translation": [0.3, 0, 0] },
    ]);
    let model = decoded(&writer.finish(nodes, &[0])).unwrap();
    assert_eq!(model.origin, DVec3::new(5_000_000.0, 0.0, 0.0));
    let sides = model.triangles[0].map(|corner| corner.position.x - 0.3);
    assert!(sides.iter().all(|x| x.abs() < 1e-6 || (x - 0.125).abs() < 1e-6), "{sides:?}");
}

#[test]
fn a_model_far_away_alone_has_its_place() {
    let sources = Sources::in_memory().with("a.ron", "(objects: [Mesh(file: \"a.obj\")])");
    let sources = sources.with("a.obj", &far_torus(FAR[2]));
    let compiled = expect_compiled(compile(&sources, "a.ron".as_ref(), Mode::Live, None));
    let [x, y, z] = compiled.scene.primitives[0].space.expect("it is moved");
    assert_eq!([x[3], y[3], z[3]], [0.0, 0.0, -20_000.0]);
}
