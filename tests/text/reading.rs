//! Texts as other programs and other languages write them: numbers, byte-order marks, line ends.

use crate::common::{expect_none, outcome_of};
use raytoy::scene::{Kind, parse};
use raytoy::sources::Sources;
use raytoy::wgsl::Mode;

#[test]
fn numbers_are_those_of_the_ron_crate() {
    let good = "1. .5 +1 -.5 +.5 1.e3 1.E-3 .5e2 -1.e+2 1e3 1E+3 0 00 01 -0 1.0 1.50 1_000 1_ 1_000.000_5 1e1_0 \
                0xff 0xFF -0x1f +0b101 0o17 0xff_ff 1.5f32 .5f32 1.f64 7u8 -7i32 0x1fu8 123456789012345678901234567890 \
                1e-400 0.1 .1";
    let bad =
        "1..5 ..5 . +. -. 1.. 1.5.2 1e .e3 1.e +-1 --1 1._5 1.5f16 7u9 0xg 0b2 0o8 0x 1e+ inf -inf NaN 1e999";
    let ours = |word: &str| match parse("a.ron", word).ok()?.kind {
        Kind::Number(x) => Some(x),
        _ => None,
    };
    expect_none(good.split_whitespace().filter_map(|word| {
        let theirs = match ron::from_str::<ron::Value>(word) {
            Ok(ron::Value::Number(number)) => number.into_f64(),
            other => return Some(format!("{word}: ron has {other:?}")),
        };
        let is_same = ours(word).is_some_and(|x| x == theirs || x as f32 == theirs as f32);
        (!is_same).then(|| format!("{word}: {:?}, and ron has {theirs}", ours(word)))
    }));
    expect_none(bad.split_whitespace().filter_map(|word| ours(word).map(|x| format!("{word} is {x}"))));
}

#[test]
fn what_only_looks_like_a_number_stays_as_it_is() {
    let text = "(name: \"1. .5 \\\" .5\", tail: r#\"a.\" 1.\"#, /* .5 */ e1: 2., // 1.\n list: [1.,.5,-.5])";
    let root = parse("a.ron", text).expect("it is RON");
    let Kind::Record(record) = root.kind else { panic!("it has fields") };
    let field = |name: &str| &record.fields.iter().find(|f| f.name.text == name).expect("it is there").value;
    assert_eq!(field("name").kind, Kind::Text("1. .5 \" .5".into()));
    assert_eq!(field("tail").kind, Kind::Text("a.\" 1.".into()));
    assert_eq!(field("e1").kind, Kind::Number(2.0));
    assert_eq!(&text[field("e1").span.clone()], "2.");
    let Kind::List(items) = &field("list").kind else { panic!("it is a list") };
    assert_eq!(items.iter().map(|item| &text[item.span.clone()]).collect::<Vec<_>>(), ["1.", ".5", "-.5"]);
}

#[test]
fn a_byte_order_mark_is_no_column() {
    for line_end in ["\n", "\r\n"] {
        let text = ["(objects: [Sphere(radius: 2)],", "lights: [Nope()])"].join(line_end);
        let plain = outcome_of("a.ron", &text, Mode::Baked).report.to_string();
        let marked = outcome_of("a.ron", &format!("\u{feff}{text}"), Mode::Baked).report.to_string();
        assert_eq!(plain, marked);
        assert!(plain.contains("a.ron:2:10"), "{plain}");
        let first = outcome_of("a.ron", "\u{feff}(objects: [Nope()])", Mode::Baked);
        assert!(first.report.to_string().contains("a.ron:1:12"), "{}", first.report);
    }
}

