//! The panel in a real X server: what a hand does there goes to the file, and what goes to the file is merged.
#![cfg(target_os = "linux")]

use std::fs;
use std::path::PathBuf;
use std::time::{Duration, Instant};

use crate::desk::Desk;
use crate::desk::hand::{CONTROL, ENTER, ESCAPE, F1, SHIFT, text, wait_for_text};
use tempfile::TempDir;

const SIZE: [u16; 2] = [900, 700];
/// The middle of the ball.
const BALL: [i16; 2] = [290, 366];
/// Above the ball, and inside of it where its radius is 1.3.
const ABOVE: [i16; 2] = [290, 150];
/// Beside the ball, however it grows.
const CORNER: [i16; 2] = [8, 690];
/// The number beside `radius`, where the ball is chosen.
const RADIUS: [i16; 2] = [719, 399];
/// The color beside `emission`.
const EMISSION: [i16; 2] = [740, 615];
/// No widget.
const BESIDE: [i16; 2] = [640, 328];
const UNDO: [i16; 2] = [385, 15];
const ONLY_TRY: [i16; 2] = [862, 15];

const RED: [u8; 3] = [255, 0, 0];
const BLACK: [u8; 3] = [0; 3];
/// The view of normals, where the surface looks along z.
const FACING: [u8; 3] = [128, 128, 255];

const SCENE: &str = "(
    camera: (eye: (0, 0, 5), target: (0, 0, 0)), // looks along -z
    lights: [],
    objects: [
        Sphere( name: \"ball\", radius: 1 /* one */, material: (color: 0, emission: (1, 0, 0))),
    ],
)
";

/// A window with the ball on the screen, chosen by a click on it; None, with a word, where there is no Xvfb.
fn chosen() -> Option<(TempDir, PathBuf, Desk)> {
    let home = TempDir::new().expect("there is room for a folder");
    let file = home.path().join("scene.ron");
    fs::write(&file, SCENE).expect("the folder is writable");
    let mut desk = Desk::open(home.path(), "scene.ron", SIZE)?;
    desk.wait_for_event("ready");
    desk.wait_for_color(BALL[0], BALL[1], RED);
    desk.click(BALL);
    desk.wait_for_event("chosen");
    // Its values are there once this one is.
    desk.wait_for_color(EMISSION[0], EMISSION[1], RED);
    Some((home, file, desk))
}

/// Makes the ball larger, again where a slow machine takes press and release for one click, until it `is_done`.
fn drag_radius(desk: &Desk, is_done: impl Fn() -> bool) {
    for _ in 0..8 {
        desk.drag(RADIUS, [RADIUS[0] + 80, RADIUS[1]]);
        let until = Instant::now() + Duration::from_secs(5);
        while Instant::now() < until {
            if is_done() {
                return;
            }
            std::thread::sleep(Duration::from_millis(20));
        }
        // A click has opened the number for typing. One beside it closes it.
        desk.click(BESIDE);
    }
    panic!("the number cannot be dragged");
}

/// The number behind `radius: `, and the text without it.
fn radius(text: &str) -> (f32, String) {
    let (before, rest) = text.split_once("radius: ").expect("the ball has a radius");
    let (number, after) = rest.split_once(' ').expect("a blank follows it");
    (number.parse().expect("a number"), format!("{before}{after}"))
}

#[test]
fn a_drag_changes_the_number_in_the_file_and_undo_takes_it_back() {
    let Some((_home, file, mut desk)) = chosen() else { return };
    let made = desk.pipelines();
    drag_radius(&desk, || text(&file) != SCENE);
    let changed = wait_for_text(&file, |text| text != SCENE);
    let (number, rest) = radius(&changed);
    assert!(number > 1.1, "{number}");
    assert_eq!(rest, radius(SCENE).1, "the rest of the text stays as it is");
    desk.wait_for_color(ABOVE[0], ABOVE[1], RED);
    desk.click(UNDO);
    wait_for_text(&file, |text| text == SCENE);
    desk.wait_for_color(ABOVE[0], ABOVE[1], BLACK);
    assert_eq!(desk.pipelines(), made, "numbers make no pipeline");
}

