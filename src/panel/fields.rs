//! Fields of the scene as widgets: each shows a value of the text, and what is done to it becomes an edit.

use egui::{Align, Layout, RichText, Ui};
use glam::Vec3;

use super::{Pending, widgets};
use crate::edit::{Edit, NewValue};
use crate::outline::{ColorStyle, Control, Field};

/// Points, of the names before the widgets.
const LABELS: f32 = 104.0;

/// Lays out fields and gathers what is done to them.
pub struct Fields<'a> {
    pub edits: &'a mut Vec<Edit>,
    pub pending: &'a Pending,
    /// RON text of a texture or mapping with no more than it must be given; None where a file for it is
    /// missing.
    pub example: &'a dyn Fn(&str) -> Option<String>,
    /// The files in the scene's reach that end in one of these, as the scene writes them.
    pub files: &'a dyn Fn(&[&str]) -> Vec<String>,
    /// What makes another texture of the one in a field, by its name.
    pub becomes: &'a dyn Fn(&Field, &str) -> Vec<Edit>,
}

impl Fields<'_> {
    pub fn show(&mut self, ui: &mut Ui, fields: &[Field]) {
        fields.iter().for_each(|field| self.field(ui, field));
    }

    fn field(&mut self, ui: &mut Ui, field: &Field) {
        match &field.control {
            Control::Texture { name, doc, fields } => {
                self.row(ui, field, |me, ui| me.texture(ui, field, name.as_deref(), doc));
                indented(ui, field, |ui| self.show(ui, fields));
            }
            Control::Choice { fields, .. } => {
                self.row(ui, field, |me, ui| me.value(ui, field));
                indented(ui, field, |ui| self.show(ui, fields));
            }
            Control::Group { fields } => {
                let title = egui::CollapsingHeader::new(&field.label).id_salt(field.path.to_string());
                let shown = title.default_open(field.span.is_some()).show(ui, |ui| {
                    widgets::group(ui, &field.label, |ui| self.show(ui, fields));
                });
                shown.header_response.on_hover_text(&field.doc);
            }
            Control::List { items, example } => self.list(ui, field, items, example),
            _ => self.row(ui, field, |me, ui| me.value(ui, field)),
        }
    }

    /// A name, a widget, and the menu of all that can be done with the field.
    fn row(&mut self, ui: &mut Ui, field: &Field, widget: impl FnOnce(&mut Self, &mut Ui)) {
        ui.horizontal(|ui| {
            let text = RichText::new(&field.label);
            let text = if field.span.is_some() { text } else { text.weak() };
            let name = ui.allocate_ui_with_layout(
                egui::vec2(LABELS, ui.spacing().interact_size.y),
                Layout::left_to_right(Align::Center),
                |ui| {
                    ui.set_min_width(LABELS);
                    ui.add(egui::Label::new(text).truncate().selectable(false)).on_hover_text(help(field))
                },
            );
            ui.with_layout(Layout::right_to_left(Align::Center), |ui| {
                self.menu(ui, field);
                ui.with_layout(Layout::left_to_right(Align::Center), |ui| {
                    ui.label_inputs_by(name.inner.id, |ui| widget(self, ui));
                });
            });
        });
    }

    /// What else the field could be.
    fn menu(&mut self, ui: &mut Ui, field: &Field) {
        let resets = field.span.is_some() && !field.is_required;
        if !resets && field.calls.is_empty() && field.declared.is_empty() {
            return;
        }
        let menu = ui.menu_button("…", |ui| {
            if ui.add_enabled(resets, egui::Button::new("Reset to the default")).clicked() {
                self.edits.push(Edit::Remove { path: field.path.clone() });
                ui.close();
            }
            for name in field.declared.iter() {
                if ui.button(format!("\"{name}\"")).clicked() {
                    self.set(field, NewValue::Text(name.clone()));
                    ui.close();
                }
            }
            if !field.calls.is_empty() {
                ui.separator();
                egui::ScrollArea::vertical().max_height(320.0).show(ui, |ui| {
                    for name in field.calls.iter() {
                        if ui.button(name).clicked() {
                            self.call(field, name);
                            ui.close();
                        }
                    }
                });
            }
        });
        menu.response.accessible_name(format!("more for {}", field.label));
    }

    fn value(&mut self, ui: &mut Ui, field: &Field) {
        match &field.control {
            Control::Number { value, default, range, is_whole } => {
                let known = self.pending.number(&field.path).or(*value).or(*default);
                let mut number = known.unwrap_or_else(|| range.map_or(0.0, |(low, _)| low));
                if widgets::number(ui, &mut number, *range, *is_whole, field.unit) {
                    self.set(field, NewValue::Number(number));
                }
            }
            Control::Vector { size, value, default, range } => {
                let known = self.pending.vector(&field.path).or_else(|| value.clone());
                let mut numbers = known.or_else(|| default.clone()).unwrap_or_else(|| vec![0.0; *size]);
                if widgets::vector(ui, (&field.label, &widgets::AXES), &mut numbers, *range) {
                    self.set(field, NewValue::Vector(numbers));
                }
            }
            Control::Color { value, default, style } => {
                let known = self.pending.color(&field.path).or(*value).or(*default);
                let mut color = known.unwrap_or(Vec3::splat(0.8));
                if widgets::color(ui, &field.label, &mut color, *style) {
                    // Three numbers are rounded to what a person would type.
                    let is_text = *style == ColorStyle::Text || field.span.is_none();
                    let round = |color: Vec3| (color * 1e4).round() / 1e4;
                    self.set(field, NewValue::Color(if is_text { color } else { round(color) }));
                }
            }
            Control::Flag { value, .. } => {
                let mut flag = self.pending.flag(&field.path).unwrap_or(*value);
                if ui.checkbox(&mut flag, "").changed() {
                    self.set(field, NewValue::Flag(flag));
                }
            }
            Control::Choice { words, current, default, .. } => {
                let shown = current.or(*default).map_or("", |i| words[i].as_str());
                if let Some(word) = pick(ui, field, shown, words.iter()) {
                    self.set(field, NewValue::Word(word));
                }
            }
            Control::Reference { name } => {
                if let Some(name) = pick(ui, field, name, field.declared.iter()) {
                    self.set(field, NewValue::Text(name));
                }
            }
            Control::File { value, extensions } => {
                let files = || (self.files)(extensions);
                if let Some(file) = widgets::file(ui, (&field.label, &field.path), value, files) {
                    self.set(field, NewValue::Text(file));
                }
            }
            Control::Text { value } => {
                if let Some(text) = widgets::text(ui, &field.path, value) {
                    self.set(field, NewValue::Text(text));
                }
            }
            Control::Unclear { words } => {
                ui.add(egui::Label::new(RichText::new(words).monospace().weak()).truncate());
            }
            Control::Texture { .. } | Control::Group { .. } | Control::List { .. } => {}
        }
    }

    fn texture(&mut self, ui: &mut Ui, field: &Field, name: Option<&str>, doc: &str) {
        if let Some(chosen) = pick(ui, field, name.unwrap_or("none"), field.calls.iter()) {
            self.call(field, &chosen);
        }
        if !doc.is_empty() {
            ui.label(RichText::new("?").weak()).on_hover_text(doc);
        }
    }

    fn list(&mut self, ui: &mut Ui, field: &Field, items: &[Vec<Field>], example: &str) {
        ui.horizontal(|ui| {
            ui.label(&field.label).on_hover_text(help(field));
            let plus = ui.small_button("+").on_hover_text("add one");
            if plus.accessible_name(format!("add to {}", field.label)).clicked() {
                let (list, item) = (field.path.clone(), example.to_owned());
                self.edits.push(Edit::Insert { list, index: items.len(), item });
            }
        });
        for (i, item) in items.iter().enumerate() {
            let path = field.path.item(i);
            let name = format!("{} {i}", field.label);
            ui.indent(path.to_string(), |ui| {
                widgets::group(ui, &name, |ui| self.show(ui, item));
                let removes = items.len() > 2
                    && ui.small_button("remove").accessible_name(format!("remove {name}")).clicked();
                if removes {
                    self.edits.push(Edit::Remove { path });
                }
            });
        }
    }

    /// Puts the texture `name` into a field, with the values of the one that is there.
    fn call(&mut self, field: &Field, name: &str) {
        match &field.control {
            Control::Texture { name: Some(old), .. } if old == name => {}
            Control::Texture { name: Some(_), .. } => {
                self.edits.extend((self.becomes)(field, name));
            }
            _ => {
                let words = (self.example)(name);
                words.into_iter().for_each(|words| self.set(field, NewValue::Code(words)));
            }
        }
    }

    fn set(&mut self, field: &Field, value: NewValue) {
        self.edits.push(Edit::Set { path: field.path.clone(), value });
    }
}

