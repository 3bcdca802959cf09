//! What a color or a number of a material is at a surface point, unfiltered.

use super::color;
use super::vector::Vec3;

#[derive(Clone, Debug)]
pub enum Texture {
    Constant(Vec3),
    /// `even` where floor(scale·u) + floor(scale·v) is even.
    Checker(Box<Tiles>),
    /// `even` where floor(scale·u) is even.
    Stripes(Box<Tiles>),
}

#[derive(Clone, Debug)]
pub struct Tiles {
    pub scale: Texture,
    pub even: Texture,
    pub odd: Texture,
}

impl Texture {
    pub fn grey(value: f64) -> Texture {
        Texture::Constant(Vec3::splat(value))
    }

    pub fn is_constant(&self) -> bool {
        matches!(self, Texture::Constant(_))
    }

    pub fn color(&self, uv: [f64; 2]) -> Vec3 {
        let (tiles, across) = match self {
            Texture::Constant(color) => return *color,
            Texture::Checker(tiles) => (tiles, 1.0),
            Texture::Stripes(tiles) => (tiles, 0.0),
        };
        let scale = tiles.scale.number(uv);
        let cell = (scale * uv[0]).floor() + across * (scale * uv[1]).floor();
        let tile = if cell.rem_euclid(2.0) == 0.0 { &tiles.even } else { &tiles.odd };
        tile.color(uv)
    }

    /// A color given for a number is its luminance.
    pub fn number(&self, uv: [f64; 2]) -> f64 {
        color::luminance(self.color(uv))
    }
}
