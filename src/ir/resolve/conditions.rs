//! Shapes without a size: points that coincide, sides that lie along each other.

use super::Resolver;
use crate::ir::{Primitive, Value};
use crate::library::{Condition, Const, Function, Relation};
use crate::scene::{self, Kind, Name};

impl Resolver<'_> {
    /// Reports what a shape with these arguments does not keep to: nothing would be seen of it, or specks.
    pub fn check_conditions(&mut self, written: &scene::Value, shape: &Function, arguments: &[Value]) {
        let constants = constants(arguments);
        // What is missing has been reported, and shifts those behind it.
        if constants.len() < shape.parameters.len() {
            return;
        }
        for condition in shape.conditions.iter().filter(|condition| !condition.holds(&constants)) {
            self.report(written, shape, condition);
        }
    }

    /// Reports a part that has no inside since it is flat.
    pub fn check_thickness(&mut self, object: &Primitive, name: &Name) {
        let constants = constants(&object.arguments);
        if object.shape.conditions.iter().any(|condition| condition.leaves_flat(&constants)) {
            let advice = "parts must be solids: make it thick along all three axes".into();
            self.error(&name.span, format!("this `{}` is flat and has no inside", name.text))
                .help
                .push(advice);
        }
    }

    fn report(&mut self, written: &scene::Value, shape: &Function, condition: &Condition) {
        let names: Vec<&str> =
            condition.parameters.iter().map(|index| shape.parameters[*index].name.as_str()).collect();
        let all = match &names[..] {
            [a, b, c] => format!("`{a}`, `{b}` and `{c}`"),
            names => names.iter().map(|name| format!("`{name}`")).collect::<Vec<_>>().join(" and "),
        };
        let (message, advice) = match condition.relation {
            Relation::Apart => (format!("{all} are the same point"), "move one of them"),
            Relation::ApartAlongTwoAxes => {
                (format!("{all} differ along fewer than two axes"), "move one of them")
            }
            Relation::Slanted => (format!("{all} are parallel"), "turn one of them"),
            Relation::OffLine => (format!("{all} are on one line"), "move one of them off the line"),
            Relation::Less => {
                (format!("`{}` must be less than `{}`", names[0], names[1]), "change one of them")
            }
        };
        // At the last of them that is written, else at the whole.
        let Kind::Record(record) = &written.kind else { return };
        let is_named = |field: &&scene::Field| names.contains(&field.name.text.as_str());
        let span = record.fields.iter().rev().find(is_named).map_or(&written.span, |field| &field.value.span);
        let help = format!("{advice}, or remove the object: this `{}` would be invisible", shape.name);
        self.error(span, message).help.push(help);
    }
}

/// The arguments that are numbers.
fn constants(arguments: &[Value]) -> Vec<Option<Const>> {
    let constant = |argument: &Value| match argument {
        Value::Const(constant) => Some(*constant),
        _ => None,
    };
    arguments.iter().map(constant).collect()
}
