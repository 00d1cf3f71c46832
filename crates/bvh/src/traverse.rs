//! Asking the tree: nearest hit, any hit, all boxes on a ray, all boxes around a point.
use raggio_math::{Ray, Vec3};
use smallvec::SmallVec;

#[cfg(target_arch = "x86_64")]
use crate::kernel::Avx2;
use crate::kernel::{Kernel, Scalar, Slab};
use crate::node::{Child, Kind, Node, WIDTH};
use crate::round::{down, up};

/// A tree over boxes. See [`Bvh::build`].
pub struct Bvh {
    /// The root is the first; no nodes, no boxes.
    pub(crate) nodes: Vec<Node>,
    /// Primitives in the order of the leaves.
    pub(crate) prims: Vec<u32>,
    /// Has the processor the wide kernel?
    pub(crate) simd: bool,
}

/// Nodes still to be visited and where the ray enters them. On the heap only for very deep trees.
type Stack = SmallVec<[(f32, Child); 64]>;

impl Bvh {
    /// How many primitives are in the tree.
    pub fn len(&self) -> usize {
        self.prims.len()
    }

    /// Is nothing in the tree?
    pub fn is_empty(&self) -> bool {
        self.prims.is_empty()
    }

    /// Visits the primitives whose boxes the ray touches, the near ones first as far as boxes tell. `visit` is given a
    /// primitive and the distance beyond which nothing interests any more; where it finds something nearer it returns
    /// the new such distance. `range.0` is taken to be at least 0.
    #[inline]
    pub fn closest(&self, ray: &Ray, range: (f64, f64), visit: impl FnMut(u32, f64) -> Option<f64>) {
        #[cfg(target_arch = "x86_64")]
        if self.simd {
            // SAFETY: `simd` says that the processor has AVX2.
            #[allow(unsafe_code)]
            return unsafe { self.closest_avx2(ray, range, visit) };
        }
        self.walk::<Scalar>(ray, range, visit);
    }

    #[cfg(target_arch = "x86_64")]
    #[target_feature(enable = "avx2")]
    fn closest_avx2(&self, ray: &Ray, range: (f64, f64), visit: impl FnMut(u32, f64) -> Option<f64>) {
        self.walk::<Avx2>(ray, range, visit);
    }

    /// Visits primitives on the ray until `visit` says that it has found what it sought; returns whether it has.
    #[inline]
    pub fn any(&self, ray: &Ray, range: (f64, f64), mut visit: impl FnMut(u32) -> bool) -> bool {
        let mut found = false;
        // A negative distance leaves nothing to be visited.
        self.closest(ray, range, |prim, _| {
            found = found || visit(prim);
            found.then_some(-1.0)
        });
        found
    }

    /// Visits all primitives whose boxes the ray touches.
    #[inline]
    pub fn all(&self, ray: &Ray, range: (f64, f64), mut visit: impl FnMut(u32)) {
        self.closest(ray, range, |prim, _| {
            visit(prim);
            None
        });
    }

    /// Visits the primitives whose boxes contain the point until `visit` says that it has found what it sought;
    /// returns whether it has.
    pub fn containing(&self, p: Vec3, mut visit: impl FnMut(u32) -> bool) -> bool {
        let (lo, hi) = (p.to_array().map(down), p.to_array().map(up));
        let mut stack: SmallVec<[Child; 64]> = SmallVec::new();
        if !self.nodes.is_empty() {
            stack.push(Child::inner(0));
        }
        while let Some(child) = stack.pop() {
            match child.kind() {
                Kind::Leaf(run) => {
                    if self.prims[run].iter().any(|&prim| visit(prim)) {
                        return true;
                    }
                }
                Kind::Inner(index) => {
                    let node = &self.nodes[index];
                    let mut outside = [false; WIDTH];
                    for k in 0..3 {
                        for (i, out) in outside.iter_mut().enumerate() {
                            *out |= !(node.sides[k][i] <= hi[k] && lo[k] <= node.sides[k + 3][i]);
                        }
                    }
                    stack.extend((0..WIDTH).filter(|&i| !outside[i]).map(|i| node.children[i]));
                }
            }
        }
        false
    }

    /// The traversal itself, for any kernel that the processor has.
    #[inline(always)]
    fn walk<K: Kernel>(&self, ray: &Ray, range: (f64, f64), mut visit: impl FnMut(u32, f64) -> Option<f64>) {
        if self.nodes.is_empty() {
            return;
        }
        let slab = Slab::new(ray);
        let t0 = down(range.0.max(0.0));
        let (mut t_max, mut t1) = (range.1, up(range.1));
        let mut stack = Stack::new();
        let mut entry = [0.0; WIDTH];
        stack.push((t0, Child::inner(0)));
        while let Some((near, child)) = stack.pop() {
            if near > t1 {
                continue;
            }
            match child.kind() {
                Kind::Leaf(run) => {
                    for &prim in &self.prims[run] {
                        if let Some(t) = visit(prim, t_max) {
                            (t_max, t1) = (t, up(t));
                        }
                    }
                }
                Kind::Inner(index) => {
                    let node = &self.nodes[index];
                    // SAFETY: the caller chose a kernel that the processor has.
                    #[allow(unsafe_code)]
                    let mask = unsafe { K::test(node, &slab, t0, t1, &mut entry) };
                    push_sorted(&mut stack, node, mask, &entry);
                }
            }
        }
    }
}

/// Pushes the children in `mask` so that the nearest comes off first.
#[inline(always)]
fn push_sorted(stack: &mut Stack, node: &Node, mut mask: u32, entry: &[f32; WIDTH]) {
    let base = stack.len();
    while mask != 0 {
        let i = mask.trailing_zeros() as usize;
        mask &= mask - 1;
        let mut at = stack.len();
        stack.push((entry[i], node.children[i]));
        while at > base && stack[at - 1].0 < entry[i] {
            stack.swap(at - 1, at);
            at -= 1;
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use raggio_math::Aabb;

    /// A small generator, so that the boxes are the same every time.
    fn next(state: &mut u64) -> f64 {
        *state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        (*state >> 11) as f64 / (1u64 << 53) as f64
    }

    #[test]
    fn both_kernels_visit_the_same_leaves_in_the_same_order() {
        let mut s = 7;
        let mut v = |scale: f64| Vec3::new(next(&mut s), next(&mut s), next(&mut s)) * scale;
        let boxes: Vec<Aabb> = (0..500)
            .map(|_| {
                let c = v(20.0);
                Aabb::new(c, c + v(2.0))
            })
            .collect();
        let mut bvh = Bvh::build(&boxes, 2).bvh;
        let rays: Vec<Ray> = (0..200).map(|_| Ray::new(v(20.0), (v(2.0) - Vec3::ONE).normalize())).collect();
        let visits = |bvh: &Bvh| {
            let mut order = Vec::new();
            rays.iter().for_each(|ray| bvh.all(ray, (0.0, 30.0), |i| order.push(i)));
            order
        };
        let fast = visits(&bvh);
        bvh.simd = false;
        assert_eq!(fast, visits(&bvh));
        assert!(fast.len() > 300);
    }
}
