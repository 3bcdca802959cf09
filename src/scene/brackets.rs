//! The brackets of a text, with strings and comments skipped, and limits of how many there may be.
//!
//! In: the text of a scene, also one that does not parse. Out: brackets and commas with their places; the
//! first excess. The parser takes kilobytes for each value, and runs out of its stack, so this comes first.

use std::ops::Range;

use super::numbers::skipped;

/// How deep brackets may be nested: a few fewer than the parser takes.
const DEEPEST: usize = 120;

/// How many things one pair of brackets may hold, and how many pairs there may be.
const MAX_ITEMS: usize = 10_000;
const MAX_PAIRS: usize = 200_000;

/// What is too much, and where.
pub struct Excess {
    pub message: String,
    pub span: Range<usize>,
}

/// The first excess of `text`.
pub fn excess(text: &str) -> Option<Excess> {
    let mut open: Vec<(usize, usize)> = vec![];
    let mut longest = (0, 0);
    let mut pairs = 0;
    for (at, mark) in marks(text) {
        match mark {
            '(' | '[' | '{' => {
                open.push((at, 0));
                pairs += 1;
                let message = match () {
                    () if open.len() > DEEPEST => format!("brackets are nested more than {DEEPEST} deep"),
                    () if pairs > MAX_PAIRS => format!("the scene has more than {MAX_PAIRS} brackets"),
                    () => continue,
                };
                return Some(Excess { message, span: at..at + 1 });
            }
            ',' => {
                if let Some((_, commas)) = open.last_mut() {
                    *commas += 1;
                }
            }
            _ => longest = longest.max(open.pop().map_or((0, 0), |(at, commas)| (commas, at))),
        }
        // Brackets that nothing closes end the search early.
        longest = longest.max(open.last().map_or((0, 0), |(at, commas)| (*commas, *at)));
    }
    let (items, at) = longest;
    let message = format!("{items} items in one list: at most {MAX_ITEMS} are allowed");
    (items > MAX_ITEMS).then_some(Excess { message, span: at..at + 1 })
}

/// Brackets and commas outside of strings, characters and comments.
pub fn marks(text: &str) -> impl Iterator<Item = (usize, char)> {
    let mut at = 0;
    std::iter::from_fn(move || {
        loop {
            let rest = &text[at..];
            let c = rest.chars().next()?;
            let here = at;
            let is_quoted = c == '\'' && rest.as_bytes().get(2) == Some(&b'\'');
            at += if is_quoted { 3 } else { skipped(rest).unwrap_or(c.len_utf8()) };
            if !is_quoted && matches!(c, '(' | '[' | '{' | ')' | ']' | '}' | ',') {
                return Some((here, c));
            }
        }
    })
}
