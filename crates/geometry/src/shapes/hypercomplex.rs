//! Hypercomplex numbers and their orbits, for Julia fractals.
//!
//! `x + iy + jz + kw` with ij = ji = k is the same as the pair of complex numbers `(x - w) + i(y + z)` and
//! `(x + w) + i(y - z)`, on which everything acts one by one.
use std::ops::{Add, Mul, Sub};

use raggio_math::{Vec3, Vec4};
use raggio_scene::JuliaFunction;

use super::julia::proved::{HUGE, Proof};
use super::julia::together::{Ends, LANES, Lanes, Orbits, choose};

/// A complex number.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Complex {
    re: f64,
    im: f64,
}

const ONE: Complex = Complex { re: 1.0, im: 0.0 };
const I: Complex = Complex { re: 0.0, im: 1.0 };

impl Add for Complex {
    type Output = Complex;
    #[inline(always)]
    fn add(self, o: Complex) -> Complex {
        Complex { re: self.re + o.re, im: self.im + o.im }
    }
}

impl Sub for Complex {
    type Output = Complex;
    #[inline(always)]
    fn sub(self, o: Complex) -> Complex {
        Complex { re: self.re - o.re, im: self.im - o.im }
    }
}

impl Mul for Complex {
    type Output = Complex;
    #[inline(always)]
    fn mul(self, o: Complex) -> Complex {
        Complex { re: self.re * o.re - self.im * o.im, im: self.re * o.im + self.im * o.re }
    }
}

impl Complex {
    #[inline(always)]
    fn times(self, k: f64) -> Complex {
        Complex { re: self.re * k, im: self.im * k }
    }
    #[inline(always)]
    fn inverse(self) -> Complex {
        let size2 = self.re * self.re + self.im * self.im;
        Complex { re: self.re / size2, im: -self.im / size2 }
    }
    fn exp(self) -> Complex {
        let (sin, cos) = self.im.sin_cos();
        Complex { re: cos, im: sin }.times(self.re.exp())
    }
    fn ln(self) -> Complex {
        Complex { re: self.re.hypot(self.im).ln(), im: self.im.atan2(self.re) }
    }
    fn sqrt(self) -> Complex {
        let size = self.re.hypot(self.im);
        let (re, im) = ((0.5 * (size + self.re)).max(0.0).sqrt(), (0.5 * (size - self.re)).max(0.0).sqrt());
        Complex { re, im: im.copysign(self.im) }
    }
    fn sinh(self) -> Complex {
        (self.exp() - self.times(-1.0).exp()).times(0.5)
    }
    fn cosh(self) -> Complex {
        (self.exp() + self.times(-1.0).exp()).times(0.5)
    }
    fn asinh(self) -> Complex {
        (self + (self * self + ONE).sqrt()).ln()
    }
    fn acosh(self) -> Complex {
        (self + (self + ONE).sqrt() * (self - ONE).sqrt()).ln()
    }
    fn atanh(self) -> Complex {
        ((ONE + self).ln() - (ONE - self).ln()).times(0.5)
    }
    /// `-i f(i z)`, which turns a hyperbolic function into its circular sister.
    fn circular(self, f: fn(Complex) -> Complex) -> Complex {
        f(self * I) * I.times(-1.0)
    }
    /// Half the real part of `conj(self) * o`.
    #[inline(always)]
    fn half_dot(self, o: Complex) -> f64 {
        0.5 * (self.re * o.re + self.im * o.im)
    }
}

/// A hypercomplex number as its pair of complex numbers, the real parts beside each other.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Hypercomplex {
    re: [f64; 2],
    im: [f64; 2],
}

