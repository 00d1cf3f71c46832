//! The superellipsoid (shapes spec, section 2).
//!
//! `f` is the norm-like `g(g(|x|, |y|; 2/e), |z|; 2/n) - 1` with `g(a, b; k) = (a^k + b^k)^(1/k)`. The planes where two
//! coordinates are equal in size, or one is zero, cut a ray into pieces in which `f` bends one way only, so that two
//! signs and two slopes tell how many roots a piece has. Where `f` is convex all over, as for most exponents, tangents
//! from outside lead to the roots without any cuts.
use raggio_math::{Aabb, EPS, Ray, Vec3};
use smallvec::SmallVec;

use super::collect::{Collect, Offset, searched_from};
use crate::{LocalHit, Surface};

const LEAST: f64 = 1e-4;
/// The surface touches the unit cube; rays are followed a little beyond.
const REACH: f64 = 1.01;

/// Steps of Newton's method; only rays that nearly touch the surface need more than ten.
const MOST_TANGENTS: u32 = 60;
/// Values that count as zero.
const TOUCHING: f64 = 1e-14;

/// A superellipsoid.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Superellipsoid {
    /// `2/e`, of the round in x and y.
    k: Exponent,
    /// `2/n`, of the round towards z.
    m: Exponent,
}

/// An exponent; small whole ones need no logarithms, and roots of powers of two are square roots.
#[derive(Clone, Copy, Debug)]
struct Exponent {
    value: f64,
    whole: Option<i32>,
    /// Of two, if it is a power of it.
    doublings: Option<u32>,
}

impl Exponent {
    fn new(value: f64) -> Self {
        let whole = (value == value.trunc() && (1.0..=64.0).contains(&value)).then_some(value as i32);
        let doublings = whole.and_then(|n| n.count_ones().eq(&1).then(|| n.trailing_zeros()));
        Exponent { value, whole, doublings }
    }

    #[inline]
    fn of(self, v: f64) -> f64 {
        match (self.doublings, self.whole) {
            (Some(doublings), _) => (0..doublings).fold(v, |v, _| v * v),
            (_, Some(n)) => v.powi(n),
            _ => v.powf(self.value),
        }
    }

    /// The root of a number that is not negative.
    #[inline]
    fn root(self, v: f64) -> f64 {
        match self.doublings {
            Some(doublings) => (0..doublings).fold(v, |v, _| v.sqrt()),
            None => v.powf(1.0 / self.value),
        }
    }
}

/// A place on the ray: distance, value, slope along the ray.
type Sample = (f64, f64, f64);

/// `(a^k + b^k)^(1/k)` for numbers that are not negative, and its derivatives; the maximum norm where k is infinite.
#[inline]
fn g(a: f64, b: f64, k: Exponent) -> (f64, f64, f64) {
    let (high, low) = (a.max(b), a.min(b));
    if high == 0.0 {
        return (0.0, 0.0, 0.0);
    }
    let ratio = low / high;
    let power = if low == 0.0 { 0.0 } else { k.of(ratio) };
    let grown = 1.0 + power;
    let value = if grown > 1.0 && k.value.is_finite() { high * k.root(grown) } else { high };
    // With s = 1 + power: d value / d high = s^(1/k - 1), d value / d low = the same times ratio^(k - 1).
    let d_high = value / high / grown;
    let d_low = if ratio > 0.0 { d_high * power / ratio } else { 0.0 };
    if a >= b { (value, d_high, d_low) } else { (value, d_low, d_high) }
}

impl Superellipsoid {
    /// Exponents as the language writes them.
    pub(crate) fn new(e: f64, n: f64) -> Self {
        Superellipsoid { k: Exponent::new(2.0 / e), m: Exponent::new(2.0 / n) }
    }

    fn value(&self, p: Vec3) -> f64 {
        let q = p.abs();
        g(g(q.x, q.y, self.k).0, q.z, self.m).0 - 1.0
    }

    fn sample(&self, ray: &Ray, t: f64) -> Sample {
        let p = ray.at(t);
        let q = p.abs();
        let (xy, dx, dy) = g(q.x, q.y, self.k);
        let (f, dxy, dz) = g(xy, q.z, self.m);
        // At a crease the slope is that of the side the ray comes from; the cuts make it one-sided anyway.
        let towards = |p: f64, d: f64| if p < 0.0 { -d } else { d };
        let d = ray.dir;
        let slope = dxy * (dx * towards(p.x, d.x) + dy * towards(p.y, d.y)) + dz * towards(p.z, d.z);
        (t, f - 1.0, slope)
    }

