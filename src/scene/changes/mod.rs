//! What two scenes say differently, value by value; comments, blanks and the order of fields do not matter.
//!
//! In: two parsed scenes and their texts. Out: [`Change`]s. Items of lists are found again by their names,
//! else by what they are and their order.

mod pairs;
mod words;

use self::pairs::{in_order, pairs};
use self::words::{quoted, words};
use super::{Field, Kind, Name, Path, Record, Step, Value};

/// A value that is not as it was.
#[derive(Clone, Debug, PartialEq)]
pub struct Change {
    /// Where, by the names of things: `objects["ball"].radius`. A value without a name has its index, the
    /// old one where there was one.
    pub path: Path,
    pub kind: ChangeKind,
    /// None where it is new.
    pub old: Option<Side>,
    /// None where it is gone.
    pub new: Option<Side>,
}

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum ChangeKind {
    New,
    Gone,
    /// It says something else.
    Changed,
    /// Its `Name(…)`, or the key of a map that leads to it, is another; fields are reported one by one.
    Renamed,
    /// It stands elsewhere in its list.
    Moved,
}

/// A value in one of the two scenes.
#[derive(Clone, Debug, PartialEq)]
pub struct Side {
    /// By indices, as [`Value::at`] takes it.
    pub path: Path,
    /// Where it begins, from 1.
    pub line: usize,
    /// What it says, in one line; of what is renamed the name alone.
    pub words: String,
}

/// All changes from `old` to `new`, each a scene and its text, in the order of the old one, with what is new
/// behind what it was put to.
pub fn changes(old: (&Value, &str), new: (&Value, &str)) -> Vec<Change> {
    let mut walk = Walk { texts: [Text::new(old.1), Text::new(new.1)], found: vec![] };
    walk.compare(&At::default(), old.0, new.0);
    walk.found
}

struct Walk<'a> {
    texts: [Text<'a>; 2],
    found: Vec<Change>,
}

/// The address of a value: as people call it, and in each of the scenes.
#[derive(Clone, Default)]
struct At {
    shown: Path,
    old: Path,
    new: Path,
}

impl At {
    fn field(&self, name: &str) -> Self {
        Self { shown: self.shown.field(name), old: self.old.field(name), new: self.new.field(name) }
    }

    fn key(&self, old: &str, new: &str) -> Self {
        Self { shown: self.shown.key(old), old: self.old.key(old), new: self.new.key(new) }
    }

    /// The item at `old` in one list and at `new` in the other, called by the name of `value` if it has one.
    fn item(&self, old: usize, new: usize, value: &Value) -> Self {
        let step = value.given_name().map_or(Step::Item(old), |name| Step::Key(name.to_owned()));
        let shown = Path(self.shown.0.iter().cloned().chain([step]).collect());
        Self { shown, old: self.old.item(old), new: self.new.item(new) }
    }
}

