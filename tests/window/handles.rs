//! The handles of the window as pure maths: the hand's way on the screen is the thing's way in the world, and what
//! moves is what a person would have changed.

use crate::common::{expect_compiled, expect_none, outcome_of, root};
use crate::device::gpu;
use glam::{Vec2, Vec3, vec2, vec3};
use raytoy::edit::{Edit, NewValue};
use raytoy::frame::{Lens, Moment};
use raytoy::gpu::{Probe, Ray};
use raytoy::ir::Camera;
use raytoy::laws::Random;
use raytoy::library::{Family, Library, sample};
use raytoy::outline::{Outline, outline};
use raytoy::panel::handles::{Ball, Direction, Handle, Known, Movable, Place, Tripod, movables};
use raytoy::scene::{Path, parse};
use raytoy::sources::Sources;
use raytoy::wgsl::Mode;

const SIZE: [u32; 2] = [900, 700];

fn lens(eye: Vec3, target: Vec3, fov_deg: f32) -> Lens {
    Lens::new(&Camera { eye, target, up: Vec3::Y, fov: fov_deg.to_radians() }, SIZE)
}

/// A camera somewhere, and a place somewhere in its picture.
fn seen(random: &mut Random) -> Tripod {
    let target = 5.0 * random.vector();
    let eye = target + (1.0 + 20.0 * random.unit()) * random.direction();
    let lens = lens(eye, target, 20.0 + 60.0 * random.unit());
    let pixel = lens.size * vec2(random.unit(), random.unit());
    let place = lens.eye + (1.0 + 20.0 * random.unit()) * lens.direction(pixel);
    Tripod::new(lens, place, 1.0).expect("it lies before the eye")
}

/// Whether an axis is seen so much from the side that its points can be told apart.
fn lies_across(tripod: &Tripod, axis: Vec3) -> bool {
    (tripod.place - tripod.lens.eye).normalize().cross(axis).length() > 0.3
}

#[test]
fn what_is_projected_and_taken_back_is_the_same_point() {
    let mut random = Random(1);
    for _ in 0..2000 {
        let tripod = seen(&mut random);
        let Tripod { lens, place, .. } = tripod;
        let far = place.distance(lens.eye);
        let back = lens.eye + far * lens.direction(lens.pixel(place));
        assert!(back.distance(place) < 1e-4 * far, "{back} {place}");
        // In the plane that faces the camera, and on each axis.
        let beside = place + 0.2 * far * (random.unit() * lens.right + random.unit() * lens.up);
        let found = tripod.point(Handle::Plane, lens.pixel(beside)).expect("it is before the eye");
        assert!(found.distance(beside) < 1e-4 * far, "{found} {beside}");
        for handle in Handle::AXES {
            let axis = handle.axis().expect("it has one");
            let there = place + 0.2 * far * (2.0 * random.unit() - 1.0) * axis;
            if lies_across(&tripod, axis) && lens.depth(there) > 0.1 * far {
                let found = tripod.point(handle, lens.pixel(there)).expect("it is before the eye");
                assert!(found.distance(there) < 1e-3 * far, "{found} {there}");
            }
        }
    }
}

#[test]
fn a_handle_dragged_by_one_unit_on_the_screen_moves_one_unit() {
    let mut random = Random(2);
    let mut asked = 0;
    for _ in 0..2000 {
        let tripod = seen(&mut random);
        let Tripod { lens, place, .. } = tripod;
        for handle in Handle::AXES {
            let axis = handle.axis().expect("it has one");
            if !lies_across(&tripod, axis) || lens.depth(place + axis) < 0.5 {
                continue;
            }
            asked += 1;
            let to = tripod.point(handle, lens.pixel(place + axis)).expect("it is before the eye");
            let by = to - tripod.point(handle, tripod.middle()).expect("it is before the eye");
            assert!(by.distance(axis) < 2e-3, "{handle:?} {by}");
        }
    }
    assert!(asked > 1000, "{asked}");
}

#[test]
fn an_axis_ends_at_its_horizon() {
    // The z axis runs away from the eye over a floor, whose horizon is at half the picture's height.
    let lens = lens(vec3(0.0, 1.0, 5.0), vec3(0.0, 1.0, 0.0), 40.0);
    let tripod = Tripod::new(lens, vec3(0.0, 0.0, 0.0), 1.0).expect("it lies before the eye");
    let at = |y: f32| tripod.point(Handle::Z, vec2(450.0, y));
    let depths: Vec<f32> = [500.0, 450.0, 400.0, 380.0].map(|y| at(y).expect("it is below").z).to_vec();
    assert!(depths.is_sorted_by(|a, b| a > b), "{depths:?}");
    for beyond in [350.0, 340.0, 100.0] {
        assert_eq!(at(beyond), None);
    }
    // Behind the eye nothing has handles.
    assert!(Tripod::new(lens, vec3(0.0, 0.0, 6.0), 1.0).is_none());
}

