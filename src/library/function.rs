//! A WGSL file as a scene author sees it: its name, its parameters, its result.

use std::sync::Arc;

use super::{Condition, Const, Type};

/// A shape, texture or mapping.
#[derive(Clone, Debug, PartialEq)]
pub struct Function {
    /// As scenes call it: `WoodGrain`.
    pub name: String,
    /// As WGSL calls it: `woodGrain`.
    pub wgsl_name: String,
    pub kind: Kind,
    /// The first doc line.
    pub caption: String,
    /// In the order of the signature, without the first, which is the ray or the point asked about.
    pub parameters: Vec<Parameter>,
    /// Of a shape: what it is besides a surface.
    pub traits: Traits,
    /// Of a shape: what its numbers keep to among each other.
    pub conditions: Vec<Condition>,
    /// The file's name and text.
    pub file: String,
    pub text: Arc<str>,
}

/// What is special about a shape.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Traits {
    /// It encloses nothing, so that it cannot be a part of another: a doc line says so.
    pub is_open: bool,
    /// It has a `nameContains`, since it goes on without end.
    pub is_endless: bool,
    /// It has a `nameDistance`, and nothing that finds crossings.
    pub is_distance: bool,
    /// It has a `nameTexturePoint`: where the textures that shape it are asked for.
    pub places_textures: bool,
    /// It has a `nameSurface`.
    pub has_surface: bool,
}

/// What a function gives.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Kind {
    Shape,
    /// A number, nominally 0 to 1.
    Pattern,
    /// Linear RGB.
    Color,
    /// The point to ask about instead.
    Mapping,
}

impl Kind {
    pub fn noun(self) -> &'static str {
        match self {
            Kind::Shape => "shape",
            Kind::Pattern => "pattern",
            Kind::Color => "color",
            Kind::Mapping => "mapping",
        }
    }
}

#[derive(Clone, Debug, PartialEq)]
pub struct Parameter {
    /// As scenes call it.
    pub name: String,
    /// The same, with an underscore behind it where WGSL has another use for the name.
    pub wgsl_name: String,
    pub ty: Type,
    /// None where the author must give it.
    pub default: Option<Const>,
    /// The default as its doc line has it.
    pub default_text: String,
    /// Least and greatest value of each component.
    pub range: Option<(f32, f32)>,
    /// A direction, which must have a length.
    pub nonzero: bool,
    /// A `vec3f` that is a color.
    pub is_color: bool,
    /// A point of a shape, which moves as all its points move together: a doc line says so.
    pub is_point: bool,
    /// The names of the values 0, 1, … of a `u32`.
    pub choices: Vec<String>,
    pub doc: String,
}

/// `WoodGrain` for `wood_grain`, and for `wood-grain`.
pub fn name_of(stem: &str) -> String {
    let capitalized = |word: &str| {
        let mut letters = word.chars();
        letters.next().into_iter().flat_map(char::to_uppercase).chain(letters).collect::<String>()
    };
    stem.split(['_', '-']).map(capitalized).collect()
}

/// `wood_grain` for `WoodGrain`.
pub fn stem_of(name: &str) -> String {
    let mut stem = String::new();
    for (i, c) in name.chars().enumerate() {
        if c.is_uppercase() && i > 0 {
            stem.push('_');
        }
        stem.extend(c.to_lowercase());
    }
    stem
}

/// `woodGrain` for `wood_grain`.
pub fn wgsl_name_of(stem: &str) -> String {
    let name = name_of(stem);
    name.chars().take(1).flat_map(char::to_lowercase).chain(name.chars().skip(1)).collect()
}

impl Function {
    pub fn parameter(&self, name: &str) -> Option<&Parameter> {
        self.parameters.iter().find(|p| p.name == name)
    }
}
