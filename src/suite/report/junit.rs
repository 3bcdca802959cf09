//! For continuous integration: the XML that JUnit began and most services read.

use super::Run;
use crate::difference::html::escaped;
use crate::suite::Outcome;

/// The XML text of a run.
pub fn junit(run: &Run) -> String {
    let skipped = run.outcomes.iter().filter(|outcome| outcome.skipped.is_some()).count();
    let seconds: f64 = run.outcomes.iter().map(|outcome| outcome.time.as_secs_f64()).sum();
    let tests: String = run.outcomes.iter().map(|outcome| test(run, outcome)).collect();
    format!(
        "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n\
         <testsuites>\n  \
         <testsuite name=\"raytoy\" tests=\"{}\" failures=\"{}\" errors=\"0\" skipped=\"{skipped}\" \
         time=\"{seconds:.3}\">\n{tests}  </testsuite>\n</testsuites>\n",
        run.outcomes.len(),
        run.failed(),
    )
}

fn test(run: &Run, outcome: &Outcome) -> String {
    let name = &outcome.case.name;
    let (folder, file) = name.rsplit_once('/').unwrap_or(("", name));
    let open = format!(
        "    <testcase classname=\"{}\" name=\"{}\" time=\"{:.3}\"",
        escaped(folder),
        escaped(file),
        outcome.time.as_secs_f64()
    );
    if let Some(why) = &outcome.skipped {
        return format!("{open}>\n      <skipped message=\"{}\"/>\n    </testcase>\n", escaped(why));
    }
    let warnings = match outcome.warnings.concat() {
        none if none.is_empty() => none,
        all => format!("      <system-out>{}</system-out>\n", escaped(all.trim_end())),
    };
    if outcome.failures.is_empty() && warnings.is_empty() {
        return format!("{open}/>\n");
    }
    if outcome.failures.is_empty() {
        return format!("{open}>\n{warnings}    </testcase>\n");
    }
    let mut lines: Vec<String> = outcome.failures.iter().flat_map(|failure| failure.told()).collect();
    lines.extend(outcome.how_to_bless(&run.call).map(|how| how.join(": ")));
    let first = escaped(&lines[0]);
    let all = escaped(&lines.join("\n"));
    format!("{open}>\n      <failure message=\"{first}\">{all}</failure>\n{warnings}    </testcase>\n")
}
