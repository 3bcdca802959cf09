//! "Something that you depend on changed": the only room that knows notify.
//!
//! In: what a compilation asked [`crate::sources::Sources`] for. Out: a call when any of it is no longer so.

mod seen;

use std::collections::{BTreeMap, BTreeSet};
use std::path::{Path, PathBuf};
use std::sync::mpsc::{Receiver, RecvTimeoutError, Sender, channel};
use std::time::{Duration, Instant};

use notify::event::{AccessKind, AccessMode, EventKind, ModifyKind, RenameMode};
use notify::{RecommendedWatcher, RecursiveMode, Watcher as _};

pub use self::seen::Seen;
use crate::sources::{Answer, Sources};

/// Files are read once they have been left alone for this long.
const BATCH_TIMEOUT: Duration = Duration::from_millis(15);
/// The same where the system says that a file was closed or put in its place: others may follow.
const BATCH_TIMEOUT_AFTER_CLOSE: Duration = Duration::from_millis(3);
/// Whoever never leaves them alone is shown what there is after this long.
const STARVE_TIMEOUT: Duration = Duration::from_millis(250);
/// Network folders, and systems out of watches, give no events: a look now and then finds the change.
const POLL_INTERVAL: Duration = Duration::from_secs(1);

/// Watches the files of the last compilation on a thread of its own, until it is dropped.
pub struct Watcher {
    sender: Sender<Message>,
}

type Asked = BTreeMap<PathBuf, Answer>;

enum Message {
    Watch(Asked),
    /// Something happens in a folder, and how long it should be quiet before that counts as over.
    Stirred(Duration),
}

impl Watcher {
    /// Calls `changed` from another thread, once for each change, until [`Watcher::watch`] is called again.
    pub fn new(changed: impl Fn() + Send + 'static) -> Self {
        let (sender, receiver) = channel();
        let events = sender.clone();
        std::thread::spawn(move || run(&receiver, events, &changed));
        Self { sender }
    }

    /// Watches what was asked for instead of what was watched before.
    pub fn watch(&self, asked: Asked) {
        // The thread ends only with the last sender.
        let _ = self.sender.send(Message::Watch(asked));
    }
}

fn run(receiver: &Receiver<Message>, events: Sender<Message>, changed: &dyn Fn()) {
    let mut folders = Folders::new(events);
    let mut seen: Option<Seen> = None;
    loop {
        match receiver.recv_timeout(POLL_INTERVAL) {
            Ok(Message::Watch(new)) => {
                let new = Seen::new(new);
                folders.follow(&new);
                seen = Some(new);
            }
            Ok(Message::Stirred(quiet)) => {
                seen = wait_for_quiet(receiver, quiet).map(Seen::new).or(seen);
                if let Some(seen) = &mut seen {
                    seen.distrust();
                    // A folder that was missing may be there now, and will get its files later.
                    folders.follow(seen);
                }
            }
            Err(RecvTimeoutError::Timeout) => {}
            Err(RecvTimeoutError::Disconnected) => return,
        }
        if seen.as_mut().is_some_and(|seen| seen.differs(&read)) {
            seen = None;
            changed();
        }
    }
}

/// Waits on the trailing edge of a burst; what is to be watched next, if that came in between.
fn wait_for_quiet(receiver: &Receiver<Message>, mut quiet: Duration) -> Option<Asked> {
    let begun = Instant::now();
    let mut next = None;
    while begun.elapsed() < STARVE_TIMEOUT {
        match receiver.recv_timeout(quiet) {
            Ok(Message::Stirred(next)) => quiet = next,
            Ok(Message::Watch(new)) => next = Some(new),
            Err(_) => break,
        }
    }
    next
}

/// What is at `path` now.
fn read(path: &Path) -> Answer {
    Sources::on_disk(Path::new("/")).read(path)
}

/// The folders under watch. Files are never watched: a watch on a file dies with the first save by rename.
struct Folders {
    watcher: Option<RecommendedWatcher>,
    watched: BTreeSet<PathBuf>,
}

impl Folders {
    fn new(events: Sender<Message>) -> Self {
        let on_event = move |event: notify::Result<notify::Event>| {
            let quiet = match event.as_ref().map(|event| event.kind) {
                Ok(EventKind::Access(AccessKind::Close(AccessMode::Write))) => BATCH_TIMEOUT_AFTER_CLOSE,
                Ok(EventKind::Modify(ModifyKind::Name(RenameMode::To | RenameMode::Both))) => {
                    BATCH_TIMEOUT_AFTER_CLOSE
                }
                // Our own reading makes events too, and must not wake us.
                Ok(EventKind::Access(_)) => return,
                _ => BATCH_TIMEOUT,
            };
            let _ = events.send(Message::Stirred(quiet));
        };
        Self { watcher: notify::recommended_watcher(on_event).ok(), watched: BTreeSet::new() }
    }

    fn follow(&mut self, seen: &Seen) {
        let Some(watcher) = &mut self.watcher else { return };
        // A file that is missing, in a folder that is missing, shows in the nearest folder that is there.
        let there = |path: &Path| path.ancestors().skip(1).find(|folder| folder.is_dir()).map(Path::to_owned);
        let wanted: BTreeSet<PathBuf> = seen.paths().filter_map(there).collect();
        for folder in self.watched.difference(&wanted) {
            // It may be gone, and its watch with it.
            let _ = watcher.unwatch(folder);
        }
        let mut failed = |folder: &PathBuf| watcher.watch(folder, RecursiveMode::NonRecursive).is_err();
        // A folder that was removed and made again needs a new watch, so all are set each time.
        let lost: Vec<PathBuf> = wanted.iter().filter(|f| failed(f)).cloned().collect();
        self.watched = wanted;
        self.watched.retain(|folder| !lost.contains(folder));
    }
}
