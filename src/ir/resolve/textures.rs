//! Values that vary over a surface: calls of textures and mappings, and names of them.

use std::sync::Arc;

use super::colors::COLOR_FORMS;
use super::reader::Fields;
use super::{Resolver, Usage};
use crate::diagnostic::Diagnostic;
use crate::ir::fields::{EVERY_TEXTURE, FORMS, OPERATIONS};
use crate::ir::{Call, Value};
use crate::library::{Const, Family, Function, Kind, Parameter, Type};
use crate::scene::{self, Kind as Written, Record};

impl<'a> Resolver<'a> {
    /// A color, or what becomes one.
    pub fn color(&mut self, value: &scene::Value) -> Value {
        self.varying(value, Type::Vec3, true, None)
    }

    /// A number, or what becomes one; constants inside `range`.
    pub fn pattern(&mut self, value: &scene::Value, range: (f32, f32)) -> Value {
        self.varying(value, Type::F32, false, Some(range))
    }

    fn varying(
        &mut self,
        value: &scene::Value,
        want: Type,
        is_color: bool,
        range: Option<(f32, f32)>,
    ) -> Value {
        let usage = if is_color { self.usage } else { Usage::Number };
        self.wanted_for(usage, |resolver| resolver.value(value, want, is_color, range))
    }

    fn value(
        &mut self,
        value: &scene::Value,
        want: Type,
        is_color: bool,
        range: Option<(f32, f32)>,
    ) -> Value {
        let stand_in = Const::from_numbers(want, &vec![range.map_or(0.0, |r| r.0); want.size()]);
        let stand_in = Value::Const(stand_in.expect("as many numbers as the type has"));
        match &value.kind {
            Written::Record(record) if record.name.is_some() => match self.texture(value, record, want) {
                Some(texture) => self.fit(texture, want),
                None => stand_in,
            },
            Written::Text(name) if self.declared.contains_key(name.as_str()) => {
                let texture = self.declared_texture(name, &value.span, want);
                texture.map_or(stand_in, |index| self.fit(Value::Texture(index), want))
            }
            Written::Text(text) if is_color || want == Type::F32 => match self.plain_color(value) {
                Some(color) => self.fit(Value::Const(Const::Vec3(color)), want),
                None => {
                    let declared: Vec<&str> = self.declared.keys().copied().collect();
                    let message = format!("\"{text}\" is neither a color nor a declared texture");
                    let place = self.place(&value.span);
                    let mut problem = Diagnostic::error(message).at(place, "").suggest(text, declared);
                    problem.help.push(COLOR_FORMS.into());
                    self.push(problem);
                    stand_in
                }
            },
            _ if is_color => match self.plain_color(value) {
                Some(color) => Value::Const(Const::Vec3(color)),
                None => {
                    self.mismatch(value, "a color or a texture");
                    stand_in
                }
            },
            Written::Tuple(_) if want == Type::Vec3 => {
                self.vector(value).map_or(stand_in, |v| Value::Const(Const::Vec3(v)))
            }
            _ if want == Type::F32 => {
                if matches!(value.kind, Written::Number(_)) {
                    self.number(value, range).map_or(stand_in, |x| Value::Const(Const::F32(x)))
                } else {
                    self.mismatch(value, "a number or a texture");
                    stand_in
                }
            }
            _ => {
                self.mismatch(value, want.describe());
                stand_in
            }
        }
    }

    /// `value` as a `want`: a pattern is a grey, a color its luminance.
    fn fit(&self, value: Value, want: Type) -> Value {
        match (self.type_of(&value), want) {
            (Type::F32, Type::Vec3) => Value::Grey(Box::new(value)),
            (Type::Vec3, Type::F32) => Value::Luminance(Box::new(value)),
            _ => value,
        }
    }

    pub fn type_of(&self, value: &Value) -> Type {
        match value {
            Value::Const(constant) => constant.ty(),
            Value::Call(call) if call.function.kind == Kind::Pattern => Type::F32,
            Value::Texture(index) => self.textures[*index].ty,
            Value::Luminance(_) => Type::F32,
            Value::Image(picture) => picture.ty,
            _ => Type::Vec3,
        }
    }

