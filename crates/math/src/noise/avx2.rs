//! Lattice noise with AVX2: the same sums in the same order as in `lattice`, for up to four points at a time, so that both
//! give the same bits. What belongs to a coordinate is worked out with a lane for each point, the hashes one by one, and
//! what belongs to a corner with a lane for each of its four numbers; then rows become columns and lanes are points again.
//! Several points keep the processor's pipelines full, where one is a long chain of waiting.
//!
//! Invariants: nothing here fuses products with sums; indices into the tables are masked or come from the tables.
#![allow(unsafe_code)] // Wide loads take pointers; each has its reason.

use std::arch::x86_64::*;

use super::lattice::{LANES, Octaves, Range};
use super::tables::{HASH, HASH_BYTES};
use super::values::VALUES;
use crate::{EPS, Vec3};

/// Added to a number below 2^51 it leaves the nearest whole number in the low bits of the sum.
const ROUND: f64 = 6_755_399_441_055_744.0;

/// A number for each point.
type Lanes = __m256d;

/// One coordinate of the points.
struct Axis {
    /// The cells, and the next ones, modulo 4096.
    cells: [u64; LANES],
    next: [u64; LANES],
    /// The way from the cell's lower side.
    f: Lanes,
    /// The weight curve there.
    s: Lanes,
}

impl Axis {
    #[inline]
    #[target_feature(enable = "avx2")]
    fn at(c: Lanes) -> Axis {
        let one = _mm256_set1_pd(1.0);
        let nudge = _mm256_and_pd(_mm256_cmp_pd::<_CMP_LT_OQ>(c, _mm256_setzero_pd()), _mm256_set1_pd(EPS));
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
        let masked = |cells| _mm256_and_si256(cells, _mm256_set1_epi64x(4095));
        let next = _mm256_add_epi64(cells, _mm256_set1_epi64x(1));
        Axis { cells: integers(masked(cells)), next: integers(masked(next)), f, s }
    }
}

#[inline]
#[target_feature(enable = "avx2")]
fn integers(v: __m256i) -> [u64; LANES] {
    let mut out = [0; LANES];
    // SAFETY: the array has the vector's 32 bytes; the store may be unaligned.
    unsafe { _mm256_storeu_si256(out.as_mut_ptr().cast(), v) };
    out
}

#[inline]
#[target_feature(enable = "avx2")]
fn numbers(v: Lanes) -> [f64; LANES] {
    let mut out = [0.0; LANES];
    // SAFETY: the array has the vector's 32 bytes; the store may be unaligned.
    unsafe { _mm256_storeu_pd(out.as_mut_ptr(), v) };
    out
}

/// Where the numbers of the eight corners begin, x slowest, z fastest; at most 255.
#[inline(always)]
fn corners([x, y, z]: &[Axis; 3], lane: usize) -> [usize; 8] {
    // SAFETY: cells and hashes lie below 4096, and so does every index.
    let hash = |i: u64| u64::from(unsafe { *HASH.get_unchecked(i as usize) });
    let byte = |i: u64| usize::from(unsafe { *HASH_BYTES.get_unchecked(i as usize) });
    let (y0, y1, z0, z1) = (y.cells[lane], y.next[lane], z.cells[lane], z.next[lane]);
    let (x0, x1) = (hash(x.cells[lane]), hash(x.next[lane]));
    let (a, b, c, d) = (hash(x0 ^ y0), hash(x0 ^ y1), hash(x1 ^ y0), hash(x1 ^ y1));
    [
        byte(a ^ z0),
        byte(a ^ z1),
        byte(b ^ z0),
        byte(b ^ z1),
        byte(c ^ z0),
        byte(c ^ z1),
        byte(d ^ z0),
        byte(d ^ z1),
    ]
}

/// What the corners' numbers are multiplied by, but for the way and the weight along x.
struct Factors {
    /// For each point (0.5, 1, way along y, way along z).
    ways: [Lanes; LANES],
    /// Weights of the four corners of a side, for each point.
    weights: [[f64; LANES]; 4],
}

impl Factors {
    #[inline]
    #[target_feature(enable = "avx2")]
    fn new(y: &Axis, z: &Axis) -> Factors {
        let one = _mm256_set1_pd(1.0);
        let (ty, tz) = (_mm256_sub_pd(one, y.s), _mm256_sub_pd(one, z.s));
        let (even, odd) = (_mm256_unpacklo_pd(y.f, z.f), _mm256_unpackhi_pd(y.f, z.f));
        let start = _mm256_set_pd(1.0, 0.5, 1.0, 0.5);
        Factors {
            ways: [
                _mm256_permute2f128_pd::<0x20>(start, even),
                _mm256_permute2f128_pd::<0x20>(start, odd),
                _mm256_permute2f128_pd::<0x30>(start, even),
                _mm256_permute2f128_pd::<0x30>(start, odd),
            ],
            weights: [
                numbers(_mm256_mul_pd(ty, tz)),
                numbers(_mm256_mul_pd(ty, z.s)),
                numbers(_mm256_mul_pd(y.s, tz)),
                numbers(_mm256_mul_pd(y.s, z.s)),
            ],
        }
    }

