//! Escape-time fractals: Mandelbrot, Julia and magnet sets (textures spec, section 4).
use std::ops::{Add, Div, Mul, Sub};

use raggio_math::Vec3;
use raggio_scene::{FractalKind, FractalSettings};

/// A complex number.
#[derive(Clone, Copy, Debug, PartialEq)]
struct Complex {
    re: f64,
    im: f64,
}

impl Complex {
    const ZERO: Complex = Complex::new(0.0, 0.0);

    const fn new(re: f64, im: f64) -> Self {
        Complex { re, im }
    }

    fn real(re: f64) -> Self {
        Complex::new(re, 0.0)
    }

    fn norm(self) -> f64 {
        self.re * self.re + self.im * self.im
    }

    fn power(self, exponent: u8) -> Self {
        (1..exponent).fold(self, |z, _| z * self)
    }
}

impl Add for Complex {
    type Output = Complex;
    fn add(self, o: Complex) -> Complex {
        Complex::new(self.re + o.re, self.im + o.im)
    }
}

impl Sub for Complex {
    type Output = Complex;
    fn sub(self, o: Complex) -> Complex {
        Complex::new(self.re - o.re, self.im - o.im)
    }
}

impl Mul for Complex {
    type Output = Complex;
    fn mul(self, o: Complex) -> Complex {
        Complex::new(self.re * o.re - self.im * o.im, self.re * o.im + self.im * o.re)
    }
}

impl Mul<Complex> for f64 {
    type Output = Complex;
    fn mul(self, o: Complex) -> Complex {
        Complex::new(self * o.re, self * o.im)
    }
}

impl Div for Complex {
    type Output = Complex;
    fn div(self, o: Complex) -> Complex {
        let conjugate = Complex::new(o.re, -o.im);
        1.0 / o.norm() * (self * conjugate)
    }
}

/// How an iteration ended.
struct Orbit {
    z: Complex,
    /// The least squared distance from 0 on the way.
    closest: f64,
    /// The iteration at which it escaped; `None` if it never did.
    escape: Option<u32>,
}

pub(super) fn value(settings: &FractalSettings, p: Vec3) -> f64 {
    let here = Complex::new(p.x, p.y);
    let c = settings.julia.map_or(here, |c| Complex::new(c.x, c.y));
    let magnet_start = if settings.julia.is_some() { here } else { Complex::ZERO };
    let n = settings.iterations;
    if settings.kind == FractalKind::Power(2)
        && settings.julia.is_none()
        && settings.interior_type == 0
        && stays(c)
    {
        return settings.interior_factor;
    }
    let orbit = match settings.kind {
        FractalKind::Power(2) => power_orbit(here, c, n, |z| z * z),
        FractalKind::Power(e) => power_orbit(here, c, n, |z| z.power(e)),
        FractalKind::Magnet1 => magnet_orbit(magnet_start, n, |z| magnet1(z, c)),
        FractalKind::Magnet2 => magnet_orbit(magnet_start, n, |z| magnet2(z, c)),
    };
    match orbit.escape {
        Some(column) => exterior(settings, orbit.z, column),
        None => interior(settings, &orbit),
    }
}

/// Is the point in the main cardioid or in the disc at its left, the two largest parts of the Mandelbrot set? Their orbits
/// are the longest to follow, and never escape.
fn stays(c: Complex) -> bool {
    let (x, y2) = (c.re - 0.25, c.im * c.im);
    let q = x * x + y2;
    q * (q + x) < 0.25 * y2 || (c.re + 1.0) * (c.re + 1.0) + y2 < 0.0625
}

fn power_orbit(start: Complex, c: Complex, n: u32, power: impl Fn(Complex) -> Complex) -> Orbit {
    iterate(start, start.norm(), n, |z| power(z) + c, |z| z.norm() > 4.0)
}

fn magnet_orbit(start: Complex, n: u32, next: impl Fn(Complex) -> Complex) -> Orbit {
    let stop = |z: Complex| z.norm() > 10000.0 || (z - Complex::real(1.0)).norm() < 0.0001;
    iterate(start, 10000.0, n, next, stop)
}

fn iterate(
    start: Complex,
    closest: f64,
    n: u32,
    next: impl Fn(Complex) -> Complex,
    stop: impl Fn(Complex) -> bool,
) -> Orbit {
    let mut orbit = Orbit { z: start, closest, escape: None };
    for column in 0..n {
        orbit.z = next(orbit.z);
        orbit.closest = orbit.closest.min(orbit.z.norm());
        if stop(orbit.z) {
            orbit.escape = Some(column);
            break;
        }
    }
    orbit
}

fn magnet1(z: Complex, c: Complex) -> Complex {
    let one = Complex::real(1.0);
    let q = (z * z + c - one) / (2.0 * z + c - Complex::real(2.0));
    q * q
}

fn magnet2(z: Complex, c: Complex) -> Complex {
    let one = Complex::real(1.0);
    let c1 = c - one;
    let c12 = c1 * (c - Complex::real(2.0));
    let z2 = z * z;
    let above = z2 * z + 3.0 * (c1 * z) + c12;
    let below = 3.0 * z2 + 3.0 * ((c - Complex::real(2.0)) * z) + c12 + one;
    let q = above / below;
    q * q
}

fn exterior(settings: &FractalSettings, z: Complex, column: u32) -> f64 {
    let (column, n, factor) = (f64::from(column), f64::from(settings.iterations), settings.exterior_factor);
    let modulo = |by: f64| if by >= 1.0 { column % by / factor } else { 0.0 };
    match settings.exterior_type {
        0 => factor,
        2 => z.re * factor,
        3 => z.im * factor,
        4 => z.re * z.re * factor,
        5 => z.im * z.im * factor,
        6 => z.norm().sqrt() * factor,
        7 => modulo(factor.floor()),
        8 => modulo((1.0 + factor).floor()),
        _ => column / n,
    }
}

fn interior(settings: &FractalSettings, orbit: &Orbit) -> f64 {
    let (z, factor) = (orbit.z, settings.interior_factor);
    match settings.interior_type {
        0 => factor,
        1 => orbit.closest.sqrt() * factor,
        2 => z.re * factor,
        3 => z.im * factor,
        4 => z.re * z.re * factor,
        5 => z.im * z.im * factor,
        _ => z.re * z.re + z.im * z.im * factor,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_last_exterior_types_repeat_the_iterations() {
        let value = |exterior_type, exterior_factor| {
            let kind = FractalKind::Power(2);
            let settings = FractalSettings {
                kind,
                julia: None,
                iterations: 25,
                exterior_type,
                exterior_factor,
                interior_type: 0,
                interior_factor: 1.0,
            };
            // 0.4, 0.56, 0.71, 0.91, 1.23, 1.90, 4.03: escapes in the iteration numbered 5.
            value(&settings, Vec3::new(0.4, 0.0, 0.0))
        };
        let column = value(1, 1.0) * 25.0;
        assert!((column - 5.0).abs() < 1e-12, "{column}");
        assert_eq!((value(7, 3.0), value(8, 3.0), value(7, 0.5)), (2.0 / 3.0, 1.0 / 3.0, 0.0));
    }
}
