//! Wavefront OBJ: all of its groups as one list of triangles; materials are the scene's business.
//!
//! In: a file's bytes. Out: its faces as triangles, in the file's order.

mod statements;
mod values;

use glam::DVec3;

use self::statements::{Statement, statements};
use self::values::{Seen, Values};
use super::found::{Face, Findings, Found, Smoothing, counted};
use super::polygon;

/// # Errors
/// Why it is no such file, in words that follow its name.
pub fn read(bytes: &[u8]) -> Result<Findings, String> {
    let values = Values::read(bytes);
    let mut reader = Reader {
        // Off, as the format says, in a file that knows of smoothing at all.
        smoothing: if values.know_smoothing { Smoothing::Flat } else { Smoothing::Creased },
        values,
        seen: [0; 3],
        corners: vec![],
        findings: Findings::default(),
    };
    let (mut has_faces, mut free_forms) = (false, 0);
    for statement in statements(bytes) {
        match statement.keyword {
            b"v" => reader.seen[0] += 1,
            b"vt" => reader.seen[1] += 1,
            b"vn" => reader.seen[2] += 1,
            // `fo` is what the first version of the format called it.
            b"f" | b"fo" => {
                has_faces = true;
                reader.face(&statement)?;
            }
            b"s" => reader.smoothing = group(&statement),
            b"surf" | b"curv" | b"curv2" => free_forms += 1,
            _ => {}
        }
    }
    if !has_faces && reader.values.are_empty() {
        return Err("is neither Wavefront OBJ nor glTF".into());
    }
    if free_forms > 0 {
        let count = counted(free_forms, "a free-form curve or surface", "free-form curves and surfaces");
        reader.findings.oddities.push(format!("has {count}: only its faces are shown"));
    }
    Ok(reader.findings)
}

struct Reader {
    values: Values,
    /// Of the faces to come.
    smoothing: Smoothing,
    seen: Seen,
    /// Of the face that is read.
    corners: Vec<Found>,
    findings: Findings,
}

impl Reader {
    /// Adds the triangles of a face. One with less than three corners is a point or a line, and has none.
    fn face(&mut self, statement: &Statement<'_>) -> Result<(), String> {
        self.corners.clear();
        for word in statement.words() {
            match self.values.corner(word, self.seen) {
                Ok(corner) => self.corners.push(corner),
                Err(why) => {
                    self.findings.lose(|| in_line(statement.line, why));
                    return Ok(());
                }
            }
        }
        if let Some(why) = self.corners.iter().find_map(|corner| self.values.why_broken(corner)) {
            self.findings.lose(|| why.clone());
            return Ok(());
        }
        let smoothing = self.smoothing;
        if let [a, b, c] = self.corners[..] {
            return self.findings.add(Face { corners: [a, b, c], smoothing });
        }
        let places: Vec<DVec3> = self.corners.iter().map(|corner| corner.position).collect();
        polygon::triangles(&places).into_iter().try_for_each(|triangle| {
            let corners = triangle.map(|i| self.corners[i]);
            self.findings.add(Face { corners, smoothing })
        })
    }
}

/// The group of `s 1`; `s off` and `s 0` are none.
fn group(statement: &Statement<'_>) -> Smoothing {
    match statement.words().next().and_then(text) {
        Some("on") => Smoothing::Group(1),
        word => match word.and_then(|word| word.parse().ok()) {
            None | Some(0) => Smoothing::Flat,
            Some(number) => Smoothing::Group(number),
        },
    }
}

fn text(word: &[u8]) -> Option<&str> {
    std::str::from_utf8(word).ok()
}

fn number(word: &[u8]) -> Option<f64> {
    text(word)?.parse().ok()
}

/// What of `words` a message shows. They may be in any encoding.
fn shown(words: &[u8]) -> String {
    const MAX_LETTERS: usize = 40;
    let words = String::from_utf8_lossy(words);
    let start: String = words.chars().take(MAX_LETTERS).collect();
    let end = if start.len() < words.len() { "…" } else { "" };
    start.replace(char::is_control, " ") + end
}

fn in_line(number: usize, why: String) -> String {
    format!("line {number}: {why}")
}
