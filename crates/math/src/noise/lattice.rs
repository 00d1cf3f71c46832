//! Lattice noise: a value and a gradient at each integer point, mixed between (textures spec, section 1.2).
//!
//! What stands here runs everywhere and says what noise is; `avx2` does the same where it can.
#[cfg(target_arch = "x86_64")]
use super::avx2;
use super::tables::HASH;
use super::values::VALUES;
use super::{clamp01, s_curve};
use crate::{EPS, Vec3};
use wide::f64x4;

/// Added to a number below 2^51 it leaves the nearest whole number in the low bits of the sum.
const ROUND: f64 = 6_755_399_441_055_744.0;

/// Where a coordinate falls: the lattice cell, masked, and the distance from its lower side. A coordinate within `EPS`
/// below a whole number belongs to the upper cell on the negative side. Beyond 2^51 the answer means nothing.
#[inline]
fn split(c: f64) -> (usize, f64) {
    let shifted = if c < 0.0 { c + EPS } else { c };
    let rounded = shifted + ROUND;
    let whole = rounded - ROUND;
    let above = whole > shifted;
    let cell = rounded.to_bits().wrapping_add(10000).wrapping_sub(u64::from(above));
    ((cell & 4095) as usize, c - whole + if above { 1.0 } else { 0.0 })
}

/// The cell that a point lies in, with all that its channels share.
///
/// A corner holds a value and a gradient, four numbers in a row; what it adds is their product with the corner's
/// weight times (0.5, and the way from the corner). `factors` has those products for the four corners of one side
/// but for the weight and the way along x, which [`Cell::channel`] multiplies in last.
struct Cell {
    /// Indices into the values, x slowest, z fastest.
    corners: [usize; 8],
    factors: [f64x4; 4],
    fx: f64,
    sx: f64,
}

impl Cell {
    #[inline(always)]
    fn at(p: Vec3) -> Cell {
        let ((ix, fx), (iy, fy), (iz, fz)) = (split(p.x), split(p.y), split(p.z));
        let (sy, sz) = (s_curve(fy), s_curve(fz));
        let h = |i: usize| usize::from(HASH[i & 4095]);
        let (x0, x1) = (h(ix), h(ix + 1));
        let sides = [h(x0 ^ iy), h(x0 ^ (iy + 1)), h(x1 ^ iy), h(x1 ^ (iy + 1))];
        let corner = |side: usize, dz: usize| h(sides[side] ^ (iz + dz)) & 255;
        let corners = [
            corner(0, 0),
            corner(0, 1),
            corner(1, 0),
            corner(1, 1),
            corner(2, 0),
            corner(2, 1),
            corner(3, 0),
            corner(3, 1),
        ];
        let factor = |wy: f64, wz: f64, fy: f64, fz: f64| {
            let w = wy * wz;
            f64x4::new([0.5 * w, w, w * fy, w * fz])
        };
        let factors = [
            factor(1.0 - sy, 1.0 - sz, fy, fz),
            factor(1.0 - sy, sz, fy, fz - 1.0),
            factor(sy, 1.0 - sz, fy - 1.0, fz),
            factor(sy, sz, fy - 1.0, fz - 1.0),
        ];
        Cell { corners, factors, fx, sx: s_curve(fx) }
    }

    /// Channel `M` at the point. Inlined always: what the corners share then stays in registers.
    #[inline(always)]
    fn channel<const M: usize>(&self) -> f64 {
        let part = |i: usize| {
            let at = (self.corners[i] & 255) + 4 * M;
            let row = f64x4::new([VALUES[at], VALUES[at + 1], VALUES[at + 2], VALUES[at + 3]]);
            row * self.factors[i & 3]
        };
        let side = |i: usize| ((part(i) + part(i + 1)) + (part(i + 2) + part(i + 3))).to_array();
        let ([value, x, y, z], [value1, x1, y1, z1]) = (side(0), side(4));
        let near = (value + y) + (z + x * self.fx);
        let far = (value1 + y1) + (z1 + x1 * (self.fx - 1.0));
        near + self.sx * (far - near)
    }

    #[inline(always)]
    fn scalar(&self) -> f64 {
        self.channel::<0>()
    }

