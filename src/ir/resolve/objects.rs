//! Objects: a shape's own fields, those that every object has, and solids made of several.

use std::collections::BTreeMap;
use std::ops::Range;

use glam::{DAffine3, DVec3};

use super::Resolver;
use super::limits::{DEEPEST_SOLID, MAX_OBJECTS};
use super::placement::into_space;
use super::reader::Fields;
use super::remote::Stand;
use crate::diagnostic::Diagnostic;
use crate::ir::fields::{EVERY_OBJECT, EVERY_SOLID, Field, OPERATIONS};
use crate::ir::{Csg, CsgOperation, Object, Primitive, Solid, Value};
use crate::library::Family;
use crate::scene::{self, Kind, Name, Record};

/// The name of what the author gave none: `shape` at `index` among the parts of `around`, or among all
/// objects.
pub fn default_name(around: &str, shape: &str, index: usize) -> String {
    format!("{around} {shape} {index}").trim_start().to_owned()
}

/// The primitives of a scene, so far.
#[derive(Default)]
struct Found {
    primitives: Vec<Primitive>,
    /// Names of primitives and of CSG solids, and where they were given.
    names: BTreeMap<String, Range<usize>>,
}

/// What a part has from the solids that it is a part of.
#[derive(Clone, Copy)]
struct Around<'a> {
    name: &'a str,
    to_world: Option<DAffine3>,
    material: Option<usize>,
    inverted: bool,
    /// In how many of them it lies.
    depth: usize,
}

