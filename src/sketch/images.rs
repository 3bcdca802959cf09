//! What the textures of a scene hold, as a program reads them.

use raytoy_vm as vm;

use crate::assets;
use crate::bindings::MODELS;
use crate::frame::MODELS_ROW;
use crate::ir::Scene;

/// What a scene takes from files.
#[derive(Debug)]
pub struct Images {
    colors: Vec<assets::Image>,
    /// Of all models.
    texels: Vec<[u32; 4]>,
}

impl Images {
    pub fn of(scene: &Scene) -> Self {
        let mut texels: Vec<[u32; 4]> = vec![];
        for model in &scene.models {
            texels.extend(model.words(texels.len() as u32));
        }
        let in_use = scene.images_in_use().into_iter();
        Self { colors: in_use.map(|index| scene.images[index].clone()).collect(), texels }
    }

    /// All that the shader uses by their bindings, as `frame/texels.rs` has them for a driver.
    pub fn bound(&self) -> Vec<vm::Image<'_>> {
        let mut images = vec![vm::Image::Empty];
        images.extend(
            self.colors.iter().map(|image| vm::Image::Colors(image.levels.iter().map(level).collect())),
        );
        if !self.texels.is_empty() {
            images.resize_with(MODELS.number as usize, || vm::Image::Empty);
            images.push(vm::Image::Words { width: MODELS_ROW, texels: &self.texels });
        }
        images
    }
}

fn level(level: &assets::Level) -> vm::Level<'_> {
    vm::Level { size: level.size, texels: &level.texels }
}
