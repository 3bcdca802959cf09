//! The only reader of files, which remembers what it was asked for: that list is what live reload watches.
//!
//! In: paths. Out: their texts, and the names by which messages call them.

use std::collections::BTreeMap;
use std::io;
use std::path::{Component, Path, PathBuf};
use std::sync::{Arc, Mutex};

use crate::diagnostic::Diagnostic;

/// Files as one compilation sees them: each is read once, so that all stages see the same bytes.
pub struct Sources {
    root: PathBuf,
    on_disk: bool,
    asked: Mutex<BTreeMap<PathBuf, Answer>>,
}

/// What a path held when it was asked for.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Answer {
    Text(Arc<str>),
    /// Bytes that are no UTF-8: a picture, or a mistake.
    Binary(Arc<[u8]>),
    Missing,
    Unreadable(String),
}

impl Sources {
    /// The files of this machine. Names in messages are relative to `root`, the folder that raytoy runs in.
    pub fn on_disk(root: &Path) -> Self {
        let root = lexically_absolute(root);
        Self { root, on_disk: true, asked: Mutex::default() }
    }

    /// No files but those given by [`Sources::with`].
    pub fn in_memory() -> Self {
        Self { root: PathBuf::from("/"), on_disk: false, asked: Mutex::default() }
    }

    /// The same, with `text` in place of what is at `path`.
    pub fn with(self, path: impl AsRef<Path>, text: &str) -> Self {
        let path = self.absolute(path.as_ref());
        self.asked.lock().expect("no holder panics").insert(path, Answer::Text(text.into()));
        self
    }

    /// What is at `path`.
    pub fn read(&self, path: &Path) -> Answer {
        let path = self.absolute(path);
        let known = self.asked.lock().expect("no holder panics").get(&path).cloned();
        known.unwrap_or_else(|| {
            let answer = if self.on_disk { read_file(&path) } else { Answer::Missing };
            self.asked.lock().expect("no holder panics").insert(path, answer.clone());
            answer
        })
    }

    /// The text at `path`, or why there is none.
    pub fn text(&self, path: &Path) -> Result<Arc<str>, Diagnostic> {
        let name = self.name(path);
        match self.read(path) {
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
        }
    }

    /// The bytes at `path`, or why there are none.
    pub fn bytes(&self, path: &Path) -> Result<Arc<[u8]>, Diagnostic> {
        match self.read(path) {
            Answer::Binary(bytes) => Ok(bytes),
            _ => self.text(path).map(|text| text.as_bytes().into()),
        }
    }

    /// The stems of the `.wgsl` files in `folder`, sorted.
    pub fn snippets_in(&self, folder: &Path) -> Vec<String> {
        let folder = self.absolute(folder);
        let mut stems: Vec<String> = self
            .asked
            .lock()
            .expect("no holder panics")
            .iter()
            .filter(|(path, answer)| {
                path.parent() == Some(folder.as_path()) && matches!(answer, Answer::Text(_))
            })
            .filter_map(|(path, _)| snippet_stem(path))
            .collect();
        if self.on_disk
            && let Ok(entries) = std::fs::read_dir(&folder)
        {
            stems.extend(entries.flatten().filter_map(|entry| snippet_stem(&entry.path())));
        }
        stems.sort();
        stems.dedup();
        stems
    }

    /// The folders in which names are looked up for a scene in `folder`, nearest first.
    pub fn folders_above(&self, folder: &Path) -> Vec<PathBuf> {
        let folder = self.absolute(folder);
        let mut above: Vec<PathBuf> = vec![folder.clone()];
        if folder.starts_with(&self.root) {
            above
                .extend(folder.ancestors().skip(1).take_while(|a| a.starts_with(&self.root)).map(Into::into));
        }
        above
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

    /// What messages and generated text call `path`: relative to the root, with `/` on every system.
    pub fn name(&self, path: &Path) -> String {
        let path = self.absolute(path);
        let short = path.strip_prefix(&self.root).unwrap_or(&path);
        let parts: Vec<_> = short.components().map(|c| c.as_os_str().to_string_lossy()).collect();
        parts.join("/").replacen("//", "/", 1)
    }

    fn absolute(&self, path: &Path) -> PathBuf {
        lexically_absolute(&self.root.join(path))
    }
}

/// Without `.` and `..`, and without asking the disk: the file may just have been removed.
fn lexically_absolute(path: &Path) -> PathBuf {
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

fn snippet_stem(path: &Path) -> Option<String> {
    let is_snippet = path.extension().is_some_and(|e| e == "wgsl");
    is_snippet.then(|| path.file_stem()?.to_str().map(str::to_owned)).flatten()
}

fn read_file(path: &Path) -> Answer {
    match std::fs::read(path) {
        Ok(bytes) => match String::from_utf8(bytes) {
            Ok(text) => Answer::Text(text.into()),
            Err(e) => Answer::Binary(e.into_bytes().into()),
        },
        Err(e) if matches!(e.kind(), io::ErrorKind::NotFound | io::ErrorKind::NotADirectory) => {
            Answer::Missing
        }
        Err(e) => Answer::Unreadable(e.to_string()),
    }
}
