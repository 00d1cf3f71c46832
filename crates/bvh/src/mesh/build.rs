//! The tree over triangles: its leaves are blocks of four.
use raggio_math::Aabb;
use rayon::prelude::*;

use super::{Block, LANES, LEAF};
use crate::build::{self, Bounds, LARGE, Leaves, Prim, Tree};
use crate::node::Node;

type V3 = [f32; 3];

/// What visiting a node costs, in tests of a block.
const NODE_COST: f32 = 1.0;

struct Triangles<'a> {
    vertices: &'a [V3],
    corners: &'a [[u32; 3]],
}

/// A tree over triangles, and a box around them.
pub(super) fn build(vertices: &[V3], corners: &[[u32; 3]]) -> (Tree<Block>, Aabb) {
    let triangles = Triangles { vertices, corners };
    let prim = |i: usize| triangles.prim(i);
    let prims: Vec<Prim> = match corners.len() < LARGE {
        true => (0..corners.len()).map(prim).collect(),
        false => (0..corners.len()).into_par_iter().map(prim).collect(),
    };
    let (mut tree, bounds) = build::build(&triangles, prims);
    if tree.nodes.is_empty() {
        tree.nodes.push(Node::EMPTY);
        return (tree, Aabb::EMPTY);
    }
    (tree, bounds.aabb())
}

impl Triangles<'_> {
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

impl Leaves for Triangles<'_> {
    type Leaf = Block;
    const FEWEST_BINS: usize = 4;
    const ALONE: bool = false;
    const SMALLEST_LAST: bool = true;

    fn size(&self) -> usize {
        LANES
    }

    fn room(&self, count: usize) -> usize {
        count / 2 + 1
    }

    /// Counts blocks, so that leaves come out full.
    #[inline(always)]
    fn cost(count: u32) -> f32 {
        NODE_COST + count.div_ceil(LANES as u32) as f32
    }

    fn add(&self, prims: &[Prim], leaves: &mut Vec<Block>) -> u32 {
        let mut block = Block { corner: [[[f32::NAN; LANES]; 3]; 3], triangle: [u32::MAX; LANES] };
        for (lane, prim) in prims.iter().enumerate() {
            block.triangle[lane] = prim.number();
            for (k, corner) in self.corners(prim.number() as usize).iter().enumerate() {
                for (row, &value) in block.corner[k].iter_mut().zip(corner) {
                    row[lane] = value;
                }
            }
        }
        leaves.push(block);
        LEAF | (leaves.len() - 1) as u32
    }

    fn moved(word: u32, by: usize) -> u32 {
        word + by as u32
    }
}
