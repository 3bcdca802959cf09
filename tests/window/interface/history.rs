//! What was done: undone and done again, only tried, merged with what an editor saves, and asked for before it is
//! lost.

use egui::accesskit::Role;
use egui::{Key, Modifiers};

use super::SCENE;
use super::harness::Studio;

/// The scene with the radius of its ball typed anew.
fn edited(tries_only: bool) -> Studio {
    let mut studio = Studio::open_among(&[("scene.ron", SCENE), ("other.ron", OTHER)], Default::default());
    if tries_only {
        studio.press("Only try");
    }
    studio.choose("ball");
    studio.fill(Role::SpinButton, "radius", "3");
    studio
}

const OTHER: &str = "// Another one.\n(objects: [Torus(name: \"ring\")])\n";

fn changed() -> String {
    SCENE.replace("radius: 1 /*", "radius: 3 /*")
}

#[test]
fn undo_and_redo_by_button_and_by_key() {
    let mut studio = edited(false);
    assert_eq!(studio.text(), changed());
    assert!(studio.can("Undo") && !studio.can("Redo"));
    studio.press("Undo");
    assert_eq!(studio.text(), SCENE);
    assert!(!studio.can("Undo") && studio.can("Redo"));
    studio.press("Redo");
    assert_eq!(studio.text(), changed());
    studio.key(Modifiers::COMMAND, Key::Z);
    assert_eq!(studio.text(), SCENE);
    studio.key(Modifiers::COMMAND | Modifiers::SHIFT, Key::Z);
    assert_eq!(studio.text(), changed());
    studio.key(Modifiers::COMMAND, Key::Z);
    studio.key(Modifiers::COMMAND, Key::Y);
    assert_eq!(studio.text(), changed());
    assert_eq!(studio.find(Role::SpinButton, "radius").value().as_deref(), Some("3"));
}

#[test]
fn what_is_only_tried_is_shown_and_saved_when_the_author_says_so() {
    let mut studio = edited(true);
    assert!(studio.is_on("Only try") && studio.says("not saved"));
    assert_eq!(studio.text(), SCENE);
    assert_eq!(studio.shown_radius(), 3.0, "it is shown");
    studio.press("Only try");
    assert!(!studio.is_on("Only try") && studio.says("saved") && !studio.says("not saved"));
    assert_eq!(studio.text(), changed());
}

#[test]
fn what_an_editor_saves_meanwhile_is_merged() {
    let mut studio = edited(true);
    let outside = SCENE.replace("min: (-2, 0, 0)", "min: (-5, 0, 0)");
    studio.save(&outside);
    assert_eq!(studio.text(), outside);
    assert_eq!(studio.shown_radius(), 3.0);
    studio.press("Only try");
    assert_eq!(studio.text(), outside.replace("radius: 1 /*", "radius: 3 /*"));
}

#[test]
fn what_an_editor_has_saved_is_not_undone_unasked() {
    let mut studio = edited(false);
    let outside = changed().replace("min: (-2, 0, 0)", "min: (-5, 0, 0)");
    studio.save(&outside);
    studio.key(Modifiers::COMMAND, Key::Z);
    assert_eq!(studio.text(), outside);
    assert!(studio.says("the next undo reverts changes that your editor saved"));
    // Something else in between, and it is asked again.
    studio.key(Modifiers::NONE, Key::G);
    studio.key(Modifiers::COMMAND, Key::Z);
    assert_eq!(studio.text(), outside);
    studio.key(Modifiers::COMMAND, Key::Z);
    assert_eq!(studio.text(), changed());
    studio.key(Modifiers::COMMAND, Key::Z);
    assert_eq!(studio.text(), SCENE);
    studio.key(Modifiers::COMMAND, Key::Y);
    studio.key(Modifiers::COMMAND, Key::Y);
    assert_eq!(studio.text(), outside);
}

#[test]
fn what_both_have_changed_is_the_authors_choice() {
    for with_mine in [true, false] {
        let mut studio = edited(true);
        studio.save(&SCENE.replace("radius: 1 /*", "radius: 2 /*"));
        assert!(studio.says("The file has changed in the same place") && studio.says("the file has 2"));
        studio.press(if with_mine { "Use my value" } else { "Use the file's value" });
        assert!(!studio.says("The file has changed in the same place"));
        assert_eq!(studio.shown_radius(), if with_mine { 3.0 } else { 2.0 });
        studio.press("Only try");
        let radius = if with_mine { "radius: 3 /*" } else { "radius: 2 /*" };
        assert_eq!(studio.text(), SCENE.replace("radius: 1 /*", radius));
    }
}

#[test]
fn a_file_that_cannot_be_read_waits_for_its_author() {
    let mut studio = edited(true);
    studio.save("(objects: [");
    assert!(studio.says("the file has mistakes: correct them to continue here"));
    studio.save(SCENE);
    assert_eq!(studio.shown_radius(), 3.0);
}

#[test]
fn the_question_before_changes_are_lost_has_three_answers() {
    let asked = |answer: &str| {
        let mut studio = edited(true);
        studio.pick((Role::ComboBox, "scene"), "other");
        assert!(studio.has(Role::Dialog, "Save your changes?"));
        assert!(studio.says("The changes to scene.ron were only tried and are not saved."));
        studio.press(answer);
        assert!(!studio.has(Role::Dialog, "Save your changes?"));
        studio
    };
    let studio = asked("Stay");
    assert_eq!(studio.text(), SCENE);
    assert_eq!(studio.shown_radius(), 3.0);
    let studio = asked("Discard");
    assert_eq!(studio.text(), SCENE);
    assert!(studio.has(Role::TreeItem, "ring"));
    let studio = asked("Save");
    assert_eq!(studio.text(), changed());
    assert!(studio.has(Role::TreeItem, "ring"));
}

#[test]
fn the_question_is_answered_by_keys_and_takes_no_others() {
    let mut studio = edited(true);
    studio.key(Modifiers::COMMAND, Key::Q);
    assert!(studio.has(Role::Dialog, "Save your changes?"));
    studio.key(Modifiers::NONE, Key::T);
    studio.key(Modifiers::NONE, Key::Escape);
    assert!(!studio.has(Role::Dialog, "Save your changes?") && studio.is_on("Only try"));
    assert!(!studio.stage().quits);
    studio.key(Modifiers::COMMAND, Key::Q);
    studio.key(Modifiers::NONE, Key::Enter);
    assert!(studio.stage().quits);
    assert_eq!(studio.text(), changed());
}

#[test]
fn what_is_saved_is_left_without_a_question() {
    let mut studio = edited(false);
    studio.pick((Role::ComboBox, "scene"), "other");
    assert!(studio.has(Role::TreeItem, "ring"));
    studio.key(Modifiers::COMMAND, Key::Q);
    assert!(studio.stage().quits);
}