fn indented(ui: &mut Ui, field: &Field, fields: impl FnOnce(&mut Ui)) {
    if !field.fields().is_empty() {
        ui.indent(field.path.to_string(), |ui| widgets::group(ui, &field.label, fields));
    }
}

fn help(field: &Field) -> String {
    let unit = field.unit.map_or(String::new(), |unit| format!(", {unit}"));
    let range = match &field.control {
        Control::Number { range: Some((low, high)), .. } => format!("\n{low} to {high}{unit}"),
        _ => String::new(),
    };
    let absent = if field.span.is_none() { "\ndefault value, not written in the file" } else { "" };
    format!("{}{range}{absent}", field.doc)
}

/// One of `names`, if another than `shown` was chosen.
fn pick<'n>(
    ui: &mut Ui,
    field: &Field,
    shown: &str,
    names: impl Iterator<Item = &'n String>,
) -> Option<String> {
    let mut chosen = None;
    egui::ComboBox::from_id_salt(field.path.to_string())
        .width(ui.available_width() - 24.0)
        .truncate()
        .selected_text(shown)
        .show_ui(ui, |ui| {
            for name in names {
                if ui.selectable_label(name == shown, name).clicked() && name != shown {
                    chosen = Some(name.clone());
                }
            }
        });
    chosen
}
