//! Binary glTF 2.0: the triangles of its scene, each moved to where its node stands.

use glam::{Mat3, Mat4, Vec2, Vec3};
use gltf::mesh::Mode;

use super::Found;

/// # Errors
/// Why it is no such file, in words that follow its name.
pub fn read(bytes: &[u8]) -> Result<Vec<[Found; 3]>, String> {
    let file = gltf::Gltf::from_slice(bytes).map_err(|error| format!("is damaged: {error}"))?;
    let outside = file.buffers().any(|b| matches!(b.source(), gltf::buffer::Source::Uri(_)));
    if outside {
        return Err("keeps its triangles in another file: export it as one .glb".into());
    }
    let scene = file.default_scene().or_else(|| file.scenes().next()).ok_or("has no scene")?;
    let blob = file.blob.as_deref().unwrap_or(&[]);
    let mut triangles = vec![];
    // glTF forbids a node to stand below itself, but its reader does not look.
    let mut left = 100_000;
    let mut waiting: Vec<(gltf::Node<'_>, Mat4)> = scene.nodes().map(|n| (n, Mat4::IDENTITY)).collect();
    while let Some((node, outer)) = waiting.pop() {
        left -= 1;
        if left == 0 {
            return Err("has too many nodes".into());
        }
        let to_scene = outer * Mat4::from_cols_array_2d(&node.transform().matrix());
        for primitive in node.mesh().iter().flat_map(gltf::Mesh::primitives) {
            triangles.extend(self::primitive(&primitive, blob, to_scene)?);
        }
        waiting.extend(node.children().map(|child| (child, to_scene)));
    }
    Ok(triangles)
}

fn primitive(
    primitive: &gltf::Primitive<'_>,
    blob: &[u8],
    to_scene: Mat4,
) -> Result<Vec<[Found; 3]>, String> {
    let reader = primitive.reader(|_| Some(blob));
    let Some(positions) = reader.read_positions() else { return Ok(vec![]) };
    let positions: Vec<Vec3> = positions.map(|p| to_scene.transform_point3(p.into())).collect();
    let turned = Mat3::from_mat4(to_scene).inverse().transpose();
    let normals: Vec<Vec3> =
        reader.read_normals().map_or(vec![], |all| all.map(|n| turned * Vec3::from(n)).collect());
    // glTF counts v from the top of an image.
    let uvs: Vec<Vec2> = reader
        .read_tex_coords(0)
        .map_or(vec![], |all| all.into_f32().map(|[u, v]| Vec2::new(u, 1.0 - v)).collect());
    let corner = |index: u32| {
        let i = index as usize;
        let position = *positions.get(i)?;
        Some(Found { position, normal: normals.get(i).copied(), uv: uvs.get(i).copied() })
    };
    let indices: Vec<u32> = match reader.read_indices() {
        Some(indices) => indices.into_u32().collect(),
        None => (0..positions.len() as u32).collect(),
    };
    let mirrors = to_scene.determinant() < 0.0;
    let mut triangles = vec![];
    for [a, b, c] in faces(primitive.mode(), &indices) {
        let [b, c] = if mirrors { [c, b] } else { [b, c] };
        let [Some(a), Some(b), Some(c)] = [a, b, c].map(corner) else {
            return Err("is damaged: a face has a corner that the file does not have".into());
        };
        triangles.push([a, b, c]);
    }
    Ok(triangles)
}

/// Points and lines have none.
fn faces(mode: Mode, indices: &[u32]) -> Vec<[u32; 3]> {
    match mode {
        Mode::Triangles => indices.chunks_exact(3).map(|t| [t[0], t[1], t[2]]).collect(),
        Mode::TriangleFan => indices.windows(2).skip(1).map(|t| [indices[0], t[0], t[1]]).collect(),
        Mode::TriangleStrip => {
            let turned = |(i, t): (usize, &[u32])| {
                if i % 2 == 0 { [t[0], t[1], t[2]] } else { [t[1], t[0], t[2]] }
            };
            indices.windows(3).enumerate().map(turned).collect()
        }
        Mode::Points | Mode::Lines | Mode::LineLoop | Mode::LineStrip => vec![],
    }
}
