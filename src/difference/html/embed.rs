//! Pictures in a page: what differs, and data URLs.

use image::{Rgb, RgbImage};

use crate::difference::png;

/// How much stronger a difference is shown than it is.
pub const AMPLIFIED: u8 = 8;

/// What differs, [`AMPLIFIED`], black where nothing does.
pub fn amplified(expected: &RgbImage, actual: &RgbImage) -> RgbImage {
    RgbImage::from_fn(actual.width(), actual.height(), |x, y| {
        let (a, b) = (expected.get_pixel(x, y).0, actual.get_pixel(x, y).0);
        Rgb([0, 1, 2].map(|i| a[i].abs_diff(b[i]).saturating_mul(AMPLIFIED)))
    })
}

/// The picture as a PNG file within an URL.
pub fn data_url(picture: &RgbImage) -> String {
    format!("data:image/png;base64,{}", base64(&png(picture)))
}

/// RFC 4648, with padding.
fn base64(bytes: &[u8]) -> String {
    const LETTERS: &[u8; 64] = b"ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    let mut text = String::with_capacity(bytes.len().div_ceil(3) * 4);
    for three in bytes.chunks(3) {
        let bits =
            three.iter().fold(0_u32, |bits, byte| bits << 8 | u32::from(*byte)) << (8 * (3 - three.len()));
        for i in 0..4 {
            let letter = LETTERS[(bits >> (18 - 6 * i)) as usize & 63];
            text.push(if i <= three.len() { char::from(letter) } else { '=' });
        }
    }
    text
}
