//! The window: its parts by themselves, and all of it in an X server without a screen. Needs Xvfb and a Vulkan
//! driver.

// Of what is shared, the window takes a part.
#[allow(dead_code)]
#[path = "../common/mod.rs"]
mod common;
#[cfg(target_os = "linux")]
#[path = "../common/desk.rs"]
mod desk;
#[path = "../common/device.rs"]
mod device;

mod commands;
mod dragging;
mod gallery;
mod guard;
mod handles;
mod interface;
mod live_reload;
mod panel;
mod views;
