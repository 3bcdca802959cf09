//! Thumbnails that were drawn before, by a digest of all that they show: in memory, and in a folder.
//!
//! A file that is missing or damaged counts as none, and one that cannot be written is drawn again next time.

use std::collections::BTreeMap;
use std::path::{Path, PathBuf};
use std::sync::Arc;

use super::Subject;
use crate::capture::jpeg;
use crate::files::write_file;
use crate::gpu::Picture;

/// Files that the folder may hold; the oldest go first.
const MAX_FILES: usize = 2000;

/// A small picture, by rows from the top.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Thumbnail {
    pub size: [u32; 2],
    /// Red, green, blue, opaque: as a screen shows it.
    pub rgba: Vec<u8>,
}

pub struct Store {
    folder: Option<PathBuf>,
    /// The last one of each subject.
    known: BTreeMap<Subject, (u64, Arc<Thumbnail>)>,
}

impl Store {
    /// Without a folder, they are kept only as long as the window is open.
    pub fn open(folder: Option<PathBuf>) -> Self {
        if let Some(folder) = &folder {
            prune(folder, MAX_FILES);
        }
        Self { folder, known: BTreeMap::new() }
    }

    /// The thumbnail with this digest, of so many pixels.
    pub fn find(&mut self, subject: &Subject, digest: u64, size: [u32; 2]) -> Option<Arc<Thumbnail>> {
        if let Some((known, image)) = self.known.get(subject)
            && *known == digest
        {
            return Some(image.clone());
        }
        let bytes = std::fs::read(self.file(digest)?).ok()?;
        let decoded = image::load_from_memory_with_format(&bytes, image::ImageFormat::Jpeg).ok()?.to_rgba8();
        if [decoded.width(), decoded.height()] != size {
            return None;
        }
        Some(self.remember(subject, digest, size, decoded.as_raw()))
    }

    pub fn keep(&mut self, subject: &Subject, digest: u64, picture: &Picture) -> Arc<Thumbnail> {
        if let Some((file, bytes)) = self.file(digest).zip(jpeg(picture).ok()) {
            let folder = file.parent().unwrap_or(Path::new(""));
            let _ = std::fs::create_dir_all(folder).and_then(|()| write_file(&file, &bytes));
        }
        self.remember(subject, digest, picture.size, &picture.rgba)
    }

    fn remember(&mut self, subject: &Subject, digest: u64, size: [u32; 2], rgba: &[u8]) -> Arc<Thumbnail> {
        let image = Arc::new(Thumbnail { size, rgba: rgba.to_vec() });
        self.known.insert(subject.clone(), (digest, image.clone()));
        image
    }

    fn file(&self, digest: u64) -> Option<PathBuf> {
        Some(self.folder.as_ref()?.join(format!("{digest:016x}.jpg")))
    }
}

/// Removes the oldest thumbnails of `folder` above `most`.
pub fn prune(folder: &Path, most: usize) {
    let files = std::fs::read_dir(folder).into_iter().flatten().flatten().filter_map(|entry| {
        let is_ours = entry.path().extension().is_some_and(|ending| ending == "jpg");
        let age = entry.metadata().ok().filter(|_| is_ours)?.modified().ok()?;
        Some((age, entry.path()))
    });
    let mut files: Vec<_> = files.collect();
    files.sort();
    for (_, file) in files.iter().take(files.len().saturating_sub(most)) {
        let _ = std::fs::remove_file(file);
    }
}
