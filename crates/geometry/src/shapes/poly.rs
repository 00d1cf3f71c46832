//! Surfaces of polynomials in x, y and z of degree 2 to 35 (shapes spec, section 2).
use raggio_math::{Aabb, Ray, Vec3, poly};

use super::collect::{Collect, searched_from};
use crate::{LocalHit, Surface};

const LEAST: f64 = 1e-4;
/// Values below this count as inside.
const TOLERANCE: f64 = 1e-4;

/// A polynomial surface.
#[derive(Clone, Debug)]
pub(crate) struct Poly {
    degree: usize,
    /// The terms that are not zero: exponents of x falling first, then of y, then of z.
    terms: Vec<Term>,
}

#[derive(Clone, Copy, Debug, PartialEq)]
struct Term {
    factor: f64,
    exponents: [i32; 3],
    /// The next has another exponent of x or y.
    last_in_z: bool,
}

/// Values on a ray up to this size are exact enough to make the polynomial of them: their rounding is far below what
/// counts as zero.
const MODEST: f64 = 1e5;

/// Values at some points at once.
type Row<const L: usize> = [f64; L];

/// Powers from 0 to 4 of numbers.
type Powers<const L: usize> = [Row<L>; 5];

/// The powers of numbers that stand in the second row.
#[inline(always)]
fn fill_powers<const L: usize>(x: &mut Powers<L>) {
    let [zero, one, two, three, four] = x;
    *zero = [1.0; L];
    for l in 0..L {
        two[l] = one[l] * one[l];
        three[l] = two[l] * one[l];
        four[l] = two[l] * two[l];
    }
}

/// Terms still to be taken, in their order.
struct Rest<'a>(std::slice::Iter<'a, Term>);

impl Rest<'_> {
    /// The exponent at a place of the next term, if its exponents before that place are these.
    #[inline]
    fn exponent<const K: usize>(&self, before: [i32; K]) -> Option<i32> {
        let next = self.0.as_slice().first()?;
        (next.exponents[..K] == before).then_some(next.exponents[K])
    }
}

/// A polynomial along a ray, grown by Horner's rule; `len` is its degree plus one, 0 for none at all. Coefficients past
/// `len` are zero.
#[derive(Clone, Copy)]
struct Along<const N: usize> {
    c: [f64; N],
    len: usize,
}

impl<const N: usize> Along<N> {
    const ZERO: Self = Along { c: [0.0; N], len: 0 };

    /// Multiplies by `o + d t`.
    #[inline]
    fn times_linear(&mut self, o: f64, d: f64) {
        if self.len == 0 {
            return;
        }
        for k in (1..=self.len.min(N - 1)).rev() {
            self.c[k] = self.c[k] * o + self.c[k - 1] * d;
        }
        self.c[0] *= o;
        self.len = (self.len + 1).min(N);
    }

    #[inline]
    fn add(&mut self, other: &Self) {
        for k in 0..other.len {
            self.c[k] += other.c[k];
        }
        self.len = self.len.max(other.len);
    }

    #[inline]
    fn add_constant(&mut self, x: f64) {
        self.c[0] += x;
        self.len = self.len.max(1);
    }
}

impl Poly {
    /// Coefficients as the language lists them: x exponents falling first, then y, then z.
    pub(crate) fn new(degree: u8, coefficients: &[f64]) -> Self {
        let degree = usize::from(degree);
        let mut terms = Vec::new();
        let mut next = coefficients.iter();
        for i in (0..=degree).rev() {
            for j in (0..=degree - i).rev() {
                for k in (0..=degree - i - j).rev() {
                    let factor = next.next().copied().unwrap_or(0.0);
                    if factor != 0.0 {
                        let exponents = [i as i32, j as i32, k as i32];
                        terms.push(Term { factor, exponents, last_in_z: true });
                    }
                }
            }
        }
        for k in 1..terms.len() {
            terms[k - 1].last_in_z = terms[k - 1].exponents[..2] != terms[k].exponents[..2];
        }
        Poly { degree, terms }
    }

    fn search(&self, ray: &Ray, to: &mut impl Collect) {
        match self.degree {
            ..=4 if self.search_stretch(ray, to) => {}
            ..=2 => self.search_sized::<3>(ray, to),
            3 => self.search_sized::<4>(ray, to),
            4 => self.search_sized::<5>(ray, to),
            5..=8 => self.search_sized::<9>(ray, to),
            _ => self.search_sized::<36>(ray, to),
        }
    }