    /// What `Name(…)` computes.
    pub fn texture(&mut self, value: &scene::Value, record: &Record, want: Type) -> Option<Value> {
        let name = record.name.as_ref().expect("the caller has looked");
        if let Some(form) = FORMS.iter().find(|(form, _)| form.name == name.text) {
            return self.form(form, value, want);
        }
        let function = self.function(Family::Texture, name)?;
        if function.kind == Kind::Mapping {
            let message = format!("`{}` is a mapping: it moves points and has no color", name.text);
            let advice = format!("use it in a texture: `Noise(at: {}(…))`", name.text);
            self.error(&name.span, message).help.push(advice);
            return None;
        }
        self.call(function, value).map(Value::Call)
    }

    /// The function called `name`, or an error with the nearest known one.
    pub fn function(&mut self, family: Family, name: &scene::Name) -> Option<Arc<Function>> {
        match self.lookup.find(family, &name.text) {
            Ok(function) => Some(function),
            Err(Some(problems)) => {
                let place = self.place(&name.span);
                self.problems.extend(problems.into_iter().map(|problem| match problem.labels.is_empty() {
                    true => problem.at(place.clone(), ""),
                    false => problem,
                }));
                None
            }
            Err(None) => {
                let noun = family.noun();
                let mut known = self.lookup.names(family);
                match family {
                    Family::Texture => known.extend(FORMS.iter().map(|(form, _)| form.name.to_owned())),
                    Family::Shape => known.extend(OPERATIONS.iter().map(|(group, _)| group.name.to_owned())),
                }
                let place = self.place(&name.span);
                let problem = Diagnostic::error(format!("there is no {noun} `{}`", name.text)).at(place, "");
                let mut problem = problem.suggest(&name.text, known.iter().map(String::as_str));
                if problem.help.is_empty() {
                    problem.help.push(format!("`raytoy {noun}s` lists them"));
                }
                self.push(problem);
                None
            }
        }
    }

    fn call(&mut self, function: Arc<Function>, value: &scene::Value) -> Option<Call> {
        let mut fields = Fields::of(self, value, &format!("`{}`", function.name), &[EVERY_TEXTURE]);
        let at = self.at(&mut fields);
        let before = self.problems.len();
        let mut arguments = vec![];
        for parameter in &function.parameters {
            let argument = match fields.parameter(parameter) {
                Some(given) => self.argument(parameter, given),
                None => parameter.default.map(Value::Const),
            };
            if argument.is_none() && !fields.has(&parameter.name) {
                self.error(&value.span, format!("`{}` needs `{}`", function.name, parameter.name));
            }
            arguments.extend(argument);
        }
        fields.finish(self);
        let complete = arguments.len() == function.parameters.len() && self.problems.len() == before;
        let at = at?;
        complete.then_some(Call { function, at, arguments })
    }

    /// The value of a parameter that may vary from point to point.
    pub fn argument(&mut self, parameter: &Parameter, given: &scene::Value) -> Option<Value> {
        let varies = match given.kind {
            Written::Record(Record { name: Some(_), .. }) => parameter.choices.is_empty(),
            Written::Text(_) => parameter.is_color || parameter.ty == Type::F32 || parameter.ty == Type::Vec3,
            _ => parameter.is_color,
        };
        if !varies {
            return self.fixed(parameter, given);
        }
        if !matches!(parameter.ty, Type::F32 | Type::Vec3) {
            self.mismatch(given, parameter.ty.describe());
            return None;
        }
        Some(self.varying(given, parameter.ty, parameter.is_color, parameter.range))
    }

    pub fn mapping(&mut self, value: &scene::Value) -> Option<Call> {
        let Written::Record(record @ Record { name: Some(name), .. }) = &value.kind else {
            self.mismatch(value, "a mapping such as `Turbulence()`");
            return None;
        };
        let is_form = FORMS.iter().any(|(form, _)| form.name == name.text);
        let function = if is_form { None } else { Some(self.function(Family::Texture, name)?) };
        match function.filter(|f| f.kind == Kind::Mapping) {
            Some(function) => self.call(function, value),
            None => {
                let name = record.name.as_ref().map_or("", |n| &n.text);
                self.error(
                    &value.span,
                    format!("`{name}` is a texture, but `at` needs a mapping, which moves points"),
                );
                None
            }
        }
    }
}
