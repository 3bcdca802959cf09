//! What the author looks for in the gallery, and the sheet on which it is found.

use std::collections::BTreeMap;

use egui::{
    Align, Button, Frame, Id, Key, Layout, Margin, Modifiers, Rect, Response, RichText, ScrollArea, TextEdit,
    Ui, UiBuilder,
};

use super::categories::{CATEGORIES, Category, by_category, stepped};
use super::{Action, TileImage, details, tile};
use crate::engine::thumbnails::{Item, Subject, ThumbnailCommand};

/// Points: between tiles, the field for words, and what is known of a tile.
const GAP: f32 = 10.0;
const SEARCH: std::ops::RangeInclusive<f32> = 90.0..=300.0;
const DETAILS: std::ops::RangeInclusive<f32> = 180.0..=300.0;

/// What the author looks for.
#[derive(Default)]
pub struct Query {
    text: String,
    /// None for all.
    category: Option<Category>,
    marked: Option<Subject>,
    /// The text that was copied last.
    copied: Option<String>,
    /// Whether somebody was asked what there is.
    is_listed: bool,
    /// What is on the screen, then all else; how many are on the screen; and the pixels of a picture.
    wanted: (Vec<Subject>, usize, [u32; 2]),
    /// The same, as it was asked for last.
    wished: (Vec<Subject>, usize, [u32; 2]),
}

impl Query {
    /// Whether nobody was asked yet what there is.
    pub fn is_new(&mut self) -> bool {
        !std::mem::replace(&mut self.is_listed, true)
    }

    pub fn begin_again(&mut self) {
        self.is_listed = false;
        self.wished = Default::default();
    }

    /// The pictures to ask for, if they are others than before.
    pub fn wish(&mut self) -> Option<ThumbnailCommand> {
        let (subjects, seen, size) = self.wanted.clone();
        let is_new = self.wanted != self.wished;
        self.wished.clone_from(&self.wanted);
        is_new.then_some(ThumbnailCommand::Draw { subjects, seen, size })
    }

    pub fn show(
        &mut self,
        ui: &mut Ui,
        items: &[Item],
        pictures: &mut BTreeMap<Subject, TileImage>,
    ) -> Option<Action> {
        let step = self.step(ui);
        let mut action = None;
        let field = ui.horizontal(|ui| {
            let field = self.head(ui);
            ui.with_layout(Layout::right_to_left(Align::Center), |ui| {
                let cross = Button::new(RichText::new("×").size(18.0)).frame(false);
                let cross = ui.add(cross).on_hover_text("close (Escape)");
                if cross.accessible_name("close the gallery").clicked() {
                    action = Some(Action::Close);
                }
            });
            field
        });
        let field = field.inner;
        if field.changed() {
            self.marked = None;
        }
        ui.separator();
        let room = ui.available_rect_before_wrap();
        let wide = (0.28 * room.width()).clamp(*DETAILS.start(), *DETAILS.end());
        let (left, right) = room.split_left_right_at_x(room.right() - wide);
        let categories = by_category(items, self.category, &self.text);
        let runs = field.lost_focus() && ui.input(|input| input.key_pressed(Key::Enter));
        if runs && self.marked.is_none() {
            self.marked = categories.iter().flat_map(|(_, of)| of).next().map(|item| item.subject.clone());
        }
        let grid = left.with_max_x(left.right() - GAP);
        let chosen = self.grid(&mut within(ui, grid), &categories, pictures, step);
        let chosen = chosen.or_else(|| self.marked.clone().filter(|_| runs));
        match chosen {
            Some(Subject::Scene(path)) => action = Some(Action::Open(path)),
            Some(subject) => self.marked = Some(subject),
            None => {}
        }
        self.look_further(ui, items);
        let marked = items.iter().find(|item| Some(&item.subject) == self.marked.as_ref());
        let image_of = marked.and_then(|item| pictures.get(&item.subject));
        let told = details::show(&mut within(ui, right), marked, image_of, &mut self.copied);
        action.or(told)
    }

