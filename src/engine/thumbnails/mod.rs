//! Small pictures of scenes, textures and shapes, drawn on a thread of their own while a gallery is open.
//!
//! In: a [`ThumbnailCommand`]. Out: a [`ThumbnailEvent`]. The thread has a device of its own, so that neither
//! the window nor the picture waits for it, and a scene that ends a device ends no other. The thread is there
//! only while it draws.

mod catalog;
pub mod store;

use std::collections::{BTreeMap, BTreeSet};
use std::hash::{DefaultHasher, Hash, Hasher};
use std::ops::ControlFlow;
use std::path::PathBuf;
use std::sync::Arc;
use std::sync::mpsc::{Receiver, Sender, TryRecvError, channel};

pub use self::catalog::{Definition, Item, Subject, catalog};
use self::store::Store;
pub use self::store::Thumbnail;
use crate::compile::Compiled;
use crate::frame::Moment;
use crate::gpu::{AdapterChoice, Gpu, GpuError, Picture, Renderer};
use crate::sources::Disk;

/// For each pixel.
const SAMPLES: u32 = 16;
/// About a screen of them is looked for among those drawn before, and only then one is drawn.
const AHEAD: usize = 40;

/// What a gallery asks for.
pub enum ThumbnailCommand {
    /// What there is: these scenes, with the names that people know them by, and what a scene in `folder`
    /// can name. All pictures are looked at anew.
    List { folder: PathBuf, scenes: Vec<(PathBuf, String)> },
    /// Pictures of these, so many pixels large, and of nothing else. The first `seen` of them are wanted
    /// before the others.
    Draw { subjects: Vec<Subject>, seen: usize, size: [u32; 2] },
}

/// A message to a gallery.
pub enum ThumbnailEvent {
    Catalog(Vec<Item>),
    /// The picture of a subject, or why there is none.
    Picture(Subject, Result<Arc<Thumbnail>, String>),
}

/// Starts the thread; it draws scenes of `disk` with an adapter of this kind, and keeps what it draws in
/// `folder`.
pub fn start(
    choice: AdapterChoice,
    folder: Option<PathBuf>,
    disk: Disk,
    tell: impl Fn(ThumbnailEvent) + Send + 'static,
) -> Sender<ThumbnailCommand> {
    let (sender, wishes) = channel();
    std::thread::spawn(move || {
        // Nobody who opens no gallery pays for it.
        let Ok(first) = wishes.recv() else { return };
        let mut artist = ThumbnailRenderer {
            choice,
            disk,
            wishes,
            tell: Box::new(tell),
            store: Store::open(folder),
            gpu: None,
            folder: PathBuf::new(),
            subjects: vec![],
            seen: 0,
            size: [1; 2],
            lists: 0,
            told: BTreeSet::new(),
            missing: BTreeMap::new(),
        };
        artist.hear(first);
        artist.run();
    });
    sender
}

struct ThumbnailRenderer {
    choice: AdapterChoice,
    disk: Disk,
    wishes: Receiver<ThumbnailCommand>,
    tell: Box<dyn Fn(ThumbnailEvent)>,
    store: Store,
    gpu: Option<Gpu>,
    /// Where names are looked up.
    folder: PathBuf,
    subjects: Vec<Subject>,
    seen: usize,
    size: [u32; 2],
    /// How many lists were asked for.
    lists: u32,
    /// Those whose picture was sent since the last one.
    told: BTreeSet<Subject>,
    /// Those of the others that nobody has drawn before, with the lengths of their shaders.
    missing: BTreeMap<Subject, usize>,
}

impl ThumbnailRenderer {
    fn run(&mut self) {
        loop {
            self.listen();
            if let Some(subject) = self.next().cloned() {
                if let Some(picture) = self.picture(&subject) {
                    (self.tell)(ThumbnailEvent::Picture(subject.clone(), picture));
                    self.told.insert(subject);
                }
                continue;
            }
            if self.subjects.is_empty() {
                self.gpu = None;
            }
            let Ok(wish) = self.wishes.recv() else { return };
            self.hear(wish);
        }
    }

