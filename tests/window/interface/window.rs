//! What belongs to the whole window: menus, the palette, the cheat sheet, bookmarks, its colors.

use std::fs;

use egui::accesskit::Role;
use egui::{Key, Modifiers, vec2};
use egui_kittest::kittest::{NodeT, Queryable};
use raytoy::frame::View;
use raytoy::panel::{COMMANDS, Settings, Theme};

use super::SCENE;
use super::harness::{Studio, is};

const OTHER: &str = "(objects: [Torus(name: \"ring\")])\n";

fn with_other() -> Studio {
    Studio::open_among(&[("scene.ron", SCENE), ("other.ron", OTHER)], Settings::default())
}

/// The lines of the palette.
fn lines(studio: &Studio) -> Vec<String> {
    let all = studio.harness.query_all_by_role(Role::ListBoxOption);
    all.filter_map(|line| line.accesskit_node().label()).collect()
}

#[test]
fn the_palette_finds_commands_views_and_scenes() {
    let mut studio = with_other();
    studio.key(Modifiers::COMMAND, Key::P);
    assert!(studio.has(Role::Dialog, "command palette"));
    // What is typed is no command.
    studio.key(Modifiers::NONE, Key::V);
    studio.type_text("w nor");
    assert_eq!(lines(&studio)[0], "View normal");
    assert_eq!(studio.look().view, View::Color);
    studio.key(Modifiers::NONE, Key::Enter);
    assert!(!studio.has(Role::Dialog, "command palette"));
    assert_eq!(studio.look().view, View::Normal);
    studio.key(Modifiers::COMMAND, Key::P);
    studio.type_text("no such thing");
    assert!(lines(&studio).is_empty() && studio.says("Nothing matches."));
    studio.key(Modifiers::NONE, Key::Escape);
    assert!(!studio.has(Role::Dialog, "command palette"));
    studio.key(Modifiers::COMMAND, Key::P);
    studio.type_text("ma");
    // Words that begin so come before those that only have it in them.
    assert_eq!(lines(&studio), ["Magnifier", "View material", "Bookmark"]);
    studio.key(Modifiers::COMMAND, Key::A);
    studio.type_text("open oth");
    studio.key(Modifiers::NONE, Key::Enter);
    assert!(studio.has(Role::TreeItem, "ring"));
}

#[test]
fn arrows_and_the_mouse_choose_in_the_palette() {
    let mut studio = with_other();
    studio.key(Modifiers::COMMAND, Key::P);
    studio.type_text("view");
    let found = lines(&studio);
    studio.key(Modifiers::NONE, Key::ArrowDown);
    studio.key(Modifiers::NONE, Key::ArrowDown);
    studio.key(Modifiers::NONE, Key::ArrowUp);
    let marked = studio.find(Role::ListBoxOption, &found[1]).accesskit_node().toggled();
    assert_eq!(marked, Some(egui::accesskit::Toggled::True), "{found:?}");
    studio.click(Role::ListBoxOption, "View depth");
    assert_eq!(studio.look().view, View::Depth);
}

#[test]
fn the_palette_has_no_command_that_can_do_nothing() {
    let mut studio = Studio::open(SCENE);
    studio.key(Modifiers::COMMAND, Key::P);
    let found = lines(&studio);
    for name in ["Undo", "Redo", "Home", "Keep view", "Choose nothing", "Only this", "Pause"] {
        assert!(!found.iter().any(|line| line == name), "{name}");
    }
    assert!(found.iter().any(|line| line == "Save picture"));
}

#[test]
fn the_cheat_sheet_has_all_commands_with_their_keys() {
    let mut studio = Studio::open(SCENE);
    studio.key(Modifiers::NONE, Key::F1);
    let sheet = studio.find(Role::Dialog, "cheat sheet");
    let said = studio.lines(&sheet);
    for entry in COMMANDS {
        let at = said.iter().position(|line| *line == format!("Label = {}", entry.name));
        let key = entry.keys[0];
        let key = match key.modifiers.is_none() {
            true => key.logical_key.symbol_or_name().to_owned(),
            false => studio.harness.ctx.format_shortcut(&key),
        };
        let beside = at.and_then(|at| said.get(at + 1)).expect(entry.name);
        assert!(beside.starts_with(&format!("Label = {key}")), "{}: {beside}", entry.name);
    }
    assert!(studio.says("Turn the camera") && studio.says("Ctrl+1 to 9"));
    // It takes the keys for itself.
    studio.key(Modifiers::NONE, Key::V);
    assert_eq!(studio.look().view, View::Color);
    studio.key(Modifiers::NONE, Key::Escape);
    assert!(!studio.has(Role::Dialog, "cheat sheet"));
    studio.key(Modifiers::NONE, Key::Questionmark);
    assert!(studio.has(Role::Dialog, "cheat sheet"));
}

