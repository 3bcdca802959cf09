//! Colors as people write them.

use glam::Vec3;

/// A color that a text names.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct NamedColor {
    /// Linear RGB.
    pub color: Vec3,
    /// How much of it there is, 0 to 1.
    pub alpha: f32,
}

/// What CSS takes as a color: `"#8c3b2a"`, `"#fff"`, `"tomato"`, `"rgb(255 136 0)"`, `"hsl(32 100% 50%)"`,
/// given in sRGB. None for any other text.
pub fn parse_css(text: &str) -> Option<NamedColor> {
    let is_plain = |c: char| c.is_ascii_alphabetic();
    let is_function = text.ends_with(')') && text.starts_with(is_plain);
    if !text.starts_with('#') && !is_function && !text.chars().all(is_plain) {
        return None;
    }
    let [r, g, b, alpha] = csscolorparser::parse(text).ok()?.to_array();
    // `lab()` and `oklch()` name colors, too, that no screen shows.
    let [r, g, b] = [r, g, b].map(|c| linear(f64::from(c).clamp(0.0, 1.0)));
    let color = Vec3::new(r, g, b);
    (color.is_finite() && alpha.is_finite()).then_some(NamedColor { color, alpha })
}

/// The same in linear RGB, whatever its alpha.
pub fn parse_color(text: &str) -> Option<Vec3> {
    parse_css(text).map(|named| named.color)
}

/// The inverse of the sRGB transfer curve (IEC 61966-2-1).
fn linear(srgb: f64) -> f32 {
    let light = if srgb <= 0.04045 { srgb / 12.92 } else { ((srgb + 0.055) / 1.055).powf(2.4) };
    light as f32
}
