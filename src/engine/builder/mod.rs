//! The thread that turns files into pipelines: compile, find the kind of edit, ask the driver.
//!
//! In: [`BuilderCommand`]. Out: [`BuilderEvent`].

mod steps;

use std::path::{Path, PathBuf};
use std::sync::Arc;
use std::sync::mpsc::{Sender, channel};
use std::time::{Duration, Instant};

use self::steps::NextStage;
use super::builder_messages::{BuilderCommand, BuilderEvent, Version};
use super::crash_guard::CrashGuard;
use super::events::Change;
use super::focus::Focus;
use crate::compile::{Compiled, compile, on_deep_stack};
use crate::diagnostic::{Diagnostic, Report};
use crate::gpu::Gpu;
use crate::ir::Measure;
use crate::library::Library;
use crate::outline;
use crate::scene;
use crate::sources::Disk;
use crate::watch::Watcher;
use crate::wgsl::Mode;

/// Starts the thread; each result goes to `done`. `crash_guard` knows the versions that other devices were
/// lost over.
pub fn start(
    gpu: Gpu,
    disk: Disk,
    crash_guard: CrashGuard,
    done: impl Fn(BuilderEvent) + Send + 'static,
) -> Sender<BuilderCommand> {
    let (sender, receiver) = channel();
    let changes = sender.clone();
    std::thread::spawn(move || {
        let watcher = Watcher::new(move || drop(changes.send(BuilderCommand::Changed)));
        let mut builder = Builder {
            gpu,
            disk,
            watcher,
            scene: PathBuf::new(),
            edited: None,
            file: None,
            focus: Focus::All,
            measure: None,
            before: None,
            next_stage: None,
            shows_views: false,
            crash_guard,
        };
        builder.begin_again(&done);
        while let Ok(first) = receiver.recv() {
            let orders: Vec<BuilderCommand> = std::iter::once(first).chain(receiver.try_iter()).collect();
            if orders.iter().any(|order| matches!(order, BuilderCommand::End)) {
                return;
            }
            builder.obey(orders, &done);
        }
    });
    sender
}

struct Builder {
    gpu: Gpu,
    disk: Disk,
    watcher: Watcher,
    scene: PathBuf,
    /// What stands for the text of the scene's file.
    edited: Option<Arc<str>>,
    /// What that file held when it was last read.
    file: Option<Arc<str>>,
    focus: Focus,
    measure: Option<String>,
    /// The last version that could be drawn.
    before: Option<Arc<Compiled>>,
    /// What the same has yet to get, once the author sees what is there.
    next_stage: Option<NextStage>,
    shows_views: bool,
    crash_guard: CrashGuard,
}

impl Builder {
    /// Shows what was shown on the device before, which was lost over something else.
    fn begin_again(&mut self, done: &impl Fn(BuilderEvent)) {
        let Some(compiled) = self.crash_guard.good().cloned() else { return };
        let noticed = Instant::now();
        // What it was drawn with before it is drawn with again; where not, the files report the mistake.
        // A picture that has come through memory is on the screen still.
        let is_on_screen = self.gpu.is_software();
        let _ = self.show(&compiled, Report::default(), noticed, is_on_screen, done);
    }

    /// Takes all orders that have come as one.
    fn obey(&mut self, orders: Vec<BuilderCommand>, done: &impl Fn(BuilderEvent)) {
        let mut is_stale = false;
        let mut is_shown = false;
        for order in orders {
            is_stale |= match &order {
                // The window asks again if a file has changed, which is known here.
                BuilderCommand::Edited(text) => *text != self.edited,
                BuilderCommand::Shown(_) | BuilderCommand::Views(_) => false,
                _ => true,
            };
            match order {
                BuilderCommand::Open(scene) => {
                    self.scene = scene;
                    self.edited = None;
                    self.file = None;
                    self.focus = Focus::All;
                    self.measure = None;
                }
                BuilderCommand::Focus(focus) => self.focus = focus,
                BuilderCommand::Measure(name) => self.measure = name,
                BuilderCommand::Edited(text) => self.edited = text,
                BuilderCommand::Changed | BuilderCommand::End => {}
                BuilderCommand::Views(shows) => {
                    self.shows_views = shows;
                    // What is baked may have none, and then nothing can be shown before the rest is there.
                    is_shown |= shows;
                }
                BuilderCommand::Shown(compiled) => {
                    is_shown |=
                        self.next_stage.as_ref().is_some_and(|o| Arc::ptr_eq(o.compiled(), &compiled));
                }
            }
        }
        let is_new = is_stale && self.build(done) == Some(Change::Structure);
        if is_stale {
            self.outline(done);
        }
        if is_shown && !is_new {
            self.advance(done);
        }
    }

