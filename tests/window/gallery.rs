//! The gallery, bookmarks and the question before changes are lost, in a real X server.
#![cfg(target_os = "linux")]

use std::fs;
use std::path::{Path, PathBuf};
use std::time::{Duration, Instant};

use crate::desk::hand::{CONTROL, ENTER, ESCAPE, text};
use crate::desk::{Desk, PATIENCE};
use image::{ImageFormat, Rgb, RgbImage};
use tempfile::TempDir;

const SIZE: [u16; 2] = [900, 700];
/// In the picture, beside everything that stands in it, also where a sheet is open.
const CORNER: [i16; 2] = [8, 690];
/// In the picture of the gallery's first tile.
const TILE: [i16; 2] = [128, 200];
/// From a tile to the next one.
const NEXT: i16 = 192;
/// In the mark of a tile without a picture, beside its sign.
const MARK: [i16; 2] = [120, 173];
/// Above the ball, and inside of it where the camera is nearer.
const ABOVE: [i16; 2] = [290, 150];
/// In the button `Only try`, beside its words.
const ONLY_TRY: [i16; 2] = [838, 8];
/// In the button by which changes are written, beside its words.
const WRITE: [i16; 2] = [602, 380];
const DROP: [i16; 2] = [545, 380];

const RED: [u8; 3] = [255, 0, 0];
const GREEN: [u8; 3] = [0, 255, 0];
const BLUE: [u8; 3] = [0, 0, 255];
const CYAN: [u8; 3] = [0, 255, 255];
const BLACK: [u8; 3] = [0; 3];
/// Of the button that is proposed.
const ACCENT: [u8; 3] = [86, 140, 245];

const BALL_SCENE: &str = "(
    camera: (eye: (0, 0, 5), target: (0, 0, 0)), // looks along -z
    lights: [],
    objects: [
        Sphere( name: \"ball\", radius: 1 /* one */, material: (color: 0, emission: (1, 0, 0))),
    ],
)
";

/// A scene that fills the screen with one color.
fn plain(color: [u8; 3]) -> String {
    let [r, g, b] = color.map(|level| level / 255);
    format!("// All of one color.\n(background: ({r}, {g}, {b}), objects: [Sphere(center: (0, 90, 0))])")
}

/// A folder with these scenes, the first one opened with what is remembered in the folder `memory`; None, with
/// a word, where there is no Xvfb.
fn opened(scenes: &[(&str, String)]) -> Option<(TempDir, Desk)> {
    let home = TempDir::new().expect("there is room for a folder");
    fs::create_dir(home.path().join("memory")).expect("the folder is writable");
    for (name, text) in scenes {
        fs::write(home.path().join(name), text).expect("the folder is writable");
    }
    let desk = reopened(home.path(), scenes[0].0)?;
    Some((home, desk))
}

fn reopened(home: &Path, scene: &str) -> Option<Desk> {
    let [width, height] = SIZE;
    let size = format!("{width}x{height}");
    let mut desk = Desk::open_with(home, scene, SIZE, Some(&home.join("memory")), &["--size", &size])?;
    desk.wait_for_event("ready");
    desk.focus();
    Some(desk)
}

#[test]
fn a_search_leaves_one_tile_whose_picture_is_drawn_and_a_click_opens_its_scene() {
    let scenes = [("a.ron", plain(RED)), ("b.ron", plain(RED)), ("meadow.ron", plain(GREEN))];
    let Some((_home, desk)) = opened(&scenes) else { return };
    desk.wait_for_color(CORNER[0], CORNER[1], RED);
    desk.press(&[CONTROL], b'o'.into());
    desk.type_text("mead");
    // A thumbnail: the scene itself is not shown yet.
    desk.wait_for_color(TILE[0], TILE[1], GREEN);
    assert_ne!(desk.color_at(CORNER[0], CORNER[1]), GREEN);
    desk.click(TILE);
    desk.wait_for_color(CORNER[0], CORNER[1], GREEN);
    // By the keys alone, in the other direction.
    desk.press(&[CONTROL], b'o'.into());
    desk.type_text("a");
    desk.press(&[], ENTER);
    desk.wait_for_color(CORNER[0], CORNER[1], RED);
}

