//! Pictures of a scene as files: stills, numbered frames and movies.
//!
//! In: a [`Shot`]. Out: the bytes of a picture, or files. Each file takes its name once it is whole, and a
//! PNG carries the scene that it shows. Who waits is told the share done, 0 to 1, some ten times a second,
//! and may stop it.

mod encode;
mod files;
mod frames;
mod movie;
mod origin;

use std::ops::ControlFlow;
use std::path::{Path, PathBuf};

pub use encode::jpeg;
pub use files::write_file;
pub use frames::{Frames, Numbered, stills};
pub use movie::{MovieFormat, movie};
pub use origin::Origin;

use crate::Compiled;
use crate::gpu::{Gpu, GpuError, Moment, Picture, PictureTimes, Renderer};

/// What to take a picture of, and how.
#[derive(Clone, Copy, Debug)]
pub struct Shot<'a> {
    pub gpu: &'a Gpu,
    pub compiled: &'a Compiled,
    pub moment: Moment,
    /// Pixels.
    pub size: [u32; 2],
    /// For each pixel.
    pub samples: u32,
}

/// The file formats of one picture.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Format {
    /// As a screen shows it, with its [`Origin`].
    Png,
    /// Linear light before exposure, the distance and the object, as 32-bit floats.
    Exr,
}

/// A picture as a file's bytes.
#[derive(Clone, Debug, PartialEq)]
pub struct Still {
    pub bytes: Vec<u8>,
    pub times: PictureTimes,
    /// One sample of the same moment in the size `SAMPLE`, by which a driver is held to account: only of
    /// those that run on the processor, which may draw wrong without a word.
    pub sample: Option<Vec<[f32; 4]>>,
}

/// Pixels of a [`Still::sample`].
pub const SAMPLE: [u32; 2] = [16, 16];

/// Why there is no capture.
#[derive(Debug)]
pub enum CaptureError {
    /// Who waited for it stopped it.
    Stopped,
    Gpu(GpuError),
    /// The picture does not fit into the format, for this reason.
    Format(String),
    /// The file cannot be written.
    File(PathBuf, std::io::Error),
    /// There is no ffmpeg on this machine.
    NoFfmpeg,
    /// ffmpeg did not do its work: what it said.
    Ffmpeg(String),
}

/// A picture in a file's format, the same bytes each time.
///
/// # Errors
/// Where the GPU refuses the scene or the size, or `progress` stops it.
pub fn still(
    shot: &Shot<'_>,
    format: Format,
    progress: &mut dyn FnMut(f32) -> ControlFlow<()>,
) -> Result<Still, CaptureError> {
    let mut renderer = shot.renderer()?;
    let mut still = shot.still(&mut renderer, format, progress)?;
    if shot.gpu.is_software() {
        still.sample = Some(renderer.sample(&Moment { split: None, ..shot.moment }, SAMPLE)?);
    }
    Ok(still)
}

impl Format {
    /// The format that a file's name asks for.
    pub fn of(path: &Path) -> Option<Self> {
        match extension(path).as_str() {
            "png" => Some(Format::Png),
            "exr" => Some(Format::Exr),
            _ => None,
        }
    }
}

impl Shot<'_> {
    fn renderer(&self) -> Result<Renderer, CaptureError> {
        Ok(Renderer::new(self.gpu, self.compiled, self.size)?)
    }

    fn picture(
        &self,
        renderer: &mut Renderer,
        progress: &mut dyn FnMut(f32) -> ControlFlow<()>,
    ) -> Result<Picture, CaptureError> {
        renderer.draw(&self.moment, self.samples, progress)?.ok_or(CaptureError::Stopped)
    }

    fn still(
        &self,
        renderer: &mut Renderer,
        format: Format,
        progress: &mut dyn FnMut(f32) -> ControlFlow<()>,
    ) -> Result<Still, CaptureError> {
        let (picture, bytes) = match format {
            Format::Png => {
                let picture = self.picture(renderer, progress)?;
                let bytes = encode::png(&picture, &Origin::of(self))?;
                (picture, bytes)
            }
            Format::Exr => {
                let picture = self.picture(renderer, progress)?;
                let bytes = encode::exr(&picture, &renderer.identity(&self.moment)?)?;
                (picture, bytes)
            }
        };
        Ok(Still { bytes, times: picture.times, sample: None })
    }
}

impl From<GpuError> for CaptureError {
    fn from(error: GpuError) -> Self {
        CaptureError::Gpu(error)
    }
}

impl std::fmt::Display for CaptureError {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        match self {
            CaptureError::Stopped => write!(f, "stopped"),
            CaptureError::Gpu(error) => write!(f, "{error}"),
            CaptureError::Format(why) => write!(f, "{why}"),
            CaptureError::File(path, error) => write!(f, "cannot write `{}`: {error}", path.display()),
            CaptureError::NoFfmpeg => f.write_str(
                "movies are made by ffmpeg, which is not installed\n  \
                 Debian, Ubuntu  apt install ffmpeg\n  \
                 Fedora          dnf install ffmpeg, from rpmfusion.org\n  \
                 Arch            pacman -S ffmpeg\n  \
                 macOS           brew install ffmpeg\n  \
                 Windows         winget install ffmpeg\n\
                 without it, write the frames as pictures: `-o frames/####.png`",
            ),
            CaptureError::Ffmpeg(why) => write!(f, "ffmpeg made no movie: {why}"),
        }
    }
}

impl std::error::Error for CaptureError {
    fn source(&self) -> Option<&(dyn std::error::Error + 'static)> {
        match self {
            CaptureError::Gpu(error) => Some(error),
            _ => None,
        }
    }
}

/// What follows the last dot of a file's name, in lower case.
fn extension(path: &Path) -> String {
    path.extension().unwrap_or_default().to_string_lossy().to_lowercase()
}