    /// For the four corners of a side, those of one point.
    #[inline]
    #[target_feature(enable = "avx2")]
    fn of(&self, lane: usize) -> [Lanes; 4] {
        let ways = self.ways[lane];
        let less_y = _mm256_set_pd(0.0, 1.0, 0.0, 0.0);
        let ways_z = _mm256_sub_pd(ways, _mm256_set_pd(1.0, 0.0, 0.0, 0.0));
        let (ways_y, ways_yz) = (_mm256_sub_pd(ways, less_y), _mm256_sub_pd(ways_z, less_y));
        let times = |i: usize, ways| _mm256_mul_pd(_mm256_set1_pd(self.weights[i][lane]), ways);
        [times(0, ways), times(1, ways_z), times(2, ways_y), times(3, ways_yz)]
    }
}

/// The sum over the four corners of a side: from value, and slopes along x, y and z.
#[inline]
#[target_feature(enable = "avx2")]
fn side<const M: usize>(corners: &[usize], factors: &[Lanes; 4]) -> Lanes {
    let part = |i: usize| {
        // SAFETY: corner + 4 M + 3 <= 255 + 8 + 3, the last of 267 values.
        let row = unsafe { _mm256_loadu_pd(VALUES.as_ptr().add(corners[i] + 4 * M)) };
        _mm256_mul_pd(row, factors[i])
    };
    _mm256_add_pd(_mm256_add_pd(part(0), part(1)), _mm256_add_pd(part(2), part(3)))
}

/// Columns from rows.
#[inline]
#[target_feature(enable = "avx2")]
fn transposed([a, b, c, d]: [Lanes; LANES]) -> [Lanes; LANES] {
    let (ab_lo, ab_hi) = (_mm256_unpacklo_pd(a, b), _mm256_unpackhi_pd(a, b));
    let (cd_lo, cd_hi) = (_mm256_unpacklo_pd(c, d), _mm256_unpackhi_pd(c, d));
    [
        _mm256_permute2f128_pd::<0x20>(ab_lo, cd_lo),
        _mm256_permute2f128_pd::<0x20>(ab_hi, cd_hi),
        _mm256_permute2f128_pd::<0x31>(ab_lo, cd_lo),
        _mm256_permute2f128_pd::<0x31>(ab_hi, cd_hi),
    ]
}

/// What a side's sums come to at this way along x from it.
#[inline]
#[target_feature(enable = "avx2")]
fn from_side(sums: [Lanes; LANES], way: Lanes) -> Lanes {
    let [v, x, y, z] = transposed(sums);
    _mm256_add_pd(_mm256_add_pd(v, y), _mm256_add_pd(z, _mm256_mul_pd(x, way)))
}

/// Between the sides of the cell.
#[inline]
#[target_feature(enable = "avx2")]
fn between(x: &Axis, near: [Lanes; LANES], far: [Lanes; LANES]) -> Lanes {
    let near = from_side(near, x.f);
    let far = from_side(far, _mm256_sub_pd(x.f, _mm256_set1_pd(1.0)));
    _mm256_add_pd(near, _mm256_mul_pd(x.s, _mm256_sub_pd(far, near)))
}

/// Raw scalar noise at the first `N` points.
#[inline]
#[target_feature(enable = "avx2")]
fn scalar_lanes<const N: usize>(p: [Lanes; 3]) -> Lanes {
    let axes = [Axis::at(p[0]), Axis::at(p[1]), Axis::at(p[2])];
    let factors = Factors::new(&axes[1], &axes[2]);
    let (mut near, mut far) = ([_mm256_setzero_pd(); LANES], [_mm256_setzero_pd(); LANES]);
    for lane in 0..N {
        let (corners, factors) = (corners(&axes, lane), factors.of(lane));
        near[lane] = side::<0>(&corners[..4], &factors);
        far[lane] = side::<0>(&corners[4..], &factors);
    }
    between(&axes[0], near, far)
}

/// Raw vector noise at the first `N` points, one channel after the other.
#[inline]
#[target_feature(enable = "avx2")]
fn vector_lanes<const N: usize>(p: [Lanes; 3]) -> [Lanes; 3] {
    let axes = [Axis::at(p[0]), Axis::at(p[1]), Axis::at(p[2])];
    let factors = Factors::new(&axes[1], &axes[2]);
    let nothing = [_mm256_setzero_pd(); LANES];
    let (mut near, mut far) = ([nothing; 3], [nothing; 3]);
    for lane in 0..N {
        let (corners, factors) = (corners(&axes, lane), factors.of(lane));
        (near[0][lane], far[0][lane]) =
            (side::<0>(&corners[..4], &factors), side::<0>(&corners[4..], &factors));
        (near[1][lane], far[1][lane]) =
            (side::<1>(&corners[..4], &factors), side::<1>(&corners[4..], &factors));
        (near[2][lane], far[2][lane]) =
            (side::<2>(&corners[..4], &factors), side::<2>(&corners[4..], &factors));
    }
    let x = &axes[0];
    [between(x, near[0], far[0]), between(x, near[1], far[1]), between(x, near[2], far[2])]
}