#[test]
fn thumbnails_of_the_day_before_are_shown_and_not_drawn_again() {
    let scenes = [("b.ron", plain(RED)), ("a.ron", plain(GREEN))];
    let Some((home, desk)) = opened(&scenes) else { return };
    desk.press(&[CONTROL], b'o'.into());
    desk.wait_for_color(TILE[0], TILE[1], GREEN);
    drop(desk);
    let kept: Vec<PathBuf> = fs::read_dir(home.path().join("memory/thumbnails"))
        .expect("they are kept there")
        .map(|entry| entry.expect("it can be read").path())
        .filter(|path| path.extension().is_some_and(|ending| ending == "jpg"))
        .collect();
    // Whoever shows blue has not drawn.
    for path in &kept {
        let old = image::open(path).expect("it is a picture");
        let blue = RgbImage::from_pixel(old.width(), old.height(), Rgb(BLUE));
        blue.save_with_format(path, ImageFormat::Jpeg).expect("it is writable");
    }
    let desk = reopened(home.path(), "b.ron").expect("there was one before");
    desk.press(&[CONTROL], b'o'.into());
    desk.wait_for_color(TILE[0], TILE[1], BLUE);
    // Another scene under the same name is another picture.
    desk.press(&[], ESCAPE);
    desk.wait_for_color(TILE[0], TILE[1], RED);
    fs::write(home.path().join("a.ron"), plain(CYAN)).expect("the folder is writable");
    desk.press(&[CONTROL], b'o'.into());
    desk.wait_for_color(TILE[0], TILE[1], CYAN);
}

#[test]
fn a_scene_with_mistakes_is_a_tile_with_a_mark_and_the_others_are_drawn() {
    let scenes = [
        ("y.ron", plain(RED)),
        ("z.ron", plain(GREEN)),
        ("broken.ron", "// Wrong.\n(objects: [Spere()])".to_owned()),
    ];
    let Some((_home, desk)) = opened(&scenes) else { return };
    desk.press(&[CONTROL], b'o'.into());
    let until = Instant::now() + PATIENCE;
    loop {
        let [r, g, _] = desk.color_at(MARK[0], MARK[1]).map(u16::from);
        if (40..120).contains(&r) && r > g + 20 {
            break;
        }
        assert!(Instant::now() < until, "there is no mark");
        std::thread::sleep(Duration::from_millis(20));
    }
    desk.wait_for_color(TILE[0] + 2 * NEXT, TILE[1], GREEN);
}

#[test]
fn a_bookmark_brings_the_camera_back_also_the_next_day() {
    let Some((home, mut desk)) = opened(&[("a.ron", BALL_SCENE.to_owned())]) else { return };
    let shows = |desk: &Desk, color| desk.wait_for_color(ABOVE[0], ABOVE[1], color);
    shows(&desk, BLACK);
    // Nearer, kept under 3; then home, and back.
    desk.roll(ABOVE, 3);
    shows(&desk, RED);
    desk.press(&[CONTROL], b'3'.into());
    // A slow machine may take both keys at once, and then goes home first.
    let until = Instant::now() + PATIENCE;
    while !fs::read_to_string(home.path().join("memory/window.json")).is_ok_and(|it| it.contains("digit")) {
        assert!(Instant::now() < until, "the bookmark is not kept");
        std::thread::sleep(Duration::from_millis(20));
    }
    desk.press(&[], b'h'.into());
    shows(&desk, BLACK);
    desk.press(&[], b'3'.into());
    shows(&desk, RED);
    desk.press(&[], b'h'.into());
    shows(&desk, BLACK);
    // The first digit that is free is 1.
    desk.press(&[], b'b'.into());
    desk.press(&[], b'3'.into());
    shows(&desk, RED);
    desk.press(&[], b'1'.into());
    shows(&desk, BLACK);
    desk.press(&[CONTROL], b'q'.into());
    desk.wait_for_end();
    let told = fs::read_to_string(home.path().join("memory/window.json")).expect("it is kept");
    let told: serde_json::Value = serde_json::from_str(&told).expect("it is JSON");
    let of_scene = told["bookmarks"][home.path().join("a.ron").to_str().expect("it is UTF-8")].clone();
    let digits: Vec<_> =
        of_scene.as_array().expect("a list").iter().map(|known| known["digit"].clone()).collect();
    assert_eq!(digits, [1, 3]);
    let desk = reopened(home.path(), "a.ron").expect("there was one before");
    shows(&desk, BLACK);
    desk.press(&[], b'3'.into());
    shows(&desk, RED);
}

