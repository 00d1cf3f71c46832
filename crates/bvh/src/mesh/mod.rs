//! The triangle mesh room: a hierarchy over triangles in single precision, as fast as the machine allows.
//!
//! Nodes have eight children with full-precision boxes, leaves hold one block of up to four triangles. The triangle
//! test is watertight (Woop, Benthin, Wald: "Watertight Ray/Triangle Intersection", JCGT 2013): edge functions of a
//! shared edge are exact negatives of each other, so no ray slips through between two triangles. The box test subtracts
//! before it scales and widens the far side by its own rounding error (Ize: "Robust BVH Ray Traversal", JCGT 2013).
//!
//! [`scalar`] says what the answer is; [`wide`] gives the same hits with wide instructions where the machine has them.

#[macro_use]
mod kernel;
mod build;
mod packet;
mod scalar;
mod wide;

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
    isa: wide::Isa,
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
        let (nodes, blocks, root) = Builder::new(vertices, triangles).build();
        let isa = *wide::Isa::all().last().unwrap_or(&wide::Isa::Scalar);
        MeshBvh { nodes, blocks, root, isa }
    }

    /// The size of the whole structure in bytes.
    pub fn bytes(&self) -> usize {
        size_of_val(&self.nodes[..]) + size_of_val(&self.blocks[..])
    }

    /// The nearest triangle with `t_min <= t <= t_max`.
    #[inline]
    pub fn closest(&self, ray: &MeshRay) -> Option<MeshHit> {
        wide::closest(self.isa, self, self.root, ray)
    }

    /// Is there any triangle with `t_min <= t <= t_max`?
    #[inline]
    pub fn any(&self, ray: &MeshRay) -> bool {
        wide::any(self.isa, self, self.root, ray)
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
mod tests {
    use super::*;

    /// A small deterministic generator: the tests need variety, not quality.
    struct Random(u64);

    impl Random {
        fn float(&mut self) -> f32 {
            self.0 = self.0.wrapping_mul(6364136223846793005).wrapping_add(1442695040888963407);
            (self.0 >> 40) as f32 / (1u64 << 24) as f32 * 2.0 - 1.0
        }
        fn point(&mut self) -> [f32; 3] {
            [self.float(), self.float(), self.float()]
        }
    }

    fn ray(origin: [f32; 3], dir: [f32; 3]) -> MeshRay {
        MeshRay { origin, t_min: 0.0, dir, t_max: f32::INFINITY }
    }

    fn soup(count: u32, size: f32, random: &mut Random) -> (Vec<[f32; 3]>, Vec<[u32; 3]>) {
        let mut vertices = Vec::new();
        for _ in 0..count {
            let centre = random.point();
            for _ in 0..3 {
                let d = random.point();
                vertices.push([0, 1, 2].map(|k| centre[k] + size * d[k]));
            }
        }
        (vertices, (0..count).map(|i| [3 * i, 3 * i + 1, 3 * i + 2]).collect())
    }

    /// Every triangle tested on its own, through a structure that holds just that one.
    fn brute_force(vertices: &[[f32; 3]], triangles: &[[u32; 3]], ray: &MeshRay) -> Option<f32> {
        let one = |t: &[u32; 3]| scalar_closest(&MeshBvh::build(vertices, &[*t]), ray).map(|h| h.t);
        triangles.iter().filter_map(one).min_by(f32::total_cmp)
    }

    fn scalar_closest(bvh: &MeshBvh, ray: &MeshRay) -> Option<MeshHit> {
        scalar::closest(bvh, bvh.root, ray)
    }

    #[test]
    fn every_kernel_agrees_with_brute_force() {
        let mut random = Random(7);
        for (count, size) in [(1, 0.5), (3, 0.5), (40, 0.3), (200, 0.05), (200, 2.0)] {
            let (vertices, triangles) = soup(count, size, &mut random);
            let bvh = MeshBvh::build(&vertices, &triangles);
            for _ in 0..200 {
                let ray = ray(random.point().map(|c| 2.0 * c), random.point());
                let expected = brute_force(&vertices, &triangles, &ray);
                for isa in wide::Isa::all() {
                    let found = wide::closest(isa, &bvh, bvh.root, &ray).map(|h| h.t);
                    assert_eq!(found.is_some(), expected.is_some(), "{isa:?} {ray:?}");
                    if let (Some(a), Some(b)) = (found, expected) {
                        assert!((a - b).abs() <= 1e-5 * b.abs().max(1.0), "{isa:?} {a} {b}");
                    }
                    assert_eq!(wide::any(isa, &bvh, bvh.root, &ray), expected.is_some(), "{isa:?}");
                }
            }
        }
    }

    #[test]
    fn nothing_coincident_flat_and_huge_are_harmless() {
        let p = [[0.0; 3], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [1e18, 1e18, 0.0]];
        let down = ray([0.2, 0.3, 1.0], [0.0, 0.0, -1.0]);
        assert_eq!(MeshBvh::build(&p, &[]).closest(&down), None);
        let same = MeshBvh::build(&p, &[[0, 1, 2]; 1000]);
        assert_eq!(same.closest(&down).map(|h| h.t), Some(1.0));
        let degenerate = MeshBvh::build(&p, &[[0, 0, 1], [1, 1, 1]]);
        assert!(!degenerate.any(&down));
        let huge = MeshBvh::build(&p, &[[0, 1, 3], [0, 1, 2]]);
        assert_eq!(huge.closest(&down).map(|h| h.triangle), Some(1));
    }

    #[test]
    fn packets_agree_with_single_rays() {
        let mut random = Random(11);
        let (vertices, triangles) = soup(300, 0.2, &mut random);
        let bvh = MeshBvh::build(&vertices, &triangles);
        for n in 0..300 {
            // Narrow bundles, wide ones, and some without any coherence.
            let spread = [0.02, 0.3, 4.0][n % 3];
            let (origin, dir) = (random.point().map(|c| 3.0 * c), random.point());
            let rays: [MeshRay; 16] = std::array::from_fn(|_| {
                let d = random.point();
                ray(origin, [0, 1, 2].map(|k| dir[k] + spread * d[k]))
            });
            let packet = Packet::new(&rays);
            let (hits, any) = (bvh.closest_packet(&packet), bvh.any_packet(&packet));
            for (i, ray) in rays.iter().enumerate() {
                let single = bvh.closest(ray).map_or((f32::INFINITY, u32::MAX), |h| (h.t, h.triangle));
                assert_eq!(any >> i & 1 == 1, single.1 != u32::MAX, "{ray:?}");
                let close = hits.t[i] == single.0 || (hits.t[i] - single.0).abs() < 1e-5 * single.0;
                assert!(close, "{} {} {ray:?}", hits.t[i], single.0);
            }
        }
    }

    /// A closed, finely divided sphere seen from inside: every ray must hit, those through edges and corners too.
    #[test]
    fn a_closed_mesh_leaks_nowhere() {
        let (rows, columns) = (24u32, 31u32);
        let mut vertices = vec![[0.0, 1.0, 0.0], [0.0, -1.0, 0.0]];
        for i in 1..rows {
            for j in 0..columns {
                let (a, b) = (
                    i as f32 / rows as f32 * std::f32::consts::PI,
                    j as f32 / columns as f32 * std::f32::consts::TAU,
                );
                vertices.push([a.sin() * b.cos(), a.cos(), a.sin() * b.sin()]);
            }
        }
        let at = |i: u32, j: u32| match i {
            0 => 0,
            i if i == rows => 1,
            i => 2 + (i - 1) * columns + j % columns,
        };
        let mut triangles = Vec::new();
        for i in 0..rows {
            for j in 0..columns {
                triangles.push([at(i, j), at(i + 1, j), at(i + 1, j + 1)]);
                triangles.push([at(i, j), at(i + 1, j + 1), at(i, j + 1)]);
            }
        }
        let bvh = MeshBvh::build(&vertices, &triangles);
        let mut random = Random(3);
        for n in 0..200_000 {
            let origin = random.point().map(|c| 0.3 * c);
            let t = triangles[n % triangles.len()];
            let (a, b) = (vertices[t[n % 3] as usize], vertices[t[(n + 1) % 3] as usize]);
            let w = if n % 7 == 0 { 0.0 } else { 0.5 + 0.5 * random.float() };
            let target = [0, 1, 2].map(|k| a[k] + w * (b[k] - a[k]));
            let through_edge = ray(origin, [0, 1, 2].map(|k| target[k] - origin[k]));
            for isa in wide::Isa::all() {
                assert!(wide::any(isa, &bvh, bvh.root, &through_edge), "{isa:?} {through_edge:?}");
            }
        }
    }
}
