//! Wavefront OBJ: all of its groups as one list of triangles; materials are the scene's business.

use glam::{Vec2, Vec3};

use super::Found;

/// # Errors
/// Why it is no such file, in words that follow its name.
pub fn read(mut bytes: &[u8]) -> Result<Vec<[Found; 3]>, String> {
    let options = tobj::LoadOptions {
        triangulate: true,
        ignore_points: true,
        ignore_lines: true,
        ..Default::default()
    };
    let no_materials = |_: &std::path::Path| Ok(Default::default());
    let (groups, _) = tobj::load_obj_buf(&mut bytes, &options, no_materials)
        .map_err(|error| format!("is neither OBJ nor binary glTF: {error}"))?;
    let mut triangles = vec![];
    for group in groups {
        let mesh = &group.mesh;
        let corner = |i: usize| {
            let position = Vec3::from_slice(numbers(&mesh.positions, mesh.indices[i], 3)?);
            let normal = mesh.normal_indices.get(i).and_then(|n| numbers(&mesh.normals, *n, 3));
            let uv = mesh.texcoord_indices.get(i).and_then(|n| numbers(&mesh.texcoords, *n, 2));
            Some(Found { position, normal: normal.map(Vec3::from_slice), uv: uv.map(Vec2::from_slice) })
        };
        for first in (0..mesh.indices.len() / 3).map(|n| 3 * n) {
            let corners = [corner(first), corner(first + 1), corner(first + 2)];
            let [Some(a), Some(b), Some(c)] = corners else {
                return Err("is damaged: a face has a corner that the file does not have".into());
            };
            triangles.push([a, b, c]);
        }
    }
    Ok(triangles)
}

/// The `index`-th `size` numbers.
fn numbers(all: &[f32], index: u32, size: usize) -> Option<&[f32]> {
    let first = index as usize * size;
    all.get(first..first + size)
}
