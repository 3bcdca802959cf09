//! Textures as a program reads them: texels as words, and colors between texels.

use glam::Vec4;

/// What one binding of group 1 holds.
#[derive(Clone, Debug)]
pub enum Image<'a> {
    Empty,
    /// Rows of texels, four words each.
    Words {
        width: u32,
        texels: &'a [[u32; 4]],
    },
    /// The whole picture first, then each half as wide and as high as the one before it.
    Colors(Vec<Level<'a>>),
}

/// One size of a picture, row by row from the top.
#[derive(Clone, Copy, Debug)]
pub struct Level<'a> {
    pub size: [u32; 2],
    pub texels: &'a [Vec4],
}

impl Image<'_> {
    pub(crate) fn size(&self) -> [u32; 2] {
        match self {
            Image::Empty => [1; 2],
            Image::Words { width, texels } => [*width, (texels.len() as u32).div_ceil(*width)],
            Image::Colors(levels) => levels[0].size,
        }
    }

    /// The texel at x and y; nothing beyond the edges.
    pub(crate) fn texel(&self, [x, y]: [u32; 2]) -> [u32; 4] {
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
    pub(crate) fn color(&self, place: [f32; 2], level: f32) -> [f32; 4] {
        let Image::Colors(levels) = self else { return [0.0; 4] };
        let last = levels.len() - 1;
        let level = level.clamp(0.0, last as f32);
        let fine = level.floor();
        let at = |level: usize| levels[level.min(last)].between(place);
        let color = at(fine as usize).lerp(at(fine as usize + 1), level - fine);
        color.to_array()
    }
}

impl Level<'_> {
    /// Linear between the four texels around a place.
    fn between(&self, place: [f32; 2]) -> Vec4 {
        let at = [0, 1].map(|i| (place[i] - place[i].floor()) * self.size[i] as f32 - 0.5);
        let low = at.map(f32::floor);
        let texel = |x: f32, y: f32| {
            let [x, y] = [(x, self.size[0]), (y, self.size[1])]
                .map(|(n, size)| (n as i64).rem_euclid(i64::from(size)) as usize);
            self.texels[y * self.size[0] as usize + x]
        };
        let row = |y: f32| texel(low[0], y).lerp(texel(low[0] + 1.0, y), at[0] - low[0]);
        row(low[1]).lerp(row(low[1] + 1.0), at[1] - low[1])
    }
}
