//! Handles in a real X server: a hand moves an object and a light, the file gets that one value, and nothing is
//! compiled.
#![cfg(target_os = "linux")]

use std::fs;
use std::path::PathBuf;

use crate::desk::Desk;
use crate::desk::hand::{CONTROL, ESCAPE, text, wait_for_text};
use tempfile::TempDir;

const SIZE: [u16; 2] = [900, 700];
/// The middle of the ball, and of the picture, which is 668 pixels high.
const BALL: [i16; 2] = [290, 366];
/// Scene units to a pixel at the ball's depth.
const PIXEL: f32 = 2.0 * 0.36397 * 5.0 / 668.0;
/// On the ball's x arrow.
const ARROW: [i16; 2] = [350, 366];
/// Beside the ball, and inside of it once it has moved by 100 pixels; no arrow or word is there.
const BESIDE: [i16; 2] = [378, 420];
/// The light.
const LIGHT: [i16; 2] = [106, 182];

const RED: [u8; 3] = [255, 0, 0];
const BLACK: [u8; 3] = [0; 3];
const X_ARROW: [u8; 3] = [238, 82, 83];
const Y_ARROW: [u8; 3] = [118, 200, 80];

const SCENE: &str = "(
    camera: (eye: (0, 0, 5), target: (0, 0, 0)), // looks along -z
    ambient: 0,
    lights: [Point( position: (-1, 1, 0) /* up there */, intensity: 0)],
    objects: [
        Sphere(name: \"ball\", center: (0, 0, 0) /* here */, radius: 0.4, material: (color: \"tomato\", emission: \"red\")),
    ],
)
";

/// A window in which numbers can be edited without another pipeline; None, with a word, where there is no Xvfb.
fn opened() -> Option<(TempDir, PathBuf, Desk)> {
    let home = TempDir::new().expect("there is room for a folder");
    let file = home.path().join("scene.ron");
    fs::write(&file, SCENE).expect("the folder is writable");
    let mut desk = Desk::open(home.path(), "scene.ron", SIZE)?;
    desk.wait_for_event("ready");
    desk.wait_for_color(BALL[0], BALL[1], RED);
    Some((home, file, desk))
}

/// The numbers between `before` and `after` in `text`, and the text without them.
fn numbers(text: &str, before: &str, after: &str) -> (Vec<f32>, String) {
    let (start, rest) = text.split_once(before).unwrap_or_else(|| panic!("no {before} in {text}"));
    let (vector, end) = rest.split_once(after).unwrap_or_else(|| panic!("no {after} in {text}"));
    let numbers = vector.split(", ").map(|number| number.parse().expect("a number"));
    (numbers.collect(), format!("{start}{end}"))
}

fn is_about(x: f32, wanted: f32) -> bool {
    (x - wanted).abs() < 0.01
}

#[test]
fn an_object_follows_the_hand_along_its_axis_and_escape_and_undo_take_it_back() {
    let Some((_home, file, mut desk)) = opened() else { return };
    desk.focus();
    desk.click(BALL);
    desk.wait_for_event("chosen");
    desk.wait_for_color(ARROW[0], ARROW[1], X_ARROW);
    let made = desk.pipelines();
    let to = [ARROW[0] + 100, ARROW[1] - 40];

    desk.hold(ARROW);
    desk.point(to);
    desk.wait_for_color(BESIDE[0], BESIDE[1], RED);
    desk.press(&[], ESCAPE);
    desk.wait_for_color(BESIDE[0], BESIDE[1], BLACK);
    // Until the hand has let go, it moves nothing more.
    desk.point([to[0] + 50, to[1]]);
    desk.let_go(to);
    desk.wait_for_color(ARROW[0], ARROW[1], X_ARROW);
    assert_eq!(text(&file), SCENE);

    // The pointer leaves the axis, and the ball does not.
    desk.hold(ARROW);
    desk.point([to[0] - 30, to[1]]);
    desk.point(to);
    desk.wait_for_color(BESIDE[0], BESIDE[1], RED);
    assert_eq!(text(&file), SCENE, "what is still in the hand is not worth a file");
    desk.let_go(to);
    let changed = wait_for_text(&file, |text| text != SCENE);
    let (center, rest) = numbers(&changed, "center: (", ")");
    assert!(is_about(center[0], 100.0 * PIXEL), "{center:?}");
    assert_eq!(center[1..], [0.0, 0.0]);
    assert_eq!(rest, numbers(SCENE, "center: (", ")").1, "the rest of the text stays as it is");
    assert!(changed.contains(", 0, 0) /* here */"), "{changed}");

    // One step, however many there were on the way.
    desk.press(&[CONTROL], b'z'.into());
    wait_for_text(&file, |text| text == SCENE);
    desk.wait_for_color(BESIDE[0], BESIDE[1], BLACK);

    desk.wait_for_color(ARROW[0], ARROW[1], X_ARROW);
    desk.hold(ARROW);
    desk.hold_key(CONTROL, true);
    desk.point(to);
    desk.let_go(to);
    desk.hold_key(CONTROL, false);
    let snapped = wait_for_text(&file, |text| text != SCENE);
    assert_eq!(snapped, SCENE.replace("center: (0, 0, 0)", "center: (0.5, 0, 0)"));
    assert_eq!(desk.pipelines(), made, "numbers make no pipeline");
}

#[test]
fn a_light_is_chosen_by_its_sign_and_moved_by_its_handles() {
    let Some((_home, file, mut desk)) = opened() else { return };
    let made = desk.pipelines();
    desk.focus();
    desk.press(&[], b'g'.into());
    desk.click(LIGHT);
    let chosen = desk.wait_for_event("chosen");
    assert_eq!(chosen["object"], "Point 0");
    let arrow = [LIGHT[0], LIGHT[1] - 50];
    desk.wait_for_color(arrow[0], arrow[1], Y_ARROW);
    desk.drag(arrow, [arrow[0] + 30, arrow[1] + 80]);
    let changed = wait_for_text(&file, |text| text != SCENE);
    let (position, rest) = numbers(&changed, "position: (", ")");
    assert!(is_about(position[1], 1.0 - 80.0 * PIXEL), "{position:?}");
    assert_eq!([position[0], position[2]], [-1.0, 0.0]);
    assert_eq!(rest, numbers(SCENE, "position: (", ")").1, "the rest of the text stays as it is");
    desk.press(&[CONTROL], b'z'.into());
    wait_for_text(&file, |text| text == SCENE);
    desk.wait_for_color(arrow[0], arrow[1], Y_ARROW);
    assert_eq!(desk.pipelines(), made, "numbers make no pipeline");
    // Without handles, what is under the pointer is the picture.
    desk.press(&[], b'm'.into());
    desk.wait_for_color(arrow[0], arrow[1], BLACK);
}
