//! The magnifier: the pixels around the pointer, each a square that can be counted.

use egui::{Align2, Color32, FontId, Pos2, Rect, Stroke, StrokeKind, TextureId, Ui, Vec2};

use super::Panel;

/// The screen's pixels that it shows in a row, an odd number with one in the middle.
const PIXELS: f32 = 21.0;
/// How many times as large it shows them.
const ZOOM: f32 = 8.0;
/// Points from the pointer.
const AWAY: f32 = 18.0;

impl Panel {
    /// Draws it beside the pointer, if that is over `area`, where `picture` is.
    pub(super) fn magnify(&self, ui: &Ui, area: Rect, pointer: Option<Pos2>, picture: Option<TextureId>) {
        let (Some(pointer), Some(picture), true) = (pointer, picture, self.magnifies) else { return };
        let points = 1.0 / ui.ctx().pixels_per_point();
        let pixel = ((pointer - area.min) / points).floor();
        let middle = area.min + (pixel + Vec2::splat(0.5)) * points;
        let source = Rect::from_center_size(middle, Vec2::splat(PIXELS * points));
        let glass = place(pointer, area, Vec2::splat(PIXELS * ZOOM * points), points);
        let seen = source.intersect(area);
        let share = |at: Pos2, whole: Rect| ((at - whole.min) / whole.size()).to_pos2();
        let uv = Rect::from_min_max(share(seen.min, area), share(seen.max, area));
        let image = Rect::from_min_max(
            glass.lerp_inside(share(seen.min, source).to_vec2()),
            glass.lerp_inside(share(seen.max, source).to_vec2()),
        );
        let painter = ui.painter();
        painter.rect_filled(glass.expand(2.0), 3.0, Color32::from_gray(20));
        painter.image(picture, image, uv, Color32::WHITE);
        painter.rect_stroke(glass, 0.0, Stroke::new(1.0, Color32::from_gray(150)), StrokeKind::Outside);
        let square = Rect::from_center_size(glass.center(), Vec2::splat(ZOOM * points));
        painter.rect_stroke(square, 0.0, Stroke::new(1.0, Color32::BLACK), StrokeKind::Outside);
        painter.rect_stroke(square.expand(1.0), 0.0, Stroke::new(1.0, Color32::WHITE), StrokeKind::Outside);
        let (font, text) = (FontId::monospace(11.0), format!("{} {}", pixel.x, pixel.y));
        let galley = painter.layout_no_wrap(text, font, Color32::from_gray(225));
        let label = Align2::LEFT_BOTTOM.align_size_within_rect(galley.size(), glass.shrink(4.0));
        painter.rect_filled(label.expand(3.0), 2.0, Color32::from_black_alpha(170));
        painter.galley(label.min, galley, Color32::WHITE);
    }
}

/// Where it goes so that it hides the pointer nowhere, and its edges lie between pixels.
fn place(pointer: Pos2, area: Rect, size: Vec2, points: f32) -> Rect {
    let beside = |at: f32, size: f32, end: f32| {
        let start = if at + AWAY + size < end { at + AWAY } else { at - AWAY - size };
        (start / points).round() * points
    };
    let min = Pos2::new(beside(pointer.x, size.x, area.max.x), beside(pointer.y, size.y, area.max.y));
    Rect::from_min_size(min, size)
}
