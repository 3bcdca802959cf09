//! What the author wrote: the RON text as a tree in which every value knows its place.
//!
//! In: the text of a scene. Out: a [`Value`], or all the syntax errors. What names mean is not known here.

mod parse;

use std::ops::Range;

pub use parse::parse;

/// A value and its place in the text, in bytes.
#[derive(Clone, Debug, PartialEq)]
pub struct Value {
    pub span: Range<usize>,
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

impl Value {
    /// What it is, for "found …".
    pub fn describe(&self) -> String {
        match &self.kind {
            Kind::None => "`None`".into(),
            Kind::Bool(b) => format!("`{b}`"),
            Kind::Number(x) => format!("the number {x}"),
            Kind::Text(text) => format!("the string \"{text}\""),
            Kind::Tuple(items) => format!("a vector of {}", items.len()),
            Kind::List(_) => "a list".into(),
            Kind::Map(_) => "a map".into(),
            Kind::Record(Record { name: Some(name), .. }) => format!("`{}`", name.text),
            Kind::Record(_) => "a group of fields".into(),
        }
    }
}
