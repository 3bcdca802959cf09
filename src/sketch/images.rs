//! Textures as a program reads them: texels as words, and colors between texels.

use glam::Vec4;

use crate::assets;
use crate::frame::{MODELS_BINDING, MODELS_ROW};
use crate::ir::Scene;

/// What one binding of group 1 holds.
#[derive(Debug)]
pub enum Image {
    Empty,
    /// Rows of texels, four words each.
    Words {
        width: u32,
        texels: Vec<[u32; 4]>,
    },
    Colors(assets::Image),
}

impl Image {
    pub fn size(&self) -> [u32; 2] {
        match self {
            Image::Empty => [1; 2],
            Image::Words { width, texels } => [*width, (texels.len() as u32).div_ceil(*width)],
            Image::Colors(image) => image.levels[0].size,
        }
    }

    /// The texel at x and y; nothing beyond the edges.
    pub fn texel(&self, [x, y]: [u32; 2]) -> [u32; 4] {
        match self {
            Image::Words { width, texels } if x < *width => {
                let place = u64::from(y) * u64::from(*width) + u64::from(x);
                texels.get(place as usize).copied().unwrap_or_default()
            }
            _ => [0; 4],
        }
    }

    /// The color at a place that counts in images, on a level between two, linear between texels; the image
    /// goes on beyond its edges.
    pub fn color(&self, place: [f32; 2], level: f32) -> [f32; 4] {
        let Image::Colors(image) = self else { return [0.0; 4] };
        let last = image.levels.len() - 1;
        let level = level.clamp(0.0, last as f32);
        let fine = level.floor();
        let at = |level: usize| between(&image.levels[level.min(last)], place);
        let color = at(fine as usize).lerp(at(fine as usize + 1), level - fine);
        color.to_array()
    }
}

/// Linear between the four texels around a place.
fn between(level: &assets::Level, place: [f32; 2]) -> Vec4 {
    let at = [0, 1].map(|i| (place[i] - place[i].floor()) * level.size[i] as f32 - 0.5);
    let low = at.map(f32::floor);
    let texel = |x: f32, y: f32| {
        let [x, y] = [(x, level.size[0]), (y, level.size[1])]
            .map(|(n, size)| (n as i64).rem_euclid(i64::from(size)) as usize);
        level.texels[y * level.size[0] as usize + x]
    };
    let row = |y: f32| texel(low[0], y).lerp(texel(low[0] + 1.0, y), at[0] - low[0]);
    row(low[1]).lerp(row(low[1] + 1.0), at[1] - low[1])
}

/// All images that the shader of `scene` uses by their bindings, as `frame/texels.rs` has them for a driver.
pub fn images(scene: &Scene) -> Vec<Image> {
    let mut images = vec![Image::Empty];
    images.extend(scene.images_in_use().into_iter().map(|index| Image::Colors(scene.images[index].clone())));
    if !scene.models.is_empty() {
        images.resize_with(MODELS_BINDING as usize, || Image::Empty);
        let mut texels: Vec<[u32; 4]> = vec![];
        for model in &scene.models {
            texels.extend(model.words(texels.len() as u32));
        }
        images.push(Image::Words { width: MODELS_ROW, texels });
    }
    images
}