#[test]
fn handles_are_as_long_from_everywhere_and_the_pointer_takes_what_it_is_on() {
    let mut random = Random(3);
    for _ in 0..500 {
        let tripod = seen(&mut random);
        let middle = tripod.middle();
        assert_eq!(tripod.under(middle), Some(Handle::Plane));
        assert_eq!(tripod.under(middle + vec2(300.0, 300.0)), None);
        for handle in Handle::AXES {
            let Some(tip) = tripod.tip(handle) else { continue };
            let others = Handle::AXES.into_iter().filter(|other| *other != handle);
            let is_alone = |other: Handle| tripod.tip(other).is_none_or(|t| t.distance(tip) > 30.0);
            if others.into_iter().all(is_alone) && tip.distance(middle) > 40.0 {
                assert_eq!(tripod.under(tip), Some(handle));
            }
        }
    }
    for distance in [0.01, 1.0, 1000.0] {
        let lens = lens(vec3(0.0, 0.0, distance), Vec3::ZERO, 40.0);
        let tripod = |scale| Tripod::new(lens, Vec3::ZERO, scale).expect("it lies before the eye");
        let long =
            |scale: f32, handle| tripod(scale).tip(handle).map(|tip| tip.distance(tripod(scale).middle()));
        let one = long(1.0, Handle::X).expect("it lies across the view");
        assert!((one - 84.0).abs() < 0.1, "{one}");
        assert!(long(2.0, Handle::Y).is_some_and(|two| (two - 168.0).abs() < 0.1));
        assert_eq!(long(1.0, Handle::Z), None, "it points at the eye");
    }
}

#[test]
fn a_knob_goes_where_the_hand_goes_and_over_the_rim_to_the_other_half() {
    let mut random = Random(4);
    let ball = Ball { lens: lens(vec3(3.0, 2.0, 5.0), Vec3::ZERO, 40.0), scale: 1.0 };
    for _ in 0..500 {
        let [from, to] = [random.direction(), random.direction()];
        if ball.is_behind(from) == ball.is_behind(to) {
            let turned = ball.turned(from, ball.knob(to) - ball.knob(from));
            assert!(turned.distance(to) < 1e-2, "{turned} {to}");
        }
        assert!(ball.turned(from, Vec2::ZERO).distance(from) < 1e-3);
        // As far past the rim as it was before it.
        let out = (ball.knob(from) - ball.middle()).normalize();
        let past = 2.0 * (ball.radius() - ball.knob(from).distance(ball.middle()));
        let turned = ball.turned(from, past * out);
        assert!(past < 1.0 || ball.is_behind(turned) != ball.is_behind(from));
        assert!(ball.knob(turned).distance(ball.knob(from)) < 0.1);
    }
}

fn outline_of(text: &str) -> Outline {
    let sources = Sources::on_disk(&root());
    let library = Library::new(&sources, &root());
    let value = parse("scene.ron", text).unwrap_or_else(|problems| panic!("{problems:?}\n{text}"));
    outline(&value, text, &library)
}

fn known(text: &str, path: &Path) -> Vec<Movable> {
    movables(&outline_of(text), path, &Known { numbers: &|_| None, middle: &|_| None })
}

/// What of the things at `path` has a place.
fn places(text: &str, path: &Path) -> Vec<Place> {
    let places = known(text, path).into_iter().filter_map(|movable| match movable {
        Movable::Place(place) => Some(place),
        Movable::Direction(_) => None,
    });
    places.collect()
}

/// `text` with the place where it has moved to.
fn written(text: &str, place: &Place) -> String {
    place.points.iter().fold(text.to_owned(), |text, (path, value)| {
        let edit = Edit::Set { path: path.clone(), value: NewValue::Vector(value.to_array().to_vec()) };
        edit.on(&text).unwrap_or_else(|refusal| panic!("{refusal}\n{text}")).apply(&text)
    })
}

fn objects() -> Path {
    Path::default().field("objects")
}

