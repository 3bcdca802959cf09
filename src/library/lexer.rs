//! The words and signs of WGSL.
//!
//! In: the text of a file. Out: its tokens, and apart from them its line comments.

use std::ops::Range;

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Kind {
    /// A name or a keyword.
    Word,
    Number,
    /// One character that is neither.
    Sign,
}

#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Token<'a> {
    pub kind: Kind,
    pub text: &'a str,
    pub start: usize,
}

impl Token<'_> {
    pub fn span(&self) -> Range<usize> {
        self.start..self.start + self.text.len()
    }

    pub fn is(&self, text: &str) -> bool {
        self.text == text
    }
}

/// What a file consists of.
#[derive(Debug, Default)]
pub struct Tokens<'a> {
    pub all: Vec<Token<'a>>,
    /// The places of comments that begin with `//`.
    pub line_comments: Vec<Range<usize>>,
}

/// Whether a line comment ends there.
pub fn ends_line(c: char) -> bool {
    matches!(c, '\n'..='\r' | '\u{85}' | '\u{2028}' | '\u{2029}')
}

/// WGSL has only the letters of names beyond ASCII; naga refuses others.
pub fn is_name_part(c: char) -> bool {
    c.is_ascii_alphanumeric() || c == '_' || (!c.is_ascii() && !is_blank(c))
}

/// Whether it may be the name of something.
pub fn is_name(text: &str) -> bool {
    !text.starts_with(|c: char| c.is_ascii_digit()) && !text.is_empty() && text.chars().all(is_name_part)
}

pub fn tokens(text: &str) -> Tokens<'_> {
    let mut found = Tokens::default();
    let mut at = 0;
    while let Some(c) = text[at..].chars().next() {
        let rest = &text[at..];
        let until = |ends: &dyn Fn(char) -> bool| rest.find(ends).unwrap_or(rest.len());
        let (kind, length) = if rest.starts_with("//") {
            let length = until(&ends_line);
            found.line_comments.push(at..at + length);
            at += length;
            continue;
        } else if rest.starts_with("/*") {
            at += block_comment(rest);
            continue;
        } else if is_blank(c) {
            at += c.len_utf8();
            continue;
        } else if rest.strip_prefix('.').unwrap_or(rest).starts_with(|c: char| c.is_ascii_digit()) {
            (Kind::Number, number(rest))
        } else if is_name_part(c) {
            (Kind::Word, until(&|c| !is_name_part(c)))
        } else {
            (Kind::Sign, c.len_utf8())
        };
        found.all.push(Token { kind, text: &rest[..length], start: at });
        at += length;
    }
    found
}

/// A byte-order mark and marks of direction, too.
fn is_blank(c: char) -> bool {
    c.is_whitespace() || matches!(c, '\u{feff}' | '\u{200e}' | '\u{200f}')
}

fn number(text: &str) -> usize {
    let is_hex = text.starts_with("0x") || text.starts_with("0X");
    let mut before = ' ';
    let ends = |(_, c): &(usize, char)| {
        let exponent = if is_hex { ['p', 'P'] } else { ['e', 'E'] };
        let signs = matches!(c, '+' | '-') && exponent.contains(&before);
        before = *c;
        !(c.is_ascii_alphanumeric() || *c == '.' || signs)
    };
    text.char_indices().find(ends).map_or(text.len(), |(at, _)| at)
}

/// The length of the comment that opens `text`, with those inside of it. RON has the same rule, which
/// `scene/numbers.rs` keeps for itself: each language may change its own.
fn block_comment(text: &str) -> usize {
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