    /// Degrees up to 4 on a stretch of the ray, from values at a few places; answers whether that is exact enough.
    fn search_stretch(&self, ray: &Ray, to: &mut impl Collect) -> bool {
        let (lo, hi) = to.range();
        let width = hi - lo;
        if !width.is_finite() || lo >= hi {
            return false;
        }
        let modest = |row: &[f64]| row.iter().all(|v| v.abs() < MODEST);
        let visit = |s: f64| to.take(LocalHit::at(lo + s * width));
        if self.degree <= 3 {
            let values = self.values::<4>(&ray.at(lo), ray.dir * (width / 3.0));
            let found = modest(&values);
            if found {
                poly::visit_bernstein_roots(&poly::bernstein_cubic_through(values), visit);
            }
            return found;
        }
        // The sixth, which lies beyond the end, only makes an even number.
        let [a, b, c, d, e, _] = self.values::<6>(&ray.at(lo), ray.dir * (width / 4.0));
        let values = [a, b, c, d, e];
        let found = modest(&values);
        if found {
            poly::visit_bernstein_roots(&poly::bernstein_quartic_through(values), visit);
        }
        found
    }

    /// The values of a polynomial of degree up to 4 at points in a row.
    #[inline(always)]
    fn values<const L: usize>(&self, start: &Vec3, step: Vec3) -> Row<L> {
        let (mut x, mut y, mut z) = ([[0.0; L]; 5], [[0.0; L]; 5], [[0.0; L]; 5]);
        for l in 0..L {
            let p = *start + step * l as f64;
            (x[1][l], y[1][l], z[1][l]) = (p.x, p.y, p.z);
        }
        fill_powers(&mut x);
        fill_powers(&mut y);
        fill_powers(&mut z);
        let (mut sum, mut in_z) = ([0.0; L], [0.0; L]);
        for term in &self.terms {
            let [i, j, k] = term.exponents;
            let (x, y, z) = (&x[i as usize], &y[j as usize], &z[k as usize]);
            for l in 0..L {
                in_z[l] += term.factor * z[l];
            }
            if term.last_in_z {
                for l in 0..L {
                    sum[l] += x[l] * y[l] * in_z[l];
                }
                in_z = [0.0; L];
            }
        }
        sum
    }

    fn search_sized<const N: usize>(&self, ray: &Ray, to: &mut impl Collect) {
        // Distances from the point nearest to the origin of coordinates, where the surface is.
        let shift = -ray.origin.dot(ray.dir);
        let along = self.along::<N>(&Ray::new(ray.at(shift), ray.dir));
        let (lo, hi) = to.range();
        poly::visit_roots_in(&along, lo - shift, hi - shift, |t| to.take(LocalHit::at(shift + t)));
    }

    /// The polynomial in t that the surface's polynomial becomes on the ray.
    fn along<const N: usize>(&self, ray: &Ray) -> [f64; N] {
        let (o, d) = (ray.origin, ray.dir);
        let mut rest = Rest(self.terms.iter());
        let mut in_x = Along::<N>::ZERO;
        for i in (0..=rest.exponent([]).unwrap_or(0)).rev() {
            in_x.times_linear(o.x, d.x);
            let mut in_y = Along::<N>::ZERO;
            for j in (0..=rest.exponent([i]).unwrap_or(-1)).rev() {
                in_y.times_linear(o.y, d.y);
                let mut in_z = Along::<N>::ZERO;
                for k in (0..=rest.exponent([i, j]).unwrap_or(-1)).rev() {
                    in_z.times_linear(o.z, d.z);
                    if rest.exponent([i, j]) == Some(k)
                        && let Some(term) = rest.0.next()
                    {
                        in_z.add_constant(term.factor);
                    }
                }
                in_y.add(&in_z);
            }
            in_x.add(&in_y);
        }
        in_x.c
    }

    fn value(&self, p: Vec3) -> f64 {
        self.terms.iter().map(|t| t.factor * powers(p, t.exponents)).sum()
    }
}

fn powers(p: Vec3, e: [i32; 3]) -> f64 {
    p.x.powi(e[0]) * p.y.powi(e[1]) * p.z.powi(e[2])
}

impl Surface for Poly {
    searched_from!(LEAST);

    fn bounds(&self) -> Aabb {
        Aabb::INFINITE
    }

    fn inside(&self, p: Vec3) -> bool {
        self.value(p) < TOLERANCE
    }

    fn normal(&self, p: Vec3, _hit: &LocalHit) -> Vec3 {
        let mut gradient = Vec3::ZERO;
        for term in &self.terms {
            for axis in 0..3 {
                let mut e = term.exponents;
                if e[axis] > 0 {
                    let factor = term.factor * f64::from(e[axis]);
                    e[axis] -= 1;
                    gradient[axis] += factor * powers(p, e);
                }
            }
        }
        gradient.try_normalize().unwrap_or(Vec3::X)
    }
}
