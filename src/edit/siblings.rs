//! Things between brackets, with commas: fields, entries and items, put in and taken out as a person would.

use std::ops::Range;

use super::TextEdit;
use super::trivia::{self, Trivia};
use crate::scene::{Kind, Value};

/// What stands between the brackets of a value.
pub struct Siblings<'t> {
    text: &'t str,
    /// Behind the opening bracket.
    open: usize,
    /// At the closing one.
    close: usize,
    items: Vec<Item>,
}

/// A field with its name, an entry with its key, or an item.
struct Item {
    span: Range<usize>,
    comma: Option<usize>,
}

impl Item {
    /// Where it ends, with its comma.
    fn end(&self) -> usize {
        self.comma.map_or(self.span.end, |comma| comma + 1)
    }
}

impl<'t> Siblings<'t> {
    /// Those of `value` in `text`; None where it has no brackets.
    pub fn of(text: &'t str, value: &Value) -> Option<Self> {
        let open = match &value.kind {
            Kind::Record(record) => record.name.as_ref().map_or(value.span.start, |n| {
                // A name by itself has no brackets, and ends where its value ends.
                if n.span.end == value.span.end { n.span.end } else { trivia::skip(text, n.span.end) }
            }),
            Kind::Tuple(_) | Kind::List(_) | Kind::Map(_) => value.span.start,
            _ => return None,
        };
        if open == value.span.end {
            return None;
        }
        let spans: Vec<Range<usize>> = match &value.kind {
            Kind::Record(record) if record.fields.is_empty() => {
                record.items.iter().map(|item| item.whole.clone()).collect()
            }
            Kind::Record(crate::scene::Record { fields, .. }) | Kind::Map(fields) => {
                fields.iter().map(|f| f.name.span.start..f.value.whole.end).collect()
            }
            Kind::Tuple(items) | Kind::List(items) => items.iter().map(|item| item.whole.clone()).collect(),
            _ => vec![],
        };
        let item = |span: Range<usize>| {
            let next = trivia::skip(text, span.end);
            Item { comma: text[next..].starts_with(',').then_some(next), span }
        };
        let items = spans.into_iter().map(item).collect();
        Some(Self { text, open: open + 1, close: value.span.end - 1, items })
    }

    pub fn len(&self) -> usize {
        self.items.len()
    }

    /// Where the words of item `index` are.
    pub fn span(&self, index: usize) -> Range<usize> {
        self.items[index].span.clone()
    }

    /// `words` as item `index`, before what is there now: on a line of its own where its neighbour is.
    pub fn insert(&self, index: usize, words: &str) -> TextEdit {
        if self.items.is_empty() {
            return self.insert_alone(words);
        }
        let from = self.behind(index);
        let Some(neighbour) = self.items.get(index) else { return self.append(words) };
        let at = neighbour.span.start;
        if self.opens_line(index) {
            let line_end = trivia::line_end(self.text, from);
            return TextEdit::insert(line_end, format!("{}{words},", self.new_line(line_end, at)));
        }
        match index {
            0 => TextEdit::insert(at, format!("{words}, ")),
            _ => TextEdit::insert(from, format!(" {words},")),
        }
    }

    fn insert_alone(&self, words: &str) -> TextEdit {
        if !trivia::breaks(self.text, self.open, self.close) {
            return TextEdit::insert(self.open, words.to_owned());
        }
        let around = trivia::indentation(self.text, self.close);
        let deeper = if around.contains('\t') { "\t" } else { "    " };
        let at = trivia::line_end(self.text, self.open);
        let line_break = trivia::line_break(self.text, at);
        TextEdit::insert(at, format!("{line_break}{around}{deeper}{words},"))
    }

    fn append(&self, words: &str) -> TextEdit {
        let last = &self.items[self.items.len() - 1];
        let is_line = self.opens_line(self.items.len() - 1);
        let from = last.end();
        let at = if is_line { trivia::line_end(self.text, from) } else { from };
        let new_line = if is_line { self.new_line(at, last.span.start) } else { " ".into() };
        match last.comma {
            Some(_) => TextEdit::insert(at, format!("{new_line}{words},")),
            None => {
                let with = format!(",{}{new_line}{words}", &self.text[from..at]);
                TextEdit { span: from..at, with }
            }
        }
    }

