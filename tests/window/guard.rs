//! The window, where the last good picture stays and the hand on the mouse is still heard.
#![cfg(target_os = "linux")]

use crate::desk::Desk;

use crate::common::folder::Folder;

/// Inside the picture, left of the panel and above what is told.
const AT: [i16; 2] = [60, 60];
/// The middle of the box.
const BOX: [i16; 2] = [160, 54];
const SIZE: [u16; 2] = [640, 360];

/// A texture that gives a grey after so many steps of a loop, and goes on where `goes_on` holds.
fn loops(grey: f32, goes_on: &str, count: &str) -> String {
    format!(
        "/// A grey, after a while.\n///\n/// count = {count}: steps\nfn loops(at: Surface, count: u32) -> f32 {{
    var x = {grey:?};
    for (var i = 0u; i < count || {goes_on}; i++) {{
        x += 1e-9 * fract(f32(i & 1u) * at.uv.x);
    }}
    return x;\n}}\n"
    )
}

/// The screen is filled with the texture, but for a box that tells where the camera stands.
fn scene(call: &str) -> String {
    format!(
        "(camera: (eye: (0, 0, 5), target: (0, 0, 0)), background: {call}, render: (transfer: Linear),
        objects: [Box(min: (-0.3, 1, 1), max: (0.3, 1.4, 1.4), material: (color: 0, emission: (1, 0, 0)))])"
    )
}

fn level(x: f32) -> [u8; 3] {
    [(x * 255.0).round() as u8; 3]
}

/// A folder with a scene whose texture gives 0.2, on the screen and with all pipelines made.
fn opened() -> Option<(Folder, Desk)> {
    let folder = Folder::new();
    folder.write("textures/loops.wgsl", &loops(0.2, "false", "3"));
    folder.write("scene.ron", &scene("Loops()"));
    let mut desk = Desk::open(folder.path(), "scene.ron", SIZE)?;
    desk.wait_for_event("ready");
    desk.wait_for_color(AT[0], AT[1], level(0.2));
    Some((folder, desk))
}

/// Waits until raytoy tells of an endless loop.
fn expect_told(desk: &mut Desk) {
    let broken = desk.wait_for_event("broken");
    assert_eq!(broken["errors"], 1);
    let told = broken["text"].as_str().unwrap_or_default();
    assert!(told.contains("ran too long") && told.contains("textures/loops.wgsl:6:5"), "{told}");
}

/// Waits until the last sample of a picture is on the screen.
fn wait_for_last(desk: &mut Desk) {
    desk.wait_for("a whole picture", |e| {
        e["event"] == "presented" && e["samples"] == 64 && e["resolution"] == 1.0
    });
}

#[test]
fn an_endless_loop_keeps_the_last_good_scene_which_still_turns() {
    let Some((folder, mut desk)) = opened() else { return };
    folder.write("textures/loops.wgsl", &loops(0.6, "true", "3"));
    expect_told(&mut desk);
    wait_for_last(&mut desk);
    assert_eq!(desk.color_at(AT[0], AT[1]), level(0.2), "the last good picture stays");
    desk.wait_for_color(BOX[0], BOX[1], [255, 0, 0]);
    desk.drag(AT, [AT[0] + 150, AT[1]]);
    desk.wait_for_color(BOX[0], BOX[1], level(0.2));
    folder.write("textures/loops.wgsl", &loops(0.6, "false", "3"));
    desk.wait_for_color(AT[0], AT[1], level(0.6));
}

#[test]
fn a_number_that_makes_a_loop_endless_is_taken_back_by_the_next() {
    let Some((folder, mut desk)) = opened() else { return };
    let made = desk.seen.last().expect("it is ready")["pipelines"].clone();
    for count in [50_000, 16_000_000] {
        folder.write("scene.ron", &scene(&format!("Loops(count: {count})")));
        expect_told(&mut desk);
        wait_for_last(&mut desk);
        assert_eq!(desk.color_at(AT[0], AT[1]), level(0.2));
        folder.write("scene.ron", &scene("Loops(count: 5)"));
        let shown = desk.wait_for("a number that is right", |e| {
            e["event"] == "presented" && e["samples"] == 64 && e["change"] == "numbers"
        });
        assert_eq!(shown["pipelines"], made, "a number is an upload");
    }
    folder.write("textures/loops.wgsl", &loops(0.8, "false", "3"));
    desk.wait_for_color(AT[0], AT[1], level(0.8));
}

#[test]
fn a_driver_that_draws_wrong_is_reported_over_the_picture() {
    let folder = Folder::new();
    let returns = |i| format!("    if k == {i} {{ return {:?}; }}\n", 0.01 * f32::from(i));
    let body: String = (0..100u8).map(returns).collect();
    let head = "/// A test.\nfn deep(at: Surface) -> f32 {\n    let k = i32(50.0 + 50.0 * at.uv.x);\n";
    folder.write("textures/deep.wgsl", &format!("{head}{body}    return 1.0;\n}}\n"));
    folder.write("scene.ron", &scene("Deep()"));
    let Some(mut desk) = Desk::open(folder.path(), "scene.ron", SIZE) else { return };
    let warned = desk.wait_for_event("warned");
    let text = warned["text"].as_str().unwrap_or_default();
    assert!(text.contains("branches are nested") && text.contains("draws `scene.ron` wrong"), "{text}");
    // A comment changes nothing of that.
    folder.write("scene.ron", &(scene("Deep()") + "// Seen."));
    desk.wait_for_event("unchanged");
    folder.write("textures/deep.wgsl", &format!("{head}    return 0.5;\n}}\n"));
    desk.wait_for_color(AT[0], AT[1], level(0.5));
}

#[test]
fn a_first_scene_that_does_not_end_waits_for_an_edit() {
    let folder = Folder::new();
    folder.write("textures/loops.wgsl", &loops(0.2, "true", "3"));
    folder.write("scene.ron", &scene("Loops()"));
    let Some(mut desk) = Desk::open(folder.path(), "scene.ron", SIZE) else { return };
    expect_told(&mut desk);
    folder.write("textures/loops.wgsl", &loops(0.2, "false", "3"));
    desk.wait_for_color(AT[0], AT[1], level(0.2));
}

#[test]
fn a_version_that_the_device_is_lost_over_is_not_drawn_again() {
    let Some((folder, mut desk)) = opened() else { return };
    // So much work that the device is gone before a picture is there.
    let slow = loops(0.6, "false", "30000").replace("fract(f32(i & 1u) * ", "perlinNoise(vec3f(f32(i)) + ");
    folder.write("textures/loops.wgsl", &slow);
    desk.wait_for_event("begun");
    desk.say("lose-device");
    desk.wait_for_event("restarted");
    let broken = desk.wait_for_event("broken");
    let told = broken["text"].as_str().unwrap_or_default();
    assert!(told.contains("the GPU stopped when it first drew this version"), "{told}");
    wait_for_last(&mut desk);
    assert_eq!(desk.color_at(AT[0], AT[1]), level(0.2), "the last good scene is there again");
    folder.write("textures/loops.wgsl", &loops(0.6, "false", "3"));
    desk.wait_for_color(AT[0], AT[1], level(0.6));
    assert_eq!(desk.end(), "", "it is told in the window alone");
}
