//! Steps that are undone and done again, and edits that meet what others did to the file meanwhile.

use crate::common::{good_scenes, read};
use crate::edits;
use crate::edits::{Random, edit, reformatted, tree};
use raytoy::edit::{Conflict, Edit, History, NewValue};
use raytoy::scene::{Path, parse};

const TEXT: &str = r##"(
    camera: (eye: (1, 2, 3), fov_deg: 40), // from the front
    objects: [
        Sphere(name: "ball", radius: 1),
        Box(material: (color: "#ff0000")),
    ],
)
"##;

fn path(steps: &str) -> Path {
    steps.split('.').fold(Path::default(), |path, step| match step.parse() {
        Ok(index) => path.item(index),
        Err(_) => path.field(step),
    })
}

fn set(at: &str, x: f32) -> Edit {
    Edit::Set { path: path(at), value: NewValue::Number(x) }
}

fn edited(text: &str, edits: &[Edit]) -> History {
    let mut history = History::new(text);
    for edit in edits {
        history.edit(edit.clone(), None).unwrap_or_else(|refusal| panic!("{refusal}"));
    }
    history
}

#[test]
fn undo_gives_the_first_text_back_and_redo_the_last() {
    let scenes: Vec<String> =
        good_scenes().iter().map(|name| read(name)).filter(|t| t.len() < 4000).collect();
    let mut random = Random(5);
    for round in 0..60 {
        let text = reformatted(&mut random, &scenes[round % scenes.len()]);
        let mut history = History::new(text.clone());
        let mut texts = vec![text];
        for _ in 0..12 {
            let edit = edit(&mut random, &tree(history.text()));
            if history.edit(edit, None) == Ok(true) {
                texts.push(history.text().to_owned());
            }
            assert_eq!(history.is_saved(), history.text() == texts[0]);
        }
        for text in texts.iter().rev().skip(1) {
            assert!(history.can_undo() && history.undo());
            assert_eq!(history.text(), text);
        }
        assert!(!history.can_undo() && !history.undo() && history.is_saved());
        for text in texts.iter().skip(1) {
            assert!(history.can_redo() && history.redo());
            assert_eq!(history.text(), text);
        }
        assert!(!history.can_redo() && !history.redo());
    }
}

#[test]
fn a_drag_is_one_step() {
    let mut history = History::new(TEXT);
    for x in [41.0, 42.5, 43.0] {
        history.edit(set("camera.fov_deg", x), Some(1)).unwrap();
    }
    history.edit(set("camera.fov_deg", 50.0), Some(2)).unwrap();
    assert!(history.undo());
    assert!(history.text() == TEXT.replace("fov_deg: 40", "fov_deg: 43"));
    assert!(history.undo());
    assert_eq!(history.text(), TEXT);
    assert!(!history.undo());
    // One that ends where it began is none.
    for x in [41.0, 42.5, 40.0] {
        history.edit(set("camera.fov_deg", x), Some(3)).unwrap();
    }
    assert!(!history.can_undo() && history.is_saved());
    assert_eq!(history.edit(set("camera.fov_deg", 40.0), None), Ok(false));
}

#[test]
fn edits_of_others_and_own_ones_go_together() {
    let mut history = edited(TEXT, &[set("camera.fov_deg", 50.0), set("objects.1.scale", 2.0)]);
    let theirs = TEXT
        .replace("radius: 1", "radius: 7 /* bigger */")
        .replace("objects: [", "objects: [\n        Plane(), // new")
        .replace("(1, 2, 3)", "( 1,2,3 )");
    assert_eq!(history.outside(&theirs), Ok(vec![]));
    let both =
        theirs.replace("fov_deg: 40", "fov_deg: 50").replace("\"#ff0000\"))", "\"#ff0000\"), scale: 2)");
    assert_eq!(history.text(), both);
    assert!(!history.is_saved() && !history.is_behind());
    assert!(history.undo() && history.undo());
    assert_eq!(history.text(), theirs);
    assert!(history.is_saved());
    assert!(history.undo(), "what happened outside is a step");
    assert_eq!(history.text(), TEXT);
    assert!(!history.is_saved() && !history.can_undo());
}

#[test]
fn what_both_changed_is_told_and_neither_is_lost() {
    let mine = set("camera.fov_deg", 50.0);
    let mut history =
        edited(TEXT, &[set("camera.fov_deg", 45.0), set("objects.0.radius", 3.0), mine.clone()]);
    let theirs = TEXT.replace("fov_deg: 40", "fov_deg: 60");
    let conflicts = history.outside(&theirs).unwrap();
    let told = Conflict {
        mine: mine.clone(),
        again: Some(mine.clone()),
        theirs: Some("60".into()),
        before: Some("40".into()),
    };
    assert_eq!(conflicts, [told]);
    assert_eq!(history.text(), theirs.replace("radius: 1", "radius: 3"));
    history.edit(mine, None).unwrap();
    assert_eq!(history.text(), theirs.replace("radius: 1", "radius: 3").replace("60", "50"));

    // The same change on both sides is no conflict.
    let mut history = edited(TEXT, &[set("camera.fov_deg", 50.0)]);
    assert_eq!(history.outside(&TEXT.replace("fov_deg: 40", "fov_deg: 50.0")), Ok(vec![]));
    assert!(history.is_saved());

    // Of what is gone there is only what was done.
    let mine = set("objects.0.radius", 3.0);
    let mut history = edited(TEXT, std::slice::from_ref(&mine));
    let theirs = TEXT.replace("        Sphere(name: \"ball\", radius: 1),\n", "");
    let conflicts = history.outside(&theirs).unwrap();
    let told = Conflict { mine, again: None, theirs: None, before: Some("1".into()) };
    assert_eq!(conflicts, [told]);
    assert_eq!(history.text(), theirs);
}

