//! What the window sees of a scene besides its picture: what lies under a pixel, lines over it, debug views, parts.

mod gizmos;
mod lines;
mod views;

use crate::common::{expect_compiled, expect_none, outcome, outcome_of};
use crate::{device, draw};
use glam::{Vec2, Vec3, vec2};
use raytoy::Compiled;
use raytoy::frame::{Lens, Moment, View};
use raytoy::gpu::{Gpu, Identity, Picture, Pipeline, Probe, Ray};
use raytoy::sources::Sources;
use raytoy::wgsl::Mode;

const SIZE: [u32; 2] = [96, 64];

fn scene(text: &str) -> Compiled {
    expect_compiled(outcome_of("a.ron", text, Mode::Baked))
}

fn identity(gpu: &Gpu, compiled: &Compiled, size: [u32; 2]) -> Identity {
    let pipeline = Pipeline::build(gpu, compiled).unwrap_or_else(|e| panic!("{e}"));
    let seen = Identity::draw(gpu, &pipeline, &Moment::of(&compiled.scene), &compiled.scene.render, size);
    seen.unwrap_or_else(|e| panic!("{e}"))
}

fn middles(size: [u32; 2]) -> impl Iterator<Item = (u32, u32, Vec2)> {
    let pixels = (0..size[1]).flat_map(move |y| (0..size[0]).map(move |x| (x, y)));
    pixels.map(|(x, y)| (x, y, vec2(x as f32, y as f32) + 0.5))
}

fn view(gpu: &Gpu, compiled: &Compiled, view: View) -> Picture {
    draw::picture(gpu, compiled, SIZE, view)
}

/// The middle pixel of a picture.
fn middle(picture: &Picture) -> Vec3 {
    Vec3::from(picture.radiance[(SIZE[1] / 2 * SIZE[0] + SIZE[0] / 2) as usize])
}

#[test]
fn a_pixel_is_what_its_ray_meets() {
    let Some(gpu) = device::gpu() else { return };
    // Shapes, moved ones, parts of solids, marched ones, bumps, mirrors and glass.
    let scenes =
        ["scenes/shapes.ron", "scenes/solids.ron", "scenes/glass.ron", "tests/cases/materials/bump.ron"];
    let live = [("scenes/table.ron", Mode::Live)];
    expect_none(scenes.map(|name| (name, Mode::Baked)).into_iter().chain(live).flat_map(|(name, mode)| {
        let compiled = expect_compiled(outcome(name, mode));
        let seen = identity(gpu, &compiled, SIZE);
        let moment = Moment::of(&compiled.scene);
        let lens = Lens::new(&moment.camera, SIZE);
        let probe = Probe::build(gpu, &compiled, &moment, SIZE).unwrap_or_else(|e| panic!("{e}"));
        let ray = |(.., pixel): (u32, u32, Vec2)| Ray {
            origin: lens.eye,
            t_min: 0.0,
            direction: lens.direction(pixel),
            t_max: 1e30,
        };
        let rays: Vec<Ray> = middles(SIZE).map(ray).collect();
        let crossings = probe.rays(&rays).unwrap_or_else(|e| panic!("{e}"));
        assert!(crossings.iter().any(Option::is_some), "{name} shows nothing");
        middles(SIZE).zip(crossings).find_map(|((x, y, pixel), expected)| {
            let actual = seen.at(x, y);
            let is_same = match (actual, expected) {
                (Some(a), Some(b)) => {
                    // The two make their ray apart: where it grazes a surface, its last digit goes far.
                    let slant = lens.direction(pixel).dot(b.normal).abs();
                    let slack = (1e-5 + 1e-7 / slant.max(1e-6)) * b.t;
                    a.object == b.object
                        && (a.distance - b.t).abs() <= slack
                        && a.position.distance(b.position) <= 2e-5 + slack
                        && a.normal.distance(b.normal) < 1e-3
                        && a.uv.distance(b.uv) <= 1e-4 + 10.0 * slack
                }
                (a, b) => a.is_none() && b.is_none(),
            };
            (!is_same).then(|| format!("{name}, pixel {x}, {y}: {actual:?}, not {expected:?}"))
        })
    }));
}

