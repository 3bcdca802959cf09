//! What is to be seen: views, two of them, a number as colors, the camera, a part alone, signs and handles.

use std::time::Duration;

use egui::accesskit::Role;
use egui::{
    Color32, Event, Key, Modifiers, MouseWheelSource, MouseWheelUnit, PointerButton, Pos2, Rect, Rgba,
    TouchPhase, vec2,
};
use egui_kittest::kittest::{NodeT, Queryable};
use glam::{Vec2, Vec3};
use raytoy::engine::{Focus, Slow};
use raytoy::frame::{Lens, View};
use raytoy::panel::handles::{Handle, Tripod};

use super::SCENE;
use super::harness::{Studio, is};

/// The picture's place in the window, and the lens before it.
fn picture(studio: &Studio) -> (Rect, Lens) {
    let place = studio.find(Role::Image, "picture").rect();
    let camera = studio.stage().panel.compiled().expect("there is a picture").scene.camera;
    (place, Lens::new(&studio.look().camera.unwrap_or(camera), studio.look().size))
}

/// Where a point of the scene is seen.
fn seen(studio: &Studio, point: Vec3) -> Pos2 {
    let (place, lens) = picture(studio);
    at(place, lens.pixel(point))
}

fn at(place: Rect, pixel: Vec2) -> Pos2 {
    place.min + vec2(pixel.x, pixel.y)
}

#[test]
fn each_view_is_in_the_menu() {
    let mut studio = Studio::open(SCENE);
    for (name, view) in View::ALL {
        studio.pick((Role::ComboBox, "view"), name);
        assert_eq!(studio.look().view, view);
        assert_eq!(studio.find(Role::ComboBox, "view").value().as_deref(), Some(name));
    }
    studio.key(Modifiers::NONE, Key::V);
    assert_eq!(studio.look().view, View::Color);
    studio.key(Modifiers::NONE, Key::V);
    assert_eq!(studio.look().view, View::Normal);
    studio.key(Modifiers::SHIFT, Key::V);
    assert_eq!(studio.look().view, View::Color);
}

#[test]
fn two_views_stand_beside_each_other_and_a_hand_moves_the_divider() {
    let mut studio = Studio::open(SCENE);
    studio.press("Split view");
    let split = studio.look().split.expect("it is split");
    assert_eq!((studio.look().view, split.view, split.at), (View::Color, View::Normal, 0.5));
    studio.pick((Role::ComboBox, "right view"), "depth");
    studio.pick((Role::ComboBox, "left view"), "uv");
    let split = studio.look().split.expect("it is split");
    assert_eq!((studio.look().view, split.view), (View::Uv, View::Depth));
    let (place, _) = picture(&studio);
    let divider = studio.find(Role::Splitter, "divider of the views").rect();
    let above = divider.center() - vec2(0.0, 100.0);
    let share = |studio: &Studio| studio.look().split.expect("it is split").at;
    studio.drag(above, vec2(-0.25 * place.width(), 0.0), |_| ());
    assert!((share(&studio) - 0.25).abs() < 0.01, "{}", share(&studio));
    assert_eq!(studio.look().camera, None, "the camera stays");
    studio.press("Split view");
    assert_eq!(studio.look().split, None);
    studio.press("Split view");
    assert!((share(&studio) - 0.25).abs() < 0.01, "{}", share(&studio));
}

#[test]
fn a_number_is_asked_for_as_long_as_somebody_sees_it() {
    let mut studio = Studio::open(SCENE);
    let asked = |studio: &Studio| studio.stage().builder.measure.clone();
    assert_eq!(asked(&studio), None);
    studio.pick((Role::ComboBox, "view"), "value");
    assert_eq!(asked(&studio).as_deref(), Some("pattern"));
    studio.pick((Role::ComboBox, "number to show"), "tiles");
    assert_eq!(asked(&studio).as_deref(), Some("tiles"));
    studio.fill(Role::SpinButton, "the largest number that has a color", "2.5");
    assert_eq!(studio.look().reach, 2.5);
    studio.pick((Role::ComboBox, "view"), "color");
    assert_eq!(asked(&studio), None);
    assert!(!studio.has(Role::ComboBox, "number to show"));
}

