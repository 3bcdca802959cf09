//! Picture files as data: decoded to linear RGB, with smaller versions of themselves for a distance.

use std::fmt;
use std::sync::Arc;

use glam::Vec3;

/// A picture, rows from the top.
#[derive(Clone)]
pub struct Image {
    /// The file's name, as messages use it.
    pub file: String,
    /// Of the file's bytes: two images of one file are the same where this is.
    pub digest: u64,
    /// The picture first, then each half as wide and as high, down to one texel.
    pub levels: Arc<[Level]>,
}

/// One of the sizes of an image.
#[derive(Clone, Debug, PartialEq)]
pub struct Level {
    /// Texels.
    pub size: [u32; 2],
    /// Linear RGB.
    pub texels: Vec<Vec3>,
}

/// The longest side, texels: what every GPU takes.
const LONGEST: u32 = 8192;

impl Image {
    /// Decodes PNG, JPEG or Radiance HDR; `digest` is of `bytes`.
    ///
    /// # Errors
    /// Why it cannot be shown, in words that follow the file's name.
    pub fn decode(file: String, digest: u64, bytes: &[u8]) -> Result<Self, String> {
        let picture = image::load_from_memory(bytes).map_err(|error| match error {
            image::ImageError::Unsupported(_) => "is neither PNG, JPEG nor Radiance HDR".to_owned(),
            other => format!("is damaged: {other}"),
        })?;
        let size = [picture.width(), picture.height()];
        if size.iter().any(|n| *n > LONGEST || *n == 0) {
            return Err(format!("has {}x{} pixels, and {LONGEST}x{LONGEST} are the most", size[0], size[1]));
        }
        let holds_light = matches!(picture, image::DynamicImage::ImageRgb32F(_));
        let linear = |x: f32| if holds_light { x } else { from_srgb(x) };
        let texels = picture.into_rgb32f().pixels().map(|p| Vec3::from(p.0.map(linear))).collect();
        let mut levels = vec![Level { size, texels }];
        while levels[levels.len() - 1].size != [1, 1] {
            levels.push(levels[levels.len() - 1].halved());
        }
        Ok(Self { file, digest, levels: levels.into() })
    }
}

impl PartialEq for Image {
    fn eq(&self, other: &Self) -> bool {
        self.file == other.file && self.digest == other.digest
    }
}

impl fmt::Debug for Image {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "Image({}, {:?})", self.file, self.levels[0].size)
    }
}

impl Level {
    /// Means of two by two texels; of a side that is odd the last texel goes in twice.
    fn halved(&self) -> Self {
        let size = self.size.map(|n| (n / 2).max(1));
        let at = |x: u32, y: u32| {
            let (x, y) = (x.min(self.size[0] - 1), y.min(self.size[1] - 1));
            self.texels[(y * self.size[0] + x) as usize]
        };
        let mean = |x: u32, y: u32| {
            let (x, y) = (2 * x, 2 * y);
            0.25 * (at(x, y) + at(x + 1, y) + at(x, y + 1) + at(x + 1, y + 1))
        };
        let texels = (0..size[1]).flat_map(|y| (0..size[0]).map(move |x| mean(x, y))).collect();
        Self { size, texels }
    }
}

/// The sRGB curve, IEC 61966-2-1.
fn from_srgb(x: f32) -> f32 {
    if x <= 0.04045 { x / 12.92 } else { ((x + 0.055) / 1.055).powf(2.4) }
}
