//! Laws of edits: a change of one value changes its bytes alone, says what was meant, and can be taken back.

use crate::common::{files, good_scenes, read};
use crate::edits::{Random, edit, reformatted, says, tree, without};
use raytoy::edit::{Edit, NewValue, Refusal};
use raytoy::scene::{Kind, Path, Record, Step, Value, parse};

/// Random edits, each of a scene written anew.
const EDITS: usize = 6000;

/// All scenes that are RON, those with other mistakes too.
fn scenes() -> Vec<(String, String)> {
    let errors = files("tests/cases/errors", "ron");
    let all = good_scenes().into_iter().chain(errors).map(|name| (name.clone(), read(&name)));
    all.filter(|(name, text)| !name.contains("forty") && parse(name, text).is_ok()).collect()
}

#[test]
fn an_edit_changes_what_it_means_and_nothing_else() {
    let scenes = scenes();
    let mut random = Random(11);
    let mut done = [0; 4];
    for number in 0..EDITS {
        let (name, original) = &scenes[random.below(scenes.len())];
        let text = reformatted(&mut random, original);
        let root = tree(&text);
        let edit = edit(&mut random, &root);
        let story = || format!("edit {number} of {name}: {edit:?}\n{text}");
        match edit.on(&text) {
            Ok(change) => {
                let new = change.apply(&text);
                let is_marked = |text: &str| text.starts_with('\u{feff}');
                assert_eq!(is_marked(&text), is_marked(&new), "{}", story());
                let after = parse(name, &new).unwrap_or_else(|p| panic!("{p:?}\n{}\nto\n{new}", story()));
                let law = check(&text, &root, &edit, &new, &after, &change.span);
                done[law.unwrap_or_else(|broken| panic!("{broken}\n{}\nto\n{new}", story()))] += 1;
            }
            Err(refusal) => assert!(is_fair(&refusal, &root, &edit), "{refusal:?}\n{}", story()),
        }
    }
    eprintln!("{EDITS} edits: {} set, {} added, {} removed, {} put in", done[0], done[1], done[2], done[3]);
    assert!(done.iter().all(|n| *n > EDITS / 50), "too few of a kind: {done:?}");
}

/// Which kind of edit it was, or what is wrong with it.
fn check(
    text: &str,
    root: &Value,
    edit: &Edit,
    new: &str,
    after: &Value,
    changed: &std::ops::Range<usize>,
) -> Result<usize, String> {
    let holds = |law: bool, what: &str| if law { Ok(()) } else { Err(what.to_owned()) };
    match edit {
        Edit::Set { path, value } | Edit::Add { path, value, .. } => {
            let now = after.at(path).ok_or("it is not there")?;
            holds(says(now, value), "it says something else")?;
            let again = edit.on(new).map_err(|r| format!("the second time: {r}"))?;
            holds(again.is_empty(), "the second time it changes something")?;
            if let Some(old) = root.at(path) {
                let is_within = old.whole.start <= changed.start && changed.end <= old.whole.end;
                holds(is_within || changed.is_empty(), "bytes of others change")?;
                let rest = without(root, path).says_the_same_as(&without(after, path));
                return holds(rest, "the rest says something else").map(|()| 0);
            }
            let added = first_missing(root, path);
            holds(without(after, &added).says_the_same_as(root), "the rest says something else")?;
            holds(is_subsequence(text, new), "something is lost")?;
            let removed = Edit::Remove { path: added.clone() }.on(new).map_err(|r| r.to_string())?;
            let back = removed.apply(new);
            holds(back == text || is_bare(root, &added), &format!("it is not taken back: {back}"))?;
            Ok(1)
        }
        Edit::Remove { path } => {
            holds(without(root, path).says_the_same_as(after), "the rest says something else")?;
            holds(is_subsequence(new, text), "something is new")?;
            Ok(2)
        }
        Edit::Insert { list, index, .. } => {
            let before =
                root.at(list).map_or(0, |list| if let Kind::List(l) = &list.kind { l.len() } else { 0 });
            let at = list.item((*index).min(before));
            holds(without(after, &at).says_the_same_as(root), "the rest says something else")?;
            holds(is_subsequence(text, new), "something is lost")?;
            let back = Edit::Remove { path: at }.on(new).map_err(|r| r.to_string())?.apply(new);
            holds(back == text, &format!("it is not taken back: {back}"))?;
            Ok(3)
        }
        Edit::Duplicate { path } => {
            let (group, step) = path.split().ok_or("it is the root")?;
            if let Step::Item(index) = step {
                let copy = without(after, &group.item(index + 1));
                holds(copy.says_the_same_as(root), "the rest says something else")?;
            }
            Ok(3)
        }
        Edit::Rename { .. } => Err("none of these is made".into()),
    }
}

