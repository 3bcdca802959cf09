//! The fields that a scene may set and that no WGSL file declares: what they take, their limits and defaults.
//!
//! In: nothing. Out: tables, by which `resolve` reads a scene and `outline` shows one.

mod tables;

pub use tables::{
    BOUNDS, BUMP, CAMERA, EVERY_LIGHT, EVERY_OBJECT, EVERY_SOLID, EVERY_TEXTURE, FORMS, LIGHTS, MATERIAL,
    OPERATIONS, RENDER, SCENE,
};

/// A field of a group.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Field {
    pub name: &'static str,
    pub takes: Takes,
    /// Whether the author must give it.
    pub is_required: bool,
    /// Whether it is one of the points that the thing around moves with.
    pub is_point: bool,
    /// Of its numbers, where they are no scene units: `degrees`, `stops`.
    pub unit: Option<&'static str>,
    /// What it is, as LANGUAGE.md says it; empty where the name says all.
    pub doc: &'static str,
}

/// What a field takes, and what holds where it is left out.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Takes {
    Number(Number),
    Vector {
        default: Option<[f32; 3]>,
    },
    /// A number or a vector of three, not 0; left out it is 1.
    Scale,
    /// Left out it is a grey. It may be a texture where it varies.
    Color {
        default: f32,
        varies: bool,
    },
    Flag {
        default: bool,
    },
    /// Left out it is the first.
    Choice(&'static [Choice]),
    /// The name of an object.
    Name,
    /// A file beside the scene.
    File,
    /// A mapping, or none.
    Mapping,
    /// A material's name, or its fields.
    Material,
    Group(&'static [Field]),
    /// Places and colors of a ramp.
    Stops,
    /// Shapes and solids made of them.
    Solids,
    Lights,
    /// Names with textures.
    Textures,
    /// Names with materials.
    Materials,
}

/// A number within limits.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Number {
    /// None where leaving it out means something else, or an error.
    pub default: Option<f32>,
    pub low: f32,
    pub high: f32,
    pub is_whole: bool,
    /// Whether it may be a texture.
    pub varies: bool,
}

/// A word, and the number in parentheses behind it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Choice {
    pub word: &'static str,
    pub carries: Option<Number>,
}

/// What a `Name(…)` takes that no WGSL file defines.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Group {
    pub name: &'static str,
    pub fields: &'static [Field],
    /// One that may stand as it is.
    pub example: &'static str,
    pub doc: &'static str,
}

const fn field(name: &'static str, takes: Takes, doc: &'static str) -> Field {
    Field { name, takes, is_required: false, is_point: false, unit: None, doc }
}

const fn limits(default: Option<f32>, low: f32, high: f32) -> Number {
    Number { default, low, high, is_whole: false, varies: false }
}

const fn number(name: &'static str, default: f32, low: f32, high: f32, doc: &'static str) -> Field {
    field(name, Takes::Number(limits(Some(default), low, high)), doc)
}

const fn vector(name: &'static str, default: Option<[f32; 3]>, doc: &'static str) -> Field {
    Field { is_required: default.is_none(), ..field(name, Takes::Vector { default }, doc) }
}

const fn color(name: &'static str, default: f32, doc: &'static str) -> Field {
    field(name, Takes::Color { default, varies: false }, doc)
}

const fn texture_or_color(name: &'static str, default: f32, doc: &'static str) -> Field {
    field(name, Takes::Color { default, varies: true }, doc)
}

const fn flag(name: &'static str, default: bool, doc: &'static str) -> Field {
    field(name, Takes::Flag { default }, doc)
}

const fn word(word: &'static str) -> Choice {
    Choice { word, carries: None }
}

impl Field {
    const fn required(self) -> Self {
        Self { is_required: true, ..self }
    }

    const fn point(self) -> Self {
        Self { is_point: true, ..self }
    }

    const fn unit(self, unit: &'static str) -> Self {
        Self { unit: Some(unit), ..self }
    }

    const fn whole(self) -> Self {
        match self.takes {
            Takes::Number(number) => {
                Self { takes: Takes::Number(Number { is_whole: true, ..number }), ..self }
            }
            _ => panic!("only numbers are whole"),
        }
    }

    const fn varying(self) -> Self {
        match self.takes {
            Takes::Number(number) => Self { takes: Takes::Number(Number { varies: true, ..number }), ..self },
            _ => panic!("colors say so by themselves"),
        }
    }
}

/// What the shader knows of lights.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum LightForm {
    Point,
    Directional,
    Spot,
    Rect,
}

/// A texture that no signature can say.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Form {
    Ramp,
    Triplanar,
    Image,
}
