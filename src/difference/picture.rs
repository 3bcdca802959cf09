//! What differs between two pictures, as a person would say it, and in which objects.

use std::ops::ControlFlow;

use image::{ImageFormat, Rgb, RgbImage};

use crate::compile::Compiled;
use crate::frame::Moment;
use crate::gpu::{Gpu, GpuError, Identity, Picture, Renderer};
use crate::judge::{Area, Broken, Limits, PictureShift, Verdict, change, judge};

/// Two pictures of one size, and how far they are apart.
#[derive(Clone, Debug)]
pub struct PictureDifference {
    pub verdict: Verdict,
    pub change: Option<PictureShift>,
    /// The objects that showed where pixels are off, and the share of those pixels, the most first. Empty
    /// where there is no scene of the first picture.
    pub before: Vec<(String, f64)>,
    /// The same of the second picture.
    pub now: Vec<(String, f64)>,
    pub expected: RgbImage,
    pub actual: RgbImage,
}

/// How a scene is drawn to be compared.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Drawing {
    /// Pixels.
    pub size: [u32; 2],
    /// For each pixel.
    pub samples: u32,
    /// Seconds since the scene began.
    pub time: f32,
}

impl PictureDifference {
    /// What differs between the pictures of two scenes, each with its own camera. `progress` gets the
    /// share done.
    ///
    /// # Errors
    /// Where the driver refuses a scene or the size, or stops to answer.
    pub fn between(
        gpu: &Gpu,
        [old, new]: [&Compiled; 2],
        drawing: Drawing,
        progress: &mut dyn FnMut(f32),
    ) -> Result<Self, GpuError> {
        let (expected, before) = drawing.draw(gpu, old, &mut |share| progress(0.5 * share))?;
        let (actual, now) = drawing.draw(gpu, new, &mut |share| progress(0.5 + 0.5 * share))?;
        let verdict = judge(&expected, &actual, Limits::default()).expect("both are of one size");
        let mut difference = Self::new(verdict, expected, actual);
        difference.before = difference.objects(old, &before);
        difference.now = difference.objects(new, &now);
        Ok(difference)
    }

    /// Two pictures that `verdict` is about, whose objects are not known yet.
    pub fn new(verdict: Verdict, expected: RgbImage, actual: RgbImage) -> Self {
        let change = change(&expected, &actual, verdict.limits.tolerance);
        Self { verdict, change, before: vec![], now: vec![], expected, actual }
    }

    /// Whether each pixel is the same.
    pub fn is_none(&self) -> bool {
        self.verdict.outliers.worst.is_none()
    }

    /// The objects of a scene that `seen` shows where the pictures differ, and the share of those pixels: at
    /// least a tenth of them.
    pub fn objects(&self, compiled: &Compiled, seen: &Identity) -> Vec<(String, f64)> {
        let pixels = self.expected.enumerate_pixels().zip(self.actual.pixels());
        let is_off = |a: &Rgb<u8>, b: &Rgb<u8>| {
            a.0.iter().zip(b.0).any(|(x, y)| x.abs_diff(y) > self.verdict.limits.tolerance)
        };
        let differing: Vec<Option<u32>> = pixels
            .filter(|((_, _, before), now)| is_off(before, now))
            .map(|((x, y, _), _)| seen.object(x, y))
            .collect();
        let share = |i: usize| {
            let count = differing.iter().filter(|object| **object == Some(i as u32)).count();
            count as f64 / differing.len().max(1) as f64
        };
        let names =
            compiled.scene.primitives.iter().enumerate().map(|(i, object)| (object.name.clone(), share(i)));
        let mut shares: Vec<(String, f64)> = names.filter(|(_, share)| *share >= 0.1).collect();
        shares.sort_by(|a, b| b.1.total_cmp(&a.1));
        shares
    }