/// The shortest beginning of `path` that leads nowhere.
fn first_missing(root: &Value, path: &Path) -> Path {
    let beginnings = (1..=path.0.len()).map(|n| Path(path.0[..n].to_vec()));
    beginnings.into_iter().find(|p| root.at(p).is_none()).expect("the whole path leads nowhere")
}

/// Whether what `path` is added to has no brackets, which it keeps.
fn is_bare(root: &Value, path: &Path) -> bool {
    let group = path.split().and_then(|(group, _)| root.at(&group).cloned());
    let bare = |v: Value| matches!(&v.kind, Kind::Record(Record { name: Some(n), .. }) if n.span == v.span);
    group.is_some_and(bare)
}

fn is_subsequence(part: &str, of: &str) -> bool {
    let mut of = of.chars();
    part.chars().all(|c| of.any(|o| o == c))
}

/// Whether there is a reason to refuse.
fn is_fair(refusal: &Refusal, root: &Value, edit: &Edit) -> bool {
    let Refusal::NotThere(_) = refusal else { return false };
    let group = |path: &Path| path.split().and_then(|(group, _)| root.at(&group).cloned()).map(|g| g.kind);
    match edit {
        Edit::Set { path, .. } => !matches!(
            group(&first_missing(root, path)),
            Some(Kind::Record(Record { items, .. })) if items.is_empty()
        ),
        Edit::Remove { path } | Edit::Duplicate { path } => {
            matches!(path.0.last(), Some(Step::Item(_))) && !matches!(group(path), Some(Kind::List(_)))
        }
        _ => false,
    }
}

#[test]
fn what_is_no_scene_and_what_is_no_value_is_refused() {
    let set = |path: Path, value: NewValue| Edit::Set { path, value };
    let camera = Path::default().field("camera");
    let broken = set(camera.clone(), NewValue::Number(1.0)).on("(camera: ");
    assert!(matches!(broken, Err(Refusal::Syntax(_))));
    for (value, why) in [
        (NewValue::Number(f32::NAN), "it is not a finite number"),
        (NewValue::Vector(vec![0.0, f32::INFINITY]), "it is not a finite number"),
        (NewValue::Code("Noise(".into()), "`Noise(` is no RON: "),
        (NewValue::Word("".into()), "`` is no RON: the file contains no scene"),
    ] {
        let refusal = set(camera.clone(), value).on("(camera: ())").unwrap_err().to_string();
        assert!(refusal.starts_with(&format!("`camera` cannot be set: {why}")), "{refusal}");
    }
    let nowhere = set(camera.item(0), NewValue::Number(1.0)).on("(camera: ())").unwrap_err();
    assert_eq!(nowhere.to_string(), "the scene has no place for `camera[0]`");
    assert!(set(camera.field("no name"), NewValue::Flag(true)).on("(camera: ())").is_err());
}

/// The text after a value is set.
fn after_set(text: &str, steps: &str, value: NewValue) -> String {
    let edit = Edit::Set { path: path(steps), value };
    edit.on(text).unwrap_or_else(|refusal| panic!("{refusal}\n{text}")).apply(text)
}

/// `a.0."key"`.
fn path(steps: &str) -> Path {
    steps.split('.').fold(Path::default(), |path, step| match step.parse() {
        Ok(index) => path.item(index),
        Err(_) if step.starts_with('"') => path.key(step.trim_matches('"')),
        Err(_) => path.field(step),
    })
}

#[test]
fn numbers_keep_their_style() {
    for (old, x, new) in [
        ("1", 2.0, "2"),
        ("1.0", 2.0, "2.0"),
        ("1.50", 2.0, "2.0"),
        ("1", 2.5, "2.5"),
        ("1.25", -0.1, "-0.1"),
        ("1", 1e-7, "0.0000001"),
        ("1", 1e-12, "1e-12"),
        ("1.5", 4e9, "4e9"),
        ("1", 1e9, "1000000000"),
        ("1", -0.0, "0"),
        ("1", 0.1 + 0.2, "0.3"),
        ("1", 16_777_216.0, "16777216"),
        // What says the same already stays as it is.
        ("1_000.00", 1000.0, "1_000.00"),
        ("0xff", 255.0, "0xff"),
        ("-0", 0.0, "-0"),
        ("1e3", 1000.0, "1e3"),
        ("1e3", 2000.0, "2000"),
        ("0xff", 256.0, "256"),
        ("0.30000000000000004", 0.3, "0.30000000000000004"),
        ("Some( 5 )", 6.0, "Some( 6 )"),
        ("None", 6.0, "6"),
        ("Noise(scale: 3)", 0.5, "0.5"),
        ("\"tomato\"", 0.5, "0.5"),
    ] {
        assert_eq!(after_set(&format!("(x: {old})"), "x", NewValue::Number(x)), format!("(x: {new})"));
    }
}

