//! Lights.

use glam::Vec3;

use super::Resolver;
use super::limits::MAX_LIGHTS;
use super::reader::Fields;
use crate::diagnostic::Diagnostic;
use crate::ir::fields::{EVERY_LIGHT, LIGHTS, LightForm};
use crate::ir::{Light, LightKind};
use crate::scene::{self, Kind, Record};

impl Resolver<'_> {
    pub fn lights(&mut self, written: Option<&scene::Value>) -> Vec<Light> {
        let Some(written) = written else { return vec![] };
        let Kind::List(items) = &written.kind else {
            self.mismatch(written, "a list of lights `[Point(position: (4, 6, 3))]`");
            return vec![];
        };
        if !self.allows(items.len(), MAX_LIGHTS, "lights", &written.span) {
            return vec![];
        }
        items.iter().filter_map(|item| self.light(item)).collect()
    }

    fn light(&mut self, written: &scene::Value) -> Option<Light> {
        let Kind::Record(Record { name: Some(name), .. }) = &written.kind else {
            self.mismatch(written, "a light such as `Point(position: (4, 6, 3))`");
            return None;
        };
        let Some((known, form)) = LIGHTS.iter().find(|(light, _)| light.name == name.text) else {
            let place = self.place(&name.span);
            let problem = Diagnostic::error(format!("there is no light `{}`", name.text)).at(place, "");
            self.push(problem.suggest(&name.text, LIGHTS.iter().map(|(light, _)| light.name)));
            return None;
        };
        let tables = [EVERY_LIGHT, known.fields];
        let mut fields = Fields::of(self, written, &format!("`{}`", name.text), &tables);
        let default = fields.default_color("color");
        let color = fields.get("color").map_or(default, |color| self.constant_color(color));
        let intensity = fields.number(self, "intensity");
        let kind = match form {
            LightForm::Point => LightKind::Point {
                position: fields.vector(self, "position"),
                radius: fields.number(self, "radius"),
            },
            LightForm::Directional => LightKind::Directional {
                direction: fields.direction(self, "direction"),
                spread: (fields.number(self, "angle_deg").to_radians() / 2.0).tan(),
            },
            LightForm::Spot => self.spot(&mut fields, written),
            LightForm::Rect => LightKind::Rect {
                corner: fields.vector(self, "corner"),
                u: fields.vector(self, "u"),
                v: fields.vector(self, "v"),
            },
        };
        let is_near = !matches!(kind, LightKind::Directional { .. });
        let inverse_square = is_near && fields.get("falloff").is_some_and(|falloff| self.falloff(falloff));
        fields.finish(self);
        let caption = self.words(written, &[]);
        Some(Light {
            caption,
            kind,
            emitted: color.to_array().map(|part| exact(part) * exact(intensity)).map(|x| x as f32).into(),
            inverse_square,
        })
    }

    fn spot(&mut self, fields: &mut Fields<'_>, written: &scene::Value) -> LightKind {
        let position = fields.vector(self, "position");
        let target = fields.vector(self, "target");
        let half = fields.number(self, "cone_deg").to_radians() / 2.0;
        let blend = fields.number(self, "blend");
        let radius = fields.number(self, "radius");
        let axis = (target - position).try_normalize().unwrap_or_else(|| {
            self.error(&written.span, "`position` and `target` are the same point");
            Vec3::NEG_Y
        });
        LightKind::Spot { position, radius, axis, inner: (half * (1.0 - blend)).cos(), outer: half.cos() }
    }

    fn falloff(&mut self, written: &scene::Value) -> bool {
        match &written.kind {
            Kind::None => false,
            Kind::Record(Record { name: Some(name), .. }) if name.text == "InverseSquare" => true,
            _ => {
                self.mismatch(written, "`None` or `InverseSquare`");
                false
            }
        }
    }
}

/// The number that an author writes for `x`: 0.9 where the nearest of 32 bits is 0.899999976.
fn exact(x: f32) -> f64 {
    x.to_string().parse().expect("a number prints as one")
}
