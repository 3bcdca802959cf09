//! What the programs of tests share: where things are, and texts that must stay as they are.

pub mod folder;
pub mod program;

use std::path::{Path, PathBuf};

use raytoy::sources::Sources;
use raytoy::wgsl::Mode;
use raytoy::{Compiled, Outcome, compile};

/// Set to 1, it writes goldens instead of comparing with them.
pub const BLESS: &str = "RAYTOY_BLESS";

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