/// The scene with the ball, seen from nearer than its file says, which is only tried.
fn tried() -> Option<(TempDir, Desk)> {
    let (home, desk) = opened(&[("a.ron", BALL_SCENE.to_owned()), ("b.ron", plain(GREEN))])?;
    let off = desk.color_at(ONLY_TRY[0], ONLY_TRY[1]);
    desk.press(&[], b't'.into());
    desk.wait_for_change(ONLY_TRY[0], ONLY_TRY[1], off);
    desk.roll(ABOVE, 3);
    desk.wait_for_color(ABOVE[0], ABOVE[1], RED);
    desk.press(&[], b'k'.into());
    Some((home, desk))
}

/// Answers the question by staying, which is no loss: the changes are there, and in no file.
fn stay(home: &TempDir, desk: &Desk) {
    desk.wait_for_color(WRITE[0], WRITE[1], ACCENT);
    desk.press(&[], ESCAPE);
    desk.wait_for_change(WRITE[0], WRITE[1], ACCENT);
    assert_eq!(text(&home.path().join("a.ron")), BALL_SCENE);
}

/// Begins to open the other scene, by the palette.
fn open_other(desk: &Desk) {
    desk.press(&[CONTROL], b'p'.into());
    desk.type_text("open b");
    desk.press(&[], ENTER);
}

#[test]
fn what_was_only_tried_is_asked_for_before_another_scene_opens() {
    let Some((home, mut desk)) = tried() else { return };
    open_other(&desk);
    stay(&home, &desk);
    // Written, it is in the file when the other scene is there.
    open_other(&desk);
    desk.wait_for_color(WRITE[0], WRITE[1], ACCENT);
    desk.press(&[], ENTER);
    desk.wait_for_color(CORNER[0], CORNER[1], GREEN);
    let written = text(&home.path().join("a.ron"));
    assert!(written != BALL_SCENE && written.contains("/* one */"), "{written}");
    // A scene without changes is left without a question.
    desk.press(&[CONTROL], b'q'.into());
    desk.wait_for_end();
}

#[test]
fn what_was_only_tried_is_asked_for_before_the_window_closes() {
    let Some((home, mut desk)) = tried() else { return };
    desk.ask_to_close();
    stay(&home, &desk);
    desk.press(&[CONTROL], b'q'.into());
    desk.wait_for_color(WRITE[0], WRITE[1], ACCENT);
    desk.press(&[], ENTER);
    desk.wait_for_end();
    assert!(text(&home.path().join("a.ron")) != BALL_SCENE, "it was to be written");
}

#[test]
fn what_is_dropped_is_not_written() {
    let Some((home, mut desk)) = tried() else { return };
    desk.ask_to_close();
    desk.wait_for_color(WRITE[0], WRITE[1], ACCENT);
    desk.click(DROP);
    desk.wait_for_end();
    assert_eq!(text(&home.path().join("a.ron")), BALL_SCENE);
}
