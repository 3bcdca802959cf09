//! Closed-form cases of light that the reference itself must answer for.

use super::render;

/// The only pixel's radiance and depth, seen from `eye` towards `target`.
pub fn look(eye: [f64; 3], target: [f64; 3], up: &str, rest: &str) -> ([f64; 3], f64) {
    let [eye, target] = [eye, target].map(|p| format!("({}, {}, {})", p[0], p[1], p[2]));
    let camera = format!("camera: (eye: {eye}, target: {target}, up: {up})");
    let picture = render(&format!("({camera}, {rest})"), 1, 1).unwrap();
    (picture.radiance[0], picture.depth[0])
}

pub fn assert_near(found: [f64; 3], wanted: [f64; 3]) {
    let near = found.iter().zip(wanted).all(|(a, b)| (a - b).abs() < 1e-12);
    assert!(near, "{found:?}, wanted {wanted:?}");
}

fn lamp(center: [f64; 3], radius: f64) -> String {
    let [x, y, z] = center;
    format!("Sphere(center: ({x}, {y}, {z}), radius: {radius}, material: (color: 0, emission: 1))")
}

const GLASS: &str = "(color: 0.0, transmission: 1.0, ior: 1.5)";
pub const Z: &str = "(0, 0, 1)";

#[test]
fn a_sphere_is_hit_and_lit_where_geometry_says() {
    // n = v = z and l is 60 degrees off it, so h is 30 degrees off n.
    let rest = "ambient: 0.25, lights: [Directional(direction: (0, -0.8660254037844386, -0.5),
            color: (1, 0.5, 0), intensity: 2)],
        objects: [Sphere(center: (0, 0, -3), radius: 2,
            material: (color: (0.4, 0.2, 0.6), specular: 0.5, shininess: 4))]";
    let (radiance, depth) = look([0.0, 0.0, 4.0], [0.0; 3], "(0, 1, 0)", rest);
    assert!((depth - 5.0).abs() < 1e-12, "{depth}");
    let gloss = 0.5 * 0.75_f64.powi(2);
    assert_near(radiance, [0.1 + 2.0 * (0.2 + gloss), 0.05 + 0.1 + gloss, 0.15]);
}

#[test]
fn a_highlight_follows_the_half_vector() {
    // v is 30 degrees left of n and l 60 degrees right of it: h is 15 degrees off n.
    let rest = "ambient: 0, lights: [Directional(direction: (-0.8660254037844386, -0.5, 0))],
        objects: [Plane(material: (color: 0, specular: 0.8, shininess: 20))]";
    let eye = [-1.0, 3_f64.sqrt(), 0.0];
    let gloss = 0.8 * 15_f64.to_radians().cos().powi(20);
    assert_near(look(eye, [0.0; 3], "(0, 1, 0)", rest).0, [gloss; 3]);
}

#[test]
fn a_mirror_shows_what_is_at_the_mirrored_angle() {
    let scene = |mirror: &str, bounces: u32| {
        format!(
            "ambient: 0, render: (max_bounces: {bounces}), objects: [
            Plane(material: (color: 0, {mirror})), Sphere(center: (5, 5, 0), radius: 0.01,
                material: (color: 0, emission: (0.2, 0.4, 0.6)))]"
        )
    };
    let see = |mirror, bounces| look([-3.0, 3.0, 0.0], [0.0; 3], "(0, 1, 0)", &scene(mirror, bounces)).0;
    assert_near(see("reflectivity: 0.5", 1), [0.1, 0.2, 0.3]);
    assert_near(see("reflectivity: 0.5", 0), [0.0; 3]);
    let f = 0.5 + 0.5 * (1.0 - 0.5_f64.sqrt()).powi(5);
    assert_near(see("reflectivity: 0.5, fresnel: 5", 1), [0.2 * f, 0.4 * f, 0.6 * f]);
}

