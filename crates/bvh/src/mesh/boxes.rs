//! The test of a ray against the eight boxes of a node, and the way to its children.

/// `Boxes`: a ray spread over lanes, made ready for boxes.
macro_rules! box_tests {
    ($features:literal) => {
        /// A ray as eight boxes see it.
        struct Boxes<B> {
            near_origin: [__m256; 3],
            far_origin: [__m256; 3],
            inverse: [__m256; 3],
            far_inverse: [__m256; 3],
            /// Where the first node has the rows of `Node::bounds` that are nearer and farther on each axis.
            near: [*const u8; 3],
            far: [*const u8; 3],
            /// Where the first node has its children.
            child: *const u8,
            nodes: *const u8,
            blocks: *const B,
            /// Is most of the tree in no cache?
            far_off: bool,
            t_min: __m256,
        }

        impl<B: Block> Boxes<B> {
            // Arrays are written out here: `map` is compiled without the features, and would not be inlined.
            #[inline]
            #[target_feature(enable = $features)]
            fn new(bvh: &MeshBvh, blocks: &[B], slab: &Slab, t_min: f32) -> Self {
                let row = |k: usize| bvh.nodes.as_ptr().cast::<u8>().wrapping_add(32 * k);
                let (near, far, inverse) = (&slab.origin_near, &slab.origin_far, &slab.inverse);
                Boxes {
                    near_origin: [_mm256_set1_ps(near[0]), _mm256_set1_ps(near[1]), _mm256_set1_ps(near[2])],
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
                    near: [row(slab.near[0]), row(slab.near[1]), row(slab.near[2])],
                    far: [row(slab.far[0]), row(slab.far[1]), row(slab.far[2])],
                    child: row(6),
                    nodes: row(0),
                    blocks: blocks.as_ptr(),
                    far_off: bvh.far_off,
                    t_min: _mm256_set1_ps(t_min),
                }
            }

            /// A ray in single precision, which is taken to be exact.
            #[inline]
            #[target_feature(enable = $features)]
            fn single(bvh: &MeshBvh, blocks: &[B], ray: &MeshRay) -> Self {
                // SAFETY: four floats, aligned to 16 by the type.
                let dir = unsafe { _mm_load_ps(ray.dir.as_ptr()) };
                // A direction of 0 becomes tiny: the box test then never multiplies 0 by infinity.
                let (sign, tiny) = (_mm_set1_ps(-0.0), _mm_set1_ps(1e-18));
                let size = _mm_max_ps(_mm_andnot_ps(sign, dir), tiny);
                let inverse = _mm_div_ps(_mm_set1_ps(1.0), _mm_or_ps(size, _mm_and_ps(dir, sign)));
                let slack = _mm_mul_ps(inverse, _mm_set1_ps(SLACK));
                let backwards = _mm_movemask_ps(inverse) as usize;
                let side = [96 * (backwards & 1), 96 * (backwards >> 1 & 1), 96 * (backwards >> 2 & 1)];
                let row = |offset: usize| bvh.nodes.as_ptr().cast::<u8>().wrapping_add(offset);
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
                    near: [row(side[0]), row(32 + side[1]), row(64 + side[2])],
                    far: [row(96 - side[0]), row(128 - side[1]), row(160 - side[2])],
                    child: row(192),
                    nodes: row(0),
                    blocks: blocks.as_ptr(),
                    far_off: bvh.far_off,
                    t_min: _mm256_broadcast_ss(&ray.t_min),
                }
            }

            /// Which children the ray enters before `t_max`, and where.
            #[inline]
            #[target_feature(enable = $features)]
            fn enter(&self, word: u32, t_max: __m256) -> (u32, __m256) {
                let plane = |first: *const u8, origin: __m256, inverse: __m256| {
                    // Words count in bytes by what an address can scale: no arithmetic stands before the load.
                    // SAFETY: rows 0..6 of `bounds`, 32 bytes each, in a structure aligned to 32.
                    let row = unsafe { _mm256_load_ps(first.add(word as usize * UNIT).cast()) };
                    _mm256_mul_ps(_mm256_sub_ps(row, origin), inverse)
                };
                let near = |axis: usize| plane(self.near[axis], self.near_origin[axis], self.inverse[axis]);
                let far = |axis: usize| plane(self.far[axis], self.far_origin[axis], self.far_inverse[axis]);
                let enter =
                    _mm256_max_ps(_mm256_max_ps(near(0), near(1)), _mm256_max_ps(near(2), self.t_min));
                let leave = _mm256_min_ps(_mm256_min_ps(far(0), far(1)), _mm256_min_ps(far(2), t_max));
                (_mm256_movemask_ps(_mm256_cmp_ps::<_CMP_LE_OQ>(enter, leave)) as u32, enter)
            }

            /// The word of a child of a node.
            #[inline(always)]
            fn child(&self, node: u32, slot: usize) -> u32 {
                // SAFETY: words are places that the builder made, and a node has eight children.
                unsafe { self.child.add(node as usize * UNIT).cast::<u32>().add(slot & 7).read() }
            }

            /// Has the processor fetch what a word names, where the tree is too large to be at hand.
            #[inline]
            #[target_feature(enable = $features)]
            fn prefetch(&self, word: u32) {
                if !self.far_off {
                    return;
                }
                let base = if word & LEAF == 0 { self.nodes } else { self.blocks.cast() };
                let at = base.wrapping_add((word & !LEAF) as usize * UNIT).cast::<i8>();
                // SAFETY: a prefetch of any address is harmless; newer compilers know that.
                #[allow(unused_unsafe)]
                unsafe {
                    _mm_prefetch::<_MM_HINT_T0>(at);
                    _mm_prefetch::<_MM_HINT_T0>(at.wrapping_add(64));
                    // Nodes have four lines, blocks two or three.
                    if B::LOOSE || word & LEAF == 0 {
                        _mm_prefetch::<_MM_HINT_T0>(at.wrapping_add(128));
                        _mm_prefetch::<_MM_HINT_T0>(at.wrapping_add(192));
                    }
                }
            }

            /// The same for the children of a node that are in the mask.
            #[inline]
            #[target_feature(enable = $features)]
            fn prefetch_children(&self, node: u32, mut mask: u32) {
                while self.far_off && mask != 0 {
                    self.prefetch(self.child(node, mask.trailing_zeros() as usize));
                    mask &= mask - 1;
                }
            }

            /// Of the children of a node that are in the mask, two or more, the one that the ray enters first. The
            /// others are shown to `wait`.
            #[inline]
            #[target_feature(enable = $features)]
            fn nearest(&self, node: u32, mut mask: u32, near: __m256, mut wait: impl FnMut(u32)) -> u32 {
                let mut t = [0.0f32; 8];
                // SAFETY: eight floats are written to an array of eight.
                unsafe { _mm256_storeu_ps(t.as_mut_ptr(), near) };
                let child = |slot: usize| entry(t[slot & 7], self.child(node, slot));
                let mut nearest = child(mask.trailing_zeros() as usize);
                while mask & (mask - 1) != 0 {
                    mask &= mask - 1;
                    let other = child(mask.trailing_zeros() as usize);
                    self.prefetch(other as u32);
                    wait(nearest.max(other) as u32);
                    nearest = nearest.min(other);
                }
                nearest as u32
            }

            /// The block that a leaf's word names.
            #[inline(always)]
            fn block(&self, word: u32) -> &B {
                // SAFETY: words are places that the builder made; the mesh outlives its questions.
                unsafe { &*self.blocks.byte_add((word & !LEAF) as usize * UNIT) }
            }
        }
    };
}
