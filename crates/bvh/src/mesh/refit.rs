//! Moving the vertices of a mesh under a tree that is there already, as for the next frame of an animation.
use raggio_math::Aabb;
use rayon::prelude::*;

use super::{Block, LEAF, MeshBvh};
use crate::build::Bounds;
use crate::node::WIDTH;

impl MeshBvh {
    /// Takes new places of the vertices; the triangles must be those that it was built over. Takes a fraction of the time
    /// of building. Answers are as right as those of a new tree, but take longer the less alike the places are.
    pub fn refit(&mut self, vertices: &[[f32; 3]], triangles: &[[u32; 3]]) {
        self.blocks.par_iter_mut().for_each(|block| block.refit(vertices, triangles));
        // Children come after their parents.
        for at in (0..self.nodes.len()).rev() {
            for slot in 0..WIDTH {
                let node = &self.nodes[at];
                let (unused, word) = (node.bounds[0][slot] > node.bounds[3][slot], node.child[slot]);
                if unused {
                    continue;
                }
                let bounds =
                    if word & LEAF == 0 { self.node(word).bounds() } else { self.block(word).bounds() };
                self.nodes[at].set_bounds(slot, &bounds);
            }
        }
        self.bounds = self.nodes[0].children().fold(Aabb::EMPTY, |all, (b, _)| all.union(&b));
    }
}

impl Block {
    fn refit(&mut self, vertices: &[[f32; 3]], triangles: &[[u32; 3]]) {
        for (lane, &triangle) in self.triangle.iter().enumerate().filter(|(_, t)| **t != u32::MAX) {
            for (rows, &vertex) in self.corner.iter_mut().zip(&triangles[triangle as usize]) {
                for (row, &value) in rows.iter_mut().zip(&vertices[vertex as usize]) {
                    row[lane] = value;
                }
            }
        }
    }

    fn bounds(&self) -> Bounds {
        let mut bounds = Bounds::EMPTY;
        for lane in (0..self.triangle.len()).filter(|&lane| self.triangle[lane] != u32::MAX) {
            for rows in &self.corner {
                let p = [rows[0][lane], rows[1][lane], rows[2][lane], 0.0];
                bounds.grow(&Bounds { lo: p, hi: p });
            }
        }
        bounds
    }
}
