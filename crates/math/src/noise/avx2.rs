//! Lattice noise with AVX2: the same sums in the same order as in `lattice`, for up to four points at a time, so that both
//! give the same bits. What belongs to a coordinate is worked out with a lane for each point, the hashes one by one, and
//! what belongs to a corner with a lane for each of its four numbers; then rows become columns and lanes are points again.
//! Several points keep the processor's pipelines full, where one is a long chain of waiting.
//!
//! Invariants: nothing here fuses products with sums; indices into the tables are masked or come from the tables.
#![allow(unsafe_code)] // Wide loads take pointers; each has its reason.

use std::arch::x86_64::*;

use super::lattice::{LANES, Octaves, Range};
use super::tables::{HASH, HASH_ROWS, ROWS};
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

/// Where the rows of the eight corners begin, x slowest, z fastest; at most 255 times 4.
#[inline(always)]
fn corners([x, y, z]: &[Axis; 3], lane: usize) -> [usize; 8] {
    // SAFETY: cells and hashes lie below 4096, and so does every index.
    let hash = |i: u64| u64::from(unsafe { *HASH.get_unchecked(i as usize) });
    let row = |i: u64| usize::from(unsafe { *HASH_ROWS.get_unchecked(i as usize) });
    // Read from memory, where they are: the compiler would take each out of a vector, for which there is one unit.
    let read = |v: &[u64; LANES]| alone(&v[lane]);
    let (y0, y1, z0, z1) = (read(&y.cells), read(&y.next), read(&z.cells), read(&z.next));
    let (x0, x1) = (hash(read(&x.cells)), hash(read(&x.next)));
    let (a, b, c, d) = (hash(x0 ^ y0), hash(x0 ^ y1), hash(x1 ^ y0), hash(x1 ^ y1));
    [row(a ^ z0), row(a ^ z1), row(b ^ z0), row(b ^ z1), row(c ^ z0), row(c ^ z1), row(d ^ z0), row(d ^ z1)]
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
        // SAFETY: corner + 16 M + 3 <= 4 * 255 + 32 + 3 lies within the rows. Rows are aligned, and places are multiples of 4.
        let row = unsafe { _mm256_load_pd(ROWS.0.as_ptr().add(corners[i] + 16 * M)) };
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

/// Raw scalar noise at the first `N` points. By the ABI of C lanes come and go in registers; in Rust's own, in memory.
#[allow(improper_ctypes_definitions)] // It is called from here only.
#[target_feature(enable = "avx2")]
extern "C" fn scalar_lanes<const N: usize>(x: Lanes, y: Lanes, z: Lanes) -> Lanes {
    let axes = [Axis::at(x), Axis::at(y), Axis::at(z)];
    let factors = Factors::new(&axes[1], &axes[2]);
    let sides = |lane: usize| {
        if lane >= N {
            return (_mm256_setzero_pd(), _mm256_setzero_pd());
        }
        let (corners, factors) = (corners(&axes, lane), factors.of(lane));
        (side::<0>(&corners[..4], &factors), side::<0>(&corners[4..], &factors))
    };
    let (a, b, c, d) = (sides(0), sides(1), sides(2), sides(3));
    between(&axes[0], [a.0, b.0, c.0, d.0], [a.1, b.1, c.1, d.1])
}

/// What vector noise at `N` points is made of.
struct Cells<const N: usize> {
    x: Axis,
    factors: Factors,
    places: [[usize; 8]; N],
}

impl<const N: usize> Cells<N> {
    #[inline]
    #[target_feature(enable = "avx2")]
    fn at(p: [Lanes; 3]) -> Cells<N> {
        let axes = [Axis::at(p[0]), Axis::at(p[1]), Axis::at(p[2])];
        let factors = Factors::new(&axes[1], &axes[2]);
        // All hashes first, so that their long chains of loads run side by side.
        let mut places = [[0; 8]; N];
        for (lane, place) in places.iter_mut().enumerate() {
            *place = corners(&axes, lane);
        }
        let [x, _, _] = axes;
        Cells { x, factors, places }
    }

    /// Raw vector noise, one channel after the other.
    #[inline]
    #[target_feature(enable = "avx2")]
    fn vectors(&self) -> [Lanes; 3] {
        let sides = |lane: usize| {
            if lane >= N {
                return [[_mm256_setzero_pd(); 2]; 3];
            }
            let factors = self.factors.of(lane);
            let (near, far) = self.places[lane].split_at(4);
            [
                [side::<0>(near, &factors), side::<0>(far, &factors)],
                [side::<1>(near, &factors), side::<1>(far, &factors)],
                [side::<2>(near, &factors), side::<2>(far, &factors)],
            ]
        };
        let (a, b, c, d) = (sides(0), sides(1), sides(2), sides(3));
        let channel = |m: usize| {
            between(&self.x, [a[m][0], b[m][0], c[m][0], d[m][0]], [a[m][1], b[m][1], c[m][1], d[m][1]])
        };
        [channel(0), channel(1), channel(2)]
    }
}

/// Raw vector noise at the first `N` points, one channel after the other.
#[inline]
#[target_feature(enable = "avx2")]
fn vector_lanes<const N: usize>(p: [Lanes; 3]) -> [Lanes; 3] {
    Cells::<N>::at(p).vectors()
}

/// The same at four points and `N` others, a sixth faster than one after the other: what the second waits for runs
/// beside the first.
#[inline]
#[target_feature(enable = "avx2")]
fn two_vector_lanes<const N: usize>(p: [Lanes; 3], q: [Lanes; 3]) -> [[Lanes; 3]; 2] {
    let (a, b) = (Cells::<LANES>::at(p), Cells::<N>::at(q));
    [a.vectors(), b.vectors()]
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

/// The sum of what becomes of octaves, if the processor has AVX2; see [`octave_sum`](super::octave_sum).
#[inline]
pub(super) fn scalar_sum<const N: usize>(
    octaves: &Octaves,
    range: &Range,
    sum: (f64, f64, f64),
    octave: impl Fn(usize, f64) -> f64 + Copy,
) -> Option<(f64, f64)> {
    let Octaves { p, scale, lambda, count } = *octaves;
    // SAFETY: the processor was asked.
    is_x86_feature_detected!("avx2")
        .then(|| unsafe { summed_scalars::<N>(p.x, p.y, p.z, scale, lambda, sum, count, range, octave) })
}

/// Raw vector noise of the first `count` octaves, channel by channel, if the processor has AVX2.
#[inline]
pub(super) fn vectors(octaves: &Octaves, out: &mut [[[f64; LANES]; 3]]) -> Option<()> {
    let Octaves { p, scale, lambda, count } = *octaves;
    // SAFETY: the processor was asked.
    is_x86_feature_detected!("avx2")
        .then(|| unsafe { many_vectors(p.x, p.y, p.z, scale, lambda, count, out) })
}

/// The sum of raw vector noise over octaves, each `omega` times as strong as the one before, if the processor has AVX2.
#[inline]
pub(super) fn vector_sum(octaves: &Octaves, omega: f64) -> Option<Vec3> {
    let Octaves { p, scale, lambda, count } = *octaves;
    // SAFETY: the processor was asked.
    is_x86_feature_detected!("avx2")
        .then(|| unsafe { summed_vectors(p.x, p.y, p.z, scale, lambda, count, omega) })
}

// Coordinates come one by one, in registers: as a `Vec3` they would come in memory, just stored one by one, and a wide
// load of what was stored in parts has to wait.

#[target_feature(enable = "avx2")]
fn one_scalar(x: f64, y: f64, z: f64) -> f64 {
    let lanes = scalar_lanes::<1>(_mm256_set1_pd(x), _mm256_set1_pd(y), _mm256_set1_pd(z));
    _mm256_cvtsd_f64(lanes)
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

/// A number read by itself. The compiler joins loads of neighbours, and one that is wider than what was just stored there
/// has to wait for the stores to be done with.
#[inline(always)]
fn alone<T: Copy>(v: &T) -> T {
    // SAFETY: a reference may be read.
    unsafe { std::ptr::read_volatile(v) }
}

#[target_feature(enable = "avx2")]
fn four_scalars([a, b, c, d]: &[Vec3; LANES], range: Range) -> [f64; LANES] {
    let x = _mm256_set_pd(alone(&d.x), alone(&c.x), alone(&b.x), alone(&a.x));
    let y = _mm256_set_pd(alone(&d.y), alone(&c.y), alone(&b.y), alone(&a.y));
    let z = _mm256_set_pd(alone(&d.z), alone(&c.z), alone(&b.z), alone(&a.z));
    numbers(ranged(scalar_lanes::<LANES>(x, y, z), range))
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
        let [x, y, z] = four_octaves(x, y, z, &mut scale, lambda);
        let raw = match count.saturating_sub(LANES * k) {
            0 => return,
            1 | 2 => scalar_lanes::<2>(x, y, z),
            3 => scalar_lanes::<3>(x, y, z),
            _ => scalar_lanes::<4>(x, y, z),
        };
        *out = numbers(ranged(raw, range));
    }
}

/// `N` is the number of octaves, or 0 where `count` is that.
#[target_feature(enable = "avx2")]
fn summed_scalars<const N: usize>(
    x: f64,
    y: f64,
    z: f64,
    mut scale: f64,
    lambda: f64,
    (mut sum, mut weight, omega): (f64, f64, f64),
    count: usize,
    range: &Range,
    octave: impl Fn(usize, f64) -> f64 + Copy,
) -> (f64, f64) {
    let count = if N > 0 { N } else { count };
    let mut done = 0;
    while done < count {
        let [x, y, z] = four_octaves(x, y, z, &mut scale, lambda);
        let raw = match count - done {
            1 | 2 => scalar_lanes::<2>(x, y, z),
            3 => scalar_lanes::<3>(x, y, z),
            _ => scalar_lanes::<4>(x, y, z),
        };
        let values = numbers(ranged(raw, *range));
        for (i, &n) in values.iter().enumerate().take(count - done) {
            sum += weight * octave(done + i, n);
            weight *= omega;
        }
        done += LANES;
    }
    (sum, weight)
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

#[target_feature(enable = "avx2")]
fn summed_vectors(x: f64, y: f64, z: f64, mut scale: f64, lambda: f64, count: usize, omega: f64) -> Vec3 {
    let (mut sum, mut weight) = ([0.0; 3], 1.0);
    let mut left = count;
    let mut add = |noise: [Lanes; 3], count: usize| {
        let [x, y, z] = [numbers(noise[0]), numbers(noise[1]), numbers(noise[2])];
        for i in 0..count {
            sum = [sum[0] + x[i] * weight, sum[1] + y[i] * weight, sum[2] + z[i] * weight];
            weight *= omega;
        }
    };
    while left > LANES {
        let p = four_octaves(x, y, z, &mut scale, lambda);
        let q = four_octaves(x, y, z, &mut scale, lambda);
        let [first, second] = match left - LANES {
            1 | 2 => two_vector_lanes::<2>(p, q),
            _ => two_vector_lanes::<4>(p, q),
        };
        add(first, LANES);
        add(second, LANES.min(left - LANES));
        left = left.saturating_sub(2 * LANES);
    }
    if left > 0 {
        let p = four_octaves(x, y, z, &mut scale, lambda);
        let noise = match left {
            1 | 2 => vector_lanes::<2>(p),
            3 => vector_lanes::<3>(p),
            _ => vector_lanes::<4>(p),
        };
        add(noise, left);
    }
    Vec3::from(sum)
}
