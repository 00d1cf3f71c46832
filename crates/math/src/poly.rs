//! Real roots of polynomials up to degree 35.
//!
//! Between two neighbouring critical points a polynomial is monotonic, so it has a root there exactly when its signs
//! at the two differ. The critical points are the roots of the derivative, found the same way; the chain ends at a
//! cubic. (Yuksel, "High-Performance Polynomial Root Finding for Graphics", 2022.) Unlike closed forms the method
//! never loses one of a pair of roots to cancellation: at a grazing ray both are found or neither is.
//!
//! Coefficients rise: `c[k]` belongs to `t^k`. An array of `N` coefficients has degree `N - 1`; high ones may be zero.

/// The highest degree that the solver takes.
pub const MAX_DEGREE: usize = 35;

/// Sorted roots, at most `N`.
#[derive(Clone, Copy, Debug)]
pub struct Roots<const N: usize> {
    values: [f64; N],
    len: usize,
}

impl<const N: usize> Roots<N> {
    /// No roots.
    pub const NONE: Self = Roots { values: [0.0; N], len: 0 };

    #[inline]
    fn push(&mut self, x: f64) {
        if self.len < N {
            self.values[self.len] = x;
            self.len += 1;
        }
    }
}

impl<const N: usize> std::ops::Deref for Roots<N> {
    type Target = [f64];
    #[inline]
    fn deref(&self) -> &[f64] {
        &self.values[..self.len]
    }
}

/// The value at `x`.
#[inline(always)]
pub fn eval(c: &[f64], x: f64) -> f64 {
    let mut v = 0.0;
    for k in (0..c.len()).rev() {
        v = v * x + c[k];
    }
    v
}

/// The value and the slope at `x`.
#[inline(always)]
fn eval_with_slope(c: &[f64], x: f64) -> (f64, f64) {
    let (mut v, mut s) = (0.0, 0.0);
    for k in (0..c.len()).rev() {
        (v, s) = (v * x + c[k], s * x + v);
    }
    (v, s)
}

/// Up to so many coefficients are used all, zero or not: loops of known length are unrolled.
const UNROLLED: usize = 9;

/// The coefficients that count of a polynomial of degree `n`.
#[inline(always)]
fn used<const N: usize>(c: &[f64; N], n: usize) -> &[f64] {
    if N <= UNROLLED { c } else { &c[..=n] }
}

/// The real roots of `c[0] + c[1] t + c[2] t^2`, sorted, without cancellation; a double root once.
#[inline]
pub fn quadratic(c: [f64; 3]) -> Roots<3> {
    let mut roots = Roots::NONE;
    let [c0, c1, c2] = c;
    if c2 == 0.0 {
        if c1 != 0.0 {
            roots.push(-c0 / c1);
        }
        return roots;
    }
    let half = -0.5 * c1;
    let disc = half * half - c2 * c0;
    if disc.is_nan() || disc < 0.0 {
        return roots;
    }
    let q = half + disc.sqrt().copysign(half);
    if q == 0.0 {
        roots.push(0.0);
        return roots;
    }
    let (a, b) = (q / c2, c0 / q);
    if disc == 0.0 || !a.is_finite() {
        roots.push(b);
    } else {
        roots.push(a.min(b));
        roots.push(a.max(b));
    }
    roots
}

/// All real roots, sorted; of a root of even multiplicity none or a pair.
pub fn real_roots<const N: usize>(c: &[f64; N]) -> Roots<N> {
    roots_in(c, f64::NEG_INFINITY, f64::INFINITY)
}

/// The roots in `lo..=hi`, sorted. Either end may be infinite.
pub fn roots_in<const N: usize>(c: &[f64; N], lo: f64, hi: f64) -> Roots<N> {
    let mut roots = Roots::NONE;
    visit_roots_in(c, lo, hi, |x| {
        roots.push(x);
        true
    });
    roots
}

/// Calls `visit` with the roots in `lo..=hi`, the least first, for as long as it answers true: what comes after is not
/// worked out.
#[inline]
pub fn visit_roots_in<const N: usize>(c: &[f64; N], lo: f64, hi: f64, visit: impl FnMut(f64) -> bool) {
    let n = degree(c);
    if n == 0 || !c.iter().all(|x| x.is_finite()) {
        return;
    }
    let (lo, hi) = if lo.is_finite() && hi.is_finite() {
        (lo, hi)
    } else {
        let bound = root_bound(&c[..=n]);
        (lo.max(-bound), hi.min(bound))
    };
    if lo <= hi {
        solve(c, (lo, eval(used(c, n), lo)), (hi, eval(used(c, n), hi)), visit);
    }
}

