//! The moment at which a picture is taken.
//!
//! In: a scene, or the wishes of who looks at it. Out: all that a picture depends on besides the scene.

use super::{Split, View};
use crate::ir;

/// The moment at which a picture is taken, and by which camera.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Moment {
    pub camera: ir::Camera,
    pub view: View,
    /// The second view, over the right part of the picture.
    pub split: Option<Split>,
    /// The number at which the colors of [`View::Value`] end, more than 0.
    pub reach: f32,
    /// Seconds.
    pub time: f32,
    /// Pixels from the top left.
    pub mouse: [f32; 2],
}

impl Moment {
    /// As the scene says, at its beginning.
    pub fn of(scene: &ir::Scene) -> Self {
        let (camera, view) = (scene.camera, View::Color);
        Self { camera, view, split: None, reach: 1.0, time: 0.0, mouse: [0.0; 2] }
    }
}
