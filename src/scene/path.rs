//! Addresses of values in a scene, which hold while the text around them changes.

use std::fmt;

use super::{Field, Kind, Value};

/// One step from a value into one of its own.
#[derive(Clone, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Step {
    /// `radius` of `Sphere(radius: 1)`.
    Field(String),
    /// `"tiles"` of `{ "tiles": Checker() }`.
    Key(String),
    /// Of a list, a vector, or the values without names of `Gamma(2.0)`; from 0.
    Item(usize),
}

/// The steps from the root of a scene to a value: `objects[3].radius`.
#[derive(Clone, Debug, Default, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct Path(pub Vec<Step>);

impl Path {
    /// The field `name` of what is here.
    pub fn field(&self, name: &str) -> Self {
        self.then(Step::Field(name.to_owned()))
    }

    /// The entry `name` of the map that is here.
    pub fn key(&self, name: &str) -> Self {
        self.then(Step::Key(name.to_owned()))
    }

    /// The item `index` of the list or vector that is here.
    pub fn item(&self, index: usize) -> Self {
        self.then(Step::Item(index))
    }

    fn then(&self, step: Step) -> Self {
        Self(self.0.iter().cloned().chain([step]).collect())
    }

    /// What this is a part of, and the last step; None for the root.
    pub fn split(&self) -> Option<(Path, &Step)> {
        let (last, rest) = self.0.split_last()?;
        Some((Path(rest.to_vec()), last))
    }
}

impl fmt::Display for Path {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        for (i, step) in self.0.iter().enumerate() {
            match step {
                Step::Field(name) if i == 0 => write!(f, "{name}")?,
                Step::Field(name) => write!(f, ".{name}")?,
                Step::Key(name) => write!(f, "[\"{name}\"]")?,
                Step::Item(index) => write!(f, "[{index}]")?,
            }
        }
        Ok(())
    }
}

impl Value {
    /// The value that one step leads to. Of fields with the same name it is the first.
    pub fn step(&self, step: &Step) -> Option<&Value> {
        let named = |fields: &'_ [Field], name: &str| fields.iter().position(|f| f.name.text == name);
        match (step, &self.kind) {
            (Step::Field(name), Kind::Record(record)) => {
                named(&record.fields, name).map(|i| &record.fields[i].value)
            }
            (Step::Key(name), Kind::Map(entries)) => named(entries, name).map(|i| &entries[i].value),
            (Step::Item(index), Kind::Tuple(items) | Kind::List(items)) => items.get(*index),
            (Step::Item(index), Kind::Record(record)) => record.items.get(*index),
            _ => None,
        }
    }

    /// The value at `path`, if there is one.
    pub fn at(&self, path: &Path) -> Option<&Value> {
        path.0.iter().try_fold(self, |value, step| value.step(step))
    }
}
