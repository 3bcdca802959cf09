//! What else the window shows of a scene, in a real X server: two views beside each other, a number as colors,
//! and the shader with what an edit has changed in it.
#![cfg(target_os = "linux")]

use std::fs;
use std::path::PathBuf;
use std::time::{Duration, Instant};

use crate::desk::hand::SHIFT;
use crate::desk::{Desk, PATIENCE};
use tempfile::TempDir;

const SIZE: [u16; 2] = [900, 700];
/// The picture's left, top, width and height.
const PICTURE: [f32; 4] = [0.0, 32.0, 580.0, 668.0];
/// Points of the ball, from the left; the divider begins at 290.
const FAR_LEFT: [i16; 2] = [140, 380];
const LEFT: [i16; 2] = [230, 426];
const RIGHT: [i16; 2] = [350, 426];
const FAR_RIGHT: [i16; 2] = [430, 426];
const SHADER: [i16; 2] = [670, 49];
/// The switch "What changed", where it has no letters.
const CHANGED: [i16; 2] = [592, 84];
/// Beside what stands there.
const BESIDE: [i16; 2] = [860, 84];
const PANEL: [u8; 3] = [24; 3];
const EXPORT: [i16; 2] = [719, 84];
/// Inside its menu, over the black of the picture.
const MENU: [i16; 2] = [526, 200];
/// "Save" beside the scene's own section.
const SAVE: [i16; 2] = [715, 111];
const COPY: [i16; 2] = [665, 111];
/// Where the rows of the shader are, and their backgrounds can be seen.
const ROWS: (i16, std::ops::Range<i16>) = (760, 112..690);

const RED: [u8; 3] = [255, 0, 0];
const BLACK: [u8; 3] = [0; 3];
/// The divider, the same near a hand, and in it.
const LINE: [u8; 3] = [235; 3];
const NEAR: [u8; 3] = [165, 195, 250];
const HELD: [u8; 3] = [86, 140, 245];
/// Behind the rows of what is chosen, gone and new.
const MARK: [u8; 3] = [58, 62, 82];
const GONE: [u8; 3] = [74, 30, 32];
const NEW: [u8; 3] = [24, 62, 34];

const SCENE: &str = "(
    camera: (eye: (0, 0, 5), target: (0, 0, 0)),
    ambient: 0,
    lights: [],
    objects: [
        Sphere(name: \"ball\", radius: 1, material: (color: 0.5, emission: (1, 0, 0))),
    ],
)
";

/// A window with the ball on the screen; None, with a word, where there is no Xvfb.
fn opened(text: &str) -> Option<(TempDir, PathBuf, Desk)> {
    let home = TempDir::new().expect("there is room for a folder");
    let file = home.path().join("scene.ron");
    fs::write(&file, text).expect("the folder is writable");
    let mut desk = Desk::open(home.path(), "scene.ron", SIZE)?;
    desk.wait_for_event("ready");
    wait(&desk, LEFT, RED);
    desk.focus();
    Some((home, file, desk))
}

fn wait(desk: &Desk, [x, y]: [i16; 2], color: [u8; 3]) {
    desk.wait_for_color(x, y, color);
}

/// What the view of normals shows of the ball at a pixel of the screen.
fn normal([x, y]: [i16; 2]) -> [u8; 3] {
    let [left, top, width, height] = PICTURE;
    let half = 20.0_f32.to_radians().tan() / (0.5 * height);
    let right = (f32::from(x) + 0.5 - left - 0.5 * width) * half;
    let down = (f32::from(y) + 0.5 - top - 0.5 * height) * half;
    // |(0, 0, 5) + t (right, -down, -1)| = 1
    let square = right * right + down * down + 1.0;
    let t = (5.0 - (25.0 - 24.0 * square).sqrt()) / square;
    [t * right, -t * down, 5.0 - t].map(|n| (127.5 + 127.5 * n).round() as u8)
}

/// Whether there is a row with this color behind it.
fn has_row(desk: &Desk, color: [u8; 3]) -> bool {
    let (x, mut rows) = ROWS;
    rows.any(|y| desk.color_at(x, y) == color)
}

/// Clicks, and again where a slow machine has missed it, until it `is_done`.
fn click_until(desk: &Desk, at: [i16; 2], is_done: impl Fn() -> bool) {
    for _ in 0..6 {
        desk.click(at);
        let until = Instant::now() + PATIENCE / 6;
        while Instant::now() < until {
            if is_done() {
                return;
            }
            std::thread::sleep(Duration::from_millis(20));
        }
    }
    panic!("a click at {at:?} does nothing");
}

/// Goes from the tree, whose search has a darker background than the panel, to the shader.
fn open_shader(desk: &Desk) {
    click_until(desk, SHADER, || desk.color_at(BESIDE[0], BESIDE[1]) == PANEL);
}

fn wait_for_row(desk: &Desk, color: [u8; 3]) {
    let until = Instant::now() + PATIENCE;
    while !has_row(desk, color) {
        assert!(Instant::now() < until, "waited in failed_restarts for a row with {color:?} behind it");
    }
}

