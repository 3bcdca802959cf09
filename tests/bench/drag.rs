//! How long a number that is dragged takes from the hand to the screen, with the software driver:
//! `cargo test --test drag_bench`.
#![cfg(target_os = "linux")]

// A bench takes a part of it.
#[allow(dead_code)]
#[path = "../common/desk.rs"]
mod desk;

use std::time::Instant;

use desk::Desk;

const SIZE: [u16; 2] = [1280, 720];
const STEPS: i16 = 500;
/// The green ball of scenes/table.ron; and once it is chosen, the number beside its radius, and its color.
const BALL: [i16; 2] = [700, 480];
const RADIUS: [i16; 2] = [1098, 472];
const COLOR: [i16; 2] = [1125, 520];

fn main() {
    let home = tempfile::TempDir::new().expect("there is room for a folder");
    std::fs::write(home.path().join("scene.ron"), include_str!("../../scenes/table.ron"))
        .expect("the folder is writable");
    let Some(mut desk) = Desk::open(home.path(), "scene.ron", SIZE) else { return };
    let before = desk.wait_for_event("ready")["pipelines"].clone();
    desk.click(BALL);
    desk.wait_for_event("chosen");
    // Its values are there once this one is.
    desk.wait_for_color(COLOR[0], COLOR[1], [0, 255, 0]);
    desk.hold(RADIUS);
    let (mut shown, mut pipelines, mut edit) = (vec![], before.clone(), 0);
    for step in 1..=STEPS {
        // To and fro, so that the pointer stays in the window, and far enough for another number.
        let along = (3 * step % 300 - 150).abs();
        let moved = Instant::now();
        desk.point([RADIUS[0] + 60 - along, RADIUS[1]]);
        let event = desk.wait_for("another number", |e| {
            e["event"] == "presented" && e["change"] == "numbers" && e["edit"].as_u64() > Some(edit)
        });
        shown.push(moved.elapsed().as_secs_f64() * 1e3);
        edit = event["edit"].as_u64().expect("a number");
        pipelines = event["pipelines"].clone();
    }
    desk.let_go(RADIUS);
    shown.sort_by(f64::total_cmp);
    let at = |share: f64| shown[((shown.len() - 1) as f64 * share).round() as usize];
    println!(
        "hand to screen, {STEPS} steps, ms: median {:.0}, p95 {:.0}, max {:.0}; pipelines {before} before, {pipelines} after",
        at(0.5),
        at(0.95),
        at(1.0)
    );
}