/// The roots in `0..=1`, where the values at the ends are known better than the coefficients tell: pieces of a curve
/// that share an end then agree about its side.
pub fn roots_in_unit<const N: usize>(c: &[f64; N], at_zero: f64, at_one: f64) -> Roots<N> {
    let mut roots = Roots::NONE;
    let mut visit = |x| {
        roots.push(x);
        true
    };
    if degree(c) == 0 || !c.iter().all(|x| x.is_finite()) {
        return roots;
    }
    if (4..=UNROLLED).contains(&N) {
        isolate(c, &bernstein_from_power(c, at_zero, at_one), (0.0, 1.0), SPLITS, &mut visit);
    } else {
        chain(c, (0.0, at_zero), (1.0, at_one), &mut visit);
    }
    roots
}

/// The roots in `0..=1` of the polynomial whose Bernstein coefficients are `b`. The signs at the ends are those of the
/// first and last coefficient, so that chained curves neither lose nor double a crossing at a joint.
#[inline]
pub fn bernstein_roots<const N: usize>(b: &[f64; N]) -> Roots<N> {
    let mut roots = Roots::NONE;
    visit_bernstein_roots(b, |x| {
        roots.push(x);
        true
    });
    roots
}

/// Calls `visit` with the [`bernstein_roots`], the least first, for as long as it answers true.
#[inline]
pub fn visit_bernstein_roots<const N: usize>(b: &[f64; N], mut visit: impl FnMut(f64) -> bool) {
    if changes(b) == 0 || !b.iter().all(|x| x.is_finite()) {
        return;
    }
    let c = power_from_bernstein(b);
    if N <= UNROLLED {
        isolate(&c, b, (0.0, 1.0), SPLITS, &mut visit);
    } else if c.iter().all(|x| x.is_finite()) {
        chain(&c, (0.0, b[0]), (1.0, b[N - 1]), &mut visit);
    }
}

/// The Bernstein coefficients over `0..=1` of the cubic with these values at 0, 1/3, 2/3 and 1.
#[inline]
pub fn bernstein_cubic_through([a, b, c, d]: [f64; 4]) -> [f64; 4] {
    [a, (-5.0 * a + 18.0 * b - 9.0 * c + 2.0 * d) / 6.0, (2.0 * a - 9.0 * b + 18.0 * c - 5.0 * d) / 6.0, d]
}

/// The Bernstein coefficients over `0..=1` of the quartic with these values at 0, 1/4, 1/2, 3/4 and 1.
#[inline]
pub fn bernstein_quartic_through([a, b, c, d, e]: [f64; 5]) -> [f64; 5] {
    let second = |a, b, c, d, e| (-13.0 * a + 48.0 * b - 36.0 * c + 16.0 * d - 3.0 * e) / 12.0;
    let middle = (13.0 * (a + e) - 64.0 * (b + d) + 120.0 * c) / 18.0;
    [a, second(a, b, c, d, e), middle, second(e, d, c, b, a), e]
}

/// Makes Bernstein coefficients over `0..=1` those over `s..=1` (de Casteljau).
#[inline]
pub fn bernstein_from<const N: usize>(s: f64, b: &mut [f64; N]) {
    for last in (1..N).rev() {
        for i in 0..last {
            b[i] += (b[i + 1] - b[i]) * s;
        }
    }
}

/// [`bernstein_roots`] of a quadratic, in closed form. The signs of the three coefficients alone tell where roots may
/// be; two that the discriminant grants lie inside.
#[inline]
pub fn bernstein_quadratic([a, b, c]: [f64; 3]) -> Roots<3> {
    let mut roots = Roots::NONE;
    let ends_differ = (a < 0.0) != (c < 0.0);
    if !ends_differ && (b < 0.0) == (a < 0.0) {
        return roots;
    }
    let disc = b * b - a * c;
    if disc.is_nan() || disc < 0.0 {
        return roots;
    }
    // The curve is `top t^2 - 2 fall t + a`.
    let (fall, top) = (a - b, a - 2.0 * b + c);
    if ends_differ {
        let root = if a < 0.0 { -disc.sqrt() } else { disc.sqrt() };
        let t = if fall * root >= 0.0 { a / (fall + root) } else { (fall - root) / top };
        // No number only for a curve that starts level at 0.
        roots.push(if t.is_finite() { t.clamp(0.0, 1.0) } else { 0.0 });
        return roots;
    }
    let q = fall + disc.sqrt().copysign(fall);
    let (s, t) = (q / top, a / q);
    if s.is_finite() && t.is_finite() {
        roots.push(s.min(t).clamp(0.0, 1.0));
        roots.push(s.max(t).clamp(0.0, 1.0));
    }
    roots
}