    /// Distances count from where the ray comes to the cube: far origins lose no digits, of which flattened ones have few.
    fn search(&self, ray: &Ray, to: &mut impl Collect) {
        let cube = Aabb::new(Vec3::splat(-REACH), Vec3::splat(REACH));
        let Some((near, far)) = cube.hit(ray) else { return };
        let to = &mut Offset { start: near, to };
        let ray = &Ray { origin: ray.at(near), ..*ray };
        let range = to.range();
        let (lo, hi) = (range.0.max(0.0), range.1.min(far - near));
        if lo.is_nan() || hi.is_nan() || lo >= hi {
            return;
        }
        if self.bends_one_way() {
            return self.search_convex(ray, (lo, hi), to);
        }
        let mut left = self.sample(ray, lo);
        for t in cuts(ray, lo, hi) {
            let right = self.sample(ray, t);
            self.search_piece(ray, left, right, to);
            if t >= to.range().1 {
                return;
            }
            left = right;
        }
    }

    /// The roots of a convex function: the first from the left, the other from the right.
    fn search_convex(&self, ray: &Ray, (lo, hi): (f64, f64), to: &mut impl Collect) {
        let start = self.sample(ray, lo);
        if start.1 > 0.0 {
            let Some(entry) = self.by_tangents(ray, start, hi) else { return };
            if !to.take(LocalHit::at(entry)) {
                return;
            }
        }
        let end = self.sample(ray, hi);
        if end.1 > 0.0
            && let Some(exit) = self.by_tangents(ray, end, lo)
        {
            to.push(LocalHit::at(exit));
        }
    }

    /// Newton's method from outside: tangents of a convex function never lead beyond the root.
    fn by_tangents(&self, ray: &Ray, mut at: Sample, limit: f64) -> Option<f64> {
        let direction = limit - at.0;
        for _ in 0..MOST_TANGENTS {
            let step = -at.1 / at.2;
            // Away from the root, or beyond the end: there is none.
            if !(step * direction > 0.0 && step.abs() <= (limit - at.0).abs()) {
                return (at.1 <= TOUCHING).then_some(at.0);
            }
            at = self.sample(ray, at.0 + step);
            if at.1 <= TOUCHING {
                return Some(at.0);
            }
        }
        None
    }

    /// A piece without creases.
    fn search_piece(&self, ray: &Ray, left: Sample, right: Sample, to: &mut impl Collect) {
        if (left.1 < 0.0) != (right.1 < 0.0) {
            to.push(LocalHit::at(self.root(ray, left, right)));
            return;
        }
        if let Some(turning) = self.turning_point(ray, left, right) {
            to.push(LocalHit::at(self.root(ray, left, turning)));
            to.push(LocalHit::at(self.root(ray, turning, right)));
        }
    }

    /// Where a piece with equal signs at its ends comes nearest to zero, if it has the other sign there.
    fn turning_point(&self, ray: &Ray, left: Sample, right: Sample) -> Option<Sample> {
        let outside = left.1 >= 0.0;
        let comes_nearer = |slope: f64| if outside { slope < 0.0 } else { slope > 0.0 };
        // The ends were sampled with the slopes of their own sides; a hair inside is this piece's side.
        let hair = 1e-9 * (right.0 - left.0);
        let (mut a, mut b) = (self.sample(ray, left.0 + hair), self.sample(ray, right.0 - hair));
        match (comes_nearer(a.2), comes_nearer(b.2)) {
            (true, false) => {}
            (true, true) => b = self.bent_back(ray, b, a, |slope| !comes_nearer(slope))?,
            (false, false) => a = self.bent_back(ray, a, b, comes_nearer)?,
            (false, true) => return None,
        }
        for _ in 0..60 {
            // The tangents at both ends bound a curve that bends one way: no root where they do not reach zero.
            let meet = (b.1 - a.1 + a.2 * a.0 - b.2 * b.0) / (a.2 - b.2);
            let reached = a.1 + a.2 * (meet - a.0);
            if self.bends_one_way() && (reached > 0.0) == outside {
                return None;
            }
            let inner = 0.05 * (b.0 - a.0);
            let t = if meet > a.0 + inner && meet < b.0 - inner { meet } else { 0.5 * (a.0 + b.0) };
            let c = self.sample(ray, t);
            if (c.1 < 0.0) == outside {
                return Some(c);
            }
            if b.0 - a.0 < 1e-10 {
                return None;
            }
            if comes_nearer(c.2) { a = c } else { b = c }
        }
        None
    }

