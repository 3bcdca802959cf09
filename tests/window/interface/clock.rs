//! The clock of scenes that move.

use egui::accesskit::Role;
use egui::{Key, Modifiers};
use raytoy::engine::Clock;

use super::SCENE;
use super::harness::Studio;

const PULSE: &str =
    "/// Brighter and brighter.\nfn pulse(at: Surface) -> f32 {\n    return fract(frame.time);\n}\n";
const MOVING: &str = "(objects: [Sphere(material: (color: Pulse()))])\n";
const FRAME: f32 = 1.0 / 60.0;

/// A scene that moves, its clock stopped at 0.
fn stopped() -> Studio {
    let files = [("scene.ron", MOVING), ("textures/pulse.wgsl", PULSE)];
    let mut studio = Studio::open_among(&files, Default::default());
    assert!(matches!(studio.look().clock, Clock::Running { .. }), "it runs at first");
    studio.press("Pause");
    studio.press("Rewind");
    studio
}

#[test]
fn a_scene_that_stands_still_has_no_clock() {
    let studio = Studio::open(SCENE);
    assert!(!studio.has(Role::Button, "Pause") && !studio.has(Role::Slider, "time"));
}

#[test]
fn it_stops_and_goes_on_from_there() {
    let mut studio = stopped();
    assert_eq!(studio.look().clock, Clock::Stopped(0.0));
    studio.press("Step forward");
    studio.press("Pause");
    let Clock::Running { then, .. } = studio.look().clock else { panic!("it is to run") };
    assert_eq!(then, FRAME);
    studio.key(Modifiers::NONE, Key::Space);
    let Clock::Stopped(time) = studio.look().clock else { panic!("it is to stand") };
    assert!(time >= FRAME, "{time}");
    studio.key(Modifiers::NONE, Key::Space);
    studio.key(Modifiers::NONE, Key::Num0);
    assert!(matches!(studio.look().clock, Clock::Running { then: 0.0, .. }), "it begins again and runs");
}

#[test]
fn it_goes_by_frames_and_not_before_the_beginning() {
    let mut studio = stopped();
    for _ in 0..3 {
        studio.press("Step forward");
    }
    studio.press("Step back");
    assert_eq!(studio.look().clock, Clock::Stopped(FRAME + FRAME + FRAME - FRAME));
    studio.key(Modifiers::NONE, Key::Period);
    assert_eq!(studio.look().clock, Clock::Stopped(FRAME + FRAME + FRAME - FRAME + FRAME));
    for _ in 0..5 {
        studio.key(Modifiers::NONE, Key::Comma);
    }
    assert_eq!(studio.look().clock, Clock::Stopped(0.0));
}

#[test]
fn the_hand_takes_it_anywhere() {
    let mut studio = stopped();
    studio.press("Pause");
    let slider = studio.shown(Role::Slider, "time");
    studio.drag(slider.center(), egui::vec2(2.0, 0.0), |_| ());
    let Clock::Stopped(time) = studio.look().clock else { panic!("it is to stand") };
    assert!((9.0..11.0).contains(&time), "{time}");
    studio.fill(Role::SpinButton, "time", "12.5");
    assert_eq!(studio.look().clock, Clock::Stopped(12.5));
    assert_eq!(studio.find(Role::SpinButton, "time").value().as_deref(), Some("12.50 s"));
}

#[test]
fn it_begins_when_a_scene_that_moves_is_first_seen() {
    let files = [("scene.ron", SCENE), ("textures/pulse.wgsl", PULSE)];
    let mut studio = Studio::open_among(&files, Default::default());
    let Clock::Running { at: opened, .. } = studio.look().clock else { panic!("it is to run") };
    studio.save(MOVING);
    let Clock::Running { then: 0.0, at } = studio.look().clock else { panic!("it is to begin") };
    assert!(at > opened, "what a still scene took does not count");
    studio.save(&MOVING.replace("Sphere(", "Sphere(radius: 2, "));
    let Clock::Running { at: later, .. } = studio.look().clock else { panic!("it is to run") };
    assert_eq!(later, at, "an edit of a scene that moves lets it run on");
}
