//! `raytoy view`: a scene in a window.

use std::io::BufRead;
use std::sync::mpsc::{Receiver, channel};
use std::sync::{Arc, Mutex};

use super::args::ViewOptions;
use super::{Failure, Result};
use crate::panel;
use crate::window;

pub fn run(options: &ViewOptions) -> Result {
    if !options.scene.exists() {
        return Err(Failure::Call(format!("there is no file `{}`", options.scene.display())));
    }
    let disk = super::disk(&options.root, [&options.scene])?;
    // SAFETY: the program has one thread until the window opens.
    unsafe { crate::gpu::prefer_quick_compiles() };
    let on_event = |event: &window::Event| {
        if options.events {
            println!("{}", serde_json::to_string(event).expect("numbers and strings"));
        }
    };
    let (scene, adapter) = (options.scene.clone(), options.adapter.clone());
    let variable = |name: &str| std::env::var_os(name);
    let (memory, cache) = (panel::folder(options.events, variable), panel::cache(options.events, variable));
    let remote = options.events.then(|| Arc::new(Mutex::new(remote())));
    let window = window::Options { scene, disk, size: options.size, adapter, memory, cache, remote };
    window::run(window, &on_event).map_err(Failure::Call)
}

/// What a program that drives the window writes to it, a word a line.
fn remote() -> Receiver<window::Remote> {
    let (sender, remote) = channel();
    std::thread::spawn(move || {
        for line in std::io::stdin().lock().lines().map_while(std::io::Result::ok) {
            match line.trim() {
                "lose-device" => drop(sender.send(window::Remote::LoseDevice)),
                other => eprintln!("unknown command `{other}`; known: lose-device"),
            }
        }
    });
    remote
}
