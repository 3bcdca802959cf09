//! What a file leaves out: normals of a smooth surface, and uv.
//!
//! In: triangles as they are read. Out: the same with all that a corner has.

use glam::{Vec2, Vec3};

use super::found::{Face, Found};
use super::{Corner, geometric_normal, places, surfaces};

/// Gives each corner a normal and uv. Where the file has no normal it is the mean of the triangles of its
/// surface that meet there, each as much as its angle (Thürrner and Wüthrich, Computing Vertex Normals
/// from Polygonal Facets, 1998); where it has no uv, the triangle is seen along its dominant axis, as a
/// box's faces are.
pub fn finish(faces: &[Face]) -> Vec<[Corner; 3]> {
    let positions = |face: &Face| face.corners.map(|corner| corner.position.as_vec3());
    let geometric_normals: Vec<Vec3> = faces.iter().map(|face| geometric_normal(positions(face))).collect();
    let lacks_normal = |corner: &Found| given_normal(corner).is_none();
    let means = match faces.iter().flat_map(|face| &face.corners).any(lacks_normal) {
        true => means(faces, &geometric_normals),
        false => vec![],
    };
    let corner = |corner: &Found, flat: Vec3, mean: Option<Vec3>| {
        let normal = given_normal(corner).or(mean.and_then(Vec3::try_normalize)).unwrap_or(flat);
        // A file may have its normals on the other side of its triangles. The triangles count.
        let normal = if normal.dot(flat) < 0.0 { -normal } else { normal };
        let position = corner.position.as_vec3();
        Corner { position, normal, uv: corner.uv.unwrap_or_else(|| seen_along(flat, position)) }
    };
    let finished = faces.iter().zip(&geometric_normals).enumerate().map(|(n, (face, flat))| {
        [0, 1, 2].map(|i| corner(&face.corners[i], *flat, means.get(n).map(|means| means[i])))
    });
    finished.collect()
}

fn given_normal(corner: &Found) -> Option<Vec3> {
    corner.normal.and_then(Vec3::try_normalize)
}

/// For each corner the mean of the triangles of its surface that meet there.
fn means(faces: &[Face], geometric_normals: &[Vec3]) -> Vec<[Vec3; 3]> {
    let surfaces = surfaces::numbered(faces, geometric_normals, &places::numbered(faces));
    let mut sums = vec![Vec3::ZERO; 3 * faces.len()];
    for ((face, surfaces), geometric_normal) in faces.iter().zip(&surfaces).zip(geometric_normals) {
        if *geometric_normal == Vec3::ZERO {
            continue;
        }
        let at = face.corners.map(|corner| corner.position.as_vec3());
        for (i, surface) in surfaces.iter().enumerate() {
            // With length 1, that their squares are neither nothing nor endless.
            let sides = [1, 2].map(|k| (at[(i + k) % 3] - at[i]).normalize_or_zero());
            sums[*surface] += sides[0].angle_between(sides[1]) * *geometric_normal;
        }
    }
    surfaces.iter().map(|surfaces| surfaces.map(|surface| sums[surface])).collect()
}

/// Along y: x and z. Along x: z and y. Along z: x and y.
fn seen_along(normal: Vec3, p: Vec3) -> Vec2 {
    let a = normal.abs();
    if a.y >= a.x.max(a.z) {
        Vec2::new(p.x, p.z)
    } else if a.x > a.z {
        Vec2::new(p.z, p.y)
    } else {
        Vec2::new(p.x, p.y)
    }
}
