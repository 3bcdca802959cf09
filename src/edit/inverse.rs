//! What takes an edit back, by path: for texts that have changed elsewhere meanwhile.

use super::place::{first_missing, read};
use super::{Edit, NewValue, Refusal};
use crate::scene::{Kind, Path, Step, Value};

/// What takes `edit` back, which made `after` of `before`. Comments that it took with it do not come back.
///
/// # Errors
/// Where `edit` cannot be made on `before`.
pub fn inverse(edit: &Edit, before: &str, after: &str) -> Result<Edit, Refusal> {
    let root = read(before)?;
    let words = |path: &Path| root.at(path).map(|value| before[value.span.clone()].to_owned());
    let written = |path: &Path| words(path).ok_or_else(|| Refusal::NotThere(path.clone()));
    let set = |path: &Path| {
        written(path).map(|words| Edit::Set { path: path.clone(), value: NewValue::Code(words) })
    };
    match edit {
        Edit::Set { path, .. } | Edit::Add { path, .. } if root.at(path).is_none() => {
            Ok(Edit::Remove { path: first_missing(&root, path) })
        }
        Edit::Set { path, .. } | Edit::Add { path, .. } | Edit::Rename { path, .. } => set(path),
        Edit::Remove { path } => match path.split() {
            Some((list, Step::Item(index))) => Ok(Edit::Insert { list, index: *index, item: written(path)? }),
            _ => set(path),
        },
        Edit::Insert { list, index, .. } => match root.at(list) {
            Some(Value { kind: Kind::List(items), .. }) => {
                Ok(Edit::Remove { path: list.item((*index).min(items.len())) })
            }
            _ => Ok(Edit::Remove { path: first_missing(&root, list) }),
        },
        Edit::Duplicate { path } => {
            let copy = copy_of(path, after);
            Ok(Edit::Remove { path: copy.ok_or_else(|| Refusal::NotThere(path.clone()))? })
        }
    }
}

/// Where the copy is, in the text `after`, that was made of what is at `path`.
pub fn copy_of(path: &Path, after: &str) -> Option<Path> {
    let root = read(after).ok()?;
    let (group, step) = path.split()?;
    let around = root.at(&group)?;
    match (step, &around.kind) {
        (Step::Item(index), _) => Some(group.item(index + 1)),
        (Step::Key(key), Kind::Map(entries)) => {
            let index = entries.iter().position(|entry| entry.name.text == *key)?;
            Some(group.key(&entries.get(index + 1)?.name.text))
        }
        _ => None,
    }
}
