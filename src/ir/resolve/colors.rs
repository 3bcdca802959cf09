//! Colors that are the same everywhere, and words about those that mean something else than they seem to.

use glam::Vec3;

use super::{Resolver, Usage};
use crate::diagnostic::Diagnostic;
use crate::library::parse_css;
use crate::scene::{Kind, Value};

/// How a color may be written, for messages.
pub const COLOR_FORMS: &str = "colors are \"#rrggbb\", \"#rgb\", other CSS such as \"tomato\" or \
    \"rgb(255 136 0)\", or linear `(1.0, 0.25, 0.0)`";

/// A surface of such a color is a mistake: white paper gives back 0.8 of the light, and nothing more than 1.
const TOO_BRIGHT: f32 = 2.0;

impl Resolver<'_> {
    /// A color that is the same everywhere.
    pub fn constant_color(&mut self, value: &Value) -> Vec3 {
        self.plain_color(value).unwrap_or_else(|| {
            let expected = format!("expected a color, found {}", value.describe());
            let is_text = matches!(value.kind, Kind::Text(_));
            let problem = self.error(&value.span, expected);
            problem.help.extend(is_text.then(|| COLOR_FORMS.to_owned()));
            Vec3::ZERO
        })
    }

    /// A color given as a number, a vector or a string; None for anything else.
    pub fn plain_color(&mut self, value: &Value) -> Option<Vec3> {
        let color = match &value.kind {
            Kind::Number(x) => match self.hexadecimal(value) {
                Some(digits) => {
                    let problem = self
                        .error(&value.span, format!("a single number is a grey value, and {x} is not one"));
                    problem.help.push(format!("write the color as a string: \"#{digits}\""));
                    Vec3::ZERO
                }
                None => Vec3::splat(self.number(value, Some((0.0, 1e6))).unwrap_or(0.0)),
            },
            Kind::Tuple(_) => {
                let rgb = self.numbers(value, 3, Some((0.0, 1e6)));
                rgb.map_or(Vec3::ZERO, |n| Vec3::from_slice(&n))
            }
            Kind::Text(text) => self.named_color(text, value)?,
            _ => return None,
        };
        self.check_brightness(color, value);
        Some(color)
    }

    /// The color that CSS calls `text`; a warning where it has less than all of it.
    pub fn named_color(&mut self, text: &str, value: &Value) -> Option<Vec3> {
        let named = parse_css(text)?;
        if named.alpha < 1.0 {
            let message = match named.alpha {
                0.0 => {
                    format!("\"{text}\" is transparent, but colors have no alpha here: it is drawn opaque")
                }
                _ => format!(
                    "\"{text}\" has an alpha, but colors have no alpha here: the color is drawn opaque"
                ),
            };
            let advice = "for a transparent material, use `transmission: 0.5`";
            let place = self.place(&value.span);
            self.push(Diagnostic::warning(message).at(place, "").help(advice));
        }
        Some(named.color)
    }

    /// The six digits of a number that is written as other programs write colors: `0xff8800`.
    fn hexadecimal(&self, value: &Value) -> Option<String> {
        let digits = self.text.get(value.span.clone())?.strip_prefix("0x")?;
        let is_color = digits.len() == 6 && digits.chars().all(|c| c.is_ascii_hexdigit());
        is_color.then(|| digits.to_owned())
    }

    /// Warns of a surface that would give back far more light than it gets.
    fn check_brightness(&mut self, color: Vec3, value: &Value) {
        let most = color.max_element();
        if most < TOO_BRIGHT {
            return;
        }
        self.depends_on_usage = true;
        if self.usage != Usage::Surface {
            return;
        }
        let message = format!("a surface of this color reflects {most} times the light that reaches it");
        let is_byte = |c: f32| c.fract() == 0.0 && c <= 255.0;
        let advice = if color.to_array().iter().all(|c| is_byte(*c)) {
            let [r, g, b] = color.to_array().map(|c| c as u8);
            format!("write bytes as \"#{r:02x}{g:02x}{b:02x}\"; linear RGB goes from 0 to 1")
        } else {
            "linear RGB goes from 0 to 1; `emission` makes a surface emit light".to_owned()
        };
        let place = self.place(&value.span);
        self.push(Diagnostic::warning(message).at(place, "").help(advice));
    }
}