/// A step, and how it looks in the text of one object.
#[test]
fn what_moves_is_what_a_person_would_have_changed() {
    let step = vec3(1.0, 0.0, -0.5);
    let cases = [
        ("Sphere(center: (0.5, 1, 2))", "Sphere(center: (1.5, 1, 1.5))"),
        ("Sphere(radius: 2)", "Sphere(radius: 2, center: (1, 0, -0.5))"),
        ("Box(min: (0, 0, 0), max: (1, 1.25, 1))", "Box(min: (1, 0, -0.5), max: (2, 1.25, 0.5))"),
        ("Cone(top: (0, 3, 0))", "Cone(top: (1, 3, -0.5), base: (1, 0, -0.5))"),
        (
            "Triangle(a: (0, 0, 0), b: (1, 0, 0), c: (0, 1, 0))",
            "Triangle(a: (1, 0, -0.5), b: (2, 0, -0.5), c: (1, 1, -0.5))",
        ),
        ("Plane()", "Plane(translate: (1, 0, -0.5))"),
        ("Heightfield(height: 0.5)", "Heightfield(height: 0.5, translate: (1, 0, -0.5))"),
        // Where the author moves or turns it already, by what the author moves it.
        (
            "Sphere(center: (3, 0, 0), translate: (0, 1, 0))",
            "Sphere(center: (3, 0, 0), translate: (1, 1, -0.5))",
        ),
        ("Box(rotate_deg: (0, 30, 0))", "Box(rotate_deg: (0, 30, 0), translate: (1, 0, -0.5))"),
        // A texture is no place.
        (
            "SmoothBalls(a: Noise(), b: (1, 0, 0))",
            "SmoothBalls(a: Noise(), b: (1, 0, 0), translate: (1, 0, -0.5))",
        ),
        ("Union(parts: [Box(), Sphere()])", "Union(parts: [Box(), Sphere()], translate: (1, 0, -0.5))"),
    ];
    for (before, after) in cases {
        let scene = |object: &str| format!("(objects: [{object}])");
        let places = places(&scene(before), &objects().item(0));
        assert_eq!(places.len(), 1, "{before}");
        assert_eq!(written(&scene(before), &places[0].moved(step, 3)), scene(after));
    }
}

#[test]
fn parts_move_in_the_space_of_their_solid() {
    let text = "(objects: [Union(translate: (9, 0, 0), rotate_deg: (0, 90, 0), scale: 2, parts: [
        Difference(parts: [Sphere(center: (1, 0, 0)), Box()]),
    ])])";
    let path = objects().item(0).field("parts").item(0).field("parts").item(0);
    let place = &places(text, &path)[0];
    // Twice as large, x is turned to -z.
    assert!(place.at.distance(vec3(9.0, 0.0, -2.0)) < 1e-5, "{}", place.at);
    let moved = place.moved(vec3(0.0, 0.0, -1.0), 3);
    assert_eq!(written(text, &moved), text.replace("center: (1, 0, 0)", "center: (1.5, 0, 0)"));
    assert!(moved.at.distance(vec3(9.0, 0.0, -3.0)) < 1e-5);
    // A whole stands where its parts do, on average.
    let whole =
        &places("(objects: [Union(parts: [Sphere(center: (4, 0, 0)), Sphere()])])", &objects().item(0))[0];
    assert_eq!(whole.at, vec3(2.0, 0.0, 0.0));
    let cut = "(objects: [Difference(parts: [Sphere(center: (4, 0, 0)), Sphere()])])";
    assert_eq!(places(cut, &objects().item(0))[0].at, vec3(4.0, 0.0, 0.0));
}

#[test]
fn lights_have_their_own_handles() {
    let text = "(lights: [
        Point(position: (4, 6, 3)), Spot(position: (0, 5, 0), target: (1, 0, 0)),
        Rect(corner: (-1, 5, -1), u: (2, 0, 0), v: (0, 0, 2)), Directional(direction: (0, -2, 0)),
    ], objects: [Sphere()])";
    let light = |i: usize| Path::default().field("lights").item(i);
    let of = |i: usize| places(text, &light(i)).into_iter().map(|p| (p.name, p.at)).collect::<Vec<_>>();
    assert_eq!(of(0), [("position".to_owned(), vec3(4.0, 6.0, 3.0))]);
    let spot = [("position".to_owned(), vec3(0.0, 5.0, 0.0)), ("target".to_owned(), vec3(1.0, 0.0, 0.0))];
    assert_eq!(of(1), spot);
    assert_eq!(of(2), [("corner".to_owned(), vec3(0.0, 5.0, 0.0))], "in the middle of the rectangle");
    assert_eq!(of(3), []);
    let Movable::Direction(direction) = &known(text, &light(3))[0] else { panic!("it has a direction") };
    assert_eq!(direction.value, vec3(0.0, -2.0, 0.0));
    // Cameras, materials and lists have none.
    for path in ["camera", "lights", "objects", "render"] {
        assert_eq!(known(text, &Path::default().field(path)), []);
    }
}

