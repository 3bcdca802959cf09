//! How the window looks: dark and light, quiet beside a picture.

use egui::{Color32, CornerRadius, Stroke, Style, Theme, Visuals};

use crate::panel::settings;

/// What is chosen, and what can be pressed.
pub const ACCENT: Color32 = Color32::from_rgb(86, 140, 245);

/// Buttons and messages over the picture, on a dark ground in both themes.
pub const LINK_OVER_PICTURE: Color32 = Color32::from_rgb(120, 170, 255);
pub const PALE: Color32 = Color32::from_gray(225);

/// Points of the smallest text.
const SMALLEST: f32 = 11.0;

/// Gives `context` the two themes, and shows one.
pub fn apply(context: &egui::Context, theme: settings::Theme) {
    context.set_style_of(Theme::Dark, style(Visuals::dark()));
    context.set_style_of(Theme::Light, style(Visuals::light()));
    choose(context, theme);
}

pub fn choose(context: &egui::Context, theme: settings::Theme) {
    context.set_theme(match theme {
        settings::Theme::Dark => Theme::Dark,
        settings::Theme::Light => Theme::Light,
    });
}

fn style(mut visuals: Visuals) -> Style {
    let is_dark = visuals.dark_mode;
    let shade = |dark: u8, light: u8| Color32::from_gray(if is_dark { dark } else { light });
    visuals.panel_fill = shade(24, 246);
    visuals.window_fill = shade(30, 252);
    visuals.faint_bg_color = shade(38, 234);
    visuals.extreme_bg_color = shade(14, 255);
    visuals.window_stroke = Stroke::new(1.0, shade(54, 205));
    visuals.selection.bg_fill = ACCENT.gamma_multiply(if is_dark { 0.45 } else { 0.3 });
    visuals.selection.stroke = Stroke::new(1.0, shade(255, 0));
    let [warning, error] = if is_dark {
        [Color32::from_rgb(245, 190, 80), Color32::from_rgb(255, 110, 100)]
    } else {
        [Color32::from_rgb(140, 85, 0), Color32::from_rgb(190, 40, 30)]
    };
    // At least 4.5 times the contrast of what it stands on.
    visuals.weak_text_color = Some(shade(158, 92));
    visuals.widgets.noninteractive.fg_stroke.color = shade(190, 60);
    visuals.hyperlink_color = if is_dark { LINK_OVER_PICTURE } else { Color32::from_rgb(30, 85, 190) };
    visuals.warn_fg_color = warning;
    visuals.error_fg_color = error;
    visuals.slider_trailing_fill = true;
    // One that blinks has the whole window drawn twice a second, half a processor for a software driver.
    visuals.text_cursor.blink = false;
    visuals.window_corner_radius = CornerRadius::same(8);
    visuals.menu_corner_radius = CornerRadius::same(6);
    let widgets = &mut visuals.widgets;
    for widget in [&mut widgets.inactive, &mut widgets.hovered, &mut widgets.active, &mut widgets.open] {
        widget.corner_radius = CornerRadius::same(5);
        widget.bg_stroke = Stroke::NONE;
    }
    widgets.inactive.bg_fill = shade(48, 218);
    widgets.inactive.weak_bg_fill = shade(42, 228);
    widgets.hovered.bg_fill = shade(62, 205);
    widgets.hovered.weak_bg_fill = shade(56, 216);
    widgets.noninteractive.bg_stroke = Stroke::new(1.0, shade(44, 220));
    let mut style = Style { visuals, ..Style::default() };
    style.text_styles.insert(egui::TextStyle::Small, egui::FontId::proportional(SMALLEST));
    style.spacing.item_spacing = egui::vec2(6.0, 4.0);
    style.spacing.button_padding = egui::vec2(7.0, 2.0);
    style.spacing.interact_size = egui::vec2(40.0, 20.0);
    style.spacing.scroll = egui::style::ScrollStyle::thin();
    style
}
