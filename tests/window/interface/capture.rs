//! The dialog by which a picture or a movie goes to a file.

use std::path::Path;

use egui::accesskit::Role;
use egui::{Key, Modifiers};
use raytoy::frame::View;
use raytoy::panel::CaptureAction;

use super::SCENE;
use super::harness::Studio;

/// The scene with the dialog open.
fn opened() -> Studio {
    let mut studio = Studio::open(SCENE);
    studio.key(Modifiers::COMMAND, Key::E);
    studio
}

#[test]
fn it_opens_and_closes_by_button_and_key() {
    let mut studio = opened();
    assert!(studio.has(Role::Window, "Save a picture"));
    studio.key(Modifiers::COMMAND, Key::E);
    assert!(!studio.has(Role::Window, "Save a picture"));
    studio.press("Save picture");
    assert!(studio.has(Role::Window, "Save a picture"));
    studio.press("Close window");
    assert!(!studio.has(Role::Window, "Save a picture"));
}

#[test]
fn a_picture_is_ordered_as_it_is_seen_in_the_size_that_is_asked_for() {
    let mut studio = opened();
    assert_eq!(studio.find(Role::TextInput, "file").value().as_deref(), Some("scene.png"));
    studio.pick((Role::ComboBox, "view"), "normal");
    studio.fill(Role::TextInput, "file", "large.exr");
    studio.fill(Role::SpinButton, "width in pixels", "320");
    studio.fill(Role::SpinButton, "height in pixels", "99999");
    studio.fill(Role::SpinButton, "samples", "4");
    assert!(!studio.has(Role::SpinButton, "seconds"), "it is no movie");
    studio.press("Save the picture");
    let [CaptureAction::Take(order)] = studio.stage().captures.as_slice() else {
        panic!("one was asked for")
    };
    assert_eq!((order.path.as_path(), order.size, order.samples), (Path::new("large.exr"), [320, 16384], 4));
    assert_eq!((order.moment.view, order.moment.time), (View::Normal, 0.0));
    assert_eq!(&*order.compiled.text, SCENE);
}

#[test]
fn a_movie_has_a_length_and_a_rate() {
    let mut studio = opened();
    studio.fill(Role::TextInput, "file", "turn.mp4");
    studio.fill(Role::SpinButton, "seconds", "2");
    studio.fill(Role::SpinButton, "frames per second", "24");
    studio.press("Save the movie");
    let [CaptureAction::Take(order)] = studio.stage().captures.as_slice() else {
        panic!("one was asked for")
    };
    assert_eq!((order.frames.numbers.clone(), order.frames.rate), (0..48, 24.0));
}

#[test]
fn what_takes_long_shows_how_far_it_is_and_can_be_stopped() {
    let mut studio = opened();
    studio.harness.state_mut().panel.dialog.progress = Some(0.25);
    studio.settle();
    assert!(studio.has(Role::ProgressIndicator, "progress") && !studio.has(Role::Button, "Save the picture"));
    studio.press("Stop");
    assert!(matches!(studio.stage().captures.as_slice(), [CaptureAction::Stop]));
    let dialog = &mut studio.harness.state_mut().panel.dialog;
    dialog.progress = None;
    dialog.result = Some(Err("the disk is full".into()));
    studio.settle();
    assert!(studio.says("the disk is full") && studio.has(Role::Button, "Save the picture"));
}
