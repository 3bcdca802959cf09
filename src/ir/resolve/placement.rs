//! Where things stand: scale, rotate, translate, and the boxes that authors draw around them.

use glam::{DAffine3, DMat3, DQuat, DVec3, Vec3};

use super::Resolver;
use super::reader::Fields;
use crate::ir::Space;
use crate::ir::fields::BOUNDS;
use crate::scene::{self, Kind};

/// The map from the world into the space of what `to_world` places.
pub fn into_space(to_world: DAffine3) -> Space {
    let inverse = to_world.inverse();
    let row = |i: usize| {
        let m = inverse.matrix3.row(i);
        let at = inverse.translation[i];
        [m.x, m.y, m.z, at].map(rounded)
    };
    [row(0), row(1), row(2)]
}

/// The map into the space around of what is scaled, then turned about x, y and z by degrees, then moved.
pub fn placed(translate: DVec3, rotate_deg: Vec3, scale: Vec3) -> DAffine3 {
    let turned = rotate_deg.as_dvec3() * (std::f64::consts::PI / 180.0);
    let turn = DQuat::from_rotation_z(turned.z)
        * DQuat::from_rotation_y(turned.y)
        * DQuat::from_rotation_x(turned.x);
    let scale = DMat3::from_diagonal(scale.as_dvec3());
    DAffine3::from_mat3_translation(DMat3::from_quat(turn) * scale, translate)
}

impl Resolver<'_> {
    /// The map into the space around, where the author moves the thing.
    pub fn placement(&mut self, fields: &mut Fields<'_>) -> Option<DAffine3> {
        let moved = ["translate", "rotate_deg", "scale"].iter().any(|field| fields.has(field));
        // A model of a survey is brought back from far away.
        let translate = fields.exact_vector(self, "translate");
        let rotate_deg = fields.vector(self, "rotate_deg");
        let scale = match fields.get("scale") {
            Some(value) => self.scale(value),
            None => Vec3::ONE,
        };
        moved.then(|| placed(translate, rotate_deg, scale))
    }

    fn scale(&mut self, value: &scene::Value) -> Vec3 {
        let scale = match value.kind {
            Kind::Number(_) => self.number(value, None).map(Vec3::splat),
            Kind::Tuple(_) | Kind::List(_) => self.vector(value),
            _ => {
                self.mismatch(value, "a number or a vector (x, y, z)");
                None
            }
        };
        let scale = scale.unwrap_or(Vec3::ONE);
        if scale.abs().min_element() < 1e-6 {
            self.error(&value.span, "`scale` must not be 0")
                .help
                .push("remove the object, or make it thin: 0.001".into());
            return Vec3::ONE;
        }
        scale
    }

    pub fn bounds(&mut self, written: &scene::Value) -> Option<(Vec3, Vec3)> {
        let before = self.problems.len();
        let mut fields = Fields::of(self, written, "`bounds`", &[BOUNDS]);
        let min = fields.vector(self, "min");
        let max = fields.vector(self, "max");
        fields.finish(self);
        if self.problems.len() == before && min.cmpge(max).any() {
            self.error(&written.span, "`min` must be below `max`");
            return None;
        }
        Some((min, max))
    }
}

/// Rid of the last bits of sine and cosine, which differ between systems.
fn rounded(x: f64) -> f32 {
    ((x * 1e9).round() / 1e9) as f32
}
