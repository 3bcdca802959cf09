//! A sketch, which the processor draws by itself, is the picture that a driver draws.

use std::ops::ControlFlow;
use std::time::Duration;

use crate::common::{expect_compiled, expect_none, good_scenes, outcome, outcome_of};
use crate::device::gpu;
use raytoy::Compiled;
use raytoy::frame::{FrameUniforms, Moment, View};
use raytoy::gpu::{Renderer, SMALL};
use raytoy::sketch::{Sketch, canary};
use raytoy::wgsl::Mode;

const SIZE: [u32; 2] = [72, 48];
/// So long that no sketch is given up.
const FOR_EVER: Duration = Duration::from_secs(600);
/// Levels of 255: what the last digits of a driver's own functions may change.
const NEAR: f32 = 2.0 / 255.0;
/// The share of the pixels that have to be as near: those on an edge may fall on either side of it.
const MOST: f64 = 0.99;

/// Light and depth of each pixel.
fn sketched(compiled: &Compiled, moment: &Moment) -> Vec<[f32; 4]> {
    let sketch = Sketch::new(compiled).unwrap_or_else(|why| panic!("{}: {why}", compiled.scene.name));
    let scene = &compiled.scene;
    let frame = FrameUniforms::new(moment, &scene.render, scene.casters(), SIZE, 0, [0.0; 2]);
    sketch.draw(&frame, FOR_EVER).expect("there is time")
}

/// What is wrong with the sketch of `compiled`, next to what the driver draws, or what the driver is doubted over.
fn difference(compiled: &Compiled, moment: &Moment) -> Option<String> {
    let gpu = gpu()?;
    let sketch = sketched(compiled, moment);
    let mut renderer = Renderer::new(gpu, compiled, SIZE).expect("the driver takes it");
    let picture = renderer.draw(moment, 1, &mut |_| ControlFlow::Continue(())).expect("the driver draws it");
    let picture = picture.expect("nobody stops it");
    let sample = renderer.small(moment).expect("the driver draws it");
    let doubt = canary::doubt(compiled, moment, SMALL, &sample, FOR_EVER);
    let shown = |x: f32| x.clamp(0.0, 1.0).powf(1.0 / 2.2);
    let near = sketch.iter().zip(&picture.radiance).zip(&picture.depth).filter(|((pixel, light), depth)| {
        let is_light = (0..3).all(|c| (shown(pixel[c]) - shown(light[c])).abs() <= NEAR);
        let is_depth =
            if pixel[3] < 0.0 { depth.is_infinite() } else { (pixel[3] / *depth - 1.0).abs() < 1e-3 };
        is_light && is_depth
    });
    let share = near.count() as f64 / sketch.len() as f64;
    let name = &compiled.scene.name;
    (share < MOST || doubt.is_some()).then(|| {
        format!("{name}: {:.2} % of the pixels are as the driver has them; {doubt:?}", 100.0 * share)
    })
}

#[test]
fn it_is_what_a_driver_draws_of_the_gallery_and_of_all_cases() {
    expect_none(good_scenes().iter().filter_map(|name| {
        let compiled = expect_compiled(outcome(name, Mode::Baked));
        difference(&compiled, &Moment::of(&compiled.scene))
    }));
}

#[test]
fn it_takes_live_numbers_and_shows_debug_views() {
    let compiled = expect_compiled(outcome("scenes/table.ron", Mode::Live));
    expect_none(View::ALL.into_iter().filter_map(|(name, view)| {
        let moment = Moment { view, ..Moment::of(&compiled.scene) };
        difference(&compiled, &moment).map(|what| format!("{name}: {what}"))
    }));
}

#[test]
fn it_is_what_a_driver_draws_of_solids_of_100_parts() {
    expect_none(solids_of(100));
}

#[test]
#[ignore = "a driver takes minutes to compile them"]
fn it_is_what_a_driver_draws_of_solids_of_300_parts() {
    expect_none(solids_of(300));
}

