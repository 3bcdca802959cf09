//! The resolved scene: plain numbers, no name unresolved, no NaN; radians, linear RGB, world space.
//!
//! In: what `resolve` makes of a [`crate::scene::Value`]. Out: what `wgsl` writes and `gpu` uploads.

pub mod fields;
mod light;
mod measure;
mod parts;
pub mod points;
mod resolve;

use std::sync::Arc;

use glam::Vec3;

pub use light::{Light, LightKind};
pub use measure::Measure;
pub use resolve::{default_name, placed, resolve};

use crate::assets::{Image, Model};
use crate::library::{Const, Function, Type};

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
    pub images: Vec<Image>,
    pub models: Vec<Model>,
    pub textures: Vec<Texture>,
    pub materials: Vec<Material>,
    pub objects: Vec<Object>,
    /// What rays are tested against: each object is in one of them, alone or as a part.
    pub bodies: Vec<Body>,
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

/// What a shader computes at a surface point.
#[derive(Clone, Debug, PartialEq)]
pub enum Value {
    Const(Const),
    /// One of [`Scene::models`].
    Model(usize),
    Call(Call),
    /// One of [`Scene::textures`].
    Texture(usize),
    Ramp(Box<Ramp>),
    Triplanar(Box<Triplanar>),
    Picture(Box<Picture>),
    /// A number as a color.
    Grey(Box<Value>),
    /// A color as a number.
    Luminance(Box<Value>),
}

/// A texture or mapping with its arguments.
#[derive(Clone, Debug, PartialEq)]
pub struct Call {
    pub function: Arc<Function>,
    /// What moves the point first; all arguments are evaluated where the function itself is.
    pub at: Option<Box<Call>>,
    /// One for each parameter.
    pub arguments: Vec<Value>,
}

/// Colors at places of a pattern, and passages between them.
#[derive(Clone, Debug, PartialEq)]
pub struct Ramp {
    /// What moves the point first.
    pub at: Option<Box<Call>>,
    pub by: Value,
    /// At least two, in ascending order.
    pub stops: Vec<(f32, Value)>,
    pub interpolation: Interpolation,
}

/// How a ramp goes from stop to stop.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Interpolation {
    Linear,
    /// Level at each stop.
    Smooth,
    /// Each stop as it is, up to the next.
    Constant,
}

/// A flat texture laid on from three sides.
#[derive(Clone, Debug, PartialEq)]
pub struct Triplanar {
    /// What moves the point first.
    pub at: Option<Box<Call>>,
    pub of: Value,
    /// How soon one side gives way to the next.
    pub sharpness: f32,
}

/// An image that lies on the uv plane.
#[derive(Clone, Debug, PartialEq)]
pub struct Picture {
    /// What moves the point first.
    pub at: Option<Box<Call>>,
    /// One of [`Scene::images`].
    pub image: usize,
    pub ty: Type,
    /// Scene units, and the height follows; left out it covers the whole surface where that has an end.
    pub width: Option<f32>,
    pub fit: Fit,
    /// What is seen where the image is clear, at the point before it is moved; left out, nothing is.
    pub under: Option<Value>,
    /// Whether it begins again beyond its edges; else they go on.
    pub repeat: bool,
}

/// What an image is laid on.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Fit {
    /// The whole of a surface: of a ball, of the sky, of a model's uv from 0 to 1. Where the surface has no
    /// whole, the uv plane.
    Surface,
    /// That of the mapping that moves the point, if that has a whole; else the uv plane.
    Mapping,
    /// The uv plane, its lower left corner at the origin.
    Plane,
    /// The whole of the surface, at any width; uv from 0 to 1 where it has no whole.
    Whole,
}

/// A texture with a name.
#[derive(Clone, Debug, PartialEq)]
pub struct Texture {
    pub name: String,
    pub ty: Type,
    pub value: Value,
}

