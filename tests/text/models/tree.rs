//! The tree of boxes: rays of each octant come by all triangles, once, and find the way out.

use glam::Vec3;
use raytoy::assets::Model;

use super::random::Random;
use super::{decoded, shapes};

/// There is no such node.
const END: u32 = u32::MAX;

#[test]
fn rays_of_each_octant_come_by_all_triangles() {
    for name in shapes::MODELS {
        if let Some(text) = shapes::made(name) {
            check(&decoded(text.as_bytes()).unwrap()).unwrap_or_else(|why| panic!("{name}: {why}"));
        }
    }
}

#[test]
fn triangles_that_lie_upon_each_other_have_leaves() {
    // All in one box: from corner to corner, and to a point anywhere in it.
    for count in [1, 2, 5, 3000] {
        let mut text = "v 0 0 0\nv 1 1 1\n".to_owned();
        for i in 0..count {
            let share = (i as f32 + 0.5) / count as f32;
            text += &format!("v {share} {} 0.25\nf 1 2 {}\n", 1.0 - share, i + 3);
        }
        let model = decoded(text.as_bytes()).unwrap();
        assert_eq!(model.triangles.len(), count);
        check(&model).unwrap_or_else(|why| panic!("{count}: {why}"));
    }
    let same = "v 0 0 0\nv 1 0 0\nv 0 1 0\n".to_owned() + &"f 1 2 3\n".repeat(100_000);
    assert_eq!(decoded(same.as_bytes()).unwrap().triangles.len(), 1);
}

#[test]
fn models_of_any_size_have_a_tree() {
    let mut random = Random(2);
    for size in [1e-12, 1e-3, 1.0, 1e9] {
        let mut text = String::new();
        for _ in 0..300 {
            let p = random.unit() * random.share() * size;
            text += &format!("v {:e} {:e} {:e}\n", p.x, p.y, p.z);
        }
        (1..299).for_each(|i| text += &format!("f {i} {} {}\n", i + 1, i + 2));
        check(&decoded(text.as_bytes()).unwrap()).unwrap_or_else(|why| panic!("{size}: {why}"));
    }
}

/// Whether all that shaders/model.wgsl relies on holds.
///
/// # Errors
/// What does not.
pub fn check(model: &Model) -> Result<(), String> {
    if model.triangles.is_empty() {
        return Err("no triangles".into());
    }
    for corner in model.triangles.iter().flatten() {
        let is_unit = (corner.normal.length() - 1.0).abs() < 1e-4 || corner.normal == Vec3::ZERO;
        if !(corner.position.is_finite() && corner.uv.is_finite() && is_unit) {
            return Err(format!("{corner:?}"));
        }
    }
    (0..8).try_for_each(|octant| walk(model, octant))
}

/// Goes as a ray goes that meets every box.
fn walk(model: &Model, octant: usize) -> Result<(), String> {
    let mut times_met = vec![0; model.triangles.len()];
    let (mut at, mut steps) = (0, 0);
    while at != END {
        steps += 1;
        if steps > 2 * model.nodes.len() {
            return Err(format!("octant {octant} goes round in circles"));
        }
        let node = model.nodes[at as usize];
        if !node.is_leaf() {
            at = node.first + (node.shape >> (8 + octant) & 1);
            continue;
        }
        let count = node.shape & 0xff;
        if count > 8 {
            return Err(format!("a leaf of {count} triangles"));
        }
        for i in node.first..node.first + count {
            times_met[i as usize] += 1;
            let corners = model.triangles[i as usize].map(|corner| corner.position);
            let is_inside = |p: Vec3| p.cmpge(node.low).all() && p.cmple(node.high).all();
            if !corners.into_iter().all(is_inside) {
                return Err(format!("triangle {i} lies beyond its box"));
            }
        }
        at = node.next[octant];
    }
    match times_met.iter().position(|times| *times != 1) {
        Some(i) => Err(format!("octant {octant} comes by triangle {i} {} times", times_met[i])),
        None => Ok(()),
    }
}