#[test]
fn nothing_is_under_the_sky_or_beside_the_picture() {
    let Some(gpu) = device::gpu() else { return };
    let seen =
        identity(gpu, &scene("(camera: (eye: (0, 0, 5), target: (0, 0, 0)), objects: [Sphere()])"), SIZE);
    assert_eq!(seen.size(), SIZE);
    assert_eq!(seen.at(0, 0), None);
    assert!(
        [(SIZE[0], 0), (0, SIZE[1]), (u32::MAX, u32::MAX)].iter().all(|(x, y)| seen.at(*x, *y).is_none())
    );
    let middle = seen.at(48, 32).expect("the ball is there");
    assert!(middle.normal.distance(Vec3::Z) < 0.1 && (middle.distance - 4.0).abs() < 0.01, "{middle:?}");
}

#[test]
fn an_outline_is_two_pixels_along_the_border() {
    let Some(gpu) = device::gpu() else { return };
    let text = "(camera: (eye: (0, 0, 5), target: (0, 0, 0)), objects: [
        Plane(normal: (0, 0, 1), offset: -9), Sphere(name: \"left\", center: (-0.7, 0, 0)), Sphere(center: (0.7, 0, 0))])";
    let seen = identity(gpu, &scene(text), SIZE);
    assert!(seen.outline(|_| false).is_empty() && seen.outline(|_| true).is_empty());
    let object = |x: u32, y: u32| seen.object(x, y).expect("the wall is behind all");
    for chosen in [&[1][..], &[2], &[1, 2]] {
        let is_chosen = |o: u32| chosen.contains(&o);
        let outline = seen.outline(is_chosen);
        assert!(outline.is_sorted_by_key(|[x, y]| (*y, *x)));
        for (x, y, _) in middles(SIZE) {
            let differs = |u: u32, v: u32| is_chosen(object(u, v)) != is_chosen(object(x, y));
            let is_border = (x > 0 && differs(x - 1, y))
                || (y > 0 && differs(x, y - 1))
                || (x + 1 < SIZE[0] && differs(x + 1, y))
                || (y + 1 < SIZE[1] && differs(x, y + 1));
            assert_eq!(outline.contains(&[x, y]), is_border, "{chosen:?}: {x}, {y}");
        }
    }
    // Each side has its pixels, but the two balls none between them.
    let inner = |chosen: &[u32]| {
        let outline = seen.outline(|o| chosen.contains(&o));
        outline.iter().filter(|[x, y]| chosen.contains(&object(*x, *y))).count()
    };
    assert!(inner(&[1, 2]) + 20 < inner(&[1]) + inner(&[2]), "{} of {}", inner(&[1, 2]), inner(&[1]));
}

#[test]
fn a_floor_is_not_outlined_where_things_stand_on_it() {
    let Some(gpu) = device::gpu() else { return };
    let text = "(camera: (eye: (0, 2, 7), target: (0, 0.7, 0)), objects: [Plane(name: \"floor\"),
        Sphere(center: (-1.3, 1, 0)), Box(min: (0.6, 0, -0.5), max: (2, 1.5, 0.5)), Sphere(center: (0, 0.4, 2), radius: 0.2)])";
    let seen = identity(gpu, &scene(text), SIZE);
    let beside = |chosen: u32, other: Option<u32>| {
        let meets = |x: u32, y: u32| {
            let sides = [(x.wrapping_sub(1), y), (x + 1, y), (x, y.wrapping_sub(1)), (x, y + 1)];
            let is_inside = |(x, y): &(u32, u32)| *x < SIZE[0] && *y < SIZE[1];
            seen.object(x, y) == Some(chosen)
                && sides.iter().filter(|at| is_inside(at)).any(|(u, v)| seen.object(*u, *v) == other)
        };
        let outline = seen.outline(|object| object == chosen);
        let all = middles(SIZE).filter(|(x, y, _)| meets(*x, *y)).count();
        (outline.iter().filter(|[x, y]| meets(*x, *y)).count(), all)
    };
    // The floor ends at the horizon, and nowhere else.
    let (shown, all) = beside(0, None);
    assert!(shown == all && all > 20, "{shown} of {all}");
    for thing in [1, 2, 3] {
        let (shown, all) = beside(0, Some(thing));
        assert!(all > 5 && shown <= 4, "the floor beside {thing}: {shown} of {all}");
        let (shown, all) = beside(thing, Some(0));
        assert!(shown == all && all > 5, "{thing} beside the floor: {shown} of {all}");
    }
}

