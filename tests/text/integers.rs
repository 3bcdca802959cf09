//! Whole numbers in a Shadertoy are WGSL's: of negative numbers, by zero, beyond the bits, of large numbers.

use crate::common::expect_compiled;
use raytoy::Compiled;
use raytoy::export::{Language, export};
use raytoy::frame::{FrameUniforms, Moment};
use raytoy::sketch::Sketch;
use raytoy::sources::Sources;
use raytoy::wgsl::Mode;
use std::time::Duration;

const INTEGERS: &str = include_str!("../../shaders/integers.wgsl");
const VECTORS: &str = include_str!("../../shaders/integer_vectors.wgsl");

fn scene_with(texture: &str) -> Compiled {
    let sources = Sources::in_memory()
        .with(
            "a.ron",
            "(objects: [Sphere(radius: 1000, center: (0, 0, 0), material: (color: 0, emission: Wave()))])",
        )
        .with("textures/wave.wgsl", texture);
    expect_compiled(raytoy::compile(&sources, "a.ron".as_ref(), Mode::Baked, None))
}

/// The functions of an author's that the Shadertoy has for `body`.
fn shadertoy(body: &str) -> String {
    let compiled = scene_with(&format!("/// A wave.\nfn wave(at: Surface) -> f32 {{\n{body}\n}}\n"));
    let text =
        String::from_utf8(export(&compiled, Language::Glsl).expect("it stands alone").shader).expect("text");
    let from = text.find("float wave(").expect("it has the texture");
    let length = text[from..].find("\n}\n").expect("it ends");
    text[from..from + length].to_owned()
}

#[test]
fn what_glsl_leaves_open_is_a_function_there() {
    let text = "let i = i32(floor(at.uv.x)); let j = i32(at.uv.y); ";
    for (body, call) in [
        ("return f32(i);", "wholeI32_(floor(at"),
        ("return f32(vec3u(at.position).z);", "wholeVec3u(at"),
        ("return f32(i % 3);", "remainderI32_("),
        ("return f32((vec2i(i, j) % 3).x);", "remainderVec2i("),
        ("return f32(u32(i) % u32(j));", "remainderU32_("),
        ("var k = i; k %= j; return f32(k);", "remainderI32_("),
        ("return f32(i / j);", "quotientI32_("),
        ("return f32(i / -1);", "quotientI32_("),
        ("return f32((vec4u(u32(i)) / vec4u(u32(j))).w);", "quotientVec4u("),
        ("return f32(i << u32(j));", "shiftLeftI32_("),
        ("return f32((vec2i(i) >> vec2u(u32(j))).x);", "shiftRightVec2i("),
        ("var k = 0; loop { k++; continuing { break if k % j == 2; } } return f32(k);", "remainderI32_("),
        ("switch i { case 1: { return f32(j % i); } default: { return 0.0; } }", "remainderI32_("),
        ("if at.uv.x > 0.5 && i % j == 1 { return 1.0; } return 0.0;", "remainderI32_("),
    ] {
        let written = shadertoy(&format!("{text}{body}"));
        assert!(written.contains(call), "{body}: {written}");
        assert!(
            ![" % ", " << ", " >> "].iter().any(|operator| written.contains(operator)),
            "{body}: {written}"
        );
    }
    // These are the same in both.
    for (body, plain) in [
        ("return f32(u32(i) % 7u);", "% 7u"),
        ("return f32(i / 2);", "/ 2)"),
        ("return f32((vec2u(u32(i)) >> vec2u(31u)).x);", ">> uvec2(31u)"),
        ("return at.uv.x % 0.5;", "trunc("),
    ] {
        let written = shadertoy(&format!("{text}{body}"));
        assert!(written.contains(plain), "{body}: {written}");
    }
}

