//! Complex numbers, one or four side by side.
use std::ops::{Add, Div, Mul, Sub};

use wide::f64x4;

/// What a complex number's parts are: a number, or four.
pub(super) trait Number:
    Copy + Add<Output = Self> + Sub<Output = Self> + Mul<Output = Self> + Div<Output = Self>
{
    fn of(v: f64) -> Self;
}

impl Number for f64 {
    #[inline(always)]
    fn of(v: f64) -> f64 {
        v
    }
}

impl Number for f64x4 {
    #[inline(always)]
    fn of(v: f64) -> f64x4 {
        f64x4::splat(v)
    }
}

/// A complex number.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Complex<T = f64> {
    pub re: T,
    pub im: T,
}

impl<T: Number> Complex<T> {
    #[inline(always)]
    pub const fn new(re: T, im: T) -> Self {
        Complex { re, im }
    }

    #[inline(always)]
    pub fn real(re: f64) -> Self {
        Complex::new(T::of(re), T::of(0.0))
    }

    /// The squared distance from 0.
    #[inline(always)]
    pub fn norm(self) -> T {
        self.re * self.re + self.im * self.im
    }

    #[inline(always)]
    pub fn power(self, exponent: u8) -> Self {
        (1..exponent).fold(self, |z, _| z * self)
    }
}

impl Complex<f64x4> {
    /// Four numbers side by side.
    #[inline(always)]
    pub fn of_each(z: [Complex; 4]) -> Self {
        let [a, b, c, d] = z;
        Complex::new(f64x4::new([a.re, b.re, c.re, d.re]), f64x4::new([a.im, b.im, c.im, d.im]))
    }

    /// `self` where the mask is set, elsewhere `other`.
    #[inline(always)]
    pub fn where_else(self, mask: f64x4, other: Self) -> Self {
        Complex::new(mask.bitselect(self.re, other.re), mask.bitselect(self.im, other.im))
    }
}

impl<T: Number> Add for Complex<T> {
    type Output = Self;
    #[inline(always)]
    fn add(self, o: Self) -> Self {
        Complex::new(self.re + o.re, self.im + o.im)
    }
}

impl<T: Number> Sub for Complex<T> {
    type Output = Self;
    #[inline(always)]
    fn sub(self, o: Self) -> Self {
        Complex::new(self.re - o.re, self.im - o.im)
    }
}

impl<T: Number> Mul for Complex<T> {
    type Output = Self;
    #[inline(always)]
    fn mul(self, o: Self) -> Self {
        Complex::new(self.re * o.re - self.im * o.im, self.re * o.im + self.im * o.re)
    }
}

impl<T: Number> Mul<Complex<T>> for f64 {
    type Output = Complex<T>;
    #[inline(always)]
    fn mul(self, o: Complex<T>) -> Complex<T> {
        Complex::new(T::of(self) * o.re, T::of(self) * o.im)
    }
}

impl<T: Number> Div for Complex<T> {
    type Output = Self;
    #[inline(always)]
    fn div(self, o: Self) -> Self {
        let conjugate = Complex::new(o.re, T::of(0.0) - o.im);
        let scale = T::of(1.0) / o.norm();
        let product = self * conjugate;
        Complex::new(scale * product.re, scale * product.im)
    }
}