/// The coefficients in powers of t of a polynomial in Bernstein form over `0..=1`.
pub fn power_from_bernstein<const N: usize>(b: &[f64; N]) -> [f64; N] {
    let mut c = *b;
    for k in 1..N {
        for j in (k..N).rev() {
            c[j] -= c[j - 1];
        }
    }
    for (k, x) in c.iter_mut().enumerate() {
        *x *= BINOMIAL[N - 1][k];
    }
    c
}

fn degree(c: &[f64]) -> usize {
    c.iter().rposition(|&x| x != 0.0).unwrap_or(0)
}

/// No root is farther from 0 (Fujiwara's bound); cut at 1e30, where no scene reaches.
fn root_bound(c: &[f64]) -> f64 {
    let n = c.len() - 1;
    let term = |k: usize| (c[n - k] / c[n]).abs().powf(1.0 / k as f64);
    let bound = 2.0 * (1..=n).map(term).fold(0.0, f64::max);
    (bound * (1.0 + 1e-12) + f64::MIN_POSITIVE).min(1e30)
}

/// `C(n, k)` for the derivatives.
const BINOMIAL: [[f64; MAX_DEGREE + 1]; MAX_DEGREE + 1] = {
    let mut table = [[0.0; MAX_DEGREE + 1]; MAX_DEGREE + 1];
    let mut n = 0;
    while n <= MAX_DEGREE {
        table[n][0] = 1.0;
        let mut k = 1;
        while k <= n {
            table[n][k] = table[n - 1][k - 1] + table[n - 1][k];
            k += 1;
        }
        n += 1;
    }
    table
};

/// `1 / C(n, k)` for short polynomials.
const INVERSE_BINOMIAL: [[f64; UNROLLED]; UNROLLED] = {
    let mut table = [[0.0; UNROLLED]; UNROLLED];
    let mut n = 0;
    while n < UNROLLED {
        let mut k = 0;
        while k <= n {
            table[n][k] = 1.0 / BINOMIAL[n][k];
            k += 1;
        }
        n += 1;
    }
    table
};

/// The `k`-th derivative divided by `k!`.
#[inline]
fn derivative<const N: usize>(c: &[f64; N], n: usize, k: usize) -> [f64; N] {
    let mut d = [0.0; N];
    for j in k..=n {
        d[j - k] = BINOMIAL[j][k] * c[j];
    }
    d
}

/// Steps this small, as a share of the interval, end the search for a critical point and for a root. Newton's method
/// doubles the digits with each step, so what is left is far smaller.
const KNOT_STEP: f64 = 1e-6;
const ROOT_STEP: f64 = 1e-8;

/// The roots between two samples of a polynomial.
#[inline]
fn solve<const N: usize>(c: &[f64; N], lo: (f64, f64), hi: (f64, f64), mut visit: impl FnMut(f64) -> bool) {
    if !(4..=UNROLLED).contains(&N) {
        chain(c, lo, hi, &mut visit);
        return;
    }
    let b = bernstein_over(c, lo, hi);
    match changes(&b) {
        0 => {}
        1 => {
            visit(only_root(c, &b, (lo.0, hi.0)));
        }
        _ => {
            isolate(c, &b, (lo.0, hi.0), SPLITS, &mut visit);
        }
    }
}

/// So often an interval is split before the derivatives are asked where its roots are.
const SPLITS: u32 = 5;