/// Numbers and what Rust makes of them, asked of the functions as a processor runs them.
#[test]
fn those_functions_give_what_wgsl_defines() {
    const SOME: [i32; 9] = [0, 1, -1, 2, -7, 33, 1_000_003, i32::MAX, i32::MIN];
    const LARGE: [f32; 10] = [0.0, 0.75, -0.75, -3.5, 2e9, -2e9, 3e9, -3e9, 1e30, -1e30];
    let mut lines = String::new();
    let mut expect = |call: String, result: String| {
        lines += &format!("    wrong += u32({call} != {result});\n");
    };
    let int = |i: i32| format!("waveInt({}u)", i as u32);
    let uint = |i: i32| format!("waveUint({}u)", i as u32);
    for a in SOME {
        for b in SOME {
            let (of, by) = (a as u32, b as u32);
            let quotient = if b == 0 { a } else { a.wrapping_div(b) };
            let remainder = if b == 0 { 0 } else { a.wrapping_rem(b) };
            let [left, right] = [a.wrapping_shl(by), a.wrapping_shr(by)];
            for (stem, result) in [("quotient", quotient), ("remainder", remainder)] {
                expect(format!("{stem}I32({}, {})", int(a), int(b)), int(result));
                let [c, d, r] = [int(a), int(b), int(result)];
                expect(format!("{stem}Vec3i(vec3i(1, {c}, 9), vec3i(2, {d}, 5)).y"), r);
            }
            for (stem, result) in [("shiftLeft", left), ("shiftRight", right)] {
                expect(format!("{stem}I32({}, {})", int(a), uint(b)), int(result));
                expect(format!("{stem}Vec2i(vec2i({}), vec2u({})).y", int(a), uint(b)), int(result));
            }
            for (stem, result) in [
                ("quotient", of.checked_div(by).unwrap_or(of)),
                ("remainder", of.checked_rem(by).unwrap_or(0)),
                ("shiftLeft", of.wrapping_shl(by)),
                ("shiftRight", of.wrapping_shr(by)),
            ] {
                let (of, by, result) = (uint(a), uint(b), uint(result as i32));
                expect(format!("{stem}U32({of}, {by})"), result.clone());
                expect(format!("{stem}Vec4u(vec4u({of}), vec4u({by})).w"), result);
            }
        }
    }
    for x in LARGE {
        // The largest that there is of f32.
        let (whole, natural) = ((x as i32).min(2_147_483_520), (x as u32).min(4_294_967_040));
        expect(format!("wholeI32(waveFloat({x:?}))"), int(whole));
        expect(format!("wholeVec2u(vec2f(1.0, waveFloat({x:?}))).y"), uint(natural as i32));
    }
    assert_eq!(wrong(&lines), 0.0);
    assert_eq!(wrong("    wrong += u32(remainderI32(waveInt(7u), 4) != 2);\n"), 1.0, "a mistake is seen");
}

/// How often `lines` count something wrong, by a sketch.
fn wrong(lines: &str) -> f32 {
    let body = format!(
        "/// A wave.\nfn wave(at: Surface) -> f32 {{\n    var wrong = 0u;\n{lines}    return f32(wrong);\n}}\n"
    );
    // Their names are raytoy's.
    let stems = ["quotient", "remainder", "shiftLeft", "shiftRight", "whole"];
    let text = stems.iter().fold(format!("{body}{INTEGERS}\n{VECTORS}"), |text, stem| {
        text.replace(stem, &format!("wave{}{}", stem[..1].to_uppercase(), &stem[1..]))
    });
    // naga would fold literals.
    let hidden = "fn waveInt(x: u32) -> i32 { return bitcast<i32>(x); }\n\
                  fn waveUint(x: u32) -> u32 { return x; }\n\
                  fn waveFloat(x: f32) -> f32 { return x; }\n";
    let compiled = scene_with(&format!("{text}{hidden}"));
    let sketch = Sketch::new(&compiled).expect("a processor can draw it");
    let scene = &compiled.scene;
    let frame = FrameUniforms::new(&Moment::of(scene), &scene.render, scene.casters(), [8, 8], 0, [0.0; 2]);
    let pixels = sketch.draw(&frame, Duration::from_secs(600)).expect("there is time");
    pixels[27][0]
}
