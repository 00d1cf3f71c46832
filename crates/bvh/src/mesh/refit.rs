//! Moving the vertices of a mesh under a tree that is there already, as for the next frame of an animation.
use rayon::prelude::*;

use super::{Block, LEAF, MeshBvh, block};
use crate::build::LARGE;
use crate::node::WIDTH;

impl MeshBvh {
    /// Takes new places of the vertices; the triangles must be those that it was built over. Takes a fraction of the time
    /// of building. Answers are as right as those of a new tree, but take longer the less alike the places are.
    pub fn refit(&mut self, vertices: &[[f32; 3]], triangles: &[[u32; 3]]) {
        let whole = with_blocks!(&mut self.blocks, list => {
            let both = |a: bool, b: bool| a & b;
            match triangles.len() < LARGE {
                true => list.iter_mut().map(|block| block.refit(vertices, triangles)).fold(true, both),
                false => list.par_iter_mut().map(|block| block.refit(vertices, triangles)).reduce(|| true, both),
            }
        });
        // Corners that had one place and part want other blocks.
        if !whole {
            *self = MeshBvh::build(vertices, triangles);
            return;
        }
        // Children come after their parents.
        for at in (0..self.nodes.len()).rev() {
            for slot in 0..WIDTH {
                let node = &self.nodes[at];
                let (unused, word) = (node.bounds[0][slot] > node.bounds[3][slot], node.child[slot]);
                if unused {
                    continue;
                }
                let bounds = match word & LEAF {
                    0 => self.node(word).bounds(),
                    _ => with_blocks!(&self.blocks, list => block(list, word).bounds()),
                };
                self.nodes[at].set_bounds(slot, &bounds);
            }
        }
        self.bounds = self.nodes[0].bounds();
    }
}
