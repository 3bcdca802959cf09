//! One scene beside its goldens: text, naga's verdict in both modes, picture.

use std::ops::ControlFlow;
use std::path::{Path, PathBuf};
use std::time::Instant;

use image::{Rgb, RgbImage};

use super::goldens::{png, read_picture, read_text, write};
use super::settings::{Settings, settings_for};
use super::{Case, Failure, Goldens, Outcome, PictureFailure, TextDifference};
use crate::gpu::{Gpu, GpuError, Identity, Moment, Picture, Renderer};
use crate::judge::{change, judge};
use crate::sources::Sources;
use crate::wgsl::Mode;
use crate::{Compiled, compile};

/// What all tests of a run share.
#[derive(Clone, Debug)]
pub struct Bench {
    /// The folder that raytoy runs in.
    pub root: PathBuf,
    pub goldens: Goldens,
    /// Whether goldens are written where they are missing or differ.
    pub bless: bool,
}

/// Runs the test of one scene.
pub fn check(bench: &Bench, gpu: &Gpu, case: &Case) -> Outcome {
    let start = Instant::now();
    let mut test = Test { bench, gpu, case, outcome: Outcome::new(case) };
    let sources = Sources::on_disk(&bench.root);
    match settings_for(&sources, &case.path) {
        Err(report) => test.fail(Failure::Mistakes(report.to_string())),
        Ok(Settings { skip: Some(why), .. }) => test.outcome.skipped = Some(why),
        Ok(settings) => test.run(&sources, &settings),
    }
    Outcome { time: start.elapsed(), ..test.outcome }
}

struct Test<'a> {
    bench: &'a Bench,
    gpu: &'a Gpu,
    case: &'a Case,
    outcome: Outcome,
}

impl Test<'_> {
    fn run(&mut self, sources: &Sources, settings: &Settings) {
        let outcome = compile(sources, &self.case.path, Mode::Baked, None);
        if settings.mistakes {
            let path = self.bench.goldens.path(self.case, "txt");
            return self.compare_text(&path, &outcome.report.to_string());
        }
        let Some(compiled) = outcome.compiled else {
            return self.fail(Failure::Mistakes(outcome.report.to_string()));
        };
        let folder = self.case.path.parent().and_then(Path::file_name).unwrap_or_default();
        if self.bench.goldens.folder.is_none() && (folder == "textures" || folder == "shapes") {
            let why = "a golden in this folder would be taken for one of its files";
            let advice = "move the scene out of it, or keep its goldens elsewhere: `--goldens FOLDER`";
            return self.fail(Failure::Obstacle(format!("{why}\n{advice}")));
        }
        if let Err(problem) = compiled.in_mode(Mode::Live) {
            // The text was right with its numbers written out, so this is a mistake of raytoy's.
            let why = format!("with its numbers as data, naga refuses the scene: {}", problem.message);
            self.fail(Failure::Mistakes(why));
        }
        if settings.text {
            let path = self.bench.goldens.path(self.case, "wgsl");
            self.compare_text(&path, compiled.source.generated());
        }
        if settings.picture
            && let Err(error) = self.compare_picture(&compiled, settings)
        {
            self.fail(Failure::Obstacle(error.to_string()));
        }
    }

    fn fail(&mut self, failure: Failure) {
        self.outcome.failures.push(failure);
    }

    fn compare_text(&mut self, path: &Path, actual: &str) {
        let golden = match read_text(path) {
            Ok(golden) => golden,
            Err(why) => return self.fail(Failure::Obstacle(unreadable(path, &why))),
        };
        let failure = match &golden {
            None => Failure::Missing(path.into()),
            Some(golden) => match TextDifference::between(&with_origin_of(actual, golden), actual) {
                None => return,
                Some(difference) => Failure::Text { golden: path.into(), difference },
            },
        };
        self.fail_or_bless(failure, path, golden.is_none(), || actual.as_bytes().to_vec());
    }

    fn compare_picture(&mut self, compiled: &Compiled, settings: &Settings) -> Result<(), GpuError> {
        let mut renderer = Renderer::new(self.gpu, compiled, settings.size)?;
        let moment = Moment { time: settings.time, ..Moment::of(&compiled.scene) };
        let actual = renderer.draw(&moment, settings.samples, &mut |_| ControlFlow::Continue(()))?;
        let actual = rgb(&actual.expect("nobody stops it"));
        let [path, target] = self.bench.goldens.pictures(self.case);
        let golden = match read_picture(&path) {
            Ok(golden) => golden,
            Err(why) => {
                self.fail(Failure::Obstacle(unreadable(&path, &why)));
                return Ok(());
            }
        };
        let Some(expected) = golden else {
            self.fail_or_bless(Failure::Missing(path), &target, true, || png(&actual));
            return Ok(());
        };
        let failure = match judge(&expected, &actual, settings.limits) {
            Err(sizes) => Failure::Size { golden: path, sizes },
            Ok(verdict) => {
                self.outcome.verdict = Some(verdict.clone());
                if verdict.passes() {
                    return Ok(());
                }
                let tolerance = settings.limits.tolerance;
                let change = change(&expected, &actual, tolerance);
                let seen = renderer.identity(&moment)?;
                let objects = objects(compiled, &seen, [&expected, &actual], tolerance);
                let actual = actual.clone();
                Failure::Picture(Box::new(PictureFailure {
                    golden: path,
                    verdict,
                    change,
                    objects,
                    expected,
                    actual,
                }))
            }
        };
        self.fail_or_bless(failure, &target, !target.exists(), || png(&actual));
        Ok(())
    }

    /// Writes the golden that `failure` is about, or notes the failure.
    fn fail_or_bless(
        &mut self,
        failure: Failure,
        path: &Path,
        is_new: bool,
        bytes: impl FnOnce() -> Vec<u8>,
    ) {
        if !self.bench.bless {
            return self.fail(failure);
        }
        match write(path, &bytes()) {
            Ok(()) => self.outcome.written.push((path.into(), is_new)),
            Err(why) => self.fail(Failure::Obstacle(why)),
        }
    }
}

