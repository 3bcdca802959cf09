//! A call that gets another name: what of it goes on, and what the new one must be given.
//!
//! In: the fields of a light, a solid or a texture, and a name for it. Out: a [`Becoming`].

use glam::Vec3;

use super::slot::{Slot, Wants};
use super::{Control, Field, Role, example};
use crate::ir::fields::{self, EVERY_LIGHT, EVERY_OBJECT, EVERY_SOLID, EVERY_TEXTURE};
use crate::library::Library;
use crate::scene::{self, Kind, Path, Value};

/// What becomes of the fields of a call.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Becoming {
    /// Those that both have, of one type and within the limits of the new one.
    pub keep: Vec<String>,
    /// Those that the new one must be given, as RON text.
    pub add: Vec<(String, String)>,
    /// The points that the new one moves with, where none of them is kept, as it would have them.
    pub points: Vec<(String, Vec3)>,
    /// All fields of the new one, in order.
    pub order: Vec<String>,
}

/// A field as a table or a signature has it.
struct Known {
    label: String,
    /// None for lists of things.
    wants: Option<Wants>,
    is_required: bool,
    is_point: bool,
}

/// What becomes of `fields`, those of an `old`, in a `new`.
pub fn becoming(role: Role, old: &str, fields: &[Field], new: &str, library: &Library<'_>) -> Becoming {
    let (before, after) = (known(role, old, library), known(role, new, library));
    let is_kept = |new: &&Known| match before.iter().find(|known| known.label == new.label) {
        Some(old) => {
            let field = fields.iter().find(|field| field.label == new.label);
            is_alike(old.wants.as_ref(), new.wants.as_ref())
                && field.is_none_or(|field| fits(&field.control, new.wants.as_ref()))
        }
        // Of what nobody knows, all may be right.
        None => before.is_empty(),
    };
    let keep: Vec<String> = after.iter().filter(is_kept).map(|known| known.label.clone()).collect();
    // Lists have no field of their own.
    let is_written = |label: &str| fields.iter().find(|f| f.label == label).is_none_or(|f| f.span.is_some());
    let goes_on = |label: &String| keep.contains(label) && is_written(label);
    let text = example(role, new, library).unwrap_or_default();
    let given = scene::parse("", &text).ok();
    let given = |label: &str| given.as_ref().and_then(|given| given.at(&Path::default().field(label)));
    let missing = after.iter().filter(|known| known.is_required && !goes_on(&known.label));
    let add = missing
        .filter_map(|known| Some((known.label.clone(), text[given(&known.label)?.whole.clone()].to_owned())));
    let points = after.iter().filter(|known| known.is_point);
    let points = match points.clone().any(|known| goes_on(&known.label)) {
        true => vec![],
        false => points
            .filter_map(|known| Some((known.label.clone(), point(known, given(&known.label))?)))
            .collect(),
    };
    Becoming { add: add.collect(), points, order: after.iter().map(|k| k.label.clone()).collect(), keep }
}

fn known(role: Role, name: &str, library: &Library<'_>) -> Vec<Known> {
    let of_table = |field: &'static fields::Field| {
        let wants = Slot::of_field(field).map(|slot| slot.wants);
        let (label, is_required, is_point) = (field.name.to_owned(), field.is_required, field.is_point);
        Known { label, wants, is_required, is_point }
    };
    let own: Vec<Known> = match (role.group(name), role.family()) {
        (Some(group), _) => group.fields.iter().map(of_table).collect(),
        (None, Some(family)) => match library.find(family, name) {
            Ok(function) => {
                let varies = role == Role::Texture || function.traits.is_distance;
                let slots = function.parameters.iter().map(|parameter| Slot::of_parameter(parameter, varies));
                let known = slots.map(|slot| {
                    let Slot { label, is_required, is_point, wants, .. } = slot;
                    Known { label: label.to_owned(), wants: Some(wants), is_required, is_point }
                });
                known.collect()
            }
            Err(_) => return vec![],
        },
        (None, None) => return vec![],
    };
    let every: &[&[fields::Field]] = match role {
        Role::Light => &[EVERY_LIGHT],
        Role::Solid => &[EVERY_SOLID, EVERY_OBJECT],
        Role::Texture => &[EVERY_TEXTURE],
    };
    let mut all: Vec<Known> = own;
    all.extend(every.iter().copied().flatten().map(of_table));
    // As people write it.
    all.sort_by_key(|known| role == Role::Solid && known.label != "name");
    all
}

/// Whether what one takes is of a type that the other takes.
fn is_alike(old: Option<&Wants>, new: Option<&Wants>) -> bool {
    match (old, new) {
        (Some(Wants::Number { is_whole: old, .. }), Some(Wants::Number { is_whole: new, .. })) => old == new,
        (Some(Wants::Vector { size: old, .. }), Some(Wants::Vector { size: new, .. })) => old == new,
        (Some(Wants::Named(old, _)), Some(Wants::Named(new, _))) => old == new,
        (Some(old), Some(new)) => std::mem::discriminant(old) == std::mem::discriminant(new),
        (old, new) => old.is_none() && new.is_none(),
    }
}

/// Whether what is written lies within the limits of `wants`.
fn fits(control: &Control, wants: Option<&Wants>) -> bool {
    let within =
        |x: &f32, range: &Option<(f32, f32)>| range.is_none_or(|(low, high)| low <= *x && *x <= high);
    match (control, wants) {
        (Control::Number { value: Some(x), .. }, Some(Wants::Number { range, .. })) => within(x, range),
        (Control::Vector { value: Some(numbers), .. }, Some(Wants::Vector { range, .. })) => {
            numbers.iter().all(|x| within(x, range))
        }
        (
            Control::Texture { .. } | Control::Reference { .. },
            Some(Wants::Number { varies, .. } | Wants::Vector { varies, .. } | Wants::Color { varies, .. }),
        ) => *varies,
        _ => true,
    }
}

fn point(known: &Known, given: Option<&Value>) -> Option<Vec3> {
    let numbers = match (given.map(|given| &given.kind), &known.wants) {
        (Some(Kind::Tuple(items)), _) => items
            .iter()
            .map(|item| if let Kind::Number(x) = item.kind { Some(x as f32) } else { None })
            .collect::<Option<Vec<f32>>>()?,
        (_, Some(Wants::Vector { default: Some(default), .. })) => default.clone(),
        _ => return None,
    };
    <[f32; 3]>::try_from(numbers).ok().map(Vec3::from_array)
}
