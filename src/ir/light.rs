//! Lights: where they stand, how large they are, and what they give.

use glam::Vec3;

#[derive(Clone, Debug, PartialEq)]
pub struct Light {
    /// The author's words, on one line.
    pub caption: String,
    pub kind: LightKind,
    /// Color · intensity.
    pub emitted: Vec3,
    /// Weaker by the square of the distance.
    pub inverse_square: bool,
}

#[derive(Clone, Copy, Debug, PartialEq)]
pub enum LightKind {
    Point {
        position: Vec3,
        radius: f32,
    },
    /// `spread` is the tangent of half the angle under which it is seen.
    Directional {
        direction: Vec3,
        spread: f32,
    },
    /// `inner` and `outer` are cosines.
    Spot {
        position: Vec3,
        radius: f32,
        axis: Vec3,
        inner: f32,
        outer: f32,
    },
    Rect {
        corner: Vec3,
        u: Vec3,
        v: Vec3,
    },
}
