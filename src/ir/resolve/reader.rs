//! Fields of a group, each asked for once: what nobody asked for is a mistake of the author's.

use std::ops::Range;

use glam::Vec3;

use super::Resolver;
use crate::diagnostic::Diagnostic;
use crate::scene::{Field, Kind, Value};

/// The fields of one group of a scene.
pub struct Fields<'v> {
    /// In messages: "`camera`".
    owner: String,
    span: Range<usize>,
    fields: &'v [Field],
    asked: Vec<String>,
}

impl<'v> Fields<'v> {
    /// The fields of `value`; an error and no fields where it has none.
    pub fn of(resolver: &mut Resolver<'_>, value: &'v Value, owner: &str) -> Self {
        let fields = match &value.kind {
            Kind::Record(record) if record.items.is_empty() => record.fields.as_slice(),
            _ => {
                let found = match &value.kind {
                    Kind::Record(_) => "values without names".into(),
                    _ => value.describe(),
                };
                let problem = resolver.error(&value.span, format!("{owner} is written with named fields"));
                problem.help.push(format!("write `name: value` pairs in parentheses; found {found}"));
                &[]
            }
        };
        for (i, field) in fields.iter().enumerate() {
            if let Some(first) = fields[..i].iter().find(|f| f.name.text == field.name.text) {
                let message = format!("`{}` is given twice", field.name.text);
                let (here, there) = (resolver.place(&field.name.span), resolver.place(&first.name.span));
                resolver.push(Diagnostic::error(message).at(here, "again").at(there, "first"));
            }
        }
        Self { owner: owner.to_owned(), span: value.span.clone(), fields, asked: vec![] }
    }

    /// The value of `name`, if the author gave one.
    pub fn get(&mut self, name: &str) -> Option<&'v Value> {
        self.asked.push(name.to_owned());
        self.fields.iter().find(|f| f.name.text == name).map(|f| &f.value)
    }

    /// The value of `name`, or an error.
    pub fn require(&mut self, resolver: &mut Resolver<'_>, name: &str) -> Option<&'v Value> {
        let value = self.get(name);
        if value.is_none() {
            let message = format!("{} needs `{name}`", self.owner);
            resolver.error(&self.span, message);
        }
        value
    }

    /// A number from `low` to `high`; required where there is no default.
    pub fn number(
        &mut self,
        resolver: &mut Resolver<'_>,
        name: &str,
        default: Option<f32>,
        low: f32,
        high: f32,
    ) -> f32 {
        let written = if default.is_some() { self.get(name) } else { self.require(resolver, name) };
        let otherwise = default.unwrap_or(low);
        written.map_or(otherwise, |value| resolver.number(value, Some((low, high))).unwrap_or(otherwise))
    }

    /// A vector; required where there is no default.
    pub fn vector(&mut self, resolver: &mut Resolver<'_>, name: &str, default: Option<Vec3>) -> Vec3 {
        let written = if default.is_some() { self.get(name) } else { self.require(resolver, name) };
        let otherwise = default.unwrap_or(Vec3::ZERO);
        written.map_or(otherwise, |value| resolver.vector(value).unwrap_or(otherwise))
    }

    /// A vector with a length, scaled to length 1.
    pub fn direction(&mut self, resolver: &mut Resolver<'_>, name: &str, default: Option<Vec3>) -> Vec3 {
        let given = self.vector(resolver, name, default);
        given.try_normalize().unwrap_or_else(|| {
            if let Some(field) = self.fields.iter().find(|f| f.name.text == name) {
                resolver.error(&field.value.span, format!("`{name}` has no length"));
            }
            Vec3::Y
        })
    }

    pub fn flag(&mut self, resolver: &mut Resolver<'_>, name: &str, default: bool) -> bool {
        self.get(name).map_or(default, |value| match value.kind {
            Kind::Bool(b) => b,
            _ => {
                resolver.mismatch(value, "true or false");
                default
            }
        })
    }

    /// Whether the author gave `name`.
    pub fn has(&self, name: &str) -> bool {
        self.fields.iter().any(|f| f.name.text == name)
    }

    /// Reports the fields that nobody asked for.
    pub fn finish(self, resolver: &mut Resolver<'_>) {
        let unknown = self.fields.iter().filter(|f| !self.asked.contains(&f.name.text));
        for Field { name, .. } in unknown {
            let place = resolver.place(&name.span);
            let problem =
                Diagnostic::error(format!("{} has no field `{}`", self.owner, name.text)).at(place, "");
            resolver.push(problem.suggest(&name.text, self.asked.iter().map(String::as_str)));
        }
    }
}
