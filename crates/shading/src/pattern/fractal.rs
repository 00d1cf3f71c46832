//! Escape-time fractals: Mandelbrot, Julia and magnet sets (textures spec, section 4).
use raggio_math::{Vec3, Wide, wide};
use raggio_scene::{FractalKind, FractalSettings};
use wide::f64x4;

use super::complex::{Complex, Number};
use super::each;

/// How an iteration ended.
struct Orbit {
    z: Complex,
    /// The least squared distance from 0 on the way, where it was asked for and nothing escaped.
    closest: f64,
    /// The iteration at which it escaped; `None` if it never did.
    escape: Option<u32>,
}

pub(super) fn value(settings: &FractalSettings, p: Vec3) -> f64 {
    let here = Complex::new(p.x, p.y);
    let c = settings.julia.map_or(here, |c| Complex::new(c.x, c.y));
    let n = settings.iterations;
    if settings.kind == FractalKind::Power(2)
        && settings.julia.is_none()
        && settings.interior_type == 0
        && stays(c)
    {
        return settings.interior_factor;
    }
    let start = if settings.julia.is_some() { here } else { Complex::real(0.0) };
    let orbit = match settings.kind {
        // Who asks how near an orbit came waits longer for every step.
        FractalKind::Power(2) if settings.interior_type != 1 => {
            power_orbit(here, c, n, |z| z * z + c, |_| 0.0)
        }
        FractalKind::Power(2) => power_orbit(here, c, n, |z| z * z + c, Complex::norm),
        FractalKind::Power(e) => power_orbit(here, c, n, |z| z.power(e) + c, Complex::norm),
        FractalKind::Magnet1 => magnet_orbit(start, n, |z| magnet1(z, c)),
        FractalKind::Magnet2 => magnet_orbit(start, n, |z| magnet2(z, c)),
    };
    of_orbit(settings, &orbit)
}

/// Orbits of more steps are followed one by one, because it is seen then when they go round in circles.
const FEW_STEPS: u32 = 200;

/// The values at four points.
pub(super) fn values(settings: &FractalSettings, points: &[Vec3; 4]) -> [f64; 4] {
    let n = settings.iterations;
    if n > FEW_STEPS {
        return points.map(|p| value(settings, p));
    }
    let orbits = wide(Orbits { settings, points });
    each(&orbits, |orbit| of_orbit(settings, orbit))
}

/// The orbits of four points of a fractal.
struct Orbits<'a> {
    settings: &'a FractalSettings,
    points: &'a [Vec3; 4],
}

impl Wide for Orbits<'_> {
    type Output = [Orbit; 4];

    #[inline(always)]
    fn run(self) -> [Orbit; 4] {
        let n = self.settings.iterations;
        let here = Complex::of_each(each(self.points, |p| Complex::new(p.x, p.y)));
        let c = self.settings.julia.map_or(here, |c| Complex::new(f64x4::splat(c.x), f64x4::splat(c.y)));
        let power = |z: Complex<f64x4>| Walk { n, z, closest: z.norm() };
        let start = if self.settings.julia.is_some() { here } else { Complex::real(0.0) };
        let magnet = Walk { n, z: start, closest: f64x4::splat(MAGNET_REACH) };
        // What is not a number has been too large for one.
        let far = |_, norm: f64x4| !norm.simd_le(f64x4::splat(4.0));
        match self.settings.kind {
            FractalKind::Power(2) => power(here).follow(|z| z * z + c, far),
            FractalKind::Power(e) => power(here).follow(|z| z.power(e) + c, far),
            FractalKind::Magnet1 => magnet.follow(|z| magnet1(z, c), magnet_stops),
            FractalKind::Magnet2 => magnet.follow(|z| magnet2(z, c), magnet_stops),
        }
    }
}

fn of_orbit(settings: &FractalSettings, orbit: &Orbit) -> f64 {
    match orbit.escape {
        Some(column) => exterior(settings, orbit.z, column),
        None => interior(settings, orbit),
    }
}

