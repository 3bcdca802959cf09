//! What raytoy reads, writes and says. Needs neither a GPU nor a display.

#[path = "../common/mod.rs"]
mod common;

mod broken_scenes;
mod changes;
mod cli;
mod diff;
mod edit;
mod edits;
mod errors;
mod golden;
mod history;
mod judge;
mod outline;
mod picture_files;
mod reading;
mod root;
mod settings;
mod tidy;