#[test]
fn utf_16_is_called_by_its_name() {
    let folder = tempfile::tempdir().expect("a temporary folder");
    let write = |name: &str, text: &str| {
        let bytes = std::iter::once(0xfeff).chain(text.encode_utf16()).flat_map(u16::to_le_bytes);
        std::fs::write(folder.path().join(name), bytes.collect::<Vec<u8>>()).expect("it can be written");
    };
    write("wide.ron", "(objects: [Sphere()])");
    std::fs::create_dir(folder.path().join("textures")).expect("it is new");
    write("textures/wide.wgsl", "/// Wide.\nfn wide(at: Surface) -> f32 { return 1.0; }\n");
    let scene = "(objects: [Sphere(material: (color: Wide()))])";
    std::fs::write(folder.path().join("narrow.ron"), scene).expect("it can be written");
    for (scene, wide) in [("wide.ron", "wide.ron"), ("narrow.ron", "textures/wide.wgsl")] {
        let sources = Sources::on_disk(folder.path());
        let told =
            raytoy::compile(&sources, &folder.path().join(scene), Mode::Baked, None).report.to_string();
        let expected = format!("cannot read `{wide}`: it is UTF-16 text");
        assert!(told.contains(&expected) && told.contains("help: save it as UTF-8"), "{told}");
    }
}

/// What is said of a texture, which a scene calls by `name`, in `file`.
fn told_of(file: &str, name: &str, texture: &str) -> String {
    let scene = format!("(objects: [Sphere(material: (color: {name}()))])");
    let sources = Sources::in_memory().with("a.ron", &scene).with(format!("textures/{file}"), texture);
    let outcome = raytoy::compile(&sources, "a.ron".as_ref(), Mode::Baked, None);
    assert_ne!(outcome.compiled.is_some(), outcome.report.has_errors());
    outcome.report.to_string()
}

#[test]
fn a_signature_is_read_as_wgsl_reads_it() {
    let right = [
        "/// Dune.\n///\n/// tilt = 1: a\nfn dune(\n  at: Surface, // (where: always, first\n  /* no, */ tilt: f32,\n) -> f32 { return tilt; }",
        "/*\n/// Old.\nfn dune(at: Surface, old: f32) -> f32 { return old; }\n/* inner */\n*/\n\n/// Dune.\nfn dune(at: Surface) -> f32 { return 1.0; }",
        "// fn dune(old: f32) -> f32 { return old; }\n/// Dune.\nfn dune(at: Surface) -> f32 { return 1.0; }",
        "/// Dune.\n@must_use\nfn dune(at: Surface) -> f32 { return 1.0; }",
        "/// Dune.\n@must_use fn dune (at : Surface) -> vec3<f32>\n{\n return vec3f(1.0); }",
        "/// Dune.\r\n///\r\n/// tilt = 1: a\r\nfn dune(at: Surface, tilt: f32) -> f32\r\n{\r\n  return tilt;\r\n}\r\n",
        "/// Dune.\r///\r/// tilt = 1: a\rfn dune(at: Surface, tilt: f32) -> f32 { return tilt; }\r",
        "\u{feff}/// Dune.\n///\n/// tilt = 1: a\nfn dune(at: Surface, tilt: f32) -> f32 { return tilt; }",
        "\u{feff}fn dune(at: Surface) -> f32 { return 1.0; }",
        "  /// Dune.\n  ///\n  /// tilt = 1: a\n  // note\n  fn /* of sand */ dune(at: Surface, tilt: f32,) -> /* how */ f32 { return tilt; }",
        "alias dunePair = vec2<f32>; struct DunePoint { p: dunePair, } const DUNES = 3;\n/// Dune.\nfn dune(at: Surface) -> f32 { return duneΔ(1.0); }\nfn duneΔ(größe: f32) -> f32 { return größe; } ",
        "/// Dune.\nfn\ndune\n(\nat\n:\nSurface\n)\n->\nf32\n{ return perlinNoise (at.position); }",
    ];
    expect_none(right.into_iter().filter_map(|texture| {
        let told = told_of("dune.wgsl", "Dune", texture);
        (!told.is_empty()).then(|| format!("{texture}\n{told}"))
    }));
}

