//! What differs between two scenes, value by value: examples in words, and two laws of random edits.

mod told;

use crate::common::{good_scenes, read};
use crate::edits::{Random, edit, reformatted, tree};
use raytoy::edit::Edit;
use raytoy::scene::{Change, ChangeKind, Path, Side, changes};
use told::*;

/// Random edits of scenes, one at a time and several.
const EDITS: usize = 3000;
const TOGETHER: usize = 1500;

const SCENE: &str = include_str!("changes/scene.ron");

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
            Edit::Set { path, .. } | Edit::Add { path, .. } => {
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
    assert!(kinds.iter().all(|n| *n > TOGETHER / 100), "too few of a kind: {kinds:?}");
}

/// The scenes that compile, but for one that is long and says the same forty times.
fn scenes() -> Vec<(String, String)> {
    let names = good_scenes().into_iter().filter(|name| !name.contains("forty"));
    names.map(|name| (name.clone(), read(&name))).collect()
}
