//! What stands between the words of a scene: blanks, line ends and comments.

use crate::scene::block_comment;

/// What RON takes for a blank.
pub fn is_blank(c: char) -> bool {
    matches!(
        c,
        ' ' | '\t'
            | '\n'
            | '\r'
            | '\x0B'
            | '\x0C'
            | '\u{85}'
            | '\u{200E}'
            | '\u{200F}'
            | '\u{2028}'
            | '\u{2029}'
    )
}

/// A blank or a comment.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Trivia {
    Blank,
    LineEnd,
    LineComment,
    BlockComment,
}

/// What begins at `at`, and where it ends; None at a word or at the end.
pub fn next(text: &str, at: usize) -> Option<(Trivia, usize)> {
    let rest = &text[at..];
    if rest.starts_with("//") {
        return Some((Trivia::LineComment, at + rest.find('\n').unwrap_or(rest.len())));
    }
    if rest.starts_with("/*") {
        return Some((Trivia::BlockComment, at + block_comment(rest)));
    }
    let c = rest.chars().next().filter(|c| is_blank(*c))?;
    Some((if c == '\n' { Trivia::LineEnd } else { Trivia::Blank }, at + c.len_utf8()))
}

/// Where the next word is, from `at` on.
pub fn skip(text: &str, at: usize) -> usize {
    let mut at = at;
    while let Some((_, end)) = next(text, at) {
        at = end;
    }
    at
}

/// Whether the trivia from `from` to `to` have the end of a line, comments of several lines aside.
pub fn breaks(text: &str, from: usize, to: usize) -> bool {
    let mut at = from;
    while at < to
        && let Some((kind, end)) = next(text, at)
    {
        if kind == Trivia::LineEnd {
            return true;
        }
        at = end;
    }
    false
}

/// Where the line goes on to from `from`: its end, before the `\n` or `\r\n`, or else behind the comments
/// that stand before the next word.
pub fn line_end(text: &str, from: usize) -> usize {
    let (mut at, mut comments) = (from, from);
    while let Some((kind, end)) = next(text, at) {
        match kind {
            Trivia::LineEnd => return at - usize::from(text[from..at].ends_with('\r')),
            Trivia::Blank => {}
            Trivia::LineComment => {
                // A `\r` before the line's end is a part of the comment as RON reads it, but not for us.
                comments = end - usize::from(text[at..end].ends_with('\r'));
                if end < text.len() {
                    return comments;
                }
            }
            Trivia::BlockComment => comments = end,
        }
        at = end;
    }
    comments
}

/// The start of the line of `at`.
pub fn line_start(text: &str, at: usize) -> usize {
    text[..at].rfind('\n').map_or(0, |n| n + 1)
}

/// The blanks that the line of `at` opens with.
pub fn indentation(text: &str, at: usize) -> &str {
    let line = &text[line_start(text, at)..];
    &line[..line.find(|c| !matches!(c, ' ' | '\t')).unwrap_or(line.len())]
}

/// How the line of `at` ends, or the one before where nothing ends it.
pub fn line_break(text: &str, at: usize) -> &'static str {
    let end = text[at..].find('\n').map_or(line_start(text, at), |n| at + n + 1);
    if text[..end].ends_with("\r\n") { "\r\n" } else { "\n" }
}
