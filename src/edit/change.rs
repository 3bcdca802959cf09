//! A new value in place of an old one, in its style, or by itself.

use std::ops::Range;

use glam::Vec3;

use super::{NewValue, TextEdit, color, number, text};
use crate::library::parse_color;
use crate::scene::{self, Kind, Record, Value};

/// `value` as RON text, where nothing was before.
///
/// # Errors
/// Why it cannot be written.
pub fn write(value: &NewValue) -> Result<String, String> {
    check(value)?;
    Ok(match value {
        NewValue::Number(x) => number::write(*x, false),
        NewValue::Vector(numbers) => {
            let numbers: Vec<String> = numbers.iter().map(|x| number::write(*x, false)).collect();
            format!("({})", numbers.join(", "))
        }
        NewValue::Color(color) => color::write(*color),
        NewValue::Flag(flag) => flag.to_string(),
        NewValue::Text(words) => text::quote(words),
        NewValue::Word(code) | NewValue::Code(code) => {
            let value = parsed(code)?;
            code[value.whole].to_owned()
        }
    })
}

/// What takes the place of parts of `old` in `text`, so that it says `value`; nothing where it does already.
///
/// # Errors
/// Why it cannot be written.
pub fn rewrite(text: &str, old: &Value, value: &NewValue) -> Result<TextEdit, String> {
    check(value)?;
    let parts = match (value, &old.kind) {
        (NewValue::Number(x), Kind::Number(_)) => number_parts(text, old, *x),
        (NewValue::Vector(numbers), Kind::Tuple(items)) if are_numbers(items, numbers.len()) => {
            items.iter().zip(numbers).flat_map(|(item, x)| number_parts(text, item, *x)).collect()
        }
        (NewValue::Color(color), Kind::Tuple(items)) if are_numbers(items, 3) => {
            let channels = items.iter().zip(color.to_array());
            channels.flat_map(|(item, x)| number_parts(text, item, x)).collect()
        }
        (NewValue::Color(color), Kind::Number(was)) => match color.to_array() {
            [grey, g, b] if grey == g && grey == b => number_parts(text, old, grey),
            _ if Vec3::splat(*was as f32) == *color => vec![],
            _ => vec![(old.span.clone(), color::write(*color))],
        },
        (NewValue::Color(color), Kind::Text(was)) => match parse_color(was) {
            Some(same) if same == *color => vec![],
            _ => vec![(old.span.clone(), color::rewrite(&text[old.span.clone()], was, *color))],
        },
        (NewValue::Text(words), Kind::Text(was)) if words == was => vec![],
        (NewValue::Text(words), Kind::Text(_)) => {
            vec![(old.span.clone(), text::requote(&text[old.span.clone()], words))]
        }
        (NewValue::Word(word), Kind::Text(was)) => match was.eq_ignore_ascii_case(word) {
            true => vec![],
            false => vec![(old.span.clone(), text::requote(&text[old.span.clone()], &cased(word, was)))],
        },
        (NewValue::Flag(_) | NewValue::Word(_) | NewValue::Code(_), _) => {
            let new = write(value)?;
            let said = parsed(&new)?;
            match is_the_same_choice(&said, old) && matches!(value, NewValue::Word(_))
                || said.says_the_same_as(old)
            {
                true => vec![],
                // `Some(None)` would be odd.
                false if said.kind == Kind::None => vec![(old.whole.clone(), new)],
                false => vec![(old.span.clone(), new)],
            }
        }
        _ => vec![(old.span.clone(), write(value)?)],
    };
    Ok(TextEdit::replace_all(text, parts))
}

/// `word` with a small first letter where `was` has one, as strings for choices do.
fn cased(word: &str, was: &str) -> String {
    if was.starts_with(|c: char| c.is_lowercase()) { word.to_lowercase() } else { word.to_owned() }
}

/// Whether both are choices by the same name; what they carry is set by itself.
fn is_the_same_choice(new: &Value, old: &Value) -> bool {
    let name = |value: &Value| match &value.kind {
        Kind::Record(Record { name: Some(name), fields, .. }) if fields.is_empty() => Some(name.text.clone()),
        _ => None,
    };
    name(new).is_some_and(|n| Some(n) == name(old))
}

fn number_parts(text: &str, old: &Value, x: f32) -> Vec<(Range<usize>, String)> {
    match old.kind {
        Kind::Number(was) if was as f32 == x => vec![],
        _ => vec![(old.span.clone(), number::rewrite(&text[old.span.clone()], x))],
    }
}

fn are_numbers(items: &[Value], count: usize) -> bool {
    items.len() == count && items.iter().all(|item| matches!(item.kind, Kind::Number(_)))
}

fn check(value: &NewValue) -> Result<(), String> {
    let is_finite = match value {
        NewValue::Number(x) => x.is_finite(),
        NewValue::Vector(numbers) => numbers.iter().all(|x| x.is_finite()),
        NewValue::Color(color) => color.is_finite(),
        _ => true,
    };
    if is_finite { Ok(()) } else { Err("it is not a finite number".into()) }
}

/// RON text as a value.
///
/// # Errors
/// Why it is none.
pub fn parsed(code: &str) -> Result<Value, String> {
    scene::parse("", code).map_err(|problems| match problems.first() {
        Some(problem) => format!("`{code}` is no RON: {}", problem.message),
        None => format!("`{code}` is no RON"),
    })
}
