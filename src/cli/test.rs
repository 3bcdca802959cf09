//! `raytoy test`: an author's scenes beside their goldens, textures and shapes before their laws.

use super::args::{TestFormat, TestOptions};
use super::progress::with_progress;
use super::{Failure, Result, print_result, write_output};
use crate::gpu::{AdapterChoice, Gpu, GpuError};
use crate::sources::Sources;
use crate::suite::{self, Bench, Case, Goldens, Gone, Run};

pub fn run(options: &TestOptions) -> Result {
    let disk = super::disk(&options.root, &options.paths)?;
    let named = match &options.adapter {
        Some(AdapterChoice::Named(name)) => Some(name.clone()),
        _ => None,
    };
    let goldens = Goldens { folder: options.goldens.clone(), adapter: named };
    let (cases, gone) = chosen(options, &disk.sources(), &goldens)?;
    if options.list {
        return print_result(&cases.iter().map(|case| format!("{}\n", case.name)).collect::<String>());
    }
    let bench = Bench { disk, goldens, bless: options.bless.is_some() };
    let devices = devices(options, cases.len())?;
    let count = cases.len() as f32;
    let mut outcomes = with_progress("testing", |progress| {
        suite::run(&bench, &devices, &cases, &mut |done| {
            let _ = progress(done as f32 / count);
        })
    });
    // A file is removed only where its scene is named: it might be an author's own after all.
    let removes = options.bless.as_ref().is_some_and(|name| !name.is_empty());
    outcomes.extend(gone.into_iter().map(|gone| gone.outcome(removes)));
    outcomes.sort_by(|a, b| a.case.name.cmp(&b.case.name));
    let run = Run { outcomes, adapter: devices[0].describe(), call: call(options) };
    if let Some(path) = &options.report {
        write_output(path, suite::html(&run).as_bytes())?;
        eprintln!("The report is {}.", path.display());
    }
    print_result(&match options.format {
        TestFormat::Human => suite::human(&run),
        TestFormat::Json => suite::json(&run),
        TestFormat::Junit => suite::junit(&run),
    })?;
    if run.failed() > 0 { Err(Failure::Scene) } else { Ok(()) }
}

/// The cases under the paths whose names have what `--filter` and `--bless` ask for, and those of which there
/// are only goldens.
fn chosen(options: &TestOptions, sources: &Sources, goldens: &Goldens) -> Result<(Vec<Case>, Vec<Gone>)> {
    let mut cases = suite::find(sources, &options.paths).map_err(Failure::Call)?;
    let mut gone = suite::find_gone(sources, goldens, &options.paths).map_err(Failure::Call)?;
    if cases.is_empty() && gone.is_empty() {
        return Err(Failure::Call(
            "there is nothing to test: no scenes, textures or shapes were found".into(),
        ));
    }
    for filter in [&options.filter, &options.bless].into_iter().flatten() {
        cases.retain(|case| case.name.contains(filter.as_str()));
        gone.retain(|gone| gone.case.name.contains(filter.as_str()));
        if cases.is_empty() && gone.is_empty() {
            let advice = "`raytoy test --list` prints the names";
            return Err(Failure::Call(format!("no test has `{filter}` in its name; {advice}")));
        }
    }
    Ok((cases, gone))
}

/// More devices than this only keep each other from the processors.
const MAX_JOBS: usize = 8;

/// A device for each thread. If no adapter is named, the software driver draws, if there is one: its pictures
/// are the same on every machine.
fn devices(options: &TestOptions, cases: usize) -> Result<Vec<Gpu>> {
    let first = match &options.adapter {
        Some(choice) => Gpu::headless(choice)?,
        None => match Gpu::headless(&AdapterChoice::Software) {
            Err(GpuError::NoAdapter(_)) => {
                let gpu = Gpu::headless(&AdapterChoice::Fastest)?;
                eprintln!(
                    "There is no software driver, so {} draws. \
                     Other machines may draw slightly different pictures.",
                    gpu.describe()
                );
                gpu
            }
            software => software?,
        },
    };
    let threads = std::thread::available_parallelism().map_or(1, usize::from);
    let jobs = options.jobs.map_or(threads.min(MAX_JOBS), |jobs| jobs as usize).min(cases);
    let choice = options.adapter.clone().unwrap_or(match first.is_software() {
        true => AdapterChoice::Software,
        false => AdapterChoice::Fastest,
    });
    let mut devices = vec![first];
    while devices.len() < jobs {
        devices.push(Gpu::headless(&choice)?);
    }
    Ok(devices)
}

/// What a call needs besides a test's name to do what this one does.
fn call(options: &TestOptions) -> String {
    let goldens = options.goldens.iter().map(|folder| format!(" --goldens {}", folder.display()));
    let adapter = options.adapter.iter().map(|choice| match choice {
        AdapterChoice::Fastest => " --adapter fastest".to_owned(),
        AdapterChoice::Software => " --adapter software".to_owned(),
        AdapterChoice::Named(name) => format!(" --adapter '{name}'"),
    });
    goldens.chain(adapter).collect()
}
