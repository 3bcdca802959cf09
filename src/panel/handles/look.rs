//! How the handles look: arrows over the picture, and a word on what they do.

use egui::{
    Align2, Color32, CursorIcon, FontId, Modifiers, Painter, Pos2, Rect, Response, Shape, Stroke, Ui, vec2,
};
use glam::Vec2;

use super::hand::{Grip, Shown, Viewport};
use super::{Ball, GAP, Handle, Movable, Tripod};
use crate::panel::{ACCENT, Panel};

const X: Color32 = Color32::from_rgb(238, 82, 83);
const Y: Color32 = Color32::from_rgb(118, 200, 80);
const Z: Color32 = Color32::from_rgb(80, 146, 255);
/// What the hand would take, or has taken.
const LIT: Color32 = Color32::from_rgb(255, 214, 84);
/// Around all, so that it is seen on any picture.
const RIM: Color32 = Color32::from_black_alpha(150);
const PALE: Color32 = Color32::from_rgb(240, 240, 240);

/// Points.
const WIDTH: f32 = 2.5;
const HEAD: [f32; 2] = [13.0, 5.5];
const MIDDLE: f32 = 5.0;
/// Farther than any screen is wide.
const FAR: f32 = 1e4;

impl Panel {
    pub(in crate::panel) fn draw_handles(&mut self, ui: &Ui, response: &Response, area: Rect) {
        let Some(frame) = self.frame(ui, area) else { return };
        let painter = ui.painter().with_clip_rect(area);
        // A hand that turns the camera takes nothing on its way.
        let hover = response.hover_pos().filter(|_| !ui.input(|input| input.pointer.any_down()));
        for shown in self.shown_handles(&frame, hover) {
            if shown.lit.is_some() && shown.from.is_none() {
                ui.ctx().set_cursor_icon(CursorIcon::Grab);
            }
            let anchor = match &shown.movable {
                Movable::Place(place) => frame.tripod(place.at).map(|tripod| {
                    draw_tripod(&painter, &frame, &tripod, &shown);
                    frame.point(tripod.middle()) + vec2(GAP, 2.0 * GAP)
                }),
                Movable::Direction(direction) => {
                    let (ball, value) = (frame.ball(), direction.value.normalize());
                    draw_ball(&painter, &frame, &ball, &shown);
                    Some(frame.point(ball.knob(value)) + vec2(GAP, 2.0 * GAP))
                }
            };
            if let (Some(anchor), Some(lines)) = (anchor, words(ui, &shown)) {
                say(&painter, anchor, area, &lines);
            }
        }
    }
}

fn draw_tripod(painter: &Painter, frame: &Viewport, tripod: &Tripod, shown: &Shown) {
    let middle = frame.point(tripod.middle());
    let lit = shown.lit;
    if let Some(Movable::Place(from)) = &shown.from {
        if let Some(Grip::Of(handle)) = lit {
            draw_axis(painter, frame, tripod, handle);
        }
        if let Some(start) = frame.tripod(from.at) {
            painter.circle_stroke(frame.point(start.middle()), MIDDLE, Stroke::new(1.5, PALE));
        }
    }
    // What is nearer lies over what is farther.
    let depth = |handle: &Handle| -tripod.lens.forward.dot(handle.axis().unwrap_or_default());
    let mut axes = Handle::AXES;
    axes.sort_by(|a, b| depth(a).total_cmp(&depth(b)));
    for handle in axes {
        let Some(tip) = tripod.tip(handle) else { continue };
        let is_lit = lit == Some(Grip::Of(handle));
        // While one is in the hand, the others step back.
        let color = match (is_lit, &shown.from) {
            (true, _) => LIT,
            (false, Some(_)) => color(handle).gamma_multiply(0.35),
            (false, None) => color(handle),
        };
        draw_arrow(painter, middle, frame.point(tip), color, shown.from.is_some() && !is_lit);
    }
    let is_lit = lit == Some(Grip::Of(Handle::Plane));
    let fill = if is_lit { LIT } else { PALE };
    painter.circle(middle, if is_lit { MIDDLE + 1.0 } else { MIDDLE }, fill, Stroke::new(1.5, RIM));
}

fn draw_arrow(painter: &Painter, from: Pos2, to: Pos2, color: Color32, is_faint: bool) {
    let along = (to - from).normalized();
    let [length, half] = HEAD;
    let (start, neck) = (from + GAP * along, to - length * along);
    let side = half * along.rot90();
    let head = |grown: f32| {
        let (tip, base) = (to + 1.6 * grown * along, neck - grown * along);
        let side = side + 1.3 * grown * along.rot90();
        vec![tip, base + side, base - side]
    };
    let is_long = (neck - start).dot(along) > 0.0;
    if !is_faint {
        if is_long {
            painter.line_segment([start, neck], Stroke::new(WIDTH + 2.0, RIM));
        }
        painter.add(Shape::convex_polygon(head(1.0), RIM, Stroke::NONE));
    }
    if is_long {
        painter.line_segment([start, neck], Stroke::new(WIDTH, color));
    }
    painter.add(Shape::convex_polygon(head(0.0), color, Stroke::NONE));
}

