//! The handles of a place: three axes of the world, and the plane that faces the camera.
//!
//! In: a [`Lens`], a place, where the pointer is. Out: which handle lies under it, and the point of the world
//! to which a hand that has taken a handle points.

use glam::{Vec2, Vec3};

use crate::frame::Lens;

/// What a hand can take.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Handle {
    X,
    Y,
    Z,
    /// The middle: it moves in the plane that faces the camera.
    Plane,
}

/// The handles of one place, as long on the screen from everywhere.
#[derive(Clone, Copy, Debug)]
pub struct Tripod {
    pub lens: Lens,
    pub place: Vec3,
    /// Pixels to a point of the screen.
    pub scale: f32,
}

/// Points of the screen: an axis that lies across the view, and where it begins.
const LENGTH: f32 = 84.0;
pub const GAP: f32 = 12.0;
/// How far from a handle the pointer may be that takes it, points.
const NEAR: f32 = 7.0;
/// An axis that points at the eye so much that less than this share of it is seen cannot be dragged.
const SHORTEST: f32 = 0.2;
/// Nothing is moved farther from the eye at once than so many times its distance.
const FARTHEST: f32 = 100.0;
/// Lines that run more alike than this, the square of the sine, have no one point that is nearest.
const PARALLEL: f32 = 1e-6;

impl Handle {
    pub const AXES: [Handle; 3] = [Handle::X, Handle::Y, Handle::Z];

    /// The axis of the world along which it moves; none for the plane.
    pub fn axis(self) -> Option<Vec3> {
        match self {
            Handle::X => Some(Vec3::X),
            Handle::Y => Some(Vec3::Y),
            Handle::Z => Some(Vec3::Z),
            Handle::Plane => None,
        }
    }
}

impl Tripod {
    /// None where `place` is not before the eye.
    pub fn new(lens: Lens, place: Vec3, scale: f32) -> Option<Self> {
        let depth = lens.depth(place);
        (depth.is_finite() && depth > 0.0).then_some(Self { lens, place, scale })
    }

    /// Where the place itself is seen.
    pub fn middle(&self) -> Vec2 {
        self.lens.pixel(self.place)
    }

    /// Where an axis ends on the screen; None for the plane, and where it points at the eye or away from it.
    pub fn tip(&self, handle: Handle) -> Option<Vec2> {
        let length = LENGTH * self.scale;
        let end = self.place + length * self.lens.pixel_size(self.place) * handle.axis()?;
        // Of a very wide view it may lie behind the eye.
        if self.lens.depth(end) < 0.1 * self.lens.depth(self.place) {
            return None;
        }
        let tip = self.lens.pixel(end);
        (tip.distance(self.middle()) > SHORTEST * length).then_some(tip)
    }

    /// What the pointer would take.
    pub fn under(&self, pointer: Vec2) -> Option<Handle> {
        let middle = self.middle();
        if pointer.distance(middle) < GAP * self.scale {
            return Some(Handle::Plane);
        }
        let away = |handle: Handle| Some((handle, to_segment(pointer, middle, self.tip(handle)?)));
        let near = Handle::AXES.into_iter().filter_map(away).filter(|(_, d)| *d < NEAR * self.scale);
        near.min_by(|(_, a), (_, b)| a.total_cmp(b)).map(|(handle, _)| handle)
    }

    /// The point of the handle's axis or plane to which the pointer points; None where it points beyond the
    /// horizon.
    ///
    /// On an axis it is the point nearest to the pointer's ray (Eberly, Distance Between Two Line Segments in
    /// 3D, Geometric Tools, for lines).
    pub fn point(&self, handle: Handle, pointer: Vec2) -> Option<Vec3> {
        let Self { lens, place, .. } = *self;
        let (direction, to_place) = (lens.direction(pointer), place - lens.eye);
        let point = match handle.axis() {
            Some(axis) => {
                let (alike, along) = (axis.dot(direction), direction.dot(to_place));
                let apart = Some(axis.cross(direction).length_squared()).filter(|apart| *apart > PARALLEL)?;
                let way = (alike * along - axis.dot(to_place)) / apart;
                // Seen past its horizon, the axis is nearest behind the eye.
                (along + way * alike > 0.0).then_some(place + way * axis)?
            }
            None => lens.eye + lens.depth(place) / direction.dot(lens.forward) * direction,
        };
        let is_near = point.distance(lens.eye) < FARTHEST * to_place.length();
        (is_near && lens.depth(point) > 0.0).then_some(point)
    }
}

/// How far `point` is from the way between `from` and `to`.
pub fn to_segment(point: Vec2, from: Vec2, to: Vec2) -> f32 {
    let way = to - from;
    let share = ((point - from).dot(way) / way.length_squared().max(1e-12)).clamp(0.0, 1.0);
    point.distance(from + share * way)
}