#[test]
fn a_lens_finds_the_pixels_of_points_and_the_points_of_pixels() {
    let camera = scene(
        "(camera: (eye: (3, 4, 5), target: (-1, 0.5, 2), up: (0.2, 1, 0), fov_deg: 70), objects: [Sphere()])",
    );
    let lens = Lens::new(&camera.scene.camera, SIZE);
    for (.., pixel) in middles(SIZE) {
        for distance in [0.01, 1.0, 3000.0] {
            let point = lens.eye + distance * lens.direction(pixel);
            assert!(lens.pixel(point).distance(pixel) < 0.01, "{pixel} at {distance}: {}", lens.pixel(point));
            assert!(lens.depth(point) > 0.0 && lens.depth(2.0 * lens.eye - point) < 0.0);
        }
    }
}

#[test]
fn balls_stand_where_the_lens_has_them() {
    let Some(gpu) = device::gpu() else { return };
    let centers = [vec2(-1.8, 1.0), vec2(0.0, 0.0), vec2(1.7, -0.9), vec2(2.0, 1.1), vec2(-0.4, 0.8)];
    let balls = centers.map(|c| format!("Sphere(center: ({}, {}, {}), radius: 0.15)", c.x, c.y, c.x - c.y));
    let text = format!(
        "(camera: (eye: (1, 2, 9), target: (0.2, 0, 0), fov_deg: 30), objects: [{}])",
        balls.join(", ")
    );
    let compiled = scene(&text);
    let size = [480, 320];
    let seen = identity(gpu, &compiled, size);
    let lens = Lens::new(&compiled.scene.camera, size);
    for (index, center) in centers.iter().enumerate() {
        let own: Vec<Vec2> = middles(size)
            .filter(|(x, y, _)| seen.object(*x, *y) == Some(index as u32))
            .map(|(.., pixel)| pixel)
            .collect();
        let mean = own.iter().sum::<Vec2>() / own.len() as f32;
        let expected = lens.pixel(center.extend(center.x - center.y));
        // Seen aside, a ball's picture is an ellipse whose middle lies a little farther out.
        assert!(own.len() > 100 && mean.distance(expected) < 0.15, "ball {index}: {mean}, not {expected}");
    }
}

#[test]
fn light_that_is_no_number_is_marked() {
    let Some(gpu) = device::gpu() else { return };
    let texture = "/// Right of x = 0 no number.\nfn broken(at: Surface) -> vec3f {\n    return vec3f(sqrt(-at.position.x));\n}\n";
    let text = "(camera: (eye: (0, 0, 5), target: (0, 0, 0)), ambient: 1, objects: [Box(material: (color: Broken()))])";
    let sources = Sources::in_memory().with("a.ron", text).with("textures/broken.wgsl", texture);
    let compiled = expect_compiled(raytoy::compile(&sources, "a.ron".as_ref(), Mode::Baked, None));
    let marked = view(gpu, &compiled, View::Nan);
    let at = |x: u32| Vec3::from(marked.radiance[(32 * SIZE[0] + x) as usize]);
    assert_eq!(at(52), Vec3::new(1.0, 0.0, 1.0));
    let dim = at(44);
    assert!(dim == Vec3::splat(dim.x) && dim.x > 0.02 && dim.x < 0.4, "{dim}");
    let infinite = scene(
        "(camera: (eye: (0, 0, 5), target: (0, 0, 0)), objects: [Sphere(material: (emission: 1e6))],
        lights: [Point(position: (0, 0, 3), intensity: 1e6)], background: 0.5)",
    );
    let picture = view(gpu, &infinite, View::Nan);
    assert!(
        picture.radiance.iter().all(|p| p[0] == p[1] && p[1] == p[2] && p[0] <= 0.4),
        "all of it is finite"
    );
}

