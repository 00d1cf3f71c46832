//! The traversal in plain Rust: what every machine can do, and what the wide kernels are checked against.

use super::{Block, LEAF, MeshBvh, MeshHit, MeshRay, Node, STACK};

/// Rounding of three operations on each side of a slab, twice over.
pub(crate) const WIDEN: f32 = 1.0 + 4.0 * f32::EPSILON;

/// What the tests need to know about a ray, worked out once.
pub(crate) struct Prepared {
    pub origin: [f32; 3],
    pub inv_dir: [f32; 3],
    /// Axes so that `dir[k[2]]` is the largest; swapped where needed to keep winding.
    pub k: [usize; 3],
    pub shear: [f32; 3],
}

impl Prepared {
    #[inline(always)]
    pub(crate) fn new(ray: &MeshRay) -> Prepared {
        let a = ray.dir.map(f32::abs);
        let kz = if a[0] > a[1] {
            if a[0] > a[2] { 0 } else { 2 }
        } else if a[1] > a[2] {
            1
        } else {
            2
        };
        let (kx, ky) = ((kz + 1) % 3, (kz + 2) % 3);
        let inv_z = 1.0 / ray.dir[kz];
        // A direction of 0 becomes tiny: the box test then never multiplies 0 by infinity.
        let inv_dir = ray.dir.map(|d| 1.0 / if d.abs() < 1e-18 { 1e-18f32.copysign(d) } else { d });
        Prepared {
            origin: ray.origin,
            inv_dir,
            k: [kx, ky, kz],
            shear: [ray.dir[kx] * inv_z, ray.dir[ky] * inv_z, inv_z],
        }
    }
}

/// Where the ray enters a child, if it does before `t_max`.
fn child_entry(node: &Node, slot: usize, ray: &Prepared, t_min: f32, t_max: f32) -> Option<f32> {
    let (mut near, mut far) = (t_min, t_max);
    for axis in 0..3 {
        let at = |row: usize| (node.bounds[row][slot] - ray.origin[axis]) * ray.inv_dir[axis];
        let (a, b) =
            if ray.inv_dir[axis] < 0.0 { (at(axis + 3), at(axis)) } else { (at(axis), at(axis + 3)) };
        near = near.max(a);
        far = far.min(b * WIDEN);
    }
    (near <= far).then_some(near)
}

/// The nearest triangle of a block.
fn hit_block(block: &Block, ray: &Prepared, t_min: f32, t_max: f32) -> Option<MeshHit> {
    let mut best = None;
    let mut t_best = t_max;
    for lane in 0..4 {
        let sheared = |corner: usize| {
            let at = |axis: usize| block.corner[corner][axis][lane] - ray.origin[axis];
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
            best = Some(MeshHit { t, triangle: block.triangle[lane] });
        }
    }
    best
}

/// See [`MeshBvh::closest`].
pub(crate) fn closest(bvh: &MeshBvh, root: u32, ray: &MeshRay) -> Option<MeshHit> {
    let prepared = Prepared::new(ray);
    let mut best = None;
    let mut t_max = ray.t_max;
    let mut stack: Vec<(f32, u32)> = Vec::with_capacity(STACK);
    stack.push((ray.t_min, root));
    while let Some((entry, word)) = stack.pop() {
        if entry > t_max {
            continue;
        }
        if word & LEAF != 0 {
            if let Some(hit) = hit_block(&bvh.blocks[(word & !LEAF) as usize], &prepared, ray.t_min, t_max) {
                t_max = hit.t;
                best = Some(hit);
            }
            continue;
        }
        let node = &bvh.nodes[word as usize];
        let first = stack.len();
        for slot in 0..8 {
            if let Some(entry) = child_entry(node, slot, &prepared, ray.t_min, t_max) {
                stack.push((entry, node.child[slot]));
            }
        }
        stack[first..].sort_unstable_by(|a, b| b.0.total_cmp(&a.0));
    }
    best
}

/// See [`MeshBvh::any`].
pub(crate) fn any(bvh: &MeshBvh, root: u32, ray: &MeshRay) -> bool {
    let prepared = Prepared::new(ray);
    let mut stack: Vec<u32> = Vec::with_capacity(STACK);
    stack.push(root);
    while let Some(word) = stack.pop() {
        if word & LEAF != 0 {
            if hit_block(&bvh.blocks[(word & !LEAF) as usize], &prepared, ray.t_min, ray.t_max).is_some() {
                return true;
            }
            continue;
        }
        let node = &bvh.nodes[word as usize];
        let hit = (0..8).filter(|&slot| child_entry(node, slot, &prepared, ray.t_min, ray.t_max).is_some());
        stack.extend(hit.map(|slot| node.child[slot]));
    }
    false
}
