//! The traversal, written once for every set of wide instructions and for rays of either precision.

/// A module `$name` with all questions to a mesh, compiled for `$features`.
macro_rules! kernel {
    ($name:ident, $features:literal) => {
        mod $name {
            use std::arch::x86_64::*;
            use std::mem::MaybeUninit;

            use raggio_math::Ray;

            use crate::kernel::{SLACK, Slab};
            use crate::mesh::double::Sheared;
            use crate::mesh::leaf::AXES;
            use crate::mesh::{Block, LEAF, MeshBvh, MeshHit, MeshRay, Node, ROOT, STACK, TriangleHit};
            use crate::round::{down, up};

            leaf_tests!($features);

            /// A ray as eight boxes see it.
            struct Boxes {
                near_origin: [__m256; 3],
                far_origin: [__m256; 3],
                inverse: [__m256; 3],
                far_inverse: [__m256; 3],
                /// Byte offsets of the rows of `Node::bounds` that are nearer and farther on each axis.
                near: [usize; 3],
                far: [usize; 3],
                t_min: __m256,
            }

            impl Boxes {
                // Arrays are written out here: `map` is compiled without the features, and would not be inlined.
                #[inline]
                #[target_feature(enable = $features)]
                fn new(slab: &Slab, t_min: f32) -> Boxes {
                    let (near, far, inverse) = (&slab.origin_near, &slab.origin_far, &slab.inverse);
                    Boxes {
                        near_origin: [
                            _mm256_set1_ps(near[0]),
                            _mm256_set1_ps(near[1]),
                            _mm256_set1_ps(near[2]),
                        ],
                        far_origin: [_mm256_set1_ps(far[0]), _mm256_set1_ps(far[1]), _mm256_set1_ps(far[2])],
                        inverse: [
                            _mm256_set1_ps(inverse[0]),
                            _mm256_set1_ps(inverse[1]),
                            _mm256_set1_ps(inverse[2]),
                        ],
                        far_inverse: [
                            _mm256_set1_ps(inverse[0] * SLACK),
                            _mm256_set1_ps(inverse[1] * SLACK),
                            _mm256_set1_ps(inverse[2] * SLACK),
                        ],
                        near: [32 * slab.near[0], 32 * slab.near[1], 32 * slab.near[2]],
                        far: [32 * slab.far[0], 32 * slab.far[1], 32 * slab.far[2]],
                        t_min: _mm256_set1_ps(t_min),
                    }
                }

                /// A ray in single precision, which is taken to be exact.
                #[inline]
                #[target_feature(enable = $features)]
                fn single(ray: &MeshRay) -> Boxes {
                    // SAFETY: four floats, aligned to 16 by the type.
                    let dir = unsafe { _mm_load_ps(ray.dir.as_ptr()) };
                    // A direction of 0 becomes tiny: the box test then never multiplies 0 by infinity.
                    let (sign, tiny) = (_mm_set1_ps(-0.0), _mm_set1_ps(1e-18));
                    let size = _mm_max_ps(_mm_andnot_ps(sign, dir), tiny);
                    let inverse = _mm_div_ps(_mm_set1_ps(1.0), _mm_or_ps(size, _mm_and_ps(dir, sign)));
                    let slack = _mm_mul_ps(inverse, _mm_set1_ps(SLACK));
                    let backwards = _mm_movemask_ps(inverse) as usize;
                    let side = [96 * (backwards & 1), 96 * (backwards >> 1 & 1), 96 * (backwards >> 2 & 1)];
                    let origin = [
                        _mm256_broadcast_ss(&ray.origin[0]),
                        _mm256_broadcast_ss(&ray.origin[1]),
                        _mm256_broadcast_ss(&ray.origin[2]),
                    ];
                    let all = |v: __m128| {
                        [
                            _mm256_broadcastss_ps(v),
                            _mm256_broadcastss_ps(_mm_shuffle_ps::<0b01_01_01_01>(v, v)),
                            _mm256_broadcastss_ps(_mm_shuffle_ps::<0b10_10_10_10>(v, v)),
                        ]
                    };
                    Boxes {
                        near_origin: origin,
                        far_origin: origin,
                        inverse: all(inverse),
                        far_inverse: all(slack),
                        near: [side[0], 32 + side[1], 64 + side[2]],
                        far: [96 - side[0], 128 - side[1], 160 - side[2]],
                        t_min: _mm256_broadcast_ss(&ray.t_min),
                    }
                }

                /// Which children the ray enters before `t_max`, and where.
                #[inline]
                #[target_feature(enable = $features)]
                fn enter(&self, node: &Node, t_max: __m256) -> (u32, __m256) {
                    let base = node.bounds.as_ptr().cast::<u8>();
                    let plane = |offset: usize, origin: __m256, inverse: __m256| {
                        // SAFETY: offsets are rows 0..6 of `bounds`, 32 bytes each, in a structure aligned to 32.
                        let row = unsafe { _mm256_load_ps(base.add(offset).cast()) };
                        _mm256_mul_ps(_mm256_sub_ps(row, origin), inverse)
                    };
                    let near =
                        |axis: usize| plane(self.near[axis], self.near_origin[axis], self.inverse[axis]);
                    let far =
                        |axis: usize| plane(self.far[axis], self.far_origin[axis], self.far_inverse[axis]);
                    let enter =
                        _mm256_max_ps(_mm256_max_ps(near(0), near(1)), _mm256_max_ps(near(2), self.t_min));
                    let leave = _mm256_min_ps(_mm256_min_ps(far(0), far(1)), _mm256_min_ps(far(2), t_max));
                    (_mm256_movemask_ps(_mm256_cmp_ps::<_CMP_LE_OQ>(enter, leave)) as u32, enter)
                }
            }

            /// A child on the stack: where it is entered (a float that is not negative orders like its bits) and its word.
            type Entry = u64;

            #[inline(always)]
            fn entry(t: f32, word: u32) -> Entry {
                u64::from(t.to_bits()) << 32 | u64::from(word)
            }

            /// Shows `leaf` the blocks on the ray, the near ones first as far as boxes tell. It is given the distance
            /// beyond which nothing interests any more and answers with the new one.
            #[inline]
            #[target_feature(enable = $features)]
            fn walk(bvh: &MeshBvh, boxes: &Boxes, mut t_max: f32, mut leaf: impl FnMut(&Block, f32) -> f32) {
                let mut stack = [MaybeUninit::<Entry>::uninit(); STACK];
                let mut top = 0usize;
                let mut word = ROOT;
                loop {
                    while word & LEAF == 0 {
                        // SAFETY: child words are indices that the builder made.
                        let node = unsafe { bvh.nodes.get_unchecked(word as usize) };
                        let (mut mask, near) = boxes.enter(node, _mm256_set1_ps(t_max));
                        if mask == 0 {
                            word = u32::MAX;
                            break;
                        }
                        let mut t = [0.0f32; 8];
                        // SAFETY: eight floats are written to an array of eight.
                        unsafe { _mm256_storeu_ps(t.as_mut_ptr(), near) };
                        let first = mask.trailing_zeros() as usize;
                        mask &= mask - 1;
                        if mask == 0 {
                            word = node.child[first];
                            continue;
                        }
                        let mut nearest = entry(t[first], node.child[first]);
                        let base = top;
                        while mask != 0 {
                            let slot = mask.trailing_zeros() as usize;
                            mask &= mask - 1;
                            let other = entry(t[slot & 7], node.child[slot & 7]);
                            let (near, far) =
                                if other < nearest { (other, nearest) } else { (nearest, other) };
                            nearest = near;
                            // Keep the waiting children sorted, the farthest at the bottom.
                            let mut at = top;
                            // SAFETY: entries base..top were written; top stays under STACK by the builder's depth bound.
                            unsafe {
                                while at > base && stack.get_unchecked(at - 1).assume_init() < far {
                                    *stack.get_unchecked_mut(at) = *stack.get_unchecked(at - 1);
                                    at -= 1;
                                }
                                stack.get_unchecked_mut(at).write(far);
                            }
                            top += 1;
                        }
                        word = nearest as u32;
                    }
                    if word != u32::MAX {
                        // SAFETY: leaf words are indices that the builder made.
                        let block = unsafe { bvh.blocks.get_unchecked((word & !LEAF) as usize) };
                        t_max = leaf(block, t_max);
                    }
                    loop {
                        if top == 0 {
                            return;
                        }
                        top -= 1;
                        // SAFETY: entries below the old top were written.
                        let next = unsafe { stack.get_unchecked(top).assume_init() };
                        if f32::from_bits((next >> 32) as u32) <= t_max {
                            word = next as u32;
                            break;
                        }
                    }
                }
            }

            #[target_feature(enable = $features)]
            pub(super) fn closest(bvh: &MeshBvh, ray: &MeshRay) -> Option<MeshHit> {
                let (boxes, single) = (Boxes::single(ray), Single::new(ray));
                let mut nearest = MeshHit { t: ray.t_max, triangle: u32::MAX };
                walk(bvh, &boxes, ray.t_max, |block, t_max| {
                    let (mask, t) = single.hit(block, t_max);
                    if mask != 0 {
                        nearest = nearest_lane(block, t);
                    }
                    nearest.t
                });
                (nearest.triangle != u32::MAX).then_some(nearest)
            }

            #[target_feature(enable = $features)]
            pub(super) fn any(bvh: &MeshBvh, ray: &MeshRay) -> bool {
                let (boxes, single) = (Boxes::single(ray), Single::new(ray));
                let t_max = _mm256_set1_ps(ray.t_max);
                let mut stack = [MaybeUninit::<u32>::uninit(); STACK];
                let mut top = 0usize;
                let mut word = ROOT;
                loop {
                    while word & LEAF == 0 {
                        // SAFETY: child words are indices that the builder made.
                        let node = unsafe { bvh.nodes.get_unchecked(word as usize) };
                        let (mut mask, _) = boxes.enter(node, t_max);
                        if mask == 0 {
                            word = u32::MAX;
                            break;
                        }
                        // SAFETY: a bit of eight is set.
                        word = unsafe { *node.child.get_unchecked(mask.trailing_zeros() as usize) };
                        mask &= mask - 1;
                        while mask != 0 {
                            let slot = mask.trailing_zeros() as usize & 7;
                            mask &= mask - 1;
                            // SAFETY: top stays under STACK by the builder's depth bound.
                            unsafe { stack.get_unchecked_mut(top).write(node.child[slot]) };
                            top += 1;
                        }
                    }
                    if word != u32::MAX {
                        // SAFETY: leaf words are indices that the builder made.
                        let block = unsafe { bvh.blocks.get_unchecked((word & !LEAF) as usize) };
                        if single.hit(block, ray.t_max).0 != 0 {
                            return true;
                        }
                    }
                    if top == 0 {
                        return false;
                    }
                    top -= 1;
                    // SAFETY: entries below the old top were written.
                    word = unsafe { stack.get_unchecked(top).assume_init() };
                }
            }

            /// See [`MeshBvh::nearest`].
            #[target_feature(enable = $features)]
            pub(super) fn nearest(
                bvh: &MeshBvh,
                ray: &Ray,
                range: (f64, f64),
                mut stops: impl FnMut(&TriangleHit) -> bool,
            ) -> Option<TriangleHit> {
                let slab = Slab::new(ray);
                if !slab.finite {
                    return None;
                }
                let boxes = Boxes::new(&slab, down(range.0.max(0.0)) + 0.0);
                let double = Double::new(&Sheared::new(ray));
                let mut best = None;
                let mut far = range.1;
                walk(bvh, &boxes, up(far), |block, t_max| {
                    let hits = double.hit(block, (range.0, far));
                    let Some(hit) = hits.nearest(block) else { return t_max };
                    best = Some(hit);
                    far = if stops(&hit) { -1.0 } else { hit.t };
                    up(far)
                });
                best
            }

            /// See [`MeshBvh::all`].
            #[target_feature(enable = $features)]
            pub(super) fn all(
                bvh: &MeshBvh,
                ray: &Ray,
                range: (f64, f64),
                mut found: impl FnMut(TriangleHit),
            ) {
                let slab = Slab::new(ray);
                if !slab.finite {
                    return;
                }
                let boxes = Boxes::new(&slab, down(range.0.max(0.0)) + 0.0);
                let double = Double::new(&Sheared::new(ray));
                walk(bvh, &boxes, up(range.1), |block, t_max| {
                    double.hit(block, range).each(block, &mut found);
                    t_max
                });
            }
        }
    };
}
