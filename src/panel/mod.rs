//! What the author sees and does: the picture, the scene as a tree with all its values, and what is wrong.
//!
//! In: pictures and outlines. Out: a [`Reply`] for each frame. It draws nothing itself and waits for nothing.

mod actions;
mod bar;
mod bookmarks;
mod camera;
mod capture;
mod changing;
mod cheat_sheet;
mod commands;
mod divider;
mod document;
pub mod editor;
mod fields;
mod gallery;
pub mod handles;
mod inspector;
mod leaving;
mod magnifier;
mod mistakes;
pub mod palette;
mod pending;
mod picking;
mod picture;
mod scenes;
mod settings;
mod shader;
mod slowness;
mod style;
mod templates;
mod timings;
mod tree;
mod value_legend;
mod widgets;

use std::path::{Path, PathBuf};
use std::sync::Arc;
use std::time::Instant;

use egui::{TextureId, Ui};

pub use self::actions::Actions;
pub use self::capture::Action as CaptureAction;
pub use self::commands::{COMMANDS, Command};
use self::document::Document;
pub use self::gallery::{Category, by_category, stepped};
pub use self::leaving::Leaving;
pub use self::pending::Pending;
use self::picking::Picking;
pub use self::settings::{Bookmarks, Memory, Settings, Theme, cache, folder, free_digit};
pub use self::style::{ACCENT, apply as apply_style};
pub use self::templates::{new_scene, new_texture};
use crate::compile::Compiled;
use crate::diagnostic::Report;
use crate::engine::{BuilderCommand, Clock, Focus, Picture, Slow, ViewRequest, thumbnails};
use crate::frame::View;
use crate::ir::Camera;
use crate::outline::Outline;
use crate::scene;
use crate::sources::Disk;

/// What is shown, and what the author has chosen.
pub struct Panel {
    scene: PathBuf,
    disk: Disk,
    /// Those of its folder.
    scenes: Vec<PathBuf>,
    /// Those that were open before, and lie elsewhere.
    recent: Vec<PathBuf>,
    /// What is remembered.
    pub settings: Settings,
    adapter: String,
    tab: Tab,
    view: View,
    /// Where the author has moved the camera to.
    camera: Option<Camera>,
    /// The scene's own.
    home: Option<Camera>,
    mouse: [f32; 2],
    /// Whether lights, target and bounds are drawn over the picture.
    gizmos: bool,
    magnifies: bool,
    divider: divider::Divider,
    gauge: value_legend::ValueLegend,
    handles: handles::Handles,
    focus: Focus,
    picking: Picking,
    /// What was asked of the painter last.
    look: Option<ViewRequest>,
    clock: Clock,
    /// Whether the scene reads the clock.
    moves: bool,
    document: Document,
    /// What the text offers to change, and the text.
    outline: Option<(Box<Outline>, Arc<str>)>,
    pending: Pending,
    selected: Option<scene::Path>,
    /// What was chosen before something new was.
    left: Option<scene::Path>,
    /// What the names in the tree are to have in them.
    wanted: String,
    compiled: Option<Arc<Compiled>>,
    shader: shader::Tab,
    timings: Vec<(&'static str, String)>,
    /// Mistakes, or warnings of a scene that is shown.
    report: Option<mistakes::Told>,
    /// Where drawing is slow, how slow.
    pub slow: Option<Slow>,
    pub dialog: capture::Dialog,
    palette: palette::Palette,
    gallery: gallery::Gallery,
    /// Where the author wants to go, while something is to be asked before.
    leaving: Option<Leaving>,
    shows_cheat_sheet: bool,
    /// A message about something that could not be done, shown once.
    notice: Option<String>,
}

/// What the side of the window shows.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Tab {
    Scene,
    Shader,
    Timings,
}

/// What the author has done.
pub struct Reply {
    pub look: ViewRequest,
    pub orders: Vec<BuilderCommand>,
    pub wishes: Vec<thumbnails::ThumbnailCommand>,
    pub capture: Option<capture::Action>,
    pub quits: bool,
}

impl Panel {
    pub fn new(scene: &Path, adapter: String, mut settings: Settings) -> Self {
        settings.visit(scene);
        Self {
            scene: scene.to_owned(),
            disk: Disk::new(None),
            scenes: scenes::neighbours(scene),
            recent: scenes::elsewhere(&settings.recent, scene),
            settings,
            adapter,
            tab: Tab::Scene,
            view: View::Color,
            camera: None,
            home: None,
            mouse: [0.0; 2],
            gizmos: false,
            magnifies: false,
            slow: None,
            divider: divider::Divider::default(),
            gauge: value_legend::ValueLegend::default(),
            handles: handles::Handles::default(),
            focus: Focus::All,
            picking: Picking::default(),
            look: None,
            clock: Clock::Running { then: 0.0, at: Instant::now() },
            moves: false,
            document: Document::new(scene),
            outline: None,
            pending: Pending::default(),
            selected: None,
            left: None,
            wanted: String::new(),
            compiled: None,
            shader: shader::Tab::default(),
            timings: vec![],
            report: None,
            dialog: capture::Dialog::new(&scenes::stem(scene)),
            palette: palette::Palette::default(),
            gallery: gallery::Gallery::default(),
            leaving: None,
            shows_cheat_sheet: false,
            notice: None,
        }
    }

