//! Binary glTF 2.0: the triangles of its scene, each moved to where its node stands.
//!
//! In: a file's bytes. Out: its triangles, node after node.

use glam::{Mat3, Mat4, Vec2, Vec3};
use gltf::accessor::Dimensions;
use gltf::mesh::Mode;
use gltf::{Document, Semantic};

use super::elements::Elements;
use super::{Found, MOST_TRIANGLES, too_many};

/// Extensions that a file may need without having its triangles elsewhere or otherwise.
const HARMLESS: [&str; 5] =
    ["KHR_materials_", "KHR_texture_", "EXT_texture_", "KHR_lights_", "KHR_mesh_quantization"];

/// # Errors
/// Why it is no such file, in words that follow its name.
pub fn read(bytes: &[u8]) -> Result<Vec<[Found; 3]>, String> {
    let (document, blob) = parse(bytes)?;
    let scene = document.default_scene().or_else(|| document.scenes().next()).ok_or("has no scene")?;
    let mut triangles = vec![];
    let mut is_known = vec![false; document.nodes().len()];
    let mut waiting: Vec<(gltf::Node<'_>, Mat4)> = scene.nodes().map(|n| (n, Mat4::IDENTITY)).collect();
    while let Some((node, outer)) = waiting.pop() {
        // Else a node could stand below itself.
        if std::mem::replace(&mut is_known[node.index()], true) {
            return Err("is damaged: one of its nodes stands in two places".into());
        }
        let to_scene = outer * Mat4::from_cols_array_2d(&node.transform().matrix());
        for primitive in node.mesh().iter().flat_map(gltf::Mesh::primitives) {
            add(&primitive, &blob, to_scene, &mut triangles)?;
        }
        waiting.extend(node.children().map(|child| (child, to_scene)));
    }
    Ok(triangles)
}

/// The document without what it says of looks and motion, and the bytes that it points into.
fn parse(bytes: &[u8]) -> Result<(Document, Vec<u8>), String> {
    const HEADER: usize = 12;
    let length = bytes.get(8..HEADER).and_then(|word| word.try_into().ok()).map(u32::from_le_bytes);
    let length = length.map_or(HEADER, |length| length as usize);
    if bytes.len() < length.max(HEADER) {
        return Err(format!("is cut off after {} of {length} bytes", bytes.len()));
    }
    // The reader takes the header off without a look.
    if length < HEADER {
        return Err("is damaged: it gives a length of less than its header".into());
    }
    let damaged = |error: gltf::Error| format!("is damaged: {}", error.to_string().trim_end_matches(';'));
    let file = gltf::Gltf::from_slice_without_validation(bytes).map_err(damaged)?;
    let mut json = file.document.into_json();
    let is_harmless = |needed: &&String| HARMLESS.iter().any(|known| needed.starts_with(known));
    if let Some(extension) = json.extensions_required.iter().find(|needed| !is_harmless(needed)) {
        return Err(format!("needs `{extension}`, which raytoy does not know: export it without"));
    }
    json.extensions_required.clear();
    json.materials.clear();
    json.textures.clear();
    json.images.clear();
    json.animations.clear();
    let accessors = json.accessors.len();
    for primitive in json.meshes.iter_mut().flat_map(|mesh| &mut mesh.primitives) {
        primitive.material = None;
        // The check of the whole document goes there without a look.
        if primitive.attributes.values().any(|accessor| accessor.value() >= accessors) {
            return Err("is damaged: a mesh has corners that are not in the file".into());
        }
    }
    if json.buffers.iter().any(|buffer| buffer.uri.is_some()) {
        return Err("keeps its triangles in another file: export it as one .glb".into());
    }
    let document = Document::from_json(json).map_err(damaged)?;
    Ok((document, file.blob.unwrap_or_default()))
}

fn add(
    primitive: &gltf::Primitive<'_>,
    blob: &[u8],
    to_scene: Mat4,
    triangles: &mut Vec<[Found; 3]>,
) -> Result<(), String> {
    let elements = |accessor: Option<gltf::Accessor<'_>>, dimensions| {
        accessor.map(|accessor| Elements::of(&accessor, dimensions, blob)).transpose()
    };
    let Some(positions) = elements(primitive.get(&Semantic::Positions), Dimensions::Vec3)? else {
        return Ok(());
    };
    let normals = elements(primitive.get(&Semantic::Normals), Dimensions::Vec3)?;
    let uvs = elements(primitive.get(&Semantic::TexCoords(0)), Dimensions::Vec2)?;
    let indices = elements(primitive.indices(), Dimensions::Scalar)?;
    let turned = Mat3::from_mat4(to_scene).inverse().transpose();
    let corner = |place: usize| {
        let i = indices.as_ref().map_or(place, |indices| indices.index(place));
        let has = |elements: &&Elements<'_>| i < elements.count;
        has(&&positions).then(|| Found {
            position: to_scene.transform_point3(positions.vector(i).into()),
            normal: normals.as_ref().filter(has).map(|all| turned * Vec3::from(all.vector(i))),
            uv: uvs.as_ref().filter(has).map(|all| {
                // glTF counts v from the top of an image.
                let [u, v] = all.vector(i);
                Vec2::new(u, 1.0 - v)
            }),
        })
    };
    let mirrors = to_scene.determinant() < 0.0;
    let count = indices.as_ref().map_or(positions.count, |indices| indices.count);
    let faces = faces(primitive.mode(), count);
    if triangles.len() + faces > MOST_TRIANGLES {
        return Err(too_many());
    }
    for n in 0..faces {
        let [a, b, c] = face(primitive.mode(), n);
        let [Some(a), Some(b), Some(c)] = [a, b, c].map(corner) else {
            return Err("is damaged: a face has a corner that is not in the file".into());
        };
        triangles.push(if mirrors { [a, c, b] } else { [a, b, c] });
    }
    Ok(())
}

/// How many triangles `count` corners make. Points and lines make none.
fn faces(mode: Mode, count: usize) -> usize {
    match mode {
        Mode::Triangles => count / 3,
        Mode::TriangleFan | Mode::TriangleStrip => count.saturating_sub(2),
        Mode::Points | Mode::Lines | Mode::LineLoop | Mode::LineStrip => 0,
    }
}

/// The corners of triangle `n`.
fn face(mode: Mode, n: usize) -> [usize; 3] {
    match mode {
        Mode::TriangleFan => [0, n + 1, n + 2],
        Mode::TriangleStrip if n % 2 == 1 => [n + 1, n, n + 2],
        Mode::TriangleStrip => [n, n + 1, n + 2],
        _ => [3 * n, 3 * n + 1, 3 * n + 2],
    }
}
