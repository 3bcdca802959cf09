//! What raytoy reads, writes and says. Needs neither a GPU nor a display.

#[path = "../common/mod.rs"]
mod common;
#[path = "../common/models/mod.rs"]
mod shared_models;

mod bindings;
mod broken_scenes;
mod changes;
mod circles;
mod cli;
mod diff;
mod edit;
mod editor;
mod edits;
mod errors;
mod forecast;
mod gallery;
mod golden;
mod history;
mod images_in_use;
mod integers;
mod interface;
mod judge;
mod models;
mod naming;
mod outline;
mod pace;
mod parts;
mod picture_files;
mod pictures;
mod reading;
mod root;
mod sections;
mod settings;
mod thumbnails;
mod tidy;
mod watch;