#[test]
fn two_views_are_beside_each_other_and_a_hand_moves_the_divider() {
    let Some((_home, _file, desk)) = opened(SCENE) else { return };
    // Alone, the view is what the test takes it for.
    desk.press(&[], b'v'.into());
    [LEFT, RIGHT, FAR_RIGHT].iter().for_each(|at| wait(&desk, *at, normal(*at)));
    desk.press(&[SHIFT], b'v'.into());
    [LEFT, RIGHT].iter().for_each(|at| wait(&desk, *at, RED));
    desk.press(&[], b's'.into());
    [RIGHT, FAR_RIGHT].iter().for_each(|at| wait(&desk, *at, normal(*at)));
    [FAR_LEFT, LEFT].iter().for_each(|at| wait(&desk, *at, RED));
    drag_divider(&desk, 290, 390);
    wait(&desk, RIGHT, RED);
    wait(&desk, FAR_RIGHT, normal(FAR_RIGHT));
    wait(&desk, LEFT, RED);
    drag_divider(&desk, 390, 190);
    [LEFT, RIGHT, FAR_RIGHT].iter().for_each(|at| wait(&desk, *at, normal(*at)));
    wait(&desk, FAR_LEFT, RED);
    // The hand has moved the divider, and not the camera.
    desk.press(&[], b's'.into());
    [FAR_LEFT, LEFT, RIGHT, FAR_RIGHT].iter().for_each(|at| wait(&desk, *at, RED));
    // The left shows other views, and the right stays.
    desk.press(&[], b's'.into());
    desk.press(&[], b'v'.into());
    [FAR_LEFT, RIGHT].iter().for_each(|at| wait(&desk, *at, normal(*at)));
    desk.press(&[SHIFT], b'v'.into());
    wait(&desk, FAR_LEFT, RED);
    wait(&desk, RIGHT, normal(RIGHT));
}

#[test]
fn a_view_is_there_over_and_right_after_an_edit_of_the_structure() {
    let Some((_home, file, desk)) = opened(SCENE) else { return };
    let save = |text: &str| fs::write(&file, text).expect("the folder is writable");
    let walled = SCENE.replace("objects: [", "objects: [Box(min: (-9, -9, -3), max: (9, 9, -2)), ");
    let wall = [40, 600];
    desk.press(&[], b'v'.into());
    wait(&desk, LEFT, normal(LEFT));
    save(&walled);
    wait(&desk, wall, [128, 128, 255]);
    desk.press(&[SHIFT], b'v'.into());
    wait(&desk, LEFT, RED);
    // The shader of this edit has no view when the key is pressed.
    save(SCENE);
    desk.press(&[], b'v'.into());
    wait(&desk, LEFT, normal(LEFT));
    wait(&desk, wall, BLACK);
}

/// Moves it from column to column. A slow machine hears many things at once: each step waits for the last.
fn drag_divider(desk: &Desk, from: i16, to: i16) {
    desk.point([from, 250]);
    wait(desk, [from, 600], NEAR);
    desk.hold([from, 250]);
    wait(desk, [from, 600], HELD);
    desk.point([to, 250]);
    wait(desk, [to, 600], HELD);
    desk.let_go([to, 250]);
    desk.point([40, 600]);
    wait(desk, [to, 600], LINE);
}

#[test]
fn a_number_has_its_color_and_the_light_comes_back() {
    let Some((_home, _file, desk)) = opened(SCENE) else { return };
    desk.press(&[SHIFT], b'v'.into());
    // Between white and red: (0.875, 0.56, 0.55).
    wait(&desk, LEFT, [223, 143, 140]);
    desk.press(&[], b's'.into());
    wait(&desk, RIGHT, normal(RIGHT));
    wait(&desk, LEFT, [223, 143, 140]);
    desk.press(&[], b's'.into());
    desk.press(&[], b'v'.into());
    [LEFT, RIGHT].iter().for_each(|at| wait(&desk, *at, RED));
}

#[test]
fn the_shader_tab_tells_what_an_edit_has_changed_and_exports() {
    let Some((home, file, mut desk)) = opened(SCENE) else { return };
    open_shader(&desk);
    // What is on is blue.
    let is_on = |[red, _, blue]: [u8; 3]| blue > red + 30;
    click_until(&desk, CHANGED, || is_on(desk.color_at(CHANGED[0], CHANGED[1])));
    let save = |text: String| fs::write(&file, text).expect("the folder is writable");
    let is_shown = |change: &'static str| {
        move |e: &serde_json::Value| e["event"] == "presented" && e["change"] == change
    };
    let larger = SCENE.replace("radius: 1,", "radius: 1.1,");
    save(larger.clone());
    desk.wait_for("another number", is_shown("numbers"));
    assert!(!has_row(&desk, NEW) && !has_row(&desk, GONE), "a number is no change of the shader");
    save(larger.replace("objects: [", "objects: [Box(min: (0, 0, 90), max: (1, 1, 91)),"));
    desk.wait_for("a box", is_shown("structure"));
    wait_for_row(&desk, NEW);
    wait_for_row(&desk, GONE);
    let written = home.path().join("scene.section.wgsl");
    click_until(&desk, EXPORT, || desk.color_at(MENU[0], MENU[1]) != BLACK);
    click_until(&desk, SAVE, || written.exists());
    assert!(!desk.has_clipboard());
    click_until(&desk, EXPORT, || desk.color_at(MENU[0], MENU[1]) != BLACK);
    click_until(&desk, COPY, || desk.has_clipboard());
    let text = fs::read_to_string(&written).expect("it was just there");
    assert!(text.contains("fn rayTraceScene(") && text.contains("box(ray, "), "{text}");
}

#[test]
fn the_listing_goes_to_what_is_chosen() {
    let far = "Sphere(center: (0, 0, 90)), ".repeat(16);
    let Some((_home, _file, desk)) = opened(&SCENE.replace("objects: [", &format!("objects: [{far}"))) else {
        return;
    };
    open_shader(&desk);
    click_until(&desk, LEFT, || has_row(&desk, MARK));
    // A quarter from the top, and not where its constant is.
    let (x, rows) = ROWS;
    let quarter = rows.start + (rows.end - rows.start) / 4;
    let is_there = || (quarter - 20..quarter + 20).any(|y| desk.color_at(x, y) == MARK);
    let until = Instant::now() + PATIENCE;
    while !is_there() {
        assert!(Instant::now() < until, "the listing has not scrolled to the ball");
    }
}
