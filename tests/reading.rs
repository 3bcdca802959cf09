//! Texts as other programs and other languages write them: numbers, byte-order marks, line ends.

mod common;

use common::{expect_none, outcome_of};
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
        let first = outcome_of("a.ron", &format!("\u{feff}(objects: [Nope()])"), Mode::Baked);
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