    /// The same, for scenes on `disk`.
    pub fn on(self, disk: &Disk) -> Self {
        Self { disk: disk.clone(), ..self }
    }

    pub fn scene(&self) -> &Path {
        &self.scene
    }

    /// The version that the picture shows.
    pub fn compiled(&self) -> Option<&Arc<Compiled>> {
        self.compiled.as_ref()
    }

    /// Another device takes the place of a lost one: what its builder has to know.
    pub fn begin_again(&mut self) -> [BuilderCommand; 2] {
        self.picking = Picking::default();
        self.look = None;
        self.slow = None;
        self.gauge.begin_again();
        self.gallery.begin_again();
        [BuilderCommand::Edited(self.document.overlay()), BuilderCommand::Focus(self.focus.clone())]
    }

    /// A new picture is there. Its scene's camera wins over the author's where the file moved it.
    pub fn take(&mut self, picture: &Picture, is_new_edit: bool) {
        let camera = picture.compiled.scene.camera;
        if self.home != Some(camera) {
            self.home = Some(camera);
            self.camera = None;
        }
        if is_new_edit {
            self.mend(&picture.warnings);
            self.picking.forget();
            self.shader.listing.take(&picture.compiled, &self.focus);
        }
        if picture.moves && !self.moves && matches!(self.clock, Clock::Running { .. }) {
            self.rewind();
        }
        self.moves = picture.moves;
        self.compiled = Some(picture.compiled.clone());
        self.timings = timings::of(picture);
    }

    /// The scene's file holds another text than before.
    pub fn file_says(&mut self, text: &str) -> BuilderCommand {
        let before = self.document.text().map(str::to_owned);
        self.document.file_says(text);
        self.follow_choice(before.as_deref());
        BuilderCommand::Edited(self.document.overlay())
    }

    /// What the scene's text offers to change.
    pub fn offer(&mut self, outline: Box<Outline>, text: Arc<str>) {
        if self.document.text() == Some(&text) {
            self.pending.clear();
            self.outline = Some((outline, text));
        }
    }

    /// The scene is right, but for `warnings`.
    ///
    /// Whether there is something else to see than before.
    pub fn mend(&mut self, warnings: &Report) -> bool {
        let told = self.report.take();
        self.report = (!warnings.diagnostics.is_empty()).then(|| mistakes::Told::new(warnings.clone()));
        told.is_some() || self.report.is_some()
    }

    /// The scene is wrong: the picture stays, the mistakes come over it.
    pub fn break_with(&mut self, report: Report) {
        self.report = Some(mistakes::Told::new(report));
    }

    /// Lays everything out around `picture`.
    pub fn show(&mut self, ui: &mut Ui, picture: Option<TextureId>) -> Reply {
        let mut actions = Actions::default();
        self.depart(ui, &mut actions);
        let asks = self.leaving.is_some();
        self.keys(ui, &mut actions);
        egui::Panel::top("bar").show(ui, |ui| self.bar(ui, &mut actions));
        if self.moves {
            egui::Panel::bottom("clock").show(ui, |ui| self.clock_bar(ui, &mut actions));
        }
        let side = egui::Panel::right("panel").default_size(self.settings.panel).size_range(settings::PANEL);
        let side = side.show(ui, |ui| {
            // What is too long is cut, and does not move the picture.
            ui.set_max_width(ui.available_width());
            ui.add_space(4.0);
            ui.horizontal(|ui| {
                for (tab, name) in [(Tab::Scene, "Scene"), (Tab::Shader, "Shader"), (Tab::Timings, "Timings")]
                {
                    ui.selectable_value(&mut self.tab, tab, name);
                }
            });
            ui.separator();
            match self.tab {
                Tab::Scene => self.inspector(ui, &mut actions),
                Tab::Shader => self.shader(ui),
                Tab::Timings => timings::show(ui, &self.adapter, &self.timings),
            }
        });
        self.settings.panel = side.response.rect.width();
        let shown = egui::CentralPanel::no_frame().show(ui, |ui| self.picture(ui, picture));
        let look = shown.inner;
        self.measure(ui, shown.response.rect, &mut actions);
        actions.edits.append(&mut self.handles.edits);
        let capture = self.capture_dialog(ui);
        self.palette(ui, &mut actions);
        let wishes = self.gallery(ui, &mut actions);
        self.sheet(ui);
        self.act(ui, &mut actions);
        if self.leaving.is_some() && !asks {
            ui.ctx().request_repaint();
        }
        Reply { look, orders: actions.orders, wishes, capture, quits: actions.quits }
    }
}