#[test]
fn a_field_is_added_in_order() {
    let order = ["a", "b", "c", "d"].map(str::to_owned).to_vec();
    for (before, name, after) in [
        ("(d: 4)", "b", "(b: 1, d: 4)"),
        ("(a: 0, d: 4)", "c", "(a: 0, c: 1, d: 4)"),
        ("(a: 0, other: 5, d: 4)", "b", "(a: 0, other: 5, b: 1, d: 4)"),
        ("(d: 4, a: 0)", "b", "(b: 1, d: 4, a: 0)"),
        ("(\n    a: 0, // first\n    d: 4,\n)", "b", "(\n    a: 0, // first\n    b: 1,\n    d: 4,\n)"),
        ("(a: 0)", "d", "(a: 0, d: 1)"),
        ("(a: 0)", "nobody_knows", "(a: 0, nobody_knows: 1)"),
        ("()", "b", "(b: 1)"),
        ("(b: 2, c: 3)", "b", "(b: 1, c: 3)"),
    ] {
        let (path, value) = (path(name), NewValue::Number(1.0));
        let edit = Edit::Add { path, value, order: order.clone() };
        let change = edit.on(before).expect("it has a place");
        assert_eq!(change.apply(before), after);
    }
}

#[test]
fn colors_keep_their_style() {
    let color = |text: &str| NewValue::Color(raytoy::library::parse_color(text).unwrap());
    let linear = |r, g, b| NewValue::Color(glam::Vec3::new(r, g, b));
    for (old, value, new) in [
        ("\"#8c3b2a\"", color("#0080ff"), "\"#0080ff\""),
        ("\"#8C3B2A\"", color("#0080ff"), "\"#0080FF\""),
        ("\"#fff\"", color("#336699"), "\"#369\""),
        ("\"#FFF\"", color("#aabbcc"), "\"#ABC\""),
        ("\"#fff\"", color("#336698"), "\"#336698\""),
        ("\"#ffffff80\"", color("#336699"), "\"#33669980\""),
        ("\"#fff8\"", color("#336699"), "\"#3698\""),
        ("\"#fff8\"", color("#336698"), "\"#33669888\""),
        ("r#\"#fff\"#", color("#336699"), "r#\"#369\"#"),
        ("\"tomato\"", color("#336699"), "\"#336699\""),
        ("\"tiles\"", color("#336699"), "\"#336699\""),
        ("\"#fff\"", linear(0.5, 0.1, 2.0), "(0.5, 0.1, 2)"),
        ("(0.5, 0.10, 0.0)", linear(0.5, 0.1, 1.0), "(0.5, 0.10, 1.0)"),
        ("( 1 , 0, /* b */ 0 )", linear(1.0, 0.5, 0.25), "( 1 , 0.5, /* b */ 0.25 )"),
        ("0.8", linear(0.5, 0.5, 0.5), "0.5"),
        ("1.0", linear(0.0, 0.0, 0.0), "0.0"),
        ("0.8", color("#336699"), "\"#336699\""),
        ("0.8", linear(0.5, 0.1, 0.2), "(0.5, 0.1, 0.2)"),
        ("Noise()", linear(0.5, 0.5, 0.5), "0.5"),
        ("\"#FFFFFF\"", color("white"), "\"#FFFFFF\""),
        ("\"white\"", color("#fff"), "\"white\""),
    ] {
        assert_eq!(after_set(&format!("(x: {old})"), "x", value), format!("(x: {new})"));
    }
}

