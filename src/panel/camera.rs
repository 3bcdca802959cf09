//! The camera under the mouse: orbit, pan, zoom.

use glam::{Quat, Vec2, Vec3};

use crate::ir::Camera;

/// Radians that a drag over the whole height of the picture turns by.
const TURN: f32 = std::f32::consts::PI;
/// The view never comes closer to straight up or down than this, radians.
const POLE: f32 = 0.02;

/// Turns around the target by a drag of `by`, in heights of the picture.
pub fn orbit(camera: &mut Camera, by: Vec2) {
    let up = camera.up.normalize_or(Vec3::Y);
    let arm = camera.eye - camera.target;
    let side = up.cross(arm).normalize_or(Vec3::X);
    let height = arm.angle_between(up);
    let lift = (height - by.y * TURN).clamp(POLE, std::f32::consts::PI - POLE) - height;
    let turn = Quat::from_axis_angle(up, -by.x * TURN) * Quat::from_axis_angle(side, lift);
    camera.eye = camera.target + turn * arm;
}

/// Moves eye and target so that the target follows a drag of `by`, in heights of the picture.
pub fn pan(camera: &mut Camera, by: Vec2) {
    let arm = camera.target - camera.eye;
    let forward = arm.normalize_or(Vec3::NEG_Z);
    let right = forward.cross(camera.up).normalize_or(Vec3::X);
    let height = 2.0 * arm.length() * (camera.fov / 2.0).tan();
    let step = (right * -by.x + right.cross(forward) * by.y) * height;
    camera.eye += step;
    camera.target += step;
}

/// Brings the eye nearer by a factor of e for each `amount`.
pub fn zoom(camera: &mut Camera, amount: f32) {
    let arm = camera.eye - camera.target;
    let length = (arm.length() * (-amount).exp()).clamp(1e-4, 1e6);
    camera.eye = camera.target + arm.normalize_or(Vec3::Z) * length;
}