impl Walk<'_> {
    fn compare(&mut self, at: &At, old: &Value, new: &Value) {
        if old.says_the_same_as(new) {
            return;
        }
        match (&old.kind, &new.kind) {
            (Kind::Record(a), Kind::Record(b)) if is_one_changed(a, b) => self.records(at, a, b),
            (Kind::Map(a), Kind::Map(b)) => self.maps(at, a, b),
            (Kind::List(a), Kind::List(b)) => self.lists(at, a, b),
            // A vector is one thing to a person, the stop of a ramp is several.
            (Kind::Tuple(a), Kind::Tuple(b)) if a.len() == b.len() && !(is_vector(a) && is_vector(b)) => {
                for (i, (old, new)) in a.iter().zip(b).enumerate() {
                    self.compare(&at.item(i, i, old), old, new);
                }
            }
            _ => self.tell(at, ChangeKind::Changed, Some(old), Some(new)),
        }
    }

    fn records(&mut self, at: &At, old: &Record, new: &Record) {
        if let (Some(before), Some(now)) = (&old.name, &new.name)
            && before.text != now.text
        {
            self.renamed(at, [before, now], [before.text.clone(), now.text.clone()]);
        }
        for field in &old.fields {
            let (at, other) = (at.field(&field.name.text), named(&new.fields, &field.name.text));
            match other {
                Some(other) => self.compare(&at, &field.value, &other.value),
                None => self.tell(&at, ChangeKind::Gone, Some(&field.value), None),
            }
        }
        for field in new.fields.iter().filter(|field| named(&old.fields, &field.name.text).is_none()) {
            self.tell(&at.field(&field.name.text), ChangeKind::New, None, Some(&field.value));
        }
        for (i, (old, new)) in old.items.iter().zip(&new.items).enumerate() {
            self.compare(&at.item(i, i, old), old, new);
        }
    }

    fn maps(&mut self, at: &At, old: &[Field], new: &[Field]) {
        let mut added: Vec<&Field> =
            new.iter().filter(|entry| named(old, &entry.name.text).is_none()).collect();
        for entry in old {
            let key = &entry.name.text;
            let renamed = || added.iter().position(|other| other.value.says_the_same_as(&entry.value));
            if let Some(other) = named(new, key) {
                self.compare(&at.key(key, key), &entry.value, &other.value);
            } else if let Some(index) = renamed() {
                let other = added.remove(index);
                let words = [&entry.name.text, &other.name.text].map(|key| quoted(key));
                self.renamed(&at.key(key, &other.name.text), [&entry.name, &other.name], words);
            } else {
                self.tell(&at.key(key, key), ChangeKind::Gone, Some(&entry.value), None);
            }
        }
        for entry in added {
            let key = &entry.name.text;
            self.tell(&at.key(key, key), ChangeKind::New, None, Some(&entry.value));
        }
    }

    fn lists(&mut self, at: &At, old: &[Value], new: &[Value]) {
        let found = pairs(old, new);
        let stays = in_order(&found, new.len());
        for (i, item) in old.iter().enumerate() {
            let Some(j) = found[i] else {
                self.tell(&at.item(i, i, item), ChangeKind::Gone, Some(item), None);
                continue;
            };
            let at = at.item(i, j, item);
            if !stays[i] {
                self.tell(&at, ChangeKind::Moved, Some(item), Some(&new[j]));
            }
            self.compare(&at, item, &new[j]);
        }
        for (j, item) in new.iter().enumerate().filter(|(j, _)| !found.contains(&Some(*j))) {
            self.tell(&at.item(j, j, item), ChangeKind::New, None, Some(item));
        }
    }

    fn tell(&mut self, at: &At, kind: ChangeKind, old: Option<&Value>, new: Option<&Value>) {
        let [before, now] = &self.texts;
        let side = |text: &Text<'_>, path: &Path, value: &Value| Side {
            path: path.clone(),
            line: text.line(value.whole.start),
            words: words(value, text.text),
        };
        let old = old.map(|value| side(before, &at.old, value));
        let new = new.map(|value| side(now, &at.new, value));
        self.found.push(Change { path: at.shown.clone(), kind, old, new });
    }

    fn renamed(&mut self, at: &At, names: [&Name; 2], words: [String; 2]) {
        let [before, now] = &self.texts;
        let [old, new] = words;
        let old = Side { path: at.old.clone(), line: before.line(names[0].span.start), words: old };
        let new = Side { path: at.new.clone(), line: now.line(names[1].span.start), words: new };
        let kind = ChangeKind::Renamed;
        self.found.push(Change { path: at.shown.clone(), kind, old: Some(old), new: Some(new) });
    }
}

/// A text that knows its lines.
struct Text<'a> {
    text: &'a str,
    /// The bytes at which lines end.
    ends: Vec<usize>,
}

impl<'a> Text<'a> {
    fn new(text: &'a str) -> Self {
        Self { text, ends: text.match_indices('\n').map(|(at, _)| at).collect() }
    }

    fn line(&self, at: usize) -> usize {
        self.ends.partition_point(|end| *end < at) + 1
    }
}

/// Whether both are compared field by field: of one name, or of two with fields in common.
fn is_one_changed(old: &Record, new: &Record) -> bool {
    let name = |record: &Record| record.name.as_ref().map(|name| name.text.clone());
    let in_common = || old.fields.iter().any(|field| named(&new.fields, &field.name.text).is_some());
    let has_names = old.name.is_some() && new.name.is_some();
    old.items.len() == new.items.len() && (name(old) == name(new) || has_names && in_common())
}

fn named<'f>(fields: &'f [Field], name: &str) -> Option<&'f Field> {
    fields.iter().find(|field| field.name.text == name)
}

fn is_vector(items: &[Value]) -> bool {
    items.iter().all(|item| matches!(item.kind, Kind::Number(_)))
}
