//! Lattice noise with AVX2: the same sums in the same order as in `lattice`, four numbers at a time, so that both give
//! the same bits. Many octaves in one call keep the processor's pipelines full.
//!
//! Invariants: nothing here fuses products with sums; indices into the tables are masked or come from the tables.
#![allow(unsafe_code)] // Wide loads take pointers; each has its reason.

use std::arch::x86_64::*;

use super::tables::{HASH, HASH_BYTES};
use super::values::VALUES;
use crate::{EPS, Vec3};

/// Added to a number below 2^51 it leaves the nearest whole number in the low bits of the sum.
const ROUND: f64 = 6_755_399_441_055_744.0;

/// The cell that a point lies in; compare `lattice::Cell`.
struct Cell {
    /// Where the numbers of each corner begin; x slowest, z fastest.
    corners: [usize; 8],
    /// Weight times (0.5, 1, way along y, way along z) for the four corners of a side.
    factors: [__m256d; 4],
    /// (fx, fx - 1): the ways along x from both sides.
    along_x: __m128d,
    sx: f64,
}

impl Cell {
    #[inline]
    #[target_feature(enable = "avx2")]
    fn at(c: __m256d) -> Cell {
        let zero = _mm256_setzero_pd();
        let one = _mm256_set1_pd(1.0);
        let nudge = _mm256_and_pd(_mm256_cmp_pd::<_CMP_LT_OQ>(c, zero), _mm256_set1_pd(EPS));
        let shifted = _mm256_add_pd(c, nudge);
        let rounded = _mm256_add_pd(shifted, _mm256_set1_pd(ROUND));
        let whole = _mm256_sub_pd(rounded, _mm256_set1_pd(ROUND));
        let above = _mm256_cmp_pd::<_CMP_GT_OQ>(whole, shifted);
        let f = _mm256_add_pd(_mm256_sub_pd(c, whole), _mm256_and_pd(above, one));
        let cells = _mm256_add_epi64(_mm256_castpd_si256(rounded), _mm256_set1_epi64x(10000));
        let cells = _mm256_add_epi64(cells, _mm256_castpd_si256(above));
        // s = f f (3 - 2 f), the weight curve between lattice points.
        let bent = _mm256_sub_pd(_mm256_set1_pd(3.0), _mm256_mul_pd(_mm256_set1_pd(2.0), f));
        let s = _mm256_mul_pd(_mm256_mul_pd(f, f), bent);
        let (f_xy, f_z) = (_mm256_castpd256_pd128(f), _mm256_extractf128_pd::<1>(f));
        let fx = _mm_cvtsd_f64(f_xy);
        Cell {
            corners: corners(cells),
            factors: factors(f_xy, f_z, s),
            along_x: _mm_set_pd(fx - 1.0, fx),
            sx: _mm256_cvtsd_f64(s),
        }
    }

    /// Channel `M` at the point.
    #[inline]
    #[target_feature(enable = "avx2")]
    fn channel<const M: usize>(&self) -> f64 {
        let part = |i: usize| {
            let at = self.corners[i] + 4 * M;
            // SAFETY: at + 3 <= 255 + 8 + 3, the last of 267 values.
            let row = unsafe { _mm256_loadu_pd(VALUES.as_ptr().add(at)) };
            _mm256_mul_pd(row, self.factors[i & 3])
        };
        let side = |i: usize| {
            let (low, high) = (_mm256_add_pd(part(i), part(i + 1)), _mm256_add_pd(part(i + 2), part(i + 3)));
            _mm256_add_pd(low, high)
        };
        let (near, far) = (side(0), side(4));
        // By pairs (near, far): value and y, x and z.
        let (vy, xz) = (_mm256_unpacklo_pd(near, far), _mm256_unpackhi_pd(near, far));
        let (v, y) = (_mm256_castpd256_pd128(vy), _mm256_extractf128_pd::<1>(vy));
        let (x, z) = (_mm256_castpd256_pd128(xz), _mm256_extractf128_pd::<1>(xz));
        let both = _mm_add_pd(_mm_add_pd(v, y), _mm_add_pd(z, _mm_mul_pd(x, self.along_x)));
        let (near, far) = (_mm_cvtsd_f64(both), _mm_cvtsd_f64(_mm_unpackhi_pd(both, both)));
        near + self.sx * (far - near)
    }

    #[inline]
    #[target_feature(enable = "avx2")]
    fn vector(&self) -> Vec3 {
        Vec3::new(self.channel::<0>(), self.channel::<1>(), self.channel::<2>())
    }
}

