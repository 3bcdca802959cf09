//! Files that are whole at all times: what was there before, or all that is new.

use std::ffi::OsString;
use std::fs::{self, File, OpenOptions, Permissions};
use std::io::{self, BufWriter, Write};
use std::path::{Path, PathBuf};

/// A file in the making: it lies beside the one that it is to replace, and is removed with this value unless
/// it is kept.
#[derive(Debug)]
pub struct Draft {
    path: PathBuf,
    /// Where it belongs.
    place: PathBuf,
    /// Those of the file that it replaces.
    permissions: Option<Permissions>,
}

/// Writes `bytes` to the file at `path`; a device or a pipe there gets them as they come.
///
/// # Errors
/// Where the file cannot be written.
pub fn write_file(path: &Path, bytes: &[u8]) -> io::Result<()> {
    write_file_with(path, |out| out.write_all(bytes))?
}

/// The same with what `write` writes. The file is kept only where that works.
///
/// # Errors
/// Where the file cannot be written; inside, what `write` returns.
pub fn write_file_with<T, E>(
    path: &Path,
    write: impl FnOnce(&mut dyn Write) -> Result<T, E>,
) -> io::Result<Result<T, E>> {
    let draft = if is_special(path) { None } else { Some(Draft::beside(path)?) };
    let mut out = BufWriter::new(File::create(draft.as_ref().map_or(path, Draft::path))?);
    let written = write(&mut out);
    if written.is_ok() {
        out.flush()?;
        drop(out);
        draft.map_or(Ok(()), Draft::keep)?;
    }
    Ok(written)
}

impl Draft {
    /// An empty file called as the one at `path`, with `.part` behind.
    ///
    /// # Errors
    /// Where one of the two cannot be written, or `path` is no place for a file.
    pub fn beside(path: &Path) -> io::Result<Self> {
        if is_special(path) {
            return Err(io::Error::other("it is not a file"));
        }
        // A link stays one: what it leads to is replaced.
        let place = if path.is_symlink() { fs::canonicalize(path)? } else { path.to_owned() };
        let permissions = match OpenOptions::new().write(true).open(&place) {
            Ok(file) => Some(file.metadata()?.permissions()),
            Err(error) if error.kind() == io::ErrorKind::NotFound => None,
            Err(error) => return Err(error),
        };
        let mut name = place.file_name().map_or_else(OsString::new, OsString::from);
        name.push(".part");
        let path = place.with_file_name(name);
        File::create(&path)?;
        Ok(Self { path, place, permissions })
    }

    /// Where to write.
    pub fn path(&self) -> &Path {
        &self.path
    }

    /// Puts it in its place.
    ///
    /// # Errors
    /// Where the system refuses; then the file is as it was before.
    pub fn keep(mut self) -> io::Result<()> {
        if let Some(permissions) = self.permissions.take() {
            fs::set_permissions(&self.path, permissions)?;
        }
        fs::rename(&self.path, &self.place)
    }
}

impl Drop for Draft {
    fn drop(&mut self) {
        // It is not there any more if it was kept.
        let _ = fs::remove_file(&self.path);
    }
}

/// Whether there is something at `path` that no other file can take the place of, such as a device.
fn is_special(path: &Path) -> bool {
    fs::metadata(path).is_ok_and(|found| !found.is_file() && !found.is_dir())
}
