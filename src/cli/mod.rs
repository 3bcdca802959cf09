//! The command line: arguments in, text and files out, and an exit code. The only printer.
//!
//! Results go to stdout, talk to stderr. The code is 0, or 1 where a scene is wrong, or 2 where the call is.

mod args;
mod check;
mod diff;
mod frames;
mod gallery;
mod generate;
mod list;
mod progress;
mod render;
mod scene;
mod shot;
mod stats;
mod test;
mod view;
mod words;

use std::io::{IsTerminal, Read, Write};
use std::path::{Path, PathBuf};
use std::process::ExitCode;

use clap::{CommandFactory, Parser};

use self::args::{Arguments, Command, RootOption};
use crate::compile::{Compiled, compile};
use crate::diagnostic::{Report, Severity};
use crate::files::write_file;
use crate::gpu::GpuError;
use crate::library::Family;
use crate::sources::{Disk, Sources};
use crate::wgsl::Mode;

/// Why a command did not do what it was asked for.
pub enum Failure {
    /// A scene is wrong, a test failed, or the code is to say that scenes differ: all has been printed.
    Scene,
    /// A scene turned out to be wrong while it was drawn: the report to print.
    Endless(Report),
    /// The call is wrong, or the machine: the message to print.
    Call(String),
}

type Result<T = ()> = std::result::Result<T, Failure>;

impl<E: std::error::Error + 'static> From<E> for Failure {
    fn from(error: E) -> Self {
        let causes = std::iter::successors(Some(&error as &dyn std::error::Error), |error| error.source());
        let mut reports = causes.filter_map(|cause| match cause.downcast_ref() {
            Some(GpuError::Endless(report)) => Some(report.clone()),
            _ => None,
        });
        reports.next().map_or_else(|| Failure::Call(error.to_string()), Failure::Endless)
    }
}

/// Runs the program with the arguments of the process.
pub fn run() -> ExitCode {
    // SAFETY: the program has one thread yet.
    unsafe { crate::gpu::ask_no_absent_display() };
    let done = match Arguments::parse().command {
        Command::View(options) => view::run(&options),
        Command::Render(options) => render::run(&options),
        Command::Scene { picture } => scene::run(&picture),
        Command::Check(options) => check::run(&options),
        Command::Test(options) => test::run(&options),
        Command::Diff(options) => diff::run(&options),
        Command::Generate(options) => generate::run(&options),
        Command::Textures { name } => list::run(Family::Texture, name.as_deref()),
        Command::Shapes { name } => list::run(Family::Shape, name.as_deref()),
        Command::Gallery { output } => gallery::run(&output),
        Command::Completions { shell } => {
            clap_complete::generate(shell, &mut Arguments::command(), "raytoy", &mut std::io::stdout());
            Ok(())
        }
    };
    match done {
        Ok(()) => ExitCode::SUCCESS,
        Err(Failure::Scene) => ExitCode::from(1),
        Err(Failure::Endless(report)) => {
            print_report(&report);
            ExitCode::from(1)
        }
        Err(Failure::Call(why)) => {
            eprintln!("raytoy: {why}");
            ExitCode::from(2)
        }
    }
}

/// The disk, with what `--root` says.
///
/// # Errors
/// Where that is no folder, or one of `scenes` lies elsewhere.
fn disk<'a>(root: &RootOption, scenes: impl IntoIterator<Item = &'a PathBuf>) -> Result<Disk> {
    let disk = Disk::new(root.root.clone());
    let Some(root) = &disk.named_root else { return Ok(disk) };
    if !root.is_dir() {
        return Err(Failure::Call(format!("the root folder `{}` does not exist", root.display())));
    }
    let sources = disk.sources();
    match scenes.into_iter().find(|scene| !sources.root_holds(scene)) {
        Some(scene) => {
            let why = format!("`{}` is outside of the root folder `{}`", scene.display(), root.display());
            Err(Failure::Call(why))
        }
        None => Ok(disk),
    }
}

/// The files of `disk`, with standard input as the file `-` where `scene` is that.
fn sources_for(disk: &Disk, scene: &Path) -> Result<Sources> {
    let sources = disk.sources();
    if scene != Path::new("-") {
        return Ok(sources);
    }
    let mut text = String::new();
    std::io::stdin().read_to_string(&mut text)?;
    Ok(sources.with("-", &text))
}

/// Compiles `scene` and prints what there is to say about it.
fn compiled(disk: &Disk, scene: &Path, mode: Mode) -> Result<Compiled> {
    if scene != Path::new("-") && !scene.exists() {
        return Err(Failure::Call(format!("there is no file `{}`", scene.display())));
    }
    let outcome = compile(&sources_for(disk, scene)?, scene, mode, None);
    print_report(&outcome.report);
    outcome.compiled.ok_or(Failure::Scene)
}

fn print_report(report: &Report) {
    if report.diagnostics.is_empty() {
        return;
    }
    let color = std::io::stderr().is_terminal() && std::env::var_os("NO_COLOR").is_none();
    eprint!("{}", report.render(color));
    let count = |severity, noun: &str| match report.count(severity) {
        0 => None,
        1 => Some(format!("1 {noun}")),
        n => Some(format!("{n} {noun}s")),
    };
    let counts: Vec<String> = [count(Severity::Error, "error"), count(Severity::Warning, "warning")]
        .into_iter()
        .flatten()
        .collect();
    eprintln!("{}", counts.join(", "));
}

/// Writes to a file, or to standard output where `path` is `-`.
fn write_output(path: &Path, bytes: &[u8]) -> Result {
    let written = if path == Path::new("-") {
        let mut out = std::io::stdout().lock();
        out.write_all(bytes).and_then(|()| out.flush())
    } else {
        write_file(path, bytes)
    };
    match written {
        // Whoever reads has seen enough: `raytoy textures | head`.
        Err(error) if error.kind() == std::io::ErrorKind::BrokenPipe => Ok(()),
        Err(error) => Err(Failure::Call(format!("cannot write `{}`: {error}", path.display()))),
        Ok(()) => Ok(()),
    }
}

/// Writes text to standard output.
fn print_result(text: &str) -> Result {
    write_output(&PathBuf::from("-"), text.as_bytes())
}