#[test]
fn vectors_words_and_strings_keep_their_style() {
    let text = |text: &str| NewValue::Text(text.into());
    let word = |text: &str| NewValue::Word(text.into());
    let code = |text: &str| NewValue::Code(text.into());
    for (old, value, new) in [
        ("(1,  2.0, /* z */ 3)", NewValue::Vector(vec![1.0, 4.0, 3.0]), "(1,  4.0, /* z */ 3)"),
        ("2", NewValue::Vector(vec![1.0, 2.5, 1.0]), "(1, 2.5, 1)"),
        ("[1, 2]", NewValue::Vector(vec![1.0, 2.0]), "(1, 2)"),
        ("true", NewValue::Flag(false), "false"),
        ("Some(true)", NewValue::Flag(false), "Some(false)"),
        ("Sine", word("Saw"), "Saw"),
        ("\"sine\"", word("Saw"), "\"saw\""),
        ("\"Sine\"", word("Saw"), "\"Saw\""),
        ("r\"sine\"", word("Saw"), "r\"saw\""),
        ("Gamma( 2.4 )", word("Gamma(2.0)"), "Gamma( 2.4 )"),
        ("Gamma( 2.4 )", word("Srgb"), "Srgb"),
        ("Srgb", word("Gamma(2.0)"), "Gamma(2.0)"),
        ("Some(5)", word("None"), "None"),
        ("\"a\"", text("b \"c\" \\ é\n"), "\"b \\\"c\\\" \\\\ é\\n\""),
        ("r\"a\"", text("b\\c"), "r\"b\\c\""),
        ("r\"a\"", text("b\"c"), "\"b\\\"c\""),
        ("r#\"a\"#", text("b\"c"), "r#\"b\"c\"#"),
        ("\"\\u{e9}\"", text("é"), "\"\\u{e9}\""),
        ("0.5", code("Noise( scale: 3 ) // mine"), "Noise( scale: 3 )"),
        ("Noise( scale: 3 )", code("Noise(scale: 3.0)"), "Noise( scale: 3 )"),
    ] {
        assert_eq!(after_set(&format!("(x: {old})"), "x", value), format!("(x: {new})"));
    }
}

#[test]
fn what_was_left_out_comes_where_a_person_would_add_it() {
    for (old, steps, new) in [
        ("(a: Sphere())", "a.b", "(a: Sphere(b: 2))"),
        ("(a: Sphere)", "a.b", "(a: Sphere(b: 2))"),
        ("(a: ())", "a.b", "(a: (b: 2))"),
        ("(a: 1)", "b", "(a: 1, b: 2)"),
        ("(a: 1,)", "b", "(a: 1, b: 2,)"),
        ("(a: Some(1) /* one */ )", "b", "(a: Some(1), b: 2 /* one */ )"),
        ("(\n    a: 1,\n)", "b", "(\n    a: 1,\n    b: 2,\n)"),
        ("(\n    a: 1\n)", "b", "(\n    a: 1,\n    b: 2\n)"),
        ("(\r\n\ta: 1, // one\r\n)", "b", "(\r\n\ta: 1, // one\r\n\tb: 2,\r\n)"),
        ("(\n  a: 1 // one\n  // two\n)", "b", "(\n  a: 1, // one\n  b: 2\n  // two\n)"),
        ("(\n    a: 1, c: 3,\n)", "b", "(\n    a: 1, c: 3, b: 2,\n)"),
        ("(a: 1,\n c: 3)", "b", "(a: 1,\n c: 3,\n b: 2)"),
        ("(\n    // nothing yet\n)", "b", "(\n    b: 2,\n    // nothing yet\n)"),
        ("(a: 1)", "b.c.d", "(a: 1, b: (c: (d: 2)))"),
        ("(a: 1)", "b.\"c d\"", "(a: 1, b: { \"c d\": 2 })"),
        ("(a: { \"c\": 1 })", "a.\"d\"", "(a: { \"c\": 1, \"d\": 2 })"),
        ("(a: {})", "a.\"d\"", "(a: {\"d\": 2})"),
    ] {
        assert_eq!(after_set(old, steps, NewValue::Number(2.0)), new, "{old}");
    }
}