    #[inline(always)]
    fn vector(&self) -> Vec3 {
        Vec3::new(self.channel::<0>(), self.channel::<1>(), self.channel::<2>())
    }
}

/// What the corners of a lattice cell, named by its least one, hold for raw scalar noise: value and gradient. x is
/// slowest, z fastest. The noise is the sum of value and way along the gradient of each corner, weighted by
/// `3 f^2 - 2 f^3` of the way towards it along each axis.
pub fn corners(least: [f64; 3]) -> [[f64; 4]; 8] {
    Cell::at(Vec3::from(least) + Vec3::splat(0.5)).corners.map(|at| {
        let row = &VALUES[at..at + 4];
        [0.5 * row[0], row[1], row[2], row[3]]
    })
}

/// Raw scalar noise, about -0.95 to 0.95.
#[inline]
pub(super) fn scalar(p: Vec3) -> f64 {
    #[cfg(target_arch = "x86_64")]
    if let Some(noise) = avx2::scalar(p) {
        return noise;
    }
    Cell::at(p).scalar()
}

/// Points or octaves that are worked out together.
pub(super) const LANES: usize = 4;

/// From raw noise to the numbers of a generator: `add` first.
#[derive(Clone, Copy, Debug)]
pub(super) struct Range {
    pub add: f64,
    pub times: f64,
}

impl Range {
    /// A NaN becomes 0.
    #[inline]
    pub fn apply(self, raw: f64) -> f64 {
        clamp01((raw + self.add) * self.times)
    }
}

/// Noise at `p` times `scale`, times `lambda` more for each octave that follows, `count` in all.
#[derive(Clone, Copy, Debug)]
pub(super) struct Octaves {
    pub p: Vec3,
    pub scale: f64,
    pub lambda: f64,
    pub count: usize,
}

impl Octaves {
    /// The points of all octaves.
    pub fn points(self) -> impl Iterator<Item = Vec3> {
        std::iter::successors(Some(self.scale), move |scale| Some(scale * self.lambda))
            .take(self.count)
            .map(move |scale| self.p * scale)
    }
}

/// Scalar noise of a generator, octave by octave. Places of `out` beyond the last one may hold anything.
#[inline]
pub(super) fn scalars(octaves: &Octaves, range: Range, out: &mut [[f64; LANES]]) {
    #[cfg(target_arch = "x86_64")]
    if avx2::scalars(octaves, range, out).is_some() {
        return;
    }
    for (p, out) in octaves.points().zip(out.as_flattened_mut()) {
        *out = range.apply(Cell::at(p).scalar());
    }
}

/// The sum of what `octave` makes of the noise of each, and the weight of the next. `N` is their number, or 0 where it
/// is not known beforehand. A sum begins with what there is of it, a weight, and what that is multiplied by for the next.
#[inline]
pub(super) fn scalar_sum<const N: usize>(
    octaves: &Octaves,
    range: &Range,
    (mut sum, mut weight, omega): (f64, f64, f64),
    octave: impl Fn(usize, f64) -> f64 + Copy,
) -> (f64, f64) {
    #[cfg(target_arch = "x86_64")]
    if let Some(sum) = avx2::scalar_sum::<N>(octaves, range, (sum, weight, omega), octave) {
        return sum;
    }
    for (i, p) in octaves.points().enumerate() {
        sum += weight * octave(i, range.apply(Cell::at(p).scalar()));
        weight *= omega;
    }
    (sum, weight)
}

/// Scalar noise of a generator at four points.
#[inline]
pub(super) fn four(p: &[Vec3; LANES], range: Range) -> [f64; LANES] {
    #[cfg(target_arch = "x86_64")]
    if let Some(noises) = avx2::four(p, range) {
        return noises;
    }
    p.map(|p| range.apply(Cell::at(p).scalar()))
}

/// Vector noise at a point: three channels of lattice noise, each about -1 to 1, the same for every generator.
#[inline]
pub fn dnoise(p: Vec3) -> Vec3 {
    #[cfg(target_arch = "x86_64")]
    if let Some(noise) = avx2::vector(p) {
        return noise;
    }
    Cell::at(p).vector()
}

