//! `Image`: what a picture file is taken for, and where it lies.

use glam::Vec3;

use super::reader::Fields;
use super::{Resolver, Usage};
use crate::assets::{Channel, Image, Reading};
use crate::diagnostic::Diagnostic;
use crate::ir::fields::{EVERY_TEXTURE, Group};
use crate::ir::{Fit, ImageTexture, Value};
use crate::library::{Const, Type};
use crate::scene::{self, Kind};

impl Resolver<'_> {
    /// An image, which gives a number where one is wanted.
    pub fn picture(&mut self, form: &Group, value: &scene::Value, want: Type) -> Option<ImageTexture> {
        let mut fields = Fields::of(self, value, "`Image`", &[EVERY_TEXTURE, form.fields]);
        let at = self.at(&mut fields);
        let file = fields.require(self, "file");
        let width = fields.given_number(self, "width");
        let repeat = fields.flag(self, "repeat");
        let fit = match fields.word(self, "fit") {
            "Units" => Fit::Plane,
            "Whole" => Fit::Whole,
            _ if width.is_some() && fields.has("at") => Fit::Mapping,
            _ => Fit::Surface,
        };
        let reading = self.reading(&mut fields, want);
        let ty = if reading.channel.is_some() { Type::F32 } else { Type::Vec3 };
        let under = match ty {
            Type::F32 => fields.get("under").map(|under| self.pattern(under, (-1e6, 1e6))),
            _ => fields.color(self, "under"),
        };
        fields.finish(self);
        let file = file?;
        let Kind::Text(path) = &file.kind else {
            self.mismatch(file, "a file such as \"photo.png\"");
            return None;
        };
        let image = self.image(path, file, reading)?;
        let under = match under {
            None if self.images[image].0.has_alpha && ty == Type::Vec3 => self.ground(file, image),
            given => given,
        };
        // Where it is whole and goes on for ever, nothing is seen under it.
        let under = under.filter(|_| self.images[image].0.has_alpha || !repeat);
        Some(ImageTexture { at: at?, image, ty, width, fit, under, repeat })
    }

    fn reading(&mut self, fields: &mut Fields<'_>, want: Type) -> Reading {
        let encoding = fields.word(self, "encoding");
        let channel = match fields.word(self, "channel") {
            "Luminance" => Some(Channel::Luminance),
            "Red" => Some(Channel::Red),
            "Green" => Some(Channel::Green),
            "Blue" => Some(Channel::Blue),
            "Alpha" => Some(Channel::Alpha),
            _ => None,
        };
        self.depends_on_usage |= encoding == "Auto" && channel.is_none();
        let has_curve = match encoding {
            "Auto" => channel.is_none() && self.usage != Usage::Number,
            encoding => encoding == "Srgb",
        };
        let wanted = (want == Type::F32).then_some(Channel::Luminance);
        Reading { has_curve, channel: channel.or(wanted) }
    }

    /// What lies under a color that is clear in places, where the author says nothing: white on a surface,
    /// and nothing in light.
    fn ground(&mut self, file: &scene::Value, image: usize) -> Option<Value> {
        self.depends_on_usage = true;
        if self.usage != Usage::Surface {
            return None;
        }
        let Image { file: name, .. } = &self.images[image].0;
        let message = format!("`{name}` is transparent in places: white is drawn there");
        let advice =
            "choose the color there with `under: \"white\"`, or read the alpha with `channel: Alpha`";
        let place = self.place(&file.span);
        self.push(Diagnostic::warning(message).at(place, "").help(advice));
        Some(Value::Const(Const::Vec3(Vec3::ONE)))
    }
}
