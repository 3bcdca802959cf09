//! Frames of a scene that moves, as pictures with numbers in their names.

use std::ops::{ControlFlow, Range};
use std::path::{Path, PathBuf};

use super::{CaptureError, Format, Shot, Small};
use crate::files::write_file;
use crate::frame::Moment;
use crate::gpu::PictureTimes;

/// Moments at the same distance from each other.
#[derive(Clone, Debug, PartialEq)]
pub struct Frames {
    pub numbers: Range<u32>,
    /// Frames a second, more than 0.
    pub rate: f64,
}

/// Names of pictures that differ in a number: `frames/####.png`.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Numbered {
    pub format: Format,
    folder: PathBuf,
    before: String,
    digits: usize,
    after: String,
}

/// Writes each of `frames` to a picture of its own; `shot` says all but the time. Returns what each took,
/// and the first one small.
///
/// Pictures that are whole stay, even if it is stopped or fails.
///
/// # Errors
/// Where the GPU refuses the scene or the size, a file cannot be written, or `progress` stops it.
pub fn stills(
    shot: &Shot<'_>,
    frames: &Frames,
    names: &Numbered,
    progress: &mut dyn FnMut(f32) -> ControlFlow<()>,
) -> Result<(Vec<PictureTimes>, Small), CaptureError> {
    let mut renderer = shot.renderer()?;
    let times = frames.each(shot, progress, |number, shot, progress| {
        let mut bytes = vec![];
        let times = shot.write(&mut bytes, &mut renderer, names.format, progress)?;
        let path = names.path(number);
        std::fs::create_dir_all(&names.folder)
            .and_then(|()| write_file(&path, &bytes))
            .map_err(|error| CaptureError::File(path, error))?;
        Ok(times)
    })?;
    Ok((times, frames.shot(shot, frames.numbers.start).small(&renderer)?))
}

impl Frames {
    /// Seconds since the scene began.
    pub fn time(&self, number: u32) -> f32 {
        (f64::from(number) / self.rate) as f32
    }

    /// What `shot` is at the time of a frame.
    pub fn shot<'a>(&self, shot: &Shot<'a>, number: u32) -> Shot<'a> {
        Shot { moment: Moment { time: self.time(number), ..shot.moment }, ..*shot }
    }

    /// Does `work` for each frame, with its number, its shot, and the progress within it.
    pub(super) fn each<'a>(
        &self,
        shot: &Shot<'a>,
        progress: &mut dyn FnMut(f32) -> ControlFlow<()>,
        mut work: impl FnMut(
            u32,
            &Shot<'a>,
            &mut dyn FnMut(f32) -> ControlFlow<()>,
        ) -> Result<PictureTimes, CaptureError>,
    ) -> Result<Vec<PictureTimes>, CaptureError> {
        let count = self.numbers.len() as f32;
        let frame = |(done, number): (usize, u32)| {
            work(number, &self.shot(shot, number), &mut |share| progress((done as f32 + share) / count))
        };
        self.numbers.clone().enumerate().map(frame).collect()
    }
}

impl Numbered {
    /// None where the name has no place for a number, a run of `#`, or is not of a picture. Of several runs
    /// the last counts.
    pub fn of(path: &Path) -> Option<Self> {
        let format = Format::of(path)?;
        let name = path.file_name()?.to_str()?;
        let end = name.rfind('#')? + 1;
        let start = name[..end].trim_end_matches('#').len();
        Some(Self {
            format,
            folder: path.parent().unwrap_or(Path::new("")).to_owned(),
            before: name[..start].to_owned(),
            digits: end - start,
            after: name[end..].to_owned(),
        })
    }

    /// The file of frame `number`: zeros in front fill the place, and a long number goes beyond it.
    pub fn path(&self, number: u32) -> PathBuf {
        let Self { folder, before, digits, after, .. } = self;
        folder.join(format!("{before}{number:0digits$}{after}"))
    }
}
