//! LDR-FLIP: the difference that a person sees who flips between two pictures.
//!
//! Andersson, Nilsson, Akenine-Möller, Oskarsson, Åström, Fairchild: FLIP, A Difference Evaluator for
//! Alternating Images, 2020, with the constants of the authors' code. tests/text/judge.rs holds means and
//! single pixels of synthetic pictures to what that code gives (the package flip-evaluator 1.7).

use std::f64::consts::{FRAC_1_SQRT_2, PI};

use image::RgbImage;

use super::color::{from_ycxcz, lab, linear, ycxcz};
use super::convolve::Plane;

/// Of an observer 0.7 m away from a screen that is 0.7 m wide and has 3840 pixels across.
pub const PIXELS_PER_DEGREE: f64 = 3840.0 * PI / 180.0;

/// Exponents of the color and the feature differences.
const COLOR_EXPONENT: f64 = 0.7;
const FEATURE_EXPONENT: f64 = 0.5;
/// Color differences up to the first, as a share of the largest, take the second of the scale.
const KNEE: f64 = 0.4;
const AT_KNEE: f64 = 0.95;
/// Peak to trough of the eye's edge detector, degrees.
const FEATURE_WIDTH: f64 = 0.082;

/// Gaussians in frequency of the eye's contrast sensitivity: amplitude, and b in exp(-π²x²/b), degrees².
const ACHROMATIC: &[[f64; 2]] = &[[1.0, 0.0047]];
const RED_GREEN: &[[f64; 2]] = &[[1.0, 0.0053]];
const BLUE_YELLOW: &[[f64; 2]] = &[[34.1, 0.04], [13.5, 0.025]];
/// The largest b, which sets how far all filters reach.
const WIDEST: f64 = 0.04;

/// The mean FLIP difference of two pictures of one size, 0 to 1, for an observer who has `pixels_per_degree`.
pub fn flip(expected: &RgbImage, actual: &RgbImage, pixels_per_degree: f64) -> f64 {
    if expected == actual {
        return 0.0;
    }
    let map = flip_map(expected, actual, pixels_per_degree);
    map.iter().sum::<f64>() / map.len() as f64
}

/// The FLIP error of each pixel, by rows from the top.
pub fn flip_map(expected: &RgbImage, actual: &RgbImage, pixels_per_degree: f64) -> Vec<f64> {
    let [one, other] = [expected, actual].map(|picture| Seen::new(picture, pixels_per_degree));
    let largest = hyab(hunted([0.0, 1.0, 0.0]), hunted([0.0, 0.0, 1.0])).powf(COLOR_EXPONENT);
    let pixel = |i: usize| {
        let color = redistributed(hyab(one.colors[i], other.colors[i]).powf(COLOR_EXPONENT), largest);
        let edges = (one.edges[i] - other.edges[i]).abs();
        let points = (one.points[i] - other.points[i]).abs();
        let feature = (FRAC_1_SQRT_2 * edges.max(points)).powf(FEATURE_EXPONENT);
        color.powf(1.0 - feature)
    };
    (0..one.colors.len()).map(pixel).collect()
}

/// A picture as the eye filters it: blurred colors in Hunt-adjusted L*a*b*, and how strong edges and
/// points are.
struct Seen {
    colors: Vec<[f64; 3]>,
    edges: Vec<f64>,
    points: Vec<f64>,
}

impl Seen {
    fn new(picture: &RgbImage, pixels_per_degree: f64) -> Self {
        let width = picture.width() as usize;
        let lights = (0..=255).map(linear).collect::<Vec<f64>>();
        let opponent: Vec<[f64; 3]> =
            picture.pixels().map(|p| ycxcz(p.0.map(|byte| lights[usize::from(byte)]))).collect();
        let plane = |i: usize| Plane { width, values: opponent.iter().map(|c| c[i]).collect() };
        let [y, cx, cz] = [plane(0), plane(1), plane(2)];
        let blurred = [(&y, ACHROMATIC), (&cx, RED_GREEN), (&cz, BLUE_YELLOW)]
            .map(|(plane, gaussians)| sensed(plane, gaussians, pixels_per_degree));
        let color = |i: usize| {
            let [y, cx, cz] = &blurred;
            hunted(from_ycxcz([y[i], cx[i], cz[i]]).map(|x| x.clamp(0.0, 1.0)))
        };
        let colors = (0..opponent.len()).map(color).collect();
        let grey = Plane { width, values: y.values.iter().map(|y| (y + 16.0) / 116.0).collect() };
        let [edges, points] = features(&grey, pixels_per_degree);
        Self { colors, edges, points }
    }
}