#[derive(Clone, Debug, PartialEq)]
pub struct Material {
    pub name: String,
    /// What the author has set, in the order of [`Property`].
    pub properties: Vec<(Property, Value)>,
    pub bump: Option<Bump>,
}

/// A field of WGSL's `Material`.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Property {
    Color,
    Specular,
    Shininess,
    Reflectivity,
    Fresnel,
    Transmission,
    Ior,
    Emission,
}

/// A height over the surface, scene units.
#[derive(Clone, Debug, PartialEq)]
pub struct Bump {
    pub height: Value,
    pub strength: f32,
}

/// A shape with a surface of its own.
#[derive(Clone, Debug, PartialEq)]
pub struct Object {
    pub name: String,
    /// The author's words, on one line.
    pub caption: String,
    pub shape: Arc<Function>,
    /// One for each parameter. Those of a shape that gives a distance may vary from point to point.
    pub arguments: Vec<Value>,
    /// One of [`Scene::materials`].
    pub material: usize,
    /// Where it stands, if it was moved.
    pub space: Option<Space>,
    /// Whether it is cut away from another solid, which shows its surface from behind.
    pub inverted: bool,
}

/// The rows of the affine map from the world into an object's space.
pub type Space = [[f32; 4]; 3];

/// What a ray meets as one.
#[derive(Clone, Debug, PartialEq)]
pub struct Body {
    pub solid: Solid,
    /// Where it stands, if it was moved.
    pub space: Option<Space>,
    /// Corners of a box in the body's space that holds all of it.
    pub bounds: Option<(Vec3, Vec3)>,
    pub visible: bool,
    pub casts_shadow: bool,
}

#[derive(Clone, Debug, PartialEq)]
pub enum Solid {
    /// One of [`Scene::objects`].
    Object(usize),
    Combination(Combination),
}

/// A solid made of solids.
#[derive(Clone, Debug, PartialEq)]
pub struct Combination {
    pub name: String,
    /// The author's words, on one line, without the parts.
    pub caption: String,
    pub operation: Operation,
    /// At least one.
    pub parts: Vec<Solid>,
}

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Operation {
    /// What is in any part.
    Union,
    /// What is in every part.
    Intersection,
    /// What is in the first part and in no other.
    Difference,
}

/// How the picture is made. All of it is data: none of it changes the shader.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Render {
    pub max_bounces: u32,
    pub shadows: bool,
    pub shadow_samples: u32,
    pub texture_filter: bool,
    pub transfer: Transfer,
    /// Factor of the light, from the author's stops.
    pub gain: f32,
    pub tone_map: ToneMap,
}

#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Transfer {
    Linear,
    Srgb,
    Gamma(f32),
}

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum ToneMap {
    Clamp,
    Reinhard,
    Aces,
    Agx,
}

/// The most bounces that a scene may ask for.
pub const MAX_BOUNCES: u32 = 100;

impl Object {
    /// Whether a texture takes part in its shape.
    pub fn is_textured(&self) -> bool {
        self.arguments.iter().any(|argument| !matches!(argument, Value::Const(_) | Value::Model(_)))
    }
}

impl Material {
    /// Whether it varies over a surface, bumps aside.
    pub fn is_textured(&self) -> bool {
        self.properties.iter().any(|(_, value)| !matches!(value, Value::Const(_)))
    }
}

impl Scene {
    /// Whether both take the same from files.
    pub fn has_files_of(&self, other: &Self) -> bool {
        self.images == other.images && self.models == other.models
    }

    /// How many bodies cast shadows.
    pub fn casters(&self) -> u32 {
        self.bodies.iter().filter(|body| body.casts_shadow).count() as u32
    }

    /// Whether any material lets light through.
    pub fn transmits(&self) -> bool {
        let properties = self.materials.iter().flat_map(|m| &m.properties);
        properties.into_iter().any(|(property, _)| *property == Property::Transmission)
    }
}
