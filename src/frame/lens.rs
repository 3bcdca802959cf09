//! The camera's rays, and where the points of the world lie in its picture.
//!
//! In: a camera and the size of a picture. Out: the rays of shaders/main.wgsl, and their inverse.

use glam::{Vec2, Vec3, vec2};

use crate::ir::Camera;

/// A camera in front of a picture. Pixels count from the top left corner, so the first has its middle at
/// (0.5, 0.5).
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Lens {
    /// World space.
    pub eye: Vec3,
    /// Along the view, to the right and upwards, all of length 1.
    pub forward: Vec3,
    pub right: Vec3,
    pub up: Vec3,
    /// The tangent of half the vertical angle of view.
    pub half: f32,
    /// Pixels.
    pub size: Vec2,
}

impl Lens {
    /// The axes of LANGUAGE.md: forward, right, true up.
    pub fn new(camera: &Camera, size: [u32; 2]) -> Self {
        let forward = (camera.target - camera.eye).normalize_or(Vec3::NEG_Z);
        let right = forward.cross(camera.up).normalize_or(Vec3::X);
        let up = right.cross(forward);
        let half = (camera.fov / 2.0).tan();
        Self { eye: camera.eye, forward, right, up, half, size: vec2(size[0] as f32, size[1] as f32) }
    }

    /// The direction of the ray through a place of the picture; length 1.
    pub fn direction(&self, pixel: Vec2) -> Vec3 {
        let place = (2.0 * pixel / self.size - 1.0) * vec2(self.size.x / self.size.y, -1.0) * self.half;
        (self.forward + place.x * self.right + place.y * self.up).normalize()
    }

    /// How far a point lies along the view; negative behind the eye.
    pub fn depth(&self, point: Vec3) -> f32 {
        (point - self.eye).dot(self.forward)
    }

    /// How wide and high a pixel is at the depth of a point before the eye, scene units.
    pub fn pixel_size(&self, point: Vec3) -> f32 {
        2.0 * self.half * self.depth(point) / self.size.y
    }

    /// The place of a point in the picture, or beyond its edges. It must lie before the eye.
    pub fn pixel(&self, point: Vec3) -> Vec2 {
        let away = point - self.eye;
        let reach = self.half * away.dot(self.forward);
        let place = vec2(away.dot(self.right), -away.dot(self.up)) / reach;
        0.5 * (self.size + place * self.size.y)
    }
}
