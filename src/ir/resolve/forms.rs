//! Textures that are the generator's own, since no function signature can say what they take.

use super::Resolver;
use super::reader::Fields;
use crate::ir::{Call, Interpolation, Picture, Ramp, Triplanar, Value};
use crate::scene::{self, Kind, Record};

/// Their names.
pub const FORMS: [&str; 3] = [RAMP, TRIPLANAR, IMAGE];
pub const RAMP: &str = "Ramp";
pub const TRIPLANAR: &str = "Triplanar";
pub const IMAGE: &str = "Image";

impl Resolver<'_> {
    pub fn ramp(&mut self, value: &scene::Value) -> Option<Ramp> {
        let mut fields = Fields::of(self, value, "`Ramp`");
        let at = self.at(&mut fields);
        let by = fields.require(self, "by").map(|by| self.pattern(by, (-1e6, 1e6)));
        let stops = fields.require(self, "stops");
        let interpolation = fields.get("interpolation").map(|written| self.interpolation(written));
        fields.finish(self);
        let stops = stops?;
        let Kind::List(items) = &stops.kind else {
            self.mismatch(stops, "a list of stops `[(0.0, \"#000\"), (1.0, \"#fff\")]`");
            return None;
        };
        let mut resolved: Vec<(f32, Value)> = vec![];
        for item in items {
            match &item.kind {
                Kind::Tuple(pair) if pair.len() == 2 => {
                    let at = self.number(&pair[0], None)?;
                    if resolved.last().is_some_and(|(before, _)| *before > at) {
                        self.error(&pair[0].span, "stops go from low to high");
                    }
                    let color = self.color(&pair[1]);
                    resolved.push((at, color));
                }
                _ => self.mismatch(item, "a stop `(0.5, \"tomato\")`"),
            }
        }
        if resolved.len() < 2 {
            self.error(&stops.span, "a ramp needs two stops or more");
            return None;
        }
        let interpolation = interpolation.unwrap_or(Interpolation::Linear);
        Some(Ramp { at: at?, by: by?, stops: resolved, interpolation })
    }

    /// The mapping that `at` names, if there is one; None where it is wrong.
    pub fn at(&mut self, fields: &mut Fields<'_>) -> Option<Option<Box<Call>>> {
        match fields.get("at") {
            Some(mapping) => self.mapping(mapping).map(|call| Some(Box::new(call))),
            None => Some(None),
        }
    }

    fn interpolation(&mut self, written: &scene::Value) -> Interpolation {
        let known = [
            ("Linear", Interpolation::Linear),
            ("Smooth", Interpolation::Smooth),
            ("Constant", Interpolation::Constant),
        ];
        if let Kind::Record(Record { name: Some(name), .. }) = &written.kind
            && let Some((_, interpolation)) = known.iter().find(|(n, _)| *n == name.text)
        {
            return *interpolation;
        }
        self.mismatch(written, "`Linear`, `Smooth` or `Constant`");
        Interpolation::Linear
    }

    pub fn triplanar(&mut self, value: &scene::Value) -> Option<Triplanar> {
        let mut fields = Fields::of(self, value, "`Triplanar`");
        let at = self.at(&mut fields);
        let of = fields.require(self, "of").map(|of| self.color(of));
        let sharpness = fields.number(self, "sharpness", Some(4.0), 1.0, 64.0);
        fields.finish(self);
        Some(Triplanar { at: at?, of: of?, sharpness })
    }

    pub fn picture(&mut self, value: &scene::Value) -> Option<Picture> {
        let mut fields = Fields::of(self, value, "`Image`");
        let at = self.at(&mut fields);
        let file = fields.require(self, "file");
        let width = fields.number(self, "width", Some(1.0), 1e-4, 1e6);
        let repeat = fields.flag(self, "repeat", true);
        fields.finish(self);
        let file = file?;
        let Kind::Text(path) = &file.kind else {
            self.mismatch(file, "a file such as \"photo.png\"");
            return None;
        };
        let image = self.image(path, file)?;
        Some(Picture { at: at?, image, width, repeat })
    }
}
