//! Colors in the author's style: `"#8c3b2a"`, `0.5` or `(0.5, 0.1, 0.0)`.

use glam::Vec3;

use super::{number, text};
use crate::library::parse_color;

/// `color`, linear RGB, as a hexadecimal one where that is exact, else as a grey, else as a vector.
pub fn write(color: Vec3) -> String {
    if let Some(bytes) = exact_bytes(color) {
        return text::quote(&hexadecimal(bytes, ""));
    }
    match color.to_array() {
        [grey, g, b] if grey == g && grey == b => number::write(grey, false),
        channels => format!("({})", channels.map(|x| number::write(x, false)).join(", ")),
    }
}

/// `color` in place of `old`, a string that says `was`: hexadecimal in its style, or a vector.
pub fn rewrite(old: &str, was: &str, color: Vec3) -> String {
    match exact_bytes(color) {
        Some(bytes) => text::requote(old, &hexadecimal(bytes, was)),
        None => format!("({})", color.to_array().map(|x| number::write(x, false)).join(", ")),
    }
}

/// The sRGB bytes that mean exactly `color`.
fn exact_bytes(color: Vec3) -> Option<[u8; 3]> {
    let byte = |light: f32| {
        let light = f64::from(light);
        // The sRGB transfer curve (IEC 61966-2-1).
        let srgb = if light <= 0.0031308 { light * 12.92 } else { 1.055 * light.powf(1.0 / 2.4) - 0.055 };
        (srgb * 255.0).round().clamp(0.0, 255.0) as u8
    };
    let bytes = color.to_array().map(byte);
    (parse_color(&hexadecimal(bytes, "")) == Some(color)).then_some(bytes)
}

/// `#rrggbb` with the case of `was`, its alpha, and as few digits as it has.
fn hexadecimal(bytes: [u8; 3], was: &str) -> String {
    let was = was.strip_prefix('#').filter(|digits| digits.is_ascii()).unwrap_or("");
    let alpha = match was.len() {
        4 => was[3..].repeat(2),
        8 => was[6..].to_owned(),
        _ => String::new(),
    };
    let mut digits: String = bytes.iter().map(|b| format!("{b:02x}")).collect();
    digits += &alpha;
    let pairs = digits.as_bytes().chunks(2);
    if matches!(was.len(), 3 | 4) && pairs.clone().all(|pair| pair[0] == pair[1]) {
        digits = pairs.map(|pair| char::from(pair[0])).collect();
    }
    let is_upper = was.contains(|c: char| c.is_ascii_uppercase());
    format!("#{}", if is_upper { digits.to_ascii_uppercase() } else { digits })
}
