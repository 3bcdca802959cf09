//! What is said over a picture that takes long, which is no mistake: how far it is, and what makes it faster.

use std::time::Duration;

use egui::accesskit::Role;
use egui::{Align2, Area, Color32, Frame, Id, ProgressBar, Rect, RichText, Ui, vec2};

use super::style::PALE;
use crate::engine::messages::Slow;

const WIDTH: f32 = 310.0;
const HELP: &str = "You can continue to work. The view `cost` shows which pixels are slow. These make it \
                    faster: fewer shadow_samples, max_bounces or objects, bounds around objects, or a \
                    smaller window.";

/// Shows it in the upper right corner of `area`, in which a picture of `size` pixels is drawn.
pub fn show(ui: &Ui, area: Rect, size: [u32; 2], slow: &Slow) {
    let width = WIDTH.min(area.width() - 48.0).max(80.0);
    Area::new(Id::unique("slowness"))
        .accessible_name("slow drawing")
        .role(Role::Status)
        .order(egui::Order::Background)
        .fixed_pos(area.right_top() + vec2(-10.0, 10.0))
        .pivot(Align2::RIGHT_TOP)
        .show(ui.ctx(), |ui| {
            let frame = Frame::NONE.fill(Color32::from_black_alpha(215)).corner_radius(6);
            frame.stroke((1.0, Color32::from_gray(110))).inner_margin(12.0).show(ui, |ui| {
                ui.set_width(width);
                ui.label(RichText::new("Drawing is slow.").color(Color32::WHITE).strong());
                let time = words(slow.sample);
                let [x, y] = size;
                let told = match slow.resolution < 1.0 {
                    true => {
                        format!("One sample of {x}x{y} takes about {time}. A coarse picture comes first:")
                    }
                    false => {
                        format!("One sample of {x}x{y} takes about {time}. Progress:")
                    }
                };
                ui.label(RichText::new(told).color(PALE));
                let bar = ProgressBar::new(slow.done).desired_width(width).desired_height(6.0);
                ui.add(bar).accessible_name("share of the sample");
                ui.label(RichText::new(HELP).color(PALE));
            });
        });
}

/// "90 seconds", "3 minutes", "2 hours".
fn words(time: Duration) -> String {
    let seconds = time.as_secs_f64();
    let (number, unit) = match seconds {
        s if s < 100.0 => (s, "seconds"),
        s if s < 100.0 * 60.0 => (s / 60.0, "minutes"),
        s => (s / 3600.0, "hours"),
    };
    format!("{number:.0} {unit}")
}
