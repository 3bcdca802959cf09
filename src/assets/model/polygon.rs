//! Polygons as triangles, also those with corners that point inward.
//!
//! In: corners in order. Out: triangles as indices of corners, turned as the polygon is.

use glam::{DVec2, DVec3};

/// Larger polygons are taken as convex: at worst, the search for ears takes the square of their corners and
/// more.
const MAX_CORNERS: usize = 1000;

/// Cuts off one ear after the other: a corner whose triangle holds no other corner (Meisters, Polygons Have
/// Ears, 1975). A convex polygon becomes a fan around its first corner.
pub fn triangles(corners: &[DVec3]) -> Vec<[usize; 3]> {
    let mut rest: Vec<usize> = (0..corners.len()).collect();
    let mut found = vec![];
    if corners.len() <= MAX_CORNERS {
        let flat = flattened(corners);
        // If a triangle holds corners, then one of them points inward.
        let mut inward: Vec<usize> =
            (0..rest.len()).filter(|at| !points_outward(&flat, &rest, *at)).collect();
        // Ears lie beside each other, so the search goes on at the last one.
        let mut from = 1;
        while rest.len() > 3 {
            let mut places = (from..from + rest.len()).map(|at| at % rest.len());
            let Some(ear) = places.find(|at| is_ear(&flat, &rest, &inward, *at)) else { break };
            let cut @ [before, _, after] = around(&rest, ear);
            found.push(cut);
            rest.remove(ear);
            for (corner, at) in [(before, ear + rest.len() - 1), (after, ear)] {
                if points_outward(&flat, &rest, at % rest.len()) {
                    inward.retain(|other| *other != corner);
                }
            }
            from = ear;
        }
    }
    // Three corners, or those of a polygon that crosses itself.
    found.extend((2..rest.len()).map(|i| [rest[0], rest[i - 1], rest[i]]));
    found
}

/// The polygon as its own normal sees it, against the clock.
fn flattened(corners: &[DVec3]) -> Vec<DVec2> {
    // Twice the area, along the normal, whatever the corners do (Newell's method).
    let next = corners.iter().cycle().skip(1);
    let normal: DVec3 = corners.iter().zip(next).map(|(a, b)| (*a - corners[0]).cross(*b - corners[0])).sum();
    let (u, v) = normal.normalize_or(DVec3::Z).any_orthonormal_pair();
    corners.iter().map(|p| DVec2::new(p.dot(u), p.dot(v))).collect()
}

/// A corner of what is left, between its neighbours.
fn around(rest: &[usize], at: usize) -> [usize; 3] {
    [rest[(at + rest.len() - 1) % rest.len()], rest[at], rest[(at + 1) % rest.len()]]
}

fn points_outward(flat: &[DVec2], rest: &[usize], at: usize) -> bool {
    let [a, b, c] = around(rest, at).map(|i| flat[i]);
    (b - a).perp_dot(c - b) > 0.0
}

/// Whether the triangle at `at` lies in the polygon and holds none of the corners that point `inward`.
fn is_ear(flat: &[DVec2], rest: &[usize], inward: &[usize], at: usize) -> bool {
    let triangle = around(rest, at).map(|i| flat[i]);
    let [a, b, c] = triangle;
    let is_inside = |p: DVec2| {
        let sides = [(a, b), (b, c), (c, a)].map(|(from, to)| (to - from).perp_dot(p - from));
        sides.iter().all(|side| *side >= 0.0) && !triangle.contains(&p)
    };
    points_outward(flat, rest, at) && !inward.iter().any(|i| is_inside(flat[*i]))
}