    /// Item `index` taken out with its comma, and with its line where it has one. Comments of other lines
    /// stay.
    pub fn remove(&self, index: usize) -> TextEdit {
        let item = &self.items[index];
        let mut cuts = vec![];
        match self.own_lines(index) {
            Some(lines) => cuts.push(lines),
            None => self.cut_words(index, &mut cuts),
        }
        // Who writes no comma behind the last item has none behind the new last item either.
        let is_last = index + 1 == self.items.len();
        if is_last && item.comma.is_none() && index > 0 {
            cuts.extend(self.items[index - 1].comma.map(|comma| comma..comma + 1));
        }
        TextEdit::cut(self.text, cuts)
    }

    /// The lines that have item `index` and nothing else but comments behind it.
    fn own_lines(&self, index: usize) -> Option<Range<usize>> {
        let item = &self.items[index];
        let start = trivia::line_start(self.text, item.span.start);
        let is_indented = self.text[start..item.span.start].chars().all(trivia::is_blank);
        if !self.opens_line(index) || !is_indented {
            return None;
        }
        if item.comma.is_some_and(|comma| self.text[item.span.end..comma].contains('\n')) {
            return None;
        }
        let mut at = item.end();
        while let Some((kind, end)) = trivia::next(self.text, at) {
            match kind {
                Trivia::LineEnd => return Some(start..end),
                Trivia::BlockComment if self.text[at..end].contains('\n') => return None,
                _ => at = end,
            }
        }
        None
    }

    /// Cuts item `index` with its comma and the blanks that go with it from a line with other things.
    fn cut_words(&self, index: usize, cuts: &mut Vec<Range<usize>>) {
        let item = &self.items[index];
        let is_last = index + 1 == self.items.len();
        let spaces_behind = |at: usize| {
            let rest = self.text[at..].trim_start_matches([' ', '\t']);
            let end = self.text.len() - rest.len();
            if rest.starts_with(['\n', '\r']) { at } else { end }
        };
        let before = &self.text[self.behind(index)..item.span.start];
        let (start, end) = match (self.opens_line(index), is_last) {
            (true, true) => (self.line_before(index), item.end()),
            (true, false) => (item.span.start, spaces_behind(item.end())),
            (false, false) if index == 0 => (item.span.start, spaces_behind(item.end())),
            (false, _) => (item.span.start - trailing_spaces(before), item.end()),
        };
        match item.comma {
            // A comment before the comma stays.
            Some(comma) if self.text[item.span.end..comma].contains('/') => {
                cuts.extend([start..item.span.end, comma..end]);
            }
            _ => cuts.push(start..end),
        }
    }

    /// Where the line ends that stands before item `index`, unless a comment runs up to there.
    fn line_before(&self, index: usize) -> usize {
        let (mut at, mut kept) = (self.behind(index), self.behind(index));
        let start = self.items[index].span.start;
        while at < start
            && let Some((kind, end)) = trivia::next(self.text, at)
        {
            match kind {
                Trivia::LineComment => return start,
                Trivia::BlockComment => kept = end,
                _ => {}
            }
            at = end;
        }
        kept
    }

    /// Where the item before `index` ends with its comma, or the bracket.
    fn behind(&self, index: usize) -> usize {
        index.checked_sub(1).map_or(self.open, |before| self.items[before].end())
    }

    /// Whether a line ends between item `index` and what stands before it.
    fn opens_line(&self, index: usize) -> bool {
        trivia::breaks(self.text, self.behind(index), self.items[index].span.start)
    }

    /// The line's end at `at`, and the blanks that the line of `like` opens with.
    fn new_line(&self, at: usize, like: usize) -> String {
        format!("{}{}", trivia::line_break(self.text, at), trivia::indentation(self.text, like))
    }
}

fn trailing_spaces(text: &str) -> usize {
    text.len() - text.trim_end_matches([' ', '\t']).len()
}
