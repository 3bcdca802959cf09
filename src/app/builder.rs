//! The thread that turns files into pipelines: compile, tell what kind of edit it was, ask the driver.
//!
//! A structural edit is shown with its numbers baked in, which a driver compiles sooner and draws faster, and
//! without debug views where none is looked at. The full pipeline, with live numbers, follows once that is on
//! the screen, so that it is there before the author changes a number.

use std::path::{Path, PathBuf};
use std::sync::Arc;
use std::sync::mpsc::{Sender, channel};
use std::time::Instant;

use super::events::Change;
use super::focus::Focus;
use super::orders::{Built, Order, Version};
use super::trial::Trial;
use crate::diagnostic::{Diagnostic, Report};
use crate::gpu::{Gpu, Pipeline};
use crate::ir::Measure;
use crate::library::Library;
use crate::outline;
use crate::scene;
use crate::sources::Sources;
use crate::watch::Watcher;
use crate::wgsl::Mode;
use crate::{Compiled, compile, on_deep_stack};

/// Starts the thread; each result goes to `done`. What `trial` has found of versions on other devices counts.
pub fn start(gpu: Gpu, trial: Trial, done: impl Fn(Built) + Send + 'static) -> Sender<Order> {
    let (sender, receiver) = channel();
    let changes = sender.clone();
    std::thread::spawn(move || {
        let watcher = Watcher::new(move || drop(changes.send(Order::Changed)));
        let mut builder = Builder {
            gpu,
            watcher,
            scene: PathBuf::new(),
            edited: None,
            file: None,
            focus: Focus::All,
            measure: None,
            before: None,
            without_full: None,
            shows_views: false,
            trial,
        };
        builder.begin_again(&done);
        while let Ok(first) = receiver.recv() {
            let orders: Vec<Order> = std::iter::once(first).chain(receiver.try_iter()).collect();
            if orders.iter().any(|order| matches!(order, Order::End)) {
                return;
            }
            builder.obey(orders, &done);
        }
    });
    sender
}

struct Builder {
    gpu: Gpu,
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
    /// The same, while it has no full pipeline: that waits until the author sees the baked one.
    without_full: Option<Arc<Compiled>>,
    shows_views: bool,
    trial: Trial,
}

impl Builder {
    /// Shows what was shown on the device before, which was lost over something else.
    fn begin_again(&mut self, done: &impl Fn(Built)) {
        let Some(compiled) = self.trial.good().cloned() else { return };
        let noticed = Instant::now();
        // What it was drawn with before it is drawn with again; where not, the files tell what is wrong.
        let Ok(baked) = self.baked(&compiled) else { return };
        done(Built::Scene(Box::new(Version {
            compiled: compiled.clone(),
            change: Change::Structure,
            baked: Some(baked),
            pipeline_time: noticed.elapsed(),
            warnings: Report::default(),
            noticed,
        })));
        self.before = Some(compiled.clone());
        self.without_full = Some(compiled);
    }

    /// Takes all orders that have come as one.
    fn obey(&mut self, orders: Vec<Order>, done: &impl Fn(Built)) {
        let mut is_stale = false;
        let mut is_shown = false;
        for order in orders {
            is_stale |= match &order {
                // The window tells it again where a file has changed, which is known here.
                Order::Edited(text) => *text != self.edited,
                Order::Shown(_) | Order::Views(_) => false,
                _ => true,
            };
            match order {
                Order::Open(scene) => {
                    self.scene = scene;
                    self.edited = None;
                    self.file = None;
                    self.focus = Focus::All;
                    self.measure = None;
                }
                Order::Focus(focus) => self.focus = focus,
                Order::Measure(name) => self.measure = name,
                Order::Edited(text) => self.edited = text,
                Order::Changed | Order::End => {}
                Order::Views(shows) => {
                    self.shows_views = shows;
                    // What is baked may have none, and then nothing can be shown before the rest is there.
                    is_shown |= shows;
                }
                Order::Shown(compiled) => {
                    is_shown |= self.without_full.as_ref().is_some_and(|last| Arc::ptr_eq(last, &compiled));
                }
            }
        }
        let is_new = is_stale && self.build(done) == Some(Change::Structure);
        if is_stale {
            self.outline(done);
        }
        if is_shown && !is_new {
            self.build_full(done);
        }
    }

