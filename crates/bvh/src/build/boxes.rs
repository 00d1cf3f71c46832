//! The tree over boxes: which boxes it takes, and its leaves, which are runs of primitives.
use raggio_math::Aabb;

use super::Tree;
use super::bins::Cost;
use super::eight::Builder;
use super::prims::{Bounds, Prim};
use crate::kernel;
use crate::node::MAX_LEAF;
use crate::round::{down, up};
use crate::traverse::Bvh;

/// Sides beyond this do not fit the single-precision boxes.
const REACH: f64 = 1e30;

/// A tree and what it could not take.
pub struct Built {
    /// The tree over all bounded boxes.
    pub bvh: Bvh,
    /// Boxes with an infinite (or hopelessly far) side, in order: to be asked one by one.
    pub unbounded: Vec<u32>,
}

/// Runs of primitives.
pub(super) struct Runs;

impl Cost for Runs {
    const FEWEST_BINS: usize = 8;

    /// Asking a primitive takes so much longer than visiting a node that only the primitives count.
    #[inline(always)]
    fn cost(count: u32) -> f32 {
        count as f32
    }
}

impl Bvh {
    /// Builds a tree over boxes; a primitive is its index in `boxes`. Empty boxes are left out, unbounded ones handed
    /// back. `leaf_size` (at most 8) is how many primitives may share a leaf: 1 for costly ones, more for cheap ones.
    pub fn build(boxes: &[Aabb], leaf_size: usize) -> Built {
        Bvh::build_by(boxes.len(), |i| boxes[i], leaf_size)
    }

    /// [`Bvh::build`] over boxes that are made one by one.
    pub fn build_by(count: usize, boxes: impl Fn(usize) -> Aabb, leaf_size: usize) -> Built {
        let mut unbounded = Vec::new();
        let mut prims = Vec::with_capacity(count);
        for (number, b) in (0..count).map(boxes).enumerate().filter(|(_, b)| !b.is_empty()) {
            match b.min.min_element() > -REACH && b.max.max_element() < REACH {
                true => prims.push(Prim::new(enclosing(&b), number as u32)),
                false => unbounded.push(number as u32),
            }
        }
        let Tree { nodes, leaves } = Builder { size: leaf_size.clamp(1, MAX_LEAF) }.build(prims);
        Built { bvh: Bvh { nodes, prims: leaves, simd: kernel::simd_available() }, unbounded }
    }
}

fn enclosing(b: &Aabb) -> Bounds {
    Bounds {
        lo: [down(b.min.x), down(b.min.y), down(b.min.z), 0.0],
        hi: [up(b.max.x), up(b.max.y), up(b.max.z), 0.0],
    }
}

#[cfg(test)]
mod tests {
    use raggio_math::Vec3;

    use super::*;

    /// Large trees are built in parts, by all threads.
    #[test]
    #[cfg_attr(miri, ignore = "takes hours there")]
    fn large_trees_are_the_same_for_any_number_of_threads_and_hold_every_box() {
        let count = 40_000;
        let boxes: Vec<Aabb> = (0..count)
            .map(|i| {
                let f = f64::from(i);
                let c = Vec3::new((f * 0.618).fract(), (f * 0.7548).fract(), (f * 0.5698).fract());
                Aabb::new(c, c + Vec3::splat(0.01))
            })
            .collect();
        let built = |threads: usize, leaf: usize| {
            let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build().expect("threads");
            pool.install(|| Bvh::build(&boxes, leaf).bvh)
        };
        for leaf in [1, 2] {
            let (one, three) = (built(1, leaf), built(3, leaf));
            let nodes =
                |bvh: &Bvh| bvh.nodes.iter().map(|node| (node.bounds, node.child)).collect::<Vec<_>>();
            assert!(nodes(&one) == nodes(&three) && one.prims == three.prims);
            for i in (0..count).step_by(997) {
                let at = boxes[i as usize].min + Vec3::splat(0.005);
                assert!(one.containing(at, |prim| prim == i as u32), "{i}");
            }
            let mut listed = one.prims.clone();
            listed.sort_unstable();
            assert!(listed.into_iter().eq(0..count as u32));
        }
    }
}
