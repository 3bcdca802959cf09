//! The part of a scene that is to be seen: all of it, one object, or one material on a stage.

use crate::compile::Compiled;
use crate::diagnostic::Diagnostic;

/// The part of the scene that the author looks at.
#[derive(Clone, Debug, Default, PartialEq)]
pub enum Focus {
    #[default]
    All,
    /// The object that has the primitive of this name.
    Object(String),
    /// The material of this name, on a stage.
    Material(String),
}

impl Focus {
    /// The part of `compiled` that is to be seen; all of it where it has no such part.
    ///
    /// # Errors
    /// Where naga refuses the part although it took the whole, which would be a mistake of ours.
    pub fn of(&self, compiled: Compiled) -> Result<Compiled, Diagnostic> {
        let scene = &compiled.scene;
        let part = match self {
            Focus::All => None,
            Focus::Object(name) => {
                scene.primitives.iter().position(|o| o.name == *name).map(|i| compiled.isolated(i))
            }
            Focus::Material(name) => {
                scene.materials.iter().position(|m| m.name == *name).map(|i| compiled.on_stage(i))
            }
        };
        part.unwrap_or(Ok(compiled))
    }
}
