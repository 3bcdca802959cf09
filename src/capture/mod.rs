//! Pictures of a scene as files: stills, numbered frames and movies.
//!
//! In: a [`Shot`]. Out: the bytes of a picture, or files. Each file takes its name once it is whole, and a
//! PNG carries the scene that it shows. `progress` gets the share done, 0 to 1, some ten times a second,
//! and may stop it.

mod encode;
mod frames;
mod movie;
mod origin;

use std::io::Write;
use std::ops::ControlFlow;
use std::path::{Path, PathBuf};

pub use encode::jpeg;
pub use frames::{Frames, Numbered, stills};
pub use movie::{MovieFormat, movie};
pub use origin::Origin;

use crate::compile::Compiled;
use crate::frame::Moment;
use crate::gpu::{Gpu, GpuError, MAX_SIDE, Picture, PictureTimes, Renderer};

/// The most pixels of a picture that memory must hold: an EXR file, or a frame of a movie.
const MAX_AT_ONCE: u64 = 1 << 26;

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
    pub small: Small,
}

/// The first moment of a capture in the size [`SMALL`](crate::gpu::SMALL), by which a driver is held to
/// account: only of those that run on the processor, which may draw wrong without a word.
pub type Small = Option<Vec<[f32; 4]>>;

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
    /// Whoever takes the picture's bytes takes no more.
    Output(std::io::Error),
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
    let mut bytes = vec![];
    let times = shot.write(&mut bytes, &mut renderer, format, progress)?;
    Ok(Still { bytes, times, small: shot.small(&renderer)? })
}

/// The same, which goes to `out` as it is drawn: so a PNG file may be larger than the memory, and no
/// bytes are returned.
///
/// # Errors
/// As with [`still`], and where `out` takes no more.
pub fn still_to(
    out: &mut dyn Write,
    shot: &Shot<'_>,
    format: Format,
    progress: &mut dyn FnMut(f32) -> ControlFlow<()>,
) -> Result<Still, CaptureError> {
    let mut renderer = shot.renderer()?;
    let times = shot.write(out, &mut renderer, format, progress)?;
    Ok(Still { bytes: vec![], times, small: shot.small(&renderer)? })
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
        let pixels = u64::from(self.size[0]) * u64::from(self.size[1]);
        if pixels > MAX_AT_ONCE {
            let why = format!(
                "a picture of {}x{} is too large for this format, which takes {MAX_AT_ONCE} pixels, \
                 such as 8192x8192; PNG pictures go to {MAX_SIDE}x{MAX_SIDE}",
                self.size[0], self.size[1]
            );
            return Err(CaptureError::Format(why));
        }
        renderer.draw(&self.moment, self.samples, progress)?.ok_or(CaptureError::Stopped)
    }

    fn small(&self, renderer: &Renderer) -> Result<Small, CaptureError> {
        let moment = Moment { split: None, ..self.moment };
        Ok(self.gpu.is_software().then(|| renderer.small(&moment)).transpose()?)
    }

    fn write(
        &self,
        out: &mut dyn Write,
        renderer: &mut Renderer,
        format: Format,
        progress: &mut dyn FnMut(f32) -> ControlFlow<()>,
    ) -> Result<PictureTimes, CaptureError> {
        if format == Format::Exr {
            let picture = self.picture(renderer, progress)?;
            let bytes = encode::exr(&picture, &renderer.identity(&self.moment)?)?;
            out.write_all(&bytes).map_err(CaptureError::Output)?;
            return Ok(picture.times);
        }
        encode::png(out, self.size, &Origin::of(self), |take| {
            let mut failure = None;
            let times = renderer.draw_strips(&self.moment, self.samples, progress, &mut |strip| {
                failure = take(&strip).err();
                if failure.is_none() { ControlFlow::Continue(()) } else { ControlFlow::Break(()) }
            })?;
            failure.map_or(times.ok_or(CaptureError::Stopped), |error| Err(CaptureError::Output(error)))
        })
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
            CaptureError::Output(error) => write!(f, "cannot write the picture: {error}"),
            CaptureError::NoFfmpeg => f.write_str(
                "movies need ffmpeg, which is not installed\n  \
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
