//! The picture's place: the camera under the mouse, and what is said over the picture.

use egui::accesskit::Role;
use egui::{Color32, PointerButton, Sense, TextureId, Ui, WidgetInfo};
use glam::Vec2;

use super::{Panel, slowness};
use crate::engine::messages::ViewRequest;
use crate::panel::camera;

impl Panel {
    pub(super) fn picture(&mut self, ui: &mut Ui, picture: Option<TextureId>) -> ViewRequest {
        let (area, response) = ui.allocate_exact_size(ui.available_size(), Sense::click_and_drag());
        response.widget_info(|| WidgetInfo::labeled(Role::Image, true, "picture"));
        if picture.is_none() && self.report.is_none() {
            let font = egui::FontId::proportional(16.0);
            ui.painter().text(area.center(), egui::Align2::CENTER_CENTER, "compiling…", font, Color32::GRAY);
        }
        let holds = self.take_handles(ui, &response, area);
        if !holds {
            self.move_camera(ui, &response, area);
        }
        let points = ui.ctx().pixels_per_point();
        if let Some(pointer) = response.interact_pointer_pos().filter(|_| !holds) {
            self.mouse = [(pointer.x - area.min.x) * points, (pointer.y - area.min.y) * points];
        }
        if response.clicked()
            && !holds
            && let Some(pointer) = response.interact_pointer_pos()
        {
            let at = (pointer - area.min) * points;
            self.click(ui, area, [at.x.max(0.0) as u32, at.y.max(0.0) as u32]);
        }
        self.show_choice(ui, area);
        self.draw_handles(ui, &response, area);
        self.divide(ui, area);
        self.magnify(ui, area, response.hover_pos(), picture);
        self.mistakes(ui, area);
        let pixels = |points_long: f32| (points_long * points).round() as u32;
        let size = [pixels(area.width()), pixels(area.height())];
        if let Some(slow) = &self.slow {
            slowness::show(ui, area, size, slow);
        }
        let look = ViewRequest {
            corner: [pixels(area.min.x), pixels(area.min.y)],
            size,
            camera: self.camera,
            view: self.view,
            split: self.divider.split(),
            reach: self.gauge.reach(),
            mouse: self.mouse,
            clock: self.clock,
            gizmos: self.gizmos,
            asks: self.asks(),
        };
        let ViewRequest { corner, mouse, asks, gizmos, .. } = look;
        if self.look.is_some_and(|before| ViewRequest { corner, mouse, asks, gizmos, ..before } != look) {
            self.picking.forget();
        }
        self.look = Some(look);
        look
    }

    fn move_camera(&mut self, ui: &Ui, response: &egui::Response, area: egui::Rect) {
        let Some(home) = self.home else { return };
        let mut moved = self.camera.unwrap_or(home);
        let before = moved;
        let drag = response.drag_delta() / area.height().max(1.0);
        let by = Vec2::new(drag.x, drag.y);
        let shift = ui.input(|input| input.modifiers.shift);
        if response.dragged_by(PointerButton::Primary) && !shift {
            camera::orbit(&mut moved, by);
        } else if response.dragged() {
            camera::pan(&mut moved, by);
        }
        if response.hovered() {
            let (scroll, pinch) = ui.input(|input| (input.smooth_scroll_delta.y, input.zoom_delta()));
            let amount = scroll * 0.004 + pinch.ln();
            if amount != 0.0 {
                camera::zoom(&mut moved, amount);
            }
        }
        if moved != before {
            self.camera = Some(moved);
        }
    }
}
