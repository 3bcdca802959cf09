//! The command palette: a few letters of a command, a view or a scene, and Enter.

use std::path::PathBuf;

use egui::accesskit::Role;
use egui::{
    Align, Align2, Color32, Key, Layout, Modal, Modifiers, RichText, ScrollArea, Sense, TextEdit, Ui,
    WidgetInfo,
};

use super::commands::keys_of;
use super::scenes::{full_name, stem};
use super::{Actions, Leaving, Panel};
use crate::frame::View;
use crate::panel::commands::{COMMANDS, Command};

/// Points.
const WIDTH: f32 = 540.0;
const LINE: f32 = 24.0;
const NAMES: f32 = 160.0;

/// What was typed, while it is open.
#[derive(Default)]
pub struct Palette(Option<Query>);

#[derive(Default)]
struct Query {
    text: String,
    /// Which of the lines that fit is marked.
    marked: usize,
}

/// What can be run.
#[derive(Clone)]
enum Item {
    Command(Command),
    View(View),
    Scene(PathBuf),
    Bookmark(u8),
}

/// An item as it is shown.
struct Line {
    item: Item,
    name: String,
    does: String,
    keys: String,
}

impl Palette {
    pub fn is_open(&self) -> bool {
        self.0.is_some()
    }

    pub fn toggle(&mut self) {
        self.0 = if self.is_open() { None } else { Some(Query::default()) };
    }
}

impl Panel {
    pub(super) fn palette(&mut self, ui: &Ui, actions: &mut Actions) {
        let Some(mut query) = self.palette.0.take() else { return };
        let lines = self.lines(ui);
        let id = egui::Id::unique("palette");
        let area = Modal::default_area(id).fade_in(false).accessible_name("command palette");
        let area = area.anchor(Align2::CENTER_TOP, egui::vec2(0.0, 64.0));
        let modal = Modal::new(id).area(area).backdrop_color(Color32::from_black_alpha(70));
        let shown = modal.show(ui.ctx(), |ui| query.show(ui, lines));
        match shown.inner.clone() {
            Some(item) => self.run(item, ui, actions),
            None if shown.should_close() => {}
            None => self.palette.0 = Some(query),
        }
    }

    fn run(&mut self, item: Item, ui: &Ui, actions: &mut Actions) {
        match item {
            Item::Command(command) => self.perform(command, ui.ctx(), actions),
            Item::View(view) => self.view = view,
            Item::Scene(scene) => self.leave(Leaving::Open(scene)),
            Item::Bookmark(digit) => self.go_to(digit),
        }
    }

    /// All that can be run now.
    fn lines(&self, ui: &Ui) -> Vec<Line> {
        let commands = COMMANDS.iter().filter(|e| e.command != Command::Palette && self.can(e.command));
        let commands = commands.map(|entry| {
            let (name, does, keys) = (entry.name.into(), entry.does.into(), keys_of(ui.ctx(), entry));
            Line { item: Item::Command(entry.command), name, does, keys }
        });
        let line = |item, name, does: &str| Line { item, name, does: does.into(), keys: String::new() };
        let views = View::ALL.iter().filter(|(_, view)| *view != self.view);
        let views = views.map(|(name, view)| line(Item::View(*view), format!("View {name}"), ""));
        let scene =
            |path: &PathBuf, name: String| line(Item::Scene(path.clone()), format!("Open {name}"), "");
        let here = self.scenes.iter().filter(|path| **path != self.scene);
        let here = here.map(|path| scene(path, stem(path)));
        let elsewhere = self.recent.iter().map(|path| scene(path, full_name(path)));
        let bookmarks = self.settings.bookmarks(&self.scene).iter().map(|known| {
            let (name, keys) = (format!("Go to {}", known.title()), known.digit.to_string());
            Line { item: Item::Bookmark(known.digit), name, does: String::new(), keys }
        });
        commands.chain(bookmarks).chain(views).chain(here).chain(elsewhere).collect()
    }
}