#[test]
fn what_is_taken_out_leaves_no_hole() {
    for (old, steps, new) in [
        ("(a: 1, b: 2, c: 3)", "a", "(b: 2, c: 3)"),
        ("(a: 1, b: 2, c: 3)", "b", "(a: 1, c: 3)"),
        ("(a: 1, b: 2, c: 3)", "c", "(a: 1, b: 2)"),
        ("(a: 1, b: 2,)", "b", "(a: 1,)"),
        ("( a: 1 )", "a", "( )"),
        (
            "(\n    a: 1, // one\n    b: 2, // two\n    c: 3, // three\n)",
            "b",
            "(\n    a: 1, // one\n    c: 3, // three\n)",
        ),
        ("(\n    a: 1,\n    // of b\n    b: 2\n)", "b", "(\n    a: 1\n    // of b\n)"),
        ("(\n    a: 1, b: 2,\n    c: 3,\n)", "b", "(\n    a: 1,\n    c: 3,\n)"),
        ("(\n    a: 1, b: 2,\n    c: 3,\n)", "a", "(\n    b: 2,\n    c: 3,\n)"),
        ("(a: 1, // one\n b: 2)", "b", "(a: 1 // one\n )"),
        ("(a: [1, 2, 3])", "a.1", "(a: [1, 3])"),
        ("(a: {\"b\": 1, \"c\": Some(2)})", "a.\"c\"", "(a: {\"b\": 1})"),
        ("(a: (\n        b: 2,\r\n    ))", "a.b", "(a: (\n    ))"),
    ] {
        let edit = Edit::Remove { path: path(steps) };
        assert_eq!(edit.on(old).unwrap().apply(old), new, "{old}");
    }
}

#[test]
fn items_are_put_in_and_copied_in_the_style_of_their_list() {
    for (old, index, new) in [
        ("(a: [])", 0, "(a: [Box()])"),
        ("(b: 1)", 7, "(b: 1, a: [Box()])"),
        ("(a: [X, Y])", 0, "(a: [Box(), X, Y])"),
        ("(a: [X, Y])", 1, "(a: [X, Box(), Y])"),
        ("(a: [X, Y])", 9, "(a: [X, Y, Box()])"),
        ("(a: [\n  X, // x\n  // of y\n  Y\n])", 1, "(a: [\n  X, // x\n  Box(),\n  // of y\n  Y\n])"),
        ("(a: [\n  X, // x\n  Y\n])", 2, "(a: [\n  X, // x\n  Y,\n  Box()\n])"),
        ("(a: [ // all\n  X,\n])", 0, "(a: [ // all\n  Box(),\n  X,\n])"),
    ] {
        let edit = Edit::Insert { list: path("a"), index, item: " Box() ".into() };
        assert_eq!(edit.on(old).unwrap().apply(old), new, "{old}");
    }
    for (old, steps, new) in [
        ("(a: [X(r: 1), Y])", "a.0", "(a: [X(r: 1), X(r: 1), Y])"),
        (
            "(a: [\n  X(\n    r: 1, // r\n  ), // x\n])",
            "a.0",
            "(a: [\n  X(\n    r: 1, // r\n  ), // x\n  X(\n    r: 1, // r\n  ),\n])",
        ),
        (
            "(a: [X(name: \"x\"), Y(name: \"x 2\")])",
            "a.0",
            "(a: [X(name: \"x\"), X(name: \"x 3\"), Y(name: \"x 2\")])",
        ),
        (
            "(a: [U(parts: [X(name: r\"x\")])])",
            "a.0",
            "(a: [U(parts: [X(name: r\"x\")]), U(parts: [X(name: r\"x 2\")])])",
        ),
        ("(a: {\"t\": 1, \"t 2\": 2})", "a.\"t\"", "(a: {\"t\": 1, \"t 3\": 1, \"t 2\": 2})"),
    ] {
        let edit = Edit::Duplicate { path: path(steps) };
        assert_eq!(edit.on(old).unwrap().apply(old), new, "{old}");
    }
    let old = "(c: Brick( scale: 2, /* c */ clay: \"#fff\", at: Swirl(), ))";
    let keep = vec!["scale".to_owned(), "at".to_owned()];
    let edit = Edit::Rename { path: path("c"), name: "Checker".into(), keep };
    assert_eq!(edit.on(old).unwrap().apply(old), "(c: Checker( scale: 2, /* c */ at: Swirl(), ))");
    let edit = Edit::Rename { path: path("c"), name: "no name".into(), keep: vec![] };
    assert!(edit.on(old).is_err());
}

#[test]
fn nesting_to_any_depth_is_edited_or_refused() {
    for (open, close) in
        [("(a: ", ")"), ("[", "]"), ("Some(", ")"), ("Checker(even: ", ")"), ("{\"a\": ", "}")]
    {
        for depth in [30, 60, 120, 1_000, 100_000] {
            let text = format!("(x: {}1{}, y: 1)", open.repeat(depth), close.repeat(depth));
            let change = Edit::Set { path: path("y"), value: NewValue::Number(2.0) }.on(&text);
            match change {
                Ok(change) => assert!(change.apply(&text).ends_with("y: 2)"), "{depth} times {open}"),
                Err(refusal) => assert!(matches!(refusal, Refusal::Syntax(_)), "{depth} times {open}"),
            }
        }
    }
}
