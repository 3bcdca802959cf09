//! From a place and what stands there to the control that sets it.

use std::sync::Arc;

use glam::Vec3;

use super::slot::{Slot, Wants};
use super::{ColorStyle, Control, Field, Writer};
use crate::ir::fields::{self, Choice, EVERY_TEXTURE, FORMS, MATERIAL};
use crate::library::{Family, parse_color};
use crate::scene::{Kind, Path, Record, Value};

/// One more stop of a ramp.
const STOP: &str = "(1.0, \"#ffffff\")";

impl Writer<'_> {
    /// The fields of a table, those of `group` as the author wrote them.
    pub fn table(&self, table: &'static [fields::Field], group: Option<&Value>, path: &Path) -> Vec<Field> {
        let slots = table.iter().filter_map(Slot::of_field);
        slots.map(|slot| self.member(&slot, group, path)).collect()
    }

    /// The field of `group` that `slot` describes.
    pub fn member(&self, slot: &Slot<'_>, group: Option<&Value>, path: &Path) -> Field {
        let path = path.field(slot.label);
        self.field(slot, group.and_then(|group| group.step(&path.0[path.0.len() - 1])), path)
    }

    pub fn field(&self, slot: &Slot<'_>, value: Option<&Value>, path: Path) -> Field {
        let (none, names) = (Arc::default(), self.names);
        let (calls, declared) = match slot.wants {
            Wants::Number { varies: true, .. }
            | Wants::Vector { varies: true, .. }
            | Wants::Color { varies: true, .. } => (&names.textures, &names.declared_textures),
            Wants::Mapping => (&names.mappings, &none),
            Wants::Material => (&none, &names.declared_materials),
            _ => (&none, &none),
        };
        let (calls, declared) = (calls.clone(), declared.clone());
        let control = self.control(&slot.wants, value, &path, &declared);
        let (label, doc) = (slot.label.to_owned(), slot.doc.to_owned());
        let span = value.map(|value| value.span.clone());
        let Slot { unit, is_required, is_point, .. } = *slot;
        Field { path, label, doc, unit, span, is_required, is_point, control, calls, declared }
    }

    fn control(&self, wants: &Wants, value: Option<&Value>, path: &Path, declared: &[String]) -> Control {
        let kind = value.map(|value| &value.kind);
        let unclear = || Control::Unclear { words: self.words(value) };
        match (wants, kind) {
            (
                Wants::Number { varies: true, .. }
                | Wants::Vector { varies: true, .. }
                | Wants::Color { varies: true, .. }
                | Wants::Mapping,
                Some(Kind::Record(Record { name: Some(name), .. })),
            ) => self.call(Some(&name.text), value, path),
            (_, Some(Kind::Text(name))) if declared.contains(name) => {
                Control::Reference { name: name.clone() }
            }
            (Wants::Material, Some(Kind::Text(name))) => Control::Reference { name: name.clone() },
            (Wants::Mapping, None) => self.call(None, None, path),
            // A color given for a number is its luminance.
            (Wants::Number { varies: true, .. }, Some(Kind::Text(text))) => match parse_color(text) {
                Some(color) => Control::Color { value: Some(color), default: None, style: ColorStyle::Text },
                None => unclear(),
            },
            (Wants::Number { default, range, is_whole, .. }, kind) => {
                let value = match kind {
                    None => *default,
                    Some(Kind::None) => None,
                    Some(Kind::Number(x)) => Some(*x as f32),
                    _ => return unclear(),
                };
                Control::Number { value, default: *default, range: *range, is_whole: *is_whole }
            }
            (Wants::Vector { size, default, range, .. }, kind) => {
                let value = match kind {
                    None => default.clone(),
                    Some(kind) => match numbers(kind).filter(|n| n.len() == *size) {
                        Some(numbers) => Some(numbers),
                        None => return unclear(),
                    },
                };
                Control::Vector { size: *size, value, default: default.clone(), range: *range }
            }
            (Wants::Scale, Some(kind @ Kind::Tuple(_))) => match numbers(kind).filter(|n| n.len() == 3) {
                Some(numbers) => {
                    let default = Some(vec![1.0; 3]);
                    Control::Vector { size: 3, value: Some(numbers), default, range: None }
                }
                None => unclear(),
            },
            (Wants::Scale, kind) => {
                let value = match kind {
                    None => Some(1.0),
                    Some(Kind::Number(x)) => Some(*x as f32),
                    _ => return unclear(),
                };
                Control::Number { value, default: Some(1.0), range: None, is_whole: false }
            }
            (Wants::Color { default, style, .. }, kind) => match kind {
                None => Control::Color { value: *default, default: *default, style: *style },
                Some(kind) => match color(kind) {
                    Some((value, style)) => Control::Color { value: Some(value), default: *default, style },
                    None => unclear(),
                },
            },
            (Wants::Flag { default }, None) => {
                Control::Flag { value: default.unwrap_or(false), default: *default }
            }
            (Wants::Flag { default }, Some(Kind::Bool(value))) => {
                Control::Flag { value: *value, default: *default }
            }
            (Wants::Choice(choices), _) => self.choice(choices, value, path),
            (Wants::Named(words, default), kind) => {
                let current = kind.map_or(*default, |kind| {
                    words.iter().position(|known| {
                        word(kind).is_some_and(|written| known.eq_ignore_ascii_case(written))
                    })
                });
                let (words, default) = (words.clone(), *default);
                Control::Choice { words, current, default, fields: vec![] }
            }
            (Wants::Name, None) => Control::Text { value: String::new() },
            (Wants::Name, Some(Kind::Text(value))) => Control::Text { value: value.clone() },
            (Wants::File(extensions), None) => Control::File { value: String::new(), extensions },
            (Wants::File(extensions), Some(Kind::Text(value))) => {
                Control::File { value: value.clone(), extensions }
            }
            (Wants::Material, None | Some(Kind::Record(Record { name: None, .. }))) => {
                Control::Group { fields: self.table(MATERIAL, value, path) }
            }
            (Wants::Group(table), None | Some(Kind::Record(Record { name: None, .. }))) => {
                Control::Group { fields: self.table(table, value, path) }
            }
            (Wants::Stops, None) => Control::List { items: vec![], example: STOP },
            (Wants::Stops, Some(Kind::List(items))) => {
                let items = items.iter().enumerate().map(|(i, item)| self.stop(item, &path.item(i)));
                Control::List { items: items.collect(), example: STOP }
            }
            _ => unclear(),
        }
    }

    /// The place and the color of a ramp's stop.
    fn stop(&self, item: &Value, path: &Path) -> Vec<Field> {
        let place = Wants::Number { default: None, range: None, is_whole: false, varies: false };
        let color = Wants::Color { default: None, style: ColorStyle::Text, varies: true };
        let slots = [("place", "from low to high", place), ("color", "a color or a texture", color)];
        let fields = slots.into_iter().enumerate().map(|(i, (label, doc, wants))| {
            let path = path.item(i);
            let slot = Slot { label, doc, unit: None, is_required: true, is_point: false, wants };
            self.field(&slot, item.step(&path.0[path.0.len() - 1]), path)
        });
        fields.collect()
    }

    /// A word of `choices`, with the number that it carries.
    fn choice(&self, choices: &'static [Choice], value: Option<&Value>, path: &Path) -> Control {
        let written = value.map_or(Some(choices[0].word), |value| word(&value.kind));
        let current = choices.iter().position(|choice| Some(choice.word) == written);
        let carried = current.and_then(|i| choices[i].carries.map(|number| (choices[i].word, number)));
        let fields = carried.map(|(label, number)| {
            let slot =
                Slot { label, doc: "", unit: None, is_required: true, is_point: false, wants: number.into() };
            let path = path.item(0);
            self.field(&slot, value.and_then(|value| value.step(&path.0[path.0.len() - 1])), path)
        });
        let words = choices.iter().map(|choice| match choice.carries.and_then(|number| number.default) {
            Some(x) => format!("{}({x:?})", choice.word),
            None => choice.word.to_owned(),
        });
        Control::Choice {
            words: words.collect(),
            current,
            default: Some(0),
            fields: fields.into_iter().collect(),
        }
    }

    /// A call of a texture or mapping; what nobody knows has no fields.
    fn call(&self, name: Option<&str>, value: Option<&Value>, path: &Path) -> Control {
        let Some(name) = name else {
            return Control::Texture { name: None, doc: String::new(), fields: vec![] };
        };
        let (doc, own) = match FORMS.iter().map(|(form, _)| form).find(|form| form.name == name) {
            Some(form) => (form.doc.to_owned(), self.table(form.fields, value, path)),
            None => match self.lookup.find(Family::Texture, name) {
                Ok(function) => {
                    let slots = function.parameters.iter().map(|p| Slot::of_parameter(p, true));
                    let own = slots.map(|slot| self.member(&slot, value, path)).collect();
                    (function.caption.clone(), own)
                }
                Err(_) => (String::new(), vec![]),
            },
        };
        let known = !own.is_empty() || !doc.is_empty();
        let at = if known { self.table(EVERY_TEXTURE, value, path) } else { vec![] };
        let fields = own.into_iter().chain(at).collect();
        Control::Texture { name: Some(name.to_owned()), doc, fields }
    }

    fn words(&self, value: Option<&Value>) -> String {
        value.map_or(String::new(), |value| self.text[value.whole.clone()].to_owned())
    }
}

/// What a bare word or a string says, as choices are written.
fn word(kind: &Kind) -> Option<&str> {
    match kind {
        Kind::None => Some("None"),
        Kind::Text(text) => Some(text),
        Kind::Record(Record { name: Some(name), .. }) => Some(&name.text),
        _ => None,
    }
}

fn numbers(kind: &Kind) -> Option<Vec<f32>> {
    let Kind::Tuple(items) = kind else { return None };
    items.iter().map(|item| if let Kind::Number(x) = item.kind { Some(x as f32) } else { None }).collect()
}

/// A color given directly, and how.
fn color(kind: &Kind) -> Option<(Vec3, ColorStyle)> {
    match kind {
        Kind::Number(x) => Some((Vec3::splat(*x as f32), ColorStyle::Grey)),
        Kind::Text(text) => parse_color(text).map(|color| (color, ColorStyle::Text)),
        kind => {
            let numbers = numbers(kind).filter(|n| n.len() == 3)?;
            Some((Vec3::from_slice(&numbers), ColorStyle::Linear))
        }
    }
}
