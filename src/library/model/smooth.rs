//! What a file leaves out: normals of a smooth surface, and uv.

use std::collections::HashMap;

use glam::{Vec2, Vec3};

use super::{Corner, Found, facet, place};

/// Gives each corner a normal and uv. Where the file has no normal it is the mean of the triangles that meet
/// there, each as much as its angle (Thürrner and Wüthrich, Computing Vertex Normals from Polygonal Facets,
/// 1998); where it has no uv, the triangle is seen along its dominant axis, as a box's faces are.
pub fn finish(triangles: &[[Found; 3]]) -> Vec<[Corner; 3]> {
    let mut means: HashMap<[u32; 3], Vec3> = HashMap::new();
    for triangle in triangles {
        let at = triangle.map(|corner| corner.position);
        let normal = facet(at);
        for i in 0..3 {
            let sides = [at[(i + 1) % 3] - at[i], at[(i + 2) % 3] - at[i]];
            *means.entry(place(at[i])).or_default() += sides[0].angle_between(sides[1]) * normal;
        }
    }
    let corner = |corner: &Found, flat: Vec3| {
        let mean = || means.get(&place(corner.position)).copied().unwrap_or(flat);
        let given = corner.normal.and_then(Vec3::try_normalize);
        let normal = given.unwrap_or_else(|| mean().try_normalize().unwrap_or(flat));
        // A file may have its normals on the other side of its triangles. The triangles count.
        let normal = if normal.dot(flat) < 0.0 { -normal } else { normal };
        let uv = corner.uv.unwrap_or_else(|| seen_along(flat, corner.position));
        Corner { position: corner.position, normal, uv }
    };
    let finished = triangles.iter().map(|triangle| {
        let flat = facet(triangle.map(|c| c.position));
        [0, 1, 2].map(|i| corner(&triangle[i], flat))
    });
    finished.collect()
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