/// Differences in solids of `count` balls, each with a material of its own: alone, cut out of a block, and in common.
fn solids_of(count: usize) -> impl Iterator<Item = String> {
    let color = |i: usize| [i % 5, i % 7, i % 11].map(|n| (0.1 + 0.08 * n as f64).to_string()).join(", ");
    let columns = (count as f64).sqrt().ceil();
    let step = 6.0 / columns;
    let ball = |i: usize| {
        let [x, y] = [i % columns as usize, i / columns as usize].map(|n| step * (n as f64 + 0.5) - 3.0);
        let radius = 0.58 * step;
        format!("Sphere(center: ({x}, {y}, 0.4), radius: {radius}, material: (color: ({})))", color(i))
    };
    let balls = (0..count).map(ball).collect::<Vec<_>>().join(", ");
    let block = "Box(min: (-3, -3, -1), max: (3.2, 3, 0.4))";
    let round = |i: usize| {
        let [x, y] = [(i as f64).sin(), (i as f64).cos()].map(|n| 0.8 * n);
        format!("Sphere(center: ({x}, {y}, 0), radius: 3, material: (color: ({})))", color(i))
    };
    let rounds = (0..count).map(round).collect::<Vec<_>>().join(", ");
    let solids = [
        ("union", format!("Union(parts: [{balls}])")),
        ("difference", format!("Difference(parts: [{block}, {balls}])")),
        ("intersection", format!("Intersection(parts: [{rounds}])")),
    ];
    solids.into_iter().filter_map(|(name, solid)| {
        let scene = format!(
            "(camera: (eye: (0, 0, 9), target: (0, 0, 0)), lights: [Directional(direction: (-1, -1, -2))], objects: [{solid}])"
        );
        let compiled = expect_compiled(outcome_of(name, &scene, Mode::Baked));
        difference(&compiled, &Moment::of(&compiled.scene))
    })
}

