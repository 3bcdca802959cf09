//! Two views beside each other, and the divider between them that a hand can move.

use egui::accesskit::Role;
use egui::{
    Align2, Area, Color32, CornerRadius, CursorIcon, Event, Id, Order, Pos2, Rect, Response, Sense, Ui,
    WidgetInfo, vec2,
};

use super::bar::view_menu;
use super::{ACCENT, Panel};
use crate::frame::{Split, View};

/// Points to each side in which a hand takes the divider.
const REACH: f32 = 6.0;
/// The nearest that it comes to the edges, as a share of the picture's width.
const NEAREST: f32 = 0.02;

/// Where it is, and what lies right of it; on or off.
pub struct Divider {
    is_on: bool,
    split: Split,
}

impl Default for Divider {
    fn default() -> Self {
        Self { is_on: false, split: Split { view: View::Normal, at: 0.5 } }
    }
}

impl Divider {
    pub fn split(&self) -> Option<Split> {
        self.is_on.then_some(self.split)
    }

    /// `view` is what the left shows: the right begins with another one.
    pub fn toggle(&mut self, view: View) {
        self.is_on = !self.is_on;
        if self.is_on && self.split.view == view {
            self.split.view = if view == View::Color { View::Normal } else { View::Color };
        }
    }
}

impl Panel {
    /// Moves the divider over the picture at `area` as the hand says, and draws it with the views' names.
    pub(super) fn divide(&mut self, ui: &mut Ui, area: Rect) {
        let Some(split) = self.divider.split() else { return };
        let points = ui.ctx().pixels_per_point();
        let pixels = (area.width() * points).round() as u32;
        let place = |split: Split| area.min.x + split.column(pixels) as f32 / points;
        let x = place(split);
        let band = Rect::from_x_y_ranges(x - REACH..=x + REACH, area.y_range());
        let response = ui.interact(band, Id::unique("divider"), Sense::click_and_drag());
        let response = response.on_hover_and_drag_cursor(CursorIcon::ResizeHorizontal);
        if response.double_clicked() {
            self.divider.split.at = 0.5;
        } else if let Some(hand) = hand(ui, &response) {
            let share = (hand.x - area.min.x) / area.width().max(1.0);
            self.divider.split.at = share.clamp(NEAREST, 1.0 - NEAREST);
        }
        response.widget_info(|| WidgetInfo::labeled(Role::Splitter, true, "divider of the views"));
        let x = place(self.divider.split);
        let color = match (response.is_pointer_button_down_on(), response.hovered()) {
            (true, _) => ACCENT,
            (false, true) => Color32::from_rgb(165, 195, 250),
            (false, false) => Color32::from_gray(235),
        };
        let line = |half: f32| Rect::from_x_y_ranges(x - half..=x + half, area.y_range());
        let painter = ui.painter();
        painter.rect_filled(line(1.5), CornerRadius::ZERO, Color32::from_black_alpha(150));
        painter.rect_filled(line(0.5), CornerRadius::ZERO, color);
        let grip = Rect::from_center_size(line(0.5).center(), vec2(7.0, 34.0));
        painter.rect_filled(grip.expand(1.0), 4.0, Color32::from_black_alpha(150));
        painter.rect_filled(grip, 3.0, color);
        let side = |name: &str, pivot: Align2, away: f32| {
            let place = egui::pos2(x + away, area.max.y - 10.0);
            let side = Area::new(Id::unique(name)).order(Order::Background).pivot(pivot);
            side.fixed_pos(place).constrain_to(area)
        };
        let (left, right) = (&mut self.view, &mut self.divider.split.view);
        for (name, pivot, away, view) in [
            ("left view", Align2::RIGHT_BOTTOM, -10.0, left),
            ("right view", Align2::LEFT_BOTTOM, 10.0, right),
        ] {
            side(name, pivot, away).show(ui.ctx(), |ui| view_menu(ui, name, view));
        }
    }
}

/// Where the hand is that drags, and at the end where it has let go: since then it may have moved on.
fn hand(ui: &Ui, response: &Response) -> Option<Pos2> {
    let let_go = |event: &Event| match event {
        Event::PointerButton { pos, pressed: false, .. } => Some(*pos),
        _ => None,
    };
    if response.drag_stopped() {
        return ui.input(|input| input.events.iter().find_map(let_go));
    }
    response.interact_pointer_pos().filter(|_| response.dragged())
}
