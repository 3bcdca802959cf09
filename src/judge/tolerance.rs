//! Pixel by pixel: which differ by more than a few steps of a channel, where they lie, and the worst.

use image::RgbImage;

/// The pixels that are off.
#[derive(Clone, Debug, PartialEq)]
pub struct Outliers {
    pub count: usize,
    /// Pixels of the picture.
    pub of: usize,
    /// The box around all outliers; None if there are none.
    pub bounds: Option<Area>,
    /// The pixel that differs most, also where no pixel is an outlier; None where all are the same.
    pub worst: Option<Pixel>,
}

/// A box of pixels, its ends included.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Area {
    pub x: [u32; 2],
    pub y: [u32; 2],
}

/// A pixel in both pictures.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Pixel {
    pub at: [u32; 2],
    pub expected: [u8; 3],
    pub actual: [u8; 3],
}

impl Outliers {
    /// 0 to 1.
    pub fn share(&self) -> f64 {
        self.count as f64 / self.of as f64
    }
}

impl Pixel {
    /// Steps of the channel that differs most.
    pub fn difference(&self) -> u8 {
        self.expected.iter().zip(self.actual).map(|(a, b)| a.abs_diff(b)).max().unwrap_or(0)
    }
}

/// The pixels in which a channel differs by more than `tolerance` steps of 255.
pub fn outliers(expected: &RgbImage, actual: &RgbImage, tolerance: u8) -> Outliers {
    let mut found = Outliers { count: 0, of: expected.pixels().len(), bounds: None, worst: None };
    for ((x, y, a), b) in expected.enumerate_pixels().zip(actual.pixels()) {
        let pixel = Pixel { at: [x, y], expected: a.0, actual: b.0 };
        let difference = pixel.difference();
        if difference > found.worst.map_or(0, |worst| worst.difference()) {
            found.worst = Some(pixel);
        }
        if difference > tolerance {
            found.count += 1;
            found.bounds = Some(found.bounds.map_or(Area { x: [x; 2], y: [y; 2] }, |b| b.with(x, y)));
        }
    }
    found
}

impl Area {
    /// Left, top, right, bottom.
    pub fn corners(self) -> [u32; 4] {
        [self.x[0], self.y[0], self.x[1], self.y[1]]
    }

    fn with(self, x: u32, y: u32) -> Self {
        let grow = |[low, high]: [u32; 2], at: u32| [low.min(at), high.max(at)];
        Self { x: grow(self.x, x), y: grow(self.y, y) }
    }
}
