//! Where in a text an edit happens: what is there is changed, what is not there is added.

use std::collections::BTreeSet;
use std::ops::Range;

use super::siblings::Siblings;
use super::{NewValue, Refusal, TextEdit, change, text};
use crate::scene::{self, Field, Kind, Path, Record, Step, Value};

/// A field that is added stands before the first that comes behind it in `order`.
pub fn set(text: &str, path: &Path, value: &NewValue, order: &[String]) -> Result<TextEdit, Refusal> {
    let root = read(text)?;
    let unfit = |why| Refusal::Unfit { path: path.clone(), why };
    let mut at = &root;
    for (i, step) in path.0.iter().enumerate() {
        let Some(next) = at.step(step) else {
            let words = change::write(value).map_err(unfit)?;
            let words = path.0[i + 1..].iter().rev().try_fold(words, |inner, step| alone(step, &inner));
            let added = words.and_then(|words| add(text, at, step, &words, order));
            return added.ok_or_else(|| Refusal::NotThere(path.clone()));
        };
        at = next;
    }
    change::rewrite(text, at, value).map_err(unfit)
}

/// The group that has nothing but `inner`, to which `step` leads.
fn alone(step: &Step, inner: &str) -> Option<String> {
    match step {
        Step::Field(name) => Some(format!("({name}: {inner})")),
        Step::Key(name) => Some(format!("{{ {}: {inner} }}", text::quote(name))),
        Step::Item(0) => Some(format!("[{inner}]")),
        Step::Item(_) => None,
    }
}

/// `words` as the new value that `step` leads to in `group`; None where such a group has none.
fn add(text: &str, group: &Value, step: &Step, words: &str, order: &[String]) -> Option<TextEdit> {
    let before = place_in(group, step, order);
    let words = match (step, &group.kind) {
        (Step::Field(name), Kind::Record(record)) if record.items.is_empty() => {
            // A name that is none would spoil the text.
            change::parsed(&format!("({name}: 0)")).ok()?;
            format!("{name}: {words}")
        }
        (Step::Key(name), Kind::Map(_)) => format!("{}: {words}", text::quote(name)),
        (Step::Item(index), Kind::List(items)) if *index == items.len() => words.to_owned(),
        _ => return None,
    };
    Some(match Siblings::of(text, group) {
        Some(siblings) => siblings.insert(before.unwrap_or(siblings.len()), &words),
        None => TextEdit::insert(group.span.end, format!("({words})")),
    })
}

/// The first of the fields of `group` that stands behind `step` in `order`.
fn place_in(group: &Value, step: &Step, order: &[String]) -> Option<usize> {
    let (Step::Field(name), Kind::Record(record)) = (step, &group.kind) else { return None };
    let later = &order[1 + order.iter().position(|known| known == name)?..];
    record.fields.iter().position(|field| later.contains(&field.name.text))
}

/// The shortest beginning of `path` that leads nowhere, or all of it.
pub fn first_missing(root: &Value, path: &Path) -> Path {
    let beginnings = (1..=path.0.len()).map(|length| Path(path.0[..length].to_vec()));
    beginnings.into_iter().find(|path| root.at(path).is_none()).unwrap_or_else(|| path.clone())
}

pub fn remove(text: &str, path: &Path) -> Result<TextEdit, Refusal> {
    let root = read(text)?;
    let (siblings, index) = find(text, &root, path)?;
    Ok(siblings.remove(index))
}

pub fn insert(text: &str, list: &Path, index: usize, item: &str) -> Result<TextEdit, Refusal> {
    let root = read(text)?;
    let words = change::write(&NewValue::Code(item.to_owned()));
    let words = words.map_err(|why| Refusal::Unfit { path: list.item(index), why })?;
    match root.at(list) {
        Some(value @ Value { kind: Kind::List(items), .. }) => {
            let siblings = Siblings::of(text, value).ok_or_else(|| Refusal::NotThere(list.clone()))?;
            Ok(siblings.insert(index.min(items.len()), &words))
        }
        Some(_) => Err(Refusal::NotThere(list.clone())),
        None => set(text, list, &NewValue::Code(format!("[{words}]")), &[]),
    }
}

