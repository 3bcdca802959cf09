//! The parts that a large picture is drawn in, so that neither its side nor its memory is the GPU's limit.
//!
//! In: the size of a picture. Out: strips from the top, each of them [`Region`]s from the left.

use super::{Gpu, Region};

/// How large a part may be.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct Parts {
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
pub(super) fn lay<T: Copy>(strip: &mut [T], width: u32, region: &Region, part: &[T]) {
    let (width, left, columns) = (width as usize, region.columns.start as usize, region.columns.len());
    for (row, texels) in strip.chunks_exact_mut(width).zip(part.chunks_exact(columns)) {
        row[left..left + columns].copy_from_slice(texels);
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn parts_cover_each_pixel_once_and_begin_at_even_places() {
        for (pixels, side, size) in [
            (1 << 22, 16_384, [65_536, 1000]),
            (64, 8, [33, 17]),
            (1, 1, [5, 3]),
            (100, 64, [1, 65]),
            (1 << 22, 16_384, [960, 540]),
        ] {
            let parts = Parts { pixels, side };
            let regions: Vec<Region> = parts.strips(size).into_iter().flatten().collect();
            let covered: u64 = regions.iter().map(|region| u64::from(region.pixels())).sum();
            assert_eq!(covered, u64::from(size[0]) * u64::from(size[1]), "{parts:?} {size:?}");
            for region in &regions {
                assert!(region.columns.start % 2 == 0 && region.rows.start % 2 == 0, "{region:?}");
                assert!(region.columns.end <= size[0] && region.rows.end <= size[1], "{region:?}");
                let most = side.max(2) as usize;
                assert!(region.columns.len() <= most && region.rows.len() <= most, "{region:?}");
            }
        }
        assert_eq!(Parts { pixels: 1 << 22, side: 16_384 }.strips([960, 540]).len(), 1);
    }

    #[test]
    fn parts_are_laid_beside_each_other() {
        let mut strip = [0; 6];
        for (columns, part) in [(0..2, &[1, 2, 4, 5][..]), (2..3, &[3, 6])] {
            lay(&mut strip, 3, &Region { columns, rows: 0..2 }, part);
        }
        assert_eq!(strip, [1, 2, 3, 4, 5, 6]);
    }
}
