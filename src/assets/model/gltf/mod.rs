//! glTF 2.0, binary or as text: the triangles of its scene, each moved to where its node stands.
//!
//! In: a file's bytes, and who reads those beside it. Out: its triangles, node after node.

mod buffers;
mod container;
mod corners;
mod document;
mod elements;
mod extensions;
mod nodes;

use glam::DMat4;

use self::buffers::Buffer;
pub use self::container::MAGIC;
use self::corners::{Mover, Placing};
use self::document::{Attributes, Document, Node, Primitive, at};
use self::elements::{Elements, Kind};
use super::found::{Face, Findings, Smoothing, counted, too_many};
use super::{Beside, MAX_TRIANGLES};

/// # Errors
/// Why it is no such file, in words that follow its name.
pub fn read(bytes: &[u8], beside: &mut Beside<'_>) -> Result<Findings, String> {
    let (json, blob) = container::split(bytes)?;
    let document = Document::read(json)?;
    let unknown = extensions::check(&document)?;
    let buffers = buffers::read(&document, blob, beside)?;
    let matrices = nodes::to_scene(&document)?;
    let reader = Reader { document: &document, buffers: &buffers, matrices };
    let mut findings = Findings { oddities: unknown.into_iter().collect(), ..Findings::default() };
    let mut bare = 0;
    for index in nodes::visible(&document)? {
        bare += reader.node(index, &mut findings)?;
    }
    if bare > 0 {
        let count = counted(bare, "a part", "parts");
        findings.oddities.push(format!("has {count} of points or lines: only its triangles are shown"));
    }
    Ok(findings)
}

struct Reader<'a> {
    document: &'a Document,
    buffers: &'a [Buffer<'a>],
    /// Of each node.
    matrices: Vec<DMat4>,
}

impl<'a> Reader<'a> {
    /// Adds the triangles of node `index`; how many of its parts have none.
    fn node(&self, index: usize, findings: &mut Findings) -> Result<usize, String> {
        let node: &Node = &self.document.nodes[index];
        let Some(mesh) = node.mesh else { return Ok(0) };
        let mesh = at(&self.document.meshes, mesh, "mesh")?;
        let weights = node.weights.as_ref().unwrap_or(&mesh.weights);
        let skin = node.skin.map(|skin| at(&self.document.skins, skin, "skin")).transpose()?;
        let joints = skin.map(|skin| self.joints(skin)).transpose()?;
        let matrix = self.matrices[index];
        // A skin makes the place of the node itself void (glTF 2.0, 3.7.3.3).
        let movers = match (&joints, &node.extensions.instancing) {
            (Some(joints), _) => vec![Mover::Skin(joints)],
            (None, None) => vec![Mover::Node(Placing::new(matrix))],
            (None, Some(instancing)) => {
                let instances = self.instances(instancing)?.into_iter();
                instances.map(|instance| Mover::Node(Placing::new(matrix * instance))).collect()
            }
        };
        let mut bare = 0;
        for primitive in &mesh.primitives {
            bare += usize::from(primitive.mode.unwrap_or(TRIANGLES) < TRIANGLES);
            self.primitive(primitive, weights, &movers, findings)?;
        }
        Ok(bare)
    }

    fn primitive(
        &self,
        primitive: &Primitive,
        weights: &[f32],
        movers: &[Mover<'_>],
        findings: &mut Findings,
    ) -> Result<(), String> {
        let Some(corners) = self.corners(primitive, weights)? else { return Ok(()) };
        let indices = primitive.indices.map(|index| self.elements(index, Kind::Scalar)).transpose()?;
        let mode = primitive.mode.unwrap_or(TRIANGLES);
        let faces = faces(mode, indices.as_ref().map_or(corners.positions.count, |indices| indices.count));
        if faces.saturating_mul(movers.len()) > MAX_TRIANGLES - findings.faces.len() {
            return Err(too_many());
        }
        // As the format says (glTF 2.0, 3.7.2.1).
        let smoothing = Smoothing::Flat;
        for mover in movers {
            let corner = |place: usize| {
                let i = indices.as_ref().map_or(place, |indices| indices.index(place));
                corners.at(i, mover)
            };
            for n in 0..faces {
                let [a, b, c] = face(mode, n).map(corner);
                let (Some((a, mirrors)), Some((b, _)), Some((c, _))) = (a, b, c) else {
                    findings.lose(|| "a face has a corner that does not exist".into());
                    continue;
                };
                let corners = if mirrors { [a, c, b] } else { [a, b, c] };
                findings.add(Face { corners, smoothing })?;
            }
        }
        Ok(())
    }

    /// The elements of accessor `index`, which must be of `kind`.
    fn elements(&self, index: usize, kind: Kind) -> Result<Elements<'a>, String> {
        Elements::of(self.document, self.buffers, index, kind)
    }

    /// The elements of the accessor `name`, if there is one.
    fn named(&self, all: &Attributes, name: &str, kind: Kind) -> Result<Option<Elements<'a>>, String> {
        all.get(name).map(|index| self.elements(*index, kind)).transpose()
    }
}

/// Smaller modes are points and lines.
const TRIANGLES: u32 = 4;
const STRIP: u32 = 5;
const FAN: u32 = 6;

/// How many triangles `count` corners make. Points and lines make none.
fn faces(mode: u32, count: usize) -> usize {
    match mode {
        TRIANGLES => count / 3,
        STRIP | FAN => count.saturating_sub(2),
        _ => 0,
    }
}

/// The corners of triangle `n`.
fn face(mode: u32, n: usize) -> [usize; 3] {
    match mode {
        FAN => [0, n + 1, n + 2],
        STRIP if n % 2 == 1 => [n + 1, n, n + 2],
        STRIP => [n, n + 1, n + 2],
        _ => [3 * n, 3 * n + 1, 3 * n + 2],
    }
}
