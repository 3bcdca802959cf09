//! What may stand at a place of the scene: a field of a table, or a parameter of a function, in one form.

use glam::Vec3;

use super::ColorStyle;
use crate::assets::{Image, Model};
use crate::ir::fields::{Choice, Field, Number, Takes};
use crate::library::{Const, Parameter, Type};

/// A place for a value.
pub struct Slot<'a> {
    pub label: &'a str,
    pub doc: &'a str,
    pub unit: Option<&'static str>,
    pub is_required: bool,
    /// Whether it is one of the points that the thing around moves with.
    pub is_point: bool,
    pub wants: Wants,
}

/// What the value is to be.
pub enum Wants {
    Number {
        default: Option<f32>,
        range: Option<(f32, f32)>,
        is_whole: bool,
        varies: bool,
    },
    Vector {
        size: usize,
        default: Option<Vec<f32>>,
        range: Option<(f32, f32)>,
        varies: bool,
    },
    Scale,
    Color {
        default: Option<Vec3>,
        /// How the default is given.
        style: ColorStyle,
        varies: bool,
    },
    Flag {
        default: Option<bool>,
    },
    Choice(&'static [Choice]),
    /// The names of a parameter's values, and which is the default.
    Named(Vec<String>, Option<usize>),
    Name,
    /// In which such files end.
    File(&'static [&'static str]),
    Mapping,
    Material,
    Group(&'static [Field]),
    Stops,
}

impl Slot<'static> {
    /// That of a table's field; None where nodes of their own stand for it.
    pub fn of_field(field: &'static Field) -> Option<Self> {
        let wants = match field.takes {
            Takes::Number(number) => number.into(),
            Takes::Vector { default } => {
                Wants::Vector { size: 3, default: default.map(Into::into), range: None, varies: false }
            }
            Takes::Scale => Wants::Scale,
            Takes::Color { default, varies } => {
                let default = Some(Vec3::splat(default)).filter(|_| !field.is_required);
                Wants::Color { default, style: ColorStyle::Grey, varies }
            }
            Takes::Flag { default } => Wants::Flag { default: Some(default) },
            Takes::Choice(choices) => Wants::Choice(choices),
            Takes::Name => Wants::Name,
            Takes::File => Wants::File(Image::EXTENSIONS),
            Takes::Mapping => Wants::Mapping,
            Takes::Material => Wants::Material,
            Takes::Group(fields) => Wants::Group(fields),
            Takes::Stops => Wants::Stops,
            Takes::Solids | Takes::Lights | Takes::Textures | Takes::Materials => return None,
        };
        let Field { name, doc, unit, is_required, is_point, .. } = *field;
        Some(Self { label: name, doc, unit, is_required, is_point, wants })
    }
}

impl<'a> Slot<'a> {
    /// That of a function's parameter, which may be given a texture where `varies`.
    pub fn of_parameter(parameter: &'a Parameter, varies: bool) -> Self {
        let Parameter { ty, default, range, .. } = *parameter;
        let numbers = default.map(Const::numbers);
        let varies = varies && matches!(ty, Type::F32 | Type::Vec3);
        let wants = match ty {
            _ if !parameter.choices.is_empty() => {
                let words = parameter.choices.iter().map(|choice| capitalized(choice)).collect();
                Wants::Named(words, numbers.map(|n| n[0] as usize))
            }
            Type::Model => Wants::File(Model::EXTENSIONS),
            Type::Bool => Wants::Flag { default: numbers.map(|n| n[0] != 0.0) },
            Type::F32 | Type::I32 | Type::U32 => {
                let is_whole = ty != Type::F32;
                let range = range.or((ty == Type::U32).then_some((0.0, 16_777_216.0)));
                Wants::Number { default: numbers.map(|n| n[0]), range, is_whole, varies }
            }
            Type::Vec3 if parameter.is_color => {
                let default = numbers.map(|n| Vec3::from_slice(&n));
                Wants::Color { default, style: ColorStyle::Text, varies }
            }
            Type::Vec2 | Type::Vec3 | Type::Vec4 => {
                Wants::Vector { size: ty.size(), default: numbers, range, varies }
            }
        };
        let unit = parameter.name.ends_with("_deg").then_some("degrees");
        let Parameter { name, doc, is_point, .. } = parameter;
        Self { label: name, doc, unit, is_required: default.is_none(), is_point: *is_point, wants }
    }
}

impl From<Number> for Wants {
    fn from(number: Number) -> Self {
        let Number { default, low, high, is_whole, varies } = number;
        Wants::Number { default, range: Some((low, high)), is_whole, varies }
    }
}

/// A choice as a bare word: `Sine` for `sine`.
fn capitalized(choice: &str) -> String {
    let mut letters = choice.chars();
    letters.next().into_iter().flat_map(char::to_uppercase).chain(letters).collect()
}
