//! A bar on the terminal for work that takes long.

use std::ops::ControlFlow;
use std::time::{Duration, Instant};

use indicatif::{ProgressBar, ProgressStyle};

/// Shows a bar on the terminal once the work takes longer than a person likes to wait. It always goes on.
pub fn with_progress<T>(name: &str, work: impl FnOnce(&mut dyn FnMut(f32) -> ControlFlow<()>) -> T) -> T {
    let style =
        ProgressStyle::with_template("{msg} [{bar:40}] {percent}%, {eta} left").expect("a valid template");
    let bar = ProgressBar::hidden().with_style(style.progress_chars("=> ")).with_message(name.to_owned());
    bar.set_length(1000);
    let start = Instant::now();
    let done = work(&mut |share| {
        if start.elapsed() > Duration::from_millis(500) && bar.is_hidden() {
            bar.set_draw_target(indicatif::ProgressDrawTarget::stderr());
        }
        bar.set_position((share * 1000.0) as u64);
        ControlFlow::Continue(())
    });
    bar.finish_and_clear();
    done
}
