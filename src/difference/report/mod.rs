//! What differs between two scenes, for people, for programs, and as a page.

mod human;
mod json;
mod page;

pub use human::human;
pub use json::json;
pub use page::page;

use super::PictureDifference;
use crate::scene::{Change, ChangeKind, Side};

/// What a change is, without its lines. `cut` shortens the words of values.
fn told(change: &Change, cut: impl Fn(&str) -> String) -> String {
    let words = |side: &Option<Side>| side.as_ref().map_or(String::new(), |side| cut(&side.words));
    let place = |side: &Option<Side>| side.as_ref().map_or(String::new(), |side| side.path.to_string());
    let (old, new) = (words(&change.old), words(&change.new));
    let path = match change.path.0.is_empty() {
        true => "the scene".into(),
        false => change.path.to_string(),
    };
    match change.kind {
        ChangeKind::New => format!("{path} is new: {new}"),
        ChangeKind::Gone => format!("{path} is gone: {old}"),
        ChangeKind::Changed | ChangeKind::Renamed => format!("{path}: {old} → {new}"),
        ChangeKind::Moved => format!("{path} moved: {} → {}", place(&change.old), place(&change.new)),
    }
}

/// `A.ron:12 → B.ron:14`, or the one of them that there is.
fn lines(change: &Change, names: &[String; 2]) -> String {
    let sides = [&change.old, &change.new].into_iter().zip(names);
    let places = sides.filter_map(|(side, name)| Some(format!("{name}:{}", side.as_ref()?.line)));
    places.collect::<Vec<_>>().join(" → ")
}

/// What there is to say of the values in all.
fn count(values: usize) -> String {
    match values {
        0 => "equal".into(),
        1 => "1 value differs".into(),
        n => format!("{n} values differ"),
    }
}

/// What there is to say of two pictures; the first line says whether they look the same.
fn sight(picture: &PictureDifference) -> Vec<String> {
    match picture.verdict.outliers.worst {
        None => vec!["equal".into()],
        Some(worst) if picture.verdict.passes() => {
            vec![format!("looks equal; channels differ by {} of 255 at most", worst.difference())]
        }
        Some(_) => [vec!["looks different".to_owned()], picture.told()].concat(),
    }
}
