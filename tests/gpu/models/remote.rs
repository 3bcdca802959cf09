//! Models that lie far from their zero, as surveys do, and are brought back by `translate`.

use std::path::Path;

use glam::DVec3;
use raytoy::frame::Moment;
use raytoy::gpu::{Probe, Ray};
use raytoy::sources::Sources;
use raytoy::wgsl::Mode;
use raytoy::{Compiled, compile};

use super::random::Random;
use super::shapes::{self, FAR, far_torus};
use crate::common::expect_compiled;
use crate::device::gpu;

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
