//! For people at a terminal: a line for each test, the story of each failure, and the count.

use super::Run;
use crate::suite::{Failure, Outcome};

/// A diff is cut after so many lines: the whole is in the page.
const MAX_LINES: usize = 24;

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
    for line in outcome.warnings.iter().flat_map(|warning| warning.trim_end().lines()) {
        text += format!("    {line}").trim_end();
        text.push('\n');
    }
    for (path, is_new) in &outcome.written {
        let what = if *is_new { "new" } else { "changed" };
        text += &format!("    wrote {} ({what})\n", path.display());
    }
    for path in &outcome.removed {
        text += &format!("    removed {}\n", path.display());
    }
    for failure in &outcome.failures {
        for (i, line) in failure.told().into_iter().enumerate() {
            let indent = if i == 0 || matches!(failure, Failure::Mistakes(_)) { "    " } else { "      " };
            text += format!("{indent}{line}").trim_end();
            text.push('\n');
        }
        if let Failure::Text { difference, .. } = failure {
            let (lines, more) = difference.unified(MAX_LINES);
            lines.iter().for_each(|line| text += &format!("      {line}\n"));
            if more > 0 {
                text += &format!("      … {more} more lines; `--report report.html` shows all\n");
            }
        }
    }
    if let Some([when, command]) = outcome.how_to_bless(&run.call) {
        text += &format!("    {when}: {command}\n");
    }
    text
}