pub fn duplicate(text: &str, path: &Path) -> Result<TextEdit, Refusal> {
    let root = read(text)?;
    let (siblings, index) = find(text, &root, path)?;
    let copied = root.at(path).ok_or_else(|| Refusal::NotThere(path.clone()))?;
    let mut renamed = vec![];
    // A key stands before what it names, so that these come in the order of the text.
    if let Some((group, Step::Key(_))) = path.split()
        && let Some(Value { kind: Kind::Map(entries), .. }) = root.at(&group)
    {
        let keys = entries.iter().map(|entry| entry.name.text.clone()).collect();
        renamed.push((entries[index].name.span.clone(), free_name(&entries[index].name.text, &keys)));
    }
    let mut taken: BTreeSet<String> = object_names(&root).into_iter().map(|(_, name)| name).collect();
    for (span, name) in object_names(copied) {
        let name = free_name(&name, &taken);
        taken.insert(name.clone());
        renamed.push((span, name));
    }
    let span = siblings.span(index);
    let requoted = renamed.into_iter().map(|(at, name)| {
        let quoted = text::requote(&text[at.clone()], &name);
        (at.start - span.start..at.end - span.start, quoted)
    });
    let words = &text[span.clone()];
    let copy = TextEdit::replace_all(words, requoted.collect()).apply(words);
    Ok(siblings.insert(index + 1, &copy))
}

/// `name` with the lowest number behind it that makes it none of `taken`.
fn free_name(name: &str, taken: &BTreeSet<String>) -> String {
    let base = match name.rsplit_once(' ') {
        Some((base, number)) if number.parse::<u32>().is_ok() => base,
        _ => name,
    };
    let mut names = (2..).map(|number| format!("{base} {number}"));
    names.find(|name| !taken.contains(name)).expect("there is always a higher number")
}

/// The names that the author gave to objects in `value`, in the order of the text.
fn object_names(value: &Value) -> Vec<(Range<usize>, String)> {
    match &value.kind {
        Kind::Record(record) => record.fields.iter().flat_map(name_or_names).collect(),
        Kind::Map(entries) => entries.iter().flat_map(|entry| object_names(&entry.value)).collect(),
        Kind::Tuple(items) | Kind::List(items) => items.iter().flat_map(object_names).collect(),
        _ => vec![],
    }
}

fn name_or_names(field: &Field) -> Vec<(Range<usize>, String)> {
    match &field.value.kind {
        Kind::Text(name) if field.name.text == "name" => vec![(field.value.span.clone(), name.clone())],
        _ => object_names(&field.value),
    }
}

pub fn rename(text: &str, path: &Path, name: &str, keep: &[String]) -> Result<TextEdit, Refusal> {
    let root = read(text)?;
    let unfit = |why| Refusal::Unfit { path: path.clone(), why };
    let is_name = change::parsed(name).map_err(unfit)?.kind;
    if !matches!(&is_name, Kind::Record(r) if r.name.as_ref().is_some_and(|n| n.text == name)) {
        return Err(unfit(format!("`{name}` is not a valid name")));
    }
    let value = root.at(path).ok_or_else(|| Refusal::NotThere(path.clone()))?;
    let Kind::Record(Record { name: Some(old), fields, .. }) = &value.kind else {
        return Err(Refusal::NotThere(path.clone()));
    };
    let mut new = TextEdit { span: old.span.clone(), with: name.to_owned() }.apply(text);
    // From the last to the first, so that the places of the others hold.
    for field in fields.iter().rev().filter(|field| !keep.contains(&field.name.text)) {
        new = remove(&new, &path.field(&field.name.text))?.apply(&new);
    }
    Ok(TextEdit::between(text, &new))
}

/// The brackets in which the value at `path` stands, and which of the things in them it is.
fn find<'t>(text: &'t str, root: &Value, path: &Path) -> Result<(Siblings<'t>, usize), Refusal> {
    let place = || {
        let (group, step) = path.split()?;
        let group = root.at(&group)?;
        let index = match (step, &group.kind) {
            (Step::Field(name), Kind::Record(Record { fields, .. }))
            | (Step::Key(name), Kind::Map(fields)) => fields.iter().position(|f| f.name.text == *name)?,
            (Step::Item(index), Kind::List(items)) if *index < items.len() => *index,
            _ => return None,
        };
        Some((Siblings::of(text, group)?, index))
    };
    place().ok_or_else(|| Refusal::NotThere(path.clone()))
}

/// The scene that `text` is.
pub fn read(text: &str) -> Result<Value, Refusal> {
    scene::parse("", text).map_err(Refusal::Syntax)
}
