//! A picture with a name and a caption under it.

use std::sync::Arc;

use egui::accesskit::Role;
use egui::text::{LayoutJob, TextWrapping};
use egui::{
    Color32, ColorImage, FontId, Galley, Image, Rect, Response, Sense, Stroke, TextureOptions, Ui, Vec2,
    WidgetInfo,
};

use super::TileImage;
use crate::engine::thumbnails::Item;
use crate::panel::ACCENT;

/// Points: the least width of a tile, the size of its picture where it is a little wider, its two lines.
pub const LEAST: f32 = 158.0;
pub const PICTURE: Vec2 = Vec2::new(176.0, 132.0);
const WORDS: f32 = 44.0;
const INSIDE: f32 = 6.0;

/// Lays out a tile that is so wide.
pub fn show(
    ui: &mut Ui,
    item: &Item,
    image_of: Option<&mut TileImage>,
    width: f32,
    is_marked: bool,
) -> Response {
    let picture = Vec2::new(width, width * PICTURE.y / PICTURE.x);
    let (area, response) = ui.allocate_exact_size(picture + Vec2::new(0.0, WORDS), Sense::click());
    response.widget_info(|| WidgetInfo::selected(Role::ListBoxOption, true, is_marked, &item.name));
    if !ui.is_rect_visible(area) {
        return response;
    }
    let visuals = ui.visuals();
    let fill = if response.hovered() { visuals.widgets.hovered.weak_bg_fill } else { visuals.faint_bg_color };
    let (strong, weak) = (visuals.strong_text_color(), visuals.weak_text_color());
    ui.painter().rect_filled(area, 8.0, fill);
    let place = Rect::from_min_size(area.min, picture).shrink(INSIDE);
    let failure = show_picture(ui, item, image_of, place);
    let at = area.left_top() + Vec2::new(INSIDE + 2.0, picture.y - 1.0);
    let room = width - 2.0 * INSIDE - 4.0;
    let name = line(ui, &item.name, 13.0, strong, room);
    ui.painter().galley(at, name, strong);
    let caption = if failure.is_some() { "has mistakes" } else { &item.caption };
    ui.ctx().accesskit_node_builder(response.id, |tile| tile.set_description(caption));
    let color = if failure.is_some() { ui.visuals().error_fg_color } else { weak };
    let caption = line(ui, caption, 11.0, color, room);
    ui.painter().galley(at + Vec2::new(0.0, 18.0), caption, color);
    if is_marked {
        ui.painter().rect_stroke(area, 8.0, Stroke::new(2.0, ACCENT), egui::StrokeKind::Inside);
    }
    match failure {
        Some(why) => response.on_hover_ui(|ui| {
            ui.set_max_width(620.0);
            ui.monospace(why);
        }),
        None if item.caption.is_empty() => response,
        None => response.on_hover_text(&item.caption),
    }
}

/// The picture, or what stands in its place; why there is none, if it failed.
fn show_picture(ui: &Ui, item: &Item, image_of: Option<&mut TileImage>, place: Rect) -> Option<String> {
    if let Some(TileImage::Picture(image, texture)) = image_of {
        let new = || {
            let size = image.size.map(|side| side as usize);
            let image = ColorImage::from_rgba_unmultiplied(size, &image.rgba);
            ui.ctx().load_texture(&item.name, image, TextureOptions::LINEAR)
        };
        let texture = texture.get_or_insert_with(new);
        Image::from_texture((texture.id(), place.size())).corner_radius(5).paint_at(ui, place);
        return None;
    }
    let visuals = ui.visuals();
    ui.painter().rect_filled(place, 5.0, visuals.extreme_bg_color);
    match image_of {
        Some(TileImage::Failure(why)) => {
            let color = visuals.error_fg_color;
            ui.painter().circle_filled(place.center(), 15.0, color.gamma_multiply(0.25));
            mark(ui, place, "!", color);
            Some(why.clone())
        }
        _ => {
            mark(ui, place, "…", visuals.weak_text_color());
            None
        }
    }
}

fn mark(ui: &Ui, place: Rect, sign: &str, color: Color32) {
    let font = FontId::proportional(18.0);
    ui.painter().text(place.center(), egui::Align2::CENTER_CENTER, sign, font, color);
}

/// `text` in one line, cut where it is too long.
fn line(ui: &Ui, text: &str, size: f32, color: Color32, width: f32) -> Arc<Galley> {
    let mut job = LayoutJob::simple_singleline(text.to_owned(), FontId::proportional(size), color);
    job.wrap = TextWrapping::truncate_at_width(width);
    ui.painter().layout_job(job)
}
