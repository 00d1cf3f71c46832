//! The test of a ray against the triangles of a leaf, for rays of either precision.

use super::block::THIRD;

/// The axes in turn, the one that is named last: a shuffle of four lanes.
pub(crate) static AXES: [[u32; 4]; 3] = [[1, 2, 0, 3], [2, 0, 1, 3], [0, 1, 2, 3]];

/// How far up in its word a lane has its first or second corner, and its third one. Beyond a word there is nothing:
/// lanes without triangles have one point for all corners.
pub(crate) static CORNERS: [[u32; 8]; 2] =
    [[0, 3, 6, 9, 12, 15, 32, 32], [THIRD, THIRD + 3, THIRD + 6, THIRD + 9, THIRD, THIRD + 3, 32, 32]];

/// `Single` and `Double`: a ray spread over lanes, made ready for triangles.
macro_rules! leaf_tests {
    ($features:literal, $call:meta) => {
        /// Which points are the first, second and third corners of each lane; only the lowest three bits count.
        #[inline]
        #[target_feature(enable = $features)]
        fn corners(block: &Shared) -> [__m256i; 3] {
            // SAFETY: eight numbers each.
            let (up, third) = unsafe {
                (
                    _mm256_loadu_si256(CORNERS[0].as_ptr().cast()),
                    _mm256_loadu_si256(CORNERS[1].as_ptr().cast()),
                )
            };
            let (a, b) =
                (_mm256_set1_epi32(block.corner[0] as i32), _mm256_set1_epi32(block.corner[1] as i32));
            let c = _mm256_blend_epi32::<0b1111_0000>(a, b);
            [_mm256_srlv_epi32(a, up), _mm256_srlv_epi32(b, up), _mm256_srlv_epi32(c, third)]
        }

        /// Of rows of points those that are one corner of each lane.
        #[inline]
        #[target_feature(enable = $features)]
        fn picked(rows: [__m256; 3], points: __m256i) -> [__m256; 3] {
            [
                _mm256_permutevar8x32_ps(rows[0], points),
                _mm256_permutevar8x32_ps(rows[1], points),
                _mm256_permutevar8x32_ps(rows[2], points),
            ]
        }

        /// A ray in single precision, its axes turned so that the last is its longest.
        struct Single {
            origin: [__m256; 3],
            shear: [__m256; 3],
            t_min: __m256,
            /// Byte offsets of the rows of the axes.
            axis: [usize; 3],
        }

        impl Single {
            #[inline]
            #[target_feature(enable = $features)]
            fn new(ray: &MeshRay) -> Single {
                // The ray stays in registers: taken through memory in parts of other sizes it would have to be waited for.
                // SAFETY: eight floats, aligned to 32 by the type.
                let (origin, dir) =
                    unsafe { (_mm_load_ps(ray.origin.as_ptr()), _mm_load_ps(ray.dir.as_ptr())) };
                let size = [ray.dir[0].to_bits() << 1, ray.dir[1].to_bits() << 1, ray.dir[2].to_bits() << 1];
                let z = usize::from(size[1] >= size[0]);
                let z = if size[2] >= size[0].max(size[1]) { 2 } else { z };
                let axis = &AXES[z];
                // SAFETY: four numbers.
                let order = unsafe { _mm_loadu_si128(axis.as_ptr().cast()) };
                let (origin, dir) = (_mm_permutevar_ps(origin, order), _mm_permutevar_ps(dir, order));
                let z = _mm_shuffle_ps::<0b10_10_10_10>(dir, dir);
                let shear = _mm_div_ps(_mm_blend_ps::<0b100>(dir, _mm_set1_ps(1.0)), z);
                let all = |v: __m128| {
                    [
                        _mm256_broadcastss_ps(v),
                        _mm256_broadcastss_ps(_mm_shuffle_ps::<0b01_01_01_01>(v, v)),
                        _mm256_broadcastss_ps(_mm_shuffle_ps::<0b10_10_10_10>(v, v)),
                    ]
                };
                Single {
                    origin: all(origin),
                    shear: all(shear),
                    t_min: _mm256_set1_ps(ray.t_min),
                    axis: [32 * axis[0] as usize, 32 * axis[1] as usize, 32 * axis[2] as usize],
                }
            }

            /// The corners as the ray sees them, of triangles that share theirs.
            #[inline]
            #[target_feature(enable = $features)]
            fn shared(&self, block: *const Shared) -> ([__m256; 3], [__m256; 3], [__m256; 3]) {
                let base = block.cast::<u8>();
                let at = |k: usize| {
                    // SAFETY: three rows of 32 bytes, in a structure aligned to 64.
                    let row = unsafe { _mm256_load_ps(base.add(self.axis[k]).cast()) };
                    _mm256_sub_ps(row, self.origin[k])
                };
                let z = at(2);
                let x = _mm256_fnmadd_ps(self.shear[0], z, at(0));
                let y = _mm256_fnmadd_ps(self.shear[1], z, at(1));
                // SAFETY: the block is one of the tree's.
                let [a, b, c] = corners(unsafe { &*block });
                (picked([x, y, z], a), picked([x, y, z], b), picked([x, y, z], c))
            }

            /// The corners as the ray sees them, of triangles that have their own, in the lower four lanes. All corners
            /// above lie in one place, and so make no hit.
            #[inline]
            #[target_feature(enable = $features)]
            fn loose(&self, block: *const Loose) -> ([__m256; 3], [__m256; 3], [__m256; 3]) {
                let base = block.cast::<u8>();
                let at = |corner: usize, k: usize| {
                    // SAFETY: three corners of three rows of 16 bytes, in a structure aligned to 32.
                    let row = unsafe { _mm_load_ps(base.add(48 * corner + self.axis[k] / 2).cast()) };
                    _mm256_sub_ps(_mm256_zextps128_ps256(row), self.origin[k])
                };
                let sheared = |corner: usize| {
                    let z = at(corner, 2);
                    let x = _mm256_fnmadd_ps(self.shear[0], z, at(corner, 0));
                    let y = _mm256_fnmadd_ps(self.shear[1], z, at(corner, 1));
                    [x, y, z]
                };
                (sheared(0), sheared(1), sheared(2))
            }

            /// A mask of the lanes that have a hit in range, and where.
            #[inline]
            #[target_feature(enable = $features)]
            fn hit<B: Block>(&self, block: &B, t_max: f32) -> (u32, __m256) {
                let (a, b, c) = match B::LOOSE {
                    true => self.loose(ptr::from_ref(block).cast()),
                    false => self.shared(ptr::from_ref(block).cast()),
                };
                // No fused operation here: a shared edge must give exact negatives on its two sides.
                let edge = |p: [__m256; 3], q: [__m256; 3]| {
                    _mm256_sub_ps(_mm256_mul_ps(p[0], q[1]), _mm256_mul_ps(p[1], q[0]))
                };
                let (u, v, w) = (edge(c, b), edge(a, c), edge(b, a));
                let zero = _mm256_setzero_ps();
                let least = _mm256_min_ps(_mm256_min_ps(u, v), w);
                let most = _mm256_max_ps(_mm256_max_ps(u, v), w);
                let one_sided = _mm256_or_ps(
                    _mm256_cmp_ps::<_CMP_GE_OQ>(least, zero),
                    _mm256_cmp_ps::<_CMP_LE_OQ>(most, zero),
                );
                // No way out here: a branch that is often mistaken costs more than the rest.
                let det = _mm256_add_ps(_mm256_add_ps(u, v), w);
                let scaled = _mm256_fmadd_ps(w, c[2], _mm256_fmadd_ps(v, b[2], _mm256_mul_ps(u, a[2])));
                let t = _mm256_div_ps(_mm256_mul_ps(scaled, self.shear[2]), det);
                // A det of 0 makes t infinite or not a number, which no comparison accepts.
                let after = _mm256_cmp_ps::<_CMP_GE_OQ>(t, self.t_min);
                let before = _mm256_cmp_ps::<_CMP_LE_OQ>(t, _mm256_set1_ps(t_max));
                let ok = _mm256_and_ps(one_sided, _mm256_and_ps(after, before));
                (_mm256_movemask_ps(ok) as u32, _mm256_blendv_ps(_mm256_set1_ps(f32::INFINITY), t, ok))
            }

            /// Does the ray hit a block before `t_max`?
            #[$call]
            #[target_feature(enable = $features)]
            fn hits<B: Block>(&self, block: &B, t_max: f32) -> bool {
                self.hit(block, t_max).0 != 0
            }
        }

        #[inline]
        #[target_feature(enable = $features)]
        fn nearest_lane<B: Block>(block: &B, t: __m256) -> MeshHit {
            let halves = _mm256_min_ps(t, _mm256_permute2f128_ps::<1>(t, t));
            let pairs = _mm256_min_ps(halves, _mm256_permute_ps::<0b01_00_11_10>(halves));
            let least = _mm256_min_ps(pairs, _mm256_permute_ps::<0b10_11_00_01>(pairs));
            let lane = _mm256_movemask_ps(_mm256_cmp_ps::<_CMP_EQ_OQ>(t, least)).trailing_zeros() as usize;
            MeshHit { t: _mm256_cvtss_f32(least), triangle: block.triangle(lane) }
        }

        /// A ray in double precision.
        struct Double {
            origin: [__m256d; 3],
            shear: [__m256d; 3],
            /// Byte offsets of the rows of the axes.
            axis: [usize; 3],
        }

        /// What [`Double::hit`] has found, a lane for each of four triangles.
        struct Hits {
            /// The first lane.
            first: usize,
            mask: u32,
            t: __m256d,
            v: __m256d,
            w: __m256d,
            det: __m256d,
        }

        impl Double {
            #[inline]
            #[target_feature(enable = $features)]
            fn new(ray: &Sheared) -> Double {
                let [x, y, z] = ray.axes;
                Double {
                    origin: [
                        _mm256_set1_pd(ray.origin[x]),
                        _mm256_set1_pd(ray.origin[y]),
                        _mm256_set1_pd(ray.origin[z]),
                    ],
                    shear: [
                        _mm256_set1_pd(ray.shear.x),
                        _mm256_set1_pd(ray.shear.y),
                        _mm256_set1_pd(ray.shear.z),
                    ],
                    axis: [32 * x, 32 * y, 32 * z],
                }
            }

            /// The hits with `range.0 < t < range.1` of the first four triangles, then those of the others.
            #[inline]
            #[target_feature(enable = $features)]
            fn hits<B: Block>(&self, block: &B, range: (f64, f64), mut found: impl FnMut(&Hits)) {
                let base = ptr::from_ref(block).cast::<u8>();
                if B::LOOSE {
                    let row = |corner: usize, k: usize| {
                        // SAFETY: three corners of three rows of 16 bytes, in a structure aligned to 32.
                        unsafe { _mm_load_ps(base.add(48 * corner + self.axis[k] / 2).cast()) }
                    };
                    let of = |corner: usize| [row(corner, 0), row(corner, 1), row(corner, 2)];
                    found(&self.hit(0, [of(0), of(1), of(2)], range));
                    return;
                }
                // SAFETY: three rows of 32 bytes, in a structure aligned to 64.
                let row = |k: usize| unsafe { _mm256_load_ps(base.add(self.axis[k]).cast()) };
                let rows = [row(0), row(1), row(2)];
                // SAFETY: what is not loose is shared.
                let [a, b, c] = corners(unsafe { &*base.cast() });
                let (a, b, c) = (picked(rows, a), picked(rows, b), picked(rows, c));
                let low = |p: [__m256; 3]| {
                    [_mm256_castps256_ps128(p[0]), _mm256_castps256_ps128(p[1]), _mm256_castps256_ps128(p[2])]
                };
                found(&self.hit(0, [low(a), low(b), low(c)], range));
                if block.triangle(4) != u32::MAX {
                    let high = |p: [__m256; 3]| {
                        [
                            _mm256_extractf128_ps::<1>(p[0]),
                            _mm256_extractf128_ps::<1>(p[1]),
                            _mm256_extractf128_ps::<1>(p[2]),
                        ]
                    };
                    found(&self.hit(4, [high(a), high(b), high(c)], range));
                }
            }

            /// The hits of four triangles given by their corners, from lane `first` on.
            #[inline]
            #[target_feature(enable = $features)]
            fn hit(&self, first: usize, corners: [[__m128; 3]; 3], range: (f64, f64)) -> Hits {
                let at = |corner: usize, k: usize| {
                    _mm256_sub_pd(_mm256_cvtps_pd(corners[corner][k]), self.origin[k])
                };
                let sheared = |corner: usize| {
                    let z = at(corner, 2);
                    let x = _mm256_fnmadd_pd(self.shear[0], z, at(corner, 0));
                    let y = _mm256_fnmadd_pd(self.shear[1], z, at(corner, 1));
                    (x, y, z)
                };
                let (a, b, c) = (sheared(0), sheared(1), sheared(2));
                // No fused operation here, for the sake of shared edges.
                let edge = |p: (__m256d, __m256d, __m256d), q: (__m256d, __m256d, __m256d)| {
                    _mm256_sub_pd(_mm256_mul_pd(p.0, q.1), _mm256_mul_pd(p.1, q.0))
                };
                let (u, v, w) = (edge(c, b), edge(a, c), edge(b, a));
                let zero = _mm256_setzero_pd();
                let least = _mm256_min_pd(_mm256_min_pd(u, v), w);
                let most = _mm256_max_pd(_mm256_max_pd(u, v), w);
                let one_sided = _mm256_or_pd(
                    _mm256_cmp_pd::<_CMP_GE_OQ>(least, zero),
                    _mm256_cmp_pd::<_CMP_LE_OQ>(most, zero),
                );
                let det = _mm256_add_pd(_mm256_add_pd(u, v), w);
                if _mm256_movemask_pd(one_sided) == 0 {
                    return Hits { first, mask: 0, t: zero, v, w, det };
                }
                let scaled = _mm256_fmadd_pd(w, c.2, _mm256_fmadd_pd(v, b.2, _mm256_mul_pd(u, a.2)));
                let t = _mm256_div_pd(_mm256_mul_pd(scaled, self.shear[2]), det);
                // A det of 0 makes t infinite or not a number, which no comparison accepts.
                let after = _mm256_cmp_pd::<_CMP_GT_OQ>(t, _mm256_set1_pd(range.0));
                let before = _mm256_cmp_pd::<_CMP_LT_OQ>(t, _mm256_set1_pd(range.1));
                let ok = _mm256_and_pd(one_sided, _mm256_and_pd(after, before));
                Hits { first, mask: _mm256_movemask_pd(ok) as u32, t, v, w, det }
            }
        }

        impl Hits {
            /// Shows all of them to `found`.
            #[inline]
            #[target_feature(enable = $features)]
            fn each<B: Block>(&self, block: &B, mut found: impl FnMut(TriangleHit)) {
                if self.mask == 0 {
                    return;
                }
                let (mut t, mut v, mut w, mut det) = ([0.0; 4], [0.0; 4], [0.0; 4], [0.0; 4]);
                // SAFETY: four doubles are written to each array of four.
                unsafe {
                    _mm256_storeu_pd(t.as_mut_ptr(), self.t);
                    _mm256_storeu_pd(v.as_mut_ptr(), self.v);
                    _mm256_storeu_pd(w.as_mut_ptr(), self.w);
                    _mm256_storeu_pd(det.as_mut_ptr(), self.det);
                }
                let mut mask = self.mask;
                while mask != 0 {
                    let i = mask.trailing_zeros() as usize & 3;
                    mask &= mask - 1;
                    found(TriangleHit {
                        t: t[i],
                        face: block.triangle(self.first + i),
                        u: v[i] / det[i],
                        v: w[i] / det[i],
                    });
                }
            }

            /// The nearest of them.
            #[inline]
            #[target_feature(enable = $features)]
            fn nearest<B: Block>(&self, block: &B) -> Option<TriangleHit> {
                let mut best: Option<TriangleHit> = None;
                self.each(block, |hit| {
                    if best.is_none_or(|b| hit.t < b.t) {
                        best = Some(hit);
                    }
                });
                best
            }
        }
    };
}
