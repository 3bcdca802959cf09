//! A number, a vector, a color, a text and a file, as widgets that say whether the hand has changed them.

use std::sync::Arc;

use egui::accesskit::Role;
use egui::color_picker::{Alpha, color_edit_button_hsva};
use egui::ecolor::Hsva;
use egui::{Align, Color32, Key, Layout, Response, RichText, Slider, SliderClamping, Ui, UiBuilder};
use glam::Vec3;

use crate::library::parse_color;
use crate::outline::ColorStyle;
use crate::scene::Path;

/// The numbers of a vector.
pub const AXES: [&str; 4] = ["x", "y", "z", "w"];
/// A slider over a range this many times as wide as the value is no use; over a steep one, whose steps grow,
/// where its ends are this far apart.
const WIDEST: f32 = 120.0;
const STEEPEST: f32 = 1e6;

/// Whoever lays it out gives it a name. What the author wrote stays as it is until a hand changes it, also
/// where it lies beyond `range` or has more digits than are shown.
pub fn number(
    ui: &mut Ui,
    number: &mut f32,
    range: Option<(f32, f32)>,
    is_whole: bool,
    unit: Option<&str>,
) -> bool {
    let before = *number;
    let suffix = if unit == Some("degrees") { "°" } else { "" };
    if let Some((low, high)) = range.filter(|(low, high)| fits_slider(*low, *high, *number)) {
        ui.spacing_mut().slider_width = (ui.available_width() - 70.0).max(40.0);
        let is_steep = low > 0.0 && high / low > 300.0;
        let slider = Slider::new(number, low..=high).logarithmic(is_steep).show_value(false);
        let slider = slider.clamping(SliderClamping::Edits);
        ui.add(if is_whole { slider.step_by(1.0) } else { slider });
        if *number != before {
            *number = short(*number);
        }
    }
    drag(ui, number, range, is_whole, suffix);
    if is_whole && *number != before {
        *number = number.round();
    }
    *number != before
}

/// Whether a hand can hit a value between `low` and `high` that is about as large as `number`.
fn fits_slider(low: f32, high: f32, number: f32) -> bool {
    let is_steep = low > 0.0 && high / low > 300.0;
    (is_steep && high / low <= STEEPEST) || high - low <= WIDEST * number.abs().max(0.05)
}

/// A number that a hand drags, in four digits, or types, in as many as it likes.
fn drag(ui: &mut Ui, number: &mut f32, range: Option<(f32, f32)>, is_whole: bool, suffix: &str) -> Response {
    let before = *number;
    let (low, high) = range.unwrap_or((f32::MIN, f32::MAX));
    let speed = if is_whole { 0.1 } else { (number.abs() * 0.01).max(0.005) };
    let (id, layer) = (ui.next_auto_id(), ui.layer_id());
    let is_typed = ui.memory_mut(|memory| {
        // The focus that Tab gives comes with this question: without it the text to edit has four digits.
        memory.interested_in_focus(id, layer);
        memory.has_focus(id)
    });
    let shown = |x: f64, _| {
        let x = x as f32;
        // egui would take a suffix for the widget's name.
        if is_typed { x.to_string() } else { format!("{}{suffix}", if is_whole { x } else { short(x) }) }
    };
    // What says the same as before is no edit, and so is not brought into the range either.
    let typed = |text: &str| {
        let text = text.trim().trim_end_matches('°').replace('−', "-");
        text.parse().ok().filter(|x: &f64| x.is_finite() && *x as f32 != before)
    };
    let value = egui::DragValue::new(number).speed(speed).range(low..=high).clamp_existing_to_range(false);
    let response = ui.add(value.custom_formatter(shown).custom_parser(typed));
    if response.dragged() && *number != before {
        *number = short(*number);
    }
    response
}

/// Each number is called by `name` and the one of `parts` that it is.
pub fn vector(
    ui: &mut Ui,
    (name, parts): (&str, &[&str]),
    numbers: &mut [f32],
    range: Option<(f32, f32)>,
) -> bool {
    let before = numbers.to_vec();
    let width = (ui.available_width() - 4.0 * (numbers.len() as f32 - 1.0)) / numbers.len() as f32;
    ui.spacing_mut().item_spacing.x = 4.0;
    ui.spacing_mut().interact_size.x = width;
    for (number, part) in numbers.iter_mut().zip(parts) {
        drag(ui, number, range, false, "").accessible_name(format!("{name} {part}"));
    }
    numbers != before
}

