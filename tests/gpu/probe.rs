//! A probe's answers where they are plain to see: materials at points, crossings of rays, long lists.

use crate::common::{expect_compiled, outcome_of};
use crate::device;
use glam::{Vec2, Vec3};
use raytoy::frame::Moment;
use raytoy::gpu::{Probe, Ray, SurfacePoint};
use raytoy::wgsl::Mode;

const SCENE: &str = "(objects: [
    Plane(offset: -1, material: (color: Checker(even: 0.2, odd: 0.7))),
    Sphere(translate: (0, 2, 0), scale: (1, 2, 1), material: (color: (0.1, 0.2, 0.3), emission: Stripes(even: 0, odd: 1))),
])";

/// The scene with `0.7` replaced, in both modes.
fn probes(odd: &str) -> Vec<(Probe, Vec<f32>)> {
    let Some(gpu) = device::gpu() else { return vec![] };
    let probe = |mode| {
        let compiled = expect_compiled(outcome_of("a.ron", &SCENE.replace("0.7", odd), mode));
        let moment = Moment::of(&compiled.scene);
        let probe = Probe::build(gpu, &compiled, &moment, [16, 9]).unwrap_or_else(|e| panic!("{e}"));
        (probe, compiled.source.numbers)
    };
    [Mode::Live, Mode::Baked].map(probe).into()
}

fn down(x: f32, z: f32) -> Ray {
    let (origin, direction) = (Vec3::new(x, 9.0, z), Vec3::NEG_Y * 2.0);
    Ray { origin, t_min: 0.0, direction, t_max: 1e30 }
}

#[test]
fn rays_meet_what_is_in_their_way() {
    for (probe, _) in probes("0.7") {
        let short = Ray { t_max: 1.0, ..down(0.0, 0.0) };
        let behind = Ray { t_min: 3.0, ..down(0.0, 0.0) };
        let up = Ray { direction: Vec3::Y, ..down(0.0, 0.0) };
        let rays = [down(0.0, 0.0), down(3.0, -2.0), short, behind, up];
        let found = probe.rays(&rays).unwrap();
        let seen: Vec<_> = found.iter().map(|hit| hit.map(|hit| (hit.object, hit.t))).collect();
        assert_eq!(seen, [Some((1, 2.5)), Some((0, 5.0)), None, Some((1, 4.5)), None]);
        let (ball, floor) = (found[0].unwrap(), found[1].unwrap());
        assert_eq!((ball.position, ball.normal), (Vec3::new(0.0, 4.0, 0.0), Vec3::Y));
        assert_eq!((floor.position, floor.uv), (Vec3::new(3.0, -1.0, -2.0), Vec2::new(3.0, -2.0)));
    }
}

#[test]
fn materials_are_those_of_the_object() {
    let probes = probes("0.7");
    let at = |object, u: f32, footprint| SurfacePoint {
        object,
        uv: Vec2::new(u, 0.5),
        footprint,
        ..Default::default()
    };
    for (probe, _) in &probes {
        let points = [
            at(0, 0.5, 0.0),
            at(0, 1.5, 0.0),
            at(0, 1.0, 0.5),
            at(1, 0.5, 0.0),
            at(1, 1.5, 0.0),
            at(2, 0.0, 0.0),
        ];
        let looks = probe.materials(&points).unwrap();
        let grey = |x| Vec3::splat(x);
        let colors =
            [grey(0.2), grey(0.7), grey(0.45), Vec3::new(0.1, 0.2, 0.3), Vec3::new(0.1, 0.2, 0.3), grey(0.0)];
        let near = |a: Vec3, b: Vec3| a.distance(b) < 1e-6;
        assert!(looks.iter().zip(colors).all(|(look, color)| near(look.color, color)), "{looks:?}");
        let lights = [0.0, 0.0, 0.0, 0.0, 1.0, 0.0];
        assert!(looks.iter().zip(lights).all(|(look, light)| near(look.emission, grey(light))), "{looks:?}");
    }
    // New numbers reach the live one; the baked one has them in its text.
    let others = self::probes("0.9");
    let odd = [at(0, 1.5, 0.0)];
    let colors = probes.iter().zip(&others).map(|((probe, _), (_, numbers))| {
        probe.upload(numbers);
        probe.materials(&odd).unwrap()[0].color.x
    });
    let colors: Vec<f32> = colors.collect();
    assert!(colors.is_empty() || colors == [0.9, 0.7], "{colors:?}");
}

#[test]
fn long_lists_keep_their_order() {
    for (probe, _) in probes("0.7") {
        assert_eq!(probe.rays(&[]).unwrap(), []);
        let place = |i: usize| (i % 1000) as f32 + 2.0;
        let rays: Vec<Ray> = (0..70_000).map(|i| down(place(i), 3.0)).collect();
        let found = probe.rays(&rays).unwrap();
        assert_eq!(found.len(), rays.len());
        assert!(found.iter().enumerate().all(|(i, hit)| hit.unwrap().uv == Vec2::new(place(i), 3.0)));
    }
}