/// Is the point in the main cardioid or in the disc at its left, the two largest parts of the Mandelbrot set? Their orbits
/// are the longest to follow, and never escape.
fn stays(c: Complex) -> bool {
    let (x, y2) = (c.re - 0.25, c.im * c.im);
    let q = x * x + y2;
    q * (q + x) < 0.25 * y2 || (c.re + 1.0) * (c.re + 1.0) + y2 < 0.0625
}

#[inline]
fn power_orbit(
    start: Complex,
    c: Complex,
    n: u32,
    next: impl Fn(Complex) -> Complex,
    distance: impl Fn(Complex) -> f64,
) -> Orbit {
    // What is farther away than 2 and than c never comes back.
    let steps = if c.norm() < 3.9 { 8 } else { 1 };
    let orbit = Orbit { z: start, closest: distance(start), escape: None };
    // Some steps after it has escaped a number may be too large for a number.
    let stop = |z: Complex| z.norm() > 4.0 || z.norm().is_nan();
    iterate(orbit, n, steps, next, stop, distance)
}

/// Squared distances beyond which a magnet's orbit is gone, and from 1 within which it has arrived.
const MAGNET_REACH: f64 = 10000.0;
const MAGNET_HOME: f64 = 0.0001;

fn magnet_orbit(start: Complex, n: u32, next: impl Fn(Complex) -> Complex) -> Orbit {
    let mut orbit = Orbit { z: start, closest: MAGNET_REACH, escape: None };
    for column in 0..n {
        orbit.z = next(orbit.z);
        let norm = orbit.z.norm();
        orbit.closest = nearer(orbit.closest, norm);
        if norm > MAGNET_REACH || (orbit.z - Complex::real(1.0)).norm() < MAGNET_HOME {
            orbit.escape = Some(column);
            break;
        }
    }
    orbit
}

#[inline(always)]
fn magnet_stops(z: Complex<f64x4>, norm: f64x4) -> f64x4 {
    let home = (z - Complex::real(1.0)).norm();
    norm.simd_gt(f64x4::splat(MAGNET_REACH)) | home.simd_lt(f64x4::splat(MAGNET_HOME))
}

/// Four orbits side by side: a step is a long chain of waiting, and one does for all.
struct Walk {
    n: u32,
    z: Complex<f64x4>,
    closest: f64x4,
}

impl Walk {
    /// Follows them until all have stopped. `stop` is told the place and its squared distance from 0, and sets a mask.
    /// What has stopped wanders on until all have, so that no step waits for the mask; where it stopped is kept.
    #[inline(always)]
    fn follow(
        mut self,
        next: impl Fn(Complex<f64x4>) -> Complex<f64x4>,
        stop: impl Fn(Complex<f64x4>, f64x4) -> f64x4,
    ) -> [Orbit; 4] {
        let (mut z, mut on) = (self.z, !f64x4::ZERO);
        let mut columns = f64x4::splat(f64::from(self.n));
        for column in 0..self.n {
            z = next(z);
            let norm = z.norm();
            self.z = z.where_else(on, self.z);
            self.closest = (on & norm.simd_lt(self.closest)).bitselect(norm, self.closest);
            let stopped = stop(z, norm) & on;
            columns = stopped.bitselect(f64x4::splat(f64::from(column)), columns);
            on &= !stopped;
            if on.to_bitmask() == 0 {
                break;
            }
        }
        let (re, im) = (self.z.re.to_array(), self.z.im.to_array());
        let (closest, columns) = (self.closest.to_array(), columns.to_array());
        std::array::from_fn(|i| {
            let column = columns[i] as u32;
            let escape = (column < self.n).then_some(column);
            Orbit { z: Complex::new(re[i], im[i]), closest: closest[i], escape }
        })
    }
}