    /// Compiles and reports. Returns the kind of change, unless the scene is wrong.
    fn build(&mut self, done: &impl Fn(BuilderEvent)) -> Option<Change> {
        let noticed = Instant::now();
        done(BuilderEvent::Begun);
        let disk = self.disk.sources();
        let file = disk.text(&self.scene).ok();
        if file.is_some() && file != self.file {
            self.file = file;
            done(BuilderEvent::File(self.file.clone().expect("it was just read")));
        }
        if self.edited == self.file {
            self.edited = None;
        }
        let mut sources = self.disk.sources();
        if let Some(text) = &self.edited {
            sources = sources.with(&self.scene, text);
        }
        let outcome = compile(&sources, &self.scene, Mode::Live, self.before.as_deref());
        // An edit that is not saved must not hide what becomes of the file.
        self.watcher.watch(sources.asked().into_iter().chain(disk.asked()).collect());
        let broken = |problem| Report { diagnostics: vec![problem], ..outcome.report.clone() };
        let Some(compiled) = outcome.compiled else {
            done(BuilderEvent::Broken(outcome.report));
            return None;
        };
        let compiled = match self.focus.of(compiled).and_then(|compiled| self.measuring(compiled)) {
            Ok(compiled) => Arc::new(compiled),
            Err(problem) => {
                done(BuilderEvent::Broken(broken(problem)));
                return None;
            }
        };
        if let Some(report) = self.crash_guard.verdict(&compiled) {
            done(BuilderEvent::Broken(report));
            return None;
        }
        let mut change = self.change(&compiled);
        if change == Change::Numbers && !self.build_full(done) {
            change = Change::Structure;
        }
        if change == Change::Structure {
            if let Err(problem) = self.show(&compiled, outcome.report.clone(), noticed, false, done) {
                done(BuilderEvent::Broken(broken(problem)));
                return None;
            }
        } else {
            let (sketch, baked, pipeline_time) = (None, None, Duration::ZERO);
            let (warnings, is_on_screen) = (outcome.report, false);
            let version =
                Version { compiled, change, sketch, baked, pipeline_time, is_on_screen, warnings, noticed };
            self.before = Some(version.compiled.clone());
            done(BuilderEvent::Scene(Box::new(version)));
        }
        Some(change)
    }

    /// `compiled` with what is to be measured; the pattern where it has no number of that name.
    fn measuring(&self, compiled: Compiled) -> Result<Compiled, Diagnostic> {
        let Some(name) = &self.measure else { return Ok(compiled) };
        compiled.measuring(Measure::named(&compiled.scene, name).unwrap_or(Measure::Pattern))
    }

    /// Tells what the scene's text offers to change, if it can be read.
    fn outline(&self, done: &impl Fn(BuilderEvent)) {
        let Some(text) = self.edited.clone().or_else(|| self.file.clone()) else { return };
        let sources = self.disk.sources();
        let library = Library::new(&sources, self.scene.parent().unwrap_or(Path::new("")));
        let outline = on_deep_stack(|| {
            let root = scene::parse(&sources.name(&self.scene), &text).ok()?;
            Some(outline::outline(&root, &text, &library))
        });
        if let Some(outline) = outline {
            done(BuilderEvent::Outline { outline: Box::new(outline), text });
        }
    }

    fn change(&self, compiled: &Compiled) -> Change {
        match &self.before {
            Some(before) if before.has_structure_of(compiled) => {
                let same = before.source.numbers == compiled.source.numbers;
                let same_frame = before.scene.camera == compiled.scene.camera;
                if same && same_frame && before.scene.render == compiled.scene.render {
                    Change::Cosmetic
                } else {
                    Change::Numbers
                }
            }
            _ => Change::Structure,
        }
    }
}
