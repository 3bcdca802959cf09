//! Doc lines of conditions, such as `base differs from top`.
//!
//! In: the doc lines of a shape's file. Out: [`Condition`]s, and what is wrong with their names.

use std::ops::Range;

use super::condition::{Condition, Relation};
use super::header::Header;
use super::{Parameter, Type, lexer};
use crate::diagnostic::Diagnostic;

/// The form of a line: what stands before, between and behind so many names of parameters of one type.
struct Form {
    around: [&'static str; 3],
    names: usize,
    ty: Type,
    relation: Relation,
}

const FORMS: [Form; 5] = [
    form(["", " differs from ", ""], 2, Type::Vec3, Relation::Apart),
    form(["", " differs from ", " along two axes"], 2, Type::Vec3, Relation::ApartAlongTwoAxes),
    form(["", " is not along ", ""], 2, Type::Vec3, Relation::Slanted),
    form(["no line holds ", ", ", ""], 3, Type::Vec3, Relation::OffLine),
    form(["", " is less than ", ""], 2, Type::F32, Relation::Less),
];

const fn form(around: [&'static str; 3], names: usize, ty: Type, relation: Relation) -> Form {
    Form { around, names, ty, relation }
}

impl Header<'_> {
    /// The conditions that `docs` set the `parameters`.
    pub fn conditions(
        &self,
        parameters: &[Parameter],
        docs: &[(&str, Range<usize>)],
        problems: &mut Vec<Diagnostic>,
    ) -> Vec<Condition> {
        let mut found = vec![];
        for (line, span) in docs {
            let Some((names, form)) = FORMS.iter().find_map(|form| Some((form.names_in(line)?, form))) else {
                continue;
            };
            let mut indices = vec![];
            for name in names {
                let start = span.start + (name.as_ptr() as usize - line.as_ptr() as usize);
                let place = self.place(start..start + name.len());
                let at = parameters.iter().position(|parameter| parameter.name == name);
                match at {
                    Some(index) if parameters[index].ty == form.ty => indices.push(index),
                    Some(_) => problems.push(
                        Diagnostic::error(format!("`{name}` is not {}", form.ty.describe())).at(place, ""),
                    ),
                    None => {
                        let message = format!("`{}` has no parameter `{name}`", self.wgsl_name);
                        let known = parameters.iter().map(|parameter| parameter.name.as_str());
                        problems.push(Diagnostic::error(message).at(place, "").suggest(name, known));
                    }
                }
            }
            found.push(Condition { relation: form.relation, parameters: indices });
        }
        found
    }
}

impl Form {
    /// The names in a line of this form; prose has more than a name in their places.
    fn names_in<'l>(&self, line: &'l str) -> Option<Vec<&'l str>> {
        let [before, between, behind] = self.around;
        let names: Vec<&str> = line.strip_prefix(before)?.strip_suffix(behind)?.split(between).collect();
        let are_names = names.iter().all(|name| lexer::is_name(name));
        (names.len() == self.names && are_names).then_some(names)
    }
}