impl Hypercomplex {
    /// From x, y, z, w.
    #[inline(always)]
    pub(crate) fn from_vec(v: Vec4) -> Self {
        Hypercomplex { re: [v.x - v.w, v.x + v.w], im: [v.y + v.z, v.y - v.z] }
    }
    #[inline(always)]
    fn of(a: Complex, b: Complex) -> Self {
        Hypercomplex { re: [a.re, b.re], im: [a.im, b.im] }
    }
    #[inline(always)]
    fn part(self, k: usize) -> Complex {
        Complex { re: self.re[k], im: self.im[k] }
    }
    #[inline(always)]
    fn each(self, f: impl Fn(Complex) -> Complex) -> Self {
        Self::of(f(self.part(0)), f(self.part(1)))
    }
    #[inline(always)]
    fn with(self, o: Self, f: impl Fn(Complex, Complex) -> Complex) -> Self {
        Self::of(f(self.part(0), o.part(0)), f(self.part(1), o.part(1)))
    }
    #[inline(always)]
    fn dot(self, o: Self) -> f64 {
        self.part(0).half_dot(o.part(0)) + self.part(1).half_dot(o.part(1))
    }
}

/// What an orbit repeats, before it adds the parameter.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum Map {
    /// The square; also what POV-Ray computes for `cube`.
    Square,
    /// One over.
    Reciprocal,
    /// Any other function.
    Function(JuliaFunction),
}

/// How an orbit ended.
pub(crate) struct Orbit {
    /// The squared size with which it escaped, if it did.
    pub(crate) escaped: Option<f64>,
    last: Hypercomplex,
    /// The product that stands for the derivative.
    product: Hypercomplex,
}

impl Orbit {
    /// How fast half the squared size of the last number grows along a direction.
    #[inline(always)]
    pub(crate) fn growth(&self, dir: Vec3) -> f64 {
        self.last.dot(self.product.with(Hypercomplex::from_vec(dir.extend(0.0)), |a, b| a * b))
    }

    /// The direction in which the size of the last number grows, in x, y and z.
    pub(crate) fn gradient(&self) -> Vec3 {
        let product = self.product;
        let along_y = product.each(|x| x * I);
        let along_z = Hypercomplex::of(product.part(0) * I, product.part(1) * I.times(-1.0));
        Vec3::new(self.last.dot(product), self.last.dot(along_y), self.last.dot(along_z))
    }
}

impl Map {
    /// The map of a function of the language.
    pub(crate) fn of(function: JuliaFunction) -> Self {
        match function {
            JuliaFunction::Sqr | JuliaFunction::Cube => Map::Square,
            JuliaFunction::Reciprocal => Map::Reciprocal,
            other => Map::Function(other),
        }
    }

    /// What POV-Ray multiplies the growth of an orbit by in its steps. The product of squares lacks the factor 2 of the
    /// first step; the others are taken as they are.
    pub(crate) fn growth_scale(self) -> f64 {
        match self {
            Map::Square => 4.0,
            Map::Reciprocal | Map::Function(_) => 2.0,
        }
    }

    /// Where POV-Ray starts the orbit for the inside test and the normal: functions take y for z.
    pub(crate) fn defective_start(self, q: Vec4) -> Vec4 {
        match self {
            Map::Function(_) => Vec4::new(q.x, q.y, q.y, q.w),
            _ => q,
        }
    }

    /// Follows the orbit of `q` for `steps` steps or until its squared size is more than `escape`.
    #[inline(always)]
    pub(crate) fn orbit(self, q: Hypercomplex, c: Hypercomplex, steps: u32, escape: f64) -> Orbit {
        let limits = (steps, escape);
        match self {
            Map::Square => orbit(q, c, limits, square, twice),
            Map::Reciprocal => orbit(q, c, limits, Complex::inverse, minus_square),
            Map::Function(f) => orbit(q, c, limits, |x| value(f, x), |_, value| value),
        }
    }

    /// The step at which the orbit escapes, or `steps`, and the squared size of the last number that was looked at.
    pub(crate) fn last_size(self, q: Hypercomplex, c: Hypercomplex, steps: u32, escape: f64) -> (u32, f64) {
        match self {
            Map::Square => last_size(q, c, (steps, escape), square),
            Map::Reciprocal => last_size(q, c, (steps, escape), Complex::inverse),
            Map::Function(f) => last_size(q, c, (steps, escape), |x| value(f, x)),
        }
    }

