//! The tree over triangles: its leaves are blocks.
use std::collections::HashSet;
use std::marker::PhantomData;

use rayon::prelude::*;

use super::Block;
use crate::build::{self, Bounds, Cost, LARGE, Leaves, Prim, Tree};
use crate::node::Node;

type V3 = [f32; 3];

struct Triangles<'a, B> {
    vertices: &'a [V3],
    corners: &'a [[u32; 3]],
    kind: PhantomData<B>,
}

/// Do so few triangles meet in a corner that they had better keep their corners each? Where there are many corners
/// they are judged by a sample.
pub(super) fn loose(vertices: &[V3], corners: &[[u32; 3]]) -> bool {
    if vertices.len() < corners.len() {
        return false;
    }
    // One place in so many is looked at, with all corners that lie there.
    let share = (corners.len() >> 12).max(1).next_power_of_two() as u64;
    let mut places = HashSet::new();
    let mut count = 0;
    for &corner in corners.iter().flatten() {
        let [x, y, z] = vertices[corner as usize].map(|c| u64::from(c.to_bits()));
        let mixed = (x ^ y.rotate_left(21) ^ z.rotate_left(42)).wrapping_mul(0x9e37_79b9_7f4a_7c15) >> 32;
        if mixed & (share - 1) == 0 {
            count += 1;
            places.insert([x, y, z]);
        }
    }
    count < 2 * places.len()
}

/// A tree over triangles, and a box around them.
pub(super) fn build<B: Block>(vertices: &[V3], corners: &[[u32; 3]]) -> (Tree<B>, Bounds) {
    let triangles = Triangles::<B> { vertices, corners, kind: PhantomData };
    let prim = |i: usize| triangles.prim(i);
    let prims: Vec<Prim> = match corners.len() < LARGE {
        true => (0..corners.len()).map(prim).collect(),
        false => (0..corners.len()).into_par_iter().map(prim).collect(),
    };
    let (mut tree, bounds) = build::build(&triangles, prims);
    if tree.nodes.is_empty() {
        tree.nodes.push(Node::EMPTY);
        return (tree, Bounds::EMPTY);
    }
    (tree, bounds)
}

impl<B: Block> Triangles<'_, B> {
    fn corners(&self, triangle: usize) -> [V3; 3] {
        self.corners[triangle].map(|corner| self.vertices[corner as usize])
    }

    #[inline(always)]
    fn prim(&self, triangle: usize) -> Prim {
        let mut bounds = Bounds::EMPTY;
        for corner in &self.corners(triangle) {
            let p = [corner[0], corner[1], corner[2], 0.0];
            bounds.grow(&Bounds { lo: p, hi: p });
        }
        Prim::new(bounds, triangle as u32)
    }
}

impl<B: Block> Cost for Triangles<'_, B> {
    const FEWEST_BINS: usize = 4;

    /// Counts blocks, so that leaves come out full.
    #[inline(always)]
    fn cost(count: u32) -> f32 {
        B::NODE_COST + count.div_ceil(B::LANES as u32) as f32
    }
}

impl<B: Block> Leaves for Triangles<'_, B> {
    type Leaf = B;

    fn size(&self) -> usize {
        B::LANES
    }

    fn room(&self, count: usize) -> usize {
        count / 2 + 1
    }

    fn leaf(&self, prims: &[Prim]) -> Option<B> {
        let triangle = |prim: &Prim| (prim.number(), self.corners[prim.number() as usize]);
        B::of(prims.iter().map(triangle), self.vertices)
    }
}
