//! For programs: one object with all that differs.

use serde::Serialize;

use crate::difference::{Measures, SceneDifference, ShaderDifference};
use crate::judge::Area;
use crate::scene::{Change, ChangeKind};

#[derive(Serialize)]
struct Report<'a> {
    same: bool,
    old: &'a str,
    new: &'a str,
    values: Vec<Value<'a>>,
    shader: Shader,
    #[serde(skip_serializing_if = "Option::is_none")]
    picture: Option<Picture<'a>>,
}

#[derive(Serialize)]
struct Value<'a> {
    path: String,
    /// new, gone, changed, renamed or moved
    kind: &'static str,
    #[serde(skip_serializing_if = "Option::is_none")]
    old: Option<Side<'a>>,
    #[serde(skip_serializing_if = "Option::is_none")]
    new: Option<Side<'a>>,
}

#[derive(Serialize)]
struct Side<'a> {
    /// By indices alone.
    path: String,
    line: usize,
    words: &'a str,
}

#[derive(Serialize)]
struct Shader {
    same: bool,
    /// Whether the text with numbers as data is the same.
    same_live: bool,
    objects_gone: Vec<String>,
    objects_new: Vec<String>,
    objects_changed: Vec<String>,
    files: Vec<String>,
    /// A unified diff.
    diff: Vec<String>,
}

#[derive(Serialize)]
struct Picture<'a> {
    same: bool,
    looks_the_same: bool,
    /// What a person would see.
    seen: String,
    measures: Measures,
    /// left, top, right, bottom; ends included
    #[serde(skip_serializing_if = "Option::is_none")]
    area: Option<[u32; 4]>,
    objects_before: Vec<Shown<'a>>,
    objects_now: Vec<Shown<'a>>,
    #[serde(skip_serializing_if = "Option::is_none")]
    adapter: Option<&'a str>,
}

/// An object where pixels differ.
#[derive(Serialize)]
struct Shown<'a> {
    name: &'a str,
    /// Of the pixels that differ, 0 to 1.
    share: f64,
}

/// The JSON text of what differs.
pub fn json(difference: &SceneDifference) -> String {
    let [old, new] = &difference.names;
    let picture = difference.picture.as_ref().map(|picture| Picture {
        same: picture.is_none(),
        looks_the_same: picture.verdict.passes(),
        seen: picture.seen(),
        measures: Measures::of(&picture.verdict),
        area: picture.verdict.outliers.bounds.map(Area::corners),
        objects_before: shown(&picture.before),
        objects_now: shown(&picture.now),
        adapter: difference.adapter.as_deref(),
    });
    let report = Report {
        same: difference.is_none(),
        old,
        new,
        values: difference.values.iter().map(value).collect(),
        shader: shader(&difference.shader),
        picture,
    };
    serde_json::to_string_pretty(&report).expect("numbers and strings") + "\n"
}

fn value(change: &Change) -> Value<'_> {
    let kind = match change.kind {
        ChangeKind::New => "new",
        ChangeKind::Gone => "gone",
        ChangeKind::Changed => "changed",
        ChangeKind::Renamed => "renamed",
        ChangeKind::Moved => "moved",
    };
    let [old, new] = [&change.old, &change.new].map(|found| {
        let side = found.as_ref();
        side.map(|side| Side { path: side.path.to_string(), line: side.line, words: &side.words })
    });
    Value { path: change.path.to_string(), kind, old, new }
}

fn shown(objects: &[(String, f64)]) -> Vec<Shown<'_>> {
    objects.iter().map(|(name, share)| Shown { name, share: *share }).collect()
}

fn shader(difference: &ShaderDifference) -> Shader {
    let text = difference.text.clone().unwrap_or_default();
    Shader {
        same: difference.is_none(),
        same_live: difference.is_same_live,
        diff: text.unified(usize::MAX).0,
        objects_gone: text.gone,
        objects_new: text.new,
        objects_changed: text.changed,
        files: difference.files.clone(),
    }
}
