//! Other texts of a scene that is compiled: fewer objects, another way of numbers, more entry points.
//!
//! In: [`Compiled`]. Out: another.

use super::{Compiled, on_deep_stack};
use crate::diagnostic::Diagnostic;
use crate::wgsl::{self, Mode, Target};
use crate::{ir, module};

impl Compiled {
    /// This scene with its numbers in the other `mode`.
    ///
    /// # Errors
    /// If naga refuses that text although it took the other, which would be a mistake of ours.
    pub fn in_mode(&self, mode: Mode) -> Result<Self, Diagnostic> {
        self.with_scene(self.scene.clone(), Target { mode, ..self.source.target.clone() })
    }

    /// This scene without debug views, and with all numbers as literals.
    ///
    /// # Errors
    /// If naga refuses that text although it took the whole, which would be a mistake of ours.
    pub fn plain(&self) -> Result<Self, Diagnostic> {
        self.with_scene(self.scene.clone(), Target::plain())
    }

    /// The scene with one object alone: the one that has this primitive is seen and casts a shadow. Lights,
    /// camera and background stay, and so do all indices.
    ///
    /// # Errors
    /// If naga refuses that text although it took the whole scene's, which would be a mistake of ours.
    pub fn isolated(&self, primitive: usize) -> Result<Self, Diagnostic> {
        let mut scene = self.scene.clone();
        for object in &mut scene.objects {
            let is_chosen = object.solid.has(primitive);
            object.visible = is_chosen;
            object.casts_shadow = is_chosen;
        }
        self.with_scene(scene, self.source.target.clone())
    }

    /// This scene with a number for the debug view `value`.
    ///
    /// # Errors
    /// If naga refuses that text although it took the other, since a file of the author's has a function
    /// of the same name; or if a texture that is measured has more images than can be bound.
    pub fn measuring(&self, measure: ir::Measure) -> Result<Self, Diagnostic> {
        let scene = ir::Scene { measure: Some(measure), ..self.scene.clone() };
        if scene.images_in_use().len() > ir::Scene::MAX_IMAGES {
            let message =
                format!("the scene and what is measured have more than {} images", ir::Scene::MAX_IMAGES);
            return Err(Diagnostic::error(message));
        }
        self.with_scene(scene, Target { views: true, ..self.source.target.clone() })
    }

    /// Returns true if `other` can use the pipeline of this one, where both have their numbers as data.
    pub fn has_structure_of(&self, other: &Self) -> bool {
        self.source.sections == other.source.sections && self.scene.has_files_of(&other.scene)
    }

    /// This scene with the entry points by which a [`crate::gpu::Probe`] asks it.
    ///
    /// # Errors
    /// If naga refuses them, since a file of the author's has a function of the same name.
    pub fn probed(&self) -> Result<Self, Diagnostic> {
        self.with_scene(self.scene.clone(), Target { probe: true, ..self.source.target.clone() })
    }

    pub(crate) fn with_scene(&self, scene: ir::Scene, target: Target) -> Result<Self, Diagnostic> {
        let source = wgsl::generate(&scene, &target);
        let module = on_deep_stack(|| module::validate(&source))?;
        Ok(Self { text: self.text.clone(), scene, source, module, times: self.times })
    }
}
