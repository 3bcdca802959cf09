//! What a person would say of the pixels that differ: brighter, redder, or that something lies elsewhere.

use image::RgbImage;

use super::color::{lab, linear};

/// How the pixels that differ have changed.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum PictureShift {
    /// Most of them in one way: a word such as "darker", and by how much on L*a*b*'s scale, where black and
    /// white are 100 apart.
    Shift { word: &'static str, by: f64 },
    /// Some in one way and some in the other: an edge or a pattern lies elsewhere.
    Elsewhere { by: f64 },
}

/// Changes are no shift if their mean is less than this share of their mean size.
const ONE_WAY: f64 = 0.5;

/// The change of the pixels in which a channel differs by more than `tolerance`; to all that differ where
/// no pixel does by so much. None where the pictures are the same.
pub fn change(expected: &RgbImage, actual: &RgbImage, tolerance: u8) -> Option<PictureShift> {
    let pairs = || expected.pixels().zip(actual.pixels());
    let differs = |tolerance: u8| {
        move |(a, b): &(&image::Rgb<u8>, &image::Rgb<u8>)| {
            a.0.iter().zip(b.0).any(|(x, y)| x.abs_diff(y) > tolerance)
        }
    };
    let tolerance = if pairs().any(|pair| differs(tolerance)(&pair)) { tolerance } else { 0 };
    let (mut mean, mut size, mut count) = ([0.0; 3], 0.0, 0.0);
    for (a, b) in pairs().filter(differs(tolerance)) {
        let [a, b] = [a, b].map(|pixel| lab(pixel.0.map(linear)));
        let step = [0, 1, 2].map(|i| b[i] - a[i]);
        [0, 1, 2].iter().for_each(|i| mean[*i] += step[*i]);
        size += length(step);
        count += 1.0;
    }
    if count == 0.0 {
        return None;
    }
    let (mean, size) = (mean.map(|x| x / count), size / count);
    if length(mean) < ONE_WAY * size {
        return Some(PictureShift::Elsewhere { by: size });
    }
    let words = [["darker", "brighter"], ["greener", "redder"], ["bluer", "yellower"]];
    let most = (0..3).max_by(|i, j| mean[*i].abs().total_cmp(&mean[*j].abs()))?;
    Some(PictureShift::Shift { word: words[most][usize::from(mean[most] > 0.0)], by: mean[most].abs() })
}

fn length(v: [f64; 3]) -> f64 {
    v.iter().map(|x| x * x).sum::<f64>().sqrt()
}
