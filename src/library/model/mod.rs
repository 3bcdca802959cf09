//! Models as data: triangles from Wavefront OBJ or binary glTF, and the tree of boxes over them.
//!
//! In: a file's bytes. Out: a [`Model`], whose triangles lie as the tree's leaves name them.

mod glb;
mod obj;
mod smooth;
mod tree;

use std::collections::HashMap;
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

impl Model {
    /// Reads OBJ or binary glTF; `digest` is of `bytes`.
    ///
    /// # Errors
    /// Why it cannot be shown, in words that follow the file's name.
    pub fn decode(file: String, digest: u64, bytes: &[u8]) -> Result<Self, String> {
        let found = if bytes.starts_with(b"glTF") { glb::read(bytes)? } else { obj::read(bytes)? };
        if found.len() > MOST_TRIANGLES {
            return Err(format!("has {} triangles, and {MOST_TRIANGLES} are the most", found.len()));
        }
        let is_number = |corner: &Found| corner.position.abs().max_element() < 1e18;
        if !found.iter().flatten().all(is_number) {
            return Err("has a corner that is nowhere: its coordinates are no numbers".into());
        }
        let has_area = |t: &&[Found; 3]| facet(t.map(|c| c.position)) != Vec3::ZERO;
        let found: Vec<[Found; 3]> = found.iter().filter(has_area).copied().collect();
        if found.is_empty() {
            return Err("has no triangles".into());
        }
        let (triangles, nodes) = tree::plant(&smooth::finish(&found));
        Ok(Self { file, digest, triangles: triangles.into(), nodes: nodes.into() })
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

    /// Whether each edge joins two triangles that face the same side, so that the model encloses something.
    pub fn is_closed(&self) -> bool {
        let mut edges: HashMap<[[u32; 3]; 2], i64> = HashMap::new();
        for triangle in self.triangles.iter() {
            let at = triangle.map(|corner| place(corner.position));
            for [a, b] in [[at[0], at[1]], [at[1], at[2]], [at[2], at[0]]] {
                *edges.entry([a.min(b), a.max(b)]).or_default() += if a < b { 1 } else { -1 };
            }
        }
        edges.values().all(|more| *more == 0)
    }
}

fn with(v: Vec3, word: u32) -> [u32; 4] {
    [v.x.to_bits(), v.y.to_bits(), v.z.to_bits(), word]
}

/// Equal for corners at the same place, whatever the sign of a zero.
fn place(position: Vec3) -> [u32; 3] {
    (position + Vec3::ZERO).to_array().map(f32::to_bits)
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
