//! What was read of files, and whether it still holds: length and time of writing are asked first.
//!
//! In: what a compilation was answered. Out: whether any of it would be answered differently now.

use std::collections::BTreeMap;
use std::fs;
use std::path::{Path, PathBuf};
use std::time::{Duration, SystemTime};

use crate::sources::Answer;

/// A time of writing says that nothing was written since only once it is this old: some systems count in
/// steps of two seconds.
const SETTLED: Duration = Duration::from_secs(2);

/// Files that were asked for.
pub struct Seen(BTreeMap<PathBuf, File>);

struct File {
    answer: Answer,
    /// What the file had when it last held what was answered, and was old enough.
    trusted: Option<Stamp>,
    /// Where the path leads, links followed.
    place: Option<PathBuf>,
}

#[derive(Clone, Copy, PartialEq, Eq)]
struct Stamp {
    length: u64,
    written: SystemTime,
}

impl Seen {
    /// Standard input, which is called `-`, is left out: it does not change.
    pub fn new(asked: BTreeMap<PathBuf, Answer>) -> Self {
        let is_file = |path: &Path| path.file_name().is_some_and(|name| name != "-");
        let files = asked.into_iter().filter(|(path, _)| is_file(path)).map(|(path, answer)| {
            let place = path.canonicalize().ok();
            (path, File { answer, trusted: None, place })
        });
        Self(files.collect())
    }

    pub fn paths(&self) -> impl Iterator<Item = &Path> {
        self.0.keys().map(PathBuf::as_path)
    }

    /// Something has happened near the files: they are to be read again, whatever their times are.
    pub fn distrust(&mut self) {
        self.0.values_mut().for_each(|file| file.trusted = None);
    }

    /// Whether one of the files is no longer what was answered; `read` is asked where the file's length and
    /// time do not say.
    pub fn differs(&mut self, read: &dyn Fn(&Path) -> Answer) -> bool {
        self.0.iter_mut().any(|(path, file)| file.differs(path, read))
    }
}

impl File {
    fn differs(&mut self, path: &Path, read: &dyn Fn(&Path) -> Answer) -> bool {
        match &self.answer {
            // Nobody has read it, so only another place can make it another file.
            Answer::Outside => path.canonicalize().ok() != self.place,
            Answer::TooLarge(limit) => {
                !fs::metadata(path).is_ok_and(|found| found.is_file() && found.len() > *limit)
            }
            answer => {
                // Asked before the file is read: what is written in between makes it another one.
                let stamp = Stamp::of(path);
                if stamp.is_some() && stamp == self.trusted {
                    return false;
                }
                let differs = read(path) != *answer;
                self.trusted = stamp.filter(|stamp| !differs && stamp.is_settled());
                differs
            }
        }
    }
}

impl Stamp {
    /// None where there is no file, or a system that keeps no times.
    fn of(path: &Path) -> Option<Self> {
        let found = fs::metadata(path).ok().filter(fs::Metadata::is_file)?;
        Some(Self { length: found.len(), written: found.modified().ok()? })
    }

    /// A time to come is not: nobody knows when the clock that wrote it gets there.
    fn is_settled(&self) -> bool {
        self.written.elapsed().is_ok_and(|age| age >= SETTLED)
    }
}
