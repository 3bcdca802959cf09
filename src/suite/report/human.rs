//! For people at a terminal: a line for each test, the story of each failure, and the count.

use std::fmt::Write;

use super::Run;
use crate::suite::{Failure, Hunk, Outcome};

/// A diff is cut after so many lines: the whole is in the page.
const MOST_LINES: usize = 24;

/// The text of a run, which ends with `N passed, N failed`.
pub fn human(run: &Run) -> String {
    let mut text = String::new();
    for outcome in &run.outcomes {
        text += &story(run, outcome);
    }
    text + &format!("{} passed, {} failed\n", run.passed(), run.failed())
}

fn story(run: &Run, outcome: &Outcome) -> String {
    let name = &outcome.case.name;
    if let Some(why) = &outcome.skipped {
        return format!("skipped  {name}: {why}\n");
    }
    let word = if outcome.failures.is_empty() { "ok      " } else { "FAILED  " };
    let mut text = format!("{word} {name}\n");
    for (path, is_new) in &outcome.written {
        let what = if *is_new { "new" } else { "changed" };
        text += &format!("    wrote {} ({what})\n", path.display());
    }
    for failure in &outcome.failures {
        for (i, line) in failure.told().into_iter().enumerate() {
            let indent = if i == 0 || matches!(failure, Failure::Mistakes(_)) { "    " } else { "      " };
            text += format!("{indent}{line}").trim_end();
            text.push('\n');
        }
        if let Failure::Text { difference, .. } = failure {
            text += &diff(&difference.hunks);
        }
    }
    if let Some(command) = outcome.how_to_bless(&run.call) {
        text += &format!("    if the new output is right: {command}\n");
    }
    text
}

/// As in a unified diff.
fn diff(hunks: &[Hunk]) -> String {
    let mut text = String::new();
    let mut left = MOST_LINES;
    for hunk in hunks {
        let lines = hunk.lines.len();
        if left == 0 {
            break;
        }
        writeln!(text, "      {}", head(hunk)).expect("a String takes all text");
        for (sign, line) in hunk.lines.iter().take(left) {
            writeln!(text, "      {}", format!("{sign}{line}").trim_end()).expect("a String takes all text");
        }
        left = left.saturating_sub(lines);
    }
    let all: usize = hunks.iter().map(|hunk| hunk.lines.len()).sum();
    if all > MOST_LINES {
        text += &format!("      … {} more lines: `--report report.html` has them\n", all - MOST_LINES);
    }
    text
}

/// `@@ -20,5 +20,6 @@ rayTraceScene`
pub fn head(hunk: &Hunk) -> String {
    let Hunk { old, new, place, .. } = hunk;
    format!("@@ -{},{} +{},{} @@ {place}", old[0], old[1], new[0], new[1]).trim_end().to_owned()
}