/// The roots in an interval over which the polynomial has the Bernstein coefficients `b`. Their signs tell of none or
/// one; where they tell of more, the interval is split (Lane and Riesenfeld, 1981) near its lowest point, or
/// highest, where a pair of roots would part. Answers whether more are wanted.
fn isolate<const N: usize, F: FnMut(f64) -> bool>(
    c: &[f64; N],
    b: &[f64; N],
    (lo, hi): (f64, f64),
    splits: u32,
    visit: &mut F,
) -> bool {
    match changes(b) {
        0 => return true,
        1 => return visit(only_root(c, b, (lo, hi))),
        _ if splits == 0 => return chain(c, (lo, b[0]), (hi, b[N - 1]), visit),
        _ => {}
    }
    let s = turn(b) as f64 / (N - 1) as f64;
    let (left, right) = split(b, s);
    let middle = lo + (hi - lo) * s;
    isolate(c, &left, (lo, middle), splits - 1, visit) && isolate(c, &right, (middle, hi), splits - 1, visit)
}

/// Of the inner coefficients that differ in sign from the first the one that does most.
#[inline]
fn turn<const N: usize>(b: &[f64; N]) -> usize {
    let depth = |k: usize| if b[0] < 0.0 { b[k] } else { -b[k] };
    (2..N - 1).fold(1, |best, k| if depth(k) > depth(best) { k } else { best })
}

/// The Bernstein coefficients over `0..=s` and `s..=1` (de Casteljau).
#[inline]
fn split<const N: usize>(b: &[f64; N], s: f64) -> ([f64; N], [f64; N]) {
    let (mut left, mut right) = (*b, *b);
    for (k, start) in left.iter_mut().enumerate().skip(1) {
        for i in 0..N - k {
            right[i] += (right[i + 1] - right[i]) * s;
        }
        *start = right[0];
    }
    (left, right)
}

/// The one root in an interval over which the Bernstein coefficients change their sign once; looked for first where the
/// line through them does.
#[inline(always)]
fn only_root<const N: usize>(c: &[f64; N], b: &[f64; N], (lo, hi): (f64, f64)) -> f64 {
    let mut k = 0;
    while k + 2 < N && (b[k + 1] < 0.0) == (b[0] < 0.0) {
        k += 1;
    }
    let share = (k as f64 + b[k] / (b[k] - b[k + 1])) / (N - 1) as f64;
    let guess = lo + (hi - lo) * share.clamp(0.001, 0.999);
    refine(c, (lo, b[0]), (hi, b[N - 1]), guess, ROOT_STEP)
}

/// The roots between two samples by way of the roots of the derivatives, from a cubic up to the polynomial itself.
/// Answers whether more are wanted.
fn chain<const N: usize>(
    c: &[f64; N],
    lo: (f64, f64),
    hi: (f64, f64),
    visit: &mut impl FnMut(f64) -> bool,
) -> bool {
    let n = degree(c);
    let mut knots: Roots<N> = Roots::NONE;
    let mut add = |x: f64| {
        if lo.0 < x && x < hi.0 {
            knots.push(x);
        }
    };
    match n {
        0 | 1 => {}
        2 => add(-0.5 * c[1] / c[2]),
        3 => quadratic([c[1], 2.0 * c[2], 3.0 * c[3]]).iter().for_each(|&x| add(x)),
        _ => {
            let top = derivative(c, n, n - 3);
            cubic_knots([top[0], top[1], top[2], top[3]]).iter().for_each(|&x| add(x));
        }
    }
    for k in (1..n.saturating_sub(3)).rev() {
        let q = derivative(c, n, k);
        let mut next = Roots::NONE;
        let at = |x: f64| (x, eval(used(&q, n - k), x));
        crossings((&q, n - k), &knots, at(lo.0), at(hi.0), KNOT_STEP, |x| {
            next.push(x);
            true
        });
        knots = next;
    }
    crossings((c, n), &knots, lo, hi, ROOT_STEP, visit)
}

/// The Bernstein coefficients over an interval. Their signs change at least as often as there are roots in it, and by an
/// even number more (Descartes' rule of signs). The values at the ends are taken as given.
#[inline]
fn bernstein_over<const N: usize>(c: &[f64; N], lo: (f64, f64), hi: (f64, f64)) -> [f64; N] {
    let mut b = *c;
    for k in 0..N - 1 {
        for j in (k..N - 1).rev() {
            b[j] += lo.0 * b[j + 1];
        }
    }
    let (width, mut power) = (hi.0 - lo.0, 1.0);
    for x in &mut b[1..] {
        power *= width;
        *x *= power;
    }
    bernstein_from_power(&b, lo.1, hi.1)
}

