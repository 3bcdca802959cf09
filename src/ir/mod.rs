//! The resolved scene: plain numbers, no name unresolved, no NaN; radians, linear RGB, world space.
//!
//! In: what `resolve` makes of a [`crate::scene::Value`]. Out: what `wgsl` writes and `gpu` uploads.

pub mod fields;
mod light;
mod measure;
pub mod points;
mod reached;
mod render;
mod resolve;
mod solid;
mod surface;

use glam::Vec3;

pub use light::{Light, LightKind};
pub use measure::Measure;
pub use render::{MAX_BOUNCES, Render, ToneMap, Transfer};
pub use resolve::{default_name, placed, resolve};
pub use solid::{Csg, CsgOperation, Object, Primitive, Solid, Space};
pub use surface::{
    Bump, Call, Fit, ImageTexture, Interpolation, Material, Property, Ramp, Texture, Triplanar, Value,
};

use crate::assets::{Image, Model};

/// A whole scene, in the author's order.
#[derive(Clone, Debug, PartialEq)]
pub struct Scene {
    /// The file's name, as messages use it.
    pub name: String,
    pub camera: Camera,
    /// A color of the point that a ray's direction marks on the unit sphere.
    pub background: Value,
    pub ambient: Vec3,
    pub lights: Vec<Light>,
    /// All that the author names, used or not.
    pub images: Vec<Image>,
    pub models: Vec<Model>,
    pub textures: Vec<Texture>,
    pub materials: Vec<Material>,
    pub primitives: Vec<Primitive>,
    /// What rays are tested against: each primitive is in one of them, alone or as a part.
    pub objects: Vec<Object>,
    pub render: Render,
    /// The number that the shader is to compute besides, for a debug view. No scene says so itself.
    pub measure: Option<Measure>,
}

#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Camera {
    pub eye: Vec3,
    pub target: Vec3,
    pub up: Vec3,
    /// Vertical, radians.
    pub fov: f32,
}

impl Scene {
    /// Whether both take the same from files.
    pub fn has_files_of(&self, other: &Self) -> bool {
        self.images == other.images && self.models == other.models
    }

    /// How many objects cast shadows.
    pub fn casters(&self) -> u32 {
        self.objects.iter().filter(|object| object.casts_shadow).count() as u32
    }

    /// Whether any material lets light through.
    pub fn transmits(&self) -> bool {
        let properties = self.materials.iter().flat_map(|m| &m.properties);
        properties.into_iter().any(|(property, _)| *property == Property::Transmission)
    }
}
