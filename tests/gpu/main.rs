//! What a GPU draws, and what is made for it. Needs a Vulkan driver: Mesa's lavapipe, unless `RAYTOY_ADAPTER` names
//! another.

#[path = "../common/mod.rs"]
mod common;
#[path = "../common/device.rs"]
mod device;
#[path = "../common/models/mod.rs"]
mod shared_models;

mod against_reference;
mod antialiasing;
mod capture;
mod default_limits;
mod diff;
mod draw;
mod export;
mod filter;
mod guard;
mod image_placement;
mod images;
mod inspection;
mod laws;
mod models;
mod patterns;
mod precision;
mod probe;
mod rays;
mod reference;
mod remote;
mod render;
mod scales;
mod shadows;
mod shapes;
mod sizeless;
mod sketch;
mod solids;
mod suite;