    /// Where exponents are sharp the curve may bend once more just beside a crease: the first of ever longer steps from
    /// there after which the slope is as wished.
    fn bent_back(
        &self,
        ray: &Ray,
        crease: Sample,
        other: Sample,
        wished: impl Fn(f64) -> bool,
    ) -> Option<Sample> {
        if self.bends_one_way() {
            return None;
        }
        let mut steps = (1..=6).rev().map(|k| crease.0 + (other.0 - crease.0) * 0.25f64.powi(k));
        steps.find_map(|t| Some(self.sample(ray, t)).filter(|sample| wished(sample.2)))
    }

    /// With both exponents at least 1 in the norm, `f` is convex everywhere.
    fn bends_one_way(&self) -> bool {
        self.k.value >= 1.0 && self.m.value >= 1.0
    }

    /// The root between two samples of different sign: false position with the Illinois rule, inside a bracket.
    fn root(&self, ray: &Ray, left: Sample, right: Sample) -> f64 {
        let ((mut a, mut fa, _), (mut b, mut fb, _)) = (left, right);
        for step in 0..80 {
            let secant = (a * fb - b * fa) / (fb - fa);
            let inside = secant > a.min(b) && secant < a.max(b);
            let t = if inside && step % 8 != 7 { secant } else { 0.5 * (a + b) };
            let f = self.value(ray.at(t));
            if f.abs() < 1e-14 || (b - a).abs() < 1e-14 {
                return t;
            }
            if (f < 0.0) == (fb < 0.0) {
                fa *= 0.5;
            } else {
                (a, fa) = (b, fb);
            }
            (b, fb) = (t, f);
        }
        b
    }
}

/// Distances of the creases between `lo` and `hi`, sorted, then `hi`.
fn cuts(ray: &Ray, lo: f64, hi: f64) -> SmallVec<[f64; 10]> {
    let (o, d) = (ray.origin, ray.dir);
    let pairs = [(o.x, d.x), (o.y, d.y), (o.z, d.z)];
    let mut cuts = SmallVec::new();
    let mut add = |o: f64, d: f64| {
        let t = -o / d;
        if lo < t && t < hi {
            cuts.push(t);
        }
    };
    for (i, &(oi, di)) in pairs.iter().enumerate() {
        add(oi, di);
        for &(oj, dj) in &pairs[..i] {
            add(oi - oj, di - dj);
            add(oi + oj, di + dj);
        }
    }
    cuts.sort_unstable_by(f64::total_cmp);
    cuts.push(hi);
    cuts
}

impl Surface for Superellipsoid {
    searched_from!(LEAST);

    fn bounds(&self) -> Aabb {
        Aabb::new(Vec3::splat(-REACH), Vec3::splat(REACH))
    }

    /// The norm that is dual to `f + 1`; the hull of a star is the double pyramid.
    fn reach(&self, along: Vec3) -> Option<f64> {
        let dual = |k: f64| match k {
            f64::INFINITY => 1.0,
            k if k > 1.0 => k / (k - 1.0),
            _ => f64::INFINITY,
        };
        let of = |a, b, k: Exponent| g(a, b, Exponent::new(dual(k.value))).0;
        let v = along.abs();
        Some(of(of(v.x, v.y, self.k), v.z, self.m))
    }

    fn inside(&self, p: Vec3) -> bool {
        self.value(p) < EPS
    }

    fn normal(&self, p: Vec3, _hit: &LocalHit) -> Vec3 {
        let q = p.abs();
        let (a, b) = (q.x.max(q.y), q.x.min(q.y));
        if a == 0.0 {
            return Vec3::Z.copysign(p);
        }
        let k = if b == 0.0 { 0.0 } else { self.k.of(b / a) };
        let w = if q.z == 0.0 { 0.0 } else { self.m.of(q.z) };
        let over = |x: f64, v: f64| if v == 0.0 { 0.0 } else { x / v };
        let (long, short) = (1.0 - w, (1.0 - w) * k);
        let (x, y) = if q.x > q.y { (long, short) } else { (short, long) };
        let n = Vec3::new(over(x, p.x), over(y, p.y), over(w * (1.0 + k), p.z));
        n.try_normalize().unwrap_or(Vec3::Z)
    }
}
