//! The curve from the values of a file to light.

use super::chunks::chunks;

/// How values, 0 to 1, stand for light.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Curve {
    /// IEC 61966-2-1.
    Srgb,
    /// A power of the value.
    Power(f32),
    Linear,
}

/// What a PNG's `gAMA` of sRGB is, in hundred thousandths; files that are nearly that mean sRGB.
const GAMMA_OF_SRGB: u32 = 45455;

/// What a picture says of its curve. Color profiles are left out, and so are primaries.
pub fn curve_of(bytes: &[u8]) -> Curve {
    let mut curve = Curve::Srgb;
    for (name, content) in chunks(bytes) {
        match (name, content) {
            // They outrank it, wherever they stand before the pixels.
            (b"sRGB" | b"iCCP" | b"cICP", _) => return Curve::Srgb,
            (b"IDAT", _) => break,
            (b"gAMA", &[a, b, c, d]) => curve = of_gamma(u32::from_be_bytes([a, b, c, d])),
            _ => {}
        }
    }
    curve
}

fn of_gamma(gamma: u32) -> Curve {
    match gamma {
        0 => Curve::Srgb,
        100_000 => Curve::Linear,
        _ if gamma.abs_diff(GAMMA_OF_SRGB) < GAMMA_OF_SRGB / 20 => Curve::Srgb,
        _ => Curve::Power(1e5 / gamma as f32),
    }
}

impl Curve {
    pub fn light(self, x: f32) -> f32 {
        match self {
            Curve::Linear => x,
            Curve::Power(power) => x.powf(power),
            Curve::Srgb if x <= 0.04045 => x / 12.92,
            Curve::Srgb => ((x + 0.055) / 1.055).powf(2.4),
        }
    }
}