/// A light's color may be brighter than a screen: then it is three numbers. Else a hand picks one of those
/// that hexadecimal digits can say.
pub fn color(ui: &mut Ui, name: &str, color: &mut Vec3, style: ColorStyle) -> bool {
    let before = *color;
    let mut rgb = color.to_array();
    if color.max_element() > 1.0 {
        return vector(ui, (name, &["red", "green", "blue"]), &mut rgb, Some((0.0, 1e6))) && {
            *color = rgb.into();
            true
        };
    }
    ui.spacing_mut().interact_size.x = 56.0;
    // A grey has no hue and a black no saturation: what the hand has chosen of those is remembered.
    let id = ui.next_auto_id().with("hue");
    let bytes = |hsva: Hsva| Color32::from(hsva);
    let own = Hsva::from_rgb(rgb);
    let kept = ui.data(|data| data.get_temp::<Hsva>(id)).filter(|kept| bytes(*kept) == bytes(own));
    let mut hsva = kept.unwrap_or(own);
    color_edit_button_hsva(ui, &mut hsva, Alpha::Opaque).accessible_name(name);
    ui.data_mut(|data| data.insert_temp(id, hsva));
    let [r, g, b, _] = bytes(hsva).to_array();
    let hexadecimal = format!("#{r:02x}{g:02x}{b:02x}");
    // egui's way through hue and back loses digits: a hand changes the color on a screen.
    if bytes(hsva) != bytes(own) {
        *color = parse_color(&hexadecimal).unwrap_or(before);
    }
    let how = match style {
        ColorStyle::Text => hexadecimal,
        ColorStyle::Linear => rgb.map(|x| format!("{x:.2}")).join(" "),
        ColorStyle::Grey => format!("{:.3}", rgb[0]),
    };
    ui.add(egui::Label::new(RichText::new(how).monospace().weak().small()).truncate());
    *color != before
}

/// A text that counts once the author has finished it; Escape takes back what was typed.
pub fn text(ui: &mut Ui, path: &Path, value: &str) -> Option<String> {
    let id = egui::Id::unique(path.to_string());
    let draft = ui.data_mut(|data| data.get_temp::<String>(id));
    let mut text = draft.unwrap_or_else(|| value.to_owned());
    let response = ui.add(egui::TextEdit::singleline(&mut text).desired_width(ui.available_width() - 8.0));
    if response.has_focus() {
        ui.data_mut(|data| data.insert_temp(id, text));
        return None;
    }
    ui.data_mut(|data| data.remove::<String>(id));
    let gives_up = ui.input(|input| input.key_pressed(Key::Escape));
    (response.lost_focus() && !gives_up && text != value).then_some(text)
}

/// A file of the scene, typed or chosen among `files`, which are looked up when the menu opens.
pub fn file(
    ui: &mut Ui,
    (name, path): (&str, &Path),
    value: &str,
    files: impl Fn() -> Vec<String>,
) -> Option<String> {
    let mut chosen = None;
    ui.with_layout(Layout::right_to_left(Align::Center), |ui| {
        let id = egui::Id::unique(format!("files for {path}"));
        let menu = egui::ComboBox::from_id_salt(id).width(0.0).selected_text("");
        let menu = menu.show_ui(ui, |ui| {
            let found =
                ui.data_mut(|data| data.get_temp_mut_or_insert_with(id, || Arc::new(files())).clone());
            if found.is_empty() {
                ui.label(RichText::new("no such file beside the scene").weak());
            }
            for file in found.iter() {
                if ui.selectable_label(file == value, file).clicked() && file != value {
                    chosen = Some(file.clone());
                }
            }
        });
        if menu.inner.is_none() {
            ui.data_mut(|data| data.remove::<Arc<Vec<String>>>(id));
        }
        menu.response.accessible_name(format!("files for {name}"));
        ui.with_layout(Layout::left_to_right(Align::Center), |ui| {
            chosen = text(ui, path, value).or(chosen.take());
        });
    });
    chosen
}

/// Lays out what belongs to what is called `name`.
pub fn group(ui: &mut Ui, name: &str, contents: impl FnOnce(&mut Ui)) {
    let group = UiBuilder::new().accessibility_role(Role::Group).accessibility_label(name);
    ui.scope_builder(group, contents);
}

/// Four digits are what a hand can mean.
fn short(x: f32) -> f32 {
    if x == 0.0 {
        return 0.0;
    }
    let unit = 10f64.powi(3 - f64::from(x.abs()).log10().floor() as i32);
    ((f64::from(x) * unit).round() / unit) as f32
}
