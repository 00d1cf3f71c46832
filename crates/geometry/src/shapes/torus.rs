//! The torus, ring or spindle, about the y axis (shapes spec, section 2).
use raggio_math::{Aabb, EPS, Ray, Vec2, Vec3, poly};

use super::collect::{AllOfFew, Collect, searched_from};
use super::revolve::{circle_reach, clip_to_cylinder, clip_to_slab, radius, radius_squared};
use super::{Few, beyond};
use crate::{LocalHit, Surface};

const LEAST: f64 = 1e-4;

/// A torus: the tube of radius `minor` around a circle of radius `major`.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Torus {
    major: f64,
    minor: f64,
}

impl Torus {
    /// A negative `minor` is never hit.
    pub(crate) fn new(major: f64, minor: f64) -> Self {
        Torus { major, minor }
    }

    /// Is a ray in the hole wherever it is as high as the ring? It is nowhere farther out than at one of the ends.
    #[inline]
    fn goes_through_hole(&self, ray: &Ray, (lo, hi): (f64, f64)) -> bool {
        let hole = (self.major.abs() - self.minor).max(0.0) * (1.0 - EPS);
        let [c, b, a] = radius_squared(ray);
        let out = |t: f64| (a * t + b) * t + c;
        out(lo) < hole * hole && out(hi) < hole * hole
    }

    /// All hits.
    pub(super) fn few(&self, ray: &Ray, range: (f64, f64), out: &mut Few) {
        self.search(ray, &mut AllOfFew { range: beyond(range, LEAST), out });
    }

    fn search(&self, ray: &Ray, to: &mut impl Collect) {
        let outer = self.major.abs() + self.minor;
        if self.minor < 0.0 {
            return;
        }
        let slab = clip_to_slab(ray.origin.y, ray.dir.y, (-self.minor, self.minor), to.range());
        let Some(slab) = slab.filter(|&slab| !self.goes_through_hole(ray, slab)) else { return };
        let Some((lo, hi)) = clip_to_cylinder(ray, outer, slab) else { return };
        let start = Ray::new(ray.at(lo), ray.dir);
        let curve = torus_curve(&start, hi - lo, self.major, self.minor);
        poly::visit_bernstein_roots(&curve, |s| to.take(LocalHit::at(lo + s * (hi - lo))));
    }
}

/// `(p.p + R^2 - r^2)^2 - 4 R^2 (x^2 + z^2)` along the first `length` of a ray of unit direction, over the torus about the
/// origin: Bernstein coefficients. It is zero on `(rho - R)^2 + y^2 = r^2` and on the mirror sheet `(rho + R)^2 + y^2 =
/// r^2`, which a spindle has.
#[inline(always)]
pub(crate) fn torus_curve(ray: &Ray, length: f64, major: f64, minor: f64) -> [f64; 5] {
    let (o, d) = (ray.origin, ray.dir);
    let (four, square) = (4.0 * major * major, length * length);
    let (turn, slope) = (o.x * o.x + o.z * o.z, length * (o.x * d.x + o.z * d.z));
    let f0 = turn + o.y * o.y + (major - minor) * (major + minor);
    let f1 = f0 + slope + length * o.y * d.y;
    let f2 = 2.0 * f1 - f0 + square;
    let g0 = four * turn;
    let g1 = g0 + four * slope;
    let g2 = 2.0 * g1 - g0 + four * square * (d.x * d.x + d.z * d.z);
    [
        f0 * f0 - g0,
        f0 * f1 - 0.5 * (g0 + g1),
        (f0 * f2 + 2.0 * f1 * f1) / 3.0 - (g0 + 4.0 * g1 + g2) / 6.0,
        f1 * f2 - 0.5 * (g1 + g2),
        f2 * f2 - g2,
    ]
}

/// `(atan2(y, x) + pi) / 2 pi`, in 0..=1.
fn share(y: f64, x: f64) -> f64 {
    (y.atan2(x) + std::f64::consts::PI) / std::f64::consts::TAU
}

impl Surface for Torus {
    searched_from!(LEAST);

    fn bounds(&self) -> Aabb {
        if self.minor < 0.0 {
            return Aabb::EMPTY;
        }
        let outer = self.major.abs() + self.minor;
        let corner = Vec3::new(outer, self.minor, outer);
        Aabb::new(-corner, corner)
    }

    fn reach(&self, along: Vec3) -> Option<f64> {
        Some(circle_reach(0.0, self.major, along) + self.minor * along.length())
    }

    fn inside(&self, p: Vec3) -> bool {
        let rho = radius(p) - self.major;
        rho * rho + p.y * p.y <= self.minor * self.minor
    }

    fn normal(&self, p: Vec3, _hit: &LocalHit) -> Vec3 {
        let rho = radius(p);
        let away = if rho < EPS {
            p
        } else {
            let k = 1.0 - self.major / rho;
            Vec3::new(p.x * k, p.y, p.z * k)
        };
        away.try_normalize().unwrap_or(Vec3::Y)
    }

    fn uv(&self, p: Vec3, _hit: &LocalHit) -> Option<Vec2> {
        let rho = radius(p);
        Some(Vec2::new(1.0 - share(p.z, p.x), share(p.y, rho - self.major)))
    }
}
