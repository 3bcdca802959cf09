//! One texture's or shape's file before the laws.

use std::path::Path;
use std::time::Instant;

use super::scene::Bench;
use super::settings::{Settings, settings_for};
use super::{Case, Failure, Outcome};
use crate::diagnostic::Report;
use crate::gpu::Gpu;
use crate::laws::{self, Problem, World};
use crate::library::{Family, Library, name_of};

/// Runs the test of one file of `family`.
pub fn check(bench: &Bench, gpu: &Gpu, case: &Case, family: Family) -> Outcome {
    let start = Instant::now();
    let folder = case.path.parent().and_then(Path::parent).unwrap_or(Path::new(""));
    let world = World { disk: Some(bench.disk.clone()), folder: folder.into(), files: vec![] };
    let mut outcome = Outcome::new(case);
    match settings_for(&world.sources(), &case.path) {
        Err(report) => outcome.failures.push(Failure::Mistakes(report.to_string())),
        Ok(Settings { skip: Some(why), .. }) => outcome.skipped = Some(why),
        Ok(_) => outcome.failures = failures(gpu, &world, case, family),
    }
    Outcome { time: start.elapsed(), ..outcome }
}

fn failures(gpu: &Gpu, world: &World, case: &Case, family: Family) -> Vec<Failure> {
    let sources = world.sources();
    let library = Library::new(&sources, &world.folder);
    let stem = case.path.file_stem().unwrap_or_default().to_string_lossy();
    let function = match library.find(family, &name_of(&stem)) {
        Ok(function) => function,
        Err(problems) => {
            let report = Report { diagnostics: problems.unwrap_or_default(), texts: sources.texts() };
            return vec![Failure::Mistakes(report.to_string())];
        }
    };
    match laws::check(gpu, world, &function) {
        Ok(broken) => broken.into_iter().map(Failure::Law).collect(),
        Err(Problem::Mistakes(report)) => vec![Failure::Mistakes(report.to_string())],
        Err(Problem::Gpu(error)) => vec![Failure::Obstacle(error.to_string())],
    }
}
