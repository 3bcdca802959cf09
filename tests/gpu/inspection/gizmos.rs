//! The lines that stand for lights, targets and bounds: how many, and where.

use glam::Vec3;
use raytoy::gpu::{Line, gizmo};

/// The lines of one light, seen by the scene's camera from 10 away.
fn of_light(light: &str) -> Vec<Line> {
    let text =
        format!("(camera: (eye: (0, 0, 10), target: (0, 0, 0)), lights: [{light}], objects: [Sphere()])");
    let scene = super::scene(&text).scene;
    let lines = gizmo::lights(&scene, &scene.camera);
    assert!(lines.iter().all(|line| line.width > 0.0 && line.color.is_finite() && line.from.is_finite()));
    lines
}

fn middle(lines: &[Line]) -> Vec3 {
    lines.iter().map(|line| 0.5 * (line.from + line.to)).sum::<Vec3>() / lines.len() as f32
}

/// Whether the lines are one closed chain.
fn is_closed(lines: &[Line]) -> bool {
    let next = lines.iter().skip(1).chain(lines.first());
    lines.iter().zip(next).all(|(line, next)| line.to.distance(next.from) < 1e-4)
}

#[test]
fn a_point_is_a_cross_and_a_circle_of_its_radius() {
    let place = Vec3::new(1.0, 2.0, 3.0);
    let hard = of_light("Point(position: (1, 2, 3), color: (0.5, 0.25, 0))");
    assert_eq!(hard.len(), 3);
    assert!(middle(&hard).distance(place) < 1e-5);
    // Linear light, as a screen shows it.
    assert!(hard[0].color.distance(Vec3::new(1.0, 0.73, 0.0)) < 0.01, "{}", hard[0].color);
    let soft = of_light("Point(position: (1, 2, 3), radius: 0.75)");
    assert_eq!(
        soft[..3].iter().map(|l| l.from).collect::<Vec<_>>(),
        hard.iter().map(|l| l.from).collect::<Vec<_>>()
    );
    assert!(soft[3..].iter().all(|line| (line.from.distance(place) - 0.75).abs() < 1e-4));
    assert!(is_closed(&soft[3..]));
    // It faces the eye.
    assert!(soft[3..].iter().all(|l| (l.from - place).dot(Vec3::new(-1.0, -2.0, 7.0)).abs() < 1e-3));
}

#[test]
fn a_direction_is_arrows_that_point_along_it() {
    let lines = of_light("Directional(direction: (1, -2, 0.5))");
    let direction = Vec3::new(1.0, -2.0, 0.5).normalize();
    let shafts: Vec<&Line> =
        lines.iter().filter(|l| (l.to - l.from).normalize().dot(direction) > 0.9999).collect();
    assert_eq!((shafts.len(), lines.len()), (5, 25));
    assert!((shafts[0].to.cross(direction)).length() < 1e-5, "the middle one points at the target");
    assert!(shafts.iter().all(|shaft| shaft.to.dot(direction) < 0.0), "from where the light comes");
}

#[test]
fn a_spot_is_its_cone_as_far_as_the_target() {
    let lines = of_light("Spot(position: (0, 4, 0), target: (0, 1, 0), cone_deg: 60, radius: 0.2)");
    let tip = Vec3::Y * 4.0;
    let sides: Vec<&Line> = lines.iter().filter(|l| l.from == tip).collect();
    assert_eq!(sides.len(), 4);
    for side in sides {
        let away = side.to - tip;
        assert!(
            (away.length() - 4.0).abs() < 1e-4
                && (away.normalize().dot(Vec3::NEG_Y) - 0.75f32.sqrt()).abs() < 1e-4
        );
    }
    assert_eq!(lines.len(), 3 + 48 + 48 + 4);
}

#[test]
fn a_rectangle_is_its_sides_and_its_normal() {
    let lines = of_light("Rect(corner: (-1, 3, -1), u: (2, 0, 0), v: (0, 0, 4))");
    assert_eq!(lines.len(), 4 + 5);
    assert!(is_closed(&lines[..4]) && middle(&lines[..4]).distance(Vec3::new(0.0, 3.0, 1.0)) < 1e-5);
    let normal = lines[4].to - lines[4].from;
    assert!(
        lines[4].from.distance(Vec3::new(0.0, 3.0, 1.0)) < 1e-5
            && normal.normalize().distance(Vec3::NEG_Y) < 1e-5
    );
    assert_eq!(
        of_light("Rect(corner: (-1, 3, -1), u: (0, 0, 0), v: (0, 0, 4))").len(),
        4,
        "no area, no normal"
    );
}

#[test]
fn signs_are_as_large_on_the_screen_from_everywhere() {
    let mut scene = super::scene("(lights: [Point(position: (0, 0, 0))], objects: [Sphere()])").scene;
    let mut share = |distance: f32| {
        scene.camera.eye = Vec3::Z * distance;
        let lines = gizmo::lights(&scene, &scene.camera);
        lines[0].from.distance(lines[0].to) / distance
    };
    assert!((share(2.0) / share(500.0) - 1.0).abs() < 1e-4);
}

#[test]
fn the_target_is_a_cross() {
    let camera =
        super::scene("(camera: (eye: (9, 8, 7), target: (1, 2, 3)), objects: [Sphere()])").scene.camera;
    let lines = gizmo::camera_target(&camera);
    assert_eq!(lines.len(), 3);
    assert!(lines.iter().all(|line| (0.5 * (line.from + line.to)).distance(camera.target) < 1e-5));
}

#[test]
fn bounds_are_boxes_where_their_bodies_stand() {
    let text = "(objects: [
        Sphere(),
        Box(bounds: (min: (-1, -2, -3), max: (1, 2, 3))),
        Union(parts: [Sphere(), Box()], bounds: (min: (0, 0, 0), max: (1, 1, 1)), translate: (5, 0, 0), rotate_deg: (0, 0, 90), scale: (2, 3, 4)),
    ])";
    let lines = gizmo::bounds(&super::scene(text).scene);
    assert_eq!(lines.len(), 24);
    let (still, moved) = lines.split_at(12);
    assert!(still.iter().flat_map(|l| [l.from, l.to]).all(|p| p.abs() == Vec3::new(1.0, 2.0, 3.0)));
    let total = |lines: &[Line]| lines.iter().map(|l| l.from.distance(l.to)).sum::<f32>();
    assert!((total(still) - 4.0 * (2.0 + 4.0 + 6.0)).abs() < 1e-4);
    assert!((total(moved) - 4.0 * (2.0 + 3.0 + 4.0)).abs() < 1e-4);
    let corners: Vec<Vec3> = moved.iter().flat_map(|l| [l.from, l.to]).collect();
    let extremes = [
        corners.iter().copied().fold(Vec3::INFINITY, Vec3::min),
        corners.iter().copied().fold(Vec3::NEG_INFINITY, Vec3::max),
    ];
    // Scaled, turned from x to y, and then moved.
    let expected = [Vec3::new(2.0, 0.0, 0.0), Vec3::new(5.0, 2.0, 4.0)];
    assert!(extremes.iter().zip(expected).all(|(a, b)| a.distance(b) < 1e-4), "{extremes:?}");
    assert!(gizmo::bounds(&super::scene("(objects: [Sphere()])").scene).is_empty());
}
