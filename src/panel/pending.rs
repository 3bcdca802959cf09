//! Values that were set and that the scene's outline does not show yet: widgets must not lag behind the hand.

use std::collections::BTreeMap;

use glam::Vec3;

use crate::edit::{Edit, NewValue};
use crate::scene::Path;

/// The last value of each field that was set since the outline last agreed with the text.
#[derive(Default)]
pub struct Pending(BTreeMap<Path, NewValue>);

impl Pending {
    pub fn note(&mut self, edit: &Edit) {
        if let Edit::Set { path, value } | Edit::Add { path, value, .. } = edit {
            self.0.insert(path.clone(), value.clone());
        }
    }

    pub fn clear(&mut self) {
        self.0.clear();
    }

    pub fn number(&self, path: &Path) -> Option<f32> {
        match self.0.get(path)? {
            NewValue::Number(number) => Some(*number),
            _ => None,
        }
    }

    pub fn vector(&self, path: &Path) -> Option<Vec<f32>> {
        match self.0.get(path)? {
            NewValue::Vector(numbers) => Some(numbers.clone()),
            _ => None,
        }
    }

    /// Those of a number or a vector.
    pub fn numbers(&self, path: &Path) -> Option<Vec<f32>> {
        self.vector(path).or_else(|| self.number(path).map(|number| vec![number]))
    }

    pub fn color(&self, path: &Path) -> Option<Vec3> {
        match self.0.get(path)? {
            NewValue::Color(color) => Some(*color),
            _ => None,
        }
    }

    pub fn flag(&self, path: &Path) -> Option<bool> {
        match self.0.get(path)? {
            NewValue::Flag(flag) => Some(*flag),
            _ => None,
        }
    }
}
