//! Fields of a group, each asked for once: what nobody asked for is a mistake of the author's.

use std::ops::Range;

use glam::{DVec3, Vec3};

use super::Resolver;
use crate::diagnostic::Diagnostic;
use crate::ir;
use crate::ir::fields::{Field as Known, Number, Takes};
use crate::library::Parameter;
use crate::scene::{Field, Kind, Record, Value};

/// The fields of one group of a scene.
pub struct Fields<'v> {
    /// In messages: "`camera`".
    owner: String,
    span: Range<usize>,
    fields: &'v [Field],
    /// What may stand there, parameters aside.
    known: Vec<&'static Known>,
    asked: Vec<String>,
}

impl<'v> Fields<'v> {
    /// The fields of `value`, which `tables` list; an error and no fields where it has none.
    pub fn of(
        resolver: &mut Resolver<'_>,
        value: &'v Value,
        owner: &str,
        tables: &[&'static [Known]],
    ) -> Self {
        let fields = match &value.kind {
            Kind::Record(record) if record.items.is_empty() => record.fields.as_slice(),
            _ => {
                let found = match &value.kind {
                    Kind::Record(_) => "values without names".into(),
                    _ => value.describe(),
                };
                let problem = resolver.error(&value.span, format!("{owner} needs named fields"));
                problem.help.push(format!("write `name: value` in parentheses; found {found}"));
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
        let known = tables.iter().copied().flatten().collect();
        Self { owner: owner.to_owned(), span: value.span.clone(), fields, known, asked: vec![] }
    }

    /// The value of `name`, if the author gave one.
    pub fn get(&mut self, name: &str) -> Option<&'v Value> {
        self.known(name);
        self.value(name)
    }

    /// The value of a function's parameter, if the author gave one.
    pub fn parameter(&mut self, parameter: &Parameter) -> Option<&'v Value> {
        self.value(&parameter.name)
    }

    fn value(&mut self, name: &str) -> Option<&'v Value> {
        self.asked.push(name.to_owned());
        self.fields.iter().find(|f| f.name.text == name).map(|f| &f.value)
    }

