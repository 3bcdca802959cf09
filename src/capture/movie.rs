//! Frames of a scene that moves, as a movie: they go to ffmpeg as they are drawn.

use std::ffi::OsString;
use std::io::{ErrorKind, Read, Write};
use std::ops::ControlFlow;
use std::path::Path;
use std::process::{Child, Command, Stdio};
use std::sync::mpsc::{Receiver, RecvTimeoutError, channel};
use std::time::Duration;

use super::{CaptureError, Frames, Shot, Small, extension};
use crate::files::Draft;
use crate::gpu::PictureTimes;

/// The file formats of a movie.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum MovieFormat {
    /// H.264, which plays everywhere.
    Mp4,
    /// VP9.
    Webm,
    /// 256 colors, the same in all frames.
    Gif,
}

/// Browsers slow down what goes faster.
const FASTEST_GIF: f64 = 50.0;

/// Writes `frames` to a movie at `path`; `shot` says all but the time. Returns what each took, and the first
/// one small. Whatever happens, the file is the one before or the whole new one.
///
/// # Errors
/// Where there is no ffmpeg or it fails, the format does not take the size or the rate, the GPU refuses the
/// scene, the file cannot be written, or `progress` stops it.
pub fn movie(
    shot: &Shot<'_>,
    frames: &Frames,
    path: &Path,
    format: MovieFormat,
    progress: &mut dyn FnMut(f32) -> ControlFlow<()>,
) -> Result<(Vec<PictureTimes>, Small), CaptureError> {
    format.check(shot.size, frames.rate)?;
    let unwritten = |error| CaptureError::File(path.to_owned(), error);
    let draft = Draft::beside(path).map_err(unwritten)?;
    let mut ffmpeg = Ffmpeg::start(&arguments(shot.size, frames.rate, format, draft.path()))?;
    let mut renderer = shot.renderer()?;
    let times = frames.each(shot, progress, |_, shot, progress| {
        let picture = shot.picture(&mut renderer, progress)?;
        ffmpeg.take(&picture.rgba)?;
        Ok(picture.times)
    })?;
    ffmpeg.finish(progress)?;
    draft.keep().map_err(unwritten)?;
    Ok((times, frames.shot(shot, frames.numbers.start).small(&renderer)?))
}

impl MovieFormat {
    /// The format that a file's name asks for.
    pub fn of(path: &Path) -> Option<Self> {
        match extension(path).as_str() {
            "mp4" => Some(MovieFormat::Mp4),
            "webm" => Some(MovieFormat::Webm),
            "gif" => Some(MovieFormat::Gif),
            _ => None,
        }
    }

    fn check(self, [width, height]: [u32; 2], rate: f64) -> Result<(), CaptureError> {
        // A pixel of color stands for two by two of brightness.
        if self == MovieFormat::Mp4 && !(width % 2 == 0 && height % 2 == 0) {
            let even = [width, height].map(|n| n.next_multiple_of(2));
            return Err(CaptureError::Format(format!(
                "width and height of an .mp4 movie must be even: {}x{} instead of {width}x{height}",
                even[0], even[1]
            )));
        }
        if self == MovieFormat::Gif && rate > FASTEST_GIF {
            let why = format!("a .gif movie has at most {FASTEST_GIF} frames per second, not {rate}");
            return Err(CaptureError::Format(why));
        }
        Ok(())
    }
}

/// What to call ffmpeg with.
fn arguments([width, height]: [u32; 2], rate: f64, format: MovieFormat, output: &Path) -> Vec<OsString> {
    let taken = format!(
        "-hide_banner -loglevel error -y \
         -f rawvideo -pixel_format rgba -video_size {width}x{height} -framerate {rate} -i pipe:0"
    );
    // Colors as the matrix of HDTV has them, and tagged so: players guess by the size where nothing is said.
    let colors = "-vf scale=out_color_matrix=bt709:out_range=tv -pix_fmt yuv420p \
                  -colorspace bt709 -color_primaries bt709 -color_trc iec61966-2-1 -color_range tv";
    let made = match format {
        MovieFormat::Mp4 => {
            format!("-c:v libx264 -preset slow -crf 16 {colors} -movflags +faststart -f mp4")
        }
        MovieFormat::Webm => format!("-c:v libvpx-vp9 -crf 20 -b:v 0 -row-mt 1 {colors} -f webm"),
        MovieFormat::Gif => {
            "-filter_complex split[seen][drawn];[seen]palettegen[palette];[drawn][palette]paletteuse -f gif"
                .into()
        }
    };
    let words = format!("{taken} {made}");
    // Without the protocol, a name with a colon would be taken for one.
    let mut file = OsString::from("file:");
    file.push(output);
    words.split(' ').map(OsString::from).chain([file]).collect()
}

/// The program at work. It ends with this value.
struct Ffmpeg {
    child: Child,
    /// All that it said, once it has ended.
    said: Receiver<String>,
}

impl Ffmpeg {
    fn start(arguments: &[OsString]) -> Result<Self, CaptureError> {
        let mut command = Command::new("ffmpeg");
        command.args(arguments).stdin(Stdio::piped()).stdout(Stdio::null()).stderr(Stdio::piped());
        let mut child = command.spawn().map_err(|error| match error.kind() {
            ErrorKind::NotFound => CaptureError::NoFfmpeg,
            _ => CaptureError::Ffmpeg(error.to_string()),
        })?;
        let mut errors = child.stderr.take().expect("it is piped");
        let (sender, said) = channel();
        // On a thread of its own: ffmpeg would wait for a reader, and we for ffmpeg.
        std::thread::spawn(move || {
            let mut text = vec![];
            let _ = errors.read_to_end(&mut text);
            let _ = sender.send(String::from_utf8_lossy(&text).trim().to_owned());
        });
        Ok(Self { child, said })
    }

    /// Hands over a frame.
    fn take(&mut self, rgba: &[u8]) -> Result<(), CaptureError> {
        let input = self.child.stdin.as_mut().expect("it is open until the end");
        let written = input.write_all(rgba);
        written.map_err(|error| {
            self.end();
            let said = self.said.recv().unwrap_or_default();
            CaptureError::Ffmpeg(if said.is_empty() { error.to_string() } else { said })
        })
    }

    /// Waits until the movie is whole.
    fn finish(mut self, progress: &mut dyn FnMut(f32) -> ControlFlow<()>) -> Result<(), CaptureError> {
        drop(self.child.stdin.take());
        let said = loop {
            match self.said.recv_timeout(Duration::from_millis(100)) {
                Err(RecvTimeoutError::Timeout) if progress(1.0).is_break() => {
                    return Err(CaptureError::Stopped);
                }
                Err(RecvTimeoutError::Timeout) => {}
                ended => break ended.unwrap_or_default(),
            }
        };
        let status = self.child.wait().map_err(|error| CaptureError::Ffmpeg(error.to_string()))?;
        if status.success() {
            return Ok(());
        }
        Err(CaptureError::Ffmpeg(if said.is_empty() { status.to_string() } else { said }))
    }

    fn end(&mut self) {
        drop(self.child.stdin.take());
        // Both fail only if it has ended.
        let _ = self.child.kill();
        let _ = self.child.wait();
    }
}

impl Drop for Ffmpeg {
    fn drop(&mut self) {
        self.end();
    }
}
