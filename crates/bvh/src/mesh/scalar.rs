//! The traversal in plain Rust: what every machine can do, and what the wide kernels are checked against.

use raggio_math::Ray;

use super::double::Sheared;
use super::{Block, LEAF, MeshBvh, MeshHit, MeshRay, Node, ROOT, STACK, TriangleHit, block};
use crate::kernel::{SLACK, Slab};
use crate::round::{not_before, not_behind};

/// What the test of a triangle in single precision needs to know about a ray.
pub(crate) struct Prepared {
    pub origin: [f32; 3],
    /// Axes so that `dir[k[2]]` is the largest.
    pub k: [usize; 3],
    pub shear: [f32; 3],
}

impl Prepared {
    #[inline(always)]
    pub(crate) fn new(ray: &MeshRay) -> Prepared {
        let a = [ray.dir[0].abs(), ray.dir[1].abs(), ray.dir[2].abs()];
        let kz = if a[0] > a[1] { 0 } else { 1 };
        let kz = if a[2] >= a[0].max(a[1]) { 2 } else { kz };
        let (kx, ky) = ((kz + 1) % 3, (kz + 2) % 3);
        let inv_z = 1.0 / ray.dir[kz];
        Prepared {
            origin: ray.origin,
            k: [kx, ky, kz],
            shear: [ray.dir[kx] * inv_z, ray.dir[ky] * inv_z, inv_z],
        }
    }
}

/// A ray in single precision as boxes see it: what it is told is exact.
#[inline(always)]
pub(crate) fn slab(ray: &MeshRay) -> Slab {
    // A direction of 0 becomes tiny: the box test then never multiplies 0 by infinity.
    let inverse = |k: usize| {
        let d = ray.dir[k];
        1.0 / if d.abs() < 1e-18 { 1e-18f32.copysign(d) } else { d }
    };
    Slab::exact(ray.origin, [inverse(0), inverse(1), inverse(2)])
}

/// Where the ray enters a child, if it does before `t_max`.
fn child_entry(node: &Node, slot: usize, slab: &Slab, t_min: f32, t_max: f32) -> Option<f32> {
    let (mut near, mut far) = (t_min, t_max);
    for axis in 0..3 {
        let a = (node.bounds[slab.near[axis]][slot] - slab.origin_near[axis]) * slab.inverse[axis];
        let b = (node.bounds[slab.far[axis]][slot] - slab.origin_far[axis]) * (slab.inverse[axis] * SLACK);
        near = near.max(a);
        far = far.min(b);
    }
    (near <= far).then_some(near)
}

/// Shows `leaf` the blocks on the ray, the near ones first as far as boxes tell. It is given the distance beyond which
/// nothing interests any more and answers with the new one, a negative one to end the search.
fn walk<B: Block>(
    bvh: &MeshBvh,
    blocks: &[B],
    slab: &Slab,
    t_min: f32,
    mut t_max: f32,
    mut leaf: impl FnMut(&B, f32) -> f32,
) {
    let mut stack: Vec<(f32, u32)> = Vec::with_capacity(STACK);
    stack.push((t_min, ROOT));
    while let Some((entry, word)) = stack.pop() {
        if entry > t_max {
            continue;
        }
        if word & LEAF != 0 {
            t_max = leaf(block(blocks, word), t_max);
            continue;
        }
        let node = bvh.node(word);
        let first = stack.len();
        for slot in 0..8 {
            if let Some(entry) = child_entry(node, slot, slab, t_min, t_max) {
                stack.push((entry, node.child[slot]));
            }
        }
        stack[first..].sort_unstable_by(|a, b| b.0.total_cmp(&a.0));
    }
}

/// The nearest triangle of a block.
fn hit_block<B: Block>(block: &B, ray: &Prepared, t_min: f32, t_max: f32) -> Option<MeshHit> {
    let mut best = None;
    let mut t_best = t_max;
    for lane in 0..block.lanes() {
        let sheared = |corner: usize| {
            let point = block.corner(lane, corner);
            let at = |axis: usize| point[axis] - ray.origin[axis];
            let z = at(ray.k[2]);
            ((-ray.shear[0]).mul_add(z, at(ray.k[0])), (-ray.shear[1]).mul_add(z, at(ray.k[1])), z)
        };
        let (a, b, c) = (sheared(0), sheared(1), sheared(2));
        let u = c.0 * b.1 - c.1 * b.0;
        let v = a.0 * c.1 - a.1 * c.0;
        let w = b.0 * a.1 - b.1 * a.0;
        if u.min(v).min(w) < 0.0 && u.max(v).max(w) > 0.0 {
            continue;
        }
        let det = u + v + w;
        let t = (u * a.2 + v * b.2 + w * c.2) * ray.shear[2] / det;
        if t >= t_min && t <= t_best && det != 0.0 {
            t_best = t;
            best = Some(MeshHit { t, triangle: block.triangle(lane) });
        }
    }
    best
}

/// See [`MeshBvh::closest`].
pub(crate) fn closest<B: Block>(bvh: &MeshBvh, blocks: &[B], ray: &MeshRay) -> Option<MeshHit> {
    let prepared = Prepared::new(ray);
    let mut best = None;
    walk(bvh, blocks, &slab(ray), ray.t_min, ray.t_max, |block, t_max| {
        let Some(hit) = hit_block(block, &prepared, ray.t_min, t_max) else { return t_max };
        best = Some(hit);
        hit.t
    });
    best
}

/// See [`MeshBvh::any`].
pub(crate) fn any<B: Block>(bvh: &MeshBvh, blocks: &[B], ray: &MeshRay) -> bool {
    closest(bvh, blocks, ray).is_some()
}

/// See [`MeshBvh::nearest`].
pub(crate) fn nearest<B: Block>(
    bvh: &MeshBvh,
    blocks: &[B],
    ray: &Ray,
    range: (f64, f64),
    mut stops: impl FnMut(&TriangleHit) -> bool,
) -> Option<TriangleHit> {
    let (slab, sheared) = (Slab::new(ray), Sheared::new(ray));
    let mut best: Option<TriangleHit> = None;
    if !slab.finite {
        return None;
    }
    let mut far = range.1;
    walk(bvh, blocks, &slab, not_behind(range.0), not_before(far), |block, t_max| {
        let before = far;
        sheared.hits(block, (range.0, far), |hit| {
            if hit.t < far {
                (best, far) = (Some(hit), hit.t);
            }
        });
        match best {
            Some(hit) if far < before => {
                far = if stops(&hit) { -1.0 } else { far };
                not_before(far)
            }
            _ => t_max,
        }
    });
    best
}

/// See [`MeshBvh::all`].
pub(crate) fn all<B: Block>(
    bvh: &MeshBvh,
    blocks: &[B],
    ray: &Ray,
    range: (f64, f64),
    mut found: impl FnMut(TriangleHit),
) {
    let (slab, sheared) = (Slab::new(ray), Sheared::new(ray));
    if !slab.finite {
        return;
    }
    walk(bvh, blocks, &slab, not_behind(range.0), not_before(range.1), |block, t_max| {
        sheared.hits(block, range, &mut found);
        t_max
    });
}
