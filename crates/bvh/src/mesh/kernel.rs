//! The traversal kernel, written once for every set of wide instructions.

/// A module `$name` with `closest` and `any` compiled for `$features`.
macro_rules! kernel {
    ($name:ident, $features:literal) => {
        mod $name {
            use std::arch::x86_64::*;
            use std::mem::MaybeUninit;

            use crate::mesh::scalar::{Prepared, WIDEN};
            use crate::mesh::{Block, LEAF, MeshBvh, MeshHit, MeshRay, Node, STACK};

            /// A ray spread over lanes.
            struct Wide {
                origin: [__m256; 3],
                inv_dir: [__m256; 3],
                /// Byte offsets of the rows of `Node::bounds` that are nearer and farther on each axis.
                near: [usize; 3],
                far: [usize; 3],
                t_min: __m256,
                /// Four lanes, in the order of `Prepared::k`.
                tri_origin: [__m128; 3],
                shear: [__m128; 3],
                /// Byte offsets of the axes `Prepared::k` in a corner.
                axis: [usize; 3],
            }

            impl Wide {
                #[inline]
                #[target_feature(enable = $features)]
                fn new(ray: &MeshRay) -> Wide {
                    let p = Prepared::new(ray);
                    let side = |axis: usize, far: bool| {
                        32 * (axis + 3 * usize::from((p.inv_dir[axis] < 0.0) != far))
                    };
                    Wide {
                        origin: p.origin.map(|v| _mm256_set1_ps(v)),
                        inv_dir: p.inv_dir.map(|v| _mm256_set1_ps(v)),
                        near: [side(0, false), side(1, false), side(2, false)],
                        far: [side(0, true), side(1, true), side(2, true)],
                        t_min: _mm256_set1_ps(ray.t_min),
                        tri_origin: p.k.map(|k| _mm_set1_ps(p.origin[k])),
                        shear: p.shear.map(|v| _mm_set1_ps(v)),
                        axis: p.k.map(|k| 16 * k),
                    }
                }
            }

            /// Which children the ray enters before `t_max`, and where.
            #[inline]
            #[target_feature(enable = $features)]
            fn enter(node: &Node, ray: &Wide, t_max: __m256) -> (u32, __m256) {
                let base = node.bounds.as_ptr().cast::<u8>();
                let plane = |offset: usize, axis: usize| {
                    // SAFETY: offsets are rows 0..6 of `bounds`, 32 bytes each, in a structure aligned to 32.
                    let row = unsafe { _mm256_load_ps(base.add(offset).cast()) };
                    _mm256_mul_ps(_mm256_sub_ps(row, ray.origin[axis]), ray.inv_dir[axis])
                };
                let near_xy = _mm256_max_ps(plane(ray.near[0], 0), plane(ray.near[1], 1));
                let near = _mm256_max_ps(near_xy, _mm256_max_ps(plane(ray.near[2], 2), ray.t_min));
                let far_xy = _mm256_min_ps(plane(ray.far[0], 0), plane(ray.far[1], 1));
                let far = _mm256_min_ps(far_xy, plane(ray.far[2], 2));
                let far = _mm256_min_ps(_mm256_mul_ps(far, _mm256_set1_ps(WIDEN)), t_max);
                (_mm256_movemask_ps(_mm256_cmp_ps::<_CMP_LE_OQ>(near, far)) as u32, near)
            }

            /// Parameters of the hits with a block, and a mask of the lanes that have one in range.
            #[inline]
            #[target_feature(enable = $features)]
            fn hit_block(block: &Block, ray: &Wide, t_max: f32) -> (u32, __m128) {
                let base = block.corner.as_ptr().cast::<u8>();
                let at = |corner: usize, k: usize| {
                    // SAFETY: three corners of three rows of 16 bytes, in a structure aligned to 16.
                    let row = unsafe { _mm_load_ps(base.add(48 * corner + ray.axis[k]).cast()) };
                    _mm_sub_ps(row, ray.tri_origin[k])
                };
                let sheared = |corner: usize| {
                    let z = at(corner, 2);
                    let x = _mm_fnmadd_ps(ray.shear[0], z, at(corner, 0));
                    let y = _mm_fnmadd_ps(ray.shear[1], z, at(corner, 1));
                    (x, y, z)
                };
                let (a, b, c) = (sheared(0), sheared(1), sheared(2));
                // No fused operation here: a shared edge must give exact negatives on its two sides.
                let edge = |p: (__m128, __m128, __m128), q: (__m128, __m128, __m128)| {
                    _mm_sub_ps(_mm_mul_ps(p.0, q.1), _mm_mul_ps(p.1, q.0))
                };
                let (u, v, w) = (edge(c, b), edge(a, c), edge(b, a));
                let zero = _mm_setzero_ps();
                let least = _mm_min_ps(_mm_min_ps(u, v), w);
                let most = _mm_max_ps(_mm_max_ps(u, v), w);
                let one_sided = _mm_or_ps(_mm_cmpge_ps(least, zero), _mm_cmple_ps(most, zero));
                if _mm_movemask_ps(one_sided) == 0 {
                    return (0, zero);
                }
                let det = _mm_add_ps(_mm_add_ps(u, v), w);
                let scaled = _mm_fmadd_ps(w, c.2, _mm_fmadd_ps(v, b.2, _mm_mul_ps(u, a.2)));
                let t = _mm_div_ps(_mm_mul_ps(scaled, ray.shear[2]), det);
                // A det of 0 makes t infinite or not a number, which no comparison accepts.
                let after = _mm_cmpge_ps(t, _mm256_castps256_ps128(ray.t_min));
                let before = _mm_cmple_ps(t, _mm_set1_ps(t_max));
                let ok = _mm_and_ps(one_sided, _mm_and_ps(after, before));
                (_mm_movemask_ps(ok) as u32, t)
            }

            /// A child on the stack: where it is entered (a float that is not negative orders like its bits) and its word.
            type Entry = u64;

            #[inline(always)]
            fn entry(t: f32, word: u32) -> Entry {
                u64::from(t.to_bits()) << 32 | u64::from(word)
            }

            #[target_feature(enable = $features)]
            pub(super) fn closest(bvh: &MeshBvh, root: u32, ray: &MeshRay) -> Option<MeshHit> {
                let wide = Wide::new(ray);
                let mut stack = [MaybeUninit::<Entry>::uninit(); STACK];
                let mut top = 0usize;
                let mut t_max = ray.t_max;
                let mut triangle = u32::MAX;
                let mut word = root;
                loop {
                    while word & LEAF == 0 {
                        // SAFETY: child words are indices that the builder made.
                        let node = unsafe { bvh.nodes.get_unchecked(word as usize) };
                        let (mut mask, near) = enter(node, &wide, _mm256_set1_ps(t_max));
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
                        let (mask, t) = hit_block(block, &wide, t_max);
                        if mask != 0 {
                            (t_max, triangle) = nearest_lane(block, mask, t);
                        }
                    }
                    loop {
                        if top == 0 {
                            return (triangle != u32::MAX).then_some(MeshHit { t: t_max, triangle });
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

            #[inline]
            #[target_feature(enable = $features)]
            fn nearest_lane(block: &Block, mut mask: u32, t: __m128) -> (f32, u32) {
                let mut lanes = [0.0f32; 4];
                // SAFETY: four floats are written to an array of four.
                unsafe { _mm_storeu_ps(lanes.as_mut_ptr(), t) };
                let mut best = (f32::INFINITY, 0usize);
                while mask != 0 {
                    let lane = mask.trailing_zeros() as usize & 3;
                    mask &= mask - 1;
                    if lanes[lane] < best.0 {
                        best = (lanes[lane], lane);
                    }
                }
                (best.0, block.triangle[best.1])
            }

            #[target_feature(enable = $features)]
            pub(super) fn any(bvh: &MeshBvh, root: u32, ray: &MeshRay) -> bool {
                let wide = Wide::new(ray);
                let t_max = _mm256_set1_ps(ray.t_max);
                let mut stack = [MaybeUninit::<u32>::uninit(); STACK];
                let mut top = 0usize;
                let mut word = root;
                loop {
                    if word & LEAF != 0 {
                        // SAFETY: leaf words are indices that the builder made.
                        let block = unsafe { bvh.blocks.get_unchecked((word & !LEAF) as usize) };
                        if hit_block(block, &wide, ray.t_max).0 != 0 {
                            return true;
                        }
                    } else {
                        // SAFETY: child words are indices that the builder made.
                        let node = unsafe { bvh.nodes.get_unchecked(word as usize) };
                        let (mut mask, _) = enter(node, &wide, t_max);
                        while mask != 0 {
                            let slot = mask.trailing_zeros() as usize & 7;
                            mask &= mask - 1;
                            // SAFETY: top stays under STACK by the builder's depth bound.
                            unsafe { stack.get_unchecked_mut(top).write(node.child[slot]) };
                            top += 1;
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
        }
    };
}
