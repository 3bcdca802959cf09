//! The window in a real X server: every way of saving shows, mistakes keep the picture, nothing is wasted.
#![cfg(target_os = "linux")]

use std::fs;
use std::path::Path;
use std::time::{Duration, Instant};

use crate::desk::hand::{CONTROL, ESCAPE};
use crate::desk::{Desk, PATIENCE};
use tempfile::TempDir;

/// Inside the picture, left of the panel.
const AT: (i16, i16) = (60, 60);
const SIZE: [u16; 2] = [640, 360];

/// A scene that fills the screen with one color.
fn plain(color: &str) -> String {
    format!("(background: {color}, render: (transfer: Linear), objects: [Sphere(center: (0, 90, 0))])")
}

fn level(x: f32) -> u8 {
    (x * 255.0).round() as u8
}

/// A folder with a scene, opened; None, with a word, where there is no Xvfb.
fn opened(text: &str) -> Option<(TempDir, Desk)> {
    let home = TempDir::new().expect("there is room for a folder");
    fs::write(home.path().join("scene.ron"), text).expect("the folder is writable");
    let desk = Desk::open(home.path(), "scene.ron", SIZE)?;
    Some((home, desk))
}

/// The same, with the scene on the screen and all pipelines made.
fn opened_and_ready(text: &str) -> Option<(TempDir, Desk)> {
    let (home, mut desk) = opened(text)?;
    desk.wait_for_event("ready");
    Some((home, desk))
}

/// Saves as editors do that write beside and rename.
fn save_by_rename(scene: &Path, text: &str) {
    let beside = scene.with_extension("tmp");
    fs::write(&beside, text).expect("the folder is writable");
    fs::rename(&beside, scene).expect("both are in one folder");
}

#[test]
fn every_way_of_saving_shows() {
    let Some((home, desk)) = opened_and_ready(&plain("0.1")) else { return };
    let scene = home.path().join("scene.ron");
    let shows = |x: f32| desk.wait_for_color(AT.0, AT.1, [level(x); 3]);
    shows(0.1);
    save_by_rename(&scene, &plain("0.2"));
    shows(0.2);
    save_by_rename(&scene, &plain("0.3"));
    shows(0.3);
    // Truncate, then write: fs::write does just that.
    fs::write(&scene, plain("0.4")).expect("the folder is writable");
    shows(0.4);
    fs::write(&scene, "").expect("the folder is writable");
    std::thread::sleep(Duration::from_millis(100));
    fs::write(&scene, plain("0.5")).expect("the folder is writable");
    shows(0.5);
    fs::remove_file(&scene).expect("it is there");
    std::thread::sleep(Duration::from_millis(100));
    fs::write(&scene, plain("0.6")).expect("the folder is writable");
    shows(0.6);
    // vim: rename away, write anew, delete the backup.
    let backup = home.path().join("scene.ron~");
    fs::rename(&scene, &backup).expect("both are in one folder");
    fs::write(&scene, plain("0.7")).expect("the folder is writable");
    fs::remove_file(&backup).expect("it is there");
    shows(0.7);
    for i in 0..50 {
        let text = plain(&format!("{}", 0.01 * i as f32));
        if i % 2 == 0 {
            save_by_rename(&scene, &text)
        } else {
            fs::write(&scene, &text).expect("writable")
        }
        std::thread::sleep(Duration::from_millis(7));
    }
    fs::write(&scene, plain("0.95")).expect("the folder is writable");
    shows(0.95);
}

#[test]
fn a_mistake_keeps_the_picture_and_a_repair_needs_nothing_else() {
    let Some((home, mut desk)) = opened_and_ready(&plain("0.2")) else { return };
    let scene = home.path().join("scene.ron");
    desk.wait_for_color(AT.0, AT.1, [level(0.2); 3]);
    save_by_rename(&scene, &plain("0.5").replace("Sphere", "Spere"));
    let broken = desk.wait_for_event("broken");
    assert_eq!(broken["errors"], 1);
    assert!(broken["text"].as_str().is_some_and(|t| t.contains("did you mean `Sphere`?")), "{broken}");
    // 0.2 is 51 of 255, with any number of samples; half a step would be rounded either way.
    assert_eq!(desk.color_at(AT.0, AT.1), [level(0.2); 3], "the last good picture stays");
    save_by_rename(&scene, &plain("0.5"));
    desk.wait_for_color(AT.0, AT.1, [level(0.5); 3]);
    save_by_rename(&scene, &(plain("0.5") + " // a comment"));
    desk.wait_for_event("unchanged");
}