/// Snippets of a hundred cases, and whether Mesa's software driver loses count of their branches.
fn long_snippets() -> [(&'static str, String, bool); 6] {
    let case = |i: usize| format!("vec3f(fract(x * {i}.0), 0.3 + 0.3 * cos({i}.0 * y), 0.01 * {i}.0)");
    let cases =
        |line: &dyn Fn(usize, String) -> String| (0..100).map(|i| line(i, case(i))).collect::<String>();
    let start = "    var color = vec3f(0.0);\n";
    let end = "    return color;\n";
    [
        (
            "returns",
            cases(&|i, c| format!("    if k == {i} {{ return {c}; }}\n")) + "    return vec3f(1.0);\n",
            true,
        ),
        (
            "elseIfs",
            format!(
                "{start}    if k < 0 {{ color.x = 1.0; }}\n{}{end}",
                cases(&|i, c| format!("    else if k == {i} {{ color = {c}; }}\n"))
            ),
            true,
        ),
        (
            "nested",
            format!(
                "{start}{}{}\n{end}",
                // A hundred brackets in each other are refused.
                (0..96).map(|i| format!("    if k >= {i} {{ color = {};\n", case(i))).collect::<String>(),
                "}".repeat(96)
            ),
            true,
        ),
        (
            "caseReturns",
            format!(
                "    switch k {{\n{}    default: {{ return vec3f(1.0); }} }}\n",
                cases(&|i, c| format!("    case {i}: {{ return {c}; }}\n"))
            ),
            true,
        ),
        (
            "caseAssigns",
            format!(
                "{start}    switch k {{\n{}    default: {{}} }}\n{end}",
                cases(&|i, c| format!("    case {i}: {{ color = {c}; }}\n"))
            ),
            false,
        ),
        (
            "breaks",
            format!(
                "{start}    for (var i = 0; i < 3; i++) {{\n{}    }}\n{end}",
                cases(&|i, c| format!("    if k == {i} {{ color = {c}; break; }}\n"))
            ),
            false,
        ),
    ]
}

#[test]
fn a_driver_that_draws_wrong_is_found_out_and_the_line_is_named_before() {
    for (name, body, is_deep) in long_snippets() {
        let snippet = format!(
            "/// A test.\nfn {name}(at: Surface) -> vec3f {{\n    let x = 0.5 + 0.25 * at.position.x;\n    \
             let y = at.position.y;\n    let k = i32(100.0 * x);\n{body}}}\n"
        );
        let file = name.replace('R', "_r").replace('A', "_a").replace('I', "_i");
        let form = name[..1].to_uppercase() + &name[1..];
        let scene = format!(
            "(camera: (eye: (0, 0, 4), target: (0, 0, 0)), \
             objects: [Quad(corner: (-2, -2, 0), u: (4, 0, 0), v: (0, 4, 0), material: (color: 0, emission: {form}()))])"
        );
        let sources = raytoy::sources::Sources::in_memory()
            .with("long.ron", &scene)
            .with(format!("textures/{file}.wgsl"), &snippet);
        let outcome = raytoy::compile(&sources, "long.ron".as_ref(), Mode::Baked, None);
        let report = outcome.report.to_string();
        assert_eq!(report.contains("branches are nested"), is_deep, "{name}: {report}");
        assert_eq!(report.contains(&format!("textures/{file}.wgsl:10")), is_deep, "{name}: {report}");
        let compiled = expect_compiled(outcome);
        let Some(gpu) = gpu() else { continue };
        let moment = Moment::of(&compiled.scene);
        let renderer = Renderer::new(gpu, &compiled, SIZE).expect("the driver takes it");
        let drawn = renderer.small(&moment).expect("the driver draws it");
        let doubt = canary::doubt(&compiled, &moment, SMALL, &drawn, FOR_EVER);
        assert_eq!(doubt.is_some(), is_deep && gpu.is_software(), "{name}: {doubt:?}");
    }
}

/// Ways through a function that no snippet of raytoy's takes, or few: as the colors of a ball.
const WAYS: [&str; 8] = [
    // Lanes leave a loop at different steps, some of them by the function's end.
    "    var sum = 0.0;
    for (var i = 0; i < 20; i++) {
        if i % 3 == 1 { continue; }
        if f32(i) > 12.0 * abs(at.position.x) { break; }
        if at.position.y > 0.8 { return vec3f(0.2, 0.4, 0.9); }
        sum += 0.07;
    }
    return vec3f(sum, 0.5, 0.1);",
    // A loop in a loop, with what goes on at the end of each step.
    "    var steps = 0u;
    var x = 0u;
    loop {
        var y = 0u;
        loop {
            if y > x { break; }
            steps++;
            continuing {
                y++;
                break if f32(y) > 5.0 + 5.0 * at.position.y;
            }
        }
        x++;
        if x > 6u { break; }
    }
    return vec3f(f32(steps) / 40.0);",
    // Each lane another case; `break` leaves the switch, `continue` the loop's step.
    "    var color = vec3f(0.1);
    for (var i = 0u; i < 4u; i++) {
        switch (u32(8.0 + 8.0 * at.position.x) + i) % 7u {
            case 0u, 1u: { color.x += 0.2; }
            case 2u: { if at.position.z > 0.0 { break; } color.y += 0.3; }
            case 3u: { continue; }
            case 4u: { return vec3f(0.9, 0.1, 0.1); }
            default: { color.z += 0.1; }
        }
        color += 0.02;
    }
    return color;",
    // Places in arrays, vectors and matrices that only the lane knows.
    "    let first = vec3f(0.9, 0.2, 0.1);
    var table = array<vec3f, 5>(vec3f(0.1), first, vec3f(0.3), first.yxz, vec3f(0.6));
    let i = u32(2.4 + 2.4 * at.position.x);
    let j = u32(1.4 + 1.4 * at.position.y);
    table[i][1] = 0.5;
    table[4u - i] = table[4u - i].zxy * 0.8;
    let turned = mat3x3f(table[0], table[2], table[4]);
    var axis = vec3f(0.2);
    axis[j] = 0.7;
    return turned[j] * 0.4 + table[i] * axis + (turned * axis) * 0.2 + (axis * turned) * 0.1;",
    // Whole numbers, which wrap, shift and divide.
    "    let p = vec3i(floor(9.0 * at.position));
    let u = bitcast<u32>((p.x * 73856093) ^ (p.y * 19349663) ^ (p.z * -83492791));
    let shifted = (u >> 13u) ^ (u << 7u) ^ u32(p.x >> 1u);
    let parts = vec3u(shifted % 17u, countOneBits(u), reverseBits(u) >> 28u);
    let signed = vec3i(-p.x / 2, p.y % 3, abs(p.z)) - min(p, vec3i(1)) + max(p, -vec3i(2));
    return vec3f(parts) / vec3f(17.0, 32.0, 16.0) * 0.7 + vec3f(signed & vec3i(3)) * 0.1;",
    // Functions of numbers, at their corners, too.
    "    let x = 3.0 * at.position;
    let a = sin(x) * cos(x.yzx) + tan(0.3 * x) + exp(-abs(x)) - log(2.0 + abs(x)) + exp2(-x * x);
    let b = atan2(x, x.zxy + 4.0) + asin(0.3 * x) + acos(0.3 * x) + atan(x) + log2(5.0 + x) + sinh(0.2 * x);
    let c = inverseSqrt(4.0 + x) + round(x) + ceil(x) - floor(x) + fract(x) + sign(x) + step(x, x.yzx);
    let d = trunc(x) + mix(x, x.zyx, 0.3) + smoothstep(vec3f(-1.0), vec3f(2.0), x) + saturate(x) + x % 0.7;
    let e = cross(x, a) + reflect(b, normalize(c + 9.0)) + distance(c, d) + pow(abs(x) + 0.1, vec3f(1.7));
    let f = asinh(x) + atanh(0.3 * x) + acosh(1.1 + abs(x)) + faceForward(x, a, b) + radians(9.0 * x);
    let g = refract(normalize(x + 0.1), normalize(a + 0.2), 1.2) + degrees(0.01 * x);
    return abs(fract(0.11 * (a + b + c + d + e + f + g) + 0.013) * 2.0 - 1.0);",
    // What is all of many, or any.
    "    let x = at.position > vec3f(0.0, 0.3, -0.2);
    let both = vec3f(f32(all(x)), f32(any(x)), f32(x.x || (!x.y && x.z)));
    return 0.2 + 0.6 * select(both, vec3f(0.5), x) + 0.1 * vec3f(x) * f32(x.x != x.y);",
    // A function that changes what it is given.
    "    var place = at.position;
    way7TurnOnce(&place, 0.7);
    way7TurnOnce(&place, at.position.x);
    return abs(place);",
];

const TURN: &str = "fn way7TurnOnce(p: ptr<function, vec3f>, angle: f32) {
    if angle > 0.0 {
        let turn = mat2x2f(cos(angle), sin(angle), -sin(angle), cos(angle));
        *p = vec3f(turn * (*p).xy, (*p).z);
        return;
    }
    (*p).z = -(*p).z;
}
";

