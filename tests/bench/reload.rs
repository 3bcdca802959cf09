//! How long an edit takes from the save to the screen, with the software driver and without its shader cache:
//! `cargo test --test reload_bench -- [SCENE…]`, all of them unless told.
#![cfg(target_os = "linux")]

// A bench takes a part of it.
#[allow(dead_code)]
#[path = "../common/desk.rs"]
mod desk;

use std::time::Instant;

use desk::Desk;

const ROUNDS: usize = 20;

fn main() {
    // The driver of the window inherits it. Nothing else runs in this program yet.
    unsafe { std::env::set_var("MESA_SHADER_CACHE_DISABLE", "true") };
    let wanted: Vec<String> = std::env::args().skip(1).collect();
    let scenes = [
        ("two_suns", include_str!("../../scenes/two_suns.ron")),
        ("table", include_str!("../../scenes/table.ron")),
        ("mirror_room", include_str!("../../scenes/mirror_room.ron")),
        ("textures", include_str!("../../scenes/textures.ron")),
        ("shapes", include_str!("../../scenes/shapes.ron")),
        ("glass", include_str!("../../scenes/glass.ron")),
        ("solids", include_str!("../../scenes/solids.ron")),
        ("fractals", include_str!("../../scenes/fractals.ron")),
    ];
    for (name, text) in scenes {
        if wanted.is_empty() || wanted.iter().any(|scene| scene == name) {
            measure(name, text);
        }
    }
}

/// Adds and removes a disk, which is another shader each time, and tells how long each took to show.
fn measure(name: &str, text: &str) {
    let home = tempfile::TempDir::new().expect("there is room for a folder");
    let scene = home.path().join("scene.ron");
    std::fs::write(&scene, text).expect("the folder is writable");
    let Some(mut desk) = Desk::open(home.path(), "scene.ron", [1280, 720]) else { return };
    desk.wait_for_event("ready");
    let (mut shown, mut blocked) = (vec![], vec![]);
    for round in 0..ROUNDS {
        let disk = format!("Disk(name: \"round {round}\", center: (0, 0.01, 0), radius: 0.3),\n");
        let edited = if round % 2 == 0 {
            text.replacen("objects: [", &format!("objects: [{disk}"), 1)
        } else {
            text.into()
        };
        let saved = Instant::now();
        std::fs::write(&scene, edited).expect("the folder is writable");
        let event = desk.wait_for("a structural edit", |e| {
            e["event"] == "presented" && e["change"] == "structure" && e["edit"] == round as u64 + 1
        });
        shown.push(saved.elapsed().as_secs_f64() * 1e3);
        blocked.push(event["blocked_ms"].as_f64().expect("a number"));
        desk.wait_for_event("ready");
    }
    println!("{name:<12} save to screen, ms: {}   window blocked, ms: {}", spread(shown), spread(blocked));
}

/// Minimum, median, 95th percentile and maximum.
fn spread(mut values: Vec<f64>) -> String {
    values.sort_by(f64::total_cmp);
    let at = |share: f64| values[((values.len() - 1) as f64 * share).round() as usize];
    format!("min {:.0}, median {:.0}, p95 {:.0}, max {:.0}", at(0.0), at(0.5), at(0.95), at(1.0))
}
