//! The traversal, written once for every set of wide instructions and for rays of either precision.

/// A module `$name` with all questions to a mesh, compiled for `$features`. `$call` says how any-hit rays ask a leaf.
macro_rules! kernel {
    ($name:ident, $features:literal, $call:meta) => {
        mod $name {
            use std::arch::x86_64::*;
            use std::mem::MaybeUninit;
            use std::ptr;

            use raggio_math::Ray;

            use crate::kernel::{SLACK, Slab};
            use crate::mesh::block::{Loose, Shared};
            use crate::mesh::double::Sheared;
            use crate::mesh::leaf::{AXES, CORNERS};
            use crate::mesh::{Block, LEAF, MeshBvh, MeshHit, MeshRay, ROOT, STACK, TriangleHit, UNIT};
            use crate::round::{not_before, not_behind};

            box_tests!($features);
            leaf_tests!($features, $call);

            /// A child on the stack: where it is entered (a float that is not negative orders like its bits) and its word.
            type Entry = u64;

            /// Marks a way as one that is taken less often.
            #[cold]
            #[inline(always)]
            fn cold_path() {}

            #[inline(always)]
            fn entry(t: f32, word: u32) -> Entry {
                u64::from(t.to_bits()) << 32 | u64::from(word)
            }

            /// Shows `leaf` the blocks on the ray, the near ones first as far as boxes tell. It is given the distance
            /// beyond which nothing interests any more and answers with the new one.
            #[inline]
            #[target_feature(enable = $features)]
            fn walk<B: Block>(boxes: &Boxes<B>, mut t_max: f32, mut leaf: impl FnMut(&B, f32) -> f32) {
                let mut stack = [MaybeUninit::<Entry>::uninit(); STACK];
                let mut top = 0usize;
                let mut word = ROOT;
                loop {
                    while word & LEAF == 0 {
                        let (mut mask, near) = boxes.enter(word, _mm256_set1_ps(t_max));
                        if mask == 0 {
                            word = u32::MAX;
                            break;
                        }
                        let mut t = [0.0f32; 8];
                        // SAFETY: eight floats are written to an array of eight.
                        unsafe { _mm256_storeu_ps(t.as_mut_ptr(), near) };
                        let node = word;
                        let first = mask.trailing_zeros() as usize;
                        word = boxes.child(node, first);
                        if mask & (mask - 1) == 0 {
                            continue;
                        }
                        boxes.prefetch_children(node, mask);
                        let (mut nearest, base) = (entry(t[first & 7], word), top);
                        mask &= mask - 1;
                        while mask != 0 {
                            let slot = mask.trailing_zeros() as usize;
                            mask &= mask - 1;
                            let other = entry(t[slot & 7], boxes.child(node, slot));
                            // A branch, so that the way may go on before it is known which is nearer.
                            let far = if nearest < other {
                                other
                            } else {
                                cold_path();
                                word = boxes.child(node, slot);
                                std::mem::replace(&mut nearest, other)
                            };
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
                    }
                    if word != u32::MAX {
                        let block = boxes.block(word);
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
            pub(super) fn closest<B: Block>(bvh: &MeshBvh, blocks: &[B], ray: &MeshRay) -> Option<MeshHit> {
                let (boxes, single) = (Boxes::single(bvh, blocks, ray), Single::new(ray));
                let mut nearest = MeshHit { t: ray.t_max, triangle: u32::MAX };
                walk(&boxes, ray.t_max, |block, t_max| {
                    let (mask, t) = single.hit(block, t_max);
                    if mask != 0 {
                        nearest = nearest_lane(block, t);
                    }
                    nearest.t
                });
                (nearest.triangle != u32::MAX).then_some(nearest)
            }

            /// [`MeshBvh::is_outside`] for the start of a ray.
            #[inline]
            #[target_feature(enable = $features)]
            fn is_outside(bvh: &MeshBvh, ray: &MeshRay) -> bool {
                let (lo, hi) = (&bvh.bounds.lo, &bvh.bounds.hi);
                // SAFETY: four floats each, aligned to 16 by their types; the fourth is not looked at.
                let (p, lo, hi) = unsafe {
                    (_mm_load_ps(ray.origin.as_ptr()), _mm_load_ps(lo.as_ptr()), _mm_load_ps(hi.as_ptr()))
                };
                let beyond = _mm_or_ps(_mm_cmplt_ps(p, lo), _mm_cmplt_ps(hi, p));
                _mm_movemask_ps(beyond) & 0b111 != 0
            }

            #[target_feature(enable = $features)]
            pub(super) fn any<B: Block>(bvh: &MeshBvh, blocks: &[B], ray: &MeshRay) -> bool {
                let (boxes, single) = (Boxes::single(bvh, blocks, ray), Single::new(ray));
                let t_max = _mm256_set1_ps(ray.t_max);
                // To choose the nearest takes longer than it saves where the tree is at hand.
                let near_first = bvh.far_off && is_outside(bvh, ray);
                let mut stack = [MaybeUninit::<u32>::uninit(); STACK];
                let mut top = 0usize;
                let mut word = ROOT;
                loop {
                    while word & LEAF == 0 {
                        let (mut mask, near) = boxes.enter(word, t_max);
                        if mask == 0 {
                            word = u32::MAX;
                            break;
                        }
                        let node = word;
                        let rest = mask & (mask - 1);
                        word = boxes.child(node, mask.trailing_zeros() as usize);
                        if rest == 0 {
                            continue;
                        }
                        if near_first {
                            // SAFETY: top stays under STACK by the builder's depth bound.
                            word = boxes.nearest(node, mask, near, |far| unsafe {
                                stack.get_unchecked_mut(top).write(far);
                                top += 1;
                            });
                            continue;
                        }
                        mask = rest;
                        // The last of them is the smallest, and asked first.
                        while mask != 0 {
                            // SAFETY: top stays under STACK by the builder's depth bound.
                            unsafe { stack.get_unchecked_mut(top).write(word) };
                            top += 1;
                            word = boxes.child(node, mask.trailing_zeros() as usize);
                            mask &= mask - 1;
                            boxes.prefetch(word);
                        }
                    }
                    if word != u32::MAX {
                        let block = boxes.block(word);
                        if single.hits(block, ray.t_max) {
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
            pub(super) fn nearest<B: Block>(
                bvh: &MeshBvh,
                blocks: &[B],
                ray: &Ray,
                range: (f64, f64),
                mut stops: impl FnMut(&TriangleHit) -> bool,
            ) -> Option<TriangleHit> {
                let slab = Slab::new(ray);
                if !slab.finite {
                    return None;
                }
                let boxes = Boxes::new(bvh, blocks, &slab, not_behind(range.0));
                let double = Double::new(&Sheared::new(ray));
                let mut best = None;
                let mut far = range.1;
                walk(&boxes, not_before(far), |block, t_max| {
                    let before = far;
                    double.hits(block, (range.0, far), |hits| {
                        if let Some(hit) = hits.nearest(block).filter(|hit| hit.t < far) {
                            best = Some(hit);
                            far = if stops(&hit) { -1.0 } else { hit.t };
                        }
                    });
                    if far == before { t_max } else { not_before(far) }
                });
                best
            }

            /// See [`MeshBvh::all`].
            #[target_feature(enable = $features)]
            pub(super) fn all<B: Block>(
                bvh: &MeshBvh,
                blocks: &[B],
                ray: &Ray,
                range: (f64, f64),
                mut found: impl FnMut(TriangleHit),
            ) {
                let slab = Slab::new(ray);
                if !slab.finite {
                    return;
                }
                let boxes = Boxes::new(bvh, blocks, &slab, not_behind(range.0));
                let double = Double::new(&Sheared::new(ray));
                walk(&boxes, not_before(range.1), |block, t_max| {
                    double.hits(block, range, |hits| hits.each(block, &mut found));
                    t_max
                });
            }
        }
    };
}
