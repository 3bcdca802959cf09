//! A number, a vector, a color and a text, as widgets that say whether the hand has changed them.

use egui::accesskit::Role;
use egui::{Color32, Response, RichText, Slider, Ui, UiBuilder};
use glam::Vec3;

use crate::outline::ColorStyle;
use crate::scene::Path;

/// The numbers of a vector.
pub const AXES: [&str; 4] = ["x", "y", "z", "w"];
/// A slider over a range this many times as wide as the value is no use; over a steep one, whose steps grow,
/// where its ends are this far apart.
const WIDEST: f32 = 120.0;
const STEEPEST: f32 = 1e6;

/// Whoever lays it out gives it a name.
pub fn number(
    ui: &mut Ui,
    number: &mut f32,
    range: Option<(f32, f32)>,
    is_whole: bool,
    unit: Option<&str>,
) -> bool {
    let before = *number;
    let suffix = if unit == Some("degrees") { "°" } else { "" };
    match range.filter(|(low, high)| fits_slider(*low, *high, *number)) {
        Some((low, high)) => {
            ui.spacing_mut().slider_width = (ui.available_width() - 70.0).max(40.0);
            let is_steep = low > 0.0 && high / low > 300.0;
            let slider = Slider::new(number, low..=high).logarithmic(is_steep).suffix(suffix);
            let slider = slider.custom_formatter(|x, _| format!("{}", short(x as f32)));
            ui.add(if is_whole { slider.step_by(1.0) } else { slider })
        }
        None => drag(ui, number, range, is_whole, suffix),
    };
    if *number != before {
        *number = if is_whole { number.round() } else { short(*number) };
    }
    *number != before
}

/// Whether a hand can hit a value between `low` and `high` that is about as large as `number`.
fn fits_slider(low: f32, high: f32, number: f32) -> bool {
    let is_steep = low > 0.0 && high / low > 300.0;
    (is_steep && high / low <= STEEPEST) || high - low <= WIDEST * number.abs().max(0.05)
}

fn drag(ui: &mut Ui, number: &mut f32, range: Option<(f32, f32)>, is_whole: bool, suffix: &str) -> Response {
    let (low, high) = range.unwrap_or((f32::MIN, f32::MAX));
    let speed = if is_whole { 0.1 } else { (number.abs() * 0.01).max(0.005) };
    let value = egui::DragValue::new(number).speed(speed).range(low..=high).suffix(suffix);
    ui.add(value.custom_formatter(|x, _| format!("{}", short(x as f32))))
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
    for (number, before) in numbers.iter_mut().zip(&before) {
        if number != before {
            *number = short(*number);
        }
    }
    numbers != before
}

/// A light's color may be brighter than a screen: then it is three numbers.
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
    // egui's way through hue and back loses digits: only what a hand has done counts.
    let is_new = ui.color_edit_button_rgb(&mut rgb).accessible_name(name).changed();
    let how = match style {
        ColorStyle::Text => {
            let [r, g, b, _] = Color32::from(egui::Rgba::from_rgb(rgb[0], rgb[1], rgb[2])).to_array();
            format!("#{r:02x}{g:02x}{b:02x}")
        }
        ColorStyle::Linear => rgb.map(|x| format!("{x:.2}")).join(" "),
        ColorStyle::Grey => format!("{:.3}", rgb[0]),
    };
    ui.add(egui::Label::new(RichText::new(how).monospace().weak().small()).truncate());
    if is_new {
        *color = rgb.map(|x| (x * 1e4).round() / 1e4).into();
    }
    *color != before
}

/// A text that is told once the author has finished it.
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
    (response.lost_focus() && text != value).then_some(text)
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
