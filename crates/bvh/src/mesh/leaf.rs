//! The test of a ray against the four triangles of a leaf, for rays of either precision.

/// The axes in turn, the one that is named last: a shuffle of four lanes.
pub(crate) static AXES: [[u32; 4]; 3] = [[1, 2, 0, 3], [2, 0, 1, 3], [0, 1, 2, 3]];

/// `Single` and `Double`: a ray spread over four lanes, made ready for triangles.
macro_rules! leaf_tests {
    ($features:literal) => {
        /// A ray in single precision, its axes turned so that the last is its longest.
        struct Single {
            origin: [__m128; 3],
            shear: [__m128; 3],
            t_min: __m128,
            /// Byte offsets of the axes in a corner.
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
                        _mm_broadcastss_ps(v),
                        _mm_shuffle_ps::<0b01_01_01_01>(v, v),
                        _mm_shuffle_ps::<0b10_10_10_10>(v, v),
                    ]
                };
                Single {
                    origin: all(origin),
                    shear: all(shear),
                    t_min: _mm_set1_ps(ray.t_min),
                    axis: [16 * axis[0] as usize, 16 * axis[1] as usize, 16 * axis[2] as usize],
                }
            }

            /// A mask of the lanes that have a hit in range, and where.
            #[inline]
            #[target_feature(enable = $features)]
            fn hit(&self, block: &Block, t_max: f32) -> (u32, __m128) {
                let base = block.corner.as_ptr().cast::<u8>();
                let at = |corner: usize, k: usize| {
                    // SAFETY: three corners of three rows of 16 bytes, in a structure aligned to 16.
                    let row = unsafe { _mm_load_ps(base.add(48 * corner + self.axis[k]).cast()) };
                    _mm_sub_ps(row, self.origin[k])
                };
                let sheared = |corner: usize| {
                    let z = at(corner, 2);
                    let x = _mm_fnmadd_ps(self.shear[0], z, at(corner, 0));
                    let y = _mm_fnmadd_ps(self.shear[1], z, at(corner, 1));
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
                // No way out here: a branch that is often mistaken costs more than the rest.
                let det = _mm_add_ps(_mm_add_ps(u, v), w);
                let scaled = _mm_fmadd_ps(w, c.2, _mm_fmadd_ps(v, b.2, _mm_mul_ps(u, a.2)));
                let t = _mm_div_ps(_mm_mul_ps(scaled, self.shear[2]), det);
                // A det of 0 makes t infinite or not a number, which no comparison accepts.
                let after = _mm_cmpge_ps(t, self.t_min);
                let before = _mm_cmple_ps(t, _mm_set1_ps(t_max));
                let ok = _mm_and_ps(one_sided, _mm_and_ps(after, before));
                (_mm_movemask_ps(ok) as u32, _mm_blendv_ps(_mm_set1_ps(f32::INFINITY), t, ok))
            }
        }

        #[inline]
        #[target_feature(enable = $features)]
        fn nearest_lane(block: &Block, t: __m128) -> MeshHit {
            let pairs = _mm_min_ps(t, _mm_shuffle_ps::<0b10_11_00_01>(t, t));
            let least = _mm_min_ps(pairs, _mm_shuffle_ps::<0b01_00_11_10>(pairs, pairs));
            let lane = _mm_movemask_ps(_mm_cmpeq_ps(t, least)).trailing_zeros() as usize & 3;
            MeshHit { t: _mm_cvtss_f32(least), triangle: block.triangle[lane] }
        }

        /// A ray in double precision.
        struct Double {
            origin: [__m256d; 3],
            shear: [__m256d; 3],
            /// Byte offsets of the axes in a corner.
            axis: [usize; 3],
        }

        /// What [`Double::hit`] has found, a lane for each triangle.
        struct Hits {
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
                    axis: [16 * x, 16 * y, 16 * z],
                }
            }

            /// The hits with `range.0 < t < range.1`.
            #[inline]
            #[target_feature(enable = $features)]
            fn hit(&self, block: &Block, range: (f64, f64)) -> Hits {
                let base = block.corner.as_ptr().cast::<u8>();
                let at = |corner: usize, k: usize| {
                    // SAFETY: three corners of three rows of 16 bytes, in a structure aligned to 16.
                    let row = unsafe { _mm_load_ps(base.add(48 * corner + self.axis[k]).cast()) };
                    _mm256_sub_pd(_mm256_cvtps_pd(row), self.origin[k])
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
                    return Hits { mask: 0, t: zero, v, w, det };
                }
                let scaled = _mm256_fmadd_pd(w, c.2, _mm256_fmadd_pd(v, b.2, _mm256_mul_pd(u, a.2)));
                let t = _mm256_div_pd(_mm256_mul_pd(scaled, self.shear[2]), det);
                // A det of 0 makes t infinite or not a number, which no comparison accepts.
                let after = _mm256_cmp_pd::<_CMP_GT_OQ>(t, _mm256_set1_pd(range.0));
                let before = _mm256_cmp_pd::<_CMP_LT_OQ>(t, _mm256_set1_pd(range.1));
                let ok = _mm256_and_pd(one_sided, _mm256_and_pd(after, before));
                Hits { mask: _mm256_movemask_pd(ok) as u32, t, v, w, det }
            }
        }

        impl Hits {
            /// Shows all of them to `found`.
            #[inline]
            #[target_feature(enable = $features)]
            fn each(&self, block: &Block, mut found: impl FnMut(TriangleHit)) {
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
                        face: block.triangle[i],
                        u: v[i] / det[i],
                        v: w[i] / det[i],
                    });
                }
            }

            /// The nearest of them.
            #[inline]
            #[target_feature(enable = $features)]
            fn nearest(&self, block: &Block) -> Option<TriangleHit> {
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
