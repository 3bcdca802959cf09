//! `raytoy view`: a scene in a window.

use super::args::ViewOptions;
use super::{Failure, Result};
use crate::app;

pub fn run(options: &ViewOptions) -> Result {
    if !options.scene.exists() {
        return Err(Failure::Call(format!("there is no file `{}`", options.scene.display())));
    }
    // SAFETY: the program has one thread until the window opens.
    unsafe { crate::gpu::prefer_quick_compiles() };
    let on_event = |event: &app::Event| {
        if options.events {
            println!("{}", serde_json::to_string(event).expect("numbers and strings"));
        }
    };
    let window =
        app::Options { scene: options.scene.clone(), size: options.size, adapter: options.adapter.clone() };
    app::run(window, &on_event).map_err(Failure::Call)
}
