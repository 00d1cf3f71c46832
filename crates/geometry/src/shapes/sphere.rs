//! The sphere, and its form in the world for uniformly scaled placements.
use raggio_math::{Aabb, EPS, Ray, Vec2, Vec3};

use super::{Few, Stretch, beyond, clearly_beyond, start_along, turn};
use crate::{LocalHit, Surface};

/// The least distance a sphere reports.
const LEAST: f64 = 1e-6;

/// `sphere { center, radius }`; a negative radius turns the normal inwards.
#[derive(Clone, Copy)]
pub(crate) struct Sphere {
    center: Vec3,
    radius: f64,
}

impl Sphere {
    pub(crate) fn new(center: Vec3, radius: f64) -> Self {
        Sphere { center, radius }
    }

    /// The centre and the radius.
    pub(crate) fn place(&self) -> (Vec3, f64) {
        (self.center, self.radius)
    }

    /// -1 for a negative radius.
    pub(crate) fn sign(&self) -> f64 {
        self.radius.signum()
    }

    /// Texture coordinates in a direction from the centre: longitude and latitude.
    pub(crate) fn uv_of(offset: Vec3) -> Vec2 {
        let q = offset.normalize_or_zero();
        Vec2::new(turn(q.x, q.z), 0.5 + q.y.clamp(-1.0, 1.0).asin() / std::f64::consts::PI)
    }

    /// The parameters of entry and exit, if the chord is long enough to count.
    #[inline(always)]
    pub(crate) fn chord(&self, ray: &Ray) -> Option<(f64, f64)> {
        let to_center = self.center - ray.origin;
        let middle = to_center.dot(ray.dir);
        // Distance of the centre from the line by rejection: no cancellation for far origins.
        let offset2 = (to_center - ray.dir * middle).length_squared();
        let half2 = self.radius * self.radius - offset2;
        if half2 > EPS {
            let half = half2.sqrt();
            return Some((middle - half, middle + half));
        }
        None
    }

    /// Where the ray is inside.
    #[inline(always)]
    pub(crate) fn stretch(&self, ray: &Ray) -> Stretch {
        Stretch::between(self.chord(ray))
    }

    /// Are all points beyond a tangent plane, or inside?
    pub(crate) fn misses(&self, hull: &[Vec3; 8]) -> bool {
        let radius = self.radius.abs();
        let Some(direction) = (hull[0] - self.center).try_normalize() else { return false };
        let within = |p: &Vec3| clearly_beyond(radius, (*p - self.center).length());
        clearly_beyond(start_along(hull, direction), radius + self.center.dot(direction))
            || hull.iter().all(within)
    }

    /// How far its surface is from a point inside; 0 for points outside.
    pub(crate) fn room_around(&self, p: Vec3) -> f64 {
        (self.radius.abs() - (p - self.center).length()).max(0.0)
    }

    /// Both hits, as far as they are in the range.
    #[inline]
    pub(crate) fn few(&self, ray: &Ray, range: (f64, f64), out: &mut Few) {
        let range = beyond(range, LEAST);
        if let Some((a, b)) = self.chord(ray) {
            out.push(a, 0, range);
            out.push(b, 0, range);
        }
    }
}

impl Surface for Sphere {
    fn bounds(&self) -> Aabb {
        Aabb { min: self.center, max: self.center }.grown(self.radius.abs())
    }

    fn reach(&self, along: Vec3) -> Option<f64> {
        Some(self.center.dot(along) + self.radius.abs() * along.length())
    }

    fn hits(&self, ray: &Ray, range: (f64, f64), out: &mut Vec<LocalHit>) {
        let mut few = Few::default();
        self.few(ray, range, &mut few);
        few.into_hits(out);
    }

    #[inline]
    fn closest(&self, ray: &Ray, range: (f64, f64)) -> Option<LocalHit> {
        let (lo, hi) = beyond(range, LEAST);
        let (a, b) = self.chord(ray)?;
        let t = if a > lo { a } else { b };
        (t > lo && t < hi).then(|| LocalHit::at(t))
    }

    fn inside(&self, p: Vec3) -> bool {
        (p - self.center).length_squared() < self.radius * self.radius
    }

    fn normal(&self, p: Vec3, _: &LocalHit) -> Vec3 {
        (p - self.center) / self.radius
    }

    fn uv(&self, p: Vec3, _: &LocalHit) -> Option<Vec2> {
        Some(Sphere::uv_of(p - self.center))
    }
}