fn unreadable(path: &Path, why: &str) -> String {
    format!("cannot read `{}`: {why}", path.display())
}

/// `golden` with the first line of `actual`: that names the scene's file from the folder that raytoy runs in,
/// which may be another one than when it was blessed.
fn with_origin_of(actual: &str, golden: &str) -> String {
    let is_origin = |text: &str| text.starts_with("// Generated from ");
    match (actual.split_once('\n'), golden.split_once('\n')) {
        (Some((origin, _)), Some((other, rest))) if is_origin(origin) && is_origin(other) => {
            format!("{origin}\n{rest}")
        }
        _ => golden.to_owned(),
    }
}

/// The picture as a screen shows it.
pub fn rgb(picture: &Picture) -> RgbImage {
    let [width, height] = picture.size;
    let bytes = picture.rgba.chunks_exact(4).flat_map(|pixel| [pixel[0], pixel[1], pixel[2]]).collect();
    RgbImage::from_raw(width, height, bytes).expect("three bytes a pixel")
}

/// The objects that `seen`, a picture of objects, shows where two pictures differ, and the share of those
/// pixels: at least a tenth of them.
fn objects(
    compiled: &Compiled,
    seen: &Identity,
    [expected, actual]: [&RgbImage; 2],
    tolerance: u8,
) -> Vec<(String, f64)> {
    let pixels = expected.enumerate_pixels().zip(actual.pixels());
    let is_off = |a: &Rgb<u8>, b: &Rgb<u8>| a.0.iter().zip(b.0).any(|(x, y)| x.abs_diff(y) > tolerance);
    let differing: Vec<Option<u32>> = pixels
        .filter(|((_, _, before), now)| is_off(before, now))
        .map(|((x, y, _), _)| seen.object(x, y))
        .collect();
    let share = |i: usize| {
        let count = differing.iter().filter(|object| **object == Some(i as u32)).count();
        count as f64 / differing.len().max(1) as f64
    };
    let names = compiled.scene.objects.iter().enumerate().map(|(i, object)| (object.name.clone(), share(i)));
    let mut shares: Vec<(String, f64)> = names.filter(|(_, share)| *share >= 0.1).collect();
    shares.sort_by(|a, b| b.1.total_cmp(&a.1));
    shares
}

impl Outcome {
    pub(super) fn new(case: &Case) -> Self {
        Self {
            case: case.clone(),
            failures: vec![],
            skipped: None,
            verdict: None,
            written: vec![],
            time: Default::default(),
        }
    }
}
