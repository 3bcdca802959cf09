//! Goldens: where they lie, and the only writer of them.

use std::path::{Path, PathBuf};

use image::{ImageFormat, RgbImage};

use super::Case;
use crate::assets::is_lfs_pointer;

/// Where goldens lie.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Goldens {
    /// A folder that mirrors the scenes'; None where goldens lie beside the scenes.
    pub folder: Option<PathBuf>,
    /// A part of the adapter's name where it was asked for by one: its pictures are `x.NAME.png` where there
    /// are such.
    pub adapter: Option<String>,
}

impl Goldens {
    /// The golden of `case` with this extension.
    pub fn path(&self, case: &Case, extension: &str) -> PathBuf {
        let beside = case.path.with_extension(extension);
        match &self.folder {
            None => beside,
            Some(folder) => {
                folder.join(Path::new(case.name.trim_start_matches('/'))).with_extension(extension)
            }
        }
    }

    /// The picture to compare with, and the one to write.
    pub fn pictures(&self, case: &Case) -> [PathBuf; 2] {
        let shared = self.path(case, "png");
        let Some(adapter) = &self.adapter else { return [shared.clone(), shared] };
        let name: String = adapter.chars().map(|c| if c.is_alphanumeric() { c } else { '-' }).collect();
        let own = self.path(case, &format!("{name}.png"));
        if own.exists() { [own.clone(), own] } else { [shared, own] }
    }
}

const NOT_FETCHED: &str = "it is a pointer of Git LFS, not the golden: `git lfs pull` fetches it";

/// The text of a golden; None where there is none.
///
/// # Errors
/// Why it cannot be read.
pub fn read_text(path: &Path) -> Result<Option<String>, String> {
    match std::fs::read_to_string(path) {
        Ok(text) if is_lfs_pointer(text.as_bytes()) => Err(NOT_FETCHED.into()),
        // A checkout on Windows may have changed the ends of the lines.
        Ok(text) => Ok(Some(text.replace("\r\n", "\n"))),
        Err(error) if error.kind() == std::io::ErrorKind::NotFound => Ok(None),
        Err(error) => Err(error.to_string()),
    }
}

/// The picture of a golden; None where there is none.
///
/// # Errors
/// Why it cannot be read.
pub fn read_picture(path: &Path) -> Result<Option<RgbImage>, String> {
    match std::fs::read(path) {
        Ok(bytes) if is_lfs_pointer(&bytes) => Err(NOT_FETCHED.into()),
        Ok(bytes) => match image::load_from_memory_with_format(&bytes, ImageFormat::Png) {
            Ok(picture) => Ok(Some(picture.to_rgb8())),
            Err(error) => Err(error.to_string()),
        },
        Err(error) if error.kind() == std::io::ErrorKind::NotFound => Ok(None),
        Err(error) => Err(error.to_string()),
    }
}

/// Writes a golden, with the folders that it lies in.
///
/// # Errors
/// Why it cannot be written.
pub fn write(path: &Path, bytes: &[u8]) -> Result<(), String> {
    let folder = path.parent().unwrap_or(Path::new(""));
    let written = std::fs::create_dir_all(folder).and_then(|()| std::fs::write(path, bytes));
    written.map_err(|error| format!("cannot write `{}`: {error}", path.display()))
}
