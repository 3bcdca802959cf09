//! Files of a scene that are no text: images and models.
//!
//! In: the bytes of a file. Out: an [`Image`] or a [`Model`], and warnings where the file is odd.

mod image;
mod model;

pub use self::image::{Channel, Image, Level, Reading};
pub use self::model::{Corner, Model};

/// Whether Git LFS has not fetched a file yet: then a few lines of text are in its place.
pub fn is_lfs_pointer(bytes: &[u8]) -> bool {
    bytes.starts_with(b"version https://git-lfs")
}
