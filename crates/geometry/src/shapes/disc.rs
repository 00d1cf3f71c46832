//! The disc.
use raggio_math::{Aabb, Affine, EPS, Ray, Vec3};

use super::beyond;
use crate::{LocalHit, Surface};

/// The least distance a disc reports.
const LEAST: f64 = 1e-6;

/// A flat ring; its inside is the whole half space behind.
#[derive(Clone, Copy)]
pub(crate) struct Disc {
    center: Vec3,
    normal: Vec3,
    radius: f64,
    hole: f64,
}

impl Disc {
    pub(crate) fn new(center: Vec3, normal: Vec3, radius: f64, hole: f64) -> Self {
        Disc { center, normal, radius, hole }
    }

    /// The same in other coordinates, in which all lengths are multiplied.
    pub(crate) fn moved(&self, there_from_here: &Affine, scale: f64) -> Self {
        Disc {
            center: there_from_here.transform_point3(self.center),
            normal: there_from_here.transform_vector3(self.normal).normalize_or(self.normal),
            radius: self.radius * scale,
            hole: self.hole * scale,
        }
    }
}

impl Surface for Disc {
    fn bounds(&self) -> Aabb {
        let e = (Vec3::ONE - self.normal * self.normal).max(Vec3::ZERO).map(f64::sqrt) * self.radius.abs();
        Aabb { min: self.center - e, max: self.center + e }
    }

    fn reach(&self, along: Vec3) -> Option<f64> {
        let within = along - self.normal * self.normal.dot(along);
        Some(self.center.dot(along) + self.radius.abs() * within.length())
    }

    fn inside_bounds(&self) -> Aabb {
        Aabb::INFINITE
    }

    fn hits(&self, ray: &Ray, range: (f64, f64), out: &mut Vec<LocalHit>) {
        out.extend(self.closest(ray, range));
    }

    fn closest(&self, ray: &Ray, range: (f64, f64)) -> Option<LocalHit> {
        let (lo, hi) = beyond(range, LEAST);
        let slope = self.normal.dot(ray.dir);
        if slope.abs() < EPS {
            return None;
        }
        let t = (self.center - ray.origin).dot(self.normal) / slope;
        let distance2 = (ray.at(t) - self.center).length_squared();
        let there = distance2 >= self.hole * self.hole && distance2 <= self.radius * self.radius;
        (t > lo && t < hi && there).then(|| LocalHit::at(t))
    }

    fn inside(&self, p: Vec3) -> bool {
        (p - self.center).dot(self.normal) < 0.0
    }

    fn normal(&self, _: Vec3, _: &LocalHit) -> Vec3 {
        self.normal
    }
}