#[test]
fn the_camera_turns_moves_comes_nearer_and_goes_home() {
    let mut studio = Studio::open(SCENE);
    let home = studio.stage().panel.compiled().expect("there is a picture").scene.camera;
    let place = picture(&studio).0;
    let beside = place.center() + vec2(150.0, 120.0);
    assert!(!studio.can("Home") && studio.look().camera.is_none());
    studio.drag(beside, vec2(60.0, 0.0), |_| ());
    let turned = studio.look().camera.expect("it has moved");
    assert_eq!(turned.target, home.target);
    assert!((turned.eye.distance(turned.target) - 5.0).abs() < 1e-3, "{}", turned.eye);
    assert!(turned.eye.distance(home.eye) > 0.2);
    studio.key(Modifiers::NONE, Key::H);
    assert!(studio.look().camera.is_none() && !studio.can("Home"));
    let wheel = Event::MouseWheel {
        unit: MouseWheelUnit::Line,
        source: MouseWheelSource::Wheel,
        delta: vec2(0.0, 2.0),
        phase: TouchPhase::Move,
        modifiers: Modifiers::NONE,
    };
    studio.harness.hover_at(beside);
    studio.harness.event(wheel);
    studio.leave();
    let nearer = studio.look().camera.expect("it has moved");
    assert!(nearer.eye.length() < 4.9 && nearer.target == home.target, "{}", nearer.eye);
    studio.press("Home");
    let button = |pressed, pos| {
        let (button, modifiers) = (PointerButton::Secondary, Modifiers::NONE);
        Event::PointerButton { pos, button, pressed, modifiers }
    };
    studio.harness.hover_at(beside);
    studio.harness.event(button(true, beside));
    studio.harness.hover_at(beside + vec2(40.0, 0.0));
    studio.harness.event(button(false, beside + vec2(40.0, 0.0)));
    studio.leave();
    let moved = studio.look().camera.expect("it has moved");
    assert!((moved.eye - home.eye).distance(moved.target - home.target) < 1e-4);
    assert!(moved.target.x < -0.1, "{}", moved.target);
}

#[test]
fn the_view_that_is_kept_is_written_into_the_scene() {
    let mut studio = Studio::open(SCENE);
    let beside = picture(&studio).0.center() + vec2(150.0, 120.0);
    studio.drag(beside, vec2(60.0, 20.0), |_| ());
    let eye = studio.look().camera.expect("it has moved").eye;
    studio.press("Keep view");
    let camera = studio.stage().panel.compiled().expect("there is a picture").scene.camera;
    assert!(camera.eye.distance(eye) < 1e-3, "{} {eye}", camera.eye);
    assert!(studio.text().contains("target: (0, 0, 0)), // looks along -z"), "{}", studio.text());
    assert!(studio.look().camera.is_none() && !studio.can("Keep view"), "the scene's camera is this one now");
    studio.press("Undo");
    assert_eq!(studio.text(), SCENE);
}

#[test]
fn a_body_or_a_material_is_shown_alone() {
    let mut studio = Studio::open(SCENE);
    let focus = |studio: &Studio| studio.stage().builder.focus.clone();
    assert!(!studio.can("Only this"));
    studio.choose("ball");
    studio.press("Only this");
    assert_eq!(focus(&studio), Focus::Object("ball".into()));
    assert!(studio.is_on("Only this"));
    studio.key(Modifiers::NONE, Key::F);
    assert_eq!(focus(&studio), Focus::All);
    studio.choose("gold");
    studio.key(Modifiers::NONE, Key::F);
    assert_eq!(focus(&studio), Focus::Material("gold".into()));
    studio.press("Only this");
    assert_eq!(focus(&studio), Focus::All);
    studio.choose("camera");
    assert!(!studio.can("Only this"));
}

#[test]
fn a_light_is_chosen_by_its_sign_where_signs_are_shown() {
    let mut studio = Studio::open(&SCENE.replace("position: (0, 5, 0)", "position: (1, 1, 0)"));
    let light = seen(&studio, Vec3::new(1.0, 1.0, 0.0));
    let click = |studio: &mut Studio| {
        studio.harness.hover_at(light);
        studio.harness.drag_at(light);
        studio.harness.drop_at(light);
        studio.settle();
    };
    click(&mut studio);
    assert!(!studio.has(Role::Group, "Point 0"));
    studio.press("Gizmos");
    assert!(studio.look().gizmos);
    click(&mut studio);
    assert!(studio.has(Role::Group, "Point 0"));
    assert_eq!(studio.harness.state_mut().panel.take_choice(), Some(Some("Point 0".into())));
    studio.key(Modifiers::NONE, Key::G);
    assert!(!studio.look().gizmos);
}

