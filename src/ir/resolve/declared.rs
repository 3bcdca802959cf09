//! Textures by name: each is resolved once for each use that makes a difference.

use std::ops::Range;

use super::limits::MAX_TEXTURES;
use super::{Resolver, Usage};
use crate::diagnostic::Diagnostic;
use crate::ir::{Texture, Value};
use crate::library::Type;
use crate::scene::{self, Kind};

impl<'a> Resolver<'a> {
    /// What `textures:` declares, all of it, used or not.
    pub fn resolve_textures(&mut self, written: Option<&'a scene::Value>) {
        let Some(written) = written else { return };
        let Kind::Map(entries) = &written.kind else {
            self.mismatch(written, "a map `{ \"name\": Texture() }`");
            return;
        };
        if !self.allows(entries.len(), MAX_TEXTURES, "textures", &written.span) {
            return;
        }
        for (i, entry) in entries.iter().enumerate() {
            if let Some(first) = entries[..i].iter().find(|e| e.name.text == entry.name.text) {
                let message = format!("texture \"{}\" is declared twice", entry.name.text);
                let (here, there) = (self.place(&entry.name.span), self.place(&first.name.span));
                self.push(Diagnostic::error(message).at(here, "again").at(there, "first"));
            }
            self.declared.insert(&entry.name.text, &entry.value);
        }
        for entry in entries {
            self.wanted_for(Usage::Light, |resolver| {
                resolver.declared_texture(&entry.name.text, &entry.name.span, Type::Vec3)
            });
        }
        let place = |name: &str| entries.iter().find(|e| e.name.text == name).map(|e| e.name.span.clone());
        self.check_textures(place);
    }

    /// The index of the texture declared as `name`, which `span` asks for, as the present use wants it.
    pub fn declared_texture(&mut self, name: &str, span: &Range<usize>, want: Type) -> Option<usize> {
        let plain = match self.textures.iter().position(|t| t.name == name) {
            Some(known) => known,
            None => self.plain_texture(name, span)?,
        };
        if !self.usage_dependent.contains(&plain) {
            return Some(plain);
        }
        self.depends_on_usage = true;
        let wanted = (plain, self.usage, want == Type::F32);
        if wanted.1 == Usage::Light && !wanted.2 {
            return Some(plain);
        }
        if let Some(variant) = self.variants.get(&wanted) {
            return Some(*variant);
        }
        let told = self.problems.len();
        let value = self.declared_value(self.declared.get(name)?, want);
        let again = self.problems.split_off(told);
        let new: Vec<_> = again.into_iter().filter(|problem| !self.problems.contains(problem)).collect();
        self.problems.extend(new);
        let texture = Texture { name: name.to_owned(), ..self.textures[plain].clone() };
        let variant = match value {
            Some(value) if value != texture.value => {
                self.textures.push(Texture { ty: self.type_of(&value), value, ..texture });
                self.textures.len() - 1
            }
            // What is wrong has been reported.
            _ => plain,
        };
        self.variants.insert(wanted, variant);
        Some(variant)
    }

    /// The texture declared as `name`, as light wants it.
    fn plain_texture(&mut self, name: &str, span: &Range<usize>) -> Option<usize> {
        if let Some(from) = self.pending.iter().position(|p| p == name) {
            if self.circular.contains(name) {
                return None;
            }
            self.circular.extend(self.pending[from..].iter().cloned());
            let circle: Vec<String> =
                self.pending[from..].iter().chain([&name.to_owned()]).cloned().collect();
            let message = format!("texture \"{name}\" uses itself");
            self.error(span, message).help.push(format!("the cycle is {}", circle.join(" → ")));
            return None;
        }
        if self.broken.contains(name) {
            return None;
        }
        let written = *self.declared.get(name)?;
        let around = std::mem::take(&mut self.depends_on_usage);
        self.pending.push(name.to_owned());
        let value = self.wanted_for(Usage::Light, |resolver| resolver.declared_value(written, Type::Vec3));
        self.pending.pop();
        let depends = std::mem::replace(&mut self.depends_on_usage, around);
        let Some(value) = value else {
            self.broken.insert(name.to_owned());
            return None;
        };
        let (ty, caption) = (self.type_of(&value), self.words(written, &[]));
        self.textures.push(Texture { name: name.to_owned(), caption, ty, value });
        let index = self.textures.len() - 1;
        if depends {
            self.usage_dependent.insert(index);
        }
        Some(index)
    }

    fn declared_value(&mut self, written: &scene::Value, want: Type) -> Option<Value> {
        match &written.kind {
            Kind::Record(record) if record.name.is_some() => self.texture(written, record, want),
            // A texture may be another one's second name, or a color to be used in many places.
            Kind::Text(other) if self.declared.contains_key(other.as_str()) => {
                self.declared_texture(other, &written.span, want).map(Value::Texture)
            }
            _ => Some(self.color(written)),
        }
    }
}
