//! Asking the tree: nearest hit, any hit, all boxes on a ray, all boxes around a point.
#![allow(unsafe_code)]

use std::mem::MaybeUninit;

use raggio_math::{Ray, Vec3};
use smallvec::SmallVec;

use crate::build::BOXES_DEPTH;
#[cfg(target_arch = "x86_64")]
use crate::kernel::Avx2;
use crate::kernel::{Kernel, Scalar, Slab};
use crate::node::{Child, Kind, Node, WIDTH};
use crate::round::{down, not_before, not_behind, up};

/// A tree over boxes. See [`Bvh::build`].
pub struct Bvh {
    /// The root is the first; no nodes, no boxes.
    pub(crate) nodes: Vec<Node>,
    /// Primitives in the order of the leaves.
    pub(crate) prims: Vec<u32>,
    /// Has the processor the wide kernel?
    #[cfg_attr(not(target_arch = "x86_64"), allow(dead_code))]
    pub(crate) simd: bool,
}

/// A child that waits: where the ray enters it (a float that is not negative orders like its bits) and its word.
type Entry = u64;

/// No ray keeps more children waiting: seven on each level of the deepest tree that the builder makes.
const STACK: usize = 7 * BOXES_DEPTH + 8;

/// Children that wait, the nearest on top. The room is borrowed: as a field beside `len` it would be zeroed for
/// each ray.
struct Stack<'a> {
    entries: &'a mut [MaybeUninit<Entry>; STACK],
    len: usize,
}

impl Stack<'_> {
    #[inline(always)]
    fn pop(&mut self) -> Option<(f32, Child)> {
        self.len = self.len.checked_sub(1)?;
        // SAFETY: entries below the old length were written.
        let entry = unsafe { self.entries.get_unchecked(self.len).assume_init() };
        Some((f32::from_bits((entry >> 32) as u32), Child::from_word(entry as u32)))
    }

    /// Puts an entry under those from `base` on that are nearer.
    #[inline(always)]
    fn insert(&mut self, base: usize, entry: Entry) {
        let mut at = self.len;
        assert!(at < STACK);
        // SAFETY: `at` and all below it are in the array, and those below the length were written.
        unsafe {
            while at > base && self.entries.get_unchecked(at - 1).assume_init() < entry {
                *self.entries.get_unchecked_mut(at) = *self.entries.get_unchecked(at - 1);
                at -= 1;
            }
            self.entries.get_unchecked_mut(at).write(entry);
        }
        self.len += 1;
    }
}

#[inline(always)]
fn entry(near: f32, child: Child) -> Entry {
    u64::from(near.to_bits()) << 32 | u64::from(child.word())
}

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
    /// the new such distance, a negative one to end the search. `range.0` is taken to be at least 0.
    #[inline]
    pub fn closest(&self, ray: &Ray, range: (f64, f64), visit: impl FnMut(u32, f64) -> Option<f64>) {
        if !self.nodes.is_empty() {
            self.closest_prepared(&Slab::new(ray), range, visit);
        }
    }

    /// [`Bvh::closest`] for a ray that is asked of several trees.
    #[inline]
    pub fn closest_prepared(
        &self,
        slab: &Slab,
        range: (f64, f64),
        visit: impl FnMut(u32, f64) -> Option<f64>,
    ) {
        #[cfg(target_arch = "x86_64")]
        if self.simd {
            // SAFETY: `simd` says that the processor has AVX2.
            return unsafe { self.closest_avx2(slab, range, visit) };
        }
        self.walk::<Scalar>(slab, range, visit);
    }

    #[cfg(target_arch = "x86_64")]
    #[target_feature(enable = "avx2")]
    fn closest_avx2(&self, slab: &Slab, range: (f64, f64), visit: impl FnMut(u32, f64) -> Option<f64>) {
        self.walk::<Avx2>(slab, range, visit);
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
                    let mut holds = [true; WIDTH];
                    for k in 0..3 {
                        for (i, holds) in holds.iter_mut().enumerate() {
                            *holds &= (node.bounds[k][i] <= hi[k]) & (lo[k] <= node.bounds[k + 3][i]);
                        }
                    }
                    for (i, holds) in holds.into_iter().enumerate() {
                        if holds {
                            stack.push(node.child(i));
                        }
                    }
                }
            }
        }
        false
    }

    /// The traversal itself, for any kernel that the processor has.
    #[inline(always)]
    fn walk<K: Kernel>(
        &self,
        slab: &Slab,
        range: (f64, f64),
        mut visit: impl FnMut(u32, f64) -> Option<f64>,
    ) {
        if self.nodes.is_empty() || !slab.finite {
            return;
        }
        let t0 = not_behind(range.0);
        let (mut t_max, mut t1) = (range.1, not_before(range.1));
        let mut room = [MaybeUninit::uninit(); STACK];
        let mut stack = Stack { entries: &mut room, len: 0 };
        let (mut near, mut far) = ([0.0; WIDTH], [0.0; WIDTH]);
        stack.insert(0, entry(t0, Child::inner(0)));
        while let Some((t, mut child)) = stack.pop() {
            if t > t1 {
                continue;
            }
            loop {
                match child.kind() {
                    Kind::Inner(index) => {
                        let node = &self.nodes[index];
                        // SAFETY: the caller chose a kernel that the processor has.
                        let mask = unsafe { K::test(node, slab, t0, t1, &mut near, &mut far) };
                        // An only child needs no stack.
                        if mask & mask.wrapping_sub(1) == 0 && mask != 0 {
                            child = node.child(mask.trailing_zeros() as usize & 7);
                            continue;
                        }
                        push_sorted(&mut stack, node, mask, &near);
                    }
                    Kind::Leaf(run) => {
                        for &prim in &self.prims[run] {
                            if let Some(t) = visit(prim, t_max) {
                                (t_max, t1) = (t, not_before(t));
                                if t < 0.0 {
                                    return;
                                }
                            }
                        }
                    }
                }
                break;
            }
        }
    }
}

/// Pushes the children in `mask` so that the nearest comes off first.
#[inline(always)]
fn push_sorted(stack: &mut Stack<'_>, node: &Node, mut mask: u32, near: &[f32; WIDTH]) {
    let base = stack.len;
    while mask != 0 {
        let i = mask.trailing_zeros() as usize & 7;
        mask &= mask - 1;
        stack.insert(base, entry(near[i], node.child(i)));
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

    #[test]
    fn rays_that_are_not_finite_end_at_once() {
        let boxes = [Aabb::new(Vec3::ZERO, Vec3::ONE), Aabb::new(Vec3::splat(2.0), Vec3::splat(3.0))];
        let mut bvh = Bvh::build(&boxes, 1).bvh;
        for simd in [bvh.simd, false] {
            bvh.simd = simd;
            for bad in [f64::NAN, f64::INFINITY, f64::NEG_INFINITY, 1e300] {
                for k in 0..3 {
                    let mut broken = Vec3::splat(0.5);
                    broken[k] = bad;
                    for ray in [Ray::new(broken, Vec3::X), Ray::new(Vec3::splat(0.5), broken)] {
                        bvh.all(&ray, (0.0, f64::INFINITY), |_| panic!("{ray:?} touches nothing"));
                    }
                }
            }
            let ray = Ray::new(Vec3::splat(-1.0), Vec3::ONE.normalize());
            for range in [(f64::NAN, 10.0), (0.0, f64::NAN), (f64::INFINITY, f64::INFINITY)] {
                let mut count = 0;
                bvh.all(&ray, range, |_| count += 1);
                assert!(count <= boxes.len());
            }
        }
    }
}