/// Follows an orbit until it escapes, has made all its steps, or comes back to where it was. Where what has escaped
/// stays away, it is looked for every few steps only. An orbit that comes back has no new places to offer; only the
/// steps that are left over after whole rounds still count. (Places are compared with one that is renewed after 1, 2, 4
/// ... times as many steps: Brent 1980.)
#[inline]
fn iterate(
    mut orbit: Orbit,
    n: u32,
    steps: u32,
    next: impl Fn(Complex) -> Complex,
    stop: impl Fn(Complex) -> bool,
    distance: impl Fn(Complex) -> f64,
) -> Orbit {
    let (mut mark, mut marked, mut renew) = (orbit.z, 0, steps);
    let mut column = 0;
    while column < n {
        let count = if n - column < steps { 1 } else { steps };
        let (mut z, mut closest) = (orbit.z, orbit.closest);
        for _ in 0..count {
            z = next(z);
            closest = nearer(closest, distance(z));
        }
        if stop(z) {
            return escaped(orbit, column..column + count, next, stop);
        }
        (orbit.z, orbit.closest) = (z, closest);
        column += count;
        if z == mark {
            let (left, round) = (n - column, column - marked);
            orbit.z = (0..left % round).fold(z, |z, _| next(z));
            break;
        }
        if column >= renew {
            (mark, marked, renew) = (z, column, column.saturating_mul(2));
        }
    }
    orbit
}

/// The lesser of two numbers, in the form that compilers make into the one instruction.
#[inline]
fn nearer(a: f64, b: f64) -> f64 {
    if b < a { b } else { a }
}

/// The step of those given in which an orbit escapes.
fn escaped(
    mut orbit: Orbit,
    columns: std::ops::Range<u32>,
    next: impl Fn(Complex) -> Complex,
    stop: impl Fn(Complex) -> bool,
) -> Orbit {
    for column in columns {
        orbit.z = next(orbit.z);
        if stop(orbit.z) {
            orbit.escape = Some(column);
            break;
        }
    }
    orbit
}

#[inline(always)]
fn magnet1<T: Number>(z: Complex<T>, c: Complex<T>) -> Complex<T> {
    let one = Complex::real(1.0);
    let q = (z * z + c - one) / (2.0 * z + c - Complex::real(2.0));
    q * q
}

#[inline(always)]
fn magnet2<T: Number>(z: Complex<T>, c: Complex<T>) -> Complex<T> {
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

    #[test]
    fn orbits_that_come_back_end_as_if_followed_to_the_end() {
        let mut stayed = 0;
        for i in 0..400 {
            let c = Complex::new(f64::from(i % 20) * 0.1 - 1.5, f64::from(i / 20) * 0.1 - 1.0);
            for n in [1, 2, 3, 100, 1001] {
                let orbit = power_orbit(c, c, n, |z| z * z + c, Complex::norm);
                let (mut z, mut closest, mut steps) = (c, c.norm(), 0);
                while steps < n && z.norm() <= 4.0 {
                    z = z * z + c;
                    closest = closest.min(z.norm());
                    steps += 1;
                }
                let nearest = if orbit.escape.is_none() { orbit.closest } else { closest };
                assert_eq!((orbit.z, nearest), (z, closest), "{c:?} {n}");
                stayed += u32::from(orbit.escape.is_none() && n == 1001);
            }
        }
        assert!(stayed > 50, "{stayed}");
    }

    #[test]
    fn four_points_together_have_the_values_of_each() {
        use FractalKind::{Magnet1, Magnet2, Power};
        for kind in [Magnet1, Magnet2, Power(2), Power(3)] {
            let settings = FractalSettings {
                kind,
                julia: None,
                iterations: 30,
                exterior_type: 6,
                exterior_factor: 0.5,
                interior_type: 1,
                interior_factor: 0.7,
            };
            for i in 0..200 {
                let p = Vec3::new(f64::from(i) * 0.017 - 1.5, f64::from(i % 7) * 0.3 - 1.0, 0.0);
                let points = [p, -p, 1e10 * p, p + 0.1];
                assert_eq!(values(&settings, &points), points.map(|p| value(&settings, p)), "{kind:?} {p}");
            }
        }
    }
}
