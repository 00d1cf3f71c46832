//! The quadric: the general surface of second degree.
use raggio_math::{Aabb, Mat3, Ray, Vec3};

use super::{Few, Stretch, beyond};
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

    /// A ball about the origin.
    pub(crate) fn ball(radius: f64) -> Self {
        Quadric::new(&[1.0, 1.0, 1.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, -radius * radius])
    }

    /// The same surface in coordinates about the same origin.
    pub(crate) fn turned_by(&self, here_from_there: &Mat3) -> Self {
        let (s, m, turn) = (self.squares, 0.5 * self.mixed, here_from_there);
        let form =
            Mat3::from_cols(Vec3::new(s.x, m.x, m.y), Vec3::new(m.x, s.y, m.z), Vec3::new(m.y, m.z, s.z));
        let form = turn.transpose() * form * *turn;
        Quadric {
            squares: Vec3::new(form.x_axis.x, form.y_axis.y, form.z_axis.z),
            mixed: 2.0 * Vec3::new(form.x_axis.y, form.x_axis.z, form.y_axis.z),
            linear: turn.transpose() * self.linear,
            ..*self
        }
    }

    /// Has [`Quadric::inverse`] made it?
    pub(crate) fn is_turned(&self) -> bool {
        self.sign < 0.0
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

    /// `a`, `b`, `c` of the value along the ray: `a t^2 + 2 b t + c`.
    #[inline(always)]
    fn along(&self, ray: &Ray) -> (f64, f64, f64) {
        let a = 0.5 * self.slope(ray.dir).dot(ray.dir);
        let slope = self.slope(ray.origin);
        let b = 0.5 * (slope + self.linear).dot(ray.dir);
        let c = (0.5 * slope + self.linear).dot(ray.origin) + self.constant;
        (a, b, c)
    }

    /// The parameters of both hits, the second repeated where there is but one.
    #[inline(always)]
    fn roots(&self, ray: &Ray) -> Option<(f64, f64)> {
        let (a, b, c) = self.along(ray);
        if a == 0.0 {
            let t = -0.5 * c / b;
            return Some((t, t));
        }
        two_roots(a, b, c)
    }

    /// Where the ray, whose direction may be of any length, is inside.
    #[inline(always)]
    pub(crate) fn stretch(&self, ray: &Ray) -> Stretch {
        let (a, b, c) = self.along(ray);
        if a == 0.0 {
            return straight_stretch(b, c);
        }
        match two_roots(a, b, c) {
            Some((enter, leave)) => Stretch { enter, leave, beyond: a < 0.0 },
            None if c <= 0.0 => Stretch::EVERYWHERE,
            None => Stretch::NOWHERE,
        }
    }

    /// Both hits, as far as they are in the range.
    #[inline]
    pub(crate) fn few(&self, ray: &Ray, range: (f64, f64), out: &mut Few) {
        let range = beyond(range, LEAST);
        if let Some((s, t)) = self.roots(ray) {
            out.push(s, 0, range);
            if t != s {
                out.push(t, 0, range);
            }
        }
    }

    /// The least that the part along one axis can be between two coordinates.
    fn least(&self, axis: usize, lo: f64, hi: f64) -> f64 {
        let (a, b) = (self.sign * self.squares[axis], self.sign * self.linear[axis]);
        let value = |x: f64| match (a == 0.0 && b == 0.0, x.is_infinite()) {
            (true, _) => 0.0,
            (_, false) => x * (a * x + b),
            (_, true) if a == 0.0 => b * x,
            _ => a * f64::INFINITY,
        };
        if a > 0.0 {
            return value((-b / (2.0 * a)).max(lo).min(hi));
        }
        value(lo).min(value(hi))
    }

    /// A box around the part of the solid that lies within a box, in the quadric's own coordinates: finite sides where
    /// the quadric lies along the axes and is bounded that way.
    pub(crate) fn bounds_within(&self, within: &Aabb) -> Aabb {
        let mut bounds = *within;
        if self.mixed != Vec3::ZERO || within.is_empty() {
            return bounds;
        }
        let least = |axis: usize| self.least(axis, within.min[axis], within.max[axis]);
        for axis in 0..3 {
            let others = least((axis + 1) % 3) + least((axis + 2) % 3);
            if others.is_finite() {
                let (lo, hi) = self.interval(axis, -self.sign * self.constant - others);
                // A hair more, for the rounding of the above.
                let grow = |x: f64| if x.is_finite() { x.abs() * 1e-9 + 1e-9 } else { 0.0 };
                bounds.min[axis] = within.min[axis].max(lo - grow(lo));
                bounds.max[axis] = within.max[axis].min(hi + grow(hi));
            }
        }
        bounds
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

/// Where `a t^2 + 2 b t + c` is zero, for an `a` that is not.
#[inline(always)]
pub(super) fn two_roots(a: f64, b: f64, c: f64) -> Option<(f64, f64)> {
    let discriminant = b * b - a * c;
    if discriminant <= 0.0 || discriminant.is_nan() {
        return None;
    }
    let q = -(b + discriminant.sqrt().copysign(b));
    let (s, t) = (q / a, if q == 0.0 { 0.0 } else { c / q });
    Some(if s < t { (s, t) } else { (t, s) })
}

/// Where `2 b t + c` is not positive.
#[cold]
fn straight_stretch(b: f64, c: f64) -> Stretch {
    let (t, far) = (-0.5 * c / b, f64::INFINITY);
    if !t.is_finite() {
        // The ray that stays as deep as it is has no end that is a number.
        return if c <= 0.0 { Stretch::EVERYWHERE } else { Stretch::NOWHERE };
    }
    Stretch::between(Some(if b > 0.0 { (-far, t) } else { (t, far) }))
}

impl Surface for Quadric {
    fn bounds(&self) -> Aabb {
        self.bounds_within(&Aabb::INFINITE)
    }

    fn inside_bounds(&self) -> Aabb {
        if self.sign < 0.0 { Aabb::INFINITE } else { self.bounds() }
    }

    fn hits(&self, ray: &Ray, range: (f64, f64), out: &mut Vec<LocalHit>) {
        let mut few = Few::default();
        self.few(ray, range, &mut few);
        few.into_hits(out);
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

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_ray_along_a_pipe_stays_in_it_or_out_of_it() {
        let pipe = Quadric::new(&[1.0, 1.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, -1.0]);
        let within = pipe.stretch(&Ray::new(Vec3::new(0.3, 0.2, -5.0), Vec3::Z));
        assert!(within.beyond && within.enter > within.leave, "{within:?}");
        let without = pipe.stretch(&Ray::new(Vec3::new(1.3, 0.2, -5.0), Vec3::Z));
        assert!(!without.beyond && without.enter > without.leave, "{without:?}");
    }

    #[test]
    fn a_hyperboloid_between_two_heights_has_a_box() {
        // x2 - y2 + z2 = 1
        let waist = Quadric::new(&[1.0, -1.0, 1.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, -1.0]);
        assert_eq!(waist.bounds(), Aabb::INFINITE);
        let mut slab = Aabb::INFINITE;
        (slab.min.y, slab.max.y) = (-2.0, 1.0);
        let b = waist.bounds_within(&slab);
        let r = 5f64.sqrt();
        assert!((b.min - Vec3::new(-r, -2.0, -r)).length() < 1e-7, "{b:?}");
        assert!((b.max - Vec3::new(r, 1.0, r)).length() < 1e-7, "{b:?}");
        // A paraboloid, y = x2 + z2, below a height.
        let bowl = Quadric::new(&[1.0, 0.0, 1.0, 0.0, 0.0, 0.0, 0.0, -1.0, 0.0, 0.0]);
        slab.max.y = 4.0;
        let b = bowl.bounds_within(&slab);
        assert!((b.max - Vec3::new(2.0, 4.0, 2.0)).length() < 1e-7 && b.min.y.abs() < 1e-7, "{b:?}");
    }
}
