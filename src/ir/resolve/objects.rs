//! Objects: a shape's own fields, and those that every object has.

use std::collections::BTreeMap;
use std::ops::Range;

use glam::{DAffine3, DMat3, DQuat, Vec3};

use super::Resolver;
use super::reader::Fields;
use crate::diagnostic::Diagnostic;
use crate::ir::Object;
use crate::library::Family;
use crate::scene::{self, Kind, Record};

/// Uniform data and compile time grow with the objects of a scene that is written out.
const MOST_OBJECTS: usize = 4096;

impl Resolver<'_> {
    pub fn objects(&mut self, written: Option<&scene::Value>, root: &scene::Value) -> Vec<Object> {
        let Some(written) = written else {
            // What has no fields at all has been reported.
            if matches!(root.kind, Kind::Record(_)) {
                let problem = self.error(&root.span, "the scene has no `objects`");
                problem.help.push("write `objects: [ Sphere() ]`".into());
            }
            return vec![];
        };
        let Kind::List(items) = &written.kind else {
            self.mismatch(written, "a list of objects `[Sphere()]`");
            return vec![];
        };
        if items.len() > MOST_OBJECTS {
            self.error(&written.span, format!("{} objects: the most are {MOST_OBJECTS}", items.len()));
            return vec![];
        }
        let mut names: BTreeMap<String, Range<usize>> = BTreeMap::new();
        let mut objects = vec![];
        for (index, item) in items.iter().enumerate() {
            let Some(object) = self.object(item, index) else { continue };
            if let Some(first) = names.get(&object.name) {
                let message = format!("two objects are called \"{}\"", object.name);
                let (here, there) = (self.place(&item.span), self.place(first));
                self.push(Diagnostic::error(message).at(here, "again").at(there, "first"));
            }
            names.insert(object.name.clone(), item.span.clone());
            objects.push(object);
        }
        objects
    }

    fn object(&mut self, written: &scene::Value, index: usize) -> Option<Object> {
        let Kind::Record(Record { name: Some(shape_name), .. }) = &written.kind else {
            self.mismatch(written, "a shape such as `Sphere(radius: 1)`");
            return None;
        };
        let shape = self.function(Family::Shape, shape_name)?;
        let mut fields = Fields::of(self, written, &format!("`{}`", shape.name));
        let name = match fields.get("name").map(|n| (n, &n.kind)) {
            Some((_, Kind::Text(name))) if !name.is_empty() => name.clone(),
            Some((value, _)) => {
                self.mismatch(value, "a name such as \"ball\"");
                String::new()
            }
            None => format!("{} {index}", shape.name),
        };
        let material = fields.get("material");
        let material = self.material(material, &name);
        let space = self.space(&mut fields);
        let bounds = fields.get("bounds").and_then(|bounds| self.bounds(bounds));
        let visible = fields.flag(self, "visible", true);
        let casts_shadow = fields.flag(self, "casts_shadow", true);
        let mut arguments = vec![];
        for parameter in &shape.parameters {
            let argument = match fields.get(&parameter.name) {
                Some(value) => self.constant(parameter, value).or(parameter.default),
                None => parameter.default,
            };
            if argument.is_none() && !fields.has(&parameter.name) {
                self.error(&written.span, format!("`{}` needs `{}`", shape.name, parameter.name));
            }
            arguments.extend(argument);
        }
        fields.finish(self);
        let caption = self.words(written, &["name", "material"]);
        Some(Object { name, caption, shape, arguments, material, space, bounds, visible, casts_shadow })
    }

    /// The map from the world into the object's space, where the author moves the object.
    fn space(&mut self, fields: &mut Fields<'_>) -> Option<[[f32; 4]; 3]> {
        let moved = ["translate", "rotate_deg", "scale"].iter().any(|field| fields.has(field));
        let translate = fields.vector(self, "translate", Some(Vec3::ZERO)).as_dvec3();
        let turned =
            fields.vector(self, "rotate_deg", Some(Vec3::ZERO)).as_dvec3() * (std::f64::consts::PI / 180.0);
        let scale = match fields.get("scale") {
            Some(value) => self.scale(value),
            None => Vec3::ONE,
        };
        if !moved {
            return None;
        }
        let turn = DQuat::from_rotation_z(turned.z)
            * DQuat::from_rotation_y(turned.y)
            * DQuat::from_rotation_x(turned.x);
        let scale = DMat3::from_diagonal(scale.as_dvec3());
        let to_world = DAffine3::from_mat3_translation(DMat3::from_quat(turn) * scale, translate);
        let inverse = to_world.inverse();
        let row = |i: usize| {
            let m = inverse.matrix3.row(i);
            let at = inverse.translation[i];
            [m.x, m.y, m.z, at].map(rounded)
        };
        Some([row(0), row(1), row(2)])
    }

    fn scale(&mut self, value: &scene::Value) -> Vec3 {
        let scale = match value.kind {
            Kind::Number(_) => self.number(value, None).map(Vec3::splat),
            Kind::Tuple(_) | Kind::List(_) => self.vector(value),
            _ => {
                self.mismatch(value, "a number or a vector (x, y, z)");
                None
            }
        };
        let scale = scale.unwrap_or(Vec3::ONE);
        if scale.abs().min_element() < 1e-6 {
            self.error(&value.span, "`scale` must not be 0")
                .help
                .push("leave the object out, or make it thin: 0.001".into());
            return Vec3::ONE;
        }
        scale
    }

    fn bounds(&mut self, written: &scene::Value) -> Option<(Vec3, Vec3)> {
        let before = self.problems.len();
        let mut fields = Fields::of(self, written, "`bounds`");
        let min = fields.vector(self, "min", None);
        let max = fields.vector(self, "max", None);
        fields.finish(self);
        if self.problems.len() == before && min.cmpge(max).any() {
            self.error(&written.span, "`min` must be below `max`");
            return None;
        }
        Some((min, max))
    }
}

/// Rid of the last bits of sine and cosine, which differ between systems.
fn rounded(x: f64) -> f32 {
    ((x * 1e9).round() / 1e9) as f32
}