#[test]
fn cost_counts_the_tests_of_rays() {
    let Some(gpu) = device::gpu() else { return };
    // Out of the red of the ramp, up to its first stop, violet, after 4 doublings.
    let cost = |rest: &str| {
        let text = format!("(camera: (eye: (0, 0, 5), target: (0, 0, 0)), {rest})");
        let red = middle(&view(gpu, &scene(&text), View::Cost)).x;
        (4.0 * red / 0.34).exp2()
    };
    let near = |actual: f32, expected: f32| {
        assert!((actual / expected - 1.0).abs() < 1e-3, "{actual}, not {expected}")
    };
    let ball = "Sphere()";
    near(cost(&format!("objects: [{ball}]")), 1.0);
    let eight = format!("objects: [{}]", [ball; 8].join(", "));
    near(cost(&eight), 8.0);
    // A shadow ray counts the bodies that cast shadows, a soft light sends several.
    let hidden = "Sphere(center: (0, 9, 0), visible: false), Sphere(center: (0, 7, 0), casts_shadow: false)";
    let objects = format!("objects: [{ball}, {hidden}]");
    near(cost(&format!("{objects}, lights: [Point(position: (0, 0, 9))]")), 2.0 + 2.0);
    let soft = "lights: [Point(position: (0, 0, 9), radius: 0.1)], render: (shadow_samples: 5)";
    near(cost(&format!("{objects}, {soft}")), 2.0 + 5.0 * 2.0);
    // Out of a mirror another ray comes.
    near(cost("objects: [Sphere(material: (reflectivity: 1))], render: (max_bounces: 3)"), 2.0);
    // Bounds keep a ray from what it does not come near.
    let bounded = "Box(min: (4, 4, 0), bounds: (min: (4, 4, 0), max: (5, 5, 1)), max: (5, 5, 1))";
    near(cost(&format!("objects: [{ball}, {bounded}]")), 1.0);
    // Steps, boxes and crossings of parts: more than one each.
    for one in ["Gyroid()", "Difference(parts: [Sphere(), Sphere(radius: 0.5)])"] {
        assert!(cost(&format!("objects: [{one}]")) > 2.0, "{one}");
    }
}

#[test]
fn faces_are_told_from_their_backs() {
    let Some(gpu) = device::gpu() else { return };
    let facing = |text: &str| middle(&view(gpu, &scene(text), View::Facing));
    let outside = facing("(camera: (eye: (0, 0, 5), target: (0, 0, 0)), objects: [Sphere()])");
    let inside = facing("(camera: (eye: (0, 0, 0.5), target: (0, 0, 0)), objects: [Sphere()])");
    assert!(outside.z > 0.8 && outside.x < 0.3, "{outside}");
    assert!(inside.x > 0.8 && inside.z < 0.3, "{inside}");
    // The wall of a hole is the outside of what is left.
    let hole = facing(
        "(camera: (eye: (0, 0, 5), target: (0, 0, 0)), objects: [
        Difference(parts: [Sphere(radius: 2), Sphere(center: (0, 0, 2), radius: 1)])])",
    );
    assert!(hole.z > 0.8 && hole.x < 0.3, "{hole}");
}

