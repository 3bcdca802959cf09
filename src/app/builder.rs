//! The thread that turns files into pipelines: compile, tell what kind of edit it was, ask the driver.
//!
//! A structural edit is shown with its numbers baked in, which a driver compiles sooner and draws faster. The
//! live pipeline follows at once, so that it is there before the author changes a number.

use std::path::{Path, PathBuf};
use std::sync::Arc;
use std::sync::mpsc::{Receiver, Sender, channel};
use std::time::{Duration, Instant};

use super::events::Change;
use crate::diagnostic::{Diagnostic, Report};
use crate::gpu::{Gpu, GpuError, Pipeline};
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
}

/// What came of it.
pub enum Built {
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
        let mut builder = Builder { gpu, watcher, scene: PathBuf::new(), before: None };
        while builder.next_order(&receiver) {
            builder.build(&done);
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
}

impl Builder {
    /// Waits for an order, and takes all that have come with it as one; whether there was one.
    fn next_order(&mut self, receiver: &Receiver<Order>) -> bool {
        let Ok(first) = receiver.recv() else { return false };
        for order in std::iter::once(first).chain(receiver.try_iter()) {
            if let Order::Open(scene) = order {
                self.scene = scene;
            }
        }
        true
    }

    fn build(&mut self, done: &impl Fn(Built)) {
        let noticed = Instant::now();
        let here = std::env::current_dir().unwrap_or_else(|_| Path::new(".").into());
        let sources = Sources::on_disk(&here);
        let outcome = compile(&sources, &self.scene, Mode::Live, self.before.as_deref());
        self.watcher.watch(sources.asked());
        let Some(compiled) = outcome.compiled else { return done(Built::Broken(outcome.report)) };
        let compiled = Arc::new(compiled);
        let change = self.change(&compiled);
        let started = Instant::now();
        let mut baked = None;
        if change == Change::Structure {
            let twin = compile(&sources, &self.scene, Mode::Baked, None).compiled;
            let built = Pipeline::build(&self.gpu, twin.as_ref().unwrap_or(&compiled));
            match built {
                Ok(pipeline) => baked = Some(pipeline),
                Err(error) => return done(Built::Broken(refused(&error))),
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
            match Pipeline::build(&self.gpu, &compiled) {
                Ok(pipeline) => done(Built::Live(pipeline)),
                // Without a live pipeline every edit is a structural one.
                Err(_) => self.before = None,
            }
        }
    }

    fn change(&self, compiled: &Compiled) -> Change {
        match &self.before {
            Some(before) if before.source.sections == compiled.source.sections => {
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

fn refused(error: &GpuError) -> Report {
    Report { diagnostics: vec![Diagnostic::error(error.to_string())], ..Report::default() }
}
