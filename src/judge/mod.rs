//! Two pictures in, a verdict out: how far apart they are by three measures, and whether that is too far.
//!
//! In: pictures as a screen shows them, and [`Limits`]. Out: a [`Verdict`]. No disk, no GPU, no clock.

mod color;
mod convolve;
mod flip;
mod seen;
mod structure;
mod tolerance;

use image::RgbImage;

pub use flip::{PIXELS_PER_DEGREE, flip, flip_map};
pub use seen::{PictureShift, change};
pub use structure::{Structure, WINDOW, structure};
pub use tolerance::{Area, Outliers, Pixel, outliers};

/// How far a picture may be from what is expected. All of them hold together: each sees what the others miss.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Limits {
    /// Steps of a channel, of 255, by which a pixel may differ without being an outlier.
    pub tolerance: u8,
    /// The share of the pixels that may be outliers, 0 to 1.
    pub outliers: f64,
    /// The least mean of the structural similarity, -1 to 1.
    pub structure: f64,
    /// The least structural similarity of any window.
    pub window: f64,
    /// The most that the mean FLIP difference may be, 0 to 1.
    pub flip: f64,
}

impl Default for Limits {
    /// Chosen by the table in docs/testing.md: they let pass what a driver rounds another way, and nothing
    /// that a person would call a change of the scene.
    fn default() -> Self {
        Self { tolerance: 3, outliers: 0.001, structure: 0.998, window: 0.8, flip: 0.001 }
    }
}

/// The measured values, and the limits that they break.
#[derive(Clone, Debug, PartialEq)]
pub struct Verdict {
    pub outliers: Outliers,
    pub structure: Structure,
    /// Mean FLIP difference, 0 to 1, of all that is more than a rounding.
    pub flip: f64,
    pub limits: Limits,
}

/// Another driver rounds up where one rounds down, in all of a smooth picture. FLIP counts each step in a
/// dark place as half a hundredth, and there would be no room left below what a person calls a change.
const ROUNDING: u8 = 1;

/// A measure beyond its limit.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Broken {
    Outliers,
    Structure,
    Window,
    Flip,
}

/// Measures `actual` beside `expected`.
///
/// # Errors
/// Both sizes, where they are not the same.
pub fn judge(expected: &RgbImage, actual: &RgbImage, limits: Limits) -> Result<Verdict, [(u32, u32); 2]> {
    let sizes = [expected.dimensions(), actual.dimensions()];
    if sizes[0] != sizes[1] {
        return Err(sizes);
    }
    Ok(Verdict {
        outliers: outliers(expected, actual, limits.tolerance),
        structure: structure(expected, actual),
        flip: flip(expected, &without_roundings(expected, actual), PIXELS_PER_DEGREE),
        limits,
    })
}

impl Verdict {
    /// The measures that are beyond their limits.
    pub fn broken(&self) -> Vec<Broken> {
        let Limits { outliers, structure, window, flip, .. } = self.limits;
        let all = [
            (self.outliers.share() > outliers, Broken::Outliers),
            (self.structure.mean < structure, Broken::Structure),
            (self.structure.least < window, Broken::Window),
            (self.flip > flip, Broken::Flip),
        ];
        all.into_iter().filter(|(is_broken, _)| *is_broken).map(|(_, broken)| broken).collect()
    }

    pub fn passes(&self) -> bool {
        self.broken().is_empty()
    }
}

/// `actual` with the pixels of `expected` where no channel is off by more than [`ROUNDING`].
fn without_roundings(expected: &RgbImage, actual: &RgbImage) -> RgbImage {
    let mut settled = actual.clone();
    for (now, before) in settled.pixels_mut().zip(expected.pixels()) {
        if now.0.iter().zip(before.0).all(|(a, b)| a.abs_diff(b) <= ROUNDING) {
            *now = *before;
        }
    }
    settled
}
