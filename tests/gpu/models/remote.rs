//! Models that lie far from their zero, as surveys do, and are brought back by `translate`.

use std::path::Path;

use glam::DVec3;
use raytoy::frame::Moment;
use raytoy::gpu::{Probe, Ray};
use raytoy::sources::Sources;
use raytoy::wgsl::Mode;
use raytoy::{Compiled, compile};

use super::random::Random;
use super::{decoded, shapes};
use crate::common::expect_compiled;
use crate::device::gpu;

const FAR: [DVec3; 3] = [
    DVec3::new(512_345.625, 5_401_234.375, 431.5),
    DVec3::new(-500_000.0, 0.1, 5_000_000.0),
    DVec3::new(0.0, 0.0, 20_000.3),
];

/// The torus of shapes.rs, moved by all digits.
fn far_torus(by: DVec3) -> String {
    let torus = shapes::made("torus.obj").unwrap();
    let moved = torus.lines().map(|line| match line.strip_prefix("v ") {
        Some(numbers) => {
            let p: Vec<f64> = numbers.split(' ').map(|x| x.parse().unwrap()).collect();
            let p = DVec3::from_slice(&p) + by;
            format!("v {} {} {}\n", p.x, p.y, p.z)
        }
        None => format!("{line}\n"),
    });
    moved.collect()
}

fn compiled(model: &str, fields: &str) -> Compiled {
    let scene = format!("(objects: [Mesh(file: \"a.obj\", {fields})])");
    let sources = Sources::in_memory().with("a.ron", &scene).with("a.obj", model);
    expect_compiled(compile(&sources, Path::new("a.ron"), Mode::Live, None))
}

#[test]
fn a_model_of_a_survey_is_the_same_where_it_is_brought_back() {
    let Some(gpu) = gpu() else { return };
    let mut random = Random(21);
    let rays: Vec<Ray> = (0..3000)
        .map(|_| {
            let origin = 4.0 * random.unit();
            let direction = (1.3 * random.share() * random.unit() - origin).as_vec3();
            Ray { origin: origin.as_vec3(), t_min: 0.0, direction, t_max: 1e30 }
        })
        .collect();
    let ask = |model: &str, fields: &str| {
        let compiled = compiled(model, fields);
        let probe = Probe::build(gpu, &compiled, &Moment::of(&compiled.scene), [64, 64]).unwrap();
        probe.rays(&rays).unwrap()
    };
    for turn in ["", ", rotate_deg: (0, 0, 90), scale: (1, 1, -1)"] {
        let near = ask(&shapes::made("torus.obj").unwrap(), &turn.replacen(", ", "", 1));
        for by in FAR {
            // A quarter around z, after a mirror across z.
            let moved = if turn.is_empty() { by } else { DVec3::new(-by.y, by.x, -by.z) };
            let back = format!("translate: ({}, {}, {}){turn}", -moved.x, -moved.y, -moved.z);
            let far = ask(&far_torus(by), &back);
            let wrong = near.iter().zip(&far).filter(|(near, far)| match (near, far) {
                (Some(near), Some(far)) => {
                    near.position.distance(far.position) > 1e-4 || near.normal.distance(far.normal) > 1e-2
                }
                (near, far) => near.is_some() != far.is_some(),
            });
            // Rays along an edge of the silhouette may do either.
            let wrong = wrong.count();
            assert!(wrong <= 6, "{by}: {wrong} of {} rays meet something else", rays.len());
        }
    }
}

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
    let mut writer = super::glb_writer::Writer::default();
    let positions = writer.vectors(&[[0.0; 3], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0]]);
    writer.mesh(serde_json::json!([{ "attributes": { "POSITION": positions } }]));
    let nodes = serde_json::json!([
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
    let compiled = compiled(&far_torus(FAR[2]), "");
    let [x, y, z] = compiled.scene.objects[0].space.expect("it is moved");
    assert_eq!([x[3], y[3], z[3]], [0.0, 0.0, -20_000.0]);
}