/// The point at the scales of the next four octaves.
#[inline]
#[target_feature(enable = "avx2")]
fn four_octaves(x: f64, y: f64, z: f64, scale: &mut f64, lambda: f64) -> [Lanes; 3] {
    let a = *scale;
    let b = a * lambda;
    let c = b * lambda;
    let d = c * lambda;
    *scale = d * lambda;
    let scales = _mm256_set_pd(d, c, b, a);
    let scaled = |v: f64| _mm256_mul_pd(_mm256_set1_pd(v), scales);
    [scaled(x), scaled(y), scaled(z)]
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

/// Scalar noise in the generator's range at four points, if the processor has AVX2.
#[inline]
pub(super) fn four(p: &[Vec3; LANES], range: Range) -> Option<[f64; LANES]> {
    // SAFETY: the processor was asked.
    is_x86_feature_detected!("avx2").then(|| unsafe { four_scalars(p, range) })
}

/// Scalar noise in the generator's range of the first `count` octaves, if the processor has AVX2.
#[inline]
pub(super) fn scalars(octaves: &Octaves, range: Range, out: &mut [[f64; LANES]]) -> Option<()> {
    let Octaves { p, scale, lambda, count } = *octaves;
    // SAFETY: the processor was asked.
    is_x86_feature_detected!("avx2")
        .then(|| unsafe { many_scalars(p.x, p.y, p.z, scale, lambda, count, range, out) })
}

/// Raw vector noise of the first `count` octaves, channel by channel, if the processor has AVX2.
#[inline]
pub(super) fn vectors(octaves: &Octaves, out: &mut [[[f64; LANES]; 3]]) -> Option<()> {
    let Octaves { p, scale, lambda, count } = *octaves;
    // SAFETY: the processor was asked.
    is_x86_feature_detected!("avx2")
        .then(|| unsafe { many_vectors(p.x, p.y, p.z, scale, lambda, count, out) })
}

// Coordinates come one by one, in registers: as a `Vec3` they would come in memory, just stored one by one, and a wide
// load of what was stored in parts has to wait.

#[target_feature(enable = "avx2")]
fn one_scalar(x: f64, y: f64, z: f64) -> f64 {
    let p = [_mm256_set1_pd(x), _mm256_set1_pd(y), _mm256_set1_pd(z)];
    _mm256_cvtsd_f64(scalar_lanes::<1>(p))
}

#[target_feature(enable = "avx2")]
fn one_vector(x: f64, y: f64, z: f64) -> Vec3 {
    let p = [_mm256_set1_pd(x), _mm256_set1_pd(y), _mm256_set1_pd(z)];
    Vec3::from(vector_lanes::<1>(p).map(|v| _mm256_cvtsd_f64(v)))
}

/// Raw noise in the generator's range; a NaN becomes 0.
#[inline]
#[target_feature(enable = "avx2")]
fn ranged(raw: Lanes, range: Range) -> Lanes {
    let v = _mm256_mul_pd(_mm256_add_pd(raw, _mm256_set1_pd(range.add)), _mm256_set1_pd(range.times));
    _mm256_min_pd(_mm256_max_pd(v, _mm256_setzero_pd()), _mm256_set1_pd(1.0))
}

#[target_feature(enable = "avx2")]
fn four_scalars([a, b, c, d]: &[Vec3; LANES], range: Range) -> [f64; LANES] {
    let x = _mm256_set_pd(d.x, c.x, b.x, a.x);
    let y = _mm256_set_pd(d.y, c.y, b.y, a.y);
    let z = _mm256_set_pd(d.z, c.z, b.z, a.z);
    numbers(ranged(scalar_lanes::<LANES>([x, y, z]), range))
}

#[target_feature(enable = "avx2")]
fn many_scalars(
    x: f64,
    y: f64,
    z: f64,
    mut scale: f64,
    lambda: f64,
    count: usize,
    range: Range,
    out: &mut [[f64; LANES]],
) {
    for (k, out) in out.iter_mut().enumerate() {
        let p = four_octaves(x, y, z, &mut scale, lambda);
        let raw = match count.saturating_sub(LANES * k) {
            0 => return,
            1 | 2 => scalar_lanes::<2>(p),
            3 => scalar_lanes::<3>(p),
            _ => scalar_lanes::<4>(p),
        };
        *out = numbers(ranged(raw, range));
    }
}

#[target_feature(enable = "avx2")]
fn many_vectors(
    x: f64,
    y: f64,
    z: f64,
    mut scale: f64,
    lambda: f64,
    count: usize,
    out: &mut [[[f64; LANES]; 3]],
) {
    for (k, out) in out.iter_mut().enumerate() {
        let p = four_octaves(x, y, z, &mut scale, lambda);
        let [x, y, z] = match count.saturating_sub(LANES * k) {
            0 => return,
            1 | 2 => vector_lanes::<2>(p),
            3 => vector_lanes::<3>(p),
            _ => vector_lanes::<4>(p),
        };
        *out = [numbers(x), numbers(y), numbers(z)];
    }
}
