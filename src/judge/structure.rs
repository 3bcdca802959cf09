//! Structural similarity: whether what is bright and dark lies in the same places.
//!
//! Wang, Bovik, Sheikh, Simoncelli: Image Quality Assessment, From Error Visibility to Structural Similarity,
//! 2004, over all 8x8 windows of the luma, each pixel of a window with the same weight.

use image::RgbImage;

/// Pixels along the side of a window; less in pictures that are smaller.
pub const WINDOW: usize = 8;

/// (K L)² of the paper with K = 0.01 and 0.03 and L = 255.
const C1: f64 = 2.55 * 2.55;
const C2: f64 = 7.65 * 7.65;

/// How similar two pictures are: 1 where they are the same, less than 0 where one is the other's negative.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Structure {
    /// Over all windows.
    pub mean: f64,
    /// Of the window that is least similar, and its top left pixel.
    pub least: f64,
    pub least_at: [u32; 2],
}

/// Compares the luma (Rec. 709 weights of the sRGB bytes) of two pictures of one size.
pub fn structure(expected: &RgbImage, actual: &RgbImage) -> Structure {
    let [width, height] = [expected.width() as usize, expected.height() as usize];
    let side = WINDOW.min(width).min(height);
    let (x, y) = (luma(expected), luma(actual));
    let products = |a: &[f64], b: &[f64]| a.iter().zip(b).map(|(a, b)| a * b).collect::<Vec<_>>();
    let means = |values: &[f64]| window_means(values, width, side);
    let (xx, yy, xy) = (means(&products(&x, &x)), means(&products(&y, &y)), means(&products(&x, &y)));
    let (x, y) = (means(&x), means(&y));
    let similarity = |i: usize| {
        let (variances, covariance) = (xx[i] - x[i] * x[i] + yy[i] - y[i] * y[i], xy[i] - x[i] * y[i]);
        let means = (2.0 * x[i] * y[i] + C1) / (x[i] * x[i] + y[i] * y[i] + C1);
        means * (2.0 * covariance + C2) / (variances + C2)
    };
    let all: Vec<f64> = (0..x.len()).map(similarity).collect();
    let (at, least) = all.iter().enumerate().min_by(|a, b| a.1.total_cmp(b.1)).unwrap_or((0, &1.0));
    let columns = width - side + 1;
    Structure {
        mean: all.iter().sum::<f64>() / all.len() as f64,
        least: *least,
        least_at: [(at % columns) as u32, (at / columns) as u32],
    }
}

fn luma(picture: &RgbImage) -> Vec<f64> {
    let weights = [0.2126, 0.7152, 0.0722];
    picture.pixels().map(|p| p.0.iter().zip(weights).map(|(c, w)| f64::from(*c) * w).sum()).collect()
}

/// The mean of each window of `side`² values, by the rows of their top left corners.
fn window_means(values: &[f64], width: usize, side: usize) -> Vec<f64> {
    let rows: Vec<f64> =
        values.chunks_exact(width).flat_map(|row| row.windows(side).map(|w| w.iter().sum::<f64>())).collect();
    let columns = width - side + 1;
    let count = rows.len() / columns - side + 1;
    let mean = |i: usize| (0..side).map(|k| rows[i + k * columns]).sum::<f64>() / (side * side) as f64;
    (0..count * columns).map(mean).collect()
}
