//! RON text to a tree with places, by ron2.

use ron2::ast::{self, Expr};
use ron2::error::ErrorKind;

use super::brackets::{excess, marks};
use super::numbers::{number, readable};
use super::{Field, Kind, Name, Record, Value};
use crate::diagnostic::{Diagnostic, Place};

/// The value of a whole file; `file` is its name in messages.
///
/// # Errors
/// All syntax errors of the text, in its order.
pub fn parse(file: &str, text: &str) -> Result<Value, Vec<Diagnostic>> {
    if let Some(excess) = excess(text) {
        let place = Place { file: file.into(), span: excess.span };
        return Err(vec![Diagnostic::error(excess.message).at(place, "")]);
    }
    let mut reader = Reader { file, text, problems: vec![] };
    let readable = readable(text);
    let (document, errors) = ast::parse_document_lossy(&readable);
    for error in errors {
        reader.syntax(&error);
        // Beyond the depth limit the parser loses its place, and all that it says after is wrong.
        if matches!(error.kind(), ErrorKind::ExceededRecursionLimit) {
            return Err(reader.problems);
        }
    }
    let value = document.value.as_ref().map(|expr| reader.value(expr));
    match value {
        Some(value) if reader.problems.is_empty() => Ok(value),
        Some(_) => Err(reader.problems),
        None if reader.problems.is_empty() => {
            let end = text.trim_end().len();
            Err(vec![
                Diagnostic::error("the file contains no scene")
                    .at(Place { file: file.into(), span: end..end }, "")
                    .help("write at least `(objects: [Sphere()])`"),
            ])
        }
        None => Err(reader.problems),
    }
}

struct Reader<'a> {
    file: &'a str,
    text: &'a str,
    problems: Vec<Diagnostic>,
}

