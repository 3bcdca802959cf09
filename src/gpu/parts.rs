//! The parts that a large picture is drawn in, so that neither its side nor its memory is the GPU's limit.
//!
//! In: the size of a picture. Out: strips from the top, each of them [`Region`]s from the left.

use super::{Gpu, Region};

/// How large a part may be.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Parts {
    /// Of a strip, unless two rows have more.
    pub pixels: u32,
    /// Width and height of a region, pixels.
    pub side: u32,
}

impl Parts {
    /// 4 million pixels take some 250 MB in all.
    pub fn of(gpu: &Gpu) -> Self {
        Self { pixels: 1 << 22, side: gpu.device.limits().max_texture_dimension_2d }
    }

    /// All of a picture. Parts begin at even rows and columns, as GPUs draw squares of two by two pixels.
    pub fn strips(self, [width, height]: [u32; 2]) -> Vec<Vec<Region>> {
        let even = |n: u32| (n & !1).max(2);
        let (rows, columns) = (even((self.pixels / width).min(self.side)), even(self.side) as usize);
        let strip = |top: u32| {
            let rows = top..top.saturating_add(rows).min(height);
            let region = |left: u32| Region {
                columns: left..left.saturating_add(columns as u32).min(width),
                rows: rows.clone(),
            };
            (0..width).step_by(columns).map(region).collect()
        };
        (0..height).step_by(rows as usize).map(strip).collect()
    }
}

/// Lays the texels of `region` into those of its strip, which is `width` wide.
pub fn lay<T: Copy>(strip: &mut [T], width: u32, region: &Region, part: &[T]) {
    let (width, left, columns) = (width as usize, region.columns.start as usize, region.columns.len());
    for (row, texels) in strip.chunks_exact_mut(width).zip(part.chunks_exact(columns)) {
        row[left..left + columns].copy_from_slice(texels);
    }
}
