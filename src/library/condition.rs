//! What the numbers of a shape keep to among each other: doc lines such as `base differs from top`.
//!
//! In: the doc lines of a shape's file. Out: [`Condition`]s, each of which can be asked about given numbers.

use std::ops::Range;

use glam::Vec3;

use super::header::Header;
use super::{Const, Parameter, Type, lexer};
use crate::diagnostic::Diagnostic;

/// Without it the shape would have no size.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Condition {
    pub relation: Relation,
    /// Indices of the parameters, in the order of the line.
    pub parameters: Vec<usize>,
}

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Relation {
    /// Two points are apart.
    Apart,
    /// Two corners are apart along two axes at least.
    ApartAlongTwoAxes,
    /// Two directions are no multiples of each other.
    Slanted,
    /// Three points span a triangle.
    OffLine,
    /// The first number is less than the second.
    Less,
}

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

/// Coordinates nearer than this share of their size are the same to numbers of 32 bits.
const SAME: f32 = 2.4e-7;
/// And so are those nearer than this.
const LEAST_APART: f32 = 1e-9;
/// The sine of the least angle that directions have.
const LEAST_SINE: f32 = 1e-6;

impl Condition {
    /// Whether it holds for the arguments of a shape; None stands for a texture, of which it is not asked.
    pub fn holds(&self, arguments: &[Option<Const>]) -> bool {
        let given: Option<Vec<Const>> =
            self.parameters.iter().map(|index| arguments.get(*index).copied()?).collect();
        match given.as_deref() {
            Some([Const::Vec3(a), Const::Vec3(b)]) => match self.relation {
                Relation::ApartAlongTwoAxes => axes_apart(*a, *b) > 1,
                Relation::Slanted => are_slanted(*a, *b),
                _ => axes_apart(*a, *b) > 0,
            },
            Some([Const::Vec3(a), Const::Vec3(b), Const::Vec3(c)]) => are_slanted(*b - *a, *c - *a),
            Some([Const::F32(a), Const::F32(b)]) => a < b,
            _ => true,
        }
    }

    /// Whether it holds and leaves the shape flat all the same, so that it encloses nothing.
    pub fn leaves_flat(&self, arguments: &[Option<Const>]) -> bool {
        let given = |index: usize| arguments.get(self.parameters[index]).copied().flatten();
        match (self.relation, given(0), given(1)) {
            (Relation::ApartAlongTwoAxes, Some(Const::Vec3(a)), Some(Const::Vec3(b))) => {
                axes_apart(a, b) == 2
            }
            _ => false,
        }
    }
}

/// Along how many axes two points are apart.
fn axes_apart(a: Vec3, b: Vec3) -> usize {
    let is_apart = |axis: &usize| {
        let (a, b) = (a[*axis], b[*axis]);
        (a - b).abs() > (SAME * a.abs().max(b.abs())).max(LEAST_APART)
    };
    (0..3).filter(is_apart).count()
}

fn are_slanted(a: Vec3, b: Vec3) -> bool {
    let (a, b) = (a.as_dvec3(), b.as_dvec3());
    let longest = a.length_squared().max(b.length_squared());
    let least = f64::from(LEAST_APART);
    longest > least * least && a.cross(b).length() > f64::from(LEAST_SINE) * longest
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
