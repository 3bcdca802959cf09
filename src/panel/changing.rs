//! Another shape, light or texture in place of one: it stands where that stood, and keeps what both have.
//!
//! In: what was chosen, and a name for it. Out: edits, all of them one step.

use std::path::Path;

use glam::{DVec3, Vec3};

use crate::edit::{Edit, NewValue};
use crate::ir::placed;
use crate::library::Library;
use crate::outline::{Becoming, Control, Field, Node, NodeKind, Role, becoming};
use crate::sources::Disk;

/// The light or solid `node` becomes a `name`.
pub fn renamed((disk, scene): (&Disk, &Path), node: &Node, name: &str) -> Vec<Edit> {
    let role = if node.kind == NodeKind::Light { Role::Light } else { Role::Solid };
    let old = node.name.as_deref().unwrap_or_default();
    let change = with_library(disk, scene, |library| becoming(role, old, &node.fields, name, library));
    let moved = moved(&node.fields, &change);
    let is_moved = |label: &String| moved.iter().any(|(known, _)| known == label);
    let added = change.add.iter().filter(|(label, _)| !is_moved(label));
    let added = added.map(|(label, words)| (label.clone(), NewValue::Code(words.clone())));
    let added: Vec<_> = added.chain(moved.clone()).collect();
    edits(&node.path, name, &change, added)
}

/// The texture or mapping of `field` becomes a `name`.
pub fn replaced((disk, scene): (&Disk, &Path), field: &Field, name: &str) -> Vec<Edit> {
    let Control::Texture { name: Some(old), fields, .. } = &field.control else { return vec![] };
    let change = with_library(disk, scene, |library| becoming(Role::Texture, old, fields, name, library));
    let added = change.add.iter().map(|(label, words)| (label.clone(), NewValue::Code(words.clone())));
    edits(&field.path, name, &change, added.collect())
}

fn edits(
    path: &crate::scene::Path,
    name: &str,
    change: &Becoming,
    added: Vec<(String, NewValue)>,
) -> Vec<Edit> {
    let rename = Edit::Rename { path: path.clone(), name: name.to_owned(), keep: change.keep.clone() };
    let added = added.into_iter().map(|(label, value)| Edit::Add {
        path: path.field(&label),
        value,
        order: change.order.clone(),
    });
    std::iter::once(rename).chain(added).collect()
}

/// The values by which the new one stands where the points of the old one say; none where nobody has
/// written such points, or where they go on.
fn moved(fields: &[Field], change: &Becoming) -> Vec<(String, NewValue)> {
    let points: Vec<&Field> = fields.iter().filter(|field| field.is_point).collect();
    let goes_on = |field: &&Field| field.span.is_some() && change.keep.contains(&field.label);
    if points.iter().all(|field| field.span.is_none()) || points.iter().any(goes_on) {
        return vec![];
    }
    let Some(old) = points.iter().map(|field| vector(field)).collect::<Option<Vec<Vec3>>>() else {
        return vec![];
    };
    let at = mean(&old);
    if change.points.is_empty() {
        return translate(fields, at).into_iter().collect();
    }
    let by = at - mean(&change.points.iter().map(|(_, point)| *point).collect::<Vec<_>>());
    change
        .points
        .iter()
        .map(|(label, point)| (label.clone(), written(point.as_dvec3() + by.as_dvec3())))
        .collect()
}

/// A shape without points of its own stands there by `translate`.
fn translate(fields: &[Field], at: Vec3) -> Option<(String, NewValue)> {
    let of = |label: &str| fields.iter().find(|field| field.label == label);
    let [translate, rotate_deg] = ["translate", "rotate_deg"].map(|label| of(label).and_then(vector));
    let scale = of("scale").and_then(|field| match field.control {
        Control::Number { value: Some(scale), .. } => Some(Vec3::splat(scale)),
        _ => vector(field),
    });
    let place = placed(translate?.as_dvec3(), rotate_deg?, scale?).transform_point3(at.as_dvec3());
    Some(("translate".to_owned(), written(place)))
}

fn vector(field: &Field) -> Option<Vec3> {
    match &field.control {
        Control::Vector { value: Some(numbers), .. } if numbers.len() == 3 => Some(Vec3::from_slice(numbers)),
        _ => None,
    }
}

fn mean(points: &[Vec3]) -> Vec3 {
    points.iter().sum::<Vec3>() / points.len().max(1) as f32
}

/// In digits that a person would write.
fn written(point: DVec3) -> NewValue {
    NewValue::Vector(point.to_array().map(|x| ((x * 1e4).round() / 1e4) as f32).to_vec())
}

/// Asks for what `scene` can name.
pub fn with_library<T>(disk: &Disk, scene: &Path, ask: impl FnOnce(&Library<'_>) -> T) -> T {
    let sources = disk.sources();
    ask(&Library::new(&sources, scene.parent().unwrap_or(Path::new(""))))
}
