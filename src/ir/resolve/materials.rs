//! Materials, named and inline.

use super::reader::Fields;
use super::{Resolver, Usage};
use crate::diagnostic::Diagnostic;
use crate::ir::fields::{BUMP, MATERIAL};
use crate::ir::{Bump, Material, Property, Value};
use crate::library::Const;
use crate::scene::{self, Kind, Record};

impl<'a> Resolver<'a> {
    /// What `materials:` declares.
    pub fn resolve_materials(&mut self, written: Option<&'a scene::Value>) {
        let Some(written) = written else { return };
        let Kind::Map(entries) = &written.kind else {
            self.mismatch(written, "a map `{ \"name\": (color: 0.8) }`");
            return;
        };
        for (i, entry) in entries.iter().enumerate() {
            if let Some(first) = entries[..i].iter().find(|e| e.name.text == entry.name.text) {
                let message = format!("material \"{}\" is declared twice", entry.name.text);
                let (here, there) = (self.place(&entry.name.span), self.place(&first.name.span));
                self.push(Diagnostic::error(message).at(here, "again").at(there, "first"));
                continue;
            }
            let index = self.inline_material(&entry.value, &entry.name.text);
            self.named_materials.insert(entry.name.text.clone(), index);
        }
    }

    /// The index of the material of an object called `object`.
    pub fn material(&mut self, written: Option<&scene::Value>, object: &str) -> usize {
        let Some(written) = written else {
            self.materials.push(Material {
                name: object.to_owned(),
                caption: String::new(),
                properties: vec![],
                bump: None,
            });
            return self.materials.len() - 1;
        };
        let Kind::Text(name) = &written.kind else {
            return self.inline_material(written, object);
        };
        if let Some(index) = self.named_materials.get(name) {
            return *index;
        }
        let known: Vec<String> = self.named_materials.keys().cloned().collect();
        let place = self.place(&written.span);
        let problem = Diagnostic::error(format!("there is no material \"{name}\"")).at(place, "");
        let mut problem = problem.suggest(name, known.iter().map(String::as_str));
        if known.is_empty() {
            problem.help.push(
                "declare it: `materials: { \"name\": (color: 0.8) }`, or write `(color: …)` here".into(),
            );
        }
        self.push(problem);
        0
    }

    fn inline_material(&mut self, written: &scene::Value, name: &str) -> usize {
        if let Kind::Record(Record { name: Some(called), .. }) = &written.kind {
            let advice = format!("write a group of fields: `(color: {}(…))`", called.text);
            self.error(&called.span, format!("`{}` is not a material", called.text)).help.push(advice);
            return 0;
        }
        let mut fields = Fields::of(self, written, "a material", &[MATERIAL]);
        let mut properties = vec![];
        let color = self.wanted_for(Usage::Surface, |resolver| fields.color(resolver, "color"));
        properties.extend(color.map(|color| (Property::Color, color)));
        for (name, property) in [
            ("specular", Property::Specular),
            ("shininess", Property::Shininess),
            ("reflectivity", Property::Reflectivity),
            ("transmission", Property::Transmission),
        ] {
            properties.extend(fields.pattern(self, name).map(|value| (property, value)));
        }
        for (name, property) in [("fresnel", Property::Fresnel), ("ior", Property::Ior)] {
            let number = fields.given_number(self, name).map(|x| Value::Const(Const::F32(x)));
            properties.extend(number.map(|value| (property, value)));
        }
        properties.extend(fields.color(self, "emission").map(|color| (Property::Emission, color)));
        let bump = fields.get("bump").and_then(|bump| self.bump(bump));
        fields.finish(self);
        self.check_evaluations(&properties.iter().map(|(_, value)| value).collect::<Vec<_>>(), &written.span);
        bump.iter().for_each(|bump| self.check_evaluations(&[&bump.height], &written.span));
        properties.sort_by_key(|(property, _)| *property);
        let caption = self.words(written, &[]);
        self.materials.push(Material { name: name.to_owned(), caption, properties, bump });
        self.materials.len() - 1
    }

    fn bump(&mut self, written: &scene::Value) -> Option<Bump> {
        let mut fields = Fields::of(self, written, "`bump`", &[BUMP]);
        let height = fields.pattern(self, "height");
        let strength = fields.number(self, "strength");
        fields.finish(self);
        Some(Bump { height: height?, strength })
    }
}
