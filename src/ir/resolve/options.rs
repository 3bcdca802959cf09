//! `render:`, how the picture is made.

use super::Resolver;
use super::reader::Fields;
use crate::diagnostic::Diagnostic;
use crate::ir::fields::RENDER;
use crate::ir::{Render, ToneMap, Transfer};
use crate::scene::{Kind, Record, Value};

impl Resolver<'_> {
    pub fn render(&mut self, written: Option<&Value>) -> Render {
        let left_out = Value::left_out();
        let written = written.unwrap_or(&left_out);
        let mut fields = Fields::of(self, written, "`render`", &[RENDER]);
        let max_bounces = fields.number(self, "max_bounces") as u32;
        let shadows = fields.flag(self, "shadows");
        let shadow_samples = fields.number(self, "shadow_samples") as u32;
        let texture_filter = fields.flag(self, "texture_filter");
        let transfer = fields.get("transfer").map_or(Transfer::Srgb, |written| self.transfer(written));
        let gain = fields.number(self, "exposure").exp2();
        let tone_map = fields.get("tone_map").map_or(ToneMap::Clamp, |written| self.tone_map(written));
        fields.finish(self);
        Render { max_bounces, shadows, shadow_samples, texture_filter, transfer, gain, tone_map }
    }

    fn transfer(&mut self, written: &Value) -> Transfer {
        if let Kind::Record(Record { name: Some(name), items, .. }) = &written.kind {
            match (name.text.as_str(), items.as_slice()) {
                ("Srgb", []) => return Transfer::Srgb,
                ("Linear", []) => return Transfer::Linear,
                ("Gamma", [gamma]) => {
                    return Transfer::Gamma(self.number(gamma, Some((0.1, 10.0))).unwrap_or(1.0));
                }
                _ => {}
            }
        }
        self.mismatch(written, "`Srgb`, `Gamma(2.0)` or `Linear`");
        Transfer::Srgb
    }

    fn tone_map(&mut self, written: &Value) -> ToneMap {
        let known = [("Reinhard", ToneMap::Reinhard), ("Aces", ToneMap::Aces), ("Agx", ToneMap::Agx)];
        match &written.kind {
            Kind::None => return ToneMap::Clamp,
            Kind::Record(Record { name: Some(name), .. }) => {
                if let Some((_, tone_map)) = known.iter().find(|(n, _)| *n == name.text) {
                    return *tone_map;
                }
                let place = self.place(&name.span);
                let problem =
                    Diagnostic::error(format!("there is no tone map `{}`", name.text)).at(place, "");
                self.push(problem.suggest(&name.text, ["None", "Reinhard", "Aces", "Agx"]));
            }
            _ => self.mismatch(written, "`None`, `Reinhard`, `Aces` or `Agx`"),
        }
        ToneMap::Clamp
    }
}
