//! Picture files as data: decoded to light or to numbers, with smaller versions of themselves for a distance.

mod chunks;
mod contents;
mod gamma;
mod openexr;
mod radiance;

use std::fmt;
use std::io::Cursor;
use std::sync::Arc;

use glam::Vec4;
use image::metadata::Orientation;
use image::{DynamicImage, ImageDecoder, ImageError, ImageFormat, ImageReader};

use self::gamma::Curve;

/// A picture, rows from the top.
#[derive(Clone)]
pub struct Image {
    /// The file's name, as messages use it.
    pub file: String,
    /// Of the file's bytes: two images of one file are the same where this and `reading` are.
    pub digest: u64,
    pub reading: Reading,
    /// Whether it is clear in places.
    pub has_alpha: bool,
    /// What was odd but not wrong, in words that follow the file's name.
    pub warning: Option<String>,
    /// The picture first, then each half as wide and as high, down to one texel.
    pub levels: Arc<[Level]>,
}

/// What the bytes of a picture are taken for.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Reading {
    /// Whether they stand for light by a curve, sRGB unless the file says otherwise; else they are numbers
    /// as they are.
    pub has_curve: bool,
    /// Whether the picture is a number at each place: which one.
    pub channel: Option<Channel>,
}

/// A number of a color.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Channel {
    Luminance,
    Red,
    Green,
    Blue,
    Alpha,
}

/// One of the sizes of an image.
#[derive(Clone, Debug, PartialEq)]
pub struct Level {
    /// Texels.
    pub size: [u32; 2],
    /// Linear red, green and blue times alpha, and alpha; or a number times alpha, twice 0, and alpha. So
    /// nothing of a color that is clear comes in where texels are mixed.
    pub texels: Vec<Vec4>,
}

/// The longest side, texels: what every GPU takes.
const LONGEST: u32 = 8192;

impl Image {
    /// In which such files end.
    pub const EXTENSIONS: &'static [&'static str] = &["png", "jpg", "jpeg", "hdr", "exr"];

    /// Decodes PNG, JPEG, Radiance HDR or OpenEXR, whatever the file is called; `digest` is of `bytes`.
    ///
    /// # Errors
    /// Why it cannot be shown, in words that follow the file's name.
    pub fn decode(file: String, digest: u64, bytes: &[u8], reading: Reading) -> Result<Self, String> {
        let (picture, curve) = if radiance::is_radiance(bytes) {
            (radiance::decode(bytes)?, Curve::Linear)
        } else if openexr::is_openexr(bytes) {
            (openexr::decode(bytes)?, Curve::Linear)
        } else {
            (decode_upright(bytes)?, gamma::curve_of(bytes))
        };
        let curve = if reading.has_curve { curve } else { Curve::Linear };
        let has_alpha = picture.color().has_alpha();
        let picture = picture.into_rgba32f();
        let size = [picture.width(), picture.height()];
        let texels: Vec<Vec4> = picture.pixels().map(|p| texel(p.0, curve, reading.channel)).collect();
        let has_alpha = has_alpha && texels.iter().any(|texel| texel.w < 1.0);
        let mut levels = vec![Level { size, texels }];
        while levels[levels.len() - 1].size != [1, 1] {
            levels.push(levels[levels.len() - 1].halved());
        }
        let is_short = bytes.starts_with(b"\xff\xd8") && contents::ends_early(bytes);
        let warning =
            is_short.then(|| "ends early, so its lower part is missing: fetch or save it again".into());
        Ok(Self { file, digest, reading, has_alpha, warning, levels: levels.into() })
    }
}

/// A picture as its camera was held, which files say beside its pixels (EXIF).
fn decode_upright(bytes: &[u8]) -> Result<DynamicImage, String> {
    let damaged = |error: ImageError| match &error {
        ImageError::Unsupported(_) => {
            format!("has a format that raytoy cannot read ({error}): save it as PNG")
        }
        _ => format!("is damaged or ends early: {error}"),
    };
    let reader = ImageReader::new(Cursor::new(bytes)).with_guessed_format();
    let reader = reader.expect("bytes in memory can be read");
    if !matches!(reader.format(), Some(ImageFormat::Png | ImageFormat::Jpeg)) {
        return Err(contents::refusal(bytes));
    }
    let mut decoder = reader.into_decoder().map_err(damaged)?;
    let (width, height) = decoder.dimensions();
    check_size([width, height])?;
    // In a PNG it may also stand behind the pixels, where the decoder has not been yet.
    let beside = chunks::chunks(bytes).find(|(name, _)| name == b"eXIf");
    let orientation = match beside {
        Some((_, exif)) => Orientation::from_exif_chunk(exif),
        None => decoder.orientation().ok(),
    };
    let mut picture = DynamicImage::from_decoder(decoder).map_err(damaged)?;
    picture.apply_orientation(orientation.unwrap_or(Orientation::NoTransforms));
    Ok(picture)
}

fn check_size(size: [u32; 2]) -> Result<(), String> {
    if size.iter().any(|n| *n > LONGEST || *n == 0) {
        return Err(format!(
            "has {}x{} pixels, but at most {LONGEST}x{LONGEST} are allowed",
            size[0], size[1]
        ));
    }
    Ok(())
}

fn texel([r, g, b, alpha]: [f32; 4], curve: Curve, channel: Option<Channel>) -> Vec4 {
    let [r, g, b] = [r, g, b].map(|x| curve.light(x));
    let color = Vec4::new(alpha * r, alpha * g, alpha * b, alpha);
    let number = |x: f32, alpha: f32| Vec4::new(x, 0.0, 0.0, alpha);
    match channel {
        None => color,
        // Rec. 709.
        Some(Channel::Luminance) => number(color.dot(Vec4::new(0.2126, 0.7152, 0.0722, 0.0)), alpha),
        Some(Channel::Red) => number(r, 1.0),
        Some(Channel::Green) => number(g, 1.0),
        Some(Channel::Blue) => number(b, 1.0),
        Some(Channel::Alpha) => number(alpha, 1.0),
    }
}

impl PartialEq for Image {
    fn eq(&self, other: &Self) -> bool {
        self.file == other.file && self.digest == other.digest && self.reading == other.reading
    }
}

impl fmt::Debug for Image {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "Image({}, {:?}, {:?})", self.file, self.levels[0].size, self.reading)
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
