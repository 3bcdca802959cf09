//! Edits that were made on one text, made again on another by path, but not where both changed a value.

use super::Edit;
use super::place::read;
use crate::scene::{Kind, Path, Step, Value, found_again};

/// A value that was changed here and in the file.
#[derive(Clone, Debug, PartialEq)]
pub struct Conflict {
    /// What was done here.
    pub mine: Edit,
    /// The same as an edit of the file's text, which it overrules; None where that has no place for it.
    pub again: Option<Edit>,
    /// The words of the file; None where the value, or what it was a part of, is no longer there.
    pub theirs: Option<String>,
    /// The words from which both began.
    pub before: Option<String>,
}

/// What became of edits.
#[derive(Debug, Default)]
pub struct Merged {
    /// Those that could be made, one after the other, on the other text.
    pub edits: Vec<Edit>,
    pub conflicts: Vec<Conflict>,
}

/// Makes `edits`, which were made on `base`, on `theirs`, which is RON.
pub fn replay(base: &str, edits: &[Edit], theirs: &str) -> Merged {
    let (mut mine, mut other) = (base.to_owned(), theirs.to_owned());
    let mut merged = Merged::default();
    for edit in edits {
        let path = path_of(edit);
        let (Ok(root), Ok(other_root)) = (read(&mine), read(&other)) else {
            // The file was broken when this was done, and so nothing can be compared.
            let again = path.0.is_empty().then(|| edit.clone());
            merged.conflicts.push(Conflict { mine: edit.clone(), again, theirs: None, before: None });
            continue;
        };
        let words = |root: &Value, text: &str, path: &Path| {
            root.at(path).map(|value| text[value.span.clone()].to_owned())
        };
        let translated = translated(edit, &root, &other_root);
        let is_free = |new: &Edit| match (root.at(path), other_root.at(path_of(new))) {
            (Some(a), Some(b)) => is_untouched(edit, a, b),
            (None, None) => true,
            _ => matches!(edit, Edit::Insert { .. }),
        };
        let change = translated.as_ref().and_then(|new| Some((new, new.on(&other).ok()?)));
        match change {
            // Both did the same.
            Some((_, change)) if change.is_empty() => {}
            Some((new, change)) if is_free(new) => {
                other = change.apply(&other);
                merged.edits.push(new.clone());
            }
            _ if is_gone(edit, translated.as_ref(), &other_root) => {}
            _ => {
                let theirs = translated.as_ref().and_then(|new| words(&other_root, &other, path_of(new)));
                // What is set twice conflicts once, with the value that it has in the end.
                let earlier = merged.conflicts.iter().position(|known| path_of(&known.mine) == path);
                let before = match earlier.map(|i| merged.conflicts.remove(i)) {
                    Some(earlier) => earlier.before,
                    None => words(&root, &mine, path),
                };
                let mine = edit.clone();
                merged.conflicts.push(Conflict { mine, again: translated, theirs, before });
            }
        }
        if let Ok(change) = edit.on(&mine) {
            mine = change.apply(&mine);
        }
    }
    merged
}

/// Whether what `edit` changes is as it was, so that no one else's change is lost.
fn is_untouched(edit: &Edit, mine: &Value, theirs: &Value) -> bool {
    let name = |value: &Value| match &value.kind {
        Kind::Record(record) => record.name.as_ref().map(|name| name.text.clone()),
        _ => None,
    };
    match edit {
        Edit::Insert { .. } | Edit::Duplicate { .. } => true,
        Edit::Rename { .. } => name(mine) == name(theirs),
        Edit::Set { .. } | Edit::Add { .. } | Edit::Remove { .. } => mine.says_the_same_as(theirs),
    }
}

/// Whether `edit` takes out what the others took out as well.
fn is_gone(edit: &Edit, translated: Option<&Edit>, other: &Value) -> bool {
    let is_there = |new: &Edit| other.at(path_of(new)).is_some();
    matches!(edit, Edit::Remove { .. }) && !translated.is_some_and(is_there)
}

fn path_of(edit: &Edit) -> &Path {
    match edit {
        Edit::Set { path, .. }
        | Edit::Add { path, .. }
        | Edit::Remove { path }
        | Edit::Duplicate { path }
        | Edit::Rename { path, .. } => path,
        Edit::Insert { list, .. } => list,
    }
}

/// The same edit of `other`; None where it has no such place.
fn translated(edit: &Edit, root: &Value, other: &Value) -> Option<Edit> {
    let mut new = edit.clone();
    match &mut new {
        Edit::Set { path, .. }
        | Edit::Add { path, .. }
        | Edit::Remove { path }
        | Edit::Duplicate { path }
        | Edit::Rename { path, .. } => *path = counterpart(path, root, other)?,
        Edit::Insert { list, index, .. } => {
            let before = index.checked_sub(1).map(|before| list.item(before));
            *list = counterpart(list, root, other)?;
            let behind = before.and_then(|before| counterpart(&before, root, other));
            // Without its neighbour it goes to the same place, or to the end.
            if let Some(Step::Item(before)) = behind.as_ref().and_then(|path| path.0.last()) {
                *index = before + 1;
            }
        }
    }
    Some(new)
}

/// Where the item or entry is in the scene `after` that is at `path` in the scene `before`; None where it was
/// taken out. Fields of a scene keep their path, written or not.
pub fn found_at(path: &Path, before: &str, after: &str) -> Option<Path> {
    let (Ok(root), Ok(other)) = (read(before), read(after)) else { return Some(path.clone()) };
    let is_field = matches!(path.0.last(), None | Some(Step::Field(_)));
    counterpart(path, &root, &other).filter(|new| is_field || other.at(new).is_some())
}

/// Where in `other` the value is that is at `path` in `root`; None where it was taken out.
fn counterpart(path: &Path, root: &Value, other: &Value) -> Option<Path> {
    let (mut mine, mut theirs) = (Some(root), Some(other));
    let mut steps = vec![];
    for step in &path.0 {
        let new = match (step, mine.map(|v| &v.kind), theirs.map(|v| &v.kind)) {
            (Step::Item(index), Some(Kind::List(a)), Some(Kind::List(b))) => {
                Step::Item(if *index < a.len() { aligned(a, b)[*index]? } else { b.len() })
            }
            _ => step.clone(),
        };
        mine = mine.and_then(|value| value.step(step));
        theirs = theirs.and_then(|value| value.step(&new));
        steps.push(new);
    }
    Some(Path(steps))
}

/// For each of `mine`, which of `theirs` it is; also what stands alone between the same neighbours.
fn aligned(mine: &[Value], theirs: &[Value]) -> Vec<Option<usize>> {
    let mut found = found_again(mine, theirs);
    // Runs of what is left, between the same neighbours: as many on both sides are the same ones, changed.
    let mut i = 0;
    while i < mine.len() {
        let run = (i..mine.len()).take_while(|k| found[*k].is_none()).count();
        if run > 0 {
            let start = i.checked_sub(1).map_or(Some(0), |before| found[before].map(|j| j + 1));
            let end = found.get(i + run).copied().map_or(Some(theirs.len()), |next| next);
            if let (Some(start), Some(end)) = (start, end)
                && start.checked_add(run) == Some(end)
                && (start..end).all(|j| !found.contains(&Some(j)))
            {
                (0..run).for_each(|k| found[i + k] = Some(start + k));
            }
        }
        i += run.max(1);
    }
    found
}
