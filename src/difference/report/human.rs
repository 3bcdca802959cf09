//! For people at a terminal: values, shader and picture, each with what there is to say of it.

use super::{count, lines, sight, told};
use crate::difference::{SceneDifference, TextDifference};

/// Words of a value beyond so many letters are cut, and a diff after so many lines: the whole is in the page.
const MAX_LETTERS: usize = 72;
const MAX_LINES: usize = 40;

/// The text of what differs.
pub fn human(difference: &SceneDifference) -> String {
    let mut text = format!("values   {}\n", count(difference.values.len()));
    for change in &difference.values {
        text += &format!("  {}  ({})\n", told(change, cut), lines(change, &difference.names));
    }
    text += &section("shader", &difference.shader.told());
    text += &difference.shader.text.as_ref().map_or(String::new(), diff);
    if let Some(picture) = &difference.picture {
        text += &section("picture", &sight(picture));
    }
    text
}

/// The first line beside `what` it is of, and the others below.
fn section(what: &str, lines: &[String]) -> String {
    let (first, rest) = lines.split_first().expect("there is something to tell");
    let rest: String = rest.iter().map(|line| format!("  {line}\n")).collect();
    format!("{what:8} {first}\n{rest}")
}

fn diff(difference: &TextDifference) -> String {
    let (lines, more) = difference.unified(MAX_LINES);
    let mut text: String = lines.iter().map(|line| format!("  {line}\n")).collect();
    if more > 0 {
        text += &format!("  … {more} more lines; `--report diff.html` shows all\n");
    }
    text
}

fn cut(words: &str) -> String {
    match words.char_indices().nth(MAX_LETTERS) {
        Some((at, _)) => format!("{}…", &words[..at]),
        None => words.to_owned(),
    }
}
