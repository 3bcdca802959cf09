//! What a hand at the window has: keys to press, and a file that tells what it did.

use std::path::Path;
use std::time::{Duration, Instant};

use super::PATIENCE;

/// X keysyms. Those of letters, digits and blanks are their ASCII codes.
pub const SHIFT: u32 = 0xffe1;
pub const CONTROL: u32 = 0xffe3;
pub const ENTER: u32 = 0xff0d;
pub const ESCAPE: u32 = 0xff1b;
pub const F1: u32 = 0xffbe;

pub fn text(file: &Path) -> String {
    std::fs::read_to_string(file).expect("the scene is there")
}

/// Waits until the file is as it is `wanted`.
pub fn wait_for_text(file: &Path, wanted: impl Fn(&str) -> bool) -> String {
    let until = Instant::now() + PATIENCE;
    loop {
        let now = text(file);
        if wanted(&now) {
            return now;
        }
        assert!(Instant::now() < until, "waited in vain; the file says {now}");
        std::thread::sleep(Duration::from_millis(10));
    }
}
