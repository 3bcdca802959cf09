//! What differs between two texts: hunks as in a unified diff, each with the function and the object that it
//! lies in.

use std::collections::BTreeSet;

use similar::{ChangeTag, TextDiff};

/// How a generated text, or a report, differs from its golden.
#[derive(Clone, Debug, PartialEq, Eq, Default)]
pub struct TextDifference {
    pub hunks: Vec<Hunk>,
    /// The objects that only the golden has, and those that only the new text has.
    pub gone: Vec<String>,
    pub new: Vec<String>,
    /// The objects of both in whose lines something differs.
    pub changed: Vec<String>,
}

/// Lines that differ, with those around them.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Hunk {
    /// First line, from 1, and count, in the golden and in the new text.
    pub old: [usize; 2],
    pub new: [usize; 2],
    /// "`rayTraceScene`, object \"ball\"", or empty.
    pub place: String,
    /// ' ', '-' or '+', and the line without its end.
    pub lines: Vec<(char, String)>,
}

/// Lines around what differs.
const CONTEXT: usize = 2;

impl TextDifference {
    /// None where the texts are the same.
    pub fn between(golden: &str, actual: &str) -> Option<Self> {
        let diff = TextDiff::from_lines(golden, actual);
        let old: Vec<&str> = golden.lines().collect();
        let new: Vec<&str> = actual.lines().collect();
        let mut found = Self::default();
        let mut touched = BTreeSet::new();
        for group in diff.grouped_ops(CONTEXT) {
            let (first, last) = (group.first()?, group.last()?);
            let [olds, news] = [
                first.old_range().start..last.old_range().end,
                first.new_range().start..last.new_range().end,
            ];
            let mut lines = vec![];
            let mut place = String::new();
            for change in group.iter().flat_map(|op| diff.iter_changes(op)) {
                let sign = match change.tag() {
                    ChangeTag::Equal => ' ',
                    ChangeTag::Delete => '-',
                    ChangeTag::Insert => '+',
                };
                if sign != ' ' {
                    let (text, at) = match change.new_index() {
                        Some(at) => (&new, at),
                        None => (&old, change.old_index().unwrap_or(0)),
                    };
                    let (function, object) = place_of(text, at);
                    if place.is_empty() {
                        place = described(function, object);
                    }
                    // Comments count the objects: one that goes changes those of all that follow.
                    let is_code = !change.value().trim_start().starts_with("//");
                    touched.extend(object.filter(|_| is_code).map(str::to_owned));
                }
                let line: &str = change.value();
                lines.push((sign, line.trim_end_matches(['\n', '\r']).to_owned()));
            }
            found.hunks.push(Hunk {
                old: [olds.start + 1, olds.len()],
                new: [news.start + 1, news.len()],
                place,
                lines,
            });
        }
        let [before, after] = [objects(golden), objects(actual)];
        let only = |a: &[String], b: &[String]| a.iter().filter(|n| !b.contains(n)).cloned().collect();
        (found.gone, found.new) = (only(&before, &after), only(&after, &before));
        let in_both = |name: &String| before.contains(name) && after.contains(name);
        found.changed = touched.into_iter().filter(in_both).collect();
        (!found.hunks.is_empty()).then_some(found)
    }

    /// How many lines only the golden has, and how many only the new text.
    pub fn counts(&self) -> [usize; 2] {
        let count = |sign| self.hunks.iter().flat_map(|h| &h.lines).filter(|(s, _)| *s == sign).count();
        [count('-'), count('+')]
    }

    /// As in a unified diff, and where that is more than `most` lines how many more there are.
    pub fn unified(&self, most: usize) -> (Vec<String>, usize) {
        let mut lines = vec![];
        let mut left = most;
        for hunk in &self.hunks {
            if left == 0 {
                break;
            }
            lines.push(hunk.head());
            let shown = hunk.lines.iter().take(left);
            lines.extend(shown.map(|(sign, line)| format!("{sign}{line}").trim_end().to_owned()));
            left = left.saturating_sub(hunk.lines.len());
        }
        let all: usize = self.hunks.iter().map(|hunk| hunk.lines.len()).sum();
        (lines, all.saturating_sub(most))
    }

    /// What a person would say of the objects; nothing where no object is known to have changed.
    pub fn told(&self) -> Vec<String> {
        let tell = |names: &[String], what: &'static str| {
            names.iter().map(move |name| format!("the object \"{name}\" {what}")).collect::<Vec<_>>()
        };
        let all =
            [tell(&self.gone, "is gone"), tell(&self.new, "is new"), tell(&self.changed, "moved or changed")];
        all.concat()
    }
}

impl Hunk {
    /// `@@ -20,5 +20,6 @@ rayTraceScene`
    pub fn head(&self) -> String {
        let Hunk { old, new, place, .. } = self;
        format!("@@ -{},{} +{},{} @@ {place}", old[0], old[1], new[0], new[1]).trim_end().to_owned()
    }
}

/// `golden` with the first line of `actual`: that names the scene's file, which may be another one, or the
/// same one from another folder.
pub fn with_origin_of(actual: &str, golden: &str) -> String {
    match (actual.split_once('\n'), golden.split_once('\n')) {
        (Some((origin, _)), Some((_, rest)))
            if [actual, golden].iter().all(|text| scene_of(text).is_some()) =>
        {
            format!("{origin}\n{rest}")
        }
        _ => golden.to_owned(),
    }
}

/// The file of the scene that a text was generated from, as its first line names it.
pub fn scene_of(text: &str) -> Option<&str> {
    text.lines().next()?.strip_prefix("// Generated from ")
}

/// The function that line `at` lies in, and the object whose words stand over that, or over one before: what
/// has no doc line goes with what stands before it.
fn place_of<'a>(lines: &[&'a str], at: usize) -> (Option<&'a str>, Option<&'a str>) {
    let above = &lines[..(at + 1).min(lines.len())];
    let name = |line: &&'a str| line.strip_prefix("fn ")?.split('(').next();
    let function = match above.last().is_some_and(|line| line.starts_with("///")) {
        true => lines[at..].iter().find_map(name),
        false => above.iter().rev().take_while(|line| **line != "}").find_map(name),
    };
    let object = above.iter().rev().find(|line| line.starts_with("///")).and_then(|line| object_of(line));
    (function, object)
}

fn described(function: Option<&str>, object: Option<&str>) -> String {
    let function = function.map(|name| format!("`{name}`"));
    let object = object.map(|name| format!("object \"{name}\""));
    [function, object].into_iter().flatten().collect::<Vec<_>>().join(", ")
}

/// The name in a doc line such as `/// objects[3] "ball": Sphere()`, or `/// "die": Difference()`.
fn object_of(line: &str) -> Option<&str> {
    let comment = line.strip_prefix("/// ")?;
    let named = match comment.strip_prefix("objects[") {
        Some(rest) => rest.split_once("] ")?.1,
        None => comment,
    };
    named.strip_prefix('"')?.split_once("\": ").map(|(name, _)| name)
}

/// The names of all objects, which the words over their functions give.
fn objects(text: &str) -> Vec<String> {
    let names: BTreeSet<&str> = text.lines().filter_map(object_of).collect();
    names.into_iter().map(str::to_owned).collect()
}