/// `plane` as the eye's contrast sensitivity blurs it.
fn sensed(plane: &Plane, gaussians: &[[f64; 2]], pixels_per_degree: f64) -> Vec<f64> {
    let reach = (3.0 * (WIDEST / (2.0 * PI * PI)).sqrt() * pixels_per_degree).ceil() as i32;
    let kernels = gaussians.iter().map(|[amplitude, b]| {
        let kernel: Vec<f64> = (-reach..=reach)
            .map(|x| (-PI * PI * (f64::from(x) / pixels_per_degree).powi(2) / b).exp())
            .collect();
        (amplitude * (PI / b).sqrt(), kernel)
    });
    let kernels: Vec<(f64, Vec<f64>)> = kernels.collect();
    let total: f64 = kernels.iter().map(|(weight, kernel)| weight * kernel.iter().sum::<f64>().powi(2)).sum();
    let mut sum = vec![0.0; plane.values.len()];
    for (weight, kernel) in &kernels {
        let part = plane.across(kernel).down(kernel);
        sum.iter_mut().zip(part.values).for_each(|(sum, x)| *sum += x * weight / total);
    }
    sum
}

/// How strong edges are, and points: lengths of the first and second derivatives of a blur.
fn features(grey: &Plane, pixels_per_degree: f64) -> [Vec<f64>; 2] {
    let deviation = 0.5 * FEATURE_WIDTH * pixels_per_degree;
    let reach = (3.0 * deviation).ceil() as i32;
    let gauss = |x: f64| (-x * x / (2.0 * deviation * deviation)).exp();
    let places = || (-reach..=reach).map(f64::from);
    let blur: Vec<f64> = places().map(gauss).collect();
    let edge = balanced(places().map(|x| -x * gauss(x)).collect(), &blur);
    let point =
        balanced(places().map(|x| (x * x / (deviation * deviation) - 1.0) * gauss(x)).collect(), &blur);
    let blurred = grey.across(&blur);
    [edge, point].map(|kernel| {
        let (across, down) = (grey.across(&kernel).down(&blur), blurred.down(&kernel));
        across.values.iter().zip(down.values).map(|(x, y)| x.hypot(y)).collect()
    })
}

/// `kernel` scaled so that, spread by `blur`, its positive weights have the sum 1 and its negative ones -1.
fn balanced(kernel: Vec<f64>, blur: &[f64]) -> Vec<f64> {
    let spread: f64 = blur.iter().sum();
    let sum = |sign: f64| kernel.iter().filter(|w| **w * sign > 0.0).sum::<f64>().abs() * spread;
    let (positive, negative) = (sum(1.0), sum(-1.0));
    kernel.into_iter().map(|w| if w < 0.0 { w / negative } else { w / positive }).collect()
}

/// L*a*b* whose colors are weaker where it is dark.
fn hunted(linear_rgb: [f64; 3]) -> [f64; 3] {
    let [l, a, b] = lab(linear_rgb);
    [l, 0.01 * l * a, 0.01 * l * b]
}

/// The distance in lightness and that in color, added (Abasi et al. 2020).
fn hyab(one: [f64; 3], other: [f64; 3]) -> f64 {
    (one[0] - other[0]).abs() + (one[1] - other[1]).hypot(one[2] - other[2])
}

/// From 0 to `largest` to 0 to 1, most of it for what is small.
fn redistributed(difference: f64, largest: f64) -> f64 {
    let knee = KNEE * largest;
    if difference < knee {
        AT_KNEE * difference / knee
    } else {
        AT_KNEE + (difference - knee) / (largest - knee) * (1.0 - AT_KNEE)
    }
}
