//! A value in one line, as its author wrote its numbers, without comments.

use crate::scene::{Field, Kind, Record, Value};

/// The words of `value`, which is a part of `text`.
pub fn words(value: &Value, text: &str) -> String {
    let list = |items: &[Value]| items.iter().map(|item| words(item, text)).collect::<Vec<_>>().join(", ");
    match &value.kind {
        Kind::None => "None".into(),
        Kind::Bool(flag) => flag.to_string(),
        Kind::Number(_) => text[value.span.clone()].to_owned(),
        Kind::Text(string) => quoted(string),
        Kind::Tuple(items) => format!("({})", list(items)),
        Kind::List(items) => format!("[{}]", list(items)),
        Kind::Map(entries) => {
            let entry = |e: &Field| format!("{}: {}", quoted(&e.name.text), words(&e.value, text));
            format!("{{{}}}", entries.iter().map(entry).collect::<Vec<_>>().join(", "))
        }
        Kind::Record(Record { name, fields, items }) => {
            let field = |f: &Field| format!("{}: {}", f.name.text, words(&f.value, text));
            let fields = fields.iter().map(field).collect::<Vec<_>>().join(", ");
            match name {
                // A name by itself ends where its value ends.
                Some(name) if name.span.end == value.span.end => name.text.clone(),
                Some(name) => format!("{}({fields}{})", name.text, list(items)),
                None => format!("({fields})"),
            }
        }
    }
}

/// A string with its quotes, in one line.
pub fn quoted(text: &str) -> String {
    format!("{text:?}")
}