/// [`bernstein_over`] the interval `0..=1`.
#[inline]
fn bernstein_from_power<const N: usize>(c: &[f64; N], at_zero: f64, at_one: f64) -> [f64; N] {
    let mut b = *c;
    for (x, inverse) in b.iter_mut().zip(&INVERSE_BINOMIAL[N - 1]) {
        *x *= inverse;
    }
    for k in (1..N).rev() {
        for j in k..N {
            b[j] += b[j - 1];
        }
    }
    (b[0], b[N - 1]) = (at_zero, at_one);
    b
}

/// How often the sign changes along a row.
#[inline(always)]
fn changes<const N: usize>(b: &[f64; N]) -> u32 {
    let mut count = 0;
    for k in 1..N {
        count += u32::from((b[k] < 0.0) != (b[k - 1] < 0.0));
    }
    count
}

/// The roots of a cubic, sorted, well enough to tell where another polynomial turns: Newton's method from beyond the
/// inflection for one of them, then the quadratic that is left (Deiters and Macias-Salinas, 2014).
fn cubic_knots(c: [f64; 4]) -> Roots<3> {
    let (b, a1, a0) = (c[2] / c[3], c[1] / c[3], c[0] / c[3]);
    let inflection = -b / 3.0;
    let value = |x: f64| ((x + b) * x + a1) * x + a0;
    let at_inflection = value(inflection);
    let spread = b * b - 3.0 * a1;
    let mut x = inflection;
    if spread > 0.0 {
        x -= (2.0 / 3.0 * spread.sqrt()).copysign(at_inflection);
    }
    for _ in 0..40 {
        let (v, slope) = eval_with_slope(&[a0, a1, b, 1.0], x);
        let next = x - v / slope;
        if !next.is_finite() {
            break;
        }
        let step = (next - x).abs();
        x = next;
        if step <= 1e-7 * x.abs() {
            break;
        }
    }
    // Divide the root out from the end that loses no digits.
    let (q0, q1) = if (x * x * x).abs() > a0.abs() {
        let q0 = -a0 / x;
        (q0, (q0 - a1) / x)
    } else {
        (a1 + x * (b + x), b + x)
    };
    let mut roots = quadratic([q0, q1, 1.0]);
    roots.push(x);
    let count = roots.len;
    roots.values[..count].sort_unstable_by(f64::total_cmp);
    roots
}

/// One root in each gap between neighbouring knots at which the signs differ, of a polynomial with its degree.
#[inline]
fn crossings<const N: usize>(
    (c, n): (&[f64; N], usize),
    knots: &Roots<N>,
    lo: (f64, f64),
    hi: (f64, f64),
    least_step: f64,
    mut visit: impl FnMut(f64) -> bool,
) -> bool {
    let mut left = lo;
    for i in 0..=knots.len {
        let right = if i < knots.len { (knots.values[i], eval(used(c, n), knots.values[i])) } else { hi };
        if (left.1 < 0.0) != (right.1 < 0.0) {
            let guess = guess(left, right, i > 0, i < knots.len);
            if !visit(refine(used(c, n), left, right, guess, least_step)) {
                return false;
            }
        }
        left = right;
    }
    true
}

/// Where the root may lie between two samples, each of which may be a place where the curve is level.
fn guess(left: (f64, f64), right: (f64, f64), level_left: bool, level_right: bool) -> f64 {
    let share = left.1 / (left.1 - right.1);
    let share = match (level_left, level_right) {
        (true, false) => share.sqrt(),
        (false, true) => 1.0 - (1.0 - share).sqrt(),
        _ => share,
    };
    left.0 + (right.0 - left.0) * share.clamp(0.02, 0.98)
}