#[test]
fn an_isolated_object_is_alone_with_its_body() {
    let Some(gpu) = device::gpu() else { return };
    let text = "(camera: (eye: (0, 3, 8), target: (0, 0, 0)), background: 0.5, lights: [Point(position: (0, 9, 0))],
        objects: [
            Plane(name: \"floor\", offset: -1), Sphere(name: \"ball\", center: (-2, 0, 0)),
            Union(name: \"pair\", parts: [Box(name: \"low\"), Difference(name: \"cut\", parts: [Sphere(name: \"high\", center: (0, 1, 0)), Sphere(name: \"hole\", center: (0, 2, 0))])]),
            Sphere(name: \"ghost\", center: (2.5, 0, 0), visible: false)])";
    for mode in [Mode::Baked, Mode::Live] {
        let whole = expect_compiled(outcome_of("a.ron", text, mode));
        let objects = |compiled: &Compiled| {
            let seen = identity(gpu, compiled, SIZE);
            let mut found: Vec<u32> = middles(SIZE).filter_map(|(x, y, _)| seen.object(x, y)).collect();
            found.sort_unstable();
            found.dedup();
            found
        };
        assert_eq!(objects(&whole), [0, 1, 2, 3, 4]);
        for (object, body) in
            [(0, &[0][..]), (1, &[1]), (2, &[2, 3, 4]), (4, &[2, 3, 4]), (5, &[5]), (6, &[])]
        {
            let alone = whole.isolated(object).unwrap_or_else(|e| panic!("{e:?}"));
            assert_eq!(objects(&alone), body, "{object}");
            assert_eq!((alone.source.target.mode, alone.scene.camera), (mode, whole.scene.camera));
            assert_eq!(alone.scene.primitives, whole.scene.primitives);
        }
        // Nothing shades the floor any more.
        let shadow = |compiled: &Compiled| view(gpu, compiled, View::Shadow).radiance;
        let dark = |compiled: &Compiled| shadow(compiled).iter().filter(|p| p[0] == 0.0).count();
        let floor = whole.isolated(0).unwrap_or_else(|e| panic!("{e:?}"));
        let sky = middles(SIZE).count() - count_met(gpu, &floor);
        assert_eq!(dark(&floor), sky, "only the sky has no light");
    }
}

fn count_met(gpu: &Gpu, compiled: &Compiled) -> usize {
    let seen = identity(gpu, compiled, SIZE);
    middles(SIZE).filter(|(x, y, _)| seen.at(*x, *y).is_some()).count()
}

#[test]
fn a_material_on_stage_is_the_scenes_own() {
    let Some(gpu) = device::gpu() else { return };
    let text = "(textures: { \"red\": Stripes(even: (1, 0, 0), odd: (1, 0, 0)) },
        materials: { \"a\": (color: (0, 0, 1)), \"b\": (color: \"red\", reflectivity: 0.2) },
        objects: [Sphere(material: \"a\"), Sphere(material: \"b\")])";
    for mode in [Mode::Baked, Mode::Live] {
        let whole = expect_compiled(outcome_of("a.ron", text, mode));
        for (material, color) in [("a", Vec3::Z), ("b", Vec3::X)] {
            let index = whole.scene.materials.iter().position(|m| m.name == material).expect("it is named");
            let stage = whole.on_stage(index).unwrap_or_else(|e| panic!("{e:?}"));
            assert_eq!(stage.source.target.mode, mode);
            let shown = view(gpu, &stage, View::Material);
            let seen = identity(gpu, &stage, SIZE);
            let mut objects = [0; 3];
            for (x, y, _) in middles(SIZE) {
                let Some(object) = seen.object(x, y) else { continue };
                objects[object as usize] += 1;
                let pixel = Vec3::from(shown.radiance[(y * SIZE[0] + x) as usize]);
                assert!(pixel.distance(color) < 1e-5, "{material}: {pixel} at {x}, {y}");
            }
            assert!(objects.iter().all(|count| *count > 200), "{objects:?}");
        }
    }
}
