//! The tree: what is in it, what can be chosen, added and taken away.

use egui::accesskit::Role;
use egui::{Key, Modifiers};
use egui_kittest::kittest::{NodeT, Queryable};

use super::SCENE;
use super::harness::{Studio, is};

/// The lines of the tree, each as far in as it lies deep.
fn tree(studio: &Studio) -> Vec<String> {
    let all = studio.harness.query_all_by_role(Role::TreeItem);
    let line = |own: egui_kittest::kittest::AccessKitNode<'_>| {
        let deep = own.data().level().expect("each line has a depth") - 1;
        format!("{}{}", "  ".repeat(deep), own.label().expect("each line has a name"))
    };
    all.map(|node| line(node.accesskit_node())).collect()
}

/// What of the tree is said to be chosen.
fn chosen(studio: &Studio) -> Vec<String> {
    let all = studio.harness.query_all_by_role(Role::TreeItem);
    let all = all.map(|node| node.accesskit_node()).filter(|own| own.is_selected() == Some(true));
    all.filter_map(|own| own.label()).collect()
}

#[test]
fn the_tree_has_all_that_the_scene_has() {
    let studio = Studio::open(SCENE);
    let expected = [
        "camera",
        "background",
        "ambient",
        "lights",
        "  Point 0",
        "textures",
        "  tiles",
        "materials",
        "  gold",
        "  clay",
        "objects",
        "  ball",
        "  block",
        "  floor",
        "  both",
        "    both Sphere 0",
        "    both Box 1",
        "render",
    ];
    assert_eq!(tree(&studio), expected);
    assert!(chosen(&studio).is_empty());
    assert!(studio.says("Choose a line of the tree to see its values."));
}

#[test]
fn what_is_chosen_shows_its_values_and_escape_lets_it_go() {
    let mut studio = Studio::open(SCENE);
    studio.choose("ball");
    assert_eq!(chosen(&studio), ["ball"]);
    assert!(studio.says("A ball"));
    studio.choose("Point 0");
    assert_eq!(chosen(&studio), ["Point 0"]);
    assert!(!studio.has(Role::Group, "ball") && studio.has(Role::Group, "Point 0"));
    assert_eq!(studio.find(Role::ComboBox, "kind").value().as_deref(), Some("Point"));
    studio.key(Modifiers::NONE, Key::Escape);
    assert!(chosen(&studio).is_empty() && !studio.has(Role::Group, "Point 0"));
}

#[test]
fn a_line_is_chosen_without_a_mouse() {
    let mut studio = Studio::open(SCENE);
    studio.find(Role::TreeItem, "block").focus();
    studio.settle();
    studio.key(Modifiers::NONE, Key::Space);
    assert_eq!(chosen(&studio), ["block"]);
}

#[test]
fn a_branch_closes_and_opens_and_a_search_leaves_what_fits() {
    let mut studio = Studio::open(SCENE);
    let all = tree(&studio);
    studio.click(Role::DisclosureTriangle, "close objects");
    assert!(!studio.has(Role::TreeItem, "ball") && studio.has(Role::TreeItem, "render"));
    studio.click(Role::DisclosureTriangle, "open objects");
    assert_eq!(tree(&studio), all);
    studio.click(Role::TextInput, "find in the scene");
    studio.type_text("BOX");
    // By what it is, or by its name.
    assert_eq!(tree(&studio), ["objects", "  block", "  both", "    both Box 1"]);
}

#[test]
fn a_thing_is_added_and_chosen_at_once() {
    let mut studio = Studio::open(SCENE);
    studio.pick((Role::Button, "add to objects"), "Torus");
    let text = studio.text();
    let added = text.lines().rev().nth(2).expect("it stands at the end");
    assert!(added.trim_start().starts_with("Torus("), "{text}");
    assert_eq!(text.replace(&format!("{added}\n"), ""), SCENE);
    assert_eq!(chosen(&studio), ["Torus 4"]);
    assert!(studio.has(Role::SpinButton, "minor_radius"));
    studio.pick((Role::Button, "add to lights"), "Directional");
    assert_eq!(chosen(&studio), ["Directional 1"]);
}

#[test]
fn a_thing_becomes_another_one_and_keeps_what_both_have() {
    let mut studio = Studio::open(SCENE);
    studio.choose("ball");
    studio.pick((Role::ComboBox, "kind"), "Torus");
    let text = studio.text();
    let changed =
        SCENE.replace("Sphere(name: \"ball\", radius: 1 /* one */,", "Torus(name: \"ball\", /* one */");
    assert_eq!(text, changed, "the comment stays, and so does the material");
    assert!(studio.has(Role::SpinButton, "major_radius") && !studio.has(Role::Alert, "mistakes"));
    // Parts of a solid stay where the new one has some, too.
    studio.choose("both");
    studio.pick((Role::ComboBox, "kind"), "Intersection");
    assert_eq!(studio.text(), changed.replace("Union(", "Intersection("));
    studio.choose("both Box 1");
    studio.pick((Role::ComboBox, "kind"), "Sphere");
    assert!(studio.text().contains("Sphere(center: (0, 45, 0))])"), "{}", studio.text());
}

