//! The laws of raytoy's own textures and shapes, and that each law can be broken.

use std::collections::BTreeSet;

use crate::common::expect_none;
use crate::patterns::{built_in, by_devices, functions};
use glam::Vec3;
use raytoy::laws::values::same_bits;
use raytoy::laws::{Broken, Law, World, check, check_shape, check_textures};
use raytoy::library::{Family, name_of};

/// Textures of one scene. The software driver computes all of them for each point, so few are faster.
const AT_ONCE: usize = 4;

#[test]
fn textures_keep_the_laws() {
    let world = built_in();
    let textures = functions(&world, Family::Texture);
    let groups: Vec<_> = textures.chunks(AT_ONCE).collect();
    let check = |gpu: &_, group: &&[_]| {
        check_textures(gpu, &world, group).unwrap_or_else(|problem| panic!("{problem}"))
    };
    let Some(found) = by_devices(&groups, check) else { return };
    expect_none(first_of_each(found.concat()));
}

#[test]
fn shapes_keep_the_laws() {
    let world = built_in();
    let shapes = functions(&world, Family::Shape);
    let check =
        |gpu: &_, shape: &_| check_shape(gpu, &world, shape).unwrap_or_else(|problem| panic!("{problem}"));
    let Some(found) = by_devices(&shapes, check) else { return };
    expect_none(first_of_each(found.concat()));
}

#[test]
fn each_law_of_textures_can_be_broken() {
    let wrong = [
        ("infinite", "return 1.0 / (at.position.x - at.position.x);", Law::IsFinite),
        ("boundless", "return at.uv.x;", Law::StaysInRange),
        ("rough", "return fract(at.position.x * a * 1.7 * a * 1e5);", Law::IsTheSameLiveAndBaked),
        ("jumpy", "return select(0.0, 1.0, at.footprint > 0.0);", Law::IsHardUpClose),
        ("harsh", "return fract(at.uv.x + 0.0 * at.footprint);", Law::IsEvenFromAfar),
    ];
    let written = wrong.map(|(name, body, law)| {
        let text = format!(
            "/// Wrong.\n///\n/// a = 1.3: a\nfn {name}(at: Surface, a: f32) -> f32 {{\n    {body}\n}}\n"
        );
        (name, text, law)
    });
    expect_broken(Family::Texture, &written);
    // No text makes a shader forgetful, so this law is asked by itself.
    let (values, again) = ([Vec3::ONE, Vec3::ZERO], [Vec3::ONE, -Vec3::ZERO]);
    assert!(same_bits(&values, &values).is_none());
    assert!(same_bits(&values, &again).is_some_and(|(i, _)| i == 1));
}

#[test]
fn each_law_of_shapes_can_be_broken() {
    // A right ball, of which each wrong one differs in one line.
    let ball = "let middle = nearestApproach(ray, vec3f(0.0));
    let p = ray.origin + middle * ray.direction;
    let half = sqrt(max(radius * radius - dot(p, p), 0.0)) / length(ray.direction);
    if half == 0.0 {
        return NO_HIT;
    }
    return firstOnRay(ray, middle - half, middle + half);";
    let surface = "return surface(p, normalize(p), p.xy);";
    let first_only =
        ball.replace("firstOnRay(ray, middle - half, middle + half)", "onRay(ray, middle - half)");
    let seen_once =
        first_only.replace("return onRay", "if ray.direction.x < 0.0 { return NO_HIT; }\n return onRay");
    let wrong = [
        ("right", ball, surface, None),
        ("unmet", "return NO_HIT;", surface, Some(Law::IsMetByRays)),
        (
            "unnumbered",
            ball,
            "return surface(p, normalize(p), vec2f(1.0) / (p.x - p.x));",
            Some(Law::IsFinite),
        ),
        (
            "rushed",
            &ball.replace("firstOnRay(ray, middle - half, middle + half)", "middle - half"),
            surface,
            Some(Law::KeepsToTheRay),
        ),
        ("longish", ball, "return surface(p, p * 1.1, p.xy);", Some(Law::HasUnitNormals)),
        ("displaced", ball, "return surface(1.1 * p, normalize(p), p.xy);", Some(Law::HasItsSurfaceThere)),
        ("inward", ball, "return surface(p, -normalize(p), p.xy);", Some(Law::FacesTheRay)),
        (
            "rough",
            &ball.replace(
                "radius * radius -",
                "radius * radius * (0.7 + 0.3 * fract(ray.origin.x * radius * 1.7 * radius * 1e5)) -",
            ),
            surface,
            Some(Law::IsTheSameLiveAndBaked),
        ),
        ("endless", &first_only, surface, Some(Law::IsEnteredAndLeft)),
        ("onesided", &seen_once, surface, Some(Law::IsTheSameFromBehind)),
    ];
    let written: Vec<_> = wrong
        .into_iter()
        .map(|(name, body, surface, law)| {
            let text = format!(
                "/// A ball.\n///\n/// radius = 1.1, 0.1 to 10: its radius\n\
                 fn {name}(ray: Ray, radius: f32) -> f32 {{\n    {body}\n}}\n\n\
                 fn {name}Surface(p: vec3f, radius: f32) -> Surface {{\n    {surface}\n}}\n"
            );
            (name, text, law)
        })
        .collect();
    let Some(found) = broken(Family::Shape, written.iter().map(|(name, text, _)| (*name, text.as_str())))
    else {
        return;
    };
    for (name, _, law) in written {
        let laws: BTreeSet<Law> =
            found.iter().filter(|broken| broken.name == name_of(name)).map(|broken| broken.law).collect();
        match law {
            Some(law) => assert!(laws.contains(&law), "{name} keeps {law:?}; broken are {laws:?}"),
            None => assert!(laws.is_empty(), "{found:#?}"),
        }
    }
}

fn expect_broken(family: Family, wrong: &[(&str, String, Law)]) {
    let Some(found) = broken(family, wrong.iter().map(|(name, text, _)| (*name, text.as_str()))) else {
        return;
    };
    for (name, _, law) in wrong {
        let is_it = |broken: &Broken| broken.name == name_of(name) && broken.law == *law;
        assert!(found.iter().any(is_it), "{name} keeps {law:?}; broken are {found:#?}");
    }
}

/// What is broken by files with these names and texts; nothing where there is no device.
fn broken<'a>(family: Family, files: impl Iterator<Item = (&'a str, &'a str)>) -> Option<Vec<Broken>> {
    let folder = if family == Family::Shape { "shapes" } else { "textures" };
    let files: Vec<(String, String)> =
        files.map(|(name, text)| (format!("{folder}/{name}.wgsl"), text.to_owned())).collect();
    let world = World { files: files.clone(), ..World::default() };
    let own = functions(&world, family).into_iter().filter(|f| files.iter().any(|(file, _)| *file == f.file));
    let own: Vec<_> = own.collect();
    let check =
        |gpu: &_, function: &_| check(gpu, &world, function).unwrap_or_else(|problem| panic!("{problem}"));
    Some(by_devices(&own, check)?.concat())
}

/// One line for each law that something breaks.
fn first_of_each(mut found: Vec<Broken>) -> Vec<String> {
    let mut known = BTreeSet::new();
    found.retain(|broken| known.insert((broken.name.clone(), broken.law)));
    found.iter().map(Broken::to_string).collect()
}
