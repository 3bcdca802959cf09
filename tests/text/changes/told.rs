//! What a change that is told stands for in the trees of both scenes.

use std::cmp::Reverse;

use raytoy::edit::Edit;
use raytoy::scene::{Change, ChangeKind, Kind, Path, Record, Side, Step, Value};

use crate::edits::{self, Random, at_mut};

/// No scene has a field twice, but RON may.
pub fn doubles_a_field(edit: &Edit) -> bool {
    matches!(edit, Edit::Duplicate { path } if matches!(path.0.last(), Some(Step::Field(_))))
}

/// Whether a change at `told` is one of what is at `path`: there, inside, or a value around it that is told
/// as one: a vector, or `Gamma(2.0)`.
pub fn is_told_at(root: &Value, told: &Path, path: &Path) -> bool {
    let is_inside = told.0.starts_with(&path.0);
    let is_around = path.split().is_some_and(|(group, _)| group == *told)
        && root.at(told).is_some_and(|group| match &group.kind {
            Kind::Tuple(_) => true,
            Kind::Record(record) => !record.items.is_empty(),
            _ => false,
        });
    is_inside || is_around
}

pub fn is_told_whole(root: &Value, found: &[Change], path: &Path) -> bool {
    let [Change { kind: ChangeKind::Changed, old: Some(side), .. }] = found else { return false };
    side.path != *path && is_told_at(root, &side.path, path)
}

/// Whether `side` is what is at `path`, or one of its list that says the same, or is told whole around it.
pub fn is_its_like(root: &Value, side: &Option<Side>, path: &Path) -> bool {
    let Some(side) = side else { return false };
    let same = match (root.at(&side.path), root.at(path)) {
        (Some(a), Some(b)) => a.says_the_same_as(b),
        _ => false,
    };
    let parent = |path: &Path| path.split().map(|(parent, _)| parent);
    is_told_at(root, &side.path, path) || same && parent(&side.path) == parent(path)
}

/// The shortest beginning of `path` that leads nowhere, if there is one.
pub fn first_missing(root: &Value, path: &Path) -> Option<Path> {
    let mut beginnings = (1..=path.0.len()).map(|n| Path(path.0[..n].to_vec()));
    beginnings.find(|beginning| root.at(beginning).is_none())
}

/// `text` with an item of one of its lists taken elsewhere in it.
pub fn with_an_item_moved(random: &mut Random, root: &Value, text: &str) -> String {
    let is_item = |path: &Path| {
        let list = path.split().and_then(|(list, _)| root.at(&list));
        list.is_some_and(|list| matches!(&list.kind, Kind::List(items) if items.len() > 1))
    };
    let items: Vec<Path> = edits::paths(root).into_iter().filter(is_item).collect();
    let Some(path) = items.get(random.below(items.len())).cloned() else { return text.to_owned() };
    let item = text[root.at(&path).expect("it was found there").whole.clone()].to_owned();
    let removed = Edit::Remove { path: path.clone() }.on(text).expect("lists let go of items").apply(text);
    let (list, _) = path.split().expect("it is in a list");
    let insert = Edit::Insert { list, index: random.below(8), item };
    insert.on(&removed).expect("lists take items").apply(&removed)
}

/// `text` with another `Name` on one of its values.
pub fn with_another_name(random: &mut Random, root: &Value, text: &str) -> String {
    let fields = |path: &Path| match &root.at(path)?.kind {
        Kind::Record(Record { name: Some(_), fields, .. }) => Some(fields),
        _ => None,
    };
    let named: Vec<Path> = edits::paths(root).into_iter().filter(|path| fields(path).is_some()).collect();
    let Some(path) = named.get(random.below(named.len())).cloned() else { return text.to_owned() };
    let keep = fields(&path).expect("it has a name").iter().map(|field| field.name.text.clone()).collect();
    let edit = Edit::Rename { path, name: "Another".into(), keep };
    edit.on(text).expect("what has a name takes another").apply(text)
}

/// `root` without all that `changes` name in it: as the old scene (0) or as the new one (1).
pub fn erased(root: &Value, changes: &[Change], side: usize) -> Value {
    let mut root = root.clone();
    let mut named: Vec<(&Side, ChangeKind)> = changes
        .iter()
        .filter_map(|change| Some(([&change.old, &change.new][side].as_ref()?, change.kind)))
        .collect();
    // From the end and from the inside, so that all paths hold until they are used.
    named.sort_by_key(|(side, kind)| (Reverse(&side.path), *kind == ChangeKind::Moved));
    for (Side { path, words, .. }, kind) in named {
        let is_key = words.starts_with('"');
        match kind {
            ChangeKind::Changed => at_mut(&mut root, path).expect("it is there").kind = Kind::None,
            ChangeKind::Renamed if !is_key => {
                let value = at_mut(&mut root, path).expect("it is there");
                let Kind::Record(Record { name, .. }) = &mut value.kind else { panic!("{path} has no name") };
                *name = None;
            }
            _ => root = edits::without(&root, path),
        }
    }
    root
}

/// `value` with all fields in the order of their names.
pub fn sorted(value: &Value) -> Value {
    let mut value = value.clone();
    match &mut value.kind {
        Kind::Record(Record { fields, items, .. }) => {
            fields.sort_by(|a, b| a.name.text.cmp(&b.name.text));
            fields.iter_mut().for_each(|field| field.value = sorted(&field.value));
            items.iter_mut().for_each(|item| *item = sorted(item));
        }
        Kind::Map(fields) => {
            fields.sort_by(|a, b| a.name.text.cmp(&b.name.text));
            fields.iter_mut().for_each(|field| field.value = sorted(&field.value));
        }
        Kind::Tuple(items) | Kind::List(items) => items.iter_mut().for_each(|item| *item = sorted(item)),
        _ => {}
    }
    value
}