#[test]
fn objects_are_found_again_where_they_moved() {
    let items = |text: &str| format!("(objects: [{text}])");
    let text = items("Sphere(radius: 1), Box(name: \"b\"), Sphere(radius: 2)");
    for (theirs, expected) in [
        ("Box(name: \"b\"), Sphere(radius: 1), Sphere(radius: 2)", None),
        ("Sphere(radius: 1), Sphere(radius: 2), Box(name: \"b\", scale: 3)", None),
        ("Plane(), Sphere(radius: 9), Box(name: \"b\"), Sphere(radius: 2)", None),
        ("Sphere(radius: 1), Box(name: \"c\"), Sphere(radius: 2)", Some("c")),
    ] {
        let mut history = edited(&text, &[set("objects.1.visible", 0.0)]);
        assert_eq!(history.outside(&items(theirs)).map(|c| c.len()), Ok(0), "{theirs}");
        let name = expected.unwrap_or("b");
        let merged = history.text().replace(", visible: 0", "");
        assert_eq!(merged, items(theirs));
        let of_box = &history.text()[history.text().find("Box").unwrap()..];
        let of_box = &of_box[..of_box.find(')').unwrap()];
        assert!(of_box.contains(name) && of_box.ends_with("visible: 0"), "{theirs}: {}", history.text());
    }
    // A copy goes behind the original, an item behind its neighbour.
    let insert = Edit::Insert { list: path("objects"), index: 2, item: "Disk()".into() };
    let mut history = edited(&text, &[insert, Edit::Duplicate { path: path("objects.1") }]);
    history.outside(&items("Plane(), Sphere(radius: 1), Box(name: \"b\"), Sphere(radius: 2)")).unwrap();
    let expected =
        "Plane(), Sphere(radius: 1), Box(name: \"b\"), Box(name: \"b 2\"), Disk(), Sphere(radius: 2)";
    assert_eq!(history.text(), items(expected));
}

#[test]
fn a_text_that_cannot_be_read_waits() {
    let mut history = edited(TEXT, &[set("camera.fov_deg", 50.0)]);
    let mine = history.text().to_owned();
    assert!(history.outside("(camera: ").is_err());
    assert_eq!((history.text(), history.is_behind()), (mine.as_str(), true));
    let theirs = TEXT.replace("radius: 1", "radius: 7");
    assert_eq!(history.outside(&theirs), Ok(vec![]));
    assert_eq!(history.text(), theirs.replace("fov_deg: 40", "fov_deg: 50"));
    assert!(!history.is_behind());
    // With nothing of one's own to merge, it is taken as it is.
    let mut history = History::new(TEXT);
    assert_eq!(history.outside("(camera: "), Ok(vec![]));
    assert_eq!((history.text(), history.is_saved()), ("(camera: ", true));
    assert!(history.edit(set("camera.fov_deg", 50.0), None).is_err());
}

#[test]
fn undoing_what_was_saved_is_an_edit_that_merges_too() {
    let mut history = edited(TEXT, &[set("camera.fov_deg", 50.0)]);
    history.saved();
    assert!(history.is_saved() && history.undo() && !history.is_saved());
    let theirs = TEXT.replace("fov_deg: 40", "fov_deg: 50").replace("radius: 1", "radius: 7");
    assert_eq!(history.outside(&theirs), Ok(vec![]));
    assert_eq!(history.text(), TEXT.replace("radius: 1", "radius: 7"));

    // A drag over the moment of saving is taken back as a whole.
    let mut history = History::new(TEXT);
    history.edit(set("camera.fov_deg", 45.0), Some(1)).unwrap();
    history.saved();
    history.edit(set("camera.fov_deg", 50.0), Some(1)).unwrap();
    assert!(history.undo());
    let theirs = TEXT.replace("fov_deg: 40", "fov_deg: 45").replace("radius: 1", "radius: 7");
    assert_eq!(history.outside(&theirs), Ok(vec![]));
    assert_eq!(history.text(), TEXT.replace("radius: 1", "radius: 7"));

    // What was undone from outside is all of the text, and is told.
    let mut history = History::new(TEXT);
    history.outside(&TEXT.replace("radius: 1", "radius: 2")).unwrap();
    assert!(history.undo());
    let theirs = TEXT.replace("radius: 1", "radius: 3");
    let conflicts = history.outside(&theirs).unwrap();
    assert_eq!(conflicts.len(), 1);
    assert_eq!(history.text(), theirs);
    history.edit(conflicts[0].again.clone().unwrap(), None).unwrap();
    assert_eq!(history.text(), TEXT);
}