/// What the only object of a scene becomes.
fn become_one(object: &str, kind: &str) -> String {
    let mut studio = Studio::open(&format!("(objects: [{object}])\n"));
    studio.choose(tree(&studio)[7].trim());
    studio.pick((Role::ComboBox, "kind"), kind);
    assert!(!studio.has(Role::Alert, "mistakes"), "{object} as {kind}: {}", studio.text());
    let text = studio.text();
    studio.key(Modifiers::COMMAND, Key::Z);
    assert_eq!(studio.text(), format!("(objects: [{object}])\n"), "it is one step");
    text.trim_start_matches("(objects: [").trim_end().strip_suffix("])").expect("it ends so").to_owned()
}

#[test]
fn another_shape_stands_where_the_one_before_stood() {
    for (object, kind, new) in [
        (
            "Sphere(center: (0, 1, 0), radius: 2, material: (color: 0.5))",
            "Cone",
            "Cone(base: (0, 0.5, 0), top: (0, 1.5, 0), material: (color: 0.5))",
        ),
        ("Sphere(center: (3, 1, 0), radius: 2)", "Torus", "Torus(center: (3, 1, 0))"),
        (
            "Sphere(center: (3, 1, 0), radius: 2)",
            "Capsule",
            "Capsule(base: (3, 0.5, 0), top: (3, 1.5, 0), radius: 2)",
        ),
        ("Cylinder(base: (1, 0, 0), radius: 2)", "Cone", "Cone(base: (1, 0, 0))"),
        ("Box(min: (0, 0, 0), max: (4, 2, 2))", "Sphere", "Sphere(center: (2, 1, 1))"),
        ("Sphere(center: (0, 1, 0), scale: 2)", "Plane", "Plane(translate: (0, 2, 0), scale: 2)"),
        ("Plane(offset: 2, translate: (1, 2, 3))", "Sphere", "Sphere(translate: (1, 2, 3))"),
        ("Sphere(radius: 2)", "Cone", "Cone()"),
    ] {
        assert_eq!(become_one(object, kind), new);
    }
    // What must be given is there.
    assert!(become_one("Sphere(center: (0, 5, 0))", "Triangle").starts_with("Triangle(a: ("));
    assert_eq!(become_one("Sphere(radius: 2)", "Union"), "Union(parts: [Box(), Sphere()])");
}

#[test]
fn a_model_is_one_that_is_there() {
    let scene = "(objects: [Sphere()])\n";
    let mut studio = Studio::open(scene);
    studio.pick((Role::Button, "add to objects"), "Mesh");
    assert_eq!(studio.text(), scene);
    assert!(studio.says("Mesh shows a model: put a file (.obj, .glb, .gltf) into the scene's folder first"));
    studio.choose(tree(&studio)[7].trim());
    studio.pick((Role::ComboBox, "kind"), "Mesh");
    assert_eq!(studio.text(), scene);
    let cube = "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n";
    let mut studio =
        Studio::open_among(&[("scene.ron", scene), ("models/a/one.obj", cube)], Default::default());
    studio.pick((Role::Button, "add to objects"), "Mesh");
    assert_eq!(studio.text(), "(objects: [Sphere(), Mesh(file: \"models/a/one.obj\")])\n");
    assert!(!studio.has(Role::Alert, "mistakes"));
}

#[test]
fn all_that_can_be_added_makes_a_scene_without_mistakes() {
    let cube = "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n";
    let files = [("scene.ron", "(objects: [Sphere()])\n"), ("a.obj", cube)];
    let mut studio = Studio::open_among(&files, Default::default());
    for menu in ["add to objects", "add to lights"] {
        studio.press(menu);
        let items = studio.find(Role::Button, menu);
        let names: Vec<String> = studio.lines(&items).into_iter().collect();
        studio.key(Modifiers::NONE, Key::Escape);
        for name in names.iter().filter_map(|line| line.strip_prefix("Button ")) {
            studio.pick((Role::Button, menu), name);
            assert!(!studio.has(Role::Alert, "mistakes"), "{name}: {}", studio.text());
            studio.key(Modifiers::COMMAND, Key::Z);
        }
        assert!(names.len() > 3, "{names:?}");
    }
}

