//! The window's panel without a window: widgets are found by the names that a screen reader would say, and what
//! they do shows in the file, in what is asked of the window, and in what is laid out next.

// A folder of the same name is where the parts lie.
#[path = "interface/mod.rs"]
mod parts;