    /// Title, search and categories; the field in which words are typed.
    fn head(&mut self, ui: &mut Ui) -> Response {
        ui.label(RichText::new("Gallery").strong().size(16.0));
        ui.add_space(6.0);
        // Before it is laid out, or it would miss what a quick hand types in its first frame.
        let id = Id::unique("gallery text");
        ui.memory_mut(|memory| memory.request_focus(id));
        let width = (ui.available_width() - 330.0).clamp(*SEARCH.start(), *SEARCH.end());
        let field = TextEdit::singleline(&mut self.text).hint_text("search names and captions");
        let frame = Frame::NONE
            .fill(ui.visuals().extreme_bg_color)
            .stroke(ui.visuals().widgets.noninteractive.bg_stroke)
            .corner_radius(5)
            .inner_margin(Margin::symmetric(8, 4));
        let field = ui.add(field.frame(frame).desired_width(width).id(id));
        let field = field.accessible_name("find in the gallery");
        ui.add_space(6.0);
        ui.selectable_value(&mut self.category, None, "All");
        for (category, title) in CATEGORIES {
            let name = title.split(' ').next().unwrap_or(title);
            ui.selectable_value(&mut self.category, Some(category), name);
        }
        field
    }

    /// How far the arrow keys go, across and down, if any was pressed.
    fn step(&self, ui: &Ui) -> Option<[isize; 2]> {
        let pressed = |key| isize::from(ui.input_mut(|input| input.consume_key(Modifiers::NONE, key)));
        let down = pressed(Key::ArrowDown) - pressed(Key::ArrowUp);
        // Until a tile is marked, these two are for the text.
        let across = match self.marked {
            Some(_) => pressed(Key::ArrowRight) - pressed(Key::ArrowLeft),
            None => 0,
        };
        (across != 0 || down != 0).then_some([across, down])
    }

    /// Lays out the tiles, category by category; which was clicked.
    fn grid(
        &mut self,
        ui: &mut Ui,
        categories: &[(&str, Vec<&Item>)],
        pictures: &mut BTreeMap<Subject, TileImage>,
        step: Option<[isize; 2]>,
    ) -> Option<Subject> {
        let mut clicked = None;
        let mut seen = vec![];
        if categories.is_empty() {
            ui.label(RichText::new("No name and no caption matches.").weak());
        }
        // The bar that scrolls lies beside them, and makes none of them narrower.
        let room = ui.available_width() - 2.0 * GAP;
        let columns = ((room + GAP) / (tile::LEAST + GAP)).floor().max(1.0);
        let width = ((room + GAP) / columns - GAP).floor();
        let rows: Vec<&[&Item]> =
            categories.iter().flat_map(|(_, items)| items.chunks(columns as usize)).collect();
        if let Some(step) = step {
            self.marked = stepped(&rows, self.marked.as_ref(), step);
        }
        ScrollArea::vertical().id_salt("tiles").auto_shrink([false, false]).show(ui, |ui| {
            ui.spacing_mut().item_spacing = egui::vec2(GAP, GAP);
            for (title, items) in categories {
                ui.label(RichText::new(format!("{title}  {}", items.len())).weak());
                for row in items.chunks(columns as usize) {
                    ui.horizontal(|ui| {
                        for item in row {
                            let is_marked = self.marked.as_ref() == Some(&item.subject);
                            let image_of = pictures.get_mut(&item.subject);
                            let tile = tile::show(ui, item, image_of, width, is_marked);
                            if ui.is_rect_visible(tile.rect) {
                                seen.push(item.subject.clone());
                            }
                            if is_marked && step.is_some() {
                                tile.scroll_to_me(None);
                            }
                            if tile.clicked() {
                                clicked = Some(item.subject.clone());
                            }
                        }
                    });
                }
            }
        });
        self.wanted.0 = seen;
        clicked
    }

    /// Asks for pictures of all that is not on the screen, too, after what is.
    fn look_further(&mut self, ui: &Ui, items: &[Item]) {
        let (subjects, seen, size) = &mut self.wanted;
        *seen = subjects.len();
        let others = items.iter().map(|item| &item.subject).filter(|other| !subjects.contains(other));
        let others: Vec<Subject> = others.cloned().collect();
        subjects.extend(others);
        let points = ui.ctx().pixels_per_point();
        *size = [tile::PICTURE.x, tile::PICTURE.y].map(|side| (side * points).round() as u32);
    }
}

/// A part of the sheet.
fn within(ui: &mut Ui, area: Rect) -> Ui {
    ui.new_child(UiBuilder::new().max_rect(area).layout(Layout::top_down(Align::LEFT)))
}