#[test]
fn a_file_may_be_called_as_its_function() {
    for (file, function) in [
        ("my-rings.wgsl", "myRings"),
        ("my_rings.wgsl", "myRings"),
        ("MyRings.wgsl", "myRings"),
        ("myRings.wgsl", "myRings"),
    ] {
        let texture = format!("/// Rings.\nfn {function}(at: Surface) -> f32 {{ return 1.0; }}\n");
        assert_eq!(told_of(file, "MyRings", &texture), "", "{file}");
    }
    let told = told_of("größe.wgsl", "Größe", "/// Size.\nfn größe(at: Surface) -> f32 { return 1.0; }\n");
    assert_eq!(told, "");
}

/// Each at its word in the author's file, in words that say what to write.
#[test]
fn what_a_snippet_cannot_have_is_told_at_its_place() {
    let deep =
        format!("fn wave(at: Surface) -> f32 {{ return {}1.0{}; }}", "(".repeat(10_000), ")".repeat(10_000));
    let signs = format!("fn wave(at: Surface) -> f32 {{ return {}1.0; }}", "-".repeat(10_000));
    let wave = |body: &str| format!("fn wave(at: Surface) -> f32 {{ {body} }}");
    let beside = |line: &str| format!("{line}\nfn wave(at: Surface) -> f32 {{ return 1.0; }}");
    let cases = [
        (deep, "brackets are nested more than 100 deep", "let part"),
        (signs, "brackets are nested more than 100 deep", "let part"),
        (wave("return fwidth(at.uv.x);"), "`fwidth` reads neighboring pixels", "at.footprint"),
        (wave("discard; return 1.0;"), "`discard` is only allowed in entry points", "return"),
        (
            wave("return select(0.0, 1.0, at.uv.x < 1.0 & true);"),
            "`<` and `&` need brackets",
            "WGSL forbids this",
        ),
        (beside("override waveLevel = 1.0;"), "an `override` never gets a value here", "write `const`"),
        (beside("@group(0) @binding(0) var<uniform> t: f32;"), "a texture has no bindings", "frame.time"),
        (beside("@compute @workgroup_size(1) fn waveMain() {}"), "no entry points", "fn wave"),
        (beside("var<workgroup> waveShared: f32;"), "must be `var<private>`", "const"),
        (beside("enable f16;"), "`enable` is only allowed at the start", "remove the line"),
        (beside("#define PI 3.14"), "this looks like GLSL", "const NAME"),
        ("vec3 wave(vec2 uv) { return vec3(1.0); }".into(), "this looks like GLSL", "fn name"),
        (beside("const frame = 1.0;"), "the name `frame` is taken: raytoy uses this name in", "waveFrame"),
        (beside("const background = 1.0;"), "the name `background` is taken", "waveBackground"),
        (beside("struct Surface { x: f32 }"), "the name `Surface` is taken", "waveSurface"),
    ];
    expect_none(cases.into_iter().filter_map(|(texture, message, help)| {
        let told = told_of("wave.wgsl", "Wave", &format!("/// A wave.\n{texture}\n"));
        let is_right =
            told.contains(message) && told.contains(help) && told.contains("textures/wave.wgsl:2:");
        (!is_right).then(|| told[..told.len().min(600)].to_owned())
    }));
}

#[test]
fn names_of_wgsl_and_of_raytoy_are_taken() {
    let names = [
        ("mix", "mix"),
        ("length", "length"),
        ("array", "array"),
        ("luminance", "luminance"),
        ("shown", "shown"),
        ("surface_at", "surfaceAt"),
        ("main_image", "mainImage"),
    ];
    for (stem, name) in names {
        let call = name[..1].to_uppercase() + &name[1..];
        let texture = format!("/// A texture.\nfn {name}(at: Surface) -> f32 {{ return 1.0; }}\n");
        let told = told_of(&format!("{stem}.wgsl"), &call, &texture);
        let place = format!("textures/{stem}.wgsl:2:4");
        assert!(told.contains(&format!("the name `{name}` is taken")) && told.contains(&place), "{told}");
    }
}
