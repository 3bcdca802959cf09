//! The lists of an OBJ file that its faces point into.
//!
//! In: the file's bytes. Out: values by their number in each list, with what is broken kept as a gap.

use glam::{DVec3, Vec2, Vec3};

use super::statements::{Statement, statements};
use super::{in_line, number, shown, text};
use crate::assets::model::MAX_COORDINATE;
use crate::assets::model::found::Found;

/// Positions, uv and normals. One that is no number keeps its place: the others keep theirs.
#[derive(Default)]
pub struct Values {
    positions: Vec<DVec3>,
    uvs: Vec<Vec2>,
    normals: Vec<Vec3>,
    /// What is wrong with the first position that cannot be read.
    why_broken: Option<String>,
    /// Whether the file says which faces are smooth.
    pub know_smoothing: bool,
}

/// How many of each list a file has had so far.
pub type Seen = [usize; 3];

impl Values {
    pub fn read(bytes: &[u8]) -> Self {
        let mut values = Self::default();
        for statement in statements(bytes) {
            match statement.keyword {
                b"v" => {
                    let position = numbers(&statement, 3).map(DVec3::from);
                    let is_near = |p: &DVec3| p.abs().max_element() <= MAX_COORDINATE && !p.is_nan();
                    if position.filter(is_near).is_none() && values.why_broken.is_none() {
                        values.why_broken = Some(in_line(statement.line, unlike(&statement)));
                    }
                    values.positions.push(position.unwrap_or(DVec3::NAN));
                }
                // The second number may be left out.
                b"vt" => {
                    let uv = numbers(&statement, 1).map(|n| DVec3::from(n).truncate().as_vec2());
                    values.uvs.push(uv.unwrap_or(Vec2::NAN));
                }
                b"vn" => {
                    let normal = numbers(&statement, 3).map(|n| DVec3::from(n).as_vec3());
                    values.normals.push(normal.unwrap_or(Vec3::NAN));
                }
                b"s" => values.know_smoothing = true,
                _ => {}
            }
        }
        values
    }

    pub fn are_empty(&self) -> bool {
        self.positions.is_empty()
    }

    /// The corner that `word` names, such as `7`, `7/2`, `7//5` or `-1/-1/-1`.
    pub fn corner(&self, word: &[u8], seen: Seen) -> Result<Found, String> {
        let mut indices = [None; 3];
        let mut parts = word.split(|byte| *byte == b'/');
        for ((index, part), seen) in indices.iter_mut().zip(&mut parts).zip(seen) {
            if part.is_empty() {
                continue;
            }
            let n: i64 = text(part).and_then(|part| part.parse().ok()).ok_or_else(|| unlike_corner(word))?;
            let first = if n < 0 { seen as i64 } else { -1 };
            // No list is so long that it has the last.
            *index = Some(usize::try_from(n.saturating_add(first)).unwrap_or(usize::MAX));
        }
        let [position, uv, normal] = indices;
        if position.is_none() || parts.next().is_some() {
            return Err(unlike_corner(word));
        }
        let position = position.and_then(|index| self.positions.get(index).copied());
        let position = position.ok_or_else(|| format!("the corner `{}` is not in the file", shown(word)))?;
        let uv = uv.filter(|_| !self.uvs.is_empty());
        let normal = normal.filter(|_| !self.normals.is_empty());
        // One that is not in the file is as broken as one that is no number: the corner has a place.
        Ok(Found {
            position,
            uv: uv.map(|index| self.uvs.get(index).copied().unwrap_or(Vec2::NAN)),
            normal: normal.map(|index| self.normals.get(index).copied().unwrap_or(Vec3::NAN)),
        })
    }

    /// Why the position of `corner` is none, if so.
    pub fn why_broken(&self, corner: &Found) -> Option<&String> {
        let is_broken = corner.position.is_nan() || corner.position.abs().max_element() > MAX_COORDINATE;
        self.why_broken.as_ref().filter(|_| is_broken)
    }
}

/// Up to three numbers, of which the first `least` must be there; the others are 0.
fn numbers(statement: &Statement<'_>, least: usize) -> Option<[f64; 3]> {
    let mut found = [0.0; 3];
    let mut words = statement.words();
    for (i, place) in found.iter_mut().enumerate() {
        match words.next() {
            Some(word) => *place = number(word)?,
            None if i < least => return None,
            None => break,
        }
    }
    Some(found)
}

fn unlike_corner(word: &[u8]) -> String {
    format!("expected a corner such as `7` or `7/2/5`, found `{}`", shown(word))
}

fn unlike(statement: &Statement<'_>) -> String {
    format!("expected 3 numbers up to {MAX_COORDINATE:e}, found `{}`", statement.shown())
}
