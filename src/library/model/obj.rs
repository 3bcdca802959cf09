//! Wavefront OBJ: all of its groups as one list of triangles; materials are the scene's business.
//!
//! In: a file's bytes. Out: its faces as triangles, in the file's order.

use std::fmt::Display;

use glam::{DVec3, Vec2, Vec3};

use super::{Found, MOST_COORDINATE, polygon};

/// # Errors
/// Why it is no such file, in words that follow its name.
pub fn read(bytes: &[u8]) -> Result<Vec<[Found; 3]>, String> {
    // Names and comments may be in any encoding.
    let mut text = String::from_utf8_lossy(bytes);
    if text.contains('\\') {
        // A line goes on in the next one; both count as one.
        text = text.replace("\\\r\n", " ").replace("\\\n", " ").into();
    }
    let values = Values::read(&text)?;
    let mut triangles = vec![];
    let mut seen = [0; 3];
    let mut has_faces = false;
    let mut corners = vec![];
    for (number, keyword, words) in statements(&text) {
        match keyword {
            "v" => seen[0] += 1,
            "vt" => seen[1] += 1,
            "vn" => seen[2] += 1,
            "f" => {
                has_faces = true;
                corners.clear();
                for word in words.split_ascii_whitespace() {
                    corners.push(values.corner(word, seen).map_err(|why| in_line(number, why))?);
                }
                face(&corners, &mut triangles);
            }
            _ => {}
        }
    }
    if !has_faces && values.positions.is_empty() {
        return Err("is neither Wavefront OBJ nor binary glTF".into());
    }
    Ok(triangles)
}

/// Adds the triangles of a face. One with less than three corners is a point or a line, and has none.
fn face(corners: &[Found], triangles: &mut Vec<[Found; 3]>) {
    if let [a, b, c] = corners {
        triangles.push([*a, *b, *c]);
        return;
    }
    let places: Vec<DVec3> = corners.iter().map(|corner| corner.position.as_dvec3()).collect();
    triangles.extend(polygon::triangles(&places).into_iter().map(|t| t.map(|i| corners[i])));
}

/// The lists that faces point into.
#[derive(Default)]
struct Values {
    positions: Vec<Vec3>,
    uvs: Vec<Vec2>,
    normals: Vec<Vec3>,
}

impl Values {
    fn read(text: &str) -> Result<Self, String> {
        let mut values = Self::default();
        for (number, keyword, words) in statements(text) {
            let wrong = |why| in_line(number, why);
            match keyword {
                "v" => values.positions.push(numbers(words, 3).map_err(wrong)?.into()),
                // The second number may be left out.
                "vt" => values.uvs.push(Vec3::from(numbers(words, 1).map_err(wrong)?).truncate()),
                "vn" => values.normals.push(numbers(words, 3).map_err(wrong)?.into()),
                _ => {}
            }
        }
        Ok(values)
    }

    /// The corner that `word` names, such as `7`, `7/2`, `7//5` or `-1/-1/-1`; `seen` counts what the file
    /// has said of each list so far.
    fn corner(&self, word: &str, seen: [usize; 3]) -> Result<Found, String> {
        let mut indices = [None; 3];
        let mut parts = word.split('/');
        for ((index, part), seen) in indices.iter_mut().zip(&mut parts).zip(seen) {
            if part.is_empty() {
                continue;
            }
            let n: i64 = part.parse().map_err(|_| unlike_corner(word))?;
            let first = if n < 0 { seen as i64 } else { -1 };
            // No list is so long that it has the last.
            *index = Some(usize::try_from(n.saturating_add(first)).unwrap_or(usize::MAX));
        }
        let [position, uv, normal] = indices;
        if position.is_none() || parts.next().is_some() {
            return Err(unlike_corner(word));
        }
        let found = || {
            Some(Found {
                position: *self.positions.get(position?)?,
                uv: pointed(&self.uvs, uv)?,
                normal: pointed(&self.normals, normal)?,
            })
        };
        found().ok_or_else(|| format!("the corner `{}` is not in the file", shown(word)))
    }
}

/// The value that a corner points to, if any; None where the file has others, but not that one.
fn pointed<T: Copy>(values: &[T], index: Option<usize>) -> Option<Option<T>> {
    match index {
        Some(index) if !values.is_empty() => values.get(index).copied().map(Some),
        _ => Some(None),
    }
}

/// The number of the line, the keyword and the rest of each line that says something.
fn statements(text: &str) -> impl Iterator<Item = (usize, &str, &str)> {
    (1..).zip(text.lines()).filter_map(|(number, line)| {
        let line = line.split('#').next().unwrap_or("").trim();
        let (keyword, words) = line.split_once([' ', '\t']).unwrap_or((line, ""));
        (!keyword.is_empty()).then_some((number, keyword, words))
    })
}

/// Up to three numbers, of which the first `least` must be there; the others are 0.
fn numbers(words: &str, least: usize) -> Result<[f32; 3], String> {
    let mut found = [0.0; 3];
    let mut split = words.split_ascii_whitespace();
    for (i, number) in found.iter_mut().enumerate() {
        let Some(word) = split.next() else {
            if i < least {
                return Err(unlike(least, words));
            }
            break;
        };
        let value = word.parse().ok().filter(|x: &f32| x.abs() <= MOST_COORDINATE);
        *number = value.ok_or_else(|| unlike(least, words))?;
    }
    Ok(found)
}

fn unlike_corner(word: &str) -> String {
    format!("expected a corner such as `7` or `7/2/5`, found `{}`", shown(word))
}

fn unlike(count: usize, words: &str) -> String {
    let numbers = if count == 1 { "a number".into() } else { format!("{count} numbers") };
    format!("expected {numbers} up to {MOST_COORDINATE:e}, found `{}`", shown(words))
}

/// What of `words` a message shows.
fn shown(words: &str) -> String {
    const MOST: usize = 40;
    let words = words.trim();
    let start: String = words.chars().take(MOST).collect();
    let end = if start.len() < words.len() { "…" } else { "" };
    start.replace(char::is_control, " ") + end
}

fn in_line(number: usize, why: impl Display) -> String {
    format!("is damaged: line {number}: {why}")
}
