//! What a file leaves out: normals of a smooth surface, and uv.
//!
//! In: triangles as they are read. Out: the same with all that a corner has.

use glam::{Vec2, Vec3};

use super::{Corner, Found, facet, places};

/// Gives each corner a normal and uv. Where the file has no normal it is the mean of the triangles that meet
/// there, each as much as its angle (Thürrner and Wüthrich, Computing Vertex Normals from Polygonal Facets,
/// 1998); where it has no uv, the triangle is seen along its dominant axis, as a box's faces are.
pub fn finish(triangles: &[[Found; 3]]) -> Vec<[Corner; 3]> {
    let (numbers, count) = places::numbered(triangles);
    let facets: Vec<Vec3> = triangles.iter().map(|t| facet(t.map(|corner| corner.position))).collect();
    let mut means = vec![Vec3::ZERO; count];
    for ((triangle, numbers), facet) in triangles.iter().zip(&numbers).zip(&facets) {
        if *facet == Vec3::ZERO {
            continue;
        }
        let at = triangle.map(|corner| corner.position);
        for (i, number) in numbers.iter().enumerate() {
            // With length 1, that their squares are neither nothing nor endless.
            let sides = [1, 2].map(|k| (at[(i + k) % 3] - at[i]).normalize_or_zero());
            means[*number] += sides[0].angle_between(sides[1]) * *facet;
        }
    }
    let corner = |corner: &Found, flat: Vec3, mean: Vec3| {
        let given = corner.normal.and_then(Vec3::try_normalize);
        let normal = given.unwrap_or_else(|| mean.try_normalize().unwrap_or(flat));
        // A file may have its normals on the other side of its triangles. The triangles count.
        let normal = if normal.dot(flat) < 0.0 { -normal } else { normal };
        let uv = corner.uv.unwrap_or_else(|| seen_along(flat, corner.position));
        Corner { position: corner.position, normal, uv }
    };
    let finished =
        triangles.iter().zip(&numbers).zip(&facets).map(|((triangle, numbers), flat)| {
            [0, 1, 2].map(|i| corner(&triangle[i], *flat, means[numbers[i]]))
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