    /// What the tables say of `name`. Only what they list is read, so that they list all there is.
    fn known(&self, name: &str) -> &'static Known {
        let known = self.known.iter().find(|known| known.name == name);
        known.unwrap_or_else(|| panic!("{} has `{name}` in no table of ir/fields.rs", self.owner))
    }

    fn limits(&self, name: &str) -> Number {
        match self.known(name).takes {
            Takes::Number(number) => number,
            other => panic!("`{name}` of {} is no number but {other:?}", self.owner),
        }
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

    /// A number within its limits; required where there is no default.
    pub fn number(&mut self, resolver: &mut Resolver<'_>, name: &str) -> f32 {
        let limits = self.limits(name);
        let is_required = self.known(name).is_required;
        let written = if is_required { self.require(resolver, name) } else { self.get(name) };
        let otherwise = limits.default.unwrap_or(limits.low);
        let Some(value) = written else { return otherwise };
        let x = resolver.number(value, Some((limits.low, limits.high))).unwrap_or(otherwise);
        if limits.is_whole && x.fract() != 0.0 {
            resolver.mismatch(value, "a whole number");
        }
        x
    }

    /// A number within its limits, if the author gave one; `None` gives none.
    pub fn given_number(&mut self, resolver: &mut Resolver<'_>, name: &str) -> Option<f32> {
        let Number { low, high, .. } = self.limits(name);
        let given = self.get(name).filter(|value| value.kind != Kind::None);
        given.and_then(|value| resolver.number(value, Some((low, high))))
    }

    /// A number or a pattern, if the author gave one; an error where it is required.
    pub fn pattern(&mut self, resolver: &mut Resolver<'_>, name: &str) -> Option<ir::Value> {
        let Number { low, high, .. } = self.limits(name);
        let is_required = self.known(name).is_required;
        let written = if is_required { self.require(resolver, name) } else { self.get(name) };
        written.map(|value| resolver.pattern(value, (low, high)))
    }

    /// A color or a texture, if the author gave one; an error where it is required.
    pub fn color(&mut self, resolver: &mut Resolver<'_>, name: &str) -> Option<ir::Value> {
        let is_required = self.known(name).is_required;
        let written = if is_required { self.require(resolver, name) } else { self.get(name) };
        written.map(|value| resolver.color(value))
    }

    /// The color that holds where the author leaves `name` out.
    pub fn default_color(&self, name: &str) -> Vec3 {
        match self.known(name).takes {
            Takes::Color { default, .. } => Vec3::splat(default),
            other => panic!("`{name}` of {} is no color but {other:?}", self.owner),
        }
    }

    /// A vector; required where there is no default.
    pub fn vector(&mut self, resolver: &mut Resolver<'_>, name: &str) -> Vec3 {
        let default = match self.known(name).takes {
            Takes::Vector { default } => default.map(Vec3::from_array),
            other => panic!("`{name}` of {} is no vector but {other:?}", self.owner),
        };
        let written = if default.is_some() { self.get(name) } else { self.require(resolver, name) };
        let otherwise = default.unwrap_or(Vec3::ZERO);
        written.map_or(otherwise, |value| resolver.vector(value).unwrap_or(otherwise))
    }

    /// A vector with all the digits that the author wrote.
    pub fn exact_vector(&mut self, resolver: &mut Resolver<'_>, name: &str) -> DVec3 {
        let rounded = self.vector(resolver, name);
        let written = self.fields.iter().find(|f| f.name.text == name).and_then(|f| exactly(&f.value));
        written.filter(|exact| exact.as_vec3() == rounded).unwrap_or(rounded.as_dvec3())
    }

    /// A vector with a length, scaled to length 1.
    pub fn direction(&mut self, resolver: &mut Resolver<'_>, name: &str) -> Vec3 {
        let given = self.vector(resolver, name);
        given.try_normalize().unwrap_or_else(|| {
            if let Some(field) = self.fields.iter().find(|f| f.name.text == name) {
                resolver.error(&field.value.span, format!("`{name}` has no length"));
            }
            Vec3::Y
        })
    }

    pub fn flag(&mut self, resolver: &mut Resolver<'_>, name: &str) -> bool {
        let default = match self.known(name).takes {
            Takes::Flag { default } => default,
            other => panic!("`{name}` of {} is no flag but {other:?}", self.owner),
        };
        self.get(name).map_or(default, |value| match value.kind {
            Kind::Bool(b) => b,
            _ => {
                resolver.mismatch(value, "true or false");
                default
            }
        })
    }

    /// Which of its words `name` has, the first where the author gave none.
    pub fn word(&mut self, resolver: &mut Resolver<'_>, name: &str) -> &'static str {
        let words: Vec<&str> = match self.known(name).takes {
            Takes::Choice(choices) => choices.iter().map(|choice| choice.word).collect(),
            other => panic!("`{name}` of {} is no choice but {other:?}", self.owner),
        };
        let Some(value) = self.get(name) else { return words[0] };
        let given = match &value.kind {
            Kind::Text(text) => text.as_str(),
            Kind::Record(Record { name: Some(name), fields, items })
                if fields.is_empty() && items.is_empty() =>
            {
                &name.text
            }
            _ => "",
        };
        let known = words.iter().find(|word| word.eq_ignore_ascii_case(given));
        known.copied().unwrap_or_else(|| {
            resolver.mismatch(value, &format!("one of {}", words.join(", ")));
            words[0]
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

/// The three numbers that `value` is made of.
fn exactly(value: &Value) -> Option<DVec3> {
    let (Kind::Tuple(items) | Kind::List(items)) = &value.kind else { return None };
    let number = |item: &Value| match item.kind {
        Kind::Number(x) => Some(x),
        _ => None,
    };
    let numbers: Option<Vec<f64>> = items.iter().map(number).collect();
    numbers.filter(|numbers| numbers.len() == 3).map(|numbers| DVec3::from_slice(&numbers))
}