#[test]
fn what_was_undone_over_a_broken_file_is_told() {
    let mut history = History::new(TEXT);
    history.outside("(camera: ").unwrap();
    assert!(history.undo() && history.text() == TEXT);
    let theirs = TEXT.replace("radius: 1", "radius: 3");
    let conflicts = history.outside(&theirs).unwrap();
    assert_eq!((conflicts.len(), history.text()), (1, theirs.as_str()));
    history.edit(conflicts[0].again.clone().unwrap(), None).unwrap();
    assert_eq!(history.text(), TEXT);
}

/// Edits of two people at random, from one text: what only one of them changed is as they said.
#[test]
fn merging_keeps_all_that_does_not_conflict() {
    let scenes: Vec<String> =
        good_scenes().iter().map(|name| read(name)).filter(|t| t.len() < 4000).collect();
    let mut random = Random(23);
    let (mut merged, mut conflicts) = (0, 0);
    for round in 0..300 {
        let text = &scenes[round % scenes.len()];
        let root = tree(text);
        let (mine, others) = (edit(&mut random, &root), edit(&mut random, &root));
        let Ok(theirs) = others.on(text).map(|change| change.apply(text)) else { continue };
        let mut history = History::new(text.clone());
        if history.edit(mine.clone(), None) != Ok(true) {
            continue;
        }
        let told = history.outside(&theirs).unwrap_or_else(|p| panic!("{p:?}\n{theirs}"));
        assert!(parse("merged", history.text()).is_ok(), "{mine:?}\n{others:?}\n{}", history.text());
        let is_theirs = tree(history.text()).says_the_same_as(&tree(&theirs));
        let Edit::Set { path, value } = &mine else { continue };
        let Edit::Set { path: other, .. } = &others else { continue };
        let is_apart = !path.0.starts_with(&other.0) && !other.0.starts_with(&path.0);
        if !told.is_empty() {
            assert!(!is_apart && is_theirs, "{told:?}");
            conflicts += 1;
        } else if is_apart && root.at(path).is_some() {
            let now = tree(history.text());
            assert!(edits::says(now.at(path).unwrap(), value), "{mine:?}\n{others:?}\n{}", history.text());
            merged += 1;
        }
    }
    eprintln!("{merged} merged, {conflicts} conflicts");
    assert!(merged > 30, "only {merged} merged");
}

#[test]
fn a_drag_of_two_values_is_one_step_however_long_it_is() {
    let mut history = History::new(TEXT);
    let drag = |history: &mut History, x: f32, gesture: u64| {
        for (at, x) in [("camera.fov_deg", x), ("objects.0.radius", 2.0 * x), ("objects.1.scale", x)] {
            history.edit(set(at, x), Some(gesture)).unwrap();
        }
    };
    (1..=500).for_each(|i| drag(&mut history, i as f32 / 8.0, 1));
    let first = TEXT
        .replace("fov_deg: 40", "fov_deg: 62.5")
        .replace("radius: 1", "radius: 125")
        .replace("\"#ff0000\")", "\"#ff0000\"), scale: 62.5");
    assert_eq!(history.text(), first);
    (1..=9).for_each(|i| drag(&mut history, i as f32, 2));
    // What is not saved is merged with what an editor does.
    let theirs = TEXT.replace("from the front", "from behind");
    let mut merged = history.clone();
    assert_eq!(merged.outside(&theirs), Ok(vec![]));
    let last = first.replace("62.5", "9.0").replace("125", "18");
    assert_eq!(merged.text(), last.replace("from the front", "from behind"));
    assert!(history.undo());
    assert_eq!(history.text(), first);
    assert!(history.undo() && !history.undo());
    assert_eq!(history.text(), TEXT);
    assert!(history.is_saved());
}

#[test]
fn a_step_that_is_abandoned_is_gone_for_good() {
    let mut history = History::new(TEXT);
    history.edit(set("camera.fov_deg", 50.0), Some(1)).unwrap();
    let before = history.text().to_owned();
    assert!(!history.abandon(2), "another gesture has made it");
    history.edit(set("objects.1.scale", 2.0), Some(2)).unwrap();
    history.edit(set("objects.1.scale", 3.0), Some(2)).unwrap();
    assert!(history.abandon(2));
    assert_eq!(history.text(), before);
    assert!(!history.can_redo() && !history.abandon(2));
    // What was done before is still not saved, and still can be undone.
    let mut merged = history.clone();
    let theirs = TEXT.replace("from the front", "from behind");
    assert_eq!(merged.outside(&theirs), Ok(vec![]));
    assert_eq!(merged.text(), theirs.replace("fov_deg: 40", "fov_deg: 50"));
    assert!(history.undo());
    assert_eq!(history.text(), TEXT);
}
