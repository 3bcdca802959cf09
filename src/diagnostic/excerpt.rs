//! The lines that a message is about, cut to the width of a terminal around what it points at.
//!
//! In: texts, and a diagnostic with places in them. Out: the same places in excerpts, and what lines and
//! columns they have in the whole texts.

use std::collections::BTreeMap;
use std::ops::Range;

use codespan_reporting::diagnostic::{Diagnostic, LabelStyle};
use codespan_reporting::files::{Error, Files, line_starts};

/// The widest line in columns. With the number of the line before it, it fits into 100.
const WIDTH: usize = 90;

/// A text with its name.
pub struct Text<'a> {
    name: &'a str,
    text: &'a str,
    starts: Vec<usize>,
}

/// For each text that has a place, its lines from the first place to the last.
pub struct Excerpts<'a>(BTreeMap<usize, Excerpt<'a>>);

struct Excerpt<'a> {
    name: &'a str,
    text: String,
    lines: Vec<Line>,
}

/// A line of an excerpt, and of the text.
struct Line {
    /// Its first column in the excerpt.
    start: usize,
    /// Its number in the text, from 0, and the bytes of the text that it shows.
    number: usize,
    shown: Range<usize>,
    /// How many characters are cut off before these.
    cut: usize,
}

const CUT: &str = "…";

impl<'a> Text<'a> {
    pub fn new(name: &'a str, text: &'a str) -> Self {
        Self { name, text, starts: line_starts(text).collect() }
    }

    fn line_of(&self, byte: usize) -> usize {
        self.starts.partition_point(|start| *start <= byte).saturating_sub(1)
    }
}

impl<'a> Excerpts<'a> {
    /// The excerpts for `diagnostic`, whose places become places in them.
    pub fn of(texts: &[Text<'a>], diagnostic: &mut Diagnostic<usize>) -> Self {
        let mut found = BTreeMap::new();
        for (id, text) in texts.iter().enumerate() {
            let labels = diagnostic.labels.iter().filter(|label| label.file_id == id);
            let points: Vec<Range<usize>> = labels.map(|label| label.range.clone()).collect();
            let Some(first) = points.iter().map(|range| range.start).min() else { continue };
            let last = points.iter().map(|range| range.end).max().unwrap_or(first);
            let excerpt = Excerpt::new(text, text.line_of(first)..text.line_of(last) + 1, &points);
            // What the excerpt has no room for is named by its line and column.
            diagnostic.labels.retain(|label| {
                let byte = label.range.start;
                let is_out =
                    label.file_id == id && label.style == LabelStyle::Secondary && !excerpt.shows(byte);
                if is_out {
                    let line = text.line_of(byte);
                    let column = 1 + text.text[text.starts[line]..byte].chars().count();
                    let (message, name) = (&label.message, text.name);
                    diagnostic.notes.push(format!("{message}: {name}:{}:{column}", line + 1));
                }
                !is_out
            });
            for label in diagnostic.labels.iter_mut().filter(|label| label.file_id == id) {
                label.range = excerpt.place(label.range.start)..excerpt.place(label.range.end);
            }
            found.insert(id, excerpt);
        }
        Self(found)
    }

    fn excerpt(&self, id: usize) -> Result<&Excerpt<'a>, Error> {
        self.0.get(&id).ok_or(Error::FileMissing)
    }
}

impl<'a> Excerpt<'a> {
    fn new(text: &Text<'a>, lines: Range<usize>, points: &[Range<usize>]) -> Self {
        let mut excerpt = Self { name: text.name, text: String::new(), lines: vec![] };
        for number in lines {
            let start = text.starts[number];
            let end = text.starts.get(number + 1).copied().unwrap_or(text.text.len());
            let whole = text.text[start..end].trim_end_matches(['\n', '\r']);
            let end_of_line = &text.text[start + whole.len()..end];
            // What is to be seen: the first thing on the line that a place begins or ends with.
            let on_line = |byte: &usize| (start..=start + whole.len()).contains(byte);
            let begins = points.iter().map(|p| p.start).find(on_line);
            let point = begins.or_else(|| points.iter().map(|p| p.end).find(on_line)).unwrap_or(start);
            let shown = window(whole, point - start);
            let line = Line {
                start: excerpt.text.len(),
                number,
                shown: start + shown.start..start + shown.end,
                cut: whole[..shown.start].chars().count(),
            };
            excerpt.text += if shown.start > 0 { CUT } else { "" };
            excerpt.text += &whole[shown.clone()];
            excerpt.text += if shown.end < whole.len() { CUT } else { "" };
            excerpt.text += end_of_line;
            excerpt.lines.push(line);
        }
        excerpt
    }