    /// Compiles and tells; what kind of change it was, unless the scene is wrong.
    fn build(&mut self, done: &impl Fn(Built)) -> Option<Change> {
        let noticed = Instant::now();
        done(Built::Begun);
        let here = std::env::current_dir().unwrap_or_else(|_| Path::new(".").into());
        let disk = Sources::on_disk(&here);
        let file = disk.text(&self.scene).ok();
        if file.is_some() && file != self.file {
            self.file = file;
            done(Built::File(self.file.clone().expect("it was just read")));
        }
        if self.edited == self.file {
            self.edited = None;
        }
        let mut sources = Sources::on_disk(&here);
        if let Some(text) = &self.edited {
            sources = sources.with(&self.scene, text);
        }
        let outcome = compile(&sources, &self.scene, Mode::Live, self.before.as_deref());
        // An edit that is not saved must not hide what becomes of the file.
        self.watcher.watch(sources.asked().into_iter().chain(disk.asked()).collect());
        let broken = |problem| Report { diagnostics: vec![problem], ..outcome.report.clone() };
        let Some(compiled) = outcome.compiled else {
            done(Built::Broken(outcome.report));
            return None;
        };
        let compiled = match self.focus.of(compiled).and_then(|compiled| self.measuring(compiled)) {
            Ok(compiled) => Arc::new(compiled),
            Err(problem) => {
                done(Built::Broken(broken(problem)));
                return None;
            }
        };
        if let Some(report) = self.trial.verdict(&compiled) {
            done(Built::Broken(report));
            return None;
        }
        let mut change = self.change(&compiled);
        if change == Change::Numbers && !self.build_full(done) {
            change = Change::Structure;
        }
        let started = Instant::now();
        let mut baked = None;
        if change == Change::Structure {
            match self.baked(&compiled) {
                Ok(pipeline) => baked = Some(pipeline),
                Err(problem) => {
                    done(Built::Broken(broken(problem)));
                    return None;
                }
            }
        }
        let pipeline_time = started.elapsed();
        let version = Version {
            compiled: compiled.clone(),
            change,
            baked,
            pipeline_time,
            warnings: outcome.report,
            noticed,
        };
        done(Built::Scene(Box::new(version)));
        self.before = Some(compiled.clone());
        if change == Change::Structure {
            self.without_full = Some(compiled);
        }
        Some(change)
    }

    /// `compiled` with what is to be measured; the pattern where it has no number of that name.
    fn measuring(&self, compiled: Compiled) -> Result<Compiled, Diagnostic> {
        let Some(name) = &self.measure else { return Ok(compiled) };
        compiled.measuring(Measure::named(&compiled.scene, name).unwrap_or(Measure::Pattern))
    }

    /// Tells what the scene's text offers to change, if it can be read.
    fn outline(&self, done: &impl Fn(Built)) {
        let Some(text) = self.edited.clone().or_else(|| self.file.clone()) else { return };
        let here = std::env::current_dir().unwrap_or_else(|_| Path::new(".").into());
        let sources = Sources::on_disk(&here);
        let library = Library::new(&sources, self.scene.parent().unwrap_or(Path::new("")));
        let outline = on_deep_stack(|| {
            let root = scene::parse(&sources.name(&self.scene), &text).ok()?;
            Some(outline::outline(&root, &text, &library))
        });
        if let Some(outline) = outline {
            done(Built::Outline { outline: Box::new(outline), text });
        }
    }

    /// Makes the full pipeline of the last structural edit, if that has none yet. Are its numbers live?
    fn build_full(&mut self, done: &impl Fn(Built)) -> bool {
        let Some(compiled) = self.without_full.take() else { return self.before.is_some() };
        let full = Pipeline::build(&self.gpu, &compiled).or_else(|_| {
            // A scene may have more numbers than the GPU takes. Then every edit is a structural one.
            self.before = None;
            self.build_baked(compiled.in_mode(Mode::Baked))
        });
        full.into_iter().for_each(|pipeline| done(Built::Full(pipeline)));
        self.before.is_some()
    }

    fn baked(&self, compiled: &Compiled) -> Result<Pipeline, Diagnostic> {
        self.build_baked(if self.shows_views { compiled.in_mode(Mode::Baked) } else { compiled.plain() })
    }

    fn build_baked(&self, twin: Result<Compiled, Diagnostic>) -> Result<Pipeline, Diagnostic> {
        Pipeline::build(&self.gpu, &twin?).map_err(|error| Diagnostic::error(error.to_string()))
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
