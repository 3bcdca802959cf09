//! Normals and uv of the surface that triangles stand for.

use std::f64::consts::PI;

use glam::{DVec3, Vec2};
use raytoy::gpu::{Crossing, Ray};

use super::brute_force::Soup;
use super::random::Random;
use super::{Subject, compiled, decoded, probe, shapes};
use crate::device::gpu;

/// Between two parallels of the ball that is called ball.obj, radians.
const FACET: f64 = PI / 24.0;
const RAYS: usize = 4000;

#[test]
fn smooth_normals_are_those_of_the_ball_and_flat_ones_those_of_its_facets() {
    let Some(gpu) = gpu() else { return };
    let mut random = Random(3);
    let rays: Vec<Ray> = (0..RAYS).map(|_| towards_the_ball(&mut random)).collect();
    let smooth = Subject::new(gpu, "ball.obj", "");
    let flat = Subject::new(gpu, "ball.obj", "smooth: false");
    let (mut smooth_off, mut flat_off) = (vec![], vec![]);
    for ((ray, smooth), flat) in rays.iter().zip(smooth.ask(&rays)).zip(flat.ask(&rays)) {
        let (smooth, flat) = (smooth.expect("it is in the way"), flat.expect("it is in the way"));
        assert_eq!((smooth.t, smooth.position), (flat.t, flat.position), "the surface itself is flat");
        let of_ball = |hit: &Crossing| {
            let normal = hit.normal.as_dvec3();
            normal.angle_between(hit.position.as_dvec3())
        };
        assert!((smooth.normal.length() - 1.0).abs() < 1e-5, "{ray:?}: {smooth:?}");
        smooth_off.push(of_ball(&smooth));
        flat_off.push(of_ball(&flat));
    }
    let worst = |off: &[f64]| off.iter().copied().fold(0.0, f64::max);
    eprintln!("smooth {}, flat {}, facet {FACET}", worst(&smooth_off), worst(&flat_off));
    // Half a facet is what a flat one leaves; what the means leave is of its square.
    assert!(worst(&smooth_off) < 0.5 * FACET * FACET, "{}", worst(&smooth_off));
    assert!((0.4 * FACET..FACET).contains(&worst(&flat_off)), "{}", worst(&flat_off));
}

#[test]
fn normals_that_the_file_gives_count() {
    // Beside each corner the normal of the ball itself.
    let corners = shapes::ball(24).lines().filter(|l| l.starts_with('v')).collect::<Vec<_>>().join("\n");
    let normals = corners.replace('v', "vn");
    let faces = shapes::ball(24);
    let faces = faces.lines().filter(|l| l.starts_with('f')).map(|line| {
        let words = line.split(' ').skip(1).map(|n| format!("{n}//{n}"));
        format!("f {}", words.collect::<Vec<_>>().join(" "))
    });
    let text = format!("{corners}\n{normals}\n{}", faces.collect::<Vec<_>>().join("\n"));
    let model = decoded(text.as_bytes()).unwrap();
    for corner in model.triangles.iter().flatten() {
        assert!(corner.normal.distance(corner.position) < 1e-5, "{corner:?}");
    }
}

#[test]
fn normals_of_scaled_and_mirrored_models_point_outward() {
    let Some(gpu) = gpu() else { return };
    let mut random = Random(4);
    let rays: Vec<Ray> = (0..RAYS).map(|_| towards_the_ball(&mut random)).collect();
    for scale in [[1.0, -1.0, 1.0], [-0.5, 0.8, 1.3], [-1.0, -1.0, -1.0]] {
        let [x, y, z] = scale;
        let subject = Subject::new(gpu, "ball.obj", &format!("scale: ({x}, {y}, {z})"));
        let moved = |v: DVec3| (v * DVec3::from(scale)).as_vec3();
        let moved_rays: Vec<Ray> = rays
            .iter()
            .map(|ray| Ray {
                origin: moved(ray.origin.as_dvec3()),
                direction: moved(ray.direction.as_dvec3()),
                ..*ray
            })
            .collect();
        for (ray, hit) in moved_rays.iter().zip(subject.ask(&moved_rays)) {
            let hit = hit.expect("it is in the way");
            // Of the ellipsoid.
            let outward = hit.position.as_dvec3() / (DVec3::from(scale) * DVec3::from(scale));
            let off = hit.normal.as_dvec3().angle_between(outward);
            assert!(off < FACET, "{scale:?}, {ray:?}: {hit:?} is off by {off}");
        }
    }
}

#[test]
fn uv_is_interpolated_as_the_file_says() {
    let Some(gpu) = gpu() else { return };
    // Where a corner of the cube is, so is its uv, but for one corner of one face.
    let uv_of = |p: DVec3| Vec2::new((3.0 * p.x + p.y) as f32, (0.5 * p.z - 2.0 * p.y + 7.0) as f32);
    let cube = shapes::made("cube.obj").unwrap();
    let (corners, faces): (Vec<&str>, Vec<&str>) = cube.lines().partition(|line| line.starts_with('v'));
    let uvs = corners.iter().map(|line| {
        let p: Vec<f64> = line.split(' ').skip(1).map(|x| x.parse().unwrap()).collect();
        let uv = uv_of(DVec3::from_slice(&p));
        format!("vt {} {}", uv.x, uv.y)
    });
    let faces = faces.iter().map(|line| {
        let words = line.split(' ').skip(1).map(|n| format!("{n}/{n}"));
        format!("f {}", words.collect::<Vec<_>>().join(" "))
    });
    let text: Vec<String> = corners.iter().map(|line| line.to_string()).chain(uvs).chain(faces).collect();
    let scene = "(objects: [Mesh(file: \"with_uv.obj\")])";
    let sources =
        raytoy::sources::Sources::in_memory().with("a.ron", scene).with("with_uv.obj", &text.join("\n"));
    let outcome = raytoy::compile(&sources, "a.ron".as_ref(), raytoy::wgsl::Mode::Baked, None);
    let compiled = crate::common::expect_compiled(outcome);
    let mut random = Random(6);
    let rays: Vec<Ray> = (0..RAYS).map(|_| towards_the_ball(&mut random)).collect();
    let found = probe(gpu, &compiled).rays(&rays).unwrap();
    for (ray, hit) in rays.iter().zip(found) {
        let hit = hit.expect("it is in the way");
        let expected = uv_of(hit.position.as_dvec3());
        assert!(hit.uv.distance(expected) < 2e-5, "{ray:?}: {hit:?}, not {expected}");
    }
}

#[test]
fn without_uv_a_triangle_is_seen_along_its_axis() {
    let compiled = compiled("cube.obj", "(objects: [Mesh(file: \"cube.obj\")])");
    let soup = Soup::of(&compiled.scene.models[0]);
    for (i, triangle) in compiled.scene.models[0].triangles.iter().enumerate() {
        let normal = soup.normal(i).abs();
        for corner in triangle {
            let p = corner.position;
            let expected = match normal {
                DVec3::X => [p.z, p.y],
                DVec3::Y => [p.x, p.z],
                _ => [p.x, p.y],
            };
            assert_eq!(corner.uv, Vec2::from(expected));
        }
    }
}

/// From outside at what surely lies within.
fn towards_the_ball(random: &mut Random) -> Ray {
    let origin = 3.0 * random.unit();
    let target = 0.9 * random.share().cbrt() * random.unit();
    let (origin, direction) = (origin.as_vec3(), (target - origin).as_vec3());
    Ray { origin, t_min: 0.0, direction, t_max: 1e30 }
}
