//! Models as data: triangles from Wavefront OBJ or glTF, and the tree of boxes over them.
//!
//! In: a file's bytes. Out: a [`Model`], whose triangles lie as the tree's leaves name them.

mod found;
mod gltf;
mod obj;
mod places;
mod polygon;
mod smooth;
mod surfaces;

use std::collections::HashSet;
use std::fmt;
use std::sync::Arc;

use glam::{DVec3, Vec2, Vec3};

use self::found::{Face, Findings};
use crate::bvh::{self, Bvh, Node};

/// Triangles in the space of the object that they are the shape of, scene units.
#[derive(Clone)]
pub struct Model {
    /// The file's name, as messages use it.
    pub file: String,
    /// Of the bytes of the file and of those beside it, as who reads them knows it: two models of one file
    /// are the same where this is.
    pub digest: u64,
    /// The files beside it that it takes its triangles from, as it names them.
    pub beside: Vec<String>,
    /// What was odd but not wrong, in words that follow the file's name.
    pub warnings: Vec<String>,
    /// Where the triangles' zero lies in the file's own space: at its zero, unless they lie so far from it
    /// that numbers would lose their digits.
    pub origin: DVec3,
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

/// Reads a file beside a model's, by the name that this gives it.
pub type Beside<'a> = dyn FnMut(&str) -> Result<Arc<[u8]>, String> + 'a;

/// As shaders/model.wgsl says.
const NODE_TEXELS: usize = 4;
const TRIANGLE_TEXELS: usize = 6;

/// Keeps what a model takes of a GPU's memory below what all take in one buffer.
const MAX_TRIANGLES: usize = 1_000_000;

/// Farther out the squares of areas are no numbers any more.
const MAX_COORDINATE: f64 = 1e9;

/// A model that lies farther from its zero than so many times its size is counted from its own middle.
const MAX_REMOTE: f64 = 8.0;

impl Model {
    /// In which such files end.
    pub const EXTENSIONS: &'static [&'static str] = &["obj", "glb", "gltf"];

    /// Reads OBJ or glTF.
    ///
    /// # Errors
    /// Why it cannot be shown, in words that follow the file's name.
    pub fn decode(file: String, bytes: &[u8], beside: &mut Beside<'_>) -> Result<Self, String> {
        let mut names = vec![];
        let mut noted = |name: &str| {
            names.push(name.to_owned());
            beside(name)
        };
        let mut findings = read(bytes, &mut noted)?;
        check(&findings)?;
        let warnings = findings.warnings();
        let mut faces = findings.faces;
        let origin = settle(&mut faces);
        remove_idle(&mut faces);
        let is_closed = places::is_closed(&faces);
        if is_closed && places::is_inside_out(&faces) {
            faces.iter_mut().for_each(|face| face.corners.swap(1, 2));
        }
        let has_uv = faces.iter().flat_map(|face| &face.corners).all(|corner| corner.uv.is_some());
        let triangles = smooth::finish(&faces);
        let Bvh { order, nodes } = bvh::build(&triangles.iter().map(bounds).collect::<Vec<_>>());
        let triangles = order.iter().map(|i| triangles[*i as usize]).collect();
        let nodes = nodes.into();
        Ok(Self { file, digest: 0, beside: names, warnings, origin, triangles, nodes, is_closed, has_uv })
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
            let next = node.next.map(|next| if next == bvh::END { bvh::END } else { node_at(next) });
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

fn read(bytes: &[u8], beside: &mut Beside<'_>) -> Result<Findings, String> {
    let bytes = bytes.strip_prefix(b"\xef\xbb\xbf").unwrap_or(bytes);
    if super::is_lfs_pointer(bytes) {
        return Err("is a pointer of Git LFS, not the model: run `git lfs pull` to fetch it".into());
    }
    if bytes.starts_with(b"\xff\xfe") || bytes.starts_with(b"\xfe\xff") {
        return Err("is text in UTF-16: save it as UTF-8".into());
    }
    if bytes.starts_with(gltf::MAGIC) || bytes.trim_ascii_start().starts_with(b"{") {
        return gltf::read(bytes, beside);
    }
    if bytes.trim_ascii().is_empty() {
        return Err("is empty".into());
    }
    obj::read(bytes)
}

/// # Errors
/// Why these are no triangles that can be shown, in words that follow the file's name.
fn check(findings: &Findings) -> Result<(), String> {
    let faces = &findings.faces;
    if let Some(why) = findings.why_lost.as_ref().filter(|_| findings.lost > faces.len()) {
        return Err(format!("is damaged: {why}"));
    }
    let has_area = |face: &Face| {
        let [a, b, c] = face.corners.map(|corner| corner.position);
        geometric_normal([Vec3::ZERO, (b - a).as_vec3(), (c - a).as_vec3()]) != Vec3::ZERO
    };
    if !faces.iter().any(has_area) {
        let oddity = findings.oddities.first().map(|oddity| format!(": it {oddity}"));
        return Err(format!("has no triangles{}", oddity.unwrap_or_default()));
    }
    Ok(())
}

/// Takes a model that lies far from its zero there, and says from where; rounds all places to what a GPU has.
fn settle(faces: &mut [Face]) -> DVec3 {
    let corners = || faces.iter().flat_map(|face| face.corners.iter().map(|corner| corner.position));
    let low = corners().reduce(DVec3::min).unwrap_or_default();
    let high = corners().reduce(DVec3::max).unwrap_or_default();
    let middle = low.midpoint(high);
    let is_remote = middle.abs().max_element() > MAX_REMOTE * (high - low).max_element();
    // Whole numbers, that a person finds them again.
    let origin = if is_remote { middle.round() } else { DVec3::ZERO };
    for corner in faces.iter_mut().flat_map(|face| &mut face.corners) {
        corner.position = (corner.position - origin).as_vec3().as_dvec3();
    }
    origin
}

/// Leaves out triangles that do nothing: one with two corners at one place, and one that is there twice,
/// which would make the tree deep. One without area stays: it may close the seam between its neighbours.
fn remove_idle(faces: &mut Vec<Face>) {
    let mut known: HashSet<u64, places::Mixed> = HashSet::default();
    faces.retain(|face| {
        let [a, b, c] = face.corners.map(|corner| corner.position);
        a != b && b != c && c != a && known.insert(places::of_triangle(face))
    });
}

fn with(v: Vec3, word: u32) -> [u32; 4] {
    [v.x.to_bits(), v.y.to_bits(), v.z.to_bits(), word]
}

/// The box around a triangle.
fn bounds(triangle: &[Corner; 3]) -> [Vec3; 2] {
    let [a, b, c] = triangle.map(|corner| corner.position);
    [a.min(b).min(c), a.max(b).max(c)]
}

/// The outward normal of a flat triangle, length 1; zero where it has no area.
fn geometric_normal([a, b, c]: [Vec3; 3]) -> Vec3 {
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
