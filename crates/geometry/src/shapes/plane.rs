//! The plane.
use raggio_math::{Aabb, EPS, Ray, Vec3};

use super::{Stretch, beyond, clearly_beyond, start_along};
use crate::{LocalHit, Surface};

/// The least distance a plane reports.
const LEAST: f64 = 1e-6;

/// A normal this near to an axis lies on it.
const STRAIGHT: f64 = 1e-15;

/// Points with `normal . p < distance` are inside; `normal` is of unit length.
#[derive(Clone, Copy)]
pub(crate) struct Plane {
    normal: Vec3,
    distance: f64,
}

impl Plane {
    pub(crate) fn new(normal: Vec3, distance: f64) -> Self {
        Plane { normal, distance }
    }

    /// The normal and the distance.
    pub(crate) fn side(&self) -> (Vec3, f64) {
        (self.normal, self.distance)
    }

    /// How fast the ray leaves the inside, and how deep inside it starts.
    #[inline(always)]
    pub(crate) fn approach(&self, ray: &Ray) -> (f64, f64) {
        (self.normal.dot(ray.dir), self.distance - self.normal.dot(ray.origin))
    }

    /// Where the ray is inside.
    #[inline(always)]
    pub(crate) fn stretch(&self, ray: &Ray) -> Stretch {
        let (slope, depth) = self.approach(ray);
        if slope.abs() < EPS {
            return if depth > 0.0 { Stretch::EVERYWHERE } else { Stretch::NOWHERE };
        }
        let (t, far) = (depth / slope, f64::INFINITY);
        Stretch::between(Some(if slope > 0.0 { (-far, t) } else { (t, far) }))
    }

    /// Are all points on one side?
    pub(crate) fn misses(&self, hull: &[Vec3; 8]) -> bool {
        clearly_beyond(start_along(hull, self.normal), self.distance)
            || clearly_beyond(start_along(hull, -self.normal), -self.distance)
    }
}

impl Plane {
    /// The share of a way from a point after which the plane is met; infinite where the way leads elsewhere.
    pub(crate) fn share_along(&self, from: Vec3, way: Vec3) -> f64 {
        let (height, slope) = (self.distance - self.normal.dot(from), self.normal.dot(way));
        let share = height / slope;
        if share >= 0.0 { share } else { f64::INFINITY }
    }
}

impl Surface for Plane {
    fn bounds(&self) -> Aabb {
        Aabb::INFINITE
    }

    /// A half space whose border stands across an axis has one finite side.
    fn inside_bounds(&self) -> Aabb {
        let mut half = Aabb::INFINITE;
        for k in 0..3 {
            // Turns leave some rounding in the other components, which shows less than the padding of boxes. The sign
            // of this one says which side is inside.
            let n = self.normal[k];
            if (self.normal - n.signum() * Vec3::AXES[k]).abs().max_element() < STRAIGHT {
                match n > 0.0 {
                    true => half.max[k] = self.distance,
                    false => half.min[k] = -self.distance,
                }
            }
        }
        half
    }

    fn hits(&self, ray: &Ray, range: (f64, f64), out: &mut Vec<LocalHit>) {
        out.extend(self.closest(ray, range));
    }

    #[inline]
    fn closest(&self, ray: &Ray, range: (f64, f64)) -> Option<LocalHit> {
        let (lo, hi) = beyond(range, LEAST);
        let slope = self.normal.dot(ray.dir);
        if slope.abs() < EPS {
            return None;
        }
        let t = (self.distance - self.normal.dot(ray.origin)) / slope;
        (t > lo && t < hi).then(|| LocalHit::at(t))
    }

    fn inside(&self, p: Vec3) -> bool {
        self.normal.dot(p) - self.distance < EPS
    }

    fn normal(&self, _: Vec3, _: &LocalHit) -> Vec3 {
        self.normal
    }
}
