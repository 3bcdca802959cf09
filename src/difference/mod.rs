//! Differences between two texts, two pictures, two scenes: reports for people, programs and browsers.
//!
//! In: the two. Out: a [`TextDifference`], a [`PictureDifference`] or a [`SceneDifference`], and texts about
//! them.

pub mod html;
mod measures;
mod picture;
mod report;
mod scene;
mod shader;
mod text;

pub use measures::Measures;
pub use picture::{Drawing, PictureDifference, png, rgb};
pub use report::{human, json, page};
pub use scene::SceneDifference;
pub use shader::ShaderDifference;
pub use text::{Hunk, TextDifference, scene_of, with_origin_of};