    /// Reports if the excerpt contains a byte of the text.
    fn shows(&self, byte: usize) -> bool {
        self.lines.iter().any(|line| (line.shown.start..=line.shown.end).contains(&byte))
    }

    /// The column of a byte of the text, or of the nearest byte shown of its line.
    fn place(&self, byte: usize) -> usize {
        let index = self.lines.partition_point(|line| line.shown.start <= byte).saturating_sub(1);
        let line = &self.lines[index];
        let lead = if line.cut > 0 { CUT.len() } else { 0 };
        line.start + lead + byte.clamp(line.shown.start, line.shown.end) - line.shown.start
    }
}

/// The part of `line` that is shown so that `point` is in it: all of it, if that is narrow enough.
fn window(line: &str, point: usize) -> Range<usize> {
    let width = |text: &str| text.chars().map(columns).sum::<usize>();
    if width(line) <= WIDTH {
        return 0..line.len();
    }
    let point = line.floor_char_boundary(point.min(line.len()));
    let fitting = |left: usize, letters: &mut dyn Iterator<Item = char>| {
        let mut left = left;
        let fits = |c: &char| {
            let wide = columns(*c);
            left = left.saturating_sub(wide);
            left > 0
        };
        letters.take_while(fits).map(char::len_utf8).sum::<usize>()
    };
    // A third of what there is stands before the place, more where the line ends soon.
    let room = WIDTH - 2;
    let behind = width(&line[point..]);
    let before = (room / 3).max(room.saturating_sub(behind));
    let start = point - fitting(before, &mut line[..point].chars().rev());
    let end = start + fitting(room, &mut line[start..].chars());
    start..end.max(point)
}

/// At most how wide it is drawn.
fn columns(c: char) -> usize {
    match c {
        '\t' => 4,
        c if c.is_ascii() => 1,
        _ => 2,
    }
}

impl<'a> Files<'a> for Excerpts<'a> {
    type FileId = usize;
    type Name = &'a str;
    type Source = &'a str;

    fn name(&'a self, id: usize) -> Result<&'a str, Error> {
        self.excerpt(id).map(|excerpt| excerpt.name)
    }

    fn source(&'a self, id: usize) -> Result<&'a str, Error> {
        self.excerpt(id).map(|excerpt| excerpt.text.as_str())
    }

    fn line_index(&'a self, id: usize, byte: usize) -> Result<usize, Error> {
        let lines = &self.excerpt(id)?.lines;
        Ok(lines.partition_point(|line| line.start <= byte).saturating_sub(1))
    }

    fn line_number(&'a self, id: usize, index: usize) -> Result<usize, Error> {
        let lines = &self.excerpt(id)?.lines;
        let line = lines.get(index).ok_or(Error::LineTooLarge { given: index, max: lines.len() })?;
        Ok(line.number + 1)
    }

    fn column_number(&'a self, id: usize, index: usize, byte: usize) -> Result<usize, Error> {
        let excerpt = self.excerpt(id)?;
        let line = &excerpt.lines[index];
        let before = excerpt.text[line.start..byte].chars().count();
        // The sign of the cut stands for what is cut.
        Ok(1 + line.cut + before - usize::from(line.cut > 0 && before > 0))
    }

    fn line_range(&'a self, id: usize, index: usize) -> Result<Range<usize>, Error> {
        let excerpt = self.excerpt(id)?;
        let max = excerpt.lines.len();
        let start = excerpt.lines.get(index).ok_or(Error::LineTooLarge { given: index, max })?.start;
        Ok(start..excerpt.lines.get(index + 1).map_or(excerpt.text.len(), |next| next.start))
    }
}