    /// Do the orbits of all pairs in two balls (middles and radii) escape, or none? Nothing is proved of functions.
    pub(crate) fn proof(self, ball: (Hypercomplex, [f64; 2]), c: Hypercomplex, limits: (u32, f64)) -> Proof {
        match self {
            Map::Square => proof(ball, c, limits, square, |n, r| r * (2.0 * n + r)),
            // No bound at all where the ball holds zero.
            Map::Reciprocal => {
                let spread = |n: f64, r: f64| if r < n { r / (n * (n - r)) } else { f64::INFINITY };
                proof(ball, c, limits, Complex::inverse, spread)
            }
            Map::Function(_) => Proof::Open,
        }
    }

    /// The orbit, if it escapes.
    #[inline(always)]
    pub(crate) fn escape(self, q: Hypercomplex, c: Hypercomplex, steps: u32, escape: f64) -> Option<Orbit> {
        let orbit = self.orbit(q, c, steps, escape);
        orbit.escaped.is_some().then_some(orbit)
    }
}

#[inline(always)]
fn square(x: Complex) -> Complex {
    x * x
}

/// The derivative of the square.
#[inline(always)]
fn twice(x: Complex, _: Complex) -> Complex {
    x.times(2.0)
}

/// The derivative of the inverse.
#[inline(always)]
fn minus_square(_: Complex, value: Complex) -> Complex {
    (value * value).times(-1.0)
}

/// The orbit of a map, with the product of the factors of its steps, each made from a number and its value.
#[inline(always)]
fn orbit(
    mut q: Hypercomplex,
    c: Hypercomplex,
    (steps, escape): (u32, f64),
    map: impl Fn(Complex) -> Complex,
    factor: impl Fn(Complex, Complex) -> Complex,
) -> Orbit {
    let mut product = q;
    for k in 0..steps {
        let size2 = q.dot(q);
        if size2.is_nan() || size2 > escape {
            return Orbit { escaped: Some(size2), last: q, product };
        }
        let value = q.each(&map);
        // The first factor is the start itself.
        if k > 0 {
            product = product.with(q.with(value, &factor), |a, b| a * b);
        }
        q = value.with(c, |a, b| a + b);
    }
    Orbit { escaped: None, last: q, product }
}

/// The step at which the orbit escapes, or `steps`, and the squared size of the last number that was looked at.
#[inline(always)]
fn last_size(
    mut q: Hypercomplex,
    c: Hypercomplex,
    (steps, escape): (u32, f64),
    map: impl Fn(Complex) -> Complex,
) -> (u32, f64) {
    let mut size2 = 0.0;
    for k in 0..steps {
        size2 = q.dot(q);
        if size2.is_nan() || size2 > escape {
            return (k, size2);
        }
        q = q.each(&map).with(c, |a, b| a + b);
    }
    (steps, size2)
}

