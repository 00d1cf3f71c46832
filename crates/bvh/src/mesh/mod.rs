//! The triangle mesh room: a hierarchy over triangles in single precision, as fast as the machine allows.
//!
//! Nodes have eight children with full-precision boxes, leaves hold one block of a few triangles. The triangle test is
//! watertight (Woop, Benthin, Wald: "Watertight Ray/Triangle Intersection", JCGT 2013): edge functions of a shared edge
//! are exact negatives of each other, so no ray slips through between two triangles. The box test subtracts before it
//! scales and widens the far side by its own rounding error (Ize: "Robust BVH Ray Traversal", JCGT 2013).
//!
//! Rays come in either precision. Those in double are tested against the triangles in double, four at a time: such hits
//! need no refinement, and only the boxes are in single precision, with the ray rounded outwards.
//!
//! [`scalar`] says what the answer is; [`wide`] gives the same hits with wide instructions where the machine has them.

#[macro_use]
mod block;
#[cfg(target_arch = "x86_64")]
#[macro_use]
mod boxes;
#[cfg(target_arch = "x86_64")]
#[macro_use]
mod leaf;
#[cfg(target_arch = "x86_64")]
#[macro_use]
mod kernel;
#[cfg(target_arch = "x86_64")]
#[macro_use]
mod bundle;
mod build;
#[cfg(target_arch = "x86_64")]
mod coherent;
mod corners;
mod double;
#[cfg(target_arch = "x86_64")]
mod lanes;
mod packet;
mod refit;
mod scalar;
mod wide;

use raggio_math::{Aabb, Ray};

pub(crate) use block::{Block, Blocks};

use crate::build::{Bounds, MESH_DEPTH, Tree};
use crate::node::{Child, Node};

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

/// Where a ray in double precision meets a triangle.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct TriangleHit {
    /// The ray's parameter.
    pub t: f64,
    /// Index of the triangle as given to [`MeshBvh::build`].
    pub face: u32,
    /// Weight of the second corner.
    pub u: f64,
    /// Weight of the third corner.
    pub v: f64,
}

/// Marks a child word as a leaf: the rest is where its block is. All places are bytes from the first, by [`UNIT`].
pub(crate) const LEAF: u32 = Child::LEAF;

/// What the places in child words are multiples of: the largest factor that an address can have.
pub(crate) const UNIT: usize = 8;

/// Trees of more bytes are taken to be in no cache.
const CACHED: usize = 16 << 20;

/// The block that a leaf's word names.
pub(crate) fn block<B: Block>(blocks: &[B], word: u32) -> &B {
    &blocks[(word & !LEAF) as usize * UNIT / size_of::<B>()]
}

/// The word of the root.
pub(crate) const ROOT: u32 = 0;

/// No traversal keeps more than this many children waiting: depth is bounded by the builder.
pub(crate) const STACK: usize = MESH_DEPTH * 7 + 8;

/// A search structure over the triangles of a mesh.
#[derive(Debug)]
pub struct MeshBvh {
    pub(crate) nodes: Vec<Node>,
    pub(crate) blocks: Blocks,
    bounds: Bounds,
    isa: wide::Isa,
    /// Is most of it in no cache, so that rays had better call for their next nodes early?
    #[cfg_attr(not(target_arch = "x86_64"), allow(dead_code))]
    far_off: bool,
}

/// Sixteen rays that start close to each other and go much the same way.
#[derive(Clone, Copy, Debug)]
#[repr(C, align(64))]
pub struct Packet {
    /// `origin[axis][ray]`
    pub origin: [[f32; 16]; 3],
    /// `dir[axis][ray]`
    pub dir: [[f32; 16]; 3],
    /// See [`MeshRay::t_min`].
    pub t_min: [f32; 16],
    /// See [`MeshRay::t_max`].
    pub t_max: [f32; 16],
}

impl Packet {
    /// The rays side by side. A packet may be filled up with copies of a ray.
    pub fn new(rays: &[MeshRay; 16]) -> Packet {
        let spread = |f: &dyn Fn(&MeshRay) -> f32| std::array::from_fn(|i| f(&rays[i]));
        Packet {
            origin: std::array::from_fn(|axis| spread(&|r| r.origin[axis])),
            dir: std::array::from_fn(|axis| spread(&|r| r.dir[axis])),
            t_min: spread(&|r| r.t_min),
            t_max: spread(&|r| r.t_max),
        }
    }

    /// One of the rays.
    pub fn ray(&self, i: usize) -> MeshRay {
        let pick = |rows: &[[f32; 16]; 3]| [rows[0][i], rows[1][i], rows[2][i]];
        MeshRay {
            origin: pick(&self.origin),
            t_min: self.t_min[i],
            dir: pick(&self.dir),
            t_max: self.t_max[i],
        }
    }