/// The whole axis along which the hand moves, to the horizon.
fn draw_axis(painter: &Painter, frame: &Viewport, tripod: &Tripod, handle: Handle) {
    let (Some(axis), Some(tip)) = (handle.axis(), tripod.tip(handle)) else { return };
    let (middle, lens) = (tripod.middle(), &tripod.lens);
    let way = FAR * (tip - middle).normalize();
    let leads_away = axis.dot(lens.forward);
    let horizon = |direction| lens.pixel(lens.eye + direction);
    let end = |sign: f32| -> Vec2 {
        if sign * leads_away > 1e-3 { horizon(sign * axis) } else { middle + sign * way }
    };
    let ends = [end(-1.0), end(1.0)].map(|pixel| frame.point(pixel));
    painter.line_segment(ends, Stroke::new(1.0, color(handle).gamma_multiply(0.8)));
}

fn draw_ball(painter: &Painter, frame: &Viewport, ball: &Ball, shown: &Shown) {
    let Movable::Direction(direction) = &shown.movable else { return };
    let unit = direction.value.normalize();
    let (middle, knob) = (frame.point(ball.middle()), frame.point(ball.knob(unit)));
    let radius = ball.radius() / frame.scale;
    for (width, color) in [(3.0, RIM), (1.0, PALE)] {
        painter.circle_stroke(middle, radius, Stroke::new(width, color.gamma_multiply(0.6)));
    }
    let is_lit = shown.lit.is_some();
    let color = if is_lit { LIT } else { ACCENT };
    let color = if ball.is_behind(unit) { color.gamma_multiply(0.6) } else { color };
    if let Some(Movable::Direction(from)) = &shown.from {
        let start = frame.point(ball.knob(from.value.normalize()));
        painter.circle_stroke(start, MIDDLE, Stroke::new(1.5, PALE));
    }
    // The arrow goes as the light does: from the knob.
    if knob.distance(middle) > 2.0 * GAP {
        draw_arrow(painter, knob, middle, color, false);
    }
    painter.circle(knob, if is_lit { 8.0 } else { 7.0 }, color, Stroke::new(1.5, RIM));
}

/// What a handle does, or what the hand has done with it.
fn words(ui: &Ui, shown: &Shown) -> Option<[String; 2]> {
    let grip = shown.lit?;
    let (name, value) = match &shown.movable {
        Movable::Place(place) => (place.name.as_str(), place.points[0].1),
        Movable::Direction(direction) => ("direction", direction.value),
    };
    let how = match grip {
        Grip::Of(Handle::X) => "along x",
        Grip::Of(Handle::Y) => "along y",
        Grip::Of(Handle::Z) => "along z",
        Grip::Of(Handle::Plane) => "parallel to the screen",
        Grip::Knob => "direction of the light",
    };
    let control = ui.ctx().format_modifiers(Modifiers::COMMAND);
    Some(match shown.from {
        None => [format!("drag {how}"), format!("changes {name}")],
        Some(_) => {
            let [x, y, z] = value.to_array();
            [format!("{name}  {x} {y} {z}"), format!("{control} steps of 0.1   Esc cancels")]
        }
    })
}

fn say(painter: &Painter, at: Pos2, area: Rect, lines: &[String; 2]) {
    let [strong, weak] = lines;
    let strong = painter.layout_no_wrap(strong.clone(), FontId::monospace(12.0), Color32::from_gray(235));
    let weak = painter.layout_no_wrap(weak.clone(), FontId::proportional(11.0), Color32::from_gray(170));
    let size = vec2(strong.size().x.max(weak.size().x), strong.size().y + weak.size().y + 1.0);
    let plate = Align2::LEFT_TOP.anchor_size(at, size + vec2(16.0, 10.0));
    let room = area.shrink(4.0);
    let inside = plate.min.clamp(room.min, (room.max - plate.size()).max(room.min));
    let plate = Rect::from_min_size(inside, plate.size());
    painter.rect_filled(plate, 6.0, Color32::from_black_alpha(190));
    let text = plate.min + vec2(8.0, 5.0);
    let below = text + vec2(0.0, strong.size().y + 1.0);
    painter.galley(text, strong, Color32::WHITE);
    painter.galley(below, weak, Color32::WHITE);
}

fn color(handle: Handle) -> Color32 {
    match handle {
        Handle::X => X,
        Handle::Y => Y,
        Handle::Z => Z,
        Handle::Plane => PALE,
    }
}