#[test]
fn numbers_have_as_many_digits_as_a_pixel_is_worth() {
    let text = "(objects: [Box(min: (0.123456, 0.7, 0), max: (1.5, 1.7, 1))])";
    let place = &places(text, &objects().item(0))[0];
    assert_eq!([0.03, 0.009, 1.0, 25.0].map(|pixel| place.digits(pixel)), [2, 3, 0, -1]);
    let moved = written(text, &place.moved(vec3(0.33333, 0.0, 0.0), 2));
    // The first lands on a round number, the others follow; what does not move stays as it is written.
    assert_eq!(moved, "(objects: [Box(min: (0.46, 0.7, 0), max: (1.83654, 1.7, 1))])");
    let snapped = written(text, &place.moved(vec3(0.0, 0.33333, 0.0), 1));
    assert_eq!(snapped, text.replace("0.7, 0)", "1.0, 0)").replace("1.7, 1)", "2.0, 1)"));
    let direction = Direction { path: Path::default(), value: vec3(0.0, -3.0, 0.0) };
    assert_eq!(direction.digits(), 2);
    let turned = direction.turned(vec3(0.6, -0.8, 0.0), 2).expect("it has a length");
    assert_eq!(turned.value, vec3(1.8, -2.4, 0.0));
    let short = Direction { value: vec3(0.0, -0.01, 0.0), ..direction };
    assert_eq!(short.turned(Vec3::X, 1), None, "steps of 0.1 would leave nothing of it");
}

#[test]
fn each_shape_moves_by_as_much_as_it_is_told() {
    let sources = Sources::on_disk(&root());
    let library = Library::new(&sources, &root());
    let mut random = Random(6);
    for name in library.names(Family::Shape) {
        let call = sample::shape(&library.find(Family::Shape, &name).expect("it is there"));
        for (before, after) in
            [("", ""), ("Union(rotate_deg: (20, 30, 40), scale: (1, 2, -3), parts: [", "])")]
        {
            let text = format!("(objects: [{before}{call}{after}])");
            let part = objects().item(0).field("parts").item(0);
            let path = if before.is_empty() { objects().item(0) } else { part };
            let place = &places(&text, &path)[0];
            let by = 3.0 * random.vector();
            let moved = place.moved(by, 5);
            let again = &places(&written(&text, &moved), &path)[0];
            assert!(again.at.distance(place.at + by) < 1e-4, "{name}: {} {}", again.at, place.at + by);
            assert!(again.at.distance(moved.at) < 1e-4, "{name}");
        }
    }
}

/// What rays cross of a shape that has moved is what they crossed before, as far away: so the doc lines of the
/// shapes name their points rightly, and all of them.
#[test]
fn a_moved_shape_looks_as_it_did_from_where_it_was() {
    let Some(gpu) = gpu() else { return };
    let sources = Sources::in_memory();
    let library = Library::new(&sources, "".as_ref());
    let by = vec3(0.75, -1.5, 2.25);
    let met = |text: &str, step: Vec3| {
        let compiled = expect_compiled(outcome_of("scene.ron", text, Mode::Live));
        let moment = Moment::of(&compiled.scene);
        let probe = Probe::build(gpu, &compiled, &moment, SIZE).expect("the device takes it");
        let mut random = Random(8);
        let rays: Vec<Ray> = (0..400)
            .map(|_| {
                let (from, to) = (10.0 * random.direction(), random.vector());
                Ray { origin: from + step, t_min: 0.0, direction: (to - from).normalize(), t_max: 1e30 }
            })
            .collect();
        let met = probe.rays(&rays).expect("the device answers");
        met.into_iter().map(|hit| hit.map(|hit| hit.t)).collect::<Vec<_>>()
    };
    expect_none(library.names(Family::Shape).into_iter().filter_map(|name| {
        let function = library.find(Family::Shape, &name).expect("it is there");
        if !function.parameters.iter().any(|parameter| parameter.is_point) {
            return None;
        }
        let text = format!("(objects: [{}])", sample::shape(&function));
        let place = &places(&text, &objects().item(0))[0];
        let (before, after) = (met(&text, Vec3::ZERO), met(&written(&text, &place.moved(by, 2)), by));
        let differ = |(a, b): &(&Option<f32>, &Option<f32>)| match (a, b) {
            (Some(a), Some(b)) => (a - b).abs() > 0.01,
            (a, b) => a.is_some() != b.is_some(),
        };
        let wrong = before.iter().zip(&after).filter(differ).count();
        let hits = before.iter().flatten().count();
        // A ray that grazes may miss; a marched fractal lets some more through.
        (wrong > 20 || hits < 40).then(|| format!("{name}: {hits} hits, {wrong} of them elsewhere"))
    }));
}
