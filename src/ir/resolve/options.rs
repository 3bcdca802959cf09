//! `render:`, how the picture is made.

use super::Resolver;
use super::reader::Fields;
use crate::diagnostic::Diagnostic;
use crate::ir::{MAX_BOUNCES, Render, ToneMap, Transfer};
use crate::scene::{Kind, Record, Value};

impl Resolver<'_> {
    pub fn render(&mut self, written: Option<&Value>) -> Render {
        let mut render = Render {
            max_bounces: 5,
            shadows: true,
            shadow_samples: 16,
            texture_filter: true,
            transfer: Transfer::Srgb,
            gain: 1.0,
            tone_map: ToneMap::Clamp,
        };
        let Some(written) = written else { return render };
        let mut fields = Fields::of(self, written, "`render`");
        render.max_bounces = self.count(&mut fields, "max_bounces", render.max_bounces, 0, MAX_BOUNCES);
        render.shadows = fields.flag(self, "shadows", render.shadows);
        render.shadow_samples = self.count(&mut fields, "shadow_samples", render.shadow_samples, 1, 1024);
        render.texture_filter = fields.flag(self, "texture_filter", render.texture_filter);
        if let Some(transfer) = fields.get("transfer") {
            render.transfer = self.transfer(transfer);
        }
        render.gain = fields.number(self, "exposure", Some(0.0), -40.0, 40.0).exp2();
        if let Some(tone_map) = fields.get("tone_map") {
            render.tone_map = self.tone_map(tone_map);
        }
        fields.finish(self);
        render
    }

    fn count(&mut self, fields: &mut Fields<'_>, name: &str, default: u32, low: u32, high: u32) -> u32 {
        let x = fields.number(self, name, Some(default as f32), low as f32, high as f32);
        if x.fract() != 0.0
            && let Some(value) = fields.get(name)
        {
            self.mismatch(value, "a whole number");
        }
        x as u32
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
