//! Names that could stand in a scene: what files define, and what the scene itself declares.

use std::sync::Arc;

use crate::assets::{Image, Model};
use crate::ir::fields::{FORMS, Field, Group, LIGHTS, OPERATIONS, Takes};
use crate::library::{Family, Kind, Library, Parameter, Type};
use crate::scene::{self, Path, Value};

/// All that a scene may name, each list in order.
#[derive(Clone, Debug, PartialEq)]
pub struct Names {
    /// Patterns and colors.
    pub textures: Arc<[String]>,
    pub mappings: Arc<[String]>,
    /// Shapes, then the ways to combine them.
    pub solids: Arc<[String]>,
    /// Those that enclose something, and so may be parts of others.
    pub parts: Arc<[String]>,
    pub lights: Arc<[String]>,
    pub declared_textures: Arc<[String]>,
    pub declared_materials: Arc<[String]>,
}

impl Names {
    pub fn new(root: &Value, library: &Library<'_>) -> Self {
        let functions = |family: Family| {
            let names = library.names(family).into_iter();
            names.filter_map(|name| library.find(family, &name).ok()).collect::<Vec<_>>()
        };
        let textures = functions(Family::Texture);
        let (mappings, mut textures): (Vec<_>, Vec<_>) = textures
            .iter()
            .map(|function| (function.kind == Kind::Mapping, function.name.clone()))
            .partition(|(is_mapping, _)| *is_mapping);
        textures.extend(FORMS.iter().map(|(form, _)| (false, form.name.to_owned())));
        textures.sort();
        let shapes = functions(Family::Shape);
        let operations = || OPERATIONS.iter().map(|(group, _)| group.name.to_owned());
        let closed = shapes.iter().filter(|shape| !shape.traits.is_open);
        let declared = |field: &str| match root.at(&Path::default().field(field)).map(|v| &v.kind) {
            Some(scene::Kind::Map(entries)) => entries.iter().map(|e| e.name.text.clone()).collect(),
            _ => Arc::default(),
        };
        Self {
            textures: textures.into_iter().map(|(_, name)| name).collect(),
            mappings: mappings.into_iter().map(|(_, name)| name).collect(),
            solids: shapes.iter().map(|shape| shape.name.clone()).chain(operations()).collect(),
            parts: closed.map(|shape| shape.name.clone()).chain(operations()).collect(),
            lights: LIGHTS.iter().map(|(light, _)| light.name.to_owned()).collect(),
            declared_textures: declared("textures"),
            declared_materials: declared("materials"),
        }
    }
}

/// What a name stands for; some are those of a texture and of a solid.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Role {
    Light,
    /// A shape, or a solid made of several.
    Solid,
    /// A texture or mapping.
    Texture,
}

/// A file that something cannot be without.
#[derive(Debug, PartialEq, Eq)]
pub struct Needed {
    /// Of the field that names it.
    pub field: String,
    /// In prose.
    pub noun: &'static str,
    /// In which such files end.
    pub extensions: &'static [&'static str],
}

/// The file that a `name` must be given, if any.
pub fn needed_file(role: Role, name: &str, library: &Library<'_>) -> Option<Needed> {
    if let Some(group) = role.group(name) {
        let is_file = |field: &&Field| matches!(field.takes, Takes::File) && field.is_required;
        let field = group.fields.iter().find(is_file)?.name.to_owned();
        return Some(Needed { field, noun: "picture", extensions: Image::EXTENSIONS });
    }
    let function = library.find(role.family()?, name).ok()?;
    let field = function.parameters.iter().find(|parameter| parameter.ty == Type::Model)?.name.clone();
    Some(Needed { field, noun: "model", extensions: Model::EXTENSIONS })
}

/// RON text with `name` and no more than it must be given, to be put into a scene; None for a name that
/// nobody knows. Of files it names the nearest that is there.
pub fn example(role: Role, name: &str, library: &Library<'_>) -> Option<String> {
    let needed = needed_file(role, name, library);
    let file =
        needed.and_then(|needed| Some((needed.field, library.files(needed.extensions).into_iter().next()?)));
    if let Some(group) = role.group(name) {
        let given = file.map(|(field, file)| format!("{name}({field}: {file:?})"));
        return Some(given.unwrap_or_else(|| group.example.to_owned()));
    }
    let function = library.find(role.family()?, name).ok()?;
    let required = function.parameters.iter().filter(|parameter| parameter.default.is_none());
    let given = required.enumerate().map(|(i, p)| match &file {
        Some((field, file)) if *field == p.name => format!("{field}: {file:?}"),
        _ => format!("{}: {}", p.name, any(p, i)),
    });
    Some(format!("{name}({})", given.collect::<Vec<_>>().join(", ")))
}

impl Role {
    /// The one in the tables with this name.
    pub(super) fn group(self, name: &str) -> Option<&'static Group> {
        match self {
            Role::Light => LIGHTS.iter().map(|(group, _)| group).find(|group| group.name == name),
            Role::Solid => OPERATIONS.iter().map(|(group, _)| group).find(|group| group.name == name),
            Role::Texture => FORMS.iter().map(|(group, _)| group).find(|group| group.name == name),
        }
    }

    /// Where the others are found.
    pub(super) fn family(self) -> Option<Family> {
        match self {
            Role::Light => None,
            Role::Solid => Some(Family::Shape),
            Role::Texture => Some(Family::Texture),
        }
    }
}

/// Something that `parameter` takes, which has no default, and so no choices. Of vectors, the first is the
/// origin and the others are along the axes, so that corners lie apart.
fn any(parameter: &Parameter, index: usize) -> String {
    let (low, high) = parameter.range.unwrap_or((f32::MIN, f32::MAX));
    let within = |x: f32| x.clamp(low, high).to_string();
    let axis = if parameter.nonzero { index.max(1) } else { index };
    match parameter.ty {
        Type::Bool => "true".into(),
        Type::Model => "\"model.obj\"".into(),
        Type::F32 | Type::I32 | Type::U32 => within(1.0),
        Type::Vec2 | Type::Vec3 | Type::Vec4 => {
            let size = parameter.ty.size();
            let along = |i: usize| if axis > 0 && (axis - 1) % size == i { 1.0 } else { 0.0 };
            format!("({})", (0..size).map(|i| within(along(i))).collect::<Vec<_>>().join(", "))
        }
    }
}
