//! A page that opens without a network: each failure with its pictures, its diff and its numbers.

use super::Run;
use super::human::head;
use super::junit::escaped;
use super::picture::{AMPLIFIED, data_url, difference};
use crate::judge::{Limits, Verdict};
use crate::suite::{Failure, Hunk, Outcome, PictureFailure};

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
    format!(
        include_str!("page.html"),
        passed = passed,
        failed = failed,
        style = include_str!("page.css"),
        state = if failed == 0 { "good" } else { "bad" },
        adapter = escaped(&run.adapter),
        version = env!("CARGO_PKG_VERSION"),
        contents = contents,
        stories = stories,
        open = if failed == 0 { " open" } else { "" },
        rows = rows,
        skips = skips,
    )
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
    format!("<tr><td>{name}</td>{measures}<td>{ms}</td></tr>\n")
}

fn story(run: &Run, index: usize, outcome: &Outcome) -> String {
    let mut text = format!("<section id=\"t{index}\">\n<h2>{}</h2>\n", escaped(&outcome.case.name));
    for failure in &outcome.failures {
        text += &match failure {
            Failure::Mistakes(report) => format!("<pre class=\"report\">{}</pre>\n", escaped(report)),
            Failure::Picture(picture) => told(failure) + &pictures(picture) + &numbers(&picture.verdict),
            Failure::Text { difference, .. } => told(failure) + &diff(&difference.hunks),
            _ => told(failure),
        };
    }
    if let Some(command) = outcome.how_to_bless(&run.call) {
        text += &format!(
            "<p class=\"bless\">If the new output is right: <code>{}</code></p>\n",
            escaped(&command)
        );
    }
    text + "</section>\n"
}

/// The first line, and the others as a list.
fn told(failure: &Failure) -> String {
    let lines = failure.told();
    let (first, rest) = lines.split_first().expect("each failure has something to tell");
    let rest: String = rest.iter().map(|line| format!("<li>{}</li>\n", escaped(line))).collect();
    let rest = if rest.is_empty() { rest } else { format!("<ul>\n{rest}</ul>\n") };
    format!("<h3>{}</h3>\n{rest}", escaped(first))
}

fn pictures(failure: &PictureFailure) -> String {
    let PictureFailure { expected, actual, .. } = failure;
    let [before, after] = [data_url(expected), data_url(actual)];
    let between = data_url(&difference(expected, actual));
    let (width, height) = expected.dimensions();
    let image = |url: &str, what: &str| {
        format!("<img src=\"{url}\" width=\"{width}\" height=\"{height}\" alt=\"{what}\">")
    };
    let figure = |url: &str, what: &str| {
        format!("<figure>{}<figcaption>{what}</figcaption></figure>\n", image(url, what))
    };
    format!(
        "<div class=\"pictures\">\n<figure class=\"slider\"><div class=\"pair\">{}{}</div>\
         <input type=\"range\" min=\"0\" max=\"100\" value=\"50\" aria-label=\"expected to actual\" \
         oninput=\"this.parentElement.style.setProperty('--at', this.value + '%')\">\
         <figcaption>expected on the left of the line, actual on the right: drag</figcaption></figure>\n\
         {}{}{}</div>\n",
        image(&before, "expected"),
        image(&after, "actual"),
        figure(&before, "expected"),
        figure(&after, "actual"),
        figure(&between, &format!("difference, {AMPLIFIED} times as strong")),
    )
}

fn numbers(verdict: &Verdict) -> String {
    let Limits { tolerance, outliers, structure, window, flip } = verdict.limits;
    let broken = verdict.broken();
    let row = |what: &str, broken_one, measured: String, limit: String| {
        let class = if broken.contains(&broken_one) { " class=\"off\"" } else { "" };
        format!("<tr{class}><td>{what}</td><td>{measured}</td><td>{limit}</td></tr>\n")
    };
    use crate::judge::Broken::{Flip, Outliers, Structure, Window};
    let percent = |share: f64| format!("{:.3} %", share * 100.0);
    let rows = [
        row(
            &format!("pixels off by more than {tolerance} of 255"),
            Outliers,
            percent(verdict.outliers.share()),
            format!("at most {}", percent(outliers)),
        ),
        row(
            "structural similarity, mean",
            Structure,
            format!("{:.5}", verdict.structure.mean),
            format!("at least {structure}"),
        ),
        row(
            "structural similarity, worst 8x8 window",
            Window,
            format!("{:.4}", verdict.structure.least),
            format!("at least {window}"),
        ),
        row("FLIP, mean", Flip, format!("{:.6}", verdict.flip), format!("at most {flip}")),
    ];
    let rows = rows.concat();
    format!(
        "<table class=\"numbers\">\n<tr><th>measure</th><th>is</th><th>may be</th></tr>\n{rows}</table>\n"
    )
}

fn diff(hunks: &[Hunk]) -> String {
    let mut text = String::from("<pre class=\"diff\">");
    for hunk in hunks {
        text += &format!("<span class=\"head\">{}</span>\n", escaped(&head(hunk)));
        for (sign, line) in &hunk.lines {
            let line = escaped(&format!("{sign}{line}"));
            text += &match sign {
                '-' => format!("<del>{line}</del>\n"),
                '+' => format!("<ins>{line}</ins>\n"),
                _ => format!("{line}\n"),
            };
        }
    }
    text + "</pre>\n"
}