    /// All of them. One that is read as soon as it is written would have to be waited for.
    fn rays(&self) -> [MeshRay; 16] {
        std::array::from_fn(|i| self.ray(i))
    }
}

/// The nearest triangles of a packet: infinity and `u32::MAX` where a ray hits nothing.
#[derive(Clone, Copy, Debug)]
#[repr(C, align(64))]
pub struct PacketHit {
    /// Ray parameters.
    pub t: [f32; 16],
    /// Indices of triangles.
    pub triangle: [u32; 16],
}

impl MeshBvh {
    /// Builds over triangles given by indices into `vertices`. Coordinates must be finite.
    pub fn build(vertices: &[[f32; 3]], triangles: &[[u32; 3]]) -> MeshBvh {
        match build::loose(vertices, triangles) {
            true => MeshBvh::of(build::build(vertices, triangles), Blocks::Loose),
            false => MeshBvh::of(build::build(vertices, triangles), Blocks::Shared),
        }
    }

    fn of<B: Block>((tree, bounds): (Tree<B>, Bounds), kind: fn(Vec<B>) -> Blocks) -> MeshBvh {
        let Tree { mut nodes, leaves } = tree;
        for word in nodes.iter_mut().flat_map(|node| &mut node.child) {
            let leaf = *word & LEAF;
            let size = if leaf == 0 { size_of::<Node>() } else { size_of::<B>() };
            *word = leaf | ((*word & !LEAF) * (size / UNIT) as u32);
        }
        let isa = *wide::Isa::all().last().unwrap_or(&wide::Isa::Scalar);
        let far_off = size_of_val(&nodes[..]) + size_of_val(&leaves[..]) > CACHED;
        MeshBvh { nodes, blocks: kind(leaves), bounds, isa, far_off }
    }

    /// The node that a word names.
    pub(crate) fn node(&self, word: u32) -> &Node {
        &self.nodes[word as usize * UNIT / size_of::<Node>()]
    }

    /// A box around all triangles.
    pub fn bounds(&self) -> Aabb {
        self.bounds.aabb()
    }

    /// Is a point outside the box around all triangles? What a ray from there hits first is mostly near. One from within
    /// goes far where it is free, and had better ask the smallest children, whose triangles are large.
    #[inline]
    #[cfg_attr(not(target_arch = "x86_64"), allow(dead_code))]
    pub(crate) fn is_outside(&self, p: &[f32; 3]) -> bool {
        (0..3).any(|k| p[k] < self.bounds.lo[k] || p[k] > self.bounds.hi[k])
    }

    /// A few boxes around parts of the mesh, which together hold all triangles: those of the top two levels. Turned,
    /// they tell much better where the mesh then is than the box around it all.
    pub fn parts(&self) -> Vec<Aabb> {
        let mut parts = Vec::new();
        let root = &self.nodes[0];
        for (i, b) in root.children() {
            let word = root.child[i];
            match word & LEAF {
                0 => parts.extend(self.node(word).children().map(|(_, b)| b)),
                _ => parts.push(b),
            }
        }
        parts
    }

    /// The size of the whole structure in bytes.
    pub fn bytes(&self) -> usize {
        size_of_val(&self.nodes[..]) + with_blocks!(&self.blocks, list => size_of_val(&list[..]))
    }

    /// The nearest triangle with `t_min <= t <= t_max`.
    #[inline]
    pub fn closest(&self, ray: &MeshRay) -> Option<MeshHit> {
        wide::closest(self, ray)
    }

    /// Is there any triangle with `t_min <= t <= t_max`?
    #[inline]
    pub fn any(&self, ray: &MeshRay) -> bool {
        wide::any(self, ray)
    }

    /// The nearest hit of a ray in double precision with `range.0 < t < range.1`, or any hit that `stops` says yes to.
    /// `range.0` is taken to be at least 0.
    #[inline]
    pub fn nearest(
        &self,
        ray: &Ray,
        range: (f64, f64),
        stops: impl FnMut(&TriangleHit) -> bool,
    ) -> Option<TriangleHit> {
        wide::nearest(self, ray, range, stops)
    }

    /// Every hit of a ray in double precision with `range.0 < t < range.1`, in any order.
    #[inline]
    pub fn all(&self, ray: &Ray, range: (f64, f64), found: impl FnMut(TriangleHit)) {
        wide::all(self, ray, range, found);
    }

    /// [`MeshBvh::closest`] for sixteen rays; worth it where they are coherent, right in any case.
    #[inline]
    pub fn closest_packet(&self, packet: &Packet) -> PacketHit {
        packet::closest(self, packet)
    }

    /// [`MeshBvh::any`] for sixteen rays: bit `i` is set where ray `i` hits something.
    #[inline]
    pub fn any_packet(&self, packet: &Packet) -> u16 {
        packet::any(self, packet)
    }
}

#[cfg(test)]
mod tests;