    /// Which one to look for, or if all have been looked for, to draw: the shortest shader of those that are
    /// seen, since drivers take longest to compile, and cannot be stopped.
    fn next(&self) -> Option<&Subject> {
        let open = self.subjects.iter().enumerate().filter(|(_, subject)| !self.told.contains(subject));
        let open = open.take(AHEAD).map(|(i, subject)| (i >= self.seen, self.missing.get(subject), subject));
        let unknown = open.clone().find(|(_, length, _)| length.is_none());
        unknown.or_else(|| open.min()).map(|(_, _, subject)| subject)
    }

    /// Hears all that was wished meanwhile.
    fn listen(&mut self) {
        loop {
            match self.wishes.try_recv() {
                Ok(wish) => self.hear(wish),
                Err(TryRecvError::Empty) => return,
                // The window is gone.
                Err(TryRecvError::Disconnected) => return self.subjects.clear(),
            }
        }
    }

    fn hear(&mut self, wish: ThumbnailCommand) {
        match wish {
            ThumbnailCommand::List { folder, scenes } => {
                self.lists += 1;
                (self.tell)(ThumbnailEvent::Catalog(catalog::catalog(&self.disk, &folder, &scenes)));
                self.folder = folder;
                self.forget();
            }
            ThumbnailCommand::Draw { subjects, seen, size } => {
                if self.size != size {
                    self.forget();
                }
                (self.subjects, self.seen, self.size) = (subjects, seen, size);
            }
        }
    }

    fn forget(&mut self) {
        self.told.clear();
        self.missing.clear();
    }

    /// The picture of `subject`, or why there is none; None where it is found missing and is to be drawn when
    /// its turn comes again, or where nobody wants it any more.
    fn picture(&mut self, subject: &Subject) -> Option<Result<Arc<Thumbnail>, String>> {
        let compiled = match subject.compiled(&self.disk, &self.folder) {
            Ok(compiled) => compiled,
            Err(mistakes) => return Some(Err(mistakes)),
        };
        let digest = digest(&compiled, self.size);
        if let Some(known) = self.store.find(subject, digest, self.size) {
            return Some(Ok(known));
        }
        // Found missing for the first time, it waits for its turn.
        self.missing.insert(subject.clone(), compiled.source.text().len())?;
        match self.draw(&compiled) {
            Ok(picture) => Some(Ok(self.store.keep(subject, digest, &picture?))),
            Err(error) => {
                // Another scene may well get along with another device.
                self.gpu = None;
                Some(Err(error.to_string()))
            }
        }
    }

    /// None where nobody wants it any more.
    fn draw(&mut self, compiled: &Compiled) -> Result<Option<Picture>, GpuError> {
        let gpu = match &self.gpu {
            Some(gpu) => gpu.clone(),
            None => self.gpu.insert(Gpu::headless(&self.choice)?).clone(),
        };
        let (size, lists) = (self.size, self.lists);
        let mut renderer = Renderer::new(&gpu, compiled, size)?;
        renderer.draw(&Moment::of(&compiled.scene), SAMPLES, &mut |_| {
            self.listen();
            let goes_on = !self.subjects.is_empty() && self.size == size && self.lists == lists;
            if goes_on { ControlFlow::Continue(()) } else { ControlFlow::Break(()) }
        })
    }
}

/// Of all that is in the picture: the shader with its numbers, what it reads, and who looks how.
pub fn digest(compiled: &Compiled, size: [u32; 2]) -> u64 {
    let scene = &compiled.scene;
    let mut digest = DefaultHasher::new();
    compiled.source.text().hash(&mut digest);
    scene.images.iter().for_each(|image| image.digest.hash(&mut digest));
    scene.models.iter().for_each(|model| model.digest.hash(&mut digest));
    format!("{:?} {:?}", scene.camera, scene.render).hash(&mut digest);
    (size, SAMPLES).hash(&mut digest);
    digest.finish()
}