/// [`orbit`] of some squares together, with how fast half the squared sizes grow along the ray.
#[inline(always)]
pub(crate) fn follow_squares(orbits: &Orbits, t: Lanes) -> Ends {
    let Orbits { line: [from, along], steps, escape, .. } = *orbits;
    let c = Hypercomplex::from_vec(orbits.parameter);
    let direction = Hypercomplex::from_vec(along.truncate().extend(0.0));
    // The parts of the numbers and of the products, one after the other.
    let [mut re, mut im] = [[[0.0; LANES]; 2]; 2];
    for k in 0..LANES {
        let q = Hypercomplex::from_vec(from + along * t[k]);
        (re[0][k], re[1][k], im[0][k], im[1][k]) = (q.re[0], q.re[1], q.im[0], q.im[1]);
    }
    let (mut product_re, mut product_im) = (re, im);
    let mut ends = Ends::NONE;
    let mut bound = [u64::MAX; LANES];
    for step in 0..steps {
        for k in 0..LANES {
            let half = |part: usize| 0.5 * (re[part][k] * re[part][k] + im[part][k] * im[part][k]);
            ends.look(k, &mut bound, half(0) + half(1), escape);
        }
        if bound == [0; LANES] {
            break;
        }
        for part in 0..2 {
            let (c_re, c_im) = (c.re[part], c.im[part]);
            for k in 0..LANES {
                let (q, p) = ((re[part][k], im[part][k]), (product_re[part][k], product_im[part][k]));
                let (twice_re, twice_im) = (2.0 * q.0, 2.0 * q.1);
                if step > 0 {
                    product_re[part][k] = choose(bound[k], p.0 * twice_re - p.1 * twice_im, p.0);
                    product_im[part][k] = choose(bound[k], p.0 * twice_im + p.1 * twice_re, p.1);
                }
                re[part][k] = choose(bound[k], q.0 * q.0 - q.1 * q.1 + c_re, q.0);
                im[part][k] = choose(bound[k], q.0 * q.1 + q.1 * q.0 + c_im, q.1);
            }
        }
    }
    for k in 0..LANES {
        let growth = |part: usize| {
            let (p_re, p_im) = (product_re[part][k], product_im[part][k]);
            let (d_re, d_im) = (direction.re[part], direction.im[part]);
            let (grown_re, grown_im) = (p_re * d_re - p_im * d_im, p_re * d_im + p_im * d_re);
            0.5 * (re[part][k] * grown_re + im[part][k] * grown_im)
        };
        ends.slope[k] = growth(0) + growth(1);
    }
    ends
}

/// [`Map::proof`] of a map with what it makes of a radius around a number of some size.
fn proof(
    (mut q, mut radii): (Hypercomplex, [f64; 2]),
    c: Hypercomplex,
    (steps, escape): (u32, f64),
    map: impl Fn(Complex) -> Complex,
    spread: impl Fn(f64, f64) -> f64,
) -> Proof {
    let mut none = true;
    for _ in 0..steps {
        let size = |k: usize| (q.re[k] * q.re[k] + q.im[k] * q.im[k]).sqrt();
        let sizes = [size(0), size(1)];
        let size2 =
            |at: fn(f64, f64) -> f64| 0.5 * (at(sizes[0], radii[0]).powi(2) + at(sizes[1], radii[1]).powi(2));
        if size2(|n, r| (n - r).max(0.0)) > escape {
            return Proof::Outside;
        }
        let most = size2(|n, r| n + r);
        if most.is_nan() || most > HUGE {
            return Proof::Open;
        }
        none &= most < escape;
        radii = [spread(sizes[0], radii[0]), spread(sizes[1], radii[1])];
        q = q.each(&map).with(c, |a, b| a + b);
    }
    if none { Proof::Inside } else { Proof::Open }
}

fn value(function: JuliaFunction, x: Complex) -> Complex {
    use JuliaFunction as F;
    match function {
        F::Sqr => x * x,
        F::Cube => x * x * x,
        F::Reciprocal => x.inverse(),
        F::Exp => x.exp(),
        F::Ln => x.ln(),
        F::Sinh => x.sinh(),
        F::Cosh => x.cosh(),
        F::Tanh => x.sinh() * x.cosh().inverse(),
        F::Asinh => x.asinh(),
        F::Acosh => x.acosh(),
        F::Atanh => x.atanh(),
        F::Sin => x.circular(Complex::sinh),
        F::Cos => (x * I).cosh(),
        F::Tan => x.circular(Complex::sinh) * (x * I).cosh().inverse(),
        F::Asin => x.circular(Complex::asinh),
        F::Acos => Complex { re: std::f64::consts::FRAC_PI_2, im: 0.0 } - x.circular(Complex::asinh),
        F::Atan => x.circular(Complex::atanh),
        F::Pwr(re, im) => (x.ln() * Complex { re, im }).exp(),
    }
}
