//! Names: each widget has one, and no two of a kind that stand together share it.
//!
//! That none lacks a name is asked by the harness after every step of every test.

use std::collections::BTreeSet;

use egui::accessibility::is_input;
use egui::accesskit::Role;
use egui::{Key, Modifiers};
use egui_kittest::kittest::{AccessKitNode, NodeT};

use super::SCENE;
use super::harness::Studio;

/// What widgets stand together in.
const PLACES: [Role; 4] = [Role::Group, Role::Dialog, Role::Window, Role::Menu];

/// What can be heard twice in one place.
fn doubled(studio: &Studio) -> Vec<String> {
    let mut heard = BTreeSet::new();
    let inputs = studio.harness.root().children_recursive().map(|node| node.accesskit_node());
    let inputs = inputs.filter(|own| is_input(own.role()));
    inputs
        .filter_map(|own| {
            let mut around = std::iter::successors(own.parent(), |node| node.parent());
            let is_place = |node: &AccessKitNode<'_>| PLACES.contains(&node.role());
            let place = around.find(is_place).map(|place| format!("{:?}", place.id()));
            let told = format!("{:?} {}", own.role(), own.label().unwrap_or_default());
            (!heard.insert((place, told.clone()))).then_some(told)
        })
        .collect()
}

/// The lines of the tree.
fn lines(studio: &Studio) -> Vec<String> {
    let all = studio.harness.root().children_recursive().map(|node| node.accesskit_node());
    all.filter(|own| own.role() == Role::TreeItem).filter_map(|own| own.label()).collect()
}

#[test]
fn all_that_the_tree_has_can_be_told_apart() {
    let mut studio = Studio::open(SCENE);
    for line in lines(&studio) {
        studio.choose(&line);
        assert_eq!(doubled(&studio), Vec::<String>::new(), "{line}");
    }
}

#[test]
fn so_can_all_that_opens() {
    let mut studio = Studio::open(SCENE);
    studio.press("Split view");
    studio.press("Only try");
    studio.choose("ball");
    studio.fill(Role::SpinButton, "radius", "3");
    for (modifiers, key) in [
        (Modifiers::COMMAND, Key::P),
        (Modifiers::NONE, Key::F1),
        (Modifiers::COMMAND, Key::O),
        (Modifiers::COMMAND, Key::Q),
        (Modifiers::COMMAND, Key::E),
    ] {
        studio.key(modifiers, key);
        assert_eq!(doubled(&studio), Vec::<String>::new(), "{key:?}");
        studio.key(Modifiers::NONE, Key::Escape);
    }
    for tab in ["Shader", "Timings", "Scene"] {
        studio.press(tab);
        assert_eq!(doubled(&studio), Vec::<String>::new(), "{tab}");
    }
    // Escape closes what is open, and lets go of what is chosen where nothing is.
    studio.choose("ball");
    for menu in ["raytoy", "more for color", "add to objects"] {
        studio.press(menu);
        assert_eq!(doubled(&studio), Vec::<String>::new(), "{menu}");
        studio.key(Modifiers::NONE, Key::Escape);
    }
}
