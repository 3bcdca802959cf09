//! What is wrong with lists of values, if anything: not finite, out of range, not alike, not even.

use glam::Vec3;

/// What breaks a law first, and in which point.
pub type Found = Option<(usize, String)>;

/// Rounding may carry a value this far out of its range.
const RANGE_TOLERANCE: f32 = 1e-4;

pub fn finite(values: &[Vec3]) -> Found {
    first(values.len(), 0.0, |i| !values[i].is_finite(), |i| values[i].to_string())
}

pub fn in_range(values: &[Vec3], (low, high): (f32, f32)) -> Found {
    let (low, high) = (low - RANGE_TOLERANCE, high + RANGE_TOLERANCE);
    // What is not finite is another law's.
    let is_out = |v: Vec3| v.is_finite() && (v.min_element() < low || v.max_element() > high);
    first(values.len(), 0.0, |i| is_out(values[i]), |i| values[i].to_string())
}

pub fn same_bits(one: &[Vec3], two: &[Vec3]) -> Found {
    let bits = |v: Vec3| v.to_array().map(f32::to_bits);
    let both = |i: usize| format!("{} and {}", one[i], two[i]);
    first(one.len(), 0.0, |i| bits(one[i]) != bits(two[i]), both)
}

/// Equal to `tolerance` where they `count`, but for a share `most` of those.
pub fn alike(one: &[Vec3], two: &[Vec3], tolerance: f32, most: f64, counts: impl Fn(usize) -> bool) -> Found {
    let differs = |i: usize| (one[i] - two[i]).abs().max_element() > tolerance;
    let counted = (0..one.len()).filter(|i| counts(*i)).count() as f64;
    let most = most * counted / one.len() as f64;
    first(one.len(), most, |i| counts(i) && differs(i), |i| format!("{} and {}", one[i], two[i]))
}

/// With a standard deviation of at most `most`.
pub fn even(values: &[Vec3], most: f32) -> Found {
    let count = values.len() as f32;
    let mean = values.iter().sum::<Vec3>() / count;
    let square = values.iter().map(|v| (*v - mean) * (*v - mean)).sum::<Vec3>() / count;
    let deviation = square.max_element().sqrt();
    let off = |i: usize| (values[i] - mean).length();
    let farthest = (0..values.len()).max_by(|a, b| off(*a).total_cmp(&off(*b)))?;
    let what = || format!("{}, the mean {mean}, the standard deviation {deviation}", values[farthest]);
    (deviation > most).then(|| (farthest, what()))
}

/// The first of `count` points that is wrong, if more than a share `most` is, with its description.
pub fn first(
    count: usize,
    most: f64,
    is_wrong: impl Fn(usize) -> bool,
    tell: impl Fn(usize) -> String,
) -> Found {
    let wrong: Vec<usize> = (0..count).filter(|i| is_wrong(*i)).collect();
    let i = *wrong.first()?;
    let too_many = wrong.len() as f64 > most * count as f64;
    too_many.then(|| (i, format!("{}, and {} of {count} points are wrong", tell(i), wrong.len())))
}
