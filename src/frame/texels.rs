//! What a scene takes from files, as textures: each image by itself, all models in one.
//!
//! In: a [`Scene`]. Out: [`Texels`], as any GPU takes them.

use half::f16;

use crate::assets::{Image, Model};
use crate::bindings::{Binding, MODELS};
use crate::ir::Scene;

/// As shaders/model.wgsl says.
pub const MODELS_ROW: u32 = 2048;

/// How the bytes of a texel are read; the names are WebGPU's.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum TexelFormat {
    /// Of images: it holds light beyond 1 in half the bytes of a float, and every device filters it.
    Rgba16Float,
    /// Of models.
    Rgba32Uint,
}

/// The texels of one texture of bind group 1.
#[derive(Clone, Debug)]
pub struct Texels {
    pub binding: Binding,
    pub format: TexelFormat,
    /// Width and height of the first level. Each other one is half as wide and as high as the one before it,
    /// rounded down, but at least 1.
    pub size: [u32; 2],
    /// Of each level the bytes: rows from the top, little-endian, without gaps.
    pub levels: Vec<Vec<u8>>,
    /// Names of the images and models that the texels were made of.
    pub files: Vec<String>,
}

/// All textures that the shader of `scene` uses, by their bindings. They are made one after the other, since
/// they may be large.
pub fn texels(scene: &Scene) -> impl Iterator<Item = Texels> {
    let images = (0..).map(Binding::image).zip(scene.images_in_use());
    let images = images.map(|(binding, index)| of_image(binding, &scene.images[index]));
    images.chain((!scene.models.is_empty()).then(|| of_models(&scene.models)))
}

fn of_image(binding: Binding, image: &Image) -> Texels {
    let half = |x: f32| f16::from_f32(x.min(65504.0));
    let texel = |texel: &glam::Vec4| {
        let mut halves = texel.to_array().map(half);
        if image.reading.channel.is_some() {
            // The sum of two halves has the digits of a height map of 16 bits, also between texels.
            halves[1] = half(texel.x - halves[0].to_f32());
        }
        bytemuck::cast::<[u16; 4], [u8; 8]>(halves.map(|half| half.to_bits().to_le()))
    };
    let bytes = |texels: &[glam::Vec4]| texels.iter().map(texel).collect::<Vec<_>>().into_flattened();
    Texels {
        binding,
        format: TexelFormat::Rgba16Float,
        size: image.levels[0].size,
        levels: image.levels.iter().map(|level| bytes(&level.texels)).collect(),
        files: vec![image.file.clone()],
    }
}

/// All models in a row, and the last row of texels to its end.
fn of_models(models: &[Model]) -> Texels {
    let mut words: Vec<[u32; 4]> = vec![];
    for model in models {
        words.extend(model.words(words.len() as u32));
    }
    let rows = (words.len() as u32).div_ceil(MODELS_ROW);
    words.resize((rows * MODELS_ROW) as usize, [0; 4]);
    let texel = |words: [u32; 4]| bytemuck::cast::<[u32; 4], [u8; 16]>(words.map(u32::to_le));
    Texels {
        binding: MODELS,
        format: TexelFormat::Rgba32Uint,
        size: [MODELS_ROW, rows],
        levels: vec![words.into_iter().map(texel).collect::<Vec<_>>().into_flattened()],
        files: models.iter().map(|model| model.file.clone()).collect(),
    }
}
