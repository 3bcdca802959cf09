//! Lines that stand for what a camera does not see: lights, its own target, the boxes around objects.
//!
//! In: the scene, and the camera that looks at it. Out: [`Line`]s in world space. Signs without a size of
//! their own are as large on the screen from everywhere.

use std::f32::consts::TAU;

use glam::{Affine3A, Mat3A, Vec3, Vec3A};

use super::lines::Line;
use crate::ir::{self, Camera, LightKind, Scene, Space};

/// Pixels.
const WIDTH: f32 = 1.5;
/// Lines of a circle.
const SEGMENTS: usize = 48;
/// Half of a sign, as a share of half the picture's height.
const SIGN: f32 = 0.04;

const TARGET: Vec3 = Vec3::new(0.35, 0.9, 1.0);
const BOUNDS: Vec3 = Vec3::new(0.45, 0.9, 0.45);

/// Each light in its own color. A point: a cross, and a circle of its radius. A direction: five arrows that
/// point at the camera's target. A spot: the same as a point, and its outer cone, whose side is as long as
/// the way to the target along its axis. A rectangle: its sides, and an arrow along its normal.
pub fn lights(scene: &Scene, camera: &Camera) -> Vec<Line> {
    scene.lights.iter().flat_map(|light| self::light(light, camera)).collect()
}

/// One of them.
pub fn light(light: &ir::Light, camera: &Camera) -> Vec<Line> {
    let brightest = light.emitted.max_element();
    let color = if brightest > 0.0 { light.emitted / brightest } else { Vec3::splat(0.2) };
    let ends = match light.kind {
        LightKind::Point { position, radius } => ball(position, radius, camera),
        LightKind::Directional { direction, .. } => rays(direction.normalize_or(Vec3::NEG_Y), camera),
        LightKind::Spot { position, radius, axis, outer, .. } => {
            let mut ends = ball(position, radius, camera);
            ends.extend(cone(position, axis, outer, camera));
            ends
        }
        LightKind::Rect { corner, u, v } => rectangle(corner, u, v, camera),
    };
    ends.into_iter().map(|ends| line(ends, color.powf(1.0 / 2.2))).collect()
}

/// A cross in the middle of the view, around which the camera turns.
pub fn camera_target(camera: &Camera) -> Vec<Line> {
    let Camera { target, .. } = *camera;
    cross(target, sign_size(target, camera)).map(|ends| line(ends, TARGET)).into()
}

/// The twelve edges of each box that the author has drawn around an object.
pub fn bounds(scene: &Scene) -> Vec<Line> {
    let boxes = scene.objects.iter().filter_map(|object| Some((object.bounds?, object.space.as_ref())));
    boxes.flat_map(|((low, high), space)| box_edges(low, high, to_world(space))).collect()
}

fn ball(position: Vec3, radius: f32, camera: &Camera) -> Vec<[Vec3; 2]> {
    let mut ends = cross(position, sign_size(position, camera)).to_vec();
    if radius > 0.0 {
        let (u, v) = (position - camera.eye).normalize_or(Vec3::NEG_Z).any_orthonormal_pair();
        ends.extend(circle(position, radius * u, radius * v));
    }
    ends
}

fn rays(direction: Vec3, camera: &Camera) -> Vec<[Vec3; 2]> {
    let size = sign_size(camera.target, camera);
    let (u, v) = direction.any_orthonormal_pair();
    let starts =
        [Vec3::ZERO, u, -u, v, -v].map(|aside| camera.target + size * (1.5 * aside - 10.0 * direction));
    starts.into_iter().flat_map(|start| arrow(start, start + 6.0 * size * direction, size)).collect()
}

fn cone(tip: Vec3, axis: Vec3, cosine: f32, camera: &Camera) -> Vec<[Vec3; 2]> {
    let (u, v) = axis.any_orthonormal_pair();
    let to_target = (camera.target - tip).dot(axis);
    // A wide cone is drawn by the length of its side.
    let side = to_target.max(8.0 * sign_size(tip, camera));
    let middle = tip + side * cosine * axis;
    let radius = side * (1.0 - cosine * cosine).max(0.0).sqrt();
    let mut ends = circle(middle, radius * u, radius * v);
    ends.extend([u, v, -u, -v].map(|aside| [tip, middle + radius * aside]));
    ends
}

fn rectangle(corner: Vec3, u: Vec3, v: Vec3, camera: &Camera) -> Vec<[Vec3; 2]> {
    let corners = [corner, corner + u, corner + u + v, corner + v];
    let mut ends: Vec<_> = (0..4).map(|i| [corners[i], corners[(i + 1) % 4]]).collect();
    let middle = corner + 0.5 * (u + v);
    let size = sign_size(middle, camera);
    ends.extend(arrow(middle, middle + 4.0 * size * u.cross(v).normalize_or_zero(), size));
    ends
}

/// A shaft and four barbs; nothing where it has no length.
fn arrow(from: Vec3, to: Vec3, size: f32) -> Vec<[Vec3; 2]> {
    let Some(direction) = (to - from).try_normalize() else { return vec![] };
    let (u, v) = direction.any_orthonormal_pair();
    let barbs = [u, -u, v, -v].map(|aside| [to, to + 0.5 * size * (0.6 * aside - direction)]);
    [[from, to]].into_iter().chain(barbs).collect()
}

fn cross(middle: Vec3, size: f32) -> [[Vec3; 2]; 3] {
    [Vec3::X, Vec3::Y, Vec3::Z].map(|axis| [middle - size * axis, middle + size * axis])
}

fn circle(middle: Vec3, u: Vec3, v: Vec3) -> Vec<[Vec3; 2]> {
    let point = |i: usize| {
        let (sine, cosine) = (TAU * i as f32 / SEGMENTS as f32).sin_cos();
        middle + cosine * u + sine * v
    };
    (0..SEGMENTS).map(|i| [point(i), point(i + 1)]).collect()
}

fn box_edges(low: Vec3, high: Vec3, to_world: Affine3A) -> Vec<Line> {
    let corner = |i: usize| {
        let share = Vec3::new((i & 1) as f32, (i >> 1 & 1) as f32, (i >> 2) as f32);
        to_world.transform_point3(low + share * (high - low))
    };
    let edges = (0..8).flat_map(|i| [1, 2, 4].map(|axis| (i, axis)));
    let edges = edges.filter(|(i, axis)| i & axis == 0);
    edges.map(|(i, axis)| line([corner(i), corner(i | axis)], BOUNDS)).collect()
}

/// From the space that the rows lead into.
fn to_world(space: Option<&Space>) -> Affine3A {
    let Some(rows) = space else { return Affine3A::IDENTITY };
    let [x, y, z] = rows.map(|[x, y, z, _]| Vec3A::new(x, y, z));
    let moved = Vec3::new(rows[0][3], rows[1][3], rows[2][3]);
    Affine3A { matrix3: Mat3A::from_cols(x, y, z).transpose(), translation: moved.into() }.inverse()
}

/// Half of a sign at `place`, scene units.
fn sign_size(place: Vec3, camera: &Camera) -> f32 {
    SIGN * place.distance(camera.eye) * (camera.fov / 2.0).tan()
}

fn line([from, to]: [Vec3; 2], color: Vec3) -> Line {
    Line { from, to, color, width: WIDTH }
}