/// Newton's method kept inside a shrinking bracket. Inlined for the sake of polynomials of known length.
#[inline(always)]
fn refine(c: &[f64], left: (f64, f64), right: (f64, f64), guess: f64, least_step: f64) -> f64 {
    let (mut lo, mut hi) = (left.0, right.0);
    let rising = left.1 < 0.0;
    let least = (hi - lo) * least_step;
    let mut x = guess;
    for _ in 0..300 {
        let (v, slope) = eval_with_slope(c, x);
        if v == 0.0 {
            return x;
        }
        if (v < 0.0) == rising {
            lo = x;
        } else {
            hi = x;
        }
        let newton = x - v / slope;
        let inside = newton > lo && newton < hi;
        let next = if inside { newton } else { 0.5 * (lo + hi) };
        let step = (next - x).abs();
        // Small against the interval, and, in case the interval is vast, against the root as well.
        if (inside && step <= least.min(1e-8 * next.abs())) || step <= 1e-15 * next.abs() {
            return next;
        }
        x = next;
    }
    x
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    /// The coefficients of the product of `t - r`.
    fn from_roots<const N: usize>(roots: &[f64]) -> [f64; N] {
        let mut c = [0.0; N];
        c[0] = 1.0;
        for (n, r) in roots.iter().enumerate() {
            for k in (0..=n + 1).rev() {
                c[k] = if k > 0 { c[k - 1] } else { 0.0 } - r * c[k];
            }
        }
        c
    }

    fn near(found: &[f64], expected: &[f64], tolerance: f64) {
        assert_eq!(found.len(), expected.len(), "{found:?} for {expected:?}");
        for (a, b) in found.iter().zip(expected) {
            assert!((a - b).abs() <= tolerance * b.abs().max(1.0), "{found:?} for {expected:?}");
        }
    }

    /// A value in twice the precision: the unevaluated sum of two doubles (Dekker; products by fused multiply-add).
    fn eval_double_double(c: &[f64], x: f64) -> f64 {
        let two_sum = |a: f64, b: f64| {
            let s = a + b;
            let t = s - a;
            (s, (a - (s - t)) + (b - t))
        };
        let (mut hi, mut lo) = (0.0, 0.0);
        for &k in c.iter().rev() {
            let p = hi * x;
            let e = f64::mul_add(hi, x, -p) + lo * x;
            let (s, e2) = two_sum(p, k);
            (hi, lo) = two_sum(s, e + e2);
        }
        hi + lo
    }

    #[test]
    fn the_rest_of_a_curve_is_the_same_curve() {
        let whole = [1.0, -2.0, 0.5, 3.0, -1.0];
        let mut rest = whole;
        bernstein_from(0.25, &mut rest);
        for x in [0.0, 0.3, 1.0] {
            let on_whole = eval(&power_from_bernstein(&whole), 0.25 + 0.75 * x);
            assert!((eval(&power_from_bernstein(&rest), x) - on_whole).abs() < 1e-14);
        }
    }

    #[test]
    fn values_at_even_steps_make_the_curve() {
        let close = |a: &[f64], b: &[f64]| a.iter().zip(b).all(|(a, b)| (a - b).abs() < 1e-14);
        let cubic = [1.0, -2.0, 0.5, 3.0];
        let c = power_from_bernstein(&cubic);
        let values = std::array::from_fn(|k| eval(&c, k as f64 / 3.0));
        assert!(close(&bernstein_cubic_through(values), &cubic));
        let quartic = [1.0, -2.0, 0.5, 3.0, -1.0];
        let c = power_from_bernstein(&quartic);
        let values = std::array::from_fn(|k| eval(&c, k as f64 / 4.0));
        assert!(close(&bernstein_quartic_through(values), &quartic));
    }

    #[test]
    fn quadratics_do_not_cancel() {
        near(&quadratic([1.0, -1e8, 1.0]), &[1e-8, 1e8], 1e-15);
        near(&quadratic([-4.0, 2.0, 0.0]), &[2.0], 0.0);
        near(&quadratic([1.0, 2.0, 1.0]), &[-1.0], 0.0);
        near(&quadratic([0.0, 0.0, 3.0]), &[0.0], 0.0);
        assert!(quadratic([1.0, 0.0, 1.0]).is_empty());
        assert!(quadratic([f64::NAN, 1.0, 1.0]).is_empty());
    }

    #[test]
    fn integer_roots_come_back_exactly_sorted() {
        near(&real_roots(&from_roots::<4>(&[3.0, -1.0, 2.0])), &[-1.0, 2.0, 3.0], 1e-14);
        near(&real_roots(&from_roots::<5>(&[5.0, -7.0, 1.0, 2.0])), &[-7.0, 1.0, 2.0, 5.0], 1e-14);
        let wilkinson: Vec<f64> = (1..=10).map(f64::from).collect();
        near(&real_roots(&from_roots::<11>(&wilkinson)), &wilkinson, 1e-8);
        near(&roots_in(&from_roots::<5>(&[5.0, -7.0, 1.0, 2.0]), 0.0, 4.0), &[1.0, 2.0], 1e-14);
    }

    #[test]
    fn degree_thirty_five_finds_the_cosine_nodes() {
        // The Chebyshev polynomial of degree 35: all roots known, coefficients exact integers below 2^53 only in part.
        let (mut a, mut b) = ([0.0; 36], [0.0; 36]);
        a[0] = 1.0;
        b[1] = 1.0;
        for _ in 2..=35 {
            let mut c = [0.0; 36];
            for k in 0..36 {
                c[k] = if k > 0 { 2.0 * b[k - 1] } else { 0.0 } - a[k];
            }
            (a, b) = (b, c);
        }
        let found = roots_in(&b, -0.5, 0.5);
        let node = |k: i32| ((f64::from(k) - 0.5) * std::f64::consts::PI / 35.0).cos();
        let expected: Vec<f64> = (1..=35).rev().map(node).filter(|x| x.abs() < 0.5).collect();
        near(&found, &expected, 1e-8);
    }

    #[test]
    fn grazing_pairs_come_together() {
        for k in 0..60 {
            let gap = 10f64.powi(-k / 4) * 1.7;
            let c = from_roots::<5>(&[-3.0, 2.0 - gap, 2.0 + gap, 9.0]);
            let n = roots_in(&c, 0.0, 5.0).len();
            assert!(n == 2 || n == 0, "{n} roots at gap {gap}");
            assert!(n == 2 || gap < 1e-7, "pair lost at gap {gap}");
        }
    }

    #[test]
    fn huge_and_tiny_scales() {
        near(&real_roots(&from_roots::<5>(&[1e6, -1e6, 2.5e6, 3e6])), &[-1e6, 1e6, 2.5e6, 3e6], 1e-13);
        let tiny = real_roots(&from_roots::<5>(&[1e-6, -1e-6, 2.5e-6, 3e-6]));
        assert_eq!(tiny.len(), 4);
        assert!((tiny[3] / 3e-6 - 1.0).abs() < 1e-12);
        near(&real_roots(&[-8.0, 0.0, 0.0, 1.0, 1e-200, 0.0]), &[2.0], 1e-14);
        assert!(real_roots(&[0.0; 5]).is_empty());
        assert!(roots_in(&[1.0, f64::INFINITY, 1.0], 0.0, 1.0).is_empty());
    }

    proptest! {
        /// Real roots are found to rounding, and the signs at the ends alone say whether there is an odd number.
        #[test]
        fn closed_quadratic_agrees_with_the_search(b in prop::array::uniform3(-4i8..=4), shift in -1e-3..1e-3) {
            let b = b.map(|x| f64::from(x) + if x == 0 { 0.0 } else { shift });
            let roots = bernstein_quadratic(b);
            prop_assert_eq!(roots.len() % 2 == 1, (b[0] < 0.0) != (b[2] < 0.0));
            let c = power_from_bernstein(&b);
            for &t in roots.iter() {
                prop_assert!((0.0..=1.0).contains(&t) && eval(&c, t).abs() < 1e-14, "{t} {}", eval(&c, t));
            }
            if b[1] * b[1] - b[0] * b[2] > 1e-9 {
                prop_assert_eq!(roots.len(), bernstein_roots(&b).len());
            }
        }
    }

    #[test]
    fn bernstein_form_agrees_with_powers() {
        let b = [1.0, -2.0, 0.5, -1.0];
        let c = power_from_bernstein(&b);
        near(&c, &[1.0, -9.0, 16.5, -9.5], 1e-14);
        near(&bernstein_roots(&b), &roots_in(&c, 0.0, 1.0), 1e-14);
        assert!(bernstein_roots(&[1.0, 2.0, 0.5, 0.1]).is_empty());
    }

    proptest! {
        #[test]
        fn roots_are_roots_to_the_last_digits(c in prop::array::uniform7(-10.0..10.0f64)) {
            for &r in real_roots(&c).iter() {
                let magnitude: f64 = c.iter().enumerate().map(|(k, x)| (x * r.powi(k as i32)).abs()).sum();
                prop_assert!(eval_double_double(&c, r).abs() <= 4e-15 * magnitude);
            }
        }

        #[test]
        fn none_is_lost(mut r in prop::array::uniform6(-5.0..5.0f64)) {
            r.sort_by(f64::total_cmp);
            prop_assume!(r.windows(2).all(|w| w[1] - w[0] > 0.05));
            let found = real_roots(&from_roots::<7>(&r));
            prop_assert_eq!(found.len(), 6);
            for (a, b) in found.iter().zip(&r) {
                prop_assert!((a - b).abs() < 1e-6);
            }
        }
    }
}
