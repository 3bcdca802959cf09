//! Numbers and vectors as WGSL knows them.

use glam::{Vec2, Vec3, Vec4};

/// A WGSL type that a parameter can have.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Type {
    F32,
    I32,
    U32,
    Bool,
    Vec2,
    Vec3,
    Vec4,
    /// A file of triangles: no value in the text, but data.
    Model,
}

impl Type {
    /// All of them, by their WGSL names.
    pub const NAMES: [(&str, Type); 8] = [
        ("f32", Type::F32),
        ("i32", Type::I32),
        ("u32", Type::U32),
        ("bool", Type::Bool),
        ("vec2f", Type::Vec2),
        ("vec3f", Type::Vec3),
        ("vec4f", Type::Vec4),
        ("Model", Type::Model),
    ];

    pub fn wgsl(self) -> &'static str {
        Self::NAMES.iter().find(|(_, ty)| *ty == self).expect("NAMES has all types").0
    }

    /// What a scene author calls it.
    pub fn describe(self) -> &'static str {
        match self {
            Type::F32 => "a number",
            Type::I32 => "a whole number",
            Type::U32 => "a whole number from 0",
            Type::Bool => "true or false",
            Type::Vec2 => "a vector (x, y)",
            Type::Vec3 => "a vector (x, y, z)",
            Type::Vec4 => "a vector (x, y, z, w)",
            Type::Model => "a file such as \"model.obj\"",
        }
    }

    /// How many numbers a value has.
    pub fn size(self) -> usize {
        match self {
            Type::F32 | Type::I32 | Type::U32 | Type::Bool => 1,
            Type::Vec2 => 2,
            Type::Vec3 => 3,
            Type::Vec4 => 4,
            Type::Model => 0,
        }
    }
}

/// A value of one of those types; always finite.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Const {
    F32(f32),
    I32(i32),
    U32(u32),
    Bool(bool),
    Vec2(Vec2),
    Vec3(Vec3),
    Vec4(Vec4),
}

impl Const {
    pub fn ty(self) -> Type {
        match self {
            Const::F32(_) => Type::F32,
            Const::I32(_) => Type::I32,
            Const::U32(_) => Type::U32,
            Const::Bool(_) => Type::Bool,
            Const::Vec2(_) => Type::Vec2,
            Const::Vec3(_) => Type::Vec3,
            Const::Vec4(_) => Type::Vec4,
        }
    }

    /// Its numbers, as [`Type::size`] says. Whole numbers are exact up to 2^24.
    pub fn numbers(self) -> Vec<f32> {
        match self {
            Const::F32(x) => vec![x],
            Const::I32(i) => vec![i as f32],
            Const::U32(u) => vec![u as f32],
            Const::Bool(b) => vec![f32::from(u8::from(b))],
            Const::Vec2(v) => v.to_array().to_vec(),
            Const::Vec3(v) => v.to_array().to_vec(),
            Const::Vec4(v) => v.to_array().to_vec(),
        }
    }

    /// A value of type `ty` from numbers, rounded where `ty` is whole; None if there are too few or too many.
    pub fn from_numbers(ty: Type, numbers: &[f32]) -> Option<Self> {
        Some(match (ty, numbers) {
            (Type::F32, &[x]) => Const::F32(x),
            (Type::I32, &[x]) => Const::I32(x as i32),
            (Type::U32, &[x]) => Const::U32(x as u32),
            (Type::Bool, &[x]) => Const::Bool(x != 0.0),
            (Type::Vec2, &[x, y]) => Const::Vec2(Vec2::new(x, y)),
            (Type::Vec3, &[x, y, z]) => Const::Vec3(Vec3::new(x, y, z)),
            (Type::Vec4, &[x, y, z, w]) => Const::Vec4(Vec4::new(x, y, z, w)),
            _ => return None,
        })
    }
}
