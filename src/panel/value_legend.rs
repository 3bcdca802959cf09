//! What the view `value` shows: which number, and what its colors mean.

use egui::{
    Align2, Area, Color32, ComboBox, DragValue, FontId, Id, Mesh, Order, Pos2, Rect, Shape, Stroke, Ui,
};

use super::{Actions, Panel};
use crate::engine::builder_messages;
use crate::frame::View;
use crate::ir::Measure;

/// BELOW, the color of 0 and ABOVE, as shaders/number_color.wgsl has them.
const COLORS: [Color32; 3] = [Color32::from_rgb(20, 71, 184), Color32::WHITE, Color32::from_rgb(191, 31, 26)];
/// Points.
const SIZE: egui::Vec2 = egui::vec2(220.0, 14.0);

/// The number that the author wants to see.
pub struct ValueLegend {
    name: String,
    /// Where its colors end.
    reach: f32,
    /// What the builder was asked for last.
    asked: Option<String>,
}

impl Default for ValueLegend {
    fn default() -> Self {
        Self { name: PATTERN.into(), reach: 1.0, asked: None }
    }
}

/// What is shown unless the author says otherwise.
const PATTERN: &str = "pattern";

impl ValueLegend {
    pub fn reach(&self) -> f32 {
        self.reach
    }

    /// Another builder knows nothing yet.
    pub fn begin_again(&mut self) {
        self.asked = None;
    }
}

impl Panel {
    /// Asks for the number if somebody sees it, and explains its colors over the picture at `area`.
    pub(super) fn measure(&mut self, ui: &Ui, area: Rect, actions: &mut Actions) {
        let beside = self.divider.split().map(|split| split.view);
        let is_seen = self.view == View::Value || beside == Some(View::Value);
        let wanted = is_seen.then(|| self.gauge.name.clone());
        if wanted != self.gauge.asked {
            self.gauge.asked.clone_from(&wanted);
            actions.orders.push(builder_messages::BuilderCommand::Measure(wanted));
        }
        if !is_seen {
            return;
        }
        let place = Area::new(Id::unique("gauge")).order(Order::Background).pivot(Align2::RIGHT_TOP);
        place.fixed_pos(area.right_top() + egui::vec2(-10.0, 10.0)).constrain_to(area).show(ui.ctx(), |ui| {
            let frame = egui::Frame::NONE.fill(Color32::from_black_alpha(170)).corner_radius(6);
            frame.inner_margin(8.0).show(ui, |ui| {
                ui.set_width(SIZE.x);
                ui.horizontal(|ui| self.number_menu(ui));
                ui.add_space(4.0);
                scale(ui, self.gauge.reach);
            });
        });
    }

    /// Which number, and how far its colors go.
    fn number_menu(&mut self, ui: &mut Ui) {
        let Some(compiled) = &self.compiled else { return };
        let ValueLegend { name, reach, .. } = &mut self.gauge;
        if Measure::named(&compiled.scene, name).is_none() {
            *name = PATTERN.into();
        }
        let menu = ComboBox::from_id_salt("number").width(120.0).height(480.0).truncate();
        let shown = menu.selected_text(name.clone()).show_ui(ui, |ui| {
            let declared = compiled.scene.textures.iter().map(|texture| texture.name.as_str());
            for known in Measure::ALL.iter().map(|(known, _)| *known).chain(declared) {
                ui.selectable_value(name, known.to_owned(), known);
            }
        });
        shown.response.accessible_name("number to show");
        let speed = 0.02 * *reach;
        let number = DragValue::new(reach).range(1e-4..=1e5).speed(speed).max_decimals(4).prefix("to ");
        let help = "the largest number that has a color";
        ui.add(number).on_hover_text(help).accessible_name(help);
    }
}

/// The colors from -`reach` to `reach`, with lines at the tenths.
fn scale(ui: &mut Ui, reach: f32) {
    let (bar, _) = ui.allocate_exact_size(SIZE, egui::Sense::hover());
    let mut mesh = Mesh::default();
    for (i, color) in (0_u32..).zip(COLORS) {
        let x = bar.min.x + 0.5 * i as f32 * bar.width();
        mesh.colored_vertex(Pos2::new(x, bar.min.y), color);
        mesh.colored_vertex(Pos2::new(x, bar.max.y), color);
        if i > 0 {
            mesh.add_triangle(2 * i - 2, 2 * i - 1, 2 * i);
            mesh.add_triangle(2 * i - 1, 2 * i, 2 * i + 1);
        }
    }
    ui.painter().add(Shape::mesh(mesh));
    for tenth in -9..=9 {
        let x = bar.center().x + 0.05 * tenth as f32 * bar.width();
        let dark = if tenth == 0 { 255 } else { 90 };
        ui.painter().vline(x, bar.y_range(), Stroke::new(1.0, Color32::from_black_alpha(dark)));
    }
    let (words, _) = ui.allocate_exact_size(egui::vec2(SIZE.x, 12.0), egui::Sense::hover());
    let ends = [
        (words.left_top(), Align2::LEFT_TOP, -reach),
        (words.center_top(), Align2::CENTER_TOP, 0.0),
        (words.right_top(), Align2::RIGHT_TOP, reach),
    ];
    for (place, align, number) in ends {
        let font = FontId::monospace(11.0);
        ui.painter().text(place, align, format!("{number}"), font, Color32::from_gray(225));
    }
}