#[test]
fn a_named_root_widens_what_the_scene_in_the_window_may_name() {
    let home = TempDir::new().expect("there is room for a folder");
    let project = home.path().join("project");
    fs::create_dir(&project).expect("the folder is writable");
    fs::write(home.path().join("wall.obj"), "v -9 -9 0\nv 9 -9 0\nv 0 9 0\nf 1 2 3\n")
        .expect("it is writable");
    let scene = "(camera: (eye: (0, 0, 5), target: (0, 0, 0)), background: 0.2, render: (transfer: Linear),
        objects: [Mesh(file: \"../wall.obj\", material: (color: 0, emission: 0.6))])";
    fs::write(project.join("scene.ron"), scene).expect("it is writable");
    let Some(mut narrow) = Desk::open(&project, "scene.ron", SIZE) else { return };
    let broken = narrow.wait_for_event("broken");
    let text = broken["text"].as_str().unwrap_or_default();
    assert!(text.contains("../wall.obj") && text.contains("--root"), "{text}");
    drop(narrow);
    let size = format!("{}x{}", SIZE[0], SIZE[1]);
    let wide = Desk::open_with(&project, "scene.ron", SIZE, None, &["--size", &size, "--root", ".."]);
    // Below the triangle's tip, left of the panel.
    wide.expect("there was an Xvfb before").wait_for_color(160, 300, [level(0.6); 3]);
}

#[test]
fn numbers_make_no_pipeline_and_structure_makes_one() {
    let Some((home, mut desk)) = opened_and_ready(&plain("0.1")) else { return };
    let scene = home.path().join("scene.ron");
    let made = desk.seen.last().expect("it is ready")["pipelines"].clone();
    for x in ["0.2", "0.3", "0.4"] {
        save_by_rename(&scene, &plain(x));
        let shown =
            desk.wait_for("an edited number", |e| e["event"] == "presented" && e["change"] == "numbers");
        assert_eq!(shown["pipelines"], made, "a number is an upload");
        desk.wait_for_color(AT.0, AT.1, [level(x.parse().expect("a number")); 3]);
    }
    save_by_rename(
        &scene,
        &plain("0.6").replace("Sphere(center: (0, 90, 0))", "Box(min: (0, 90, 0), max: (1, 91, 1))"),
    );
    let shown = desk.wait_for("another shape", |e| e["event"] == "presented" && e["change"] == "structure");
    assert_eq!(shown["pipelines"], made, "it shows before there is a pipeline");
    let ready = desk.wait_for_event("ready");
    assert!(ready["pipelines"].as_u64() > made.as_u64(), "another shape is another shader");
    desk.wait_for_color(AT.0, AT.1, [level(0.6); 3]);
}

#[test]
fn a_texture_that_was_missing_is_noticed_and_its_edits_too() {
    let Some((home, mut desk)) = opened(&plain("Flat()")) else { return };
    let broken = desk.wait_for_event("broken");
    assert!(broken["text"].as_str().is_some_and(|t| t.contains("there is no texture `Flat`")), "{broken}");
    let flat =
        |x: &str| format!("/// One color.\nfn flat(at: Surface) -> vec3f {{\n    return vec3f({x});\n}}\n");
    fs::create_dir(home.path().join("textures")).expect("the folder is writable");
    std::thread::sleep(Duration::from_millis(200));
    fs::write(home.path().join("textures/flat.wgsl"), flat("0.3")).expect("the folder is writable");
    desk.wait_for_color(AT.0, AT.1, [level(0.3); 3]);
    fs::write(home.path().join("textures/flat.wgsl"), flat("0.7")).expect("the folder is writable");
    desk.wait_for_color(AT.0, AT.1, [level(0.7); 3]);
}

#[test]
fn an_edit_of_a_model_shows() {
    let home = TempDir::new().expect("there is room for a folder");
    let model = home.path().join("a.obj");
    let square = |x: f32| {
        let corners = [[-9.0, -9.0], [9.0, -9.0], [9.0, 9.0], [-9.0, 9.0]];
        corners.map(|[dx, y]| format!("v {} {y} 0\n", x + dx)).concat() + "f 1 2 3 4\n"
    };
    fs::write(&model, square(0.0)).expect("the folder is writable");
    let scene = "(camera: (eye: (0, 0, 5), target: (0, 0, 0)), background: 0.2, render: (transfer: Linear),
        objects: [Mesh(file: \"a.obj\", material: (color: 0, emission: 0.6))])";
    fs::write(home.path().join("scene.ron"), scene).expect("the folder is writable");
    let Some(mut desk) = Desk::open(home.path(), "scene.ron", SIZE) else { return };
    desk.wait_for_color(AT.0, AT.1, [level(0.6); 3]);
    desk.wait_for_event("ready");
    fs::write(&model, square(100.0)).expect("the folder is writable");
    desk.wait_for("another model", |e| e["event"] == "presented" && e["change"] == "structure");
    desk.wait_for_color(AT.0, AT.1, [level(0.2); 3]);
    fs::write(&model, "v 1 2").expect("the folder is writable");
    let broken = desk.wait_for_event("broken");
    assert!(broken["text"].as_str().is_some_and(|t| t.contains("`a.obj` has no triangles")), "{broken}");
    save_by_rename(&model, &square(0.0));
    desk.wait_for_color(AT.0, AT.1, [level(0.6); 3]);
}

#[test]
fn a_drag_turns_the_camera() {
    let scene = "(
        camera: (eye: (0, 0, 5), target: (0, 0, 0)),
        objects: [Box(min: (-1, -1, -1), max: (1, 1, 1), material: (color: 0, emission: (1, 0, 0)))],
        background: Gradient(zenith: (0, 0, 1), horizon: (0, 1, 0)),
    )";
    let Some((_home, mut desk)) = opened_and_ready(scene) else { return };
    let middle = [160, 190];
    desk.wait_for_color(middle[0], middle[1], [255, 0, 0]);
    // Level with the horizon the upper edge shows the sky's first green; from above, the ground below it.
    let before = desk.color_at(20, 60);
    desk.drag(middle, [middle[0], middle[1] + 90]);
    let turned = |desk: &Desk| desk.color_at(20, 60).iter().zip(before).any(|(a, b)| a.abs_diff(b) > 8);
    desk.wait_for("a turned picture", |e| e["event"] == "presented" && e["samples"] == 64);
    assert!(turned(&desk), "the sky moves with the camera");
}

#[test]
fn a_window_at_rest_costs_nothing() {
    let Some((home, mut desk)) = opened_and_ready(&plain("0.2")) else { return };
    let rests = |desk: &Desk, seconds: u64, what: &str| {
        let time = Duration::from_secs(seconds);
        let used = desk.used_at_rest(time);
        assert!(used <= time / 100, "{what} takes {used:?} of {time:?}");
    };
    desk.wait_for("a whole picture", |e| e["event"] == "presented" && e["samples"] == 64);
    rests(&desk, 10, "a still picture");
    // It has a cursor, which must not blink.
    desk.focus();
    desk.press(&[CONTROL], b'p'.into());
    desk.wait_for_change(AT.0, AT.1, [level(0.2); 3]);
    rests(&desk, 3, "the palette");
    desk.press(&[], ESCAPE);
    save_by_rename(&home.path().join("scene.ron"), &plain("0.5").replace("Sphere", "Spere"));
    desk.wait_for_event("broken");
    rests(&desk, 3, "a mistake");
}

#[test]
fn a_scene_that_reads_the_clock_moves_and_takes_numbers_too() {
    let home = TempDir::new().expect("there is room for a folder");
    fs::create_dir(home.path().join("textures")).expect("the folder is writable");
    let pulse = "/// A light that grows.\n///\n/// rate = 1, 0 to 10: how fast\n\
                 fn pulse(at: Surface, rate: f32) -> f32 {\n    return fract(rate * frame.time);\n}\n";
    fs::write(home.path().join("textures/pulse.wgsl"), pulse).expect("the folder is writable");
    fs::write(home.path().join("scene.ron"), plain("Pulse(rate: 0.5)")).expect("the folder is writable");
    let Some(mut desk) = Desk::open(home.path(), "scene.ron", SIZE) else { return };
    desk.wait_for_event("ready");
    let before = desk.color_at(AT.0, AT.1);
    desk.wait_for_change(AT.0, AT.1, before);
    save_by_rename(&home.path().join("scene.ron"), &plain("Pulse(rate: 0)"));
    desk.wait_for_color(AT.0, AT.1, [0; 3]);
}

#[test]
fn a_lost_device_comes_back_and_the_picture_stays() {
    let Some((_home, mut desk)) = opened_and_ready(&plain("0.4")) else { return };
    desk.wait_for_color(AT.0, AT.1, [level(0.4); 3]);
    let mut seed = 1u64;
    let mut wait_a_moment = || {
        seed = seed.wrapping_mul(6364136223846793005).wrapping_add(1442695040888963407);
        std::thread::sleep(Duration::from_millis(seed >> 56));
    };
    for round in 0..20 {
        // In the midst of what follows a picture, or after it.
        wait_a_moment();
        let mut lost = Instant::now();
        desk.say("lose-device");
        desk.wait_for_event("restarted");
        if round % 2 == 1 {
            // In the midst of what the next device begins with.
            wait_a_moment();
            lost = Instant::now();
            desk.say("lose-device");
            desk.wait_for_event("restarted");
        }
        while desk.next_event().is_none_or(|event| event["event"] != "presented") {
            assert_eq!(desk.color_at(AT.0, AT.1), [level(0.4); 3], "the old picture stays until then");
            assert!(lost.elapsed() < PATIENCE, "there is no new picture");
            std::thread::sleep(Duration::from_millis(5));
        }
        println!("drawn again {} ms after the loss", lost.elapsed().as_millis());
    }
    assert_eq!(desk.end(), "", "raytoy has nothing to say about it");
}
