//! The gallery: scenes, textures and shapes as pictures, to be found by a part of their names or captions.
//!
//! In: the messages of a thread. Out: commands to that thread, and the author's choice.

mod categories;
mod details;
mod query;
mod tile;

use std::collections::BTreeMap;
use std::path::{Path, PathBuf};
use std::sync::Arc;

use egui::{Color32, Frame, Id, Modal, TextureHandle, Ui, Vec2};

pub use self::categories::{Category, by_category, stepped};
use self::query::Query;
use super::inspector::example;
use super::scenes::{full_name, neighbours, stem};
use super::{Actions, Leaving, Panel};
use crate::edit::Edit;
use crate::engine::thumbnails::{Item, Subject, Thumbnail, ThumbnailCommand, ThumbnailEvent};
use crate::outline::{NodeKind, Role};

/// Points: how wide the sheet is at most, and what stays free around it.
const WIDTH: f32 = 1240.0;
const AROUND: Vec2 = Vec2::new(72.0, 80.0);

/// What there is to see, and who looks at it.
#[derive(Default)]
pub struct Gallery {
    /// None while it is closed.
    query: Option<Query>,
    items: Vec<Item>,
    pictures: BTreeMap<Subject, TileImage>,
    wishes: Vec<ThumbnailCommand>,
}

/// What came of a picture.
enum TileImage {
    /// It is a texture, too, once it was looked at.
    Picture(Arc<Thumbnail>, Option<TextureHandle>),
    /// Why there is none.
    Failure(String),
}

/// What the author has chosen.
enum Action {
    Close,
    Open(PathBuf),
    /// One more object, by its shape.
    Add(String),
}

impl Gallery {
    pub fn is_open(&self) -> bool {
        self.query.is_some()
    }

    /// Another thread takes the place of the one before, and other textures that of those before.
    pub fn begin_again(&mut self) {
        self.pictures.clear();
        if let Some(query) = &mut self.query {
            query.begin_again();
        }
    }

    fn close(&mut self) {
        self.query = None;
        self.wishes.push(ThumbnailCommand::Draw { subjects: vec![], seen: 0, size: [1; 2] });
    }
}

impl Panel {
    /// Takes a message of the thread of the thumbnails.
    pub fn receive_thumbnails(&mut self, news: ThumbnailEvent) {
        let Gallery { items, pictures, .. } = &mut self.gallery;
        match news {
            ThumbnailEvent::Catalog(catalog) => *items = catalog,
            ThumbnailEvent::Picture(subject, Err(mistakes)) => {
                drop(pictures.insert(subject, TileImage::Failure(mistakes)))
            }
            ThumbnailEvent::Picture(subject, Ok(image)) => {
                let known = pictures.get(&subject);
                if !matches!(known, Some(TileImage::Picture(known, _)) if Arc::ptr_eq(known, &image)) {
                    pictures.insert(subject, TileImage::Picture(image, None));
                }
            }
        }
    }

    pub(super) fn toggle_gallery(&mut self) {
        if self.gallery.is_open() {
            return self.gallery.close();
        }
        self.scenes = neighbours(&self.scene);
        self.gallery.query = Some(Query::default());
    }

    /// Shows it, if it is open; what to ask of the thread of the thumbnails.
    pub(super) fn gallery(&mut self, ui: &Ui, actions: &mut Actions) -> Vec<ThumbnailCommand> {
        if let Some(mut query) = self.gallery.query.take() {
            if query.is_new() {
                let list = self.all_that_is_there();
                self.gallery.wishes.push(list);
            }
            let Gallery { items, pictures, wishes, .. } = &mut self.gallery;
            let id = Id::unique("gallery");
            let area = Modal::default_area(id).fade_in(false).accessible_name("gallery");
            let modal = Modal::new(id).area(area).backdrop_color(Color32::from_black_alpha(70));
            let frame = Frame::popup(ui.style()).inner_margin(16.0);
            let room = ui.ctx().content_rect().size() - AROUND;
            let shown = modal.frame(frame).show(ui.ctx(), |ui| {
                ui.set_max_size(room.min(Vec2::new(WIDTH, f32::INFINITY)).max(Vec2::splat(100.0)));
                ui.set_min_size(ui.max_rect().size());
                query.show(ui, items, pictures)
            });
            wishes.extend(query.wish());
            self.gallery.query = Some(query);
            if shown.inner.is_some() || shown.should_close() {
                self.gallery.close();
            }
            match shown.inner {
                Some(Action::Open(scene)) if scene != self.scene => self.leave(Leaving::Open(scene)),
                Some(Action::Add(shape)) => self.add_object(&shape, actions),
                _ => {}
            }
        }
        std::mem::take(&mut self.gallery.wishes)
    }

    /// Asks for the scenes that the menu has, too, and for all that this scene could name.
    fn all_that_is_there(&self) -> ThumbnailCommand {
        let here = self.scenes.iter().map(|path| (path.clone(), stem(path)));
        let elsewhere = self.recent.iter().map(|path| (path.clone(), full_name(path)));
        let folder = self.scene.parent().unwrap_or(Path::new("")).to_owned();
        ThumbnailCommand::List { folder, scenes: here.chain(elsewhere).collect() }
    }

    fn add_object(&mut self, shape: &str, actions: &mut Actions) {
        let item = match example(&self.disk, &self.scene, Role::Solid, shape) {
            Ok(item) => item,
            Err(why) => {
                self.notice = Some(why);
                return;
            }
        };
        let Some((outline, _)) = &self.outline else { return };
        let Some(objects) = outline.nodes.iter().find(|node| node.kind == NodeKind::Objects) else { return };
        let (list, index) = (objects.path.clone(), objects.nodes.len());
        actions.edits.push(Edit::Insert { list, index, item });
    }
}
