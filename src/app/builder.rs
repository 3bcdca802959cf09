//! The thread that turns files into pipelines: compile, tell what kind of edit it was, ask the driver.
//!
//! A structural edit is shown with its numbers baked in, which a driver compiles sooner and draws faster. The
//! live pipeline follows once that is on the screen, so that it is there before the author changes a number.

use std::path::{Path, PathBuf};
use std::sync::Arc;
use std::sync::mpsc::{Sender, channel};
use std::time::{Duration, Instant};

use super::events::Change;
use crate::diagnostic::{Diagnostic, Report};
use crate::gpu::{Gpu, Pipeline};
use crate::sources::Sources;
use crate::watch::Watcher;
use crate::wgsl::Mode;
use crate::{Compiled, compile};

/// What to build.
pub enum Order {
    /// Another scene.
    Open(PathBuf),
    /// The same, whose files have changed.
    Changed,
    /// The last version is on the screen: there is time for its live pipeline.
    Shown,
}

/// What came of it.
pub enum Built {
    /// Nothing yet: the files have changed, and a verdict follows.
    Begun,
    Scene(Box<Version>),
    /// The live pipeline of the last [`Change::Structure`].
    Live(Pipeline),
    Broken(Report),
}

/// A version of the scene that can be drawn.
pub struct Version {
    pub compiled: Arc<Compiled>,
    pub change: Change,
    /// The baked pipeline of a [`Change::Structure`]; others keep the live one.
    pub baked: Option<Pipeline>,
    pub pipeline_time: Duration,
    pub warnings: Report,
    /// When the change was noticed.
    pub noticed: Instant,
}

/// Starts the thread; each result goes to `done`.
pub fn start(gpu: Gpu, done: impl Fn(Built) + Send + 'static) -> Sender<Order> {
    let (sender, receiver) = channel();
    let changes = sender.clone();
    std::thread::spawn(move || {
        let watcher = Watcher::new(move || drop(changes.send(Order::Changed)));
        let mut builder = Builder { gpu, watcher, scene: PathBuf::new(), before: None, without_live: None };
        while let Ok(first) = receiver.recv() {
            builder.obey(std::iter::once(first).chain(receiver.try_iter()), &done);
        }
    });
    sender
}

struct Builder {
    gpu: Gpu,
    watcher: Watcher,
    scene: PathBuf,
    /// The last version that could be drawn.
    before: Option<Arc<Compiled>>,
    /// The same, while it has no live pipeline: that waits until the author sees the baked one.
    without_live: Option<Arc<Compiled>>,
}

impl Builder {
    /// Takes all orders that have come as one.
    fn obey(&mut self, orders: impl Iterator<Item = Order>, done: &impl Fn(Built)) {
        let mut is_stale = false;
        for order in orders {
            if let Order::Open(scene) = order {
                self.scene = scene;
                is_stale = true;
            } else if let Order::Changed = order {
                is_stale = true;
            }
        }
        if is_stale {
            self.build(done);
        } else {
            self.build_live(done);
        }
    }

    fn build(&mut self, done: &impl Fn(Built)) {
        let noticed = Instant::now();
        done(Built::Begun);
        let here = std::env::current_dir().unwrap_or_else(|_| Path::new(".").into());
        let sources = Sources::on_disk(&here);
        let outcome = compile(&sources, &self.scene, Mode::Live, self.before.as_deref());
        self.watcher.watch(sources.asked());
        let Some(compiled) = outcome.compiled else { return done(Built::Broken(outcome.report)) };
        let compiled = Arc::new(compiled);
        let mut change = self.change(&compiled);
        if change == Change::Numbers && !self.build_live(done) {
            change = Change::Structure;
        }
        let started = Instant::now();
        let mut baked = None;
        if change == Change::Structure {
            match self.baked(&compiled) {
                Ok(pipeline) => baked = Some(pipeline),
                Err(problem) => {
                    return done(Built::Broken(Report { diagnostics: vec![problem], ..outcome.report }));
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
            self.without_live = Some(compiled);
        }
    }

    /// Makes the live pipeline of the last structural edit, if that has none yet; whether there is one now.
    fn build_live(&mut self, done: &impl Fn(Built)) -> bool {
        let Some(compiled) = self.without_live.take() else { return self.before.is_some() };
        match Pipeline::build(&self.gpu, &compiled) {
            Ok(pipeline) => done(Built::Live(pipeline)),
            // A scene may have more numbers than the GPU takes. Then every edit is a structural one.
            Err(_) => self.before = None,
        }
        self.before.is_some()
    }

    fn baked(&self, compiled: &Compiled) -> Result<Pipeline, Diagnostic> {
        let twin = compiled.in_mode(Mode::Baked)?;
        Pipeline::build(&self.gpu, &twin).map_err(|error| Diagnostic::error(error.to_string()))
    }

    fn change(&self, compiled: &Compiled) -> Change {
        match &self.before {
            Some(before)
                if before.source.sections == compiled.source.sections
                    && before.scene.images == compiled.scene.images
                    && before.scene.models == compiled.scene.models =>
            {
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