#[test]
fn it_goes_every_way_that_wgsl_has() {
    let deep = format!(
        "{}return at.position;{}\nreturn vec3f(0.1);",
        "if at.uv.x < 9.0 { ".repeat(97),
        "}".repeat(97)
    );
    for (i, way) in WAYS.into_iter().chain([deep.as_str()]).enumerate() {
        let helper = if way.contains("TurnOnce") { TURN } else { "" };
        let snippet = format!("/// A test.\nfn way{i}(at: Surface) -> vec3f {{\n{way}\n}}\n\n{helper}");
        let scene = format!("(objects: [Sphere(radius: 1, material: (color: 0, emission: Way{i}()))])");
        let sources = raytoy::sources::Sources::in_memory()
            .with("way.ron", &scene)
            .with(format!("textures/way{i}.wgsl"), &snippet);
        let compiled = expect_compiled(raytoy::compile(&sources, "way.ron".as_ref(), Mode::Live, None));
        expect_none(difference(&compiled, &Moment::of(&compiled.scene)));
    }
}

#[test]
fn one_that_takes_too_long_is_given_up() {
    let compiled = expect_compiled(outcome_of("ball.ron", "(objects: [Sphere()])", Mode::Baked));
    let moment = Moment::of(&compiled.scene);
    let frame = FrameUniforms::new(&moment, &compiled.scene.render, 1, SIZE, 0, [0.0; 2]);
    let sketch = Sketch::new(&compiled).expect("raytoy's own files can be drawn");
    assert!(sketch.draw(&frame, Duration::ZERO).is_err());
    assert!(sketch.draw(&frame, FOR_EVER).is_ok());
}

#[test]
fn an_endless_loop_of_the_authors_ends_with_the_time() {
    let snippet = "/// A test.\nfn endless(at: Surface) -> vec3f {\n    var x = at.position.x;\n    \
                   while x < 9.0 { x *= 0.5; }\n    return vec3f(x);\n}\n";
    let sources = raytoy::sources::Sources::in_memory()
        .with("endless.ron", "(objects: [Sphere(material: (color: Endless()))])")
        .with("textures/endless.wgsl", snippet);
    let compiled = expect_compiled(raytoy::compile(&sources, "endless.ron".as_ref(), Mode::Baked, None));
    let frame =
        FrameUniforms::new(&Moment::of(&compiled.scene), &compiled.scene.render, 1, SIZE, 0, [0.0; 2]);
    let sketch = Sketch::new(&compiled).expect("a loop can be drawn");
    assert!(sketch.draw(&frame, Duration::from_millis(50)).is_err());
}