/// Vector noise, octave by octave, channel by channel. Places of `out` beyond the last one may hold anything.
#[inline]
pub(super) fn vectors(octaves: &Octaves, out: &mut [[[f64; LANES]; 3]]) {
    #[cfg(target_arch = "x86_64")]
    if avx2::vectors(octaves, out).is_some() {
        return;
    }
    for (i, p) in octaves.points().enumerate() {
        let noise = Cell::at(p).vector();
        for (channel, value) in out[i / LANES].iter_mut().zip(noise.to_array()) {
            channel[i % LANES] = value;
        }
    }
}

/// The sum of vector noise over octaves, each `omega` times as strong as the one before.
#[inline]
pub(super) fn vector_sum(octaves: &Octaves, omega: f64) -> Vec3 {
    #[cfg(target_arch = "x86_64")]
    if let Some(sum) = avx2::vector_sum(octaves, omega) {
        return sum;
    }
    let (mut sum, mut weight) = (Vec3::ZERO, 1.0);
    for p in octaves.points() {
        sum += Cell::at(p).vector() * weight;
        weight *= omega;
    }
    sum
}

#[cfg(all(test, target_arch = "x86_64"))]
mod tests {
    use super::*;

    #[test]
    fn both_ways_give_the_same_bits() {
        for i in 0..20_000 {
            let t = f64::from(i);
            let p = match i % 4 {
                0 => Vec3::new(t * 0.37 - 900.0, 130.0 - t * 0.11, t * 0.0053),
                1 => Vec3::new(-t, t * 0.5, 3.0 - EPS / 2.0),
                2 => Vec3::new(t * 1e5, -t * 7.7e6, 0.1 * t),
                _ => Vec3::new(-1e-12 * t, -0.0, t - 1e-9),
            };
            let (scalar, vector) = (Cell::at(p).scalar(), Cell::at(p).vector());
            let Some(wide) = avx2::scalar(p) else { return };
            assert_eq!(scalar, wide, "{p}");
            assert_eq!(Some(vector), avx2::vector(p), "{p}");
            for count in 1..=7 {
                octaves_give_the_same_bits(&Octaves { p, scale: 1.5, lambda: 2.1, count });
            }
            let range = Range { add: 0.5, times: 1.25 };
            let points = [p, p + 0.3, p - Vec3::Y, 2.0 * p];
            let each = points.map(|p| range.apply(Cell::at(p).scalar()));
            assert_eq!(Some(each), avx2::four(&points, range), "{p}");
        }
    }

    fn octaves_give_the_same_bits(octaves: &Octaves) {
        let range = Range { add: 0.5, times: 1.25 };
        let (mut scalars, mut vectors) = ([[0.0; LANES]; 2], [[[0.0; LANES]; 3]; 2]);
        avx2::scalars(octaves, range, &mut scalars);
        avx2::vectors(octaves, &mut vectors);
        for (i, p) in octaves.points().enumerate() {
            let (vector, [x, y, z]) = (Cell::at(p).vector(), vectors[i / LANES]);
            assert_eq!(scalars.as_flattened()[i], range.apply(Cell::at(p).scalar()), "{octaves:?} {i}");
            assert_eq!(vector.to_array(), [x, y, z].map(|v| v[i % LANES]), "{octaves:?} {i}");
        }
        let (mut sum, mut weight) = (Vec3::ZERO, 1.0);
        for p in octaves.points() {
            sum += Cell::at(p).vector() * weight;
            weight *= 0.7;
        }
        assert_eq!(avx2::vector_sum(octaves, 0.7), Some(sum), "{octaves:?}");
        let bent = |i: usize, n: f64| n * n + i as f64;
        let (mut sum, mut weight) = (0.1, 0.9);
        for (i, p) in octaves.points().enumerate() {
            sum += weight * bent(i, range.apply(Cell::at(p).scalar()));
            weight *= 0.6;
        }
        let start = (0.1, 0.9, 0.6);
        assert_eq!(avx2::scalar_sum::<0>(octaves, &range, start, bent), Some((sum, weight)), "{octaves:?}");
        if octaves.count == 6 {
            assert_eq!(avx2::scalar_sum::<6>(octaves, &range, start, bent), Some((sum, weight)));
        }
    }
}
