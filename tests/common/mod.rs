//! What the test binaries share: where things are, texts that must stay as they are, and one software GPU.
// Each binary uses a part of it.
#![allow(dead_code)]

pub mod folder;

use std::io::Write;
use std::path::{Path, PathBuf};
use std::sync::LazyLock;

use raytoy::frame::{Moment, View};
use raytoy::gpu::{AdapterChoice, Gpu, Picture, render};
use raytoy::library::{Family, Library, Type};
use raytoy::sources::Sources;
use raytoy::wgsl::Mode;
use raytoy::{Compiled, Outcome, compile};

/// Set to 1, it writes goldens instead of comparing with them.
pub const BLESS: &str = "RAYTOY_BLESS";

/// Set, it turns a missing adapter from a skip into a failure.
pub const REQUIRE_GPU: &str = "RAYTOY_REQUIRE_GPU";

/// The variable with a part of the name of another adapter to test than the software one.
const ADAPTER: &str = "RAYTOY_ADAPTER";

/// The project's folder.
pub fn root() -> PathBuf {
    PathBuf::from(env!("CARGO_MANIFEST_DIR"))
}

/// The text of the file called `name` from the project's folder.
pub fn read(name: &str) -> String {
    std::fs::read_to_string(root().join(name)).unwrap_or_else(|e| panic!("{name}: {e}"))
}

/// The files below `folder` with this extension, by their names from the project's folder, sorted.
pub fn files(folder: &str, extension: &str) -> Vec<String> {
    let path = root().join(folder);
    let entries = std::fs::read_dir(&path).unwrap_or_else(|e| panic!("{folder}: {e}"));
    let mut found = vec![];
    for entry in entries.flatten() {
        let name = format!("{folder}/{}", entry.file_name().to_string_lossy());
        if entry.path().is_dir() {
            found.extend(files(&name, extension));
        } else if Path::new(&name).extension().is_some_and(|e| e == extension) {
            found.push(name);
        }
    }
    found.sort();
    found
}

/// The scenes that must compile: the gallery's, and the cases but for those that show errors.
pub fn good_scenes() -> Vec<String> {
    let cases = scenes("tests/cases").into_iter().filter(|f| !f.starts_with("tests/cases/errors/"));
    scenes("scenes").into_iter().chain(cases).collect()
}

/// The scenes below `folder`: what ends in .ron, but for settings of tests.
pub fn scenes(folder: &str) -> Vec<String> {
    files(folder, "ron").into_iter().filter(|f| !f.ends_with(".test.ron")).collect()
}

/// What comes of the file called `name`.
pub fn outcome(name: &str, mode: Mode) -> Outcome {
    compile(&Sources::on_disk(&root()), Path::new(name), mode, None)
}

/// What comes of `text`, which has only what ships with raytoy around it.
pub fn outcome_of(name: &str, text: &str, mode: Mode) -> Outcome {
    compile(&Sources::in_memory().with(name, text), Path::new(name), mode, None)
}

/// The scene of an outcome without errors.
pub fn expect_compiled(outcome: Outcome) -> Compiled {
    let Outcome { compiled, report } = outcome;
    compiled.unwrap_or_else(|| panic!("the scene does not compile:\n{report}"))
}

/// Compares `actual` with the file called `golden`, or writes it there when blessing.
///
/// # Errors
/// How they differ, and how to bless.
pub fn check_text(golden: &str, actual: &str) -> Result<(), String> {
    if is_blessing() {
        return std::fs::write(root().join(golden), actual).map_err(|e| format!("{golden}: {e}"));
    }
    let Ok(expected) = std::fs::read_to_string(root().join(golden)) else {
        return Err(format!("{golden} is missing; {}", how_to_bless(golden)));
    };
    if expected == actual {
        return Ok(());
    }
    Err(format!("{golden} differs; {}\n{}", how_to_bless(golden), difference(&expected, actual)))
}

/// Whether goldens are to be written.
pub fn is_blessing() -> bool {
    std::env::var_os(BLESS).is_some_and(|value| value == "1")
}

/// What to type where the new output is the right one.
pub fn how_to_bless(golden: &str) -> String {
    format!("if the new {golden} is right, run the test again with {BLESS}=1 and read the diff")
}

/// Panics with all problems, if there are any.
pub fn expect_none(problems: impl IntoIterator<Item = String>) {
    let problems: Vec<String> = problems.into_iter().collect();
    assert!(problems.is_empty(), "{} problem(s)\n{}", problems.len(), problems.join("\n"));
}

/// The GPU that runs on the processor, unless [`ADAPTER`] names another, one for the whole binary; without one the
/// test is skipped.
pub fn gpu() -> Option<&'static Gpu> {
    static GPU: LazyLock<Option<Gpu>> = LazyLock::new(|| {
        let choice = std::env::var(ADAPTER).map_or(AdapterChoice::Software, AdapterChoice::Named);
        match Gpu::headless(&choice) {
            Ok(gpu) => Some(gpu),
            Err(error) if std::env::var_os(REQUIRE_GPU).is_some() => {
                panic!("{REQUIRE_GPU} is set, but {error}")
            }
            Err(error) => {
                // Past the capture of a test that passes: who runs the tests shall see it.
                let _ = writeln!(std::io::stderr(), "skipped: no adapter ({error})");
                None
            }
        }
    });
    GPU.as_ref()
}

/// The shapes that find their crossings by equations, as the reference does. For what is marched to
/// tests/gpu/solids.rs has laws, and for models tests/gpu/models/.
pub fn solved_shapes() -> Vec<String> {
    let sources = Sources::in_memory();
    let library = Library::new(&sources, "".as_ref());
    let is_solved = |name: &String| {
        let function = library.find(Family::Shape, name);
        function.is_ok_and(|f| !f.traits.is_distance && f.parameters.iter().all(|p| p.ty != Type::Model))
    };
    library.names(Family::Shape).into_iter().filter(is_solved).collect()
}

/// One sample of `compiled`, as its own camera sees it.
pub fn picture(gpu: &Gpu, compiled: &Compiled, size: [u32; 2], view: View) -> Picture {
    let moment = Moment { view, ..Moment::of(&compiled.scene) };
    render(gpu, compiled, &moment, size, 1, &mut |_| ())
        .unwrap_or_else(|e| panic!("{}: {e}", compiled.scene.name))
}

/// The lines that two texts do not share at their start and end, cut where they are many.
fn difference(expected: &str, actual: &str) -> String {
    const MOST: usize = 12;
    let (old, new): (Vec<&str>, Vec<&str>) = (expected.lines().collect(), actual.lines().collect());
    let same = old.iter().zip(&new).take_while(|(a, b)| a == b).count();
    let rest = old.len().min(new.len()) - same;
    let tail = old.iter().rev().zip(new.iter().rev()).take(rest).take_while(|(a, b)| a == b).count();
    let show = |sign: char, lines: &[&str]| {
        let mut shown: String = lines.iter().take(MOST).map(|line| format!("  {sign} {line}\n")).collect();
        if lines.len() > MOST {
            shown += &format!("  {sign} … {} more lines\n", lines.len() - MOST);
        }
        shown
    };
    let (old, new) = (&old[same..old.len() - tail], &new[same..new.len() - tail]);
    format!("  from line {}\n{}{}", same + 1, show('-', old), show('+', new))
}
