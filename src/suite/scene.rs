//! One scene beside its goldens: text, naga's verdict in both modes, picture.

use std::ops::ControlFlow;
use std::path::Path;
use std::time::Instant;

use super::goldens::{read_picture, read_text, write};
use super::settings::{Settings, settings_for};
use super::{Case, Failure, Goldens, Outcome};
use crate::compile::{Compiled, compile};
use crate::diagnostic::Report;
use crate::difference::{PictureDifference, TextDifference, png, rgb, with_origin_of};
use crate::frame::Moment;
use crate::gpu::{Gpu, GpuError, Renderer, SMALL};
use crate::judge::judge;
use crate::sketch::canary;
use crate::sources::{Disk, Sources};
use crate::wgsl::Mode;

/// What all tests of a run share.
#[derive(Clone, Debug)]
pub struct Bench {
    pub disk: Disk,
    pub goldens: Goldens,
    /// Whether goldens are written where they are missing or differ.
    pub bless: bool,
}

/// Runs the test of one scene.
pub fn check(bench: &Bench, gpu: &Gpu, case: &Case) -> Outcome {
    let start = Instant::now();
    let mut test = Test { bench, gpu, case, outcome: Outcome::new(case) };
    let sources = bench.disk.sources();
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
            let why = "a golden in this folder would be read as a texture or shape";
            let advice =
                "move the scene to another folder, or choose a folder for the goldens: `--goldens FOLDER`";
            return self.fail(Failure::Obstacle(format!("{why}\n{advice}")));
        }
        if let Err(problem) = compiled.in_mode(Mode::Live) {
            // The text was right with its numbers written out, so this is a mistake of raytoy's.
            let why =
                format!("naga refuses the scene with its numbers in a uniform buffer: {}", problem.message);
            self.fail(Failure::Mistakes(why));
        }
        if settings.text {
            let path = self.bench.goldens.path(self.case, "wgsl");
            self.compare_text(&path, compiled.source.generated());
        }
        if settings.picture
            && let Err(error) = self.compare_picture(&compiled, settings)
        {
            self.fail(match error {
                GpuError::Endless(report) => Failure::Mistakes(report.to_string()),
                error => Failure::Obstacle(error.to_string()),
            });
        }
    }

    fn fail(&mut self, failure: Failure) {
        self.outcome.failures.push(failure);
    }

    fn compare_text(&mut self, path: &Path, actual: &str) {
        let golden = match read_text(path) {
            Ok(golden) => golden,
            Err(why) => {
                let failure = Failure::Obstacle(unreadable(path, &why));
                return self.fail_or_bless(failure, path, false, || actual.as_bytes().to_vec());
            }
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
        if self.gpu.is_software() {
            let small = renderer.small(&moment)?;
            let doubt = canary::doubt(compiled, &moment, SMALL, &small, canary::PATIENCE);
            let warning = doubt.map(|doubt| doubt.warning(&compiled.scene.name, &self.gpu.describe()));
            self.outcome.warnings.extend(warning.map(|warning| Report::from(warning).to_string()));
        }
        let [path, target] = self.bench.goldens.pictures(self.case);
        let golden = match read_picture(&path) {
            Ok(golden) => golden,
            Err(why) => {
                let failure = Failure::Obstacle(unreadable(&path, &why));
                self.fail_or_bless(failure, &target, !target.exists(), || png(&actual));
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
                let mut difference = PictureDifference::new(verdict, expected, actual.clone());
                difference.now = difference.objects(compiled, &renderer.identity(&moment)?);
                Failure::Picture { golden: path, difference: Box::new(difference) }
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

impl Outcome {
    pub(super) fn new(case: &Case) -> Self {
        Self {
            case: case.clone(),
            failures: vec![],
            warnings: vec![],
            skipped: None,
            verdict: None,
            written: vec![],
            removed: vec![],
            time: Default::default(),
        }
    }
}
