//! The numbers of RON, also in the forms that ron2 does not read.
//!
//! In: the text of a scene. Out: text of the same length for ron2, and what a number says.

use std::borrow::Cow;

/// Types that may stand behind a number, as in `1u32`.
const SUFFIXES: [&str; 12] =
    ["i8", "i16", "i32", "i64", "i128", "u8", "u16", "u32", "u64", "u128", "f32", "f64"];

/// `text` for ron2: blanks in place of a byte-order mark, and plain digits for numbers such as `1.` and `.5`.
/// All places stay as they are.
pub fn readable(text: &str) -> Cow<'_, str> {
    let mut readable = Cow::Borrowed(text);
    if text.starts_with('\u{feff}') {
        readable.to_mut().replace_range(..3, "   ");
    }
    let mut at = 0;
    while let Some(c) = text[at..].chars().next() {
        let rest = &text[at..];
        let length = skipped(rest).unwrap_or_else(|| {
            let word = &rest[..number_length(rest)];
            if is_unusual(word) && number(word).is_some() {
                let digits = format!("{:0>1$}", 1, word.len());
                readable.to_mut().replace_range(at..at + word.len(), &digits);
            }
            word.len().max(c.len_utf8())
        });
        at += length;
    }
    readable
}

/// What a number says: decimal, `1_000`, `0xff`, `0b1`, `0o7`, `1.`, `.5`, `1.5f32`.
pub fn number(raw: &str) -> Option<f64> {
    let (sign, digits) = match raw.strip_prefix('-') {
        Some(rest) => (-1.0, rest),
        None => (1.0, raw.strip_prefix('+').unwrap_or(raw)),
    };
    let plain = digits.replace('_', "");
    let whole = |plain: &str| {
        [("0x", 16), ("0b", 2), ("0o", 8)].iter().find_map(|(prefix, radix)| {
            let digits = plain.strip_prefix(prefix).filter(|digits| !digits.starts_with(['+', '-']))?;
            u128::from_str_radix(digits, *radix).ok().map(|n| n as f64)
        })
    };
    let value = |plain: &str| {
        let is_number = plain.starts_with(|c: char| c.is_ascii_digit() || c == '.');
        whole(plain).or_else(|| plain.parse().ok().filter(|_| is_number))
    };
    let without_suffix = || SUFFIXES.iter().find_map(|suffix| value(plain.strip_suffix(suffix)?));
    let starts_well = !digits.starts_with('_') && !digits.contains("._");
    value(&plain).or_else(without_suffix).filter(|_| starts_well).map(|value| sign * value)
}

/// The length of the comment that opens `text`, with those inside of it.
pub fn block_comment(text: &str) -> usize {
    let (mut depth, mut at) = (0, 0);
    while at < text.len() {
        if text[at..].starts_with("/*") {
            (depth, at) = (depth + 1, at + 2);
        } else if text[at..].starts_with("*/") {
            (depth, at) = (depth - 1, at + 2);
            if depth == 0 {
                break;
            }
        } else {
            at += text[at..].chars().next().map_or(1, char::len_utf8);
        }
    }
    at
}

/// Whether ron2 stumbles over a word that is a number.
fn is_unusual(word: &str) -> bool {
    let dot = word.find('.');
    dot.is_some_and(|dot| {
        let is_digit = |c: Option<char>| c.is_some_and(|c| c.is_ascii_digit());
        !is_digit(word[..dot].chars().next_back()) || !is_digit(word[dot + 1..].chars().next())
    })
}

/// The length of the word that a number, or what looks like one, opens `text` with.
fn number_length(text: &str) -> usize {
    let unsigned = text.strip_prefix(['+', '-']).unwrap_or(text);
    let mut begins = unsigned.chars().filter(|c| *c != '.');
    if !begins.next().is_some_and(|c| c.is_ascii_digit()) {
        return 0;
    }
    let is_hex = unsigned.starts_with("0x");
    let mut before = ' ';
    let ends = |(_, c): &(usize, char)| {
        let is_part = c.is_ascii_alphanumeric() || matches!(c, '_' | '.');
        let signs_exponent = matches!(c, '+' | '-') && matches!(before, 'e' | 'E') && !is_hex;
        before = *c;
        !(is_part || signs_exponent)
    };
    let length = unsigned.char_indices().find(ends).map_or(unsigned.len(), |(at, _)| at);
    text.len() - unsigned.len() + length
}

/// The length of the comment, string, character or name that opens `text`.
pub fn skipped(text: &str) -> Option<usize> {
    if text.starts_with("//") {
        return Some(text.find('\n').unwrap_or(text.len()));
    }
    if text.starts_with("/*") {
        return Some(block_comment(text));
    }
    let hashes = text.strip_prefix('r').map(|rest| rest.len() - rest.trim_start_matches('#').len());
    if let Some(hashes) = hashes.filter(|n| text[1 + n..].starts_with('"')) {
        let close = format!("\"{}", "#".repeat(hashes));
        let open = hashes + 2;
        return Some(text[open..].find(&close).map_or(text.len(), |at| open + at + close.len()));
    }
    if text.starts_with('"') {
        let mut is_escaped = true;
        let closes = |(_, c): &(usize, char)| {
            let closes = *c == '"' && !is_escaped;
            is_escaped = *c == '\\' && !is_escaped;
            closes
        };
        return Some(text.char_indices().find(closes).map_or(text.len(), |(at, _)| at + 1));
    }
    let is_part = |c: char| c.is_alphanumeric() || c == '_';
    let first = text.chars().next().filter(|c| is_part(*c) && !c.is_ascii_digit())?;
    let rest = &text[first.len_utf8()..];
    Some(first.len_utf8() + rest.find(|c| !is_part(c)).unwrap_or(rest.len()))
}
