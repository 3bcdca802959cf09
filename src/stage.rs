//! A material by itself: on a ball, a block and a floor, in the same light for all.
//!
//! In: a compiled scene, and which of its materials. Out: another scene.

use crate::compile::{Compiled, compile};
use crate::diagnostic::Diagnostic;
use crate::sources::Sources;

const STAGE: &str = r##"(
    camera: (eye: (0.5, 2.8, 6), target: (0.1, 0.75, 0), fov_deg: 34),
    background: Gradient(zenith: "#5d88c9", horizon: "#dfe9f5"),
    ambient: 0.2,
    lights: [Point(position: (4, 6, 5), radius: 0.4)],
    objects: [
        Plane(name: "floor"),
        Sphere(name: "ball", center: (-1.1, 1, 0)),
        RoundedBox(name: "block", min: (0.35, 0, -0.75), max: (1.85, 1.5, 0.75), radius: 0.03,
            rotate_deg: (0, 25, 0)),
    ],
)"##;

impl Compiled {
    /// A scene that shows one of this scene's materials, with its numbers in the same mode.
    ///
    /// # Errors
    /// Where naga refuses it although it took the material before, which would be a mistake of ours.
    pub fn on_stage(&self, material: usize) -> Result<Self, Diagnostic> {
        let sources = Sources::in_memory().with("stage.ron", STAGE);
        let stage = compile(&sources, "stage.ron".as_ref(), self.source.target.mode, None);
        let mut scene = stage.compiled.expect("the stage has no mistakes").scene;
        scene.images.clone_from(&self.scene.images);
        scene.models.clone_from(&self.scene.models);
        scene.textures.clone_from(&self.scene.textures);
        scene.materials.clone_from(&self.scene.materials);
        scene.primitives.iter_mut().for_each(|object| object.material = material);
        self.with_scene(scene, self.source.target.clone())
    }
}