#[test]
fn branches_below_the_least_weight_add_nothing() {
    // 0.04² is below 1/512: the second reflection is cut, long before the bounces end.
    let rest = "ambient: 0, render: (max_bounces: 9), objects: [
        Plane(material: (color: 0, emission: 1, reflectivity: 0.04)),
        Plane(offset: 2, material: (color: 0, emission: 1, reflectivity: 0.04))]";
    let (radiance, _) = look([0.0, 1.0, 0.0], [0.0; 3], Z, rest);
    assert_near(radiance, [0.96 + 0.04 * 0.96; 3]);
}

#[test]
fn a_slab_shifts_a_ray_by_snells_law() {
    let sin = 60_f64.to_radians().sin();
    let across = (sin / 1.5).asin().tan();
    let beyond = [across + sin, -1.5, 0.0];
    let see = |lamp: String| {
        let slab = format!("Box(min: (-9, -1, -9), max: (9, 0, 9), material: {GLASS})");
        let rest = format!("ambient: 0, objects: [{slab}, {lamp}]");
        look([-2.0 * sin, 1.0, 0.0], [0.0; 3], "(0, 1, 0)", &rest).0
    };
    assert_near(see(lamp(beyond, 1e-6)), [1.0; 3]);
    assert_near(see(lamp([beyond[0] + 1e-3, beyond[1], 0.0], 1e-4)), [0.0; 3]);
}

#[test]
fn glass_reflects_totally_beyond_the_critical_angle() {
    // From inside, under the face y = 0; the critical angle of 1.5 is 41.8 degrees.
    let see = |degrees: f64, lamp: String| {
        let (sin, cos) = degrees.to_radians().sin_cos();
        let block = format!("Box(min: (-9, -9, -9), max: (9, 0, 9), material: {GLASS})");
        let rest = format!("ambient: 0, objects: [{block}, {lamp}]");
        look([-3.0 * sin, -3.0 * cos, 0.0], [0.0; 3], "(0, 1, 0)", &rest).0
    };
    let (sin, cos) = 60_f64.to_radians().sin_cos();
    assert_near(see(60.0, lamp([2.0 * sin, -2.0 * cos, 0.0], 1e-6)), [1.0; 3]);
    // 30 degrees leaves with sin = 1.5 / 2.
    let outside = [0.75, (1.0 - 0.75_f64.powi(2)).sqrt(), 0.0];
    assert_near(see(30.0, lamp(outside, 1e-6)), [1.0; 3]);
}

#[test]
fn shadows_are_hard_and_can_be_turned_off() {
    let see = |blocker: &str, render: &str| {
        let rest = format!(
            "ambient: 0, {render} lights: [Point(position: (0, 4, 0), falloff: InverseSquare)],
            objects: [Plane(material: (color: 1)), Sphere(center: (0, 2, 0), radius: 0.1 {blocker})]"
        );
        look([3.0, 1.0, 0.0], [0.0; 3], "(0, 1, 0)", &rest).0
    };
    assert_near(see("", ""), [0.0; 3]);
    assert_near(see(", visible: false", ""), [0.0; 3]);
    assert_near(see(", casts_shadow: false", ""), [1.0 / 16.0; 3]);
    assert_near(see("", "render: (shadows: false),"), [1.0 / 16.0; 3]);
}

#[test]
fn a_spot_fades_inside_its_cone() {
    // The cone is 60 degrees wide and its outer half fades: full to 15 degrees, dark from 30.
    let see = |degrees: f64| {
        let x = degrees.to_radians().tan();
        let rest = "ambient: 0, lights: [Spot(position: (0, 1, 0), target: (0, 0, 0),
            cone_deg: 60, blend: 0.5)], objects: [Plane(material: (color: 1))]";
        look([x, 0.5, 0.0], [x, 0.0, 0.0], Z, rest).0[0] / degrees.to_radians().cos()
    };
    let [full, dark] = [15_f64, 30_f64].map(|degrees| degrees.to_radians().cos());
    let half = (0.5 * (full + dark)).acos().to_degrees();
    assert_near([see(14.9), see(half), see(30.1)], [1.0, 0.5, 0.0]);
}
