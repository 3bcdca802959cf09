//! Polygons as triangles, also those with corners that point inward.
//!
//! In: corners in order. Out: triangles as indices of corners, turned as the polygon is.

use glam::{DVec2, DVec3};

/// Larger polygons are taken as convex: the search for ears takes the square of their corners and more.
const MAX_CORNERS: usize = 1000;

/// Cuts off one ear after the other: a corner whose triangle holds no other corner (Meisters, Polygons Have
/// Ears, 1975). A convex polygon becomes a fan around its first corner.
pub fn triangles(corners: &[DVec3]) -> Vec<[usize; 3]> {
    let mut rest: Vec<usize> = (0..corners.len()).collect();
    let mut found = vec![];
    if corners.len() <= MAX_CORNERS {
        let flat = flattened(corners);
        while rest.len() > 3 {
            let Some(ear) = (1..=rest.len()).find(|i| is_ear(&flat, &rest, i % rest.len())) else { break };
            let ear = ear % rest.len();
            found.push(around(&rest, ear));
            rest.remove(ear);
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

fn is_ear(flat: &[DVec2], rest: &[usize], at: usize) -> bool {
    let triangle = around(rest, at).map(|i| flat[i]);
    let [a, b, c] = triangle;
    let is_inside = |p: DVec2| {
        let sides = [(a, b), (b, c), (c, a)].map(|(from, to)| (to - from).perp_dot(p - from));
        sides.iter().all(|side| *side >= 0.0) && !triangle.contains(&p)
    };
    (b - a).perp_dot(c - b) > 0.0 && !rest.iter().any(|i| is_inside(flat[*i]))
}
