//! The triangle mesh room: a hierarchy over triangles in single precision, as fast as the machine allows.
//!
//! Nodes have eight children with full-precision boxes, leaves hold one block of up to four triangles. The triangle
//! test is watertight (Woop, Benthin, Wald: "Watertight Ray/Triangle Intersection", JCGT 2013): edge functions of a
//! shared edge are exact negatives of each other, so no ray slips through between two triangles. The box test subtracts
//! before it scales and widens the far side by its own rounding error (Ize: "Robust BVH Ray Traversal", JCGT 2013).
//!
//! [`scalar`] says what the answer is; [`avx2`] gives the same hits with wide instructions where the machine has them.

mod avx2;
mod build;
mod scalar;

use crate::mesh::build::Builder;

/// A ray in single precision with the range that counts.
#[derive(Clone, Copy, Debug, PartialEq)]
#[repr(C, align(32))]
pub struct MeshRay {
    /// Where it starts.
    pub origin: [f32; 3],
    /// Hits nearer than this do not count.
    pub t_min: f32,
    /// Where it goes; any length but 0.
    pub dir: [f32; 3],
    /// Hits farther than this do not count.
    pub t_max: f32,
}

/// The nearest triangle on a ray.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct MeshHit {
    /// Ray parameter.
    pub t: f32,
    /// Index of the triangle as given to [`MeshBvh::build`].
    pub triangle: u32,
}

/// Eight boxes and what is in them. Unused children have boxes that nothing hits.
#[derive(Clone, Copy, Debug)]
#[repr(C, align(32))]
pub(crate) struct Node {
    /// Least corners, one row an axis, then greatest corners: rows 0..3 and 3..6.
    pub bounds: [[f32; 8]; 6],
    /// [`Child`] words.
    pub child: [u32; 8],
}

/// Up to four triangles; unused lanes repeat the first one.
#[derive(Clone, Copy, Debug)]
#[repr(C, align(16))]
pub(crate) struct Block {
    /// `corner[k][axis][lane]`
    pub corner: [[[f32; 4]; 3]; 3],
    /// Index of each triangle.
    pub triangle: [u32; 4],
}

/// Marks a child word as a leaf: the rest is the index of its [`Block`].
pub(crate) const LEAF: u32 = 1 << 31;

/// No traversal keeps more than this many children waiting: depth is bounded by the builder.
pub(crate) const STACK: usize = build::MAX_DEPTH * 7 + 8;

/// A search structure over the triangles of a mesh.
#[derive(Debug)]
pub struct MeshBvh {
    pub(crate) nodes: Vec<Node>,
    pub(crate) blocks: Vec<Block>,
    root: u32,
    wide: bool,
}

impl MeshBvh {
    /// Builds over triangles given by indices into `vertices`. Coordinates must be finite.
    pub fn build(vertices: &[[f32; 3]], triangles: &[[u32; 3]]) -> MeshBvh {
        let (nodes, blocks, root) = Builder::new(vertices, triangles).build();
        MeshBvh { nodes, blocks, root, wide: avx2::available() }
    }

    /// The size of the whole structure in bytes.
    pub fn bytes(&self) -> usize {
        size_of_val(&self.nodes[..]) + size_of_val(&self.blocks[..])
    }

    /// The nearest triangle with `t_min <= t <= t_max`.
    #[inline]
    pub fn closest(&self, ray: &MeshRay) -> Option<MeshHit> {
        if self.wide { avx2::closest(self, self.root, ray) } else { scalar::closest(self, self.root, ray) }
    }

    /// Is there any triangle with `t_min <= t <= t_max`?
    #[inline]
    pub fn any(&self, ray: &MeshRay) -> bool {
        if self.wide { avx2::any(self, self.root, ray) } else { scalar::any(self, self.root, ray) }
    }
}
