//! The tree of boxes over a model's triangles, in which every node says where a ray goes on.

use glam::Vec3;
use obvhs::aabb::Aabb;
use obvhs::bvh2::leaf_collapser::collapse;
use obvhs::bvh2::reinsertion::ReinsertionOptimizer;
use obvhs::ploc::{PlocBuilder, PlocSearchDistance, SortPrecision};

use super::Corner;

/// A box.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Node {
    pub low: Vec3,
    /// Its first child, which the other one follows, or its first triangle.
    pub first: u32,
    pub high: Vec3,
    /// How many triangles it has, none if it has children; bit 8 + o says that the second child is the nearer
    /// for directions of octant o.
    pub shape: u32,
    /// Where a ray of each octant goes on when it is done with the node, [`END`] if nowhere. So it meets near
    /// boxes first and needs no stack (Hachisuka, Multiple-Threaded BVH, in: Implementing a Photorealistic
    /// Rendering System using GLSL, 2015). Bit 0 of an octant says that x falls, bit 1 y, bit 2 z.
    pub next: [u32; 8],
}

/// Triangles in a leaf: a ray asks all of them.
const MOST_IN_LEAF: u32 = 4;

/// There is no such node.
pub const END: u32 = u32::MAX;

impl Node {
    pub fn is_leaf(&self) -> bool {
        self.shape & 0xff != 0
    }

    fn center(&self) -> Vec3 {
        0.5 * (self.low + self.high)
    }
}

/// The triangles in the order of the leaves, and the nodes.
pub fn plant(triangles: &[[Corner; 3]]) -> (Vec<[Corner; 3]>, Vec<Node>) {
    let boxes: Vec<Aabb> = triangles
        .iter()
        .map(|triangle| Aabb::from_points(&triangle.map(|corner| corner.position.into())))
        .collect();
    // As obvhs::bvh2::builder does for BvhBuildParams::medium_build, but for its check, which takes longer
    // than the tree and panics.
    let mut tree = PlocBuilder::with_capacity(boxes.len()).build(
        PlocSearchDistance::Medium,
        &boxes,
        (0..boxes.len() as u32).collect(),
        SortPrecision::U64,
        3,
    );
    let mut optimizer = ReinsertionOptimizer::default();
    optimizer.run(&mut tree, 0.05, None);
    collapse(&mut tree, MOST_IN_LEAF, 3.0);
    optimizer.run(&mut tree, 0.1, None);
    let ordered = tree.primitive_indices.iter().map(|i| triangles[*i as usize]).collect();
    let mut nodes: Vec<Node> = tree
        .nodes
        .iter()
        .map(|node| Node {
            low: node.aabb().min.into(),
            first: node.first_index,
            high: node.aabb().max.into(),
            shape: node.prim_count,
            next: [END; 8],
        })
        .collect();
    thread(&mut nodes);
    (ordered, nodes)
}

/// Tells each node which child is the nearer, and where rays go on.
fn thread(nodes: &mut [Node]) {
    let mut waiting = vec![0];
    while let Some(at) = waiting.pop() {
        let node = nodes[at];
        if node.is_leaf() {
            continue;
        }
        let children = [node.first as usize, node.first as usize + 1];
        let across = nodes[children[1]].center() - nodes[children[0]].center();
        for octant in 0..8 {
            let sign = |bit: u32| if octant >> bit & 1 == 1 { -1.0 } else { 1.0 };
            let second_first = across.dot(Vec3::new(sign(0), sign(1), sign(2))) < 0.0;
            let [near, far] = if second_first { [children[1], children[0]] } else { children };
            nodes[at].shape |= u32::from(second_first) << (8 + octant);
            nodes[near].next[octant] = far as u32;
            nodes[far].next[octant] = node.next[octant];
        }
        waiting.extend(children);
    }
}
