//! What readers of model files hand over: triangles, of which much may be missing, and what was odd.

use glam::{DVec3, Vec2, Vec3};

use super::{MAX_COORDINATE, MAX_TRIANGLES};

/// A corner: the normal and the uv may be missing.
#[derive(Clone, Copy, Debug)]
pub struct Found {
    pub position: DVec3,
    pub normal: Option<Vec3>,
    pub uv: Option<Vec2>,
}

/// A triangle.
#[derive(Clone, Copy, Debug)]
pub struct Face {
    pub corners: [Found; 3],
    pub smoothing: Smoothing,
}

/// Which surface a triangle stands for, where its corners have no normals.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Smoothing {
    /// Its own.
    Flat,
    /// One that it shares with the triangles of the same group.
    Group(u32),
    /// The file says nothing: one that it shares with those beside it, but for sharp edges.
    Creased,
}

/// All that was found in a file.
#[derive(Default)]
pub struct Findings {
    pub faces: Vec<Face>,
    /// How many triangles could not be made.
    pub lost: usize,
    /// Why the first of them could not.
    pub why_lost: Option<String>,
    /// How many corners had a normal or a uv that is no number.
    pub broken_normals: usize,
    pub broken_uvs: usize,
    /// What else was odd, in words that follow the file's name.
    pub oddities: Vec<String>,
}

impl Findings {
    /// # Errors
    /// That there are too many triangles to go on.
    pub fn add(&mut self, face: Face) -> Result<(), String> {
        if self.faces.len() >= MAX_TRIANGLES {
            return Err(too_many());
        }
        let corners = &face.corners;
        if corners.iter().any(|corner| corner.position.abs().max_element() > MAX_COORDINATE)
            || corners.iter().any(|corner| corner.position.is_nan())
        {
            self.lose(|| format!("a corner has invalid numbers, or numbers beyond {MAX_COORDINATE:e}"));
        } else {
            let corners = face.corners.map(|corner| self.repaired(corner));
            self.faces.push(Face { corners, ..face });
        }
        Ok(())
    }

    /// Counts a triangle that could not be made.
    pub fn lose(&mut self, why: impl FnOnce() -> String) {
        self.lost += 1;
        self.why_lost.get_or_insert_with(why);
    }

    fn repaired(&mut self, corner: Found) -> Found {
        let normal = corner.normal.filter(|normal| normal.is_finite());
        let uv = corner.uv.filter(|uv| uv.abs().max_element() <= MAX_COORDINATE as f32 && !uv.is_nan());
        self.broken_normals += usize::from(normal.is_none() && corner.normal.is_some());
        self.broken_uvs += usize::from(uv.is_none() && corner.uv.is_some());
        Found { normal, uv, ..corner }
    }

    /// What was odd but not wrong, in words that follow the file's name.
    pub fn warnings(&mut self) -> Vec<String> {
        let mut warnings = std::mem::take(&mut self.oddities);
        if let Some(why) = &self.why_lost {
            let all = self.faces.len() + self.lost;
            warnings.push(format!("lacks {} of its {all} triangles: {why}", self.lost));
        }
        if self.broken_normals > 0 {
            let count = counted(self.broken_normals, "an invalid normal", "invalid normals");
            warnings.push(format!("has {count}: the normals of the triangles are used there"));
        }
        if self.broken_uvs > 0 {
            let count = counted(self.broken_uvs, "an invalid uv", "invalid uv");
            warnings.push(format!("has {count}: images are laid on these triangles along an axis"));
        }
        warnings
    }
}

pub fn too_many() -> String {
    format!("has more than {MAX_TRIANGLES} triangles")
}

/// `one`, or how many of `many`.
pub fn counted(count: usize, one: &str, many: &str) -> String {
    if count == 1 { one.into() } else { format!("{count} {many}") }
}