#[test]
fn what_is_only_tried_stays_out_of_the_file_and_is_merged_with_it() {
    let Some((_home, file, desk)) = chosen() else { return };
    desk.click(ONLY_TRY);
    drag_radius(&desk, || desk.color_at(ABOVE[0], ABOVE[1]) == RED);
    desk.wait_for_color(ABOVE[0], ABOVE[1], RED);
    assert_eq!(text(&file), SCENE, "it is only tried");
    // An editor saves something else meanwhile.
    let outside = SCENE.replace("lights: []", "lights: [], background: (0, 1, 0)");
    fs::write(&file, &outside).expect("the folder is writable");
    desk.wait_for_color(CORNER[0], CORNER[1], [0, 255, 0]);
    desk.wait_for_color(ABOVE[0], ABOVE[1], RED);
    assert_eq!(text(&file), outside);
    desk.click(ONLY_TRY);
    let both = wait_for_text(&file, |text| text != outside);
    assert!(radius(&both).0 > 1.1 && both.contains("background: (0, 1, 0)"), "{both}");
}

#[test]
fn keys_and_the_palette_give_the_same_commands() {
    let Some((_home, _file, desk)) = chosen() else { return };
    desk.focus();
    // Handles lie over the middle of what is chosen.
    desk.press(&[], b'm'.into());
    desk.wait_for_color(BALL[0], BALL[1], RED);
    desk.press(&[], b'v'.into());
    desk.wait_for_color(BALL[0], BALL[1], FACING);
    desk.press(&[SHIFT], b'v'.into());
    desk.wait_for_color(BALL[0], BALL[1], RED);
    // An open palette darkens the picture.
    desk.press(&[CONTROL], b'p'.into());
    desk.wait_for_change(BALL[0], BALL[1], RED);
    desk.press(&[], ESCAPE);
    desk.wait_for_color(BALL[0], BALL[1], RED);
    desk.press(&[], F1);
    desk.wait_for_change(BALL[0], BALL[1], RED);
    desk.press(&[], ESCAPE);
    desk.wait_for_color(BALL[0], BALL[1], RED);
    desk.press(&[CONTROL], b'p'.into());
    desk.type_text("w nor");
    desk.press(&[], ENTER);
    desk.wait_for_color(BALL[0], BALL[1], FACING);
}

#[test]
fn the_magnifier_shows_what_is_under_the_pointer_beside_it() {
    let Some((_home, _file, desk)) = chosen() else { return };
    desk.focus();
    // Nothing but black is near the pointer, and the glass lies over the ball.
    desk.point(ABOVE);
    let glass = [ABOVE[0] + 120, ABOVE[1] + 120];
    desk.wait_for_color(glass[0], glass[1], RED);
    desk.press(&[], b'z'.into());
    desk.wait_for_color(glass[0], glass[1], BLACK);
    desk.point(BALL);
    desk.wait_for_color(BALL[0] + 120, BALL[1] + 120, RED);
    desk.press(&[], b'z'.into());
    desk.wait_for_color(glass[0], glass[1], RED);
}

#[test]
fn what_is_chosen_in_the_window_is_there_again_the_next_day() {
    let home = TempDir::new().expect("there is room for a folder");
    let memory = home.path().join("memory");
    fs::create_dir(&memory).expect("the folder is writable");
    let kept = memory.join("window.json");
    fs::write(&kept, "{\"size\": [700, 600], \"panel\": 300}").expect("the folder is writable");
    fs::write(home.path().join("scene.ron"), SCENE).expect("the folder is writable");
    let open = |scene| Desk::open_with(home.path(), scene, SIZE, Some(&memory), &[]);
    let Some(mut desk) = open("scene.ron") else { return };
    desk.wait_for_event("ready");
    assert_eq!(desk.focus(), [700, 600]);
    let [x, y] = [690, 590];
    let dark = desk.color_at(x, y);
    assert!(dark[0] < 64, "{dark:?}");
    desk.press(&[], b'l'.into());
    desk.wait_for_change(x, y, dark);
    let light = desk.color_at(x, y);
    assert!(light[0] > 192, "{light:?}");
    desk.press(&[CONTROL], b'n'.into());
    let untitled = home.path().join("untitled.ron");
    desk.wait_for("the new scene", |event| event["event"] == "presented" && event["change"] == "structure");
    assert!(text(&untitled).starts_with("// "));
    desk.press(&[CONTROL], b'q'.into());
    desk.wait_for_end();
    let told: serde_json::Value = serde_json::from_str(&text(&kept)).expect("it is JSON");
    assert_eq!(told["size"], serde_json::json!([700, 600]));
    assert_eq!(told["theme"], "light");
    let recent = [untitled, home.path().join("scene.ron")];
    assert_eq!(told["recent"], serde_json::json!(recent));
    let mut desk = open("scene.ron").expect("there was one before");
    desk.wait_for_event("ready");
    assert_eq!(desk.color_at(x, y), light);
}
