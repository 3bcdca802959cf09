//! Parsers of the words of a call: sizes, ranges, and names of views, languages and adapters.
//!
//! In: a word. Out: its value, or how such a word is written.

use std::ops::Range;

use crate::export::Language;
use crate::frame::View;
use crate::gpu::{AdapterChoice, MAX_SIDE};

pub fn size(text: &str) -> Result<[u32; 2], String> {
    let parsed = text.split_once(['x', 'X']).and_then(|(w, h)| Some([w.parse().ok()?, h.parse().ok()?]));
    let size = parsed.ok_or("a size is width x height in pixels, such as 960x540")?;
    let is_drawn = size.iter().all(|n| (1..=MAX_SIDE).contains(n));
    is_drawn.then_some(size).ok_or_else(|| format!("the size must be from 1x1 to {MAX_SIDE}x{MAX_SIDE}"))
}

pub fn frames(text: &str) -> Result<Range<u32>, String> {
    let parsed = text.split_once("..").and_then(|(from, to)| Some(from.parse().ok()?..to.parse().ok()?));
    let some = parsed.filter(|range: &Range<u32>| !range.is_empty());
    some.ok_or_else(|| "a range of frames is FROM..TO, such as 0..120 for the frames 0 to 119".into())
}

/// Beyond it, a second of `frame.time` has hardly any steps.
pub const LONGEST_TIME: f32 = 1e6;

pub fn time(text: &str) -> Result<f32, String> {
    let sensible = text.parse().ok().filter(|time: &f32| time.abs() <= LONGEST_TIME);
    sensible.ok_or_else(|| "the time must be a number of seconds from -1000000 to 1000000".into())
}

pub fn rate(text: &str) -> Result<f64, String> {
    let sensible = text.parse().ok().filter(|rate| (0.01..=1000.0).contains(rate));
    sensible.ok_or_else(|| "the number of frames for each second must be from 0.01 to 1000".into())
}

pub fn share(text: &str) -> Result<f32, String> {
    let sensible = text.parse().ok().filter(|share| (0.0..=1.0).contains(share));
    sensible.ok_or_else(|| "the position must be from 0, the left edge, to 1, the right edge".into())
}

pub fn reach(text: &str) -> Result<f32, String> {
    let sensible = text.parse().ok().filter(|reach| (1e-6..=1e6).contains(reach));
    sensible.ok_or_else(|| "the number must be from 0.000001 to 1000000".into())
}

pub fn view(text: &str) -> Result<View, String> {
    let found = View::ALL.iter().find(|(name, _)| *name == text);
    found.map(|(_, view)| *view).ok_or_else(|| {
        let names = View::ALL.map(|(name, _)| name);
        format!("the views are {}", names.join(", "))
    })
}

pub fn language(text: &str) -> Result<Language, String> {
    let found = Language::ALL.iter().find(|(name, _)| *name == text);
    found.map(|(_, language)| *language).ok_or_else(|| {
        let names = Language::ALL.map(|(name, _)| name);
        format!("the languages are {}", names.join(", "))
    })
}

pub fn adapter(text: &str) -> Result<AdapterChoice, String> {
    Ok(match text {
        "fastest" => AdapterChoice::Fastest,
        "software" => AdapterChoice::Software,
        name => AdapterChoice::Named(name.into()),
    })
}