    /// What is beyond its limit, what a person would see, where, and the pixel that differs most.
    pub fn told(&self) -> Vec<String> {
        let broken = self.verdict.broken();
        let mut lines: Vec<String> =
            broken.into_iter().map(|broken| measure(&self.verdict, broken)).collect();
        lines.push(self.seen());
        if let Some(worst) = self.verdict.outliers.worst {
            let color = |[r, g, b]: [u8; 3]| format!("rgb({r}, {g}, {b})");
            let [x, y] = worst.at;
            let (was, is) = (color(worst.expected), color(worst.actual));
            lines.push(format!("largest difference in the pixel ({x}, {y}): it was {was} and is {is}"));
        }
        lines
    }

    /// The sentence of what a person would see: how, where, and in which objects.
    pub fn seen(&self) -> String {
        let how = match self.change {
            Some(PictureShift::Shift { word, by }) => format!("{word} by about {by:.1} of 100"),
            Some(PictureShift::Elsewhere { by }) => {
                format!("something moved or looks different: off by about {by:.1} of 100")
            }
            None => "no visible change".into(),
        };
        let place = self.verdict.outliers.bounds.map_or(String::new(), |area| format!(" in {}", told(area)));
        let [before, now] = [("was", &self.before), ("is now", &self.now)].map(|(verb, objects)| {
            let shares = objects.iter().map(|(name, share)| format!("\"{name}\" {:.0} %", share * 100.0));
            let shares = shares.collect::<Vec<_>>().join(", ");
            if shares.is_empty() { shares } else { format!("; there {verb} {shares}") }
        });
        format!("{how}{place}{before}{now}")
    }
}

impl Drawing {
    /// The picture, and what is under its pixels.
    fn draw(
        &self,
        gpu: &Gpu,
        compiled: &Compiled,
        progress: &mut dyn FnMut(f32),
    ) -> Result<(RgbImage, Identity), GpuError> {
        let mut renderer = Renderer::new(gpu, compiled, self.size)?;
        let moment = Moment { time: self.time, ..Moment::of(&compiled.scene) };
        let picture = renderer.draw(&moment, self.samples, &mut |share| {
            progress(share);
            ControlFlow::Continue(())
        })?;
        Ok((rgb(&picture.expect("nobody stops it")), renderer.identity(&moment)?))
    }
}

/// The picture as a screen shows it.
pub fn rgb(picture: &Picture) -> RgbImage {
    let [width, height] = picture.size;
    let bytes = picture.rgba.chunks_exact(4).flat_map(|pixel| [pixel[0], pixel[1], pixel[2]]).collect();
    RgbImage::from_raw(width, height, bytes).expect("three bytes a pixel")
}

/// A picture as a PNG file.
pub fn png(picture: &RgbImage) -> Vec<u8> {
    let mut bytes = std::io::Cursor::new(vec![]);
    picture.write_to(&mut bytes, ImageFormat::Png).expect("memory takes all pictures");
    bytes.into_inner()
}

fn measure(verdict: &Verdict, broken: Broken) -> String {
    let limits = verdict.limits;
    match broken {
        Broken::Outliers => format!(
            "{} pixels ({:.2} %) differ by more than {} of 255; at most {} % may",
            verdict.outliers.count,
            verdict.outliers.share() * 100.0,
            limits.tolerance,
            trimmed(limits.outliers * 100.0),
        ),
        Broken::Structure => {
            format!(
                "the structural similarity is {:.4}; it must be at least {}",
                verdict.structure.mean, limits.structure
            )
        }
        Broken::Window => {
            let [x, y] = verdict.structure.least_at;
            let least = verdict.structure.least;
            format!(
                "the structural similarity at ({x}, {y}) is {least:.3}; it must be at least {}",
                limits.window
            )
        }
        Broken::Flip => format!("FLIP is {:.5}; it must be at most {}", verdict.flip, limits.flip),
    }
}

/// Without the digits that a float leaves behind: 0.1, not 0.10000000000000001.
fn trimmed(x: f64) -> f64 {
    (x * 1e6).round() / 1e6
}

fn told(area: Area) -> String {
    let side = |[low, high]: [u32; 2]| format!("{low}..{high}");
    format!("the box x {}, y {}", side(area.x), side(area.y))
}
