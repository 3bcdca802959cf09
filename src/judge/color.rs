//! The color spaces in which people's eyes are modelled: from sRGB bytes to YCxCz, and to L*a*b*.
//!
//! Matrices and white are those of the FLIP paper's code for D65 (Andersson et al. 2020); L*a*b* is CIE 15.

/// From linear RGB with sRGB's primaries to XYZ.
const TO_XYZ: [[f64; 3]; 3] = [
    [10_135_552.0 / 24_577_794.0, 8_788_810.0 / 24_577_794.0, 4_435_075.0 / 24_577_794.0],
    [2_613_072.0 / 12_288_897.0, 8_788_810.0 / 12_288_897.0, 887_015.0 / 12_288_897.0],
    [1_425_312.0 / 73_733_382.0, 8_788_810.0 / 73_733_382.0, 70_074_185.0 / 73_733_382.0],
];

/// The inverse of [`TO_XYZ`].
const FROM_XYZ: [[f64; 3]; 3] = [
    [3.241_003_275, -1.537_398_934, -0.498_615_861],
    [-0.969_224_334, 1.875_930_071, 0.041_554_224],
    [0.055_639_423, -0.204_011_202, 1.057_148_933],
];

/// XYZ of linear RGB (1, 1, 1).
const WHITE: [f64; 3] = [0.950_428_545, 1.0, 1.088_900_371];

/// The part of a cube root that CIE replaces by a line ends here.
const KNEE: f64 = 6.0 / 29.0;

/// Linear light of an sRGB byte (IEC 61966-2-1), 0 to 1.
pub fn linear(byte: u8) -> f64 {
    let x = f64::from(byte) / 255.0;
    if x > 0.04045 { ((x + 0.055) / 1.055).powf(2.4) } else { x / 12.92 }
}

/// Luminance, -16 to 100, red-green and blue-yellow, all linear in light: what the eye's filters work on.
pub fn ycxcz(linear_rgb: [f64; 3]) -> [f64; 3] {
    let [x, y, z] = relative(linear_rgb);
    [116.0 * y - 16.0, 500.0 * (x - y), 200.0 * (y - z)]
}

/// Linear RGB of [`ycxcz`], which may lie outside of 0 to 1.
pub fn from_ycxcz([y, cx, cz]: [f64; 3]) -> [f64; 3] {
    let y = (y + 16.0) / 116.0;
    let relative = [y + cx / 500.0, y, y - cz / 200.0];
    times(FROM_XYZ, [0, 1, 2].map(|i| relative[i] * WHITE[i]))
}

/// CIE L*a*b*. L* is 0 to 100.
pub fn lab(linear_rgb: [f64; 3]) -> [f64; 3] {
    let [x, y, z] = relative(linear_rgb).map(|t| {
        let is_root = t > KNEE * KNEE * KNEE;
        if is_root { t.cbrt() } else { t / (3.0 * KNEE * KNEE) + 4.0 / 29.0 }
    });
    [116.0 * y - 16.0, 500.0 * (x - y), 200.0 * (y - z)]
}

/// XYZ as a share of white's.
fn relative(linear_rgb: [f64; 3]) -> [f64; 3] {
    let xyz = times(TO_XYZ, linear_rgb);
    [0, 1, 2].map(|i| xyz[i] / WHITE[i])
}

fn times(matrix: [[f64; 3]; 3], v: [f64; 3]) -> [f64; 3] {
    matrix.map(|row| row[0] * v[0] + row[1] * v[1] + row[2] * v[2])
}