#[test]
fn what_is_chosen_is_moved_by_its_arrow_and_escape_gives_it_up() {
    let mut studio = Studio::open(SCENE);
    assert!(!studio.look().asks);
    studio.choose("ball");
    assert!(studio.look().asks, "its outline is to be drawn");
    let (place, lens) = picture(&studio);
    let tip = Tripod::new(lens, Vec3::ZERO, 1.0).and_then(|tripod| tripod.tip(Handle::X));
    let arrow = at(place, tip.expect("it is seen"));
    studio.drag(arrow, vec2(100.0, 0.0), |studio| {
        assert_eq!(studio.text(), SCENE);
        studio.key(Modifiers::NONE, Key::Escape);
    });
    assert_eq!(studio.text(), SCENE);
    assert!(!studio.can("Undo") && studio.has(Role::Group, "ball"));
    studio.drag(arrow, vec2(100.0, 0.0), |_| ());
    let text = studio.text();
    let (_, rest) = text.split_once("center: (").expect("it has moved");
    let (x, rest) = rest.split_once(", ").expect("it is a vector");
    let x: f32 = x.parse().expect("a number");
    let wanted = 100.0 * lens.pixel_size(Vec3::ZERO);
    assert!((x - wanted).abs() < 0.01 && rest.starts_with("0, 0)"), "{x} {wanted}: {text}");
    studio.press("Undo");
    assert_eq!(studio.text(), SCENE);
    // Without handles the same drag turns the camera.
    studio.key(Modifiers::NONE, Key::M);
    studio.drag(arrow, vec2(100.0, 0.0), |_| ());
    assert!(studio.text() == SCENE && studio.look().camera.is_some());
}

#[test]
fn slow_drawing_is_told_as_what_it_is_and_the_rest_goes_on() {
    let mut studio = Studio::open(SCENE);
    let tell = |studio: &mut Studio, resolution: f32| {
        let sample = Duration::from_secs(180);
        studio.harness.state_mut().panel.slow = Some(Slow { sample, done: 0.34, resolution });
        studio.settle();
    };
    tell(&mut studio, 0.25);
    assert!(studio.has(Role::Status, "slow drawing") && !studio.has(Role::Alert, "mistakes"));
    assert!(studio.says("Drawing is slow.") && studio.says("about 3 minutes. A coarse picture comes first"));
    tell(&mut studio, 1.0);
    assert!(studio.says("Progress:") && studio.says("The view `cost` shows which pixels are slow"));
    assert!(!studio.says("mistakes"));
    let share = studio.find(Role::ProgressIndicator, "share of the sample").accesskit_node().numeric_value();
    assert_eq!(share, Some(34.0));
    // A hand can do all that it can do otherwise.
    studio.choose("ball");
    assert!(studio.look().asks);
    studio.harness.state_mut().panel.slow = None;
    studio.settle();
    assert!(!studio.has(Role::Status, "slow drawing"));
}

/// The contrast of two colors as WCAG 2 has it.
fn contrast(a: Color32, b: Color32) -> f32 {
    let light = |color: Color32| {
        let [r, g, b, _] = Rgba::from(color).to_array();
        0.2126 * r + 0.7152 * g + 0.0722 * b + 0.05
    };
    light(a).max(light(b)) / light(a).min(light(b))
}

#[test]
fn all_text_can_be_read_in_both_themes() {
    let studio = Studio::open(SCENE);
    assert!((contrast(Color32::BLACK, Color32::WHITE) - 21.0).abs() < 0.01);
    for theme in [egui::Theme::Dark, egui::Theme::Light] {
        let style = studio.harness.ctx.style_of(theme);
        for (name, font) in &style.text_styles {
            assert!(font.size >= 11.0, "{theme:?} {name} has {} points", font.size);
        }
        let visuals = &style.visuals;
        let texts = [
            ("text", visuals.text_color()),
            ("weak", visuals.weak_text_color()),
            ("strong", visuals.strong_text_color()),
            ("button", visuals.widgets.inactive.text_color()),
            ("link", visuals.hyperlink_color),
            ("warning", visuals.warn_fg_color),
            ("error", visuals.error_fg_color),
        ];
        let grounds =
            [visuals.panel_fill, visuals.window_fill, visuals.faint_bg_color, visuals.extreme_bg_color];
        for (name, text) in texts {
            for ground in grounds {
                let found = contrast(text, ground);
                assert!(found >= 4.5, "{theme:?} {name}: {found} on {ground:?}");
            }
        }
        let button = contrast(visuals.weak_text_color(), visuals.widgets.inactive.weak_bg_fill);
        assert!(button >= 4.5, "{theme:?}: {button}");
    }
}

#[test]
fn what_a_narrow_bar_has_no_room_for_is_in_the_menu() {
    let mut studio = Studio::open(SCENE);
    studio.harness.set_size(vec2(800.0, 600.0));
    studio.settle();
    assert!(!studio.has(Role::Button, "Gallery"), "there is no room");
    studio.press("raytoy");
    for item in ["Gizmos", "Only this", "Split view", "Save picture", "Gallery"] {
        assert!(
            studio.find(Role::Button, "raytoy").query_all_by(is(Role::Button, item)).next().is_some(),
            "{item}"
        );
    }
}
