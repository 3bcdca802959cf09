//! `raytoy diff` as an author and a machine see it, and the laws of what it says of values.

mod common;
mod edits;

use std::cmp::Reverse;
use std::io::Write;
use std::process::{Command, Output, Stdio};

use common::{good_scenes, read};
use edits::{Random, at_mut, edit, reformatted, tree};
use raytoy::edit::Edit;
use raytoy::scene::{Change, ChangeKind, Kind, Path, Record, Side, Step, Value, changes};
use tempfile::TempDir;

/// Random edits of scenes, one at a time and several.
const EDITS: usize = 3000;
const TOGETHER: usize = 1500;

const SCENE: &str = "(
    lights: [Point(position: (4, 6, 5)), Directional(direction: (0, -1, 0))],
    textures: { \"tiles\": Checker(scale: 2, odd: Noise(scale: 3)) },
    materials: { \"matte\": (color: \"tiles\"), \"shiny\": (reflectivity: 0.5) },
    objects: [
        Plane(name: \"floor\", material: \"matte\"),
        Sphere(name: \"ball\", center: (0, 1, 0), radius: 1, material: (color: Ramp(by: Noise(), stops: [(0, \"red\"), (1, 0.5)]))),
        Sphere(center: (3, 1, 0)),
        Torus(center: (0, 0.3, 0)),
        Difference(name: \"die\", parts: [
            Union(name: \"body\", parts: [Box(min: (4, 0, 0), max: (5, 1, 1)), Sphere(center: (4, 1, 1))]),
            Sphere(name: \"hole\", center: (4.5, 1, 0.5), radius: 0.2),
        ]),
    ],
)
";

/// Each replacement in [`SCENE`], and what is said of the values, without the lines in the files.
#[test]
fn each_change_is_told_where_it_is() {
    for (replaced, with, told) in [
        ("radius: 1,", "radius: 1.0, // as before\n", ""),
        ("radius: 1,", "radius: Some(1),", ""),
        ("center: (0, 1, 0), radius: 1,", "radius: 1, center: (0, 1, 0),", ""),
        ("    objects", "    /* all */ objects", ""),
        ("radius: 1,", "radius: 1.50,", "objects[\"ball\"].radius: 1 → 1.50"),
        ("radius: 1,", "", "objects[\"ball\"].radius is gone: 1"),
        ("radius: 1,", "radius: 1, scale: 2,", "objects[\"ball\"].scale is new: 2"),
        ("(0, 1, 0), radius", "(0, 1, -2), radius", "objects[\"ball\"].center: (0, 1, 0) → (0, 1, -2)"),
        // By name also where it stands elsewhere, by shape where it has no name.
        ("Torus(", "Sphere(name: \"new\"),\n Torus(", "objects[\"new\"] is new: Sphere(name: \"new\")"),
        ("(3, 1, 0)", "(3, 2, 0)", "objects[2].center: (3, 1, 0) → (3, 2, 0)"),
        (
            "Plane(name: \"floor\", material: \"matte\"),",
            "Box(min: 0, max: 1), Plane(name: \"floor\", material: \"shiny\"), Torus(major_radius: 2),",
            "objects[\"floor\"].material: \"matte\" → \"shiny\"\n\
             objects[0] is new: Box(min: 0, max: 1)\nobjects[2] is new: Torus(major_radius: 2)",
        ),
        (
            "        Sphere(center: (3, 1, 0)),\n        Torus(center: (0, 0.3, 0)),",
            "        Torus(center: (0, 0.3, 0)), Box(min: 0, max: 2), Sphere(center: (3, 1, 0)),",
            "objects[2] moved: objects[2] → objects[4]\nobjects[3] is new: Box(min: 0, max: 2)",
        ),
        ("name: \"ball\"", "name: \"moon\"", "objects[\"ball\"].name: \"ball\" → \"moon\""),
        ("name: \"ball\", ", "", "objects[\"ball\"].name is gone: \"ball\""),
        (
            "Sphere(name: \"ball\", center: (0, 1, 0), radius: 1,",
            "Box(name: \"ball\", min: 0, max: 1,",
            "objects[\"ball\"]: Sphere → Box\nobjects[\"ball\"].center is gone: (0, 1, 0)\n\
             objects[\"ball\"].radius is gone: 1\nobjects[\"ball\"].min is new: 0\n\
             objects[\"ball\"].max is new: 1",
        ),
        // Parts of parts.
        ("radius: 0.2", "radius: 0.3", "objects[\"die\"].parts[\"hole\"].radius: 0.2 → 0.3"),
        ("(4, 1, 1)", "(4, 1, 2)", "objects[\"die\"].parts[\"body\"].parts[1].center: (4, 1, 1) → (4, 1, 2)"),
        (
            "Union(name: \"body\", parts: [",
            "Intersection(name: \"body\", parts: [Torus(), ",
            "objects[\"die\"].parts[\"body\"]: Union → Intersection\n\
             objects[\"die\"].parts[\"body\"].parts[0] is new: Torus()",
        ),
        // Textures, materials, lights.
        ("Noise(scale: 3)", "Noise(scale: 4)", "textures[\"tiles\"].odd.scale: 3 → 4"),
        ("Noise(scale: 3)", "Fbm(scale: 3)", "textures[\"tiles\"].odd: Noise → Fbm"),
        ("Noise(scale: 3)", "Brick()", "textures[\"tiles\"].odd: Noise(scale: 3) → Brick()"),
        ("\"shiny\": (", "\"bright\": (", "materials[\"shiny\"]: \"shiny\" → \"bright\""),
        (
            ", \"shiny\": (reflectivity: 0.5)",
            ", \"dull\": (color: 0.1)",
            "materials[\"shiny\"] is gone: (reflectivity: 0.5)\nmaterials[\"dull\"] is new: (color: 0.1)",
        ),
        (
            "(1, 0.5)",
            "(0.5, \"red\"), (0.75, 0.5)",
            "objects[\"ball\"].material.color.stops[1]: (1, 0.5) → (0.75, 0.5)\n\
             objects[\"ball\"].material.color.stops[1] is new: (0.5, \"red\")",
        ),
        ("Point(position: (4, 6, 5))", "Spot(position: (4, 6, 5))", "lights[0]: Point → Spot"),
        (
            "Point(position: (4, 6, 5)), Directional(direction: (0, -1, 0))",
            "Directional(direction: (0, -1, 0)), Point(position: (4, 6, 5))",
            "lights[0] moved: lights[0] → lights[1]",
        ),
        ("[Point(position: (4, 6, 5)), ", "[", "lights[0] is gone: Point(position: (4, 6, 5))"),
    ] {
        assert_eq!(SCENE.matches(replaced).count(), 1, "{replaced}");
        let new = SCENE.replace(replaced, with);
        let found = changes((&tree(SCENE), SCENE), (&tree(&new), &new));
        let said = found.iter().map(spoken).collect::<Vec<_>>().join("\n");
        assert_eq!(said, told, "{replaced} becomes {with}");
    }
}

/// A change in the words of the command, written down a second time.
fn spoken(change: &Change) -> String {
    let words = |side: &Option<Side>| side.as_ref().expect("it has this side").words.clone();
    let place = |side: &Option<Side>| side.as_ref().expect("it has this side").path.to_string();
    let path = &change.path;
    match change.kind {
        ChangeKind::New => format!("{path} is new: {}", words(&change.new)),
        ChangeKind::Gone => format!("{path} is gone: {}", words(&change.old)),
        ChangeKind::Changed | ChangeKind::Renamed => {
            format!("{path}: {} → {}", words(&change.old), words(&change.new))
        }
        ChangeKind::Moved => format!("{path} moved: {} → {}", place(&change.old), place(&change.new)),
    }
}

#[test]
fn hundreds_of_things_without_names_are_found_again() {
    let text = |radius: f32, first: &str| {
        let spheres = (0..600).map(|i| format!("Sphere(radius: {})", i as f32 + radius));
        format!("(objects: [{first}{}])", spheres.collect::<Vec<_>>().join(", "))
    };
    let (old, new) = (text(0.25, ""), text(0.75, "Box(), "));
    let found = changes((&tree(&old), &old), (&tree(&new), &new));
    let count = |kind| found.iter().filter(|change| change.kind == kind).count();
    assert_eq!((count(ChangeKind::Changed), count(ChangeKind::New), found.len()), (600, 1, 601));
    assert_eq!(spoken(&found[599]), "objects[599].radius: 599.25 → 599.75");
}

#[test]
fn one_edit_is_told_at_its_path_and_nowhere_else() {
    let scenes = scenes();
    let mut random = Random(23);
    let mut told = [0; 4];
    for number in 0..EDITS {
        let (name, original) = &scenes[random.below(scenes.len())];
        let text = reformatted(&mut random, original);
        let root = tree(&text);
        let edit = edit(&mut random, &root);
        if doubles_a_field(&edit) {
            continue;
        }
        let Ok(edited) = edit.on(&text) else { continue };
        let new = edited.apply(&text);
        let after = tree(&new);
        let found = changes((&root, &text), (&after, &new));
        let story = || format!("edit {number} of {name}: {edit:?}\n{found:#?}\n{text}\nto\n{new}");
        if after.says_the_same_as(&root) {
            assert!(found.is_empty(), "{}", story());
            continue;
        }
        assert!(!found.is_empty(), "{}", story());
        let is_at = |change: &Change, path: &Path| {
            [&change.old, &change.new].into_iter().flatten().all(|side| is_told_at(&root, &side.path, path))
        };
        let only = |kind: ChangeKind| found.len() == 1 && found[0].kind == kind;
        match &edit {
            Edit::Set { path, .. } => {
                let added = first_missing(&root, path);
                let is_new = added.as_ref().is_none_or(|_| only(ChangeKind::New));
                let path = added.as_ref().unwrap_or(path);
                assert!(is_new && found.iter().all(|change| is_at(change, path)), "{}", story());
                told[usize::from(added.is_some())] += 1;
            }
            Edit::Remove { path } => {
                let is_one = only(ChangeKind::Gone) || is_told_whole(&root, &found, path);
                assert!(is_one && is_its_like(&root, &found[0].old, path), "{}", story());
                told[2] += 1;
            }
            Edit::Insert { .. } | Edit::Duplicate { .. } => {
                let list = match &edit {
                    Edit::Insert { list, .. } => list.clone(),
                    Edit::Duplicate { path } => path.split().expect("the root is none").0,
                    _ => unreachable!("no other comes here"),
                };
                let parent = |side: &Side| side.path.split().map(|(parent, _)| parent);
                let is_there = found[0].new.as_ref().and_then(parent) == Some(list);
                assert!(only(ChangeKind::New) && is_there, "{}", story());
                told[3] += 1;
            }
            Edit::Rename { .. } => panic!("none of these is made"),
        }
    }
    eprintln!("{told:?} set, added, removed, put in");
    assert!(told.iter().all(|n| *n > EDITS / 100), "too few of a kind: {told:?}");
}

/// No scene has a field twice, but RON may.
fn doubles_a_field(edit: &Edit) -> bool {
    matches!(edit, Edit::Duplicate { path } if matches!(path.0.last(), Some(Step::Field(_))))
}

/// Whether a change at `told` is one of what is at `path`: there, inside, or a value around it that is told
/// as one: a vector, or `Gamma(2.0)`.
fn is_told_at(root: &Value, told: &Path, path: &Path) -> bool {
    let is_inside = told.0.starts_with(&path.0);
    let is_around = path.split().is_some_and(|(group, _)| group == *told)
        && root.at(told).is_some_and(|group| match &group.kind {
            Kind::Tuple(_) => true,
            Kind::Record(record) => !record.items.is_empty(),
            _ => false,
        });
    is_inside || is_around
}

fn is_told_whole(root: &Value, found: &[Change], path: &Path) -> bool {
    let [Change { kind: ChangeKind::Changed, old: Some(side), .. }] = found else { return false };
    side.path != *path && is_told_at(root, &side.path, path)
}

/// Whether `side` is what is at `path`, or one of its list that says the same, or is told whole around it.
fn is_its_like(root: &Value, side: &Option<Side>, path: &Path) -> bool {
    let Some(side) = side else { return false };
    let same = match (root.at(&side.path), root.at(path)) {
        (Some(a), Some(b)) => a.says_the_same_as(b),
        _ => false,
    };
    let parent = |path: &Path| path.split().map(|(parent, _)| parent);
    is_told_at(root, &side.path, path) || same && parent(&side.path) == parent(path)
}

/// The shortest beginning of `path` that leads nowhere, if there is one.
fn first_missing(root: &Value, path: &Path) -> Option<Path> {
    let mut beginnings = (1..=path.0.len()).map(|n| Path(path.0[..n].to_vec()));
    beginnings.find(|beginning| root.at(beginning).is_none())
}

#[test]
fn what_is_not_told_says_the_same() {
    let scenes = scenes();
    let mut random = Random(29);
    let mut kinds = [0; 5];
    for number in 0..TOGETHER {
        let (name, text) = &scenes[random.below(scenes.len())];
        let mut new = text.clone();
        for _ in 0..1 + random.below(6) {
            let root = tree(&new);
            match random.below(4) {
                0 => new = with_an_item_moved(&mut random, &root, &new),
                1 => new = with_another_name(&mut random, &root, &new),
                _ => {
                    let edit = edit(&mut random, &root);
                    let is_fit = !doubles_a_field(&edit);
                    new = edit.on(&new).ok().filter(|_| is_fit).map_or(new.clone(), |edit| edit.apply(&new));
                }
            }
        }
        if number % 5 == 0 {
            new = scenes[random.below(scenes.len())].1.clone();
        }
        let (root, after) = (tree(text), tree(&new));
        let found = changes((&root, text), (&after, &new));
        let story = || format!("{number}, {name}: {found:#?}\n{text}\nto\n{new}");
        let [old_rest, new_rest] =
            [(&root, 0), (&after, 1)].map(|(root, side)| sorted(&erased(root, &found, side)));
        assert!(old_rest.says_the_same_as(&new_rest), "{}", story());
        for change in &found {
            kinds[change.kind as usize] += 1;
            for (side, root, text) in [(&change.old, &root, text), (&change.new, &after, &new)] {
                let Some(side) = side else { continue };
                let value =
                    root.at(&side.path).unwrap_or_else(|| panic!("{change:?} is nowhere; {}", story()));
                let says = || tree(&side.words).says_the_same_as(value);
                assert!(change.kind == ChangeKind::Renamed || says(), "{change:?}; {}", story());
                assert!(side.line <= text.lines().count().max(1), "{change:?}; {}", story());
            }
        }
    }
    eprintln!("{kinds:?} new, gone, changed, renamed, moved");
    assert!(kinds.iter().all(|n| *n > TOGETHER / 50), "too few of a kind: {kinds:?}");
}

/// `text` with an item of one of its lists taken elsewhere in it.
fn with_an_item_moved(random: &mut Random, root: &Value, text: &str) -> String {
    let is_item = |path: &Path| {
        let list = path.split().and_then(|(list, _)| root.at(&list));
        list.is_some_and(|list| matches!(&list.kind, Kind::List(items) if items.len() > 1))
    };
    let items: Vec<Path> = edits::paths(root).into_iter().filter(is_item).collect();
    let Some(path) = items.get(random.below(items.len())).cloned() else { return text.to_owned() };
    let item = text[root.at(&path).expect("it was found there").whole.clone()].to_owned();
    let removed = Edit::Remove { path: path.clone() }.on(text).expect("lists let go of items").apply(text);
    let (list, _) = path.split().expect("it is in a list");
    let insert = Edit::Insert { list, index: random.below(8), item };
    insert.on(&removed).expect("lists take items").apply(&removed)
}

/// `text` with another `Name` on one of its values.
fn with_another_name(random: &mut Random, root: &Value, text: &str) -> String {
    let fields = |path: &Path| match &root.at(path)?.kind {
        Kind::Record(Record { name: Some(_), fields, .. }) => Some(fields),
        _ => None,
    };
    let named: Vec<Path> = edits::paths(root).into_iter().filter(|path| fields(path).is_some()).collect();
    let Some(path) = named.get(random.below(named.len())).cloned() else { return text.to_owned() };
    let keep = fields(&path).expect("it has a name").iter().map(|field| field.name.text.clone()).collect();
    let edit = Edit::Rename { path, name: "Another".into(), keep };
    edit.on(text).expect("what has a name takes another").apply(text)
}

/// `root` without all that `changes` name in it: as the old scene (0) or as the new one (1).
fn erased(root: &Value, changes: &[Change], side: usize) -> Value {
    let mut root = root.clone();
    let mut named: Vec<(&Side, ChangeKind)> = changes
        .iter()
        .filter_map(|change| Some(([&change.old, &change.new][side].as_ref()?, change.kind)))
        .collect();
    // From the end and from the inside, so that all paths hold until they are used.
    named.sort_by_key(|(side, kind)| (Reverse(&side.path), *kind == ChangeKind::Moved));
    for (Side { path, words, .. }, kind) in named {
        let is_key = words.starts_with('"');
        match kind {
            ChangeKind::Changed => at_mut(&mut root, path).expect("it is there").kind = Kind::None,
            ChangeKind::Renamed if !is_key => {
                let value = at_mut(&mut root, path).expect("it is there");
                let Kind::Record(Record { name, .. }) = &mut value.kind else { panic!("{path} has no name") };
                *name = None;
            }
            _ => root = edits::without(&root, path),
        }
    }
    root
}

/// `value` with all fields in the order of their names.
fn sorted(value: &Value) -> Value {
    let mut value = value.clone();
    match &mut value.kind {
        Kind::Record(Record { fields, items, .. }) => {
            fields.sort_by(|a, b| a.name.text.cmp(&b.name.text));
            fields.iter_mut().for_each(|field| field.value = sorted(&field.value));
            items.iter_mut().for_each(|item| *item = sorted(item));
        }
        Kind::Map(fields) => {
            fields.sort_by(|a, b| a.name.text.cmp(&b.name.text));
            fields.iter_mut().for_each(|field| field.value = sorted(&field.value));
        }
        Kind::Tuple(items) | Kind::List(items) => items.iter_mut().for_each(|item| *item = sorted(item)),
        _ => {}
    }
    value
}

/// The scenes that compile, but for one that is long and says the same forty times.
fn scenes() -> Vec<(String, String)> {
    let names = good_scenes().into_iter().filter(|name| !name.contains("forty"));
    names.map(|name| (name.clone(), read(&name))).collect()
}

#[test]
fn the_whole_text_for_people() {
    let folder = Folder::new();
    folder.write("old.ron", SCENE);
    let new = SCENE
        .replace("radius: 1,", "radius: 1.5,")
        .replace("        Torus(", "\n        Torus(name: \"ring\", ");
    folder.write("new.ron", &new);
    let told = folder.diff(&["old.ron", "new.ron", "--no-picture"]);
    let said = stdout(&told);
    let (values, shader) = said.split_once("shader ").expect("there is a line on the shader");
    assert_eq!(
        values,
        "values   2 values differ\n  objects[\"ball\"].radius: 1 → 1.5  (old.ron:7 → new.ron:7)\n  \
         objects[3].name is new: \"ring\"  (new.ron:10)\n"
    );
    let lines: Vec<&str> = shader.lines().collect();
    assert!(lines[0].ends_with("; the window needs another pipeline"), "{said}");
    for line in [
        "  the object \"Torus 3\" is gone",
        "  the object \"ring\" is new",
        "  the object \"ball\" moved or changed",
        "  -const OBJECT_TORUS_3: u32 = 3u;",
        "  +const OBJECT_RING: u32 = 3u;",
    ] {
        assert!(lines.contains(&line), "{line}\n\nis not in\n\n{said}");
    }
    assert!(lines.last().is_some_and(|l| l.ends_with("more lines: `--report diff.html` has them")), "{said}");
    assert_eq!((told.status.code(), stderr(&told)), (Some(0), String::new()));
    let same = folder.diff(&["old.ron", "./old.ron", "--no-picture", "--exit-code"]);
    assert_eq!(
        (stdout(&same).as_str(), same.status.code()),
        ("values   the same\nshader   the same\n", Some(0))
    );
}

#[test]
fn numbers_alone_need_no_other_pipeline() {
    let folder = Folder::new();
    folder.write("old.ron", "(objects: [Sphere(name: \"ball\", radius: 2)])");
    let first_lines = |new: &str| {
        folder.write("new.ron", new);
        let told = stdout(&folder.diff(&["old.ron", "new.ron", "--no-picture"]));
        told.lines().filter(|line| !line.starts_with(' ')).collect::<Vec<_>>().join("\n")
    };
    let number = first_lines("(objects: [Sphere(name: \"ball\", radius: 3)])");
    let kept = "lines gone, 4 new; only numbers and comments differ, so the window keeps its pipeline";
    assert_eq!(number, format!("values   1 value differs\nshader   4 {kept}"));
    let camera = first_lines("(camera: (fov_deg: 30), objects: [Sphere(name: \"ball\", radius: 2)])");
    assert_eq!(camera, "values   1 value differs\nshader   the same");
    let structure = first_lines("(objects: [Sphere(name: \"ball\", radius: 2, rotate_deg: (0, 10, 0))])");
    assert!(structure.ends_with("; the window needs another pipeline"), "{structure}");
}

#[test]
fn files_that_hold_something_else_are_named() {
    let folder = Folder::new();
    let pond = "/// Waves.\nfn pond(at: Surface) -> f32 {\n    return fract(at.uv.x);\n}\n";
    for (place, text) in [("a", pond.to_owned()), ("b", pond.replace("uv.x", "uv.y"))] {
        folder.write(&format!("{place}/scene.ron"), "(objects: [Sphere(material: (color: Pond()))])");
        folder.write(&format!("{place}/textures/pond.wgsl"), &text);
    }
    let told = folder.diff(&["a/scene.ron", "b/scene.ron", "--no-picture", "--exit-code"]);
    assert_eq!(
        stdout(&told),
        "values   the same\nshader   the scene's own text is the same\n  \
         the file `b/textures/pond.wgsl` holds something else\n"
    );
    assert_eq!(told.status.code(), Some(1));
    // Standard input is taken as if it lay beside the other scene, whose textures it finds.
    let piped =
        folder.piped(&["-", "a/scene.ron", "--no-picture", "--exit-code"], &folder.read("a/scene.ron"));
    assert_eq!(
        (stdout(&piped).as_str(), piped.status.code()),
        ("values   the same\nshader   the same\n", Some(0))
    );
}

#[test]
fn programs_get_all_of_it() {
    let folder = Folder::new();
    folder.write("old.ron", SCENE);
    folder.write(
        "new.ron",
        &SCENE.replace("\n        Plane(", "\n        Torus(),\n        Plane(").replace("0.2", "0.25"),
    );
    let told = folder.diff(&["old.ron", "new.ron", "--no-picture", "--format", "json"]);
    let json: serde_json::Value = serde_json::from_str(&stdout(&told)).expect("it is JSON");
    assert_eq!(
        (&json["same"], &json["old"], &json["new"]),
        (&false.into(), &"old.ron".into(), &"new.ron".into())
    );
    assert_eq!(
        json["values"],
        serde_json::json!([
            {
                "path": "objects[\"die\"].parts[\"hole\"].radius",
                "kind": "changed",
                "old": { "path": "objects[4].parts[1].radius", "line": 12, "words": "0.2" },
                "new": { "path": "objects[5].parts[1].radius", "line": 13, "words": "0.25" },
            },
            { "path": "objects[0]", "kind": "new", "new": { "path": "objects[0]", "line": 6, "words": "Torus()" } },
        ])
    );
    let shader = &json["shader"];
    assert_eq!((&shader["same"], &shader["same_live"]), (&false.into(), &false.into()));
    assert_eq!(shader["objects_new"], serde_json::json!(["Sphere 3", "Torus 0", "Torus 4"]));
    let diff = shader["diff"].as_array().expect("it is a list");
    assert!(diff.len() > 40 && diff[0].as_str().is_some_and(|line| line.starts_with("@@ -")), "{diff:?}");
    assert!(json.get("picture").is_none());
}

#[test]
fn exit_codes_and_wrong_calls() {
    let folder = Folder::new();
    folder.write("a.ron", "(objects: [Sphere()])");
    folder.write("b.ron", "(objects: [Sphere(radius: 2)])");
    folder.write("wrong.ron", "(objects: [Spere()])");
    folder.write("plain.png", "\u{89}PNG");
    std::fs::write(folder.0.path().join("cut.png"), b"\x89PNG\r\n\x1a\n").expect("it is writable");
    let code = |arguments: &[&str]| folder.diff(&[arguments, &["--no-picture"]].concat()).status.code();
    assert_eq!(code(&["a.ron", "a.ron", "--exit-code"]), Some(0));
    assert_eq!(code(&["a.ron", "b.ron"]), Some(0));
    assert_eq!(code(&["a.ron", "b.ron", "--exit-code"]), Some(1));
    assert_eq!(code(&["a.ron", "wrong.ron"]), Some(1));
    assert_eq!(code(&["wrong.ron", "wrong.ron", "--exit-code"]), Some(2));
    for (call, why) in [
        (&["a.ron", "nothing.ron"][..], "raytoy: there is no file `nothing.ron`\n"),
        (&["-", "-"], "raytoy: only one of the two scenes can come by standard input\n"),
        (&["a.ron", "cut.png"], "raytoy: cannot read `cut.png` as a PNG file: "),
        (&["a.ron", "b.ron", "--format", "junit"], "error: invalid value 'junit'"),
        (&["a.ron"], "error: the following required arguments"),
        (&["a.ron", "b.ron", "--samples", "0"], "error: invalid value '0'"),
    ] {
        let refused = folder.diff(&[call, &["--no-picture"]].concat());
        assert_eq!((refused.status.code(), stdout(&refused)), (Some(2), String::new()), "{call:?}");
        assert!(stderr(&refused).starts_with(why), "{call:?}: {}", stderr(&refused));
    }
    let both = folder.diff(&["wrong.ron", "plain.png", "--no-picture"]);
    assert!(
        stderr(&both).contains("did you mean `Sphere`?") && stderr(&both).contains("plain.png"),
        "{both:?}"
    );
}

#[test]
fn pictures_are_judged_and_shown_on_a_page() {
    if common::gpu().is_none() {
        return;
    }
    let folder = Folder::new();
    let scene = "(lights: [Point(position: (4, 6, 5))], objects: [Plane(name: \"floor\"), Sphere(name: \"<ball>\", center: (0, 1, 0))])";
    folder.write("old.ron", scene);
    folder.write("new.ron", &scene.replace("(0, 1, 0)", "(0, 1, 0), radius: 0.8"));
    let small = ["--adapter", "software", "--size", "96x54", "--samples", "1"];
    let diff = |arguments: &[&str]| folder.diff(&[arguments, &small].concat());
    let told = diff(&["old.ron", "new.ron", "--report", "out.html"]);
    let said = stdout(&told);
    for line in [
        "picture  looks different\n",
        " pixels (",
        "FLIP sees ",
        "; there was \"<ball>\" ",
        "; there is now \"<ball>\" ",
    ] {
        assert!(said.contains(line), "{line}\n\nis not in\n\n{said}");
    }
    assert!(stderr(&told).ends_with("The report is out.html.\n"), "{}", stderr(&told));
    let page = folder.read("out.html");
    assert_eq!(page.matches("src=\"data:image/png;base64,").count(), 5, "both twice, and what differs");
    for part in [
        "<h1>old.ron → new.ron</h1>",
        "type=\"range\"",
        "alt=\"old.ron\"",
        "<td><code>objects[&quot;&lt;ball&gt;&quot;].radius</code></td><td></td><td><ins>0.8</ins></td><td>new.ron:1</td>",
        "<h2>Shader</h2>",
        "<ins>+",
    ] {
        assert!(page.contains(part), "{part}");
    }
    assert!(!page.contains("http:") && !page.contains("https:") && !page.contains("<ball>"));
    let json = stdout(&diff(&["old.ron", "new.ron", "--format", "json"]));
    let json: serde_json::Value = serde_json::from_str(&json).expect("it is JSON");
    let picture = &json["picture"];
    assert_eq!((&picture["same"], &picture["looks_the_same"]), (&false.into(), &false.into()));
    let share = picture["objects_before"][0]["share"].as_f64();
    assert!(share.is_some_and(|share| share > 0.5 && share <= 1.0), "{picture}");
    assert!(picture["area"].as_array().is_some_and(|area| area.len() == 4) && picture["adapter"].is_string());
    let same = diff(&["old.ron", "old.ron", "--exit-code"]);
    assert_eq!(stdout(&same), "values   the same\nshader   the same\npicture  the same\n");
    assert_eq!(same.status.code(), Some(0));
    // What is hidden changes values alone.
    folder
        .write("hidden.ron", &scene.replace("Plane(", "Sphere(name: \"under\", center: (0, -9, 0)), Plane("));
    assert!(stdout(&diff(&["old.ron", "hidden.ron"])).ends_with("\npicture  the same\n"));
}

#[test]
fn a_picture_stands_for_its_scene() {
    if common::gpu().is_none() {
        return;
    }
    let folder = Folder::new();
    folder.write("ball.ron", "(objects: [Sphere(radius: 2)])");
    let render = ["render", "ball.ron", "-o", "ball.png", "--size", "16x9", "--adapter", "software"];
    assert!(folder.run(&render).status.success());
    folder.write("ball.ron", "(objects: [Sphere(radius: 3)])");
    let told = folder.diff(&["ball.png", "ball.ron", "--no-picture"]);
    let line = "  objects[0].radius: 2 → 3  (ball.png:1 → ball.ron:1)\n";
    assert!(stdout(&told).starts_with(&format!("values   1 value differs\n{line}")), "{}", stdout(&told));
}

/// A folder of its own for scenes.
struct Folder(TempDir);

impl Folder {
    fn new() -> Self {
        Self(tempfile::tempdir().expect("a temporary folder"))
    }

    fn write(&self, name: &str, text: &str) {
        let path = self.0.path().join(name);
        std::fs::create_dir_all(path.parent().expect("it is in a folder")).expect("it is writable");
        std::fs::write(path, text).expect("it is writable");
    }

    fn read(&self, name: &str) -> String {
        std::fs::read_to_string(self.0.path().join(name)).expect("it is there")
    }

    fn command(&self, arguments: &[&str]) -> Command {
        let mut command = Command::new(env!("CARGO_BIN_EXE_raytoy"));
        command.current_dir(self.0.path()).args(arguments).stdin(Stdio::null());
        command
    }

    fn run(&self, arguments: &[&str]) -> Output {
        self.command(arguments).output().expect("raytoy runs")
    }

    fn diff(&self, arguments: &[&str]) -> Output {
        self.run(&[&["diff"], arguments].concat())
    }

    /// The same, with `input` at standard input.
    fn piped(&self, arguments: &[&str], input: &str) -> Output {
        let mut command = self.command(&[&["diff"], arguments].concat());
        let streams = command.stdin(Stdio::piped()).stdout(Stdio::piped()).stderr(Stdio::piped());
        let mut child = streams.spawn().expect("raytoy runs");
        let mut stdin = child.stdin.take().expect("it is piped");
        stdin.write_all(input.as_bytes()).expect("raytoy reads");
        drop(stdin);
        child.wait_with_output().expect("raytoy ends")
    }
}

fn stdout(output: &Output) -> String {
    String::from_utf8_lossy(&output.stdout).into_owned()
}

fn stderr(output: &Output) -> String {
    String::from_utf8_lossy(&output.stderr).into_owned()
}
