//! Closed-form cases of camera, objects, patterns and display that the reference must answer for.

use super::color::{Transfer, linear_to_srgb, named_color};
use super::light_checks::{Z, assert_near, look};
use super::render;

#[test]
fn camera_rays_go_through_pixel_centres() {
    // 90 degrees and 4 × 2 pixels: x is -1.5, -0.5, 0.5, 1.5 and y is 0.5, -0.5 at distance 1.
    let scene = "(camera: (eye: (0, 0, 5), target: (0, 0, 0), fov_deg: 90),
        objects: [Plane(normal: (0.1, 0.2, 1))])";
    let picture = render(scene, 4, 2).unwrap();
    for (pixel, depth) in picture.depth.iter().enumerate() {
        let (x, y) = ((pixel % 4) as f64 - 1.5, 0.5 - (pixel / 4) as f64);
        let wanted = 5.0 / (1.0 - 0.1 * x - 0.2 * y) * (x * x + y * y + 1.0).sqrt();
        assert!((depth - wanted).abs() < 1e-12, "{pixel}: {depth}, wanted {wanted}");
    }
}

#[test]
fn the_nearest_is_seen_and_of_equals_the_first() {
    let seen = |objects: &str| {
        let camera = "camera: (eye: (0, 0, 5), target: (0, 0, 0))";
        render(&format!("({camera}, objects: [{objects}])"), 1, 1).unwrap().object[0]
    };
    assert_eq!(seen("Sphere(), Sphere(radius: 2)"), 1);
    assert_eq!(seen("Sphere(radius: 2), Sphere()"), 0);
    assert_eq!(seen("Sphere(radius: 2, visible: false), Sphere()"), 1);
    assert_eq!(seen("Sphere(), Ellipsoid(), Quad(corner: (-1, -1, 1), u: (2, 0, 0), v: (0, 2, 0))"), 0);
    assert_eq!(seen("Sphere(center: (0, 3, 0))"), -1);
}

#[test]
fn tiles_keep_their_parity_below_zero() {
    let see = |pattern: &str, x: f64, z: f64| {
        let rest = format!("ambient: 1, objects: [Plane(material: (color: {pattern}(even: 1.0, odd: 0.0)))]");
        look([x, 1.0, z], [x, 0.0, z], Z, &rest).0[0]
    };
    let places = [(-0.5, 0.5), (-0.5, -0.5), (-1.5, 0.5), (0.5, 0.5), (1.5, 0.5), (1.5, -1.5)];
    let lit = places.map(|(x, z)| see("Checker", x, z) > 0.5);
    assert_eq!(lit, [false, true, true, true, false, false]);
    let lit = places.map(|(x, z)| see("Stripes", x, z) > 0.5);
    assert_eq!(lit, [false, false, true, true, false, false]);
}

#[test]
fn a_sphere_is_unrolled_by_longitude_and_latitude() {
    // Radius 2, so a tile is half a radian both ways.
    let even = |longitude: f64, latitude: f64| {
        let (y, ring) = latitude.sin_cos();
        let eye = [ring * longitude.cos(), y, ring * longitude.sin()].map(|c| 5.0 * c);
        let rest = "ambient: 1, objects: [
            Sphere(radius: 2, material: (color: Checker(even: 1.0, odd: 0.0)))]";
        look(eye, [0.0; 3], "(0.1, 1, 0.2)", rest).0[0] > 0.5
    };
    let places = [(0.3, 0.3), (0.3, 0.6), (0.6, 0.6), (0.6, 0.3), (-0.3, 0.3), (0.3, -0.3)];
    let found = places.map(|(longitude, latitude)| even(longitude, latitude));
    assert_eq!(found, [true, false, true, false, false, false]);
    assert!(even(1.3, 0.3) && !even(1.8, 0.3) && even(0.03, 0.3));
}

#[test]
fn transforms_scale_then_turn_about_x_y_z_then_move() {
    // (1, 1, 1) → scaled (2, 1, 1) → about x (2, -1, 1) → about y (1, -1, -2)
    // → about z (1, 1, -2) → moved (1, 6, -2).
    let corner = "Sphere(center: (1, 1, 1), radius: 0.01, scale: (2, 1, 1), rotate_deg: (90, 90, 90),
        translate: (0, 5, 0), material: (color: 0, emission: 1))";
    let rest = format!("ambient: 0, objects: [{corner}]");
    assert_near(look([1.0, 9.0, -2.0], [1.0, 0.0, -2.0], Z, &rest).0, [1.0; 3]);
    assert_near(look([1.0, 9.0, -2.1], [1.0, 0.0, -2.1], Z, &rest).0, [0.0; 3]);
}

#[test]
fn a_stretched_sphere_is_an_ellipsoid() {
    let see = |object: &str| {
        let scene = format!(
            "(camera: (eye: (3, 2, 4), target: (0, 0, 0)), objects: [{object}],
            lights: [Point(position: (2, 5, 3))])"
        );
        render(&scene, 24, 16).unwrap()
    };
    let stretched = see("Sphere(scale: (1.2, -0.5, 0.8), translate: (0.1, 0, 0))");
    let ellipsoid = see("Ellipsoid(center: (0.1, 0, 0), radii: (1.2, 0.5, 0.8))");
    assert!(stretched.object.contains(&0) && stretched.object == ellipsoid.object);
    stretched.radiance.iter().zip(ellipsoid.radiance).for_each(|(a, b)| assert_near(*a, b));
}

#[test]
fn transfer_curves_meet_published_values() {
    // 188 is sRGB's half grey; 21.4 % is its middle code value.
    assert!((linear_to_srgb(0.5) * 255.0 - 187.515).abs() < 1e-2);
    let [grey, ..] = named_color("#808080").unwrap().0;
    assert!((grey - 0.215_860_5).abs() < 1e-6);
    assert!((linear_to_srgb(grey) - 128.0 / 255.0).abs() < 1e-9);
    assert!((linear_to_srgb(0.002) - 0.02584).abs() < 1e-12);
    assert_eq!(Transfer::Gamma(2.0).encode(0.25), 0.5);
    assert_eq!(Transfer::Linear.encode(1.5), 1.0);
    assert_eq!(named_color("tomato"), named_color("#FF6347"));
    assert_eq!(named_color("#fa0"), named_color("#ffaa00"));
    assert_eq!(named_color("tomat"), None);
}

#[test]
fn what_cannot_be_shaded_is_named() {
    let scene = |object: &str| format!("(camera: (eye: (0, 1, 5), target: (0, 0, 0)), objects: [{object}])");
    let error = |object: &str| render(&scene(object), 1, 1).unwrap_err();
    assert!(error("Plane(material: (color: Brick(scale: 2)))").contains("`Brick`"));
    assert!(error("Mesh(file: \"a.obj\")").contains("`Mesh`"));
    assert!(error("Torus(material: (color: Checker(even: 0, odd: 1)))").contains("uv"));
    assert!(error("Sphere(radios: 1)").contains("unknown field `radios`"));
    assert!(error("Sphere(radius: NaN)").contains("finite"));
    assert!(error("Sphere(material: \"gold\")").contains("\"gold\""));
}