#[test]
fn what_is_used_is_written_out_where_it_goes() {
    let text = r#"(
    textures: { "stone": Noise(scale: 3), "wall": Brick(joint: "stone") },
    materials: { "stone": (color: "stone"), "spare": (color: 0.5) },
    objects: [Sphere(material: "stone"), Box(material: (color: "stone", specular: "stone"))],
)
"#;
    let removed = |at: usize, item: &str| {
        let mut studio = Studio::open(text);
        studio.harness.query_all_by_role(Role::TreeItem).nth(at).expect("it is there").click_secondary();
        studio.leave();
        studio.harness.get_by(is(Role::Button, item)).click();
        studio.leave();
        assert!(!studio.has(Role::Alert, "mistakes"), "{}", studio.text());
        let removed = studio.text();
        studio.key(Modifiers::COMMAND, Key::Z);
        assert_eq!(studio.text(), text, "it is one step");
        removed
    };
    let texture = removed(5, "Remove, and write its value in 4 places");
    let expected = text
        .replace("\"stone\": Noise(scale: 3), ", "")
        .replace("color: \"stone\"", "color: Noise(scale: 3)");
    let expected = expected.replace("joint: \"stone\"", "joint: Noise(scale: 3)");
    assert_eq!(texture, expected.replace("specular: \"stone\"", "specular: Noise(scale: 3)"));
    let material = removed(8, "Remove, and write its value where it is used");
    let expected = text.replace("\"stone\": (color: \"stone\"), ", "");
    assert_eq!(material, expected.replace("material: \"stone\"", "material: (color: \"stone\")"));
    assert_eq!(removed(9, "Remove"), text.replace(", \"spare\": (color: 0.5)", ""));
}

#[test]
fn the_choice_goes_with_what_was_chosen() {
    let mut studio = Studio::open(SCENE);
    studio.choose("block");
    studio.pick((Role::Button, "add to objects"), "Torus");
    assert_eq!(chosen(&studio), ["Torus 4"]);
    studio.key(Modifiers::COMMAND, Key::Z);
    assert_eq!(chosen(&studio), ["block"]);
    let menu = |studio: &mut Studio, line: &str, item: &str| {
        studio.find(Role::TreeItem, line).click_secondary();
        studio.leave();
        studio.harness.get_by(is(Role::Button, item)).click();
        studio.leave();
    };
    menu(&mut studio, "ball", "Duplicate");
    assert_eq!(chosen(&studio), ["ball 2"]);
    studio.choose("floor");
    menu(&mut studio, "ball", "Remove");
    assert_eq!(chosen(&studio), ["floor"]);
    studio.key(Modifiers::COMMAND, Key::Z);
    studio.key(Modifiers::COMMAND, Key::Z);
    assert_eq!(chosen(&studio), ["floor"]);
    studio.save(
        &SCENE.replace("        Sphere(name: \"ball\"", "        Disk(),\n        Sphere(name: \"ball\""),
    );
    assert_eq!(chosen(&studio), ["floor"]);
    menu(&mut studio, "gold", "Duplicate");
    assert_eq!(chosen(&studio), ["gold 2"]);
    menu(&mut studio, "gold 2", "Remove");
    assert!(chosen(&studio) != ["clay"]);
}

#[test]
fn the_menu_of_a_line_duplicates_and_removes() {
    let mut studio = Studio::open(SCENE);
    let menu = |studio: &mut Studio, item: &str| {
        studio.find(Role::TreeItem, "block").click_secondary();
        studio.leave();
        studio.harness.get_by(is(Role::Button, item)).click();
        studio.leave();
    };
    menu(&mut studio, "Duplicate");
    let block = "        Box(name: \"block\", min: (-2, 0, 0), material: \"gold\"),\n";
    let blocks = |studio: &Studio| tree(studio).iter().filter(|line| line.contains("block")).count();
    assert_eq!(blocks(&studio), 2, "{}", studio.text());
    studio.key(Modifiers::COMMAND, Key::Z);
    assert_eq!(studio.text(), SCENE);
    menu(&mut studio, "Remove");
    assert_eq!(studio.text(), SCENE.replace(block, ""));
    assert_eq!(blocks(&studio), 0);
}

#[test]
fn the_last_part_of_a_solid_takes_the_solid_along() {
    let text = "(objects: [\n    Sphere(name: \"ball\"),\n    Union(name: \"pair\", parts: [\n        \
                Difference(name: \"cup\", parts: [Box(name: \"cube\"), Torus(name: \"ring\")]),\n    ]),\n])";
    let mut studio = Studio::open(text);
    let menu = |studio: &mut Studio, line: &str, item: &str| {
        studio.find(Role::TreeItem, line).click_secondary();
        studio.leave();
        studio.harness.get_by(is(Role::Button, item)).click();
        studio.leave();
    };
    menu(&mut studio, "ring", "Remove");
    assert_eq!(studio.text(), text.replace(", Torus(name: \"ring\")", ""));
    menu(&mut studio, "cube", "Remove, with \"pair\", which has no other part");
    assert!(!studio.text().contains("parts"), "{}", studio.text());
    assert!(studio.text().contains("Sphere(name: \"ball\")"), "{}", studio.text());
}
