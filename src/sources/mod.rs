//! The only reader of files, which remembers what it was asked for: that list is what live reload watches.
//!
//! In: paths. Out: their texts, and the names by which messages call them. A scene's own files are read
//! through its [`Reach`], which refuses what lies outside of the scene's root.

mod disk;
mod near;
mod reach;

use std::collections::{BTreeMap, BTreeSet};
use std::path::{Path, PathBuf};
use std::sync::{Arc, Mutex};

pub use disk::Disk;
pub use reach::Reach;

use self::disk::{MAX_BYTES, MAX_TEXT, lexically_absolute, read_file, same_above};
use crate::diagnostic::Diagnostic;

/// Files as one compilation sees them: each is read once, so that all stages see the same bytes.
pub struct Sources {
    /// The folder that raytoy runs in.
    here: PathBuf,
    /// The folder that the author names as the root of the scenes.
    named_root: Option<PathBuf>,
    on_disk: bool,
    asked: Mutex<BTreeMap<PathBuf, Answer>>,
    /// The paths of [`Sources::with`].
    given: BTreeSet<PathBuf>,
}

/// The content of a path when it was read.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Answer {
    Text(Arc<str>),
    /// Bytes that are no UTF-8: a picture, or a mistake.
    Binary(Arc<[u8]>),
    Missing,
    Unreadable(String),
    /// It has more than this many bytes.
    TooLarge(u64),
    /// It lies outside of the scene's root, and nobody has looked at it.
    Outside,
}

impl Sources {
    /// The files of this machine. Names in messages are relative to `here`, the folder that raytoy runs in.
    pub fn on_disk(here: &Path) -> Self {
        Self { on_disk: true, ..Self::bare(lexically_absolute(here)) }
    }

    /// No files but those given by [`Sources::with`].
    pub fn in_memory() -> Self {
        Self::bare(PathBuf::from("/"))
    }

    fn bare(here: PathBuf) -> Self {
        let (asked, given) = (Mutex::default(), BTreeSet::new());
        Self { here, named_root: None, on_disk: false, asked, given }
    }

    /// Sets `root` as the root of all scenes below it, if one is named.
    pub fn below(self, root: Option<&Path>) -> Self {
        let named_root = root.map(|root| self.absolute(root));
        Self { named_root, ..self }
    }

    /// Replaces the content of `path` by `text`.
    pub fn with(mut self, path: impl AsRef<Path>, text: &str) -> Self {
        let path = self.absolute(path.as_ref());
        self.asked.lock().expect("no holder panics").insert(path.clone(), Answer::Text(text.into()));
        self.given.insert(path);
        self
    }

    /// The files that a scene in `folder` may name.
    pub fn reach(&self, folder: &Path) -> Reach<'_> {
        let folder = self.absolute(folder);
        let named = self.named_root.as_ref().and_then(|root| same_above(&folder, root));
        let own = || if folder.starts_with(&self.here) { self.here.clone() } else { folder.clone() };
        let root = named.unwrap_or_else(own);
        Reach { sources: self, folder, root }
    }

    /// Returns true if the root that the author names contains `folder`, or if there is no such root.
    pub fn root_holds(&self, folder: &Path) -> bool {
        let folder = self.absolute(folder);
        self.named_root.as_ref().is_none_or(|root| same_above(&folder, root).is_some())
    }

    /// The bytes at `path`, inside the root or not: for files that the user names.
    pub fn read(&self, path: &Path) -> Answer {
        let path = self.absolute(path);
        self.recall(&path, MAX_BYTES, |_| Ok(path.clone()))
    }

    /// The text at `path`, wherever that is.
    ///
    /// # Errors
    /// Why there is none.
    pub fn text(&self, path: &Path) -> Result<Arc<str>, Diagnostic> {
        let path = self.absolute(path);
        self.told(&path, self.recall(&path, MAX_TEXT, |_| Ok(path.clone())))
    }

    /// The bytes at `path`, wherever that is.
    ///
    /// # Errors
    /// Why there are none.
    pub fn bytes(&self, path: &Path) -> Result<Arc<[u8]>, Diagnostic> {
        self.bytes_of(&self.absolute(path), self.read(path))
    }

    /// The answer from before, or else that for the file that `judge` leads to.
    fn recall(&self, path: &Path, most: u64, judge: impl FnOnce(&Path) -> Result<PathBuf, Answer>) -> Answer {
        let known = self.asked.lock().expect("no holder panics").get(path).cloned();
        known.unwrap_or_else(|| {
            let answer = match self.on_disk {
                true => judge(path).map_or_else(|refusal| refusal, |real| read_file(&real, most)),
                false => Answer::Missing,
            };
            self.asked.lock().expect("no holder panics").insert(path.to_path_buf(), answer.clone());
            answer
        })
    }

    /// The bytes of `answer`, which is what is at `path`, or why there are none.
    fn bytes_of(&self, path: &Path, answer: Answer) -> Result<Arc<[u8]>, Diagnostic> {
        match answer {
            Answer::Binary(bytes) => Ok(bytes),
            other => self.told(path, other).map(|text| text.as_bytes().into()),
        }
    }

    /// The text of `answer`, which is what is at `path`, or why there is none.
    fn told(&self, path: &Path, answer: Answer) -> Result<Arc<str>, Diagnostic> {
        let name = self.name(path);
        match answer {
            Answer::Text(text) => Ok(text),
            Answer::Binary(bytes) => {
                let at = std::str::from_utf8(&bytes).map_or_else(|e| e.valid_up_to(), str::len);
                let is_utf16 = bytes.starts_with(&[0xff, 0xfe]) || bytes.starts_with(&[0xfe, 0xff]);
                let problem = |why: String| Diagnostic::error(format!("cannot read `{name}`: {why}"));
                Err(match is_utf16 {
                    true => problem("it is UTF-16 text".into()).help("save it as UTF-8"),
                    false => problem(format!("it is not UTF-8 text (byte {at})")),
                })
            }
            Answer::Missing => Err(Diagnostic::error(format!("there is no file `{name}`"))),
            Answer::Unreadable(why) => Err(Diagnostic::error(format!("cannot read `{name}`: {why}"))),
            Answer::TooLarge(limit) => {
                let why = format!("it is larger than {} MiB", limit >> 20);
                Err(Diagnostic::error(format!("cannot read `{name}`: {why}")))
            }
            Answer::Outside => Err(Diagnostic::error("this file is outside of the scene's root folder")),
        }
    }

    /// Everything that was asked for, and what was found.
    pub fn asked(&self) -> BTreeMap<PathBuf, Answer> {
        self.asked.lock().expect("no holder panics").clone()
    }

    /// The texts that were found, by the names that messages use.
    pub fn texts(&self) -> BTreeMap<String, Arc<str>> {
        let asked = self.asked.lock().expect("no holder panics");
        let found = asked.iter().filter_map(|(path, answer)| match answer {
            Answer::Text(text) => Some((self.name(path), text.clone())),
            _ => None,
        });
        found.collect()
    }

    /// Name of `path` in messages and generated text: relative to the current folder, with `/` everywhere.
    pub fn name(&self, path: &Path) -> String {
        let path = self.absolute(path);
        let short = path.strip_prefix(&self.here).unwrap_or(&path);
        let parts: Vec<_> = short.components().map(|c| c.as_os_str().to_string_lossy()).collect();
        parts.join("/").replacen("//", "/", 1)
    }

    fn absolute(&self, path: &Path) -> PathBuf {
        lexically_absolute(&self.here.join(path))
    }
}
