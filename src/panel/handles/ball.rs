//! The handle of a direction: a knob on a ball in the middle of the picture, turned by a hand.
//!
//! In: a [`Lens`], a direction, how the pointer has moved. Out: the direction after that. The ball is flat on
//! the screen, without perspective, so that it looks alike wherever it is.

use glam::{Vec2, Vec3, vec2};

use crate::frame::Lens;

/// A ball whose middle is that of the picture.
#[derive(Clone, Copy, Debug)]
pub struct Ball {
    pub lens: Lens,
    /// Pixels to a point of the screen.
    pub scale: f32,
}

/// Of the ball, points of the screen.
const RADIUS: f32 = 96.0;
/// How far from the knob the pointer may be that takes it, points.
const NEAR: f32 = 12.0;

impl Ball {
    pub fn middle(&self) -> Vec2 {
        0.5 * self.lens.size
    }

    pub fn radius(&self) -> f32 {
        RADIUS * self.scale
    }

    /// Where the knob is seen of a direction of length 1: the direction leads from it to the middle.
    pub fn knob(&self, direction: Vec3) -> Vec2 {
        self.middle() - self.radius() * vec2(direction.dot(self.lens.right), -direction.dot(self.lens.up))
    }

    /// Whether the knob lies on the half of the ball that is turned away.
    pub fn is_behind(&self, direction: Vec3) -> bool {
        direction.dot(self.lens.forward) < 0.0
    }

    pub fn is_under(&self, pointer: Vec2, direction: Vec3) -> bool {
        pointer.distance(self.knob(direction)) < NEAR * self.scale
    }

    /// The direction, of length 1, once a hand that has taken the knob of `direction` has moved by `by`. Past
    /// the ball's rim the knob goes on over its other half.
    pub fn turned(&self, direction: Vec3, by: Vec2) -> Vec3 {
        let place = (self.knob(direction) + by - self.middle()) / self.radius();
        let (away, half) = (place.length(), if self.is_behind(direction) { -1.0 } else { 1.0 });
        let (folded, half) = if away > 1.0 { ((2.0 - away).max(0.0), -half) } else { (away, half) };
        let flat = place * if away > 0.0 { folded / away } else { 0.0 };
        let near = half * (1.0 - folded * folded).sqrt();
        let Lens { forward, right, up, .. } = self.lens;
        (near * forward - flat.x * right + flat.y * up).normalize()
    }
}
