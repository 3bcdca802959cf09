//! The tree: what is in it, what can be chosen, added and taken away.

use egui::accesskit::Role;
use egui::{Key, Modifiers};
use egui_kittest::kittest::{NodeT, Queryable};

use super::SCENE;
use super::studio::{Studio, is};

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
    assert!(studio.says("Choose something in the tree to see its values."));
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
    assert!(studio.text().contains("Sphere()])"), "{}", studio.text());
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