#[test]
fn a_camera_is_kept_under_a_digit_and_comes_back() {
    let mut studio = Studio::open(SCENE);
    let place = studio.find(Role::Image, "picture").rect();
    let beside = place.center() + vec2(150.0, 120.0);
    studio.drag(beside, vec2(60.0, 20.0), |_| ());
    let kept = studio.look().camera.expect("it has moved");
    studio.key(Modifiers::COMMAND, Key::Num3);
    assert!(studio.says("camera saved as bookmark 3: press 3 to return to it"));
    studio.key(Modifiers::NONE, Key::H);
    assert!(studio.look().camera.is_none());
    studio.key(Modifiers::NONE, Key::Num3);
    assert_eq!(studio.look().camera, Some(kept));
    studio.key(Modifiers::NONE, Key::B);
    let digits = |studio: &Studio| {
        let settings = &studio.stage().panel.settings;
        settings.bookmarks(&studio.scene).iter().map(|known| known.digit).collect::<Vec<_>>()
    };
    assert_eq!(digits(&studio), [1, 3]);
    assert_eq!(studio.text(), SCENE, "the scene does not change");
}

#[test]
fn bookmarks_are_named_replaced_and_removed() {
    let mut studio = Studio::open(SCENE);
    let beside = studio.find(Role::Image, "picture").rect().center() + vec2(150.0, 120.0);
    studio.choose("camera");
    assert!(studio.says("Saved cameras appear here."));
    studio.press("Save this camera");
    studio.fill(Role::TextInput, "name of bookmark 1", "front");
    studio.drag(beside, vec2(60.0, 20.0), |_| ());
    let turned = studio.look().camera.expect("it has moved");
    assert!(!studio.is_on("bookmark 1"));
    studio.press("replace bookmark 1");
    assert!(studio.is_on("bookmark 1"));
    studio.press("Home");
    studio.press("go to bookmark 1");
    assert_eq!(studio.look().camera, Some(turned));
    let titles = |studio: &Studio| {
        let settings = &studio.stage().panel.settings;
        settings.bookmarks(&studio.scene).iter().map(|known| known.title()).collect::<Vec<_>>()
    };
    assert_eq!(titles(&studio), ["front"]);
    studio.press("remove bookmark 1");
    assert!(titles(&studio).is_empty() && !studio.has(Role::Button, "bookmark 1"));
}

#[test]
fn the_window_is_dark_or_light_and_remembers_it() {
    let mut studio = Studio::open(SCENE);
    let is_dark = |studio: &Studio| studio.harness.ctx.theme() == egui::Theme::Dark;
    assert!(is_dark(&studio));
    studio.key(Modifiers::NONE, Key::L);
    assert!(!is_dark(&studio) && studio.stage().panel.settings.theme == Theme::Light);
    // In the color of its background, and not only by name.
    assert!(studio.harness.ctx.global_style().visuals.panel_fill.r() > 200);
    studio.key(Modifiers::NONE, Key::L);
    assert!(is_dark(&studio) && studio.stage().panel.settings.theme == Theme::Dark);
}

#[test]
fn the_menu_has_the_commands_that_have_no_button() {
    let mut studio = Studio::open(SCENE);
    studio.pick((Role::Button, "raytoy"), "Magnifier");
    studio.press("raytoy");
    let menu = studio.find(Role::Button, "raytoy");
    let switch = |name| menu.get_by(is(Role::Button, name)).accesskit_node().toggled();
    assert_eq!(switch("Magnifier"), Some(egui::accesskit::Toggled::True));
    assert_eq!(switch("Handles"), Some(egui::accesskit::Toggled::True));
    studio.key(Modifiers::NONE, Key::Escape);
    studio.pick((Role::Button, "raytoy"), "Handles");
    assert!(!studio.stage().panel.settings.handles);
    studio.pick((Role::Button, "raytoy"), "Find a command");
    assert!(studio.has(Role::Dialog, "command palette"));
}

#[test]
fn a_new_scene_is_written_beside_this_one_and_opened() {
    let mut studio = with_other();
    studio.key(Modifiers::COMMAND, Key::N);
    let path = studio.home.path().join("untitled.ron");
    assert!(fs::read_to_string(&path).expect("it is written").starts_with("// A new scene"));
    assert_eq!(studio.stage().panel.scene(), path);
    assert!(studio.has(Role::TreeItem, "ring") && studio.has(Role::TreeItem, "block"));
    studio.click(Role::ComboBox, "scene");
    let menu = studio.find(Role::ComboBox, "scene");
    let names: Vec<_> = ["other", "scene", "untitled"].into_iter().collect();
    assert!(names.iter().all(|name| menu.query_by(is(Role::Button, name)).is_some()));
}

#[test]
fn letters_are_no_commands_while_somebody_types() {
    let mut studio = Studio::open(SCENE);
    studio.click(Role::TextInput, "find in the scene");
    studio.key(Modifiers::NONE, Key::T);
    studio.key(Modifiers::NONE, Key::V);
    assert!(!studio.is_on("Only try") && studio.look().view == View::Color);
}

#[test]
fn the_panel_is_made_wider_and_stays_so() {
    let mut studio = Studio::open(SCENE);
    // What lies on the other side is the picture's.
    let edge = studio.find(Role::Splitter, "Resize panel").rect().center() + vec2(2.0, 0.0);
    let before = studio.stage().panel.settings.panel;
    studio.drag(edge, vec2(-100.0, 0.0), |_| ());
    let after = studio.stage().panel.settings.panel;
    assert!((95.0..=100.0).contains(&(after - before)), "{before} {after}");
    assert_eq!(studio.look().camera, None, "the camera stays");
}
