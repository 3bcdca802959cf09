//! Colors as people write them.

use glam::Vec3;

/// `"#8c3b2a"`, `"#fff"` or a CSS name, given in sRGB: linear RGB. None for any other text.
pub fn parse_color(text: &str) -> Option<Vec3> {
    let is_plain = |c: char| c.is_ascii_alphabetic();
    if !text.starts_with('#') && !text.chars().all(is_plain) {
        return None;
    }
    let color = csscolorparser::parse(text).ok()?;
    let [r, g, b, _] = color.to_array().map(|c| linear(f64::from(c)));
    Some(Vec3::new(r, g, b))
}

/// The inverse of the sRGB transfer curve (IEC 61966-2-1).
fn linear(srgb: f64) -> f32 {
    let light = if srgb <= 0.04045 { srgb / 12.92 } else { ((srgb + 0.055) / 1.055).powf(2.4) };
    light as f32
}
