//! What went wrong, where, and what to try: one type for every mistake that a user can make.
//!
//! In: messages from every room. Out: text for the terminal and the window, as codespan-reporting draws it.

mod excerpt;

use std::collections::BTreeMap;
use std::fmt;
use std::ops::Range;
use std::sync::Arc;

use codespan_reporting::diagnostic as codespan;
use codespan_reporting::term;

use excerpt::{Excerpts, Text};

/// How bad it is.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Severity {
    Warning,
    Error,
}

/// A stretch of a named text, in bytes.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Place {
    pub file: String,
    pub span: Range<usize>,
}

/// One problem. Messages are lower case, without a full stop, with names in backticks.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Diagnostic {
    pub severity: Severity,
    pub message: String,
    /// Places and what there is to say of each; the first is where it happened.
    pub labels: Vec<(Place, String)>,
    /// Advice: the text to type instead, and why.
    pub help: Vec<String>,
}

/// The longest list of names that a message shows.
const MAX_KNOWN: usize = 24;

impl Diagnostic {
    pub fn error(message: impl Into<String>) -> Self {
        Self { severity: Severity::Error, message: message.into(), labels: vec![], help: vec![] }
    }

    pub fn warning(message: impl Into<String>) -> Self {
        Self { severity: Severity::Warning, ..Self::error(message) }
    }

    /// Adds `place` with a `label`, which may be empty.
    pub fn at(mut self, place: Place, label: impl Into<String>) -> Self {
        self.labels.push((place, label.into()));
        self
    }

    /// Adds advice.
    pub fn help(mut self, advice: impl Into<String>) -> Self {
        self.help.push(advice.into());
        self
    }

    /// Adds "did you mean" where one of `known` is close to `name`, else with all of them unless
    /// they are too many to read.
    pub fn suggest<'a>(self, name: &str, known: impl IntoIterator<Item = &'a str>) -> Self {
        let known: Vec<&str> = known.into_iter().collect();
        let close = known
            .iter()
            .map(|k| (strsim::damerau_levenshtein(&name.to_lowercase(), &k.to_lowercase()), *k))
            .filter(|(distance, k)| *distance <= 1 + k.len().max(name.len()) / 3)
            .min_by_key(|(distance, _)| *distance);
        match close {
            Some((_, k)) => self.help(format!("did you mean `{k}`?")),
            None if known.is_empty() || known.len() > MAX_KNOWN => self,
            None => self.help(format!("known: {}", known.join(", "))),
        }
    }
}

/// Problems together with the texts that they point into.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Report {
    pub diagnostics: Vec<Diagnostic>,
    /// The text of each file that a place may name.
    pub texts: BTreeMap<String, Arc<str>>,
}

impl Report {
    pub fn has_errors(&self) -> bool {
        self.count(Severity::Error) > 0
    }

    pub fn count(&self, severity: Severity) -> usize {
        self.diagnostics.iter().filter(|d| d.severity == severity).count()
    }

    /// The text of all problems, with escape codes for a terminal if `color`.
    pub fn render(&self, color: bool) -> String {
        let files: Vec<Text> =
            self.texts.iter().map(|(name, text)| Text::new(name, unmarked(text))).collect();
        let ids: BTreeMap<&str, usize> = self.texts.keys().map(String::as_str).zip(0..).collect();
        let config = term::Config { tab_width: 4, ..term::Config::default() };
        let mut plain = String::new();
        let mut colored = codespan_reporting::term::termcolor::Buffer::ansi();
        for diagnostic in &self.diagnostics {
            let mut drawn = draw(diagnostic, &ids, &self.texts);
            let files = Excerpts::of(&files, &mut drawn);
            // The only errors are of a file that is not there, which `draw` leaves out, and of the writer,
            // which is memory.
            if color {
                let _ = term::emit_to_write_style(&mut colored, &config, &files, &drawn);
            } else {
                let _ = term::emit_to_string(&mut plain, &config, &files, &drawn);
            }
        }
        if color { String::from_utf8_lossy(colored.as_slice()).into_owned() } else { plain }
    }
}

/// A report of one problem that is at no place.
impl From<Diagnostic> for Report {
    fn from(problem: Diagnostic) -> Self {
        Self { diagnostics: vec![problem], texts: BTreeMap::new() }
    }
}

impl fmt::Display for Report {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(&self.render(false))
    }
}

/// `text` without a byte-order mark, which is no column of its first line.
fn unmarked(text: &str) -> &str {
    text.strip_prefix('\u{feff}').unwrap_or(text)
}

fn draw(
    diagnostic: &Diagnostic,
    ids: &BTreeMap<&str, usize>,
    texts: &BTreeMap<String, Arc<str>>,
) -> codespan::Diagnostic<usize> {
    let severity = match diagnostic.severity {
        Severity::Warning => codespan::Severity::Warning,
        Severity::Error => codespan::Severity::Error,
    };
    let labels = diagnostic.labels.iter().enumerate().filter_map(|(i, (place, text))| {
        let style = if i == 0 { codespan::LabelStyle::Primary } else { codespan::LabelStyle::Secondary };
        let id = *ids.get(place.file.as_str())?;
        let mark = texts.get(&place.file).map_or(0, |text| text.len() - unmarked(text).len());
        let span = place.span.start.saturating_sub(mark)..place.span.end.saturating_sub(mark);
        Some(codespan::Label::new(style, id, span).with_message(text))
    });
    codespan::Diagnostic::new(severity)
        .with_message(&diagnostic.message)
        .with_labels(labels.collect())
        .with_notes(diagnostic.help.iter().map(|h| format!("help: {h}")).collect())
}
