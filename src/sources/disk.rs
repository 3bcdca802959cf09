//! The disk, asked with care: what is no file, or too large for one, is answered in words.
//!
//! In: paths. Out: what is there.

use std::io::{self, Read};
use std::path::{Component, Path, PathBuf};

use super::{Answer, Sources};

/// The disk of this machine as one call of raytoy sees it.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Disk {
    /// The folder that raytoy runs in.
    pub here: PathBuf,
    /// The folder that the author names as the root of the scenes.
    pub named_root: Option<PathBuf>,
}

impl Disk {
    pub fn new(named_root: Option<PathBuf>) -> Self {
        Self { here: std::env::current_dir().unwrap_or_else(|_| ".".into()), named_root }
    }

    /// Its files, of which none has been read.
    pub fn sources(&self) -> Sources {
        Sources::on_disk(&self.here).below(self.named_root.as_deref())
    }
}

/// The longest text that is read: scenes that a program wrote have some megabytes.
pub(super) const MAX_TEXT: u64 = 16 << 20;
/// The largest model or image that is read.
pub(super) const MAX_BYTES: u64 = 1 << 30;

pub(super) fn read_file(path: &Path, most: u64) -> Answer {
    // Pipes and devices may never end, or keep whoever opens them.
    let refusal = match std::fs::metadata(path) {
        Ok(found) if found.is_dir() => Some("it is a folder"),
        Ok(found) if !found.is_file() => Some("it is a pipe or a device, not a file"),
        Ok(found) if found.len() > most => return Answer::TooLarge(most),
        _ => None,
    };
    if let Some(why) = refusal {
        return Answer::Unreadable(why.into());
    }
    let mut bytes = vec![];
    match std::fs::File::open(path).and_then(|file| file.take(most + 1).read_to_end(&mut bytes)) {
        Ok(_) if bytes.len() as u64 > most => Answer::TooLarge(most),
        Ok(_) => match String::from_utf8(bytes) {
            Ok(text) => Answer::Text(text.into()),
            Err(e) => Answer::Binary(e.into_bytes().into()),
        },
        Err(error) => unread(&error),
    }
}

pub(super) fn unread(error: &io::Error) -> Answer {
    match error.kind() {
        io::ErrorKind::NotFound | io::ErrorKind::NotADirectory => Answer::Missing,
        _ => Answer::Unreadable(error.to_string()),
    }
}

/// The folder above `folder`, or `folder` itself, that is `root`, maybe by a link.
pub(super) fn same_above(folder: &Path, root: &Path) -> Option<PathBuf> {
    let real = root.canonicalize().ok();
    let is_root = |above: &&Path| *above == root || real.is_some() && above.canonicalize().ok() == real;
    folder.ancestors().find(is_root).map(Path::to_path_buf)
}

/// Without `.` and `..`, and without asking the disk: the file may just have been removed.
pub(super) fn lexically_absolute(path: &Path) -> PathBuf {
    let absolute = std::path::absolute(path).unwrap_or_else(|_| path.to_path_buf());
    let mut parts = PathBuf::new();
    for component in absolute.components() {
        match component {
            Component::ParentDir => drop(parts.pop()),
            Component::CurDir => {}
            other => parts.push(other),
        }
    }
    parts
}