impl Resolver<'_> {
    /// The primitives, and the objects that they are or are parts of.
    pub fn objects(
        &mut self,
        written: Option<&scene::Value>,
        root: &scene::Value,
    ) -> (Vec<Primitive>, Vec<Object>) {
        let mut found = Found::default();
        let Some(written) = written else {
            // What has no fields at all has been reported.
            if matches!(root.kind, Kind::Record(_)) {
                let problem = self.error(&root.span, "the scene has no `objects`");
                problem.help.push("write `objects: [ Sphere() ]`".into());
            }
            return (vec![], vec![]);
        };
        let Kind::List(items) = &written.kind else {
            self.mismatch(written, "a list of objects `[Sphere()]`");
            return (vec![], vec![]);
        };
        if !self.allows(count(items), MAX_OBJECTS, "objects and parts", &written.span) {
            return (vec![], vec![]);
        }
        let objects =
            items.iter().enumerate().filter_map(|(i, item)| self.object(item, i, &mut found)).collect();
        (found.primitives, objects)
    }

    fn object(&mut self, written: &scene::Value, index: usize, found: &mut Found) -> Option<Object> {
        let shape = self.named(written)?;
        let mut tables = tables_of(shape);
        tables.push(EVERY_OBJECT);
        let mut fields = Fields::of(self, written, &format!("`{}`", shape.text), &tables);
        let bounds = fields.get("bounds").and_then(|bounds| self.bounds(bounds));
        let visible = fields.flag(self, "visible");
        let casts_shadow = fields.flag(self, "casts_shadow");
        let around = Around { name: "", to_world: None, material: None, inverted: false, depth: 0 };
        let (solid, to_world) = self.solid(written, shape, fields, index, around, found)?;
        Some(Object { solid, space: to_world.map(into_space), bounds, visible, casts_shadow })
    }

    /// The `Name` of `Name(…)`.
    fn named<'v>(&mut self, written: &'v scene::Value) -> Option<&'v Name> {
        if let Kind::Record(Record { name: Some(name), .. }) = &written.kind {
            return Some(name);
        }
        self.mismatch(written, "a shape such as `Sphere(radius: 1)`");
        None
    }

    /// A primitive or a CSG solid, and the map from its space into the world.
    fn solid(
        &mut self,
        written: &scene::Value,
        shape: &Name,
        mut fields: Fields<'_>,
        index: usize,
        around: Around<'_>,
        found: &mut Found,
    ) -> Option<(Solid, Option<DAffine3>)> {
        let name = match fields.get("name").map(|n| (n, &n.kind)) {
            Some((_, Kind::Text(name))) if !name.is_empty() => name.clone(),
            Some((value, _)) => {
                self.mismatch(value, "a name such as \"ball\"");
                String::new()
            }
            None => default_name(around.name, &shape.text, index),
        };
        if let Some(first) = found.names.get(&name) {
            let message = format!("two objects are called \"{name}\"");
            let (here, there) = (self.place(&written.span), self.place(first));
            self.push(Diagnostic::error(message).at(here, "again").at(there, "first"));
        }
        found.names.insert(name.clone(), written.span.clone());
        let to_world = match (around.to_world, self.placement(&mut fields)) {
            (Some(outer), Some(inner)) => Some(outer * inner),
            (outer, inner) => outer.or(inner),
        };
        let around = Around { name: &name, to_world, ..around };
        let solid = match OPERATIONS.iter().find(|(known, _)| known.name == shape.text) {
            Some((_, operation)) => self.csg(*operation, written, fields, around, found),
            None => {
                let primitive = self.primitive(written, shape, fields, around)?;
                found.primitives.push(primitive);
                Some(Solid::Primitive(found.primitives.len() - 1))
            }
        };
        Some((solid?, to_world))
    }

    fn primitive(
        &mut self,
        written: &scene::Value,
        shape_name: &Name,
        mut fields: Fields<'_>,
        around: Around<'_>,
    ) -> Option<Primitive> {
        let shape = self.function(Family::Shape, shape_name)?;
        let material = match (fields.get("material"), around.material) {
            (None, Some(material)) => material,
            (written, _) => self.material(written, around.name),
        };
        let mut arguments = vec![];
        for parameter in &shape.parameters {
            let argument = match fields.parameter(parameter) {
                // A distance is asked for at points, and so are textures.
                Some(value) if shape.traits.is_distance => self.argument(parameter, value),
                Some(value) => self.fixed(parameter, value).or(parameter.default.map(Value::Const)),
                None => parameter.default.map(Value::Const),
            };
            if argument.is_none() && !fields.has(&parameter.name) {
                self.error(&written.span, format!("`{}` needs `{}`", shape.name, parameter.name));
            }
            arguments.extend(argument);
        }
        fields.finish(self);
        self.check_conditions(written, &shape, &arguments);
        let origin = self.origin(shape_name, &arguments);
        let moved = DAffine3::from_translation(origin);
        let to_world = match origin == DVec3::ZERO {
            true => around.to_world,
            false => Some(around.to_world.map_or(moved, |outer| outer * moved)),
        };
        self.stands.push(Stand::of(&shape, &arguments, &self.models, to_world, &written.span));
        if shape.traits.is_distance {
            self.check_evaluations(&arguments.iter().collect::<Vec<_>>(), &written.span);
        }
        Some(Primitive {
            name: around.name.to_owned(),
            caption: self.words(written, &["name", "material"]),
            shape,
            arguments,
            material,
            space: to_world.map(into_space),
            inverted: around.inverted,
        })
    }

    /// Where the models of an object count from, in the object's space.
    fn origin(&mut self, shape: &Name, arguments: &[Value]) -> DVec3 {
        let models = arguments.iter().filter_map(|argument| match argument {
            Value::Model(index) => Some(&self.models[*index]),
            _ => None,
        });
        let origins: Vec<DVec3> = models.map(|model| model.origin).collect();
        let first = origins.first().copied().unwrap_or_default();
        if origins.iter().any(|origin| *origin != first) {
            let advice = "move both models near the origin in the program that made them".into();
            let message = "these two models are too far from each other";
            self.error(&shape.span, message).help.push(advice);
        }
        first
    }

    fn csg(
        &mut self,
        operation: CsgOperation,
        written: &scene::Value,
        mut fields: Fields<'_>,
        around: Around<'_>,
        found: &mut Found,
    ) -> Option<Solid> {
        let material = fields.get("material").map(|m| self.material(Some(m), around.name));
        let parts = fields.require(self, "parts");
        fields.finish(self);
        let around = Around { material: material.or(around.material), ..around };
        let parts = parts?;
        let Kind::List(items) = &parts.kind else {
            self.mismatch(parts, "a list of solids `[Box(), Sphere()]`");
            return None;
        };
        if around.depth == DEEPEST_SOLID {
            let message = format!("solids are nested more than {DEEPEST_SOLID} deep");
            let advice = "a `Union` takes any number of parts: put them all in one list".into();
            self.error(&written.span, message).help.push(advice);
            return None;
        }
        if items.is_empty() {
            self.error(&parts.span, "the list of parts is empty");
            return None;
        }
        let mut solids = vec![];
        for (i, item) in items.iter().enumerate() {
            let Some(shape) = self.named(item) else { continue };
            let fields = Fields::of(self, item, &format!("`{}` as a part", shape.text), &tables_of(shape));
            let cut = operation == CsgOperation::Difference && i > 0;
            let around = Around { inverted: around.inverted != cut, depth: around.depth + 1, ..around };
            let Some((solid, _)) = self.solid(item, shape, fields, i, around, found) else { continue };
            if let Solid::Primitive(index) = solid {
                self.check_encloses(&found.primitives[index], shape);
            }
            solids.push(solid);
        }
        let caption = self.words(written, &["name", "material", "parts"]);
        let name = around.name.to_owned();
        let csg = Csg { name, caption, operation, parts: solids };
        Some(Solid::Csg(csg.in_groups()))
    }

    /// Reports a part that has no inside.
    fn check_encloses(&mut self, primitive: &Primitive, shape: &Name) {
        if primitive.shape.traits.is_open {
            let advice =
                "parts must be solids: use a shape with thickness, such as `Box` or `Cylinder`".into();
            self.error(&shape.span, format!("`{}` has no inside", shape.text)).help.push(advice);
        }
        self.check_thickness(primitive, shape);
        for argument in &primitive.arguments {
            if let Value::Model(index) = argument
                && !self.models[*index].is_closed
            {
                let message = format!("`{}` has a hole, so it has no inside", self.models[*index].file);
                let advice = "parts must be solids: in the model, each edge must join two triangles".into();
                self.error(&shape.span, message).help.push(advice);
            }
        }
    }
}

/// The tables of the fields of a part called `shape`.
fn tables_of(shape: &Name) -> Vec<&'static [Field]> {
    let operation = OPERATIONS.iter().find(|(known, _)| known.name == shape.text);
    [EVERY_SOLID].into_iter().chain(operation.map(|(group, _)| group.fields)).collect()
}

/// How many objects and parts there are, those in parts too.
fn count(items: &[scene::Value]) -> usize {
    let parts = |item: &scene::Value| match &item.kind {
        Kind::Record(record) => {
            record.fields.iter().find(|f| f.name.text == "parts").map_or(0, |f| match &f.value.kind {
                Kind::List(parts) => count(parts),
                _ => 0,
            })
        }
        _ => 0,
    };
    items.iter().map(|item| 1 + parts(item)).sum()
}
