//! What came of a test, and what there is to say of it.

use std::path::PathBuf;
use std::time::Duration;

use image::RgbImage;

use super::{Case, TextDifference};
use crate::judge::{Area, Broken, Change, Verdict};
use crate::laws;

/// One test that ran.
#[derive(Clone, Debug)]
pub struct Outcome {
    pub case: Case,
    pub failures: Vec<Failure>,
    /// Why it was not run.
    pub skipped: Option<String>,
    /// What was measured where a picture was compared.
    pub verdict: Option<Verdict>,
    /// Goldens that were blessed, and whether they are new.
    pub written: Vec<(PathBuf, bool)>,
    pub time: Duration,
}

/// Why a test failed.
#[derive(Clone, Debug)]
pub enum Failure {
    /// The scene, its settings or a file that it uses have mistakes: the report.
    Mistakes(String),
    /// A golden that is not there.
    Missing(PathBuf),
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
    Picture(Box<PictureFailure>),
    Law(laws::Broken),
}

/// A picture that is too far from its golden.
#[derive(Clone, Debug)]
pub struct PictureFailure {
    pub golden: PathBuf,
    pub verdict: Verdict,
    pub change: Option<Change>,
    /// The objects that now show where pixels are off, and the share of those pixels; the most first.
    pub objects: Vec<(String, f64)>,
    pub expected: RgbImage,
    pub actual: RgbImage,
}

impl Outcome {
    pub fn passes(&self) -> bool {
        self.failures.is_empty() && self.skipped.is_none()
    }

    /// What a person would type where the new output is the right one; None where no golden can help.
    pub fn how_to_bless(&self, call: &str) -> Option<String> {
        let is_golden = |failure: &Failure| {
            matches!(
                failure,
                Failure::Missing(_) | Failure::Text { .. } | Failure::Size { .. } | Failure::Picture(_)
            )
        };
        let name = &self.case.name;
        let name = if name.contains(char::is_whitespace) { format!("'{name}'") } else { name.clone() };
        self.failures.iter().any(is_golden).then(|| format!("raytoy test {name}{call} --bless"))
    }
}

impl Failure {
    /// One word for programs.
    pub fn kind(&self) -> &'static str {
        match self {
            Failure::Mistakes(_) => "mistakes",
            Failure::Missing(_) => "missing",
            Failure::Obstacle(_) => "obstacle",
            Failure::Text { .. } => "text",
            Failure::Size { .. } => "size",
            Failure::Picture(_) => "picture",
            Failure::Law(_) => "law",
        }
    }

    /// What happened, in a line or several.
    pub fn told(&self) -> Vec<String> {
        match self {
            Failure::Mistakes(report) => report.trim_end().lines().map(str::to_owned).collect(),
            Failure::Missing(golden) => vec![format!("there is no golden `{}`", golden.display())],
            Failure::Obstacle(why) => why.lines().map(str::to_owned).collect(),
            Failure::Text { golden, difference } => {
                let [gone, new] = difference.counts();
                let head = format!("{} differs: {gone} lines gone, {new} new", golden.display());
                [vec![head], difference.told()].concat()
            }
            Failure::Size { golden, sizes: [(w, h), (width, height)] } => {
                let now = format!("the picture is {width}x{height}");
                vec![format!("{} is {w}x{h}, and {now}", golden.display())]
            }
            Failure::Picture(failure) => failure.told(),
            Failure::Law(broken) => vec![broken.to_string()],
        }
    }
}

impl PictureFailure {
    fn told(&self) -> Vec<String> {
        let mut lines = vec![format!("{} looks different", self.golden.display())];
        lines.extend(self.verdict.broken().into_iter().map(|broken| measure(&self.verdict, broken)));
        let seen = match self.change {
            Some(Change::Shift { word, by }) => format!("{word} by about {by:.1} of 100"),
            Some(Change::Elsewhere { by }) => {
                format!("something moved or looks another way: off by about {by:.1} of 100")
            }
            None => "nothing that can be seen".into(),
        };
        let place = self.verdict.outliers.bounds.map_or(String::new(), |area| format!(" in {}", told(area)));
        let objects = self.objects.iter().map(|(name, share)| format!("\"{name}\" {:.0} %", share * 100.0));
        let objects = objects.collect::<Vec<_>>().join(", ");
        let objects = if objects.is_empty() { objects } else { format!("; there is now {objects}") };
        lines.push(format!("{seen}{place}{objects}"));
        if let Some(worst) = self.verdict.outliers.worst {
            let color = |[r, g, b]: [u8; 3]| format!("rgb({r}, {g}, {b})");
            let [x, y] = worst.at;
            let (was, is) = (color(worst.expected), color(worst.actual));
            lines.push(format!("most in the pixel ({x}, {y}): {is}, where {was} is expected"));
        }
        lines
    }
}

fn measure(verdict: &Verdict, broken: Broken) -> String {
    let limits = verdict.limits;
    match broken {
        Broken::Outliers => format!(
            "{} pixels ({:.2} %) differ by more than {} of 255; {} % may",
            verdict.outliers.count,
            verdict.outliers.share() * 100.0,
            limits.tolerance,
            trimmed(limits.outliers * 100.0),
        ),
        Broken::Structure => {
            format!(
                "its structure is similar to {:.4}; {} is the least",
                verdict.structure.mean, limits.structure
            )
        }
        Broken::Window => {
            let [x, y] = verdict.structure.least_at;
            let least = verdict.structure.least;
            format!("the window at ({x}, {y}) is similar to {least:.3}; {} is the least", limits.window)
        }
        Broken::Flip => format!("FLIP sees {:.5}; {} is the most", verdict.flip, limits.flip),
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
