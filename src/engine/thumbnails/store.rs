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
fn prune(folder: &Path, most: usize) {
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

#[cfg(test)]
mod tests {
    use std::fs::{self, File};
    use std::time::{Duration, SystemTime};

    use tempfile::TempDir;

    use super::*;

    const SIZE: [u32; 2] = [8, 8];

    fn red() -> Picture {
        let rgba = [255, 0, 0, 255].repeat(64);
        Picture { size: SIZE, rgba, radiance: vec![], depth: vec![], times: Default::default() }
    }

    fn is_red(image: &Thumbnail) -> bool {
        // A JPEG is not exact.
        image.rgba.chunks(4).all(|pixel| pixel[0] > 245 && pixel[1] < 10 && pixel[2] < 10)
    }

    #[test]
    fn a_thumbnail_is_there_the_next_day_under_its_digest_and_size() {
        let home = TempDir::new().expect("there is room for a folder");
        let folder = Some(home.path().join("a/b"));
        let subject = Subject::Scene("red.ron".into());
        Store::open(folder.clone()).keep(&subject, 7, &red());
        let mut store = Store::open(folder.clone());
        assert!(store.find(&subject, 8, SIZE).is_none());
        assert!(store.find(&subject, 7, [9, 8]).is_none());
        assert!(store.find(&subject, 7, SIZE).is_some_and(|image| is_red(&image)));
        let file = home.path().join("a/b/0000000000000007.jpg");
        fs::write(&file, "no picture").expect("it is writable");
        assert!(store.find(&subject, 7, SIZE).is_some(), "memory has it still");
        assert!(Store::open(folder).find(&subject, 7, SIZE).is_none());
    }

    #[test]
    fn without_a_folder_they_are_known_until_the_subject_changes() {
        let mut store = Store::open(None);
        let subject = Subject::Scene("red.ron".into());
        assert!(store.find(&subject, 7, SIZE).is_none());
        assert!(is_red(&store.keep(&subject, 7, &red())));
        assert!(store.find(&subject, 7, SIZE).is_some());
        store.keep(&subject, 8, &red());
        assert!(store.find(&subject, 7, SIZE).is_none());
    }

    #[test]
    fn the_oldest_go_and_what_is_not_ours_stays() {
        let home = TempDir::new().expect("there is room for a folder");
        for (age, name) in ["new.jpg", "old.jpg", "older.jpg", "mine.txt"].iter().enumerate() {
            let file = File::create(home.path().join(name)).expect("the folder is writable");
            let then = SystemTime::now() - Duration::from_secs(100 * age as u64);
            file.set_modified(then).expect("it is ours");
        }
        prune(home.path(), 2);
        let left = |name: &str| home.path().join(name).exists();
        assert_eq!(["new.jpg", "old.jpg", "older.jpg", "mine.txt"].map(left), [true, true, false, true]);
    }
}
