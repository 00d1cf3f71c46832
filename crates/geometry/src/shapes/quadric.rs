//! The quadric: the general surface of second degree.
use raggio_math::{Aabb, Ray, Vec3};

use super::beyond;
use crate::{LocalHit, Surface};

/// The least distance a quadric reports.
const LEAST: f64 = 1e-6;

/// `p . squares p + p . mixed(p) + p . linear + constant`; inside where that is not positive.
#[derive(Clone, Copy)]
pub(crate) struct Quadric {
    /// Coefficients of x2, y2, z2.
    squares: Vec3,
    /// Coefficients of xy, xz, yz.
    mixed: Vec3,
    linear: Vec3,
    constant: f64,
    /// Of the reported normal against the gradient.
    sign: f64,
}

impl Quadric {
    /// From the coefficients `a..=j` in the order of the language.
    pub(crate) fn new(c: &[f64; 10]) -> Self {
        Quadric {
            squares: Vec3::new(c[0], c[1], c[2]),
            mixed: Vec3::new(c[3], c[4], c[5]),
            linear: Vec3::new(c[6], c[7], c[8]),
            constant: c[9],
            sign: 1.0,
        }
    }

    /// Inside and outside exchanged. The reported normal stays: the language negates both the coefficients and the
    /// normal.
    pub(crate) fn inverse(&self) -> Self {
        Quadric {
            squares: -self.squares,
            mixed: -self.mixed,
            linear: -self.linear,
            constant: -self.constant,
            sign: -self.sign,
        }
    }

    fn value(&self, p: Vec3) -> f64 {
        p.dot(self.squares * p + self.linear)
            + self.mixed.dot(Vec3::new(p.x * p.y, p.x * p.z, p.y * p.z))
            + self.constant
    }

    /// The gradient without the linear part.
    #[inline]
    fn slope(&self, p: Vec3) -> Vec3 {
        let m = self.mixed;
        Vec3::new(
            2.0 * self.squares.x * p.x + m.x * p.y + m.y * p.z,
            2.0 * self.squares.y * p.y + m.x * p.x + m.z * p.z,
            2.0 * self.squares.z * p.z + m.y * p.x + m.z * p.y,
        )
    }

    /// The parameters of both hits, the second repeated where there is but one.
    #[inline]
    fn roots(&self, ray: &Ray) -> Option<(f64, f64)> {
        let a = 0.5 * self.slope(ray.dir).dot(ray.dir);
        let b = 0.5 * (self.slope(ray.origin) + self.linear).dot(ray.dir);
        let c = self.value(ray.origin);
        if a == 0.0 {
            let t = -0.5 * c / b;
            return Some((t, t));
        }
        let discriminant = b * b - a * c;
        if discriminant <= 0.0 || discriminant.is_nan() {
            return None;
        }
        let q = -(b + discriminant.sqrt().copysign(b));
        let (s, t) = (q / a, if q == 0.0 { 0.0 } else { c / q });
        Some((s.min(t), s.max(t)))
    }

    /// The least that the part along one axis can be, or minus infinity.
    fn least(&self, axis: usize) -> f64 {
        let (a, b) = (self.sign * self.squares[axis], self.sign * self.linear[axis]);
        match (a > 0.0, a == 0.0 && b == 0.0) {
            (true, _) => -b * b / (4.0 * a),
            (_, true) => 0.0,
            _ => f64::NEG_INFINITY,
        }
    }

    /// Where the part along one axis is at most `most`.
    fn interval(&self, axis: usize, most: f64) -> (f64, f64) {
        let (a, b) = (self.sign * self.squares[axis], self.sign * self.linear[axis]);
        if a > 0.0 {
            let (middle, reach) = (-b / (2.0 * a), (most / a + b * b / (4.0 * a * a)).max(0.0).sqrt());
            (middle - reach, middle + reach)
        } else if a == 0.0 && b > 0.0 {
            (f64::NEG_INFINITY, most / b)
        } else if a == 0.0 && b < 0.0 {
            (most / b, f64::INFINITY)
        } else {
            (f64::NEG_INFINITY, f64::INFINITY)
        }
    }
}

impl Surface for Quadric {
    /// Finite sides where the quadric lies along the axes and is bounded that way.
    fn bounds(&self) -> Aabb {
        let mut bounds = Aabb::INFINITE;
        if self.mixed != Vec3::ZERO {
            return bounds;
        }
        for axis in 0..3 {
            let others = self.least((axis + 1) % 3) + self.least((axis + 2) % 3);
            if others.is_finite() {
                (bounds.min[axis], bounds.max[axis]) =
                    self.interval(axis, -self.sign * self.constant - others);
            }
        }
        // A hair more, for the rounding of the above.
        let grow = |v: Vec3| v.map(|x| if x.is_finite() { x.abs() * 1e-9 + 1e-9 } else { 0.0 });
        Aabb { min: bounds.min - grow(bounds.min), max: bounds.max + grow(bounds.max) }
    }

    fn inside_bounds(&self) -> Aabb {
        if self.sign < 0.0 { Aabb::INFINITE } else { self.bounds() }
    }

    fn hits(&self, ray: &Ray, range: (f64, f64), out: &mut Vec<LocalHit>) {
        let (lo, hi) = beyond(range, LEAST);
        if let Some((s, t)) = self.roots(ray) {
            let within = |t: f64| t > lo && t < hi;
            if within(s) {
                out.push(LocalHit::at(s));
            }
            if t != s && within(t) {
                out.push(LocalHit::at(t));
            }
        }
    }

    #[inline]
    fn closest(&self, ray: &Ray, range: (f64, f64)) -> Option<LocalHit> {
        let (lo, hi) = beyond(range, LEAST);
        let (s, t) = self.roots(ray)?;
        let t = if s > lo { s } else { t };
        (t > lo && t < hi).then(|| LocalHit::at(t))
    }

    fn inside(&self, p: Vec3) -> bool {
        self.value(p) <= 0.0
    }

    fn normal(&self, p: Vec3, _: &LocalHit) -> Vec3 {
        ((self.slope(p) + self.linear) * self.sign).normalize_or(Vec3::X)
    }
}
