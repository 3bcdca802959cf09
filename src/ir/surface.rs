//! What a surface looks like: textures, mappings, images and materials.
//!
//! In: names that `resolve` has found. Out: [`Value`]s, which `wgsl` writes as calls.

use std::sync::Arc;

use crate::library::{Const, Function, Type};

/// What a shader computes at a surface point.
#[derive(Clone, Debug, PartialEq)]
pub enum Value {
    Const(Const),
    /// One of [`super::Scene::models`].
    Model(usize),
    Call(Call),
    /// One of [`super::Scene::textures`].
    Texture(usize),
    Ramp(Box<Ramp>),
    Triplanar(Box<Triplanar>),
    Image(Box<ImageTexture>),
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
pub struct ImageTexture {
    /// What moves the point first.
    pub at: Option<Box<Call>>,
    /// One of [`super::Scene::images`].
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
    /// The author's words, on one line; empty where it is no call.
    pub caption: String,
    pub ty: Type,
    pub value: Value,
}

#[derive(Clone, Debug, PartialEq)]
pub struct Material {
    pub name: String,
    /// The author's words, on one line; empty where there are none.
    pub caption: String,
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

impl Material {
    /// Whether the author wrote none.
    pub fn is_unset(&self) -> bool {
        self.caption.is_empty() && self.properties.is_empty() && self.bump.is_none()
    }

    /// Whether it varies over a surface, bumps aside.
    pub fn is_textured(&self) -> bool {
        self.properties.iter().any(|(_, value)| !matches!(value, Value::Const(_)))
    }
}
