//! Numbers, vectors and colors, given directly.

use glam::Vec3;

use super::Resolver;
use crate::library::{Const, Parameter, Type};
use crate::scene::{Kind, Value};

/// Beyond this f32 loses the digits that a picture needs.
const LARGEST: f64 = 1e9;
/// Below this the square of a length is nothing.
const LEAST_LENGTH: f32 = 1e-12;

impl Resolver<'_> {
    /// "expected …, found …".
    pub fn mismatch(&mut self, value: &Value, expected: &str) {
        self.error(&value.span, format!("expected {expected}, found {}", value.describe()));
    }

    /// A number, inside `range` where there is one.
    pub fn number(&mut self, value: &Value, range: Option<(f32, f32)>) -> Option<f32> {
        let Kind::Number(x) = value.kind else {
            self.mismatch(value, "a number");
            return None;
        };
        if x.abs() > LARGEST {
            self.error(&value.span, format!("{x} is too large: numbers go up to {LARGEST}"));
            return None;
        }
        let x = x as f32;
        if let Some((low, high)) = range
            && !(low..=high).contains(&x)
        {
            self.error(&value.span, format!("{x} is out of range: {low} to {high}"));
            return None;
        }
        Some(x)
    }

    /// A vector of three numbers.
    pub fn vector(&mut self, value: &Value) -> Option<Vec3> {
        self.numbers(value, 3, None).map(|n| Vec3::from_slice(&n))
    }

    /// The value of a parameter that cannot vary over a surface.
    pub fn constant(&mut self, parameter: &Parameter, value: &Value) -> Option<Const> {
        if parameter.is_color {
            return Some(Const::Vec3(self.constant_color(value)));
        }
        if !parameter.choices.is_empty() {
            return self.choice(parameter, value);
        }
        let numbers = match (parameter.ty, &value.kind) {
            (Type::Bool, Kind::Bool(b)) => return Some(Const::Bool(*b)),
            (Type::Bool, _) => {
                self.mismatch(value, Type::Bool.describe());
                return None;
            }
            (ty, _) => self.numbers(value, ty.size(), parameter.range)?,
        };
        let whole = matches!(parameter.ty, Type::I32 | Type::U32);
        if whole && (numbers[0].fract() != 0.0 || numbers[0].abs() > 16_777_216.0) {
            self.mismatch(value, parameter.ty.describe());
            return None;
        }
        if parameter.ty == Type::U32 && numbers[0] < 0.0 {
            self.mismatch(value, parameter.ty.describe());
            return None;
        }
        if parameter.nonzero && numbers.iter().all(|n| n.abs() < LEAST_LENGTH) {
            self.error(&value.span, format!("`{}` has no length", parameter.name));
            return None;
        }
        Const::from_numbers(parameter.ty, &numbers)
    }

    fn choice(&mut self, parameter: &Parameter, value: &Value) -> Option<Const> {
        let given = match &value.kind {
            Kind::Text(text) => text,
            Kind::Record(record) if record.fields.is_empty() && record.items.is_empty() => {
                record.name.as_ref().map_or("", |n| n.text.as_str())
            }
            _ => "",
        };
        let at = parameter.choices.iter().position(|c| c.eq_ignore_ascii_case(given));
        if at.is_none() {
            let expected = format!("one of {}", parameter.choices.join(", "));
            self.mismatch(value, &expected);
        }
        at.map(|i| Const::U32(i as u32))
    }

    /// `size` numbers: one by itself, more as a vector.
    pub fn numbers(&mut self, value: &Value, size: usize, range: Option<(f32, f32)>) -> Option<Vec<f32>> {
        if size == 1 {
            return self.number(value, range).map(|n| vec![n]);
        }
        match &value.kind {
            Kind::Tuple(items) if items.len() == size => {
                items.iter().map(|i| self.number(i, range)).collect()
            }
            Kind::List(items) if items.len() == size => {
                let problem = self.error(&value.span, "vectors are written in parentheses");
                problem.help.push("replace [ ] with ( )".into());
                None
            }
            _ => {
                let expected = format!("a vector of {size} numbers");
                self.mismatch(value, &expected);
                None
            }
        }
    }
}
