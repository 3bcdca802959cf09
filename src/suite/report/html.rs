//! A page that opens without a network: each failure with its pictures, its diff and its numbers.

use super::Run;
use crate::difference::html::{Page, escaped, hunks, numbers, pictures, told};
use crate::judge::Verdict;
use crate::suite::{Failure, Outcome};

/// The page of a run.
pub fn html(run: &Run) -> String {
    let (passed, failed) = (run.passed(), run.failed());
    let skipped: Vec<&Outcome> = run.outcomes.iter().filter(|o| o.skipped.is_some()).collect();
    let wrong: Vec<&Outcome> = run.outcomes.iter().filter(|o| !o.failures.is_empty()).collect();
    let right: Vec<&Outcome> = run.outcomes.iter().filter(|o| o.passes()).collect();
    let links: String = wrong
        .iter()
        .enumerate()
        .map(|(i, outcome)| format!("<li><a href=\"#t{i}\">{}</a></li>\n", escaped(&outcome.case.name)))
        .collect();
    let contents =
        if wrong.len() > 1 { format!("<ul class=\"contents\">\n{links}</ul>\n") } else { String::new() };
    let stories: String = wrong.iter().enumerate().map(|(i, outcome)| story(run, i, outcome)).collect();
    let rows: String = right.iter().map(|outcome| row(outcome)).collect();
    let skips = skipped.iter().map(|outcome| {
        let why = outcome.skipped.as_deref().unwrap_or_default();
        format!("<tr><td>{}</td><td>{}</td></tr>\n", escaped(&outcome.case.name), escaped(why))
    });
    let skips: String = skips.collect();
    let skips = match skipped.len() {
        0 => skips,
        n => format!("<details><summary>{n} skipped</summary>\n<table>\n{skips}</table>\n</details>\n"),
    };
    let (state, open) = if failed == 0 { ("good", " open") } else { ("bad", "") };
    let heading = format!("{passed} passed, {failed} failed");
    let page = Page {
        title: &format!("raytoy test: {heading}"),
        state,
        heading: &heading,
        origin: &format!("Drawn by {}.", run.adapter),
        body: &format!(
            "{contents}{stories}<details{open}><summary>{passed} passed</summary>\n<table>\n\
             <tr><th>test</th><th>outliers</th><th>structure</th><th>worst window</th><th>FLIP</th>\
             <th>ms</th></tr>\n{rows}</table>\n</details>\n{skips}"
        ),
    };
    page.text()
}

fn row(outcome: &Outcome) -> String {
    let measures = outcome.verdict.as_ref().map_or("<td></td>".repeat(4), |verdict| {
        let Verdict { outliers, structure, flip, .. } = verdict;
        format!(
            "<td>{}</td><td>{:.4}</td><td>{:.3}</td><td>{:.5}</td>",
            outliers.count, structure.mean, structure.least, flip
        )
    });
    let (name, ms) = (escaped(&outcome.case.name), outcome.time.as_millis());
    let name = name + &warnings(outcome);
    format!("<tr><td>{name}</td>{measures}<td>{ms}</td></tr>\n")
}

fn warnings(outcome: &Outcome) -> String {
    let pre = |warning: &String| format!("<pre class=\"report\">{}</pre>\n", escaped(warning));
    outcome.warnings.iter().map(pre).collect()
}

fn story(run: &Run, index: usize, outcome: &Outcome) -> String {
    let mut text =
        format!("<section class=\"bad\" id=\"t{index}\">\n<h2>{}</h2>\n", escaped(&outcome.case.name));
    text += &warnings(outcome);
    for failure in &outcome.failures {
        text += &match failure {
            Failure::Mistakes(report) => format!("<pre class=\"report\">{}</pre>\n", escaped(report)),
            Failure::Picture { difference, .. } => {
                told(&failure.told())
                    + &pictures(difference, ["expected", "actual"])
                    + &numbers(&difference.verdict)
            }
            Failure::Text { difference, .. } => told(&failure.told()) + &hunks(&difference.hunks),
            _ => told(&failure.told()),
        };
    }
    if let Some([when, command]) = outcome.how_to_bless(&run.call) {
        let [first, rest] = [&when[..1], &when[1..]];
        let when = first.to_uppercase() + rest;
        text += &format!("<p class=\"bless\">{when}: <code>{}</code></p>\n", escaped(&command));
    }
    text + "</section>\n"
}
