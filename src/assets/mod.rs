//! Files of a scene that are no text: images and models.
//!
//! In: the bytes of a file. Out: an [`Image`] or a [`Model`], and warnings where the file is odd.

mod image;
mod model;

pub use self::image::{Channel, Image, Level, Reading};
pub use self::model::{Corner, Model};