impl Query {
    /// The item that was chosen.
    fn show(&mut self, ui: &mut Ui, mut lines: Vec<Line>) -> Option<Item> {
        ui.set_width(WIDTH);
        let pressed = |ui: &Ui, key| ui.input_mut(|input| input.consume_key(Modifiers::NONE, key));
        // The text field would take these keys for itself.
        let down = usize::from(pressed(ui, Key::ArrowDown));
        let up = usize::from(pressed(ui, Key::ArrowUp));
        let hint = "a command, a view or a scene";
        let field = TextEdit::singleline(&mut self.text).hint_text(hint).desired_width(f32::INFINITY);
        let frame = egui::Frame::NONE.inner_margin(egui::Margin::symmetric(8, 5));
        // Before it is laid out, or it would miss what a quick hand types in its first frame.
        let id = egui::Id::unique("palette text");
        ui.memory_mut(|memory| memory.request_focus(id));
        let field = ui.add(field.frame(frame).id(id)).accessible_name("find a command");
        let runs = field.lost_focus() && ui.input(|input| input.key_pressed(Key::Enter));
        if field.changed() {
            self.marked = 0;
        }
        ui.separator();
        lines.retain(|line| fuzzy_score(&line.name, &self.text).is_some());
        lines.sort_by_key(|line| fuzzy_score(&line.name, &self.text));
        self.marked = (self.marked + down).min(lines.len().saturating_sub(1)).saturating_sub(up);
        let mut chosen = lines.get(self.marked).filter(|_| runs).map(|line| line.item.clone());
        if lines.is_empty() {
            ui.label(RichText::new("Nothing matches.").weak());
        }
        ui.spacing_mut().item_spacing.y = 1.0;
        ScrollArea::vertical().max_height(12.0 * LINE).auto_shrink([false, true]).show(ui, |ui| {
            for (i, line) in lines.iter().enumerate() {
                let response = line.show(ui, i == self.marked);
                if response.hovered() && ui.input(|input| input.pointer.is_moving()) {
                    self.marked = i;
                }
                if i == self.marked && (down + up > 0 || field.changed()) {
                    response.scroll_to_me(None);
                }
                if response.clicked() {
                    chosen = Some(line.item.clone());
                }
            }
        });
        chosen
    }
}

impl Line {
    fn show(&self, ui: &mut Ui, is_marked: bool) -> egui::Response {
        let size = egui::vec2(ui.available_width(), LINE);
        let (area, response) = ui.allocate_exact_size(size, Sense::click());
        response.widget_info(|| WidgetInfo::selected(Role::ListBoxOption, true, is_marked, &self.name));
        if is_marked {
            ui.painter().rect_filled(area, 5.0, ui.visuals().selection.bg_fill);
        }
        let inside = egui::UiBuilder::new().max_rect(area.shrink2(egui::vec2(8.0, 0.0)));
        let mut ui = ui.new_child(inside.layout(Layout::left_to_right(Align::Center)));
        let quiet = |text: &str| egui::Label::new(RichText::new(text).weak().size(11.0)).selectable(false);
        let name = RichText::new(&self.name);
        let name = if is_marked { name.strong() } else { name };
        ui.add(egui::Label::new(name).selectable(false));
        ui.add_space((area.min.x + NAMES - ui.cursor().min.x).max(0.0));
        ui.with_layout(Layout::right_to_left(Align::Center), |ui| {
            ui.add(quiet(&self.keys));
            ui.with_layout(Layout::left_to_right(Align::Center), |ui| ui.add(quiet(&self.does).truncate()));
        });
        response
    }
}

/// How many words of `wanted` begin no word of `name`; None where it does not have them all somewhere.
pub fn fuzzy_score(name: &str, wanted: &str) -> Option<usize> {
    let (name, wanted) = (name.to_lowercase(), wanted.to_lowercase());
    let begins = |word: &str| name.split([' ', '_']).any(|own| own.starts_with(word));
    let mut words = wanted.split_whitespace();
    words.try_fold(0, |count, word| name.contains(word).then_some(count + usize::from(!begins(word))))
}
