//! For programs: one object with all that was measured.

use serde::Serialize;

use super::Run;
use crate::difference::Measures;
use crate::judge::Area;
use crate::suite::{Failure, Outcome};

#[derive(Serialize)]
struct Report<'a> {
    passed: usize,
    failed: usize,
    skipped: usize,
    adapter: &'a str,
    tests: Vec<Test<'a>>,
}

#[derive(Serialize)]
struct Test<'a> {
    name: &'a str,
    /// passed, failed or skipped
    outcome: &'a str,
    milliseconds: u64,
    #[serde(skip_serializing_if = "Option::is_none")]
    reason: Option<&'a str>,
    #[serde(skip_serializing_if = "Vec::is_empty")]
    warnings: Vec<&'a str>,
    #[serde(skip_serializing_if = "Vec::is_empty")]
    written: Vec<String>,
    #[serde(skip_serializing_if = "Vec::is_empty")]
    removed: Vec<String>,
    #[serde(skip_serializing_if = "Option::is_none")]
    picture: Option<Measures>,
    #[serde(skip_serializing_if = "Vec::is_empty")]
    failures: Vec<Told>,
    #[serde(skip_serializing_if = "Option::is_none")]
    bless: Option<String>,
}

#[derive(Serialize)]
struct Told {
    kind: &'static str,
    message: String,
    /// left, top, right, bottom; ends included
    #[serde(skip_serializing_if = "Option::is_none")]
    area: Option<[u32; 4]>,
}

/// The JSON text of a run.
pub fn json(run: &Run) -> String {
    let report = Report {
        passed: run.passed(),
        failed: run.failed(),
        skipped: run.outcomes.iter().filter(|outcome| outcome.skipped.is_some()).count(),
        adapter: &run.adapter,
        tests: run.outcomes.iter().map(|outcome| test(run, outcome)).collect(),
    };
    serde_json::to_string_pretty(&report).expect("numbers and strings") + "\n"
}

fn test<'a>(run: &Run, outcome: &'a Outcome) -> Test<'a> {
    let word = match (&outcome.skipped, outcome.failures.is_empty()) {
        (Some(_), _) => "skipped",
        (None, true) => "passed",
        (None, false) => "failed",
    };
    Test {
        name: &outcome.case.name,
        outcome: word,
        milliseconds: outcome.time.as_millis() as u64,
        reason: outcome.skipped.as_deref(),
        warnings: outcome.warnings.iter().map(|warning| warning.trim_end()).collect(),
        written: outcome.written.iter().map(|(path, _)| path.display().to_string()).collect(),
        removed: outcome.removed.iter().map(|path| path.display().to_string()).collect(),
        picture: outcome.verdict.as_ref().map(Measures::of),
        failures: outcome.failures.iter().map(told).collect(),
        bless: outcome.how_to_bless(&run.call).map(|[_, command]| command),
    }
}

fn told(failure: &Failure) -> Told {
    let area = match failure {
        Failure::Picture { difference, .. } => difference.verdict.outliers.bounds.map(Area::corners),
        _ => None,
    };
    Told { kind: failure.kind(), message: failure.told().join("\n"), area }
}
