//! Models as data: triangles from Wavefront OBJ or binary glTF, and the tree of boxes over them.
//!
//! In: a file's bytes. Out: a [`Model`], whose triangles lie as the tree's leaves name them.

mod elements;
mod glb;
mod obj;
mod places;
mod polygon;
mod smooth;
mod tree;

use std::collections::HashSet;
use std::fmt;
use std::sync::Arc;

use glam::{Vec2, Vec3};

pub use tree::Node;

/// Triangles in the space of the object that they are the shape of, scene units.
#[derive(Clone)]
pub struct Model {
    /// The file's name, as messages use it.
    pub file: String,
    /// Of the file's bytes: two models of one file are the same where this is.
    pub digest: u64,
    /// Their corners go round the outward side against the clock.
    pub triangles: Arc<[[Corner; 3]]>,
    /// The root first.
    pub nodes: Arc<[Node]>,
    /// Whether each edge joins two triangles that face the same side, so that the model encloses something.
    pub is_closed: bool,
    /// Whether all its uv are the file's, which go from 0 to 1, and not places in scene units.
    pub has_uv: bool,
}

/// A corner of a triangle.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Corner {
    pub position: Vec3,
    /// Of the smooth surface, outward, length 1.
    pub normal: Vec3,
    pub uv: Vec2,
}

/// What is read from a file: the normal and the uv may be missing.
#[derive(Clone, Copy, Debug)]
struct Found {
    position: Vec3,
    normal: Option<Vec3>,
    uv: Option<Vec2>,
}

/// As shaders/model.wgsl says.
const NODE_TEXELS: usize = 4;
const TRIANGLE_TEXELS: usize = 6;

/// Keeps what a model takes of a GPU's memory below what all take in one buffer.
const MOST_TRIANGLES: usize = 1_000_000;

/// Farther out the squares of areas are no numbers any more.
const MOST_COORDINATE: f32 = 1e9;

impl Model {
    /// Reads OBJ or binary glTF; `digest` is of `bytes`.
    ///
    /// # Errors
    /// Why it cannot be shown, in words that follow the file's name.
    pub fn decode(file: String, digest: u64, bytes: &[u8]) -> Result<Self, String> {
        let mut found = if bytes.starts_with(b"glTF") {
            glb::read(bytes)?
        } else if bytes.trim_ascii_start().starts_with(b"{") {
            return Err("is glTF as text: export it as one .glb".into());
        } else if bytes.trim_ascii().is_empty() {
            return Err("is empty".into());
        } else {
            obj::read(bytes)?
        };
        check(&found)?;
        remove_idle(&mut found);
        let is_closed = places::is_closed(&found);
        if is_closed && places::is_inside_out(&found) {
            found.iter_mut().for_each(|triangle| triangle.swap(1, 2));
        }
        let has_uv = found.iter().flatten().all(|corner| corner.uv.is_some());
        let (triangles, nodes) = tree::plant(&smooth::finish(&found));
        Ok(Self { file, digest, triangles: triangles.into(), nodes: nodes.into(), is_closed, has_uv })
    }

    /// How many texels [`Model::words`] fills.
    pub fn texels(&self) -> usize {
        NODE_TEXELS * self.nodes.len() + TRIANGLE_TEXELS * self.triangles.len()
    }

    /// The model as shaders/model.wgsl reads it, where `base` texels stand before it.
    pub fn words(&self, base: u32) -> Vec<[u32; 4]> {
        let node_at = |index: u32| base + NODE_TEXELS as u32 * index;
        let triangles = node_at(self.nodes.len() as u32);
        let mut words = Vec::with_capacity(self.texels());
        for node in self.nodes.iter() {
            let first = match node.is_leaf() {
                true => triangles + TRIANGLE_TEXELS as u32 * node.first,
                false => node_at(node.first),
            };
            let next = node.next.map(|next| if next == tree::END { tree::END } else { node_at(next) });
            let [a, b, c, d, e, f, g, h] = next;
            words.extend([with(node.low, first), with(node.high, node.shape), [a, b, c, d], [e, f, g, h]]);
        }
        for corner in self.triangles.iter().flatten() {
            words.push(with(corner.position, corner.uv.x.to_bits()));
            words.push(with(corner.normal, corner.uv.y.to_bits()));
        }
        words
    }
}

/// # Errors
/// Why these are no triangles that can be shown, in words that follow the file's name.
fn check(found: &[[Found; 3]]) -> Result<(), String> {
    if found.len() > MOST_TRIANGLES {
        return Err(too_many());
    }
    let is_near = |x: f32| x.abs() <= MOST_COORDINATE;
    let is_somewhere = |corner: &Found| {
        let uv = corner.uv.unwrap_or_default();
        corner.position.to_array().into_iter().chain(uv.to_array()).all(is_near)
    };
    if !found.iter().flatten().all(is_somewhere) {
        return Err(format!("has a corner whose numbers are none, or beyond {MOST_COORDINATE:e}"));
    }
    if !found.iter().any(|t| facet(t.map(|corner| corner.position)) != Vec3::ZERO) {
        return Err("has no triangles".into());
    }
    Ok(())
}

/// Leaves out triangles that do nothing: one with two corners at one place, and one that is there twice,
/// which would make the tree deep. One without area stays: it may close the seam between its neighbours.
fn remove_idle(found: &mut Vec<[Found; 3]>) {
    let mut known: HashSet<u64, places::Mixed> = HashSet::default();
    found.retain(|t| {
        let [a, b, c] = t.map(|corner| corner.position);
        a != b && b != c && c != a && known.insert(places::of_triangle(t))
    });
}

fn too_many() -> String {
    format!("has more than {MOST_TRIANGLES} triangles")
}

fn with(v: Vec3, word: u32) -> [u32; 4] {
    [v.x.to_bits(), v.y.to_bits(), v.z.to_bits(), word]
}

/// The outward normal of a flat triangle, length 1; zero where it has no area.
fn facet([a, b, c]: [Vec3; 3]) -> Vec3 {
    (b - a).normalize_or_zero().cross((c - a).normalize_or_zero()).normalize_or_zero()
}

impl PartialEq for Model {
    fn eq(&self, other: &Self) -> bool {
        self.file == other.file && self.digest == other.digest
    }
}

impl fmt::Debug for Model {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "Model({}, {} triangles)", self.file, self.triangles.len())
    }
}