impl Reader<'_> {
    fn syntax(&mut self, error: &ron2::Error) {
        let span = range(error.span());
        // One mistake often upsets the parser at several places in a row; only the first says something.
        if self.problems.iter().any(|p| p.labels.iter().any(|(at, _)| at.span.end >= span.start)) {
            return;
        }
        let message = match error.kind() {
            ErrorKind::Eof => "the text ends before the end of the scene".to_owned(),
            ErrorKind::TrailingCharacters => "there is text after the end of the scene".to_owned(),
            ErrorKind::ExceededRecursionLimit => "values are nested too deeply".to_owned(),
            kind => {
                let said = kind.to_string();
                let mut letters = said.chars();
                letters.next().map_or(String::new(), |c| c.to_lowercase().chain(letters).collect())
            }
        };
        let mut diagnostic = Diagnostic::error(message).at(self.place(span.clone()), "");
        if let Some(advice) = self.advice(error.kind(), span.start) {
            diagnostic = diagnostic.help(advice);
        }
        self.problems.push(diagnostic);
    }

    fn advice(&self, kind: &ErrorKind, at: usize) -> Option<String> {
        if self.text.get(at..).is_some_and(|rest| rest.starts_with('{')) {
            return Some("fields are written in parentheses: `(name: value)`".into());
        }
        let is_first = self.problems.is_empty();
        if let Some(open) = unclosed(self.text).filter(|_| is_first) {
            return Some(open);
        }
        match kind {
            ErrorKind::Expected { expected, .. } if expected.contains("comma") || expected.contains(',') => {
                Some("is a comma missing before this?".into())
            }
            ErrorKind::Expected { expected, .. } if expected.contains("closing") && is_first => {
                Some("is a `:` or a comma missing before this?".into())
            }
            _ => None,
        }
    }

    fn place(&self, span: std::ops::Range<usize>) -> Place {
        let end = span.end.min(self.text.len());
        Place { file: self.file.into(), span: span.start.min(end)..end }
    }

    fn value(&mut self, expr: &Expr<'_>) -> Value {
        let kind = match expr {
            Expr::Unit(_) => Kind::Record(Record::default()),
            Expr::Bool(b) => Kind::Bool(b.value),
            Expr::Number(n) => {
                let place = self.place(range(&n.span));
                let written = &self.text[place.span.clone()];
                Kind::Number(number(written).filter(|x| x.is_finite()).unwrap_or_else(|| {
                    let message = format!("`{written}` is not a finite number");
                    self.problems.push(Diagnostic::error(message).at(place, ""));
                    0.0
                }))
            }
            Expr::String(s) => Kind::Text(s.value.clone()),
            Expr::Option(option) => match &option.value {
                Some(inner) => {
                    return Value { whole: range(&option.span), ..self.value(&inner.expr) };
                }
                None => Kind::None,
            },
            Expr::Seq(seq) => Kind::List(seq.items.iter().map(|i| self.value(&i.expr)).collect()),
            Expr::Tuple(tuple) => Kind::Tuple(tuple.elements.iter().map(|e| self.value(&e.expr)).collect()),
            Expr::Map(map) => Kind::Map(map.entries.iter().filter_map(|e| self.entry(e)).collect()),
            Expr::AnonStruct(record) => {
                Kind::Record(Record { fields: self.fields(&record.fields), ..Record::default() })
            }
            Expr::Struct(record) => Kind::Record(self.record(record)),
            Expr::Char(_) | Expr::Byte(_) | Expr::Bytes(_) => {
                let message = "characters and bytes are not allowed here; write a \"string\"";
                self.problems.push(Diagnostic::error(message).at(self.place(range(expr.span())), ""));
                Kind::None
            }
            // Already reported by the parser.
            Expr::Error(_) => Kind::None,
        };
        let span = range(expr.span());
        Value { whole: span.clone(), span, kind }
    }

    fn record(&mut self, record: &ast::StructExpr<'_>) -> Record {
        let name = Some(Name { span: range(&record.name.span), text: record.name.name.to_string() });
        match &record.body {
            None => Record { name, ..Record::default() },
            Some(ast::StructBody::Tuple(body)) => {
                let items = body.elements.iter().map(|e| self.value(&e.expr)).collect();
                Record { name, items, ..Record::default() }
            }
            Some(ast::StructBody::Fields(body)) => {
                Record { name, fields: self.fields(&body.fields), ..Record::default() }
            }
        }
    }

    fn fields(&mut self, fields: &[ast::StructField<'_>]) -> Vec<Field> {
        let read = |f: &ast::StructField<'_>| Field {
            name: Name { span: range(&f.name.span), text: f.name.name.to_string() },
            value: self.value(&f.value),
        };
        fields.iter().map(read).collect()
    }

    fn entry(&mut self, entry: &ast::MapEntry<'_>) -> Option<Field> {
        let value = self.value(&entry.value);
        let span = range(entry.key.span());
        if let Expr::String(key) = &entry.key {
            return Some(Field { name: Name { span, text: key.value.clone() }, value });
        }
        let message = "names in a map are written as strings: `\"name\": …`";
        self.problems.push(Diagnostic::error(message).at(self.place(span), ""));
        None
    }
}

fn range(span: &ron2::error::Span) -> std::ops::Range<usize> {
    span.start_offset..span.end_offset.max(span.start_offset)
}

/// The first bracket that another kind of bracket closes, or the last that nothing closes.
fn unclosed(text: &str) -> Option<String> {
    let mut open = vec![];
    for (at, c) in marks(text) {
        match (c, open.last()) {
            ('(' | '[' | '{', _) => open.push((at, c)),
            (')', Some((_, '('))) | (']', Some((_, '['))) | ('}', Some((_, '{'))) => drop(open.pop()),
            (',', _) => {}
            _ => break,
        }
    }
    let (at, bracket) = open.pop()?;
    let line = text[..at].matches('\n').count() + 1;
    Some(format!("`{bracket}` of line {line} is not closed"))
}
