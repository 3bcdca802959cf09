//! How the window looks: dark and light, quiet beside a picture.

use egui::{Color32, CornerRadius, Stroke, Style, Theme, Visuals};

/// What is chosen, and what can be pressed.
pub const ACCENT: Color32 = Color32::from_rgb(86, 140, 245);

/// Gives `context` the two themes, and the one of the system.
pub fn apply(context: &egui::Context) {
    context.set_style_of(Theme::Dark, style(Visuals::dark(), 0));
    context.set_style_of(Theme::Light, style(Visuals::light(), 255));
    context.set_theme(Theme::Dark);
}

/// `ink` is the background's grey, 0 or 255.
fn style(mut visuals: Visuals, ink: u8) -> Style {
    let shade = |amount: u8| Color32::from_gray(ink.abs_diff(amount));
    visuals.panel_fill = shade(24);
    visuals.window_fill = shade(30);
    visuals.faint_bg_color = shade(38);
    visuals.extreme_bg_color = shade(14);
    visuals.selection.bg_fill = ACCENT.gamma_multiply(0.45);
    visuals.selection.stroke = Stroke::new(1.0, if ink == 0 { Color32::WHITE } else { Color32::BLACK });
    visuals.slider_trailing_fill = true;
    visuals.window_corner_radius = CornerRadius::same(8);
    visuals.menu_corner_radius = CornerRadius::same(6);
    let widgets = &mut visuals.widgets;
    for widget in [&mut widgets.inactive, &mut widgets.hovered, &mut widgets.active, &mut widgets.open] {
        widget.corner_radius = CornerRadius::same(5);
        widget.bg_stroke = Stroke::NONE;
    }
    widgets.inactive.bg_fill = shade(48);
    widgets.inactive.weak_bg_fill = shade(42);
    widgets.hovered.bg_fill = shade(62);
    widgets.hovered.weak_bg_fill = shade(56);
    widgets.noninteractive.bg_stroke = Stroke::new(1.0, shade(44));
    let mut style = Style { visuals, ..Style::default() };
    style.spacing.item_spacing = egui::vec2(6.0, 4.0);
    style.spacing.button_padding = egui::vec2(7.0, 2.0);
    style.spacing.interact_size = egui::vec2(40.0, 20.0);
    style.spacing.scroll = egui::style::ScrollStyle::thin();
    style
}
