//! What the author wrote: the RON text as a tree in which every value knows its place.
//!
//! In: the text of a scene. Out: a [`Value`], or all the syntax errors; and what two of them say differently.
//! What names mean is not known here.

mod brackets;
mod changes;
mod numbers;
mod order;
mod parse;
mod path;

use std::ops::Range;

pub use changes::{Change, ChangeKind, Side, changes};
pub use numbers::block_comment;
pub use order::found_again;
pub use parse::parse;
pub use path::{Path, Step};

/// A value and its place in the text, in bytes.
#[derive(Clone, Debug, PartialEq)]
pub struct Value {
    pub span: Range<usize>,
    /// The same, with the `Some(…)` around it where there is one.
    pub whole: Range<usize>,
    pub kind: Kind,
}

/// What a value is. `Some(x)` is `x`.
#[derive(Clone, Debug, PartialEq)]
pub enum Kind {
    None,
    Bool(bool),
    Number(f64),
    Text(String),
    /// `(1, 2, 3)`
    Tuple(Vec<Value>),
    /// `[1, 2, 3]`
    List(Vec<Value>),
    /// `{ "name": value }`
    Map(Vec<Field>),
    /// `(field: value)`, `Name(field: value)`, `Name(value)` or `Name`
    Record(Record),
}

/// A name with a value: `radius: 1` or `"tiles": Checker()`.
#[derive(Clone, Debug, PartialEq)]
pub struct Field {
    pub name: Name,
    pub value: Value,
}

#[derive(Clone, Debug, PartialEq)]
pub struct Name {
    pub span: Range<usize>,
    pub text: String,
}

/// Fields, named or not, that belong together.
#[derive(Clone, Debug, PartialEq, Default)]
pub struct Record {
    pub name: Option<Name>,
    pub fields: Vec<Field>,
    /// Values without a name: the `2.0` of `Gamma(2.0)`.
    pub items: Vec<Value>,
}

/// The longest text that a message repeats.
const LONGEST_QUOTE: usize = 40;

impl Value {
    /// A group of fields that the author left out: it has none.
    pub fn left_out() -> Self {
        Self { span: 0..0, whole: 0..0, kind: Kind::Record(Record::default()) }
    }

    /// Whether both say the same, wherever and however they are written.
    pub fn says_the_same_as(&self, other: &Value) -> bool {
        let all = |a: &[Value], b: &[Value]| {
            a.len() == b.len() && a.iter().zip(b).all(|(a, b)| a.says_the_same_as(b))
        };
        let fields = |a: &[Field], b: &[Field]| {
            let same =
                |(a, b): (&Field, &Field)| a.name.text == b.name.text && a.value.says_the_same_as(&b.value);
            a.len() == b.len() && a.iter().zip(b).all(same)
        };
        match (&self.kind, &other.kind) {
            (Kind::Tuple(a), Kind::Tuple(b)) | (Kind::List(a), Kind::List(b)) => all(a, b),
            (Kind::Map(a), Kind::Map(b)) => fields(a, b),
            (Kind::Record(a), Kind::Record(b)) => {
                let name = |r: &Record| r.name.as_ref().map(|n| n.text.clone());
                name(a) == name(b) && fields(&a.fields, &b.fields) && all(&a.items, &b.items)
            }
            (a, b) => a == b,
        }
    }

    /// What it is, for "found …".
    pub fn describe(&self) -> String {
        match &self.kind {
            Kind::None => "`None`".into(),
            Kind::Bool(b) => format!("`{b}`"),
            Kind::Number(x) => format!("the number {x}"),
            Kind::Text(text) if text.chars().count() > LONGEST_QUOTE => {
                let start: String = text.chars().take(LONGEST_QUOTE).collect();
                format!("the string \"{start}…\"")
            }
            Kind::Text(text) => format!("the string \"{text}\""),
            Kind::Tuple(items) => format!("a vector of {}", items.len()),
            Kind::List(_) => "a list".into(),
            Kind::Map(_) => "a map".into(),
            Kind::Record(Record { name: Some(name), .. }) => format!("`{}`", name.text),
            Kind::Record(_) => "a group of fields".into(),
        }
    }
}
