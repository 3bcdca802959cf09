//! A bounding volume hierarchy (BVH): a tree of boxes in which every node says where a ray goes on.
//!
//! In: boxes. Out: [`Bvh`].

use glam::Vec3;
use obvhs::aabb::Aabb;
use obvhs::bvh2::leaf_collapser::collapse;
use obvhs::bvh2::reinsertion::ReinsertionOptimizer;
use obvhs::ploc::{PlocBuilder, PlocSearchDistance, SortPrecision};

/// A tree of boxes. Its leaves name ranges of `order`.
#[derive(Clone, Debug)]
pub struct Bvh {
    /// The indices of the boxes that it was built over, in the order of the leaves.
    pub order: Vec<u32>,
    /// The root first.
    pub nodes: Vec<Node>,
}

/// A box of the tree.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Node {
    pub low: Vec3,
    /// Its first child, which the other one follows, or the first of its boxes in [`Bvh::order`].
    pub first: u32,
    pub high: Vec3,
    /// How many boxes it has, none if it has children; bit 8 + o says that the second child is the nearer
    /// for directions of octant o.
    pub shape: u32,
    /// Where a ray of each octant goes on when it is done with the node, [`END`] if nowhere. So it meets near
    /// boxes first and needs no stack (Hachisuka, Multiple-Threaded BVH, in: Implementing a Photorealistic
    /// Rendering System using GLSL, 2015). Bit 0 of an octant says that x falls, bit 1 y, bit 2 z.
    pub next: [u32; 8],
}

/// Boxes in a leaf: a ray asks for what is in all of them.
const MAX_IN_LEAF: u32 = 4;

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

/// Builds the tree over `boxes`, each given by its low and its high corner; there must be at least one.
pub fn build(boxes: &[[Vec3; 2]]) -> Bvh {
    let boxes: Vec<Aabb> = boxes.iter().map(|[low, high]| Aabb::new((*low).into(), (*high).into())).collect();
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
    collapse(&mut tree, MAX_IN_LEAF, 3.0);
    optimizer.run(&mut tree, 0.1, None);
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
    Bvh { order: tree.primitive_indices, nodes }
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
