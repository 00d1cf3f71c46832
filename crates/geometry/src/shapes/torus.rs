//! The torus, ring or spindle, about the y axis (shapes spec, section 2).
use raggio_math::{Aabb, Ray, Vec2, Vec3, poly};

use super::collect::{Collect, searched_from};
use super::revolve::{circle_reach, clip_to_barrel};
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

    fn search(&self, ray: &Ray, to: &mut impl Collect) {
        let outer = self.major.abs() + self.minor;
        if self.minor < 0.0 {
            return;
        }
        let Some((lo, hi)) = clip_to_barrel(ray, (-self.minor, self.minor), outer, to.range()) else {
            return;
        };
        // Distances from the middle of what is left of the ray keep the coefficients small.
        let middle = 0.5 * (lo + hi);
        let quartic = torus_quartic(&Ray::new(ray.at(middle), ray.dir), self.major, self.minor);
        poly::visit_roots_in(&quartic, lo - middle, hi - middle, |t| to.take(LocalHit::at(middle + t)));
    }
}

/// `(p.p + R^2 - r^2)^2 - 4 R^2 (x^2 + z^2)` along a ray of unit direction, over the torus about the origin. It is zero
/// on `(rho - R)^2 + y^2 = r^2` and on the mirror sheet `(rho + R)^2 + y^2 = r^2`, which a spindle has.
pub(crate) fn torus_quartic(ray: &Ray, major: f64, minor: f64) -> [f64; 5] {
    let (o, d) = (ray.origin, ray.dir);
    let b = 2.0 * o.dot(d);
    let c = o.length_squared() + (major - minor) * (major + minor);
    let four = 4.0 * major * major;
    [
        c * c - four * (o.x * o.x + o.z * o.z),
        2.0 * b * c - four * 2.0 * (o.x * d.x + o.z * d.z),
        b * b + 2.0 * c - four * (d.x * d.x + d.z * d.z),
        2.0 * b,
        1.0,
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
        let rho = p.x.hypot(p.z) - self.major;
        rho * rho + p.y * p.y <= self.minor * self.minor
    }

    fn normal(&self, p: Vec3, _hit: &LocalHit) -> Vec3 {
        let rho = p.x.hypot(p.z);
        let away = if rho < raggio_math::EPS {
            p
        } else {
            let k = 1.0 - self.major / rho;
            Vec3::new(p.x * k, p.y, p.z * k)
        };
        away.try_normalize().unwrap_or(Vec3::Y)
    }

    fn uv(&self, p: Vec3, _hit: &LocalHit) -> Option<Vec2> {
        let rho = p.x.hypot(p.z);
        Some(Vec2::new(1.0 - share(p.z, p.x), share(p.y, rho - self.major)))
    }
}
