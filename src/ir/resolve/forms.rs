//! Textures that are the generator's own, since no function signature can say what they take.

use super::Resolver;
use super::limits::MAX_STOPS;
use super::reader::Fields;
use crate::ir::fields::{EVERY_TEXTURE, Form, Group};
use crate::ir::{Call, Interpolation, Ramp, Triplanar, Value};
use crate::library::Type;
use crate::scene::{self, Kind, Record};

impl Resolver<'_> {
    /// What `Name(…)` computes where that is one of [`crate::ir::fields::FORMS`].
    pub fn form(&mut self, (group, form): &(Group, Form), value: &scene::Value, want: Type) -> Option<Value> {
        match form {
            Form::Ramp => self.ramp(group, value).map(|ramp| Value::Ramp(Box::new(ramp))),
            Form::Triplanar => self.triplanar(group, value).map(|form| Value::Triplanar(Box::new(form))),
            Form::Image => self.picture(group, value, want).map(|form| Value::Image(Box::new(form))),
        }
    }

    fn ramp(&mut self, form: &Group, value: &scene::Value) -> Option<Ramp> {
        let mut fields = Fields::of(self, value, "`Ramp`", &[EVERY_TEXTURE, form.fields]);
        let at = self.at(&mut fields);
        let by = fields.pattern(self, "by");
        let stops = fields.require(self, "stops");
        let interpolation = fields.get("interpolation").map(|written| self.interpolation(written));
        fields.finish(self);
        let stops = stops?;
        let Kind::List(items) = &stops.kind else {
            self.mismatch(stops, "a list of stops `[(0.0, \"#000\"), (1.0, \"#fff\")]`");
            return None;
        };
        if !self.allows(items.len(), MAX_STOPS, "stops", &stops.span) {
            return None;
        }
        let mut resolved: Vec<(f32, Value)> = vec![];
        for item in items {
            match &item.kind {
                Kind::Tuple(pair) if pair.len() == 2 => {
                    let at = self.number(&pair[0], None)?;
                    if resolved.last().is_some_and(|(before, _)| *before > at) {
                        self.error(&pair[0].span, "the positions of stops must increase");
                    }
                    let color = self.color(&pair[1]);
                    resolved.push((at, color));
                }
                _ => self.mismatch(item, "a stop `(0.5, \"tomato\")`"),
            }
        }
        if resolved.len() < 2 {
            self.error(&stops.span, "a ramp needs at least two stops");
            return None;
        }
        let interpolation = interpolation.unwrap_or(Interpolation::Linear);
        Some(Ramp { at: at?, by: by?, stops: resolved, interpolation })
    }

    /// The mapping that `at` names, if there is one; None where it is wrong.
    pub fn at(&mut self, fields: &mut Fields<'_>) -> Option<Option<Box<Call>>> {
        match fields.get("at") {
            Some(mapping) => self.mapping(mapping).map(|call| Some(Box::new(call))),
            None => Some(None),
        }
    }

    fn interpolation(&mut self, written: &scene::Value) -> Interpolation {
        let known = [
            ("Linear", Interpolation::Linear),
            ("Smooth", Interpolation::Smooth),
            ("Constant", Interpolation::Constant),
        ];
        if let Kind::Record(Record { name: Some(name), .. }) = &written.kind
            && let Some((_, interpolation)) = known.iter().find(|(n, _)| *n == name.text)
        {
            return *interpolation;
        }
        self.mismatch(written, "`Linear`, `Smooth` or `Constant`");
        Interpolation::Linear
    }

    fn triplanar(&mut self, form: &Group, value: &scene::Value) -> Option<Triplanar> {
        let mut fields = Fields::of(self, value, "`Triplanar`", &[EVERY_TEXTURE, form.fields]);
        let at = self.at(&mut fields);
        let of = fields.color(self, "of");
        let sharpness = fields.number(self, "sharpness");
        fields.finish(self);
        Some(Triplanar { at: at?, of: of?, sharpness })
    }
}