/// Where the numbers of the corners begin; at most 255.
#[inline]
#[target_feature(enable = "avx2")]
fn corners(cells: __m256i) -> [usize; 8] {
    let cells = _mm256_and_si256(cells, _mm256_set1_epi64x(4095));
    let (xy, z) = (_mm256_castsi256_si128(cells), _mm256_extracti128_si256::<1>(cells));
    let ix = _mm_cvtsi128_si64(xy) as usize;
    let iy = _mm_extract_epi64::<1>(xy) as usize;
    let iz = _mm_cvtsi128_si64(z) as usize;
    // SAFETY: cells and hashes lie below 4096, and so does every index.
    let hash = |i: usize| usize::from(unsafe { *HASH.get_unchecked(i) });
    let byte = |i: usize| usize::from(unsafe { *HASH_BYTES.get_unchecked(i) });
    let next = |i: usize| (i + 1) & 4095;
    let (x0, x1, y1, z1) = (hash(ix), hash(next(ix)), next(iy), next(iz));
    let (a, b, c, d) = (hash(x0 ^ iy), hash(x0 ^ y1), hash(x1 ^ iy), hash(x1 ^ y1));
    [
        byte(a ^ iz),
        byte(a ^ z1),
        byte(b ^ iz),
        byte(b ^ z1),
        byte(c ^ iz),
        byte(c ^ z1),
        byte(d ^ iz),
        byte(d ^ z1),
    ]
}

#[inline]
#[target_feature(enable = "avx2")]
fn factors(f_xy: __m128d, f_z: __m128d, s: __m256d) -> [__m256d; 4] {
    let ways = _mm256_set_m128d(_mm_shuffle_pd::<0b01>(f_xy, f_z), _mm_set_pd(1.0, 0.5));
    let ways_z = _mm256_sub_pd(ways, _mm256_set_pd(1.0, 0.0, 0.0, 0.0));
    let less_y = _mm256_set_pd(0.0, 1.0, 0.0, 0.0);
    let (ways_y, ways_yz) = (_mm256_sub_pd(ways, less_y), _mm256_sub_pd(ways_z, less_y));
    let sy = _mm256_permute4x64_pd::<0b01_01_01_01>(s);
    let sz = _mm256_permute4x64_pd::<0b10_10_10_10>(s);
    let one = _mm256_set1_pd(1.0);
    let (ty, tz) = (_mm256_sub_pd(one, sy), _mm256_sub_pd(one, sz));
    [
        _mm256_mul_pd(_mm256_mul_pd(ty, tz), ways),
        _mm256_mul_pd(_mm256_mul_pd(ty, sz), ways_z),
        _mm256_mul_pd(_mm256_mul_pd(sy, tz), ways_y),
        _mm256_mul_pd(_mm256_mul_pd(sy, sz), ways_yz),
    ]
}

/// Raw scalar noise, if the processor has AVX2.
#[inline]
pub(super) fn scalar(p: Vec3) -> Option<f64> {
    // SAFETY: the processor was asked.
    is_x86_feature_detected!("avx2").then(|| unsafe { one_scalar(p.x, p.y, p.z) })
}

/// Raw vector noise, if the processor has AVX2.
#[inline]
pub(super) fn vector(p: Vec3) -> Option<Vec3> {
    // SAFETY: the processor was asked.
    is_x86_feature_detected!("avx2").then(|| unsafe { one_vector(p.x, p.y, p.z) })
}

/// Raw scalar noise at `p` times `scale`, times `lambda` more for each that follows, if the processor has AVX2.
#[inline]
pub(super) fn scalars(p: Vec3, scale: f64, lambda: f64, out: &mut [f64]) -> Option<()> {
    // SAFETY: the processor was asked.
    is_x86_feature_detected!("avx2").then(|| unsafe { many_scalars(p.x, p.y, p.z, scale, lambda, out) })
}

/// Raw vector noise at `p` times `scale`, times `lambda` more for each that follows, if the processor has AVX2.
#[inline]
pub(super) fn vectors(p: Vec3, scale: f64, lambda: f64, out: &mut [Vec3]) -> Option<()> {
    // SAFETY: the processor was asked.
    is_x86_feature_detected!("avx2").then(|| unsafe { many_vectors(p.x, p.y, p.z, scale, lambda, out) })
}

// Coordinates come one by one, in registers: as a `Vec3` they would come in memory, just stored one by one, and a wide
// load of what was stored in parts has to wait.

#[target_feature(enable = "avx2")]
fn one_scalar(x: f64, y: f64, z: f64) -> f64 {
    Cell::at(_mm256_set_pd(0.0, z, y, x)).channel::<0>()
}

#[target_feature(enable = "avx2")]
fn one_vector(x: f64, y: f64, z: f64) -> Vec3 {
    Cell::at(_mm256_set_pd(0.0, z, y, x)).vector()
}

#[target_feature(enable = "avx2")]
fn many_scalars(x: f64, y: f64, z: f64, mut scale: f64, lambda: f64, out: &mut [f64]) {
    let p = _mm256_set_pd(0.0, z, y, x);
    for out in out {
        *out = Cell::at(_mm256_mul_pd(p, _mm256_set1_pd(scale))).channel::<0>();
        scale *= lambda;
    }
}

#[target_feature(enable = "avx2")]
fn many_vectors(x: f64, y: f64, z: f64, mut scale: f64, lambda: f64, out: &mut [Vec3]) {
    let p = _mm256_set_pd(0.0, z, y, x);
    for out in out {
        *out = Cell::at(_mm256_mul_pd(p, _mm256_set1_pd(scale))).vector();
        scale *= lambda;
    }
}
