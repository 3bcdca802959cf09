//! What came of a test, and what there is to say of it.

use std::path::{Path, PathBuf};
use std::time::Duration;

use super::Case;
use crate::difference::{PictureDifference, TextDifference};
use crate::judge::Verdict;
use crate::laws;

/// One test that ran.
#[derive(Clone, Debug)]
pub struct Outcome {
    pub case: Case,
    pub failures: Vec<Failure>,
    /// Reports of what makes a picture doubtful, even one that is as its golden.
    pub warnings: Vec<String>,
    /// Why it was not run.
    pub skipped: Option<String>,
    /// What was measured where a picture was compared.
    pub verdict: Option<Verdict>,
    /// Goldens that were blessed, and whether they are new.
    pub written: Vec<(PathBuf, bool)>,
    /// Goldens that were removed.
    pub removed: Vec<PathBuf>,
    pub time: Duration,
}

/// Why a test failed.
#[derive(Clone, Debug)]
pub enum Failure {
    /// The scene, its settings or a file that it uses have mistakes: the report.
    Mistakes(String),
    /// A golden that is not there.
    Missing(PathBuf),
    /// Goldens of a scene that is not there.
    Gone(Vec<PathBuf>),
    /// A golden that cannot be read, or a driver that refuses: why.
    Obstacle(String),
    Text {
        golden: PathBuf,
        difference: TextDifference,
    },
    /// Widths and heights of the golden and the new picture.
    Size {
        golden: PathBuf,
        sizes: [(u32, u32); 2],
    },
    /// A picture that is too far from its golden.
    Picture {
        golden: PathBuf,
        difference: Box<PictureDifference>,
    },
    Law(laws::Broken),
}

impl Outcome {
    pub fn passes(&self) -> bool {
        self.failures.is_empty() && self.skipped.is_none()
    }

    /// When blessing helps, and what a person would type; None where it does not help.
    pub fn how_to_bless(&self, call: &str) -> Option<[String; 2]> {
        let is_golden = |failure: &Failure| {
            matches!(
                failure,
                Failure::Missing(_) | Failure::Text { .. } | Failure::Size { .. } | Failure::Picture { .. }
            )
        };
        let name = quoted(&self.case.name);
        if self.failures.iter().any(|failure| matches!(failure, Failure::Gone(_))) {
            let there = |folder: &&Path| folder.is_dir() && *folder != Path::new("/");
            let folder = self.case.path.ancestors().skip(1).find(there).unwrap_or(Path::new("."));
            let folder = quoted(&folder.to_string_lossy());
            let when = "to remove them".to_owned();
            return Some([when, format!("raytoy test {folder}{call} --bless {name}")]);
        }
        let command = format!("raytoy test {name}{call} --bless");
        self.failures.iter().any(is_golden).then(|| ["if the new output is right".to_owned(), command])
    }
}

/// `name` as a shell takes it.
fn quoted(name: &str) -> String {
    if name.contains(char::is_whitespace) { format!("'{name}'") } else { name.to_owned() }
}

impl Failure {
    /// One word for programs.
    pub fn kind(&self) -> &'static str {
        match self {
            Failure::Mistakes(_) => "mistakes",
            Failure::Missing(_) => "missing",
            Failure::Gone(_) => "gone",
            Failure::Obstacle(_) => "obstacle",
            Failure::Text { .. } => "text",
            Failure::Size { .. } => "size",
            Failure::Picture { .. } => "picture",
            Failure::Law(_) => "law",
        }
    }

    /// What happened, in a line or several.
    pub fn told(&self) -> Vec<String> {
        match self {
            Failure::Mistakes(report) => report.trim_end().lines().map(str::to_owned).collect(),
            Failure::Missing(golden) => vec![format!("the golden `{}` is missing", golden.display())],
            Failure::Gone(goldens) => {
                let goldens: Vec<String> =
                    goldens.iter().map(|path| format!("`{}`", path.display())).collect();
                vec![format!("this scene does not exist, but it has goldens: {}", goldens.join(", "))]
            }
            Failure::Obstacle(why) => why.lines().map(str::to_owned).collect(),
            Failure::Text { golden, difference } => {
                let [gone, new] = difference.counts();
                let head = format!("{} differs: {gone} lines removed, {new} added", golden.display());
                [vec![head], difference.told()].concat()
            }
            Failure::Size { golden, sizes: [(w, h), (width, height)] } => {
                let now = format!("the picture is {width}x{height}");
                vec![format!("{} is {w}x{h}, but {now}", golden.display())]
            }
            Failure::Picture { golden, difference } => {
                let head = format!("{} looks different", golden.display());
                [vec![head], difference.told()].concat()
            }
            Failure::Law(broken) => vec![broken.to_string()],
        }
    }
}
