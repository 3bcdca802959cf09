//! Shapes, and solids made of them: constructive solid geometry (CSG).
//!
//! In: shapes with their arguments. Out: an [`Object`] for each thing that rays are tested against.

use std::sync::Arc;

use glam::Vec3;

use super::Value;
use crate::library::Function;

/// The most parts of a CSG solid, and of a group of them: drivers compile more at once slowly.
const MAX_PARTS: usize = 16;

/// A shape with a surface of its own.
#[derive(Clone, Debug, PartialEq)]
pub struct Primitive {
    pub name: String,
    /// The author's words, on one line.
    pub caption: String,
    pub shape: Arc<Function>,
    /// One for each parameter. Those of a shape that gives a distance may vary from point to point.
    pub arguments: Vec<Value>,
    /// One of [`super::Scene::materials`].
    pub material: usize,
    /// Where it stands, if it was moved.
    pub space: Option<Space>,
    /// Whether it is cut away from another solid, which shows its surface from behind.
    pub inverted: bool,
}

/// The rows of the affine map from the world into an object's space.
pub type Space = [[f32; 4]; 3];

/// What a ray meets as one.
#[derive(Clone, Debug, PartialEq)]
pub struct Object {
    pub solid: Solid,
    /// Where it stands, if it was moved.
    pub space: Option<Space>,
    /// Corners of a box in the object's space that holds all of it.
    pub bounds: Option<(Vec3, Vec3)>,
    pub visible: bool,
    pub casts_shadow: bool,
}

impl Object {
    /// The author's name for it, or the one that its place in the file gives it.
    pub fn name<'s>(&'s self, scene: &'s super::Scene) -> &'s str {
        match &self.solid {
            Solid::Primitive(index) => &scene.primitives[*index].name,
            Solid::Csg(csg) => &csg.name,
        }
    }
}

#[derive(Clone, Debug, PartialEq)]
pub enum Solid {
    /// One of [`super::Scene::primitives`].
    Primitive(usize),
    Csg(Csg),
}

/// A solid made of solids.
#[derive(Clone, Debug, PartialEq)]
pub struct Csg {
    pub name: String,
    /// The author's words, on one line, without the parts.
    pub caption: String,
    pub operation: CsgOperation,
    /// At least one.
    pub parts: Vec<Solid>,
}

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum CsgOperation {
    /// What is in any part.
    Union,
    /// What is in every part.
    Intersection,
    /// What is in the first part and in no other.
    Difference,
}

impl Primitive {
    /// Whether a texture takes part in its shape.
    pub fn is_textured(&self) -> bool {
        self.arguments.iter().any(|argument| !matches!(argument, Value::Const(_) | Value::Model(_)))
    }
}

impl Solid {
    /// Whether it is or has this one of [`super::Scene::primitives`].
    pub fn has(&self, object: usize) -> bool {
        match self {
            Solid::Primitive(index) => *index == object,
            Solid::Csg(csg) => csg.parts.iter().any(|part| part.has(object)),
        }
    }
}

impl Csg {
    /// The same solid, in which many parts are solids of a few.
    pub fn in_groups(mut self) -> Self {
        let name = self.name.clone();
        if self.parts.len() > MAX_PARTS && self.operation == CsgOperation::Difference {
            // What is in none of many is not in their union.
            let cut =
                group(format!("{name}, what is cut away"), CsgOperation::Union, self.parts.split_off(1));
            self.parts.push(Solid::Csg(cut.in_groups()));
        }
        let mut width = 1;
        while self.parts.len() > MAX_PARTS {
            width *= MAX_PARTS;
            let mut parts = std::mem::take(&mut self.parts).into_iter().peekable();
            for first in (1..).step_by(width) {
                if parts.peek().is_none() {
                    break;
                }
                let few = parts.by_ref().take(MAX_PARTS).collect();
                let name = format!("{name}, parts {first} to {}", first + width - 1);
                self.parts.push(Solid::Csg(group(name, self.operation, few)));
            }
        }
        self
    }
}

fn group(name: String, operation: CsgOperation, parts: Vec<Solid>) -> Csg {
    Csg { name, caption: format!("{operation:?}"), operation, parts }
}
