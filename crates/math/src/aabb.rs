//! Axis-aligned boxes.
use crate::{Affine, Ray, Vec3};

/// An axis-aligned box; empty when `min > max` on an axis, unbounded when a side is infinite.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Aabb {
    /// The least corner.
    pub min: Vec3,
    /// The greatest corner.
    pub max: Vec3,
}

impl Aabb {
    /// The box that holds nothing; the neutral element of [`Aabb::union`].
    pub const EMPTY: Aabb = Aabb { min: Vec3::splat(f64::INFINITY), max: Vec3::splat(f64::NEG_INFINITY) };
    /// All of space; the neutral element of [`Aabb::intersection`].
    pub const INFINITE: Aabb = Aabb { min: Vec3::splat(f64::NEG_INFINITY), max: Vec3::splat(f64::INFINITY) };

    /// The box between two corners given in any order.
    pub fn new(a: Vec3, b: Vec3) -> Self {
        Aabb { min: a.min(b), max: a.max(b) }
    }

    /// The smallest box around some points.
    pub fn around(points: impl IntoIterator<Item = Vec3>) -> Self {
        points.into_iter().fold(Aabb::EMPTY, |b, p| Aabb { min: b.min.min(p), max: b.max.max(p) })
    }

    /// The smallest box around both.
    pub fn union(&self, other: &Aabb) -> Aabb {
        Aabb { min: self.min.min(other.min), max: self.max.max(other.max) }
    }

    /// What both have in common; may be empty.
    pub fn intersection(&self, other: &Aabb) -> Aabb {
        Aabb { min: self.min.max(other.min), max: self.max.min(other.max) }
    }

    /// Does the box hold no point at all?
    pub fn is_empty(&self) -> bool {
        !(self.min.x <= self.max.x && self.min.y <= self.max.y && self.min.z <= self.max.z)
    }

    /// Are all six sides finite?
    pub fn is_finite(&self) -> bool {
        self.min.is_finite() && self.max.is_finite()
    }

    /// Is the point inside or on the border?
    #[inline]
    pub fn contains(&self, p: Vec3) -> bool {
        p.cmpge(self.min).all() && p.cmple(self.max).all()
    }

    /// The box grown by `d` on every side.
    pub fn grown(&self, d: f64) -> Aabb {
        Aabb { min: self.min - Vec3::splat(d), max: self.max + Vec3::splat(d) }
    }

    /// The middle.
    pub fn centre(&self) -> Vec3 {
        (self.min + self.max) * 0.5
    }

    /// The edge lengths.
    pub fn size(&self) -> Vec3 {
        self.max - self.min
    }

    /// Half the surface area, the measure of the surface area heuristic.
    pub fn half_area(&self) -> f64 {
        let s = self.size();
        s.x * s.y + s.y * s.z + s.z * s.x
    }

    /// The box around the transformed box. An infinite box stays infinite.
    pub fn transformed(&self, to_from_here: &Affine) -> Aabb {
        if self.is_empty() {
            return Aabb::EMPTY;
        }
        if !self.is_finite() {
            return Aabb::INFINITE;
        }
        let corner = |i: u32| {
            let pick = |bit: u32, lo: f64, hi: f64| if i & bit == 0 { lo } else { hi };
            Vec3::new(
                pick(1, self.min.x, self.max.x),
                pick(2, self.min.y, self.max.y),
                pick(4, self.min.z, self.max.z),
            )
        };
        Aabb::around((0..8).map(|i| to_from_here.transform_point3(corner(i))))
    }

    /// The parameters at which the ray enters and leaves, or `None` where it misses. Entry may be negative.
    #[inline]
    pub fn hit(&self, ray: &Ray) -> Option<(f64, f64)> {
        self.hit_by(ray, ray.dir.recip())
    }

    /// The same for a ray whose direction's inverse is known.
    #[inline(always)]
    pub fn hit_by(&self, ray: &Ray, inverse: Vec3) -> Option<(f64, f64)> {
        let (mut near, mut far) = (f64::NEG_INFINITY, f64::INFINITY);
        // Along a slab's planes the distances are infinite, or in a plane not a number, which no comparison is true of.
        let mut slab = |min: f64, max: f64, origin: f64, inverse: f64| {
            let (a, b) = ((min - origin) * inverse, (max - origin) * inverse);
            // One instruction each, which `f64::min` and `f64::max` are not.
            let (first, last) = if inverse > 0.0 { (a, b) } else { (b, a) };
            near = if first > near { first } else { near };
            far = if last < far { last } else { far };
        };
        slab(self.min.x, self.max.x, ray.origin.x, inverse.x);
        slab(self.min.y, self.max.y, ray.origin.y, inverse.y);
        slab(self.min.z, self.max.z, ray.origin.z, inverse.z);
        (near <= far && near < f64::INFINITY && far > f64::NEG_INFINITY).then_some((near, far))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_ray_along_a_face_still_hits() {
        let b = Aabb::new(Vec3::ZERO, Vec3::ONE);
        assert_eq!(b.hit(&Ray::new(Vec3::new(-1.0, 1.0, 0.5), Vec3::X)), Some((1.0, 2.0)));
        assert_eq!(b.hit(&Ray::new(Vec3::new(-1.0, 1.1, 0.5), Vec3::X)), None);
    }

    #[test]
    fn transforming_keeps_every_corner_inside() {
        let t = crate::transform::rotate(Vec3::new(30.0, 40.0, 50.0));
        let b = Aabb::new(Vec3::splat(-1.0), Vec3::splat(1.0)).transformed(&t);
        assert!(b.contains(t.transform_point3(Vec3::new(1.0, -1.0, 1.0))));
        assert!(Aabb::EMPTY.transformed(&t).is_empty());
    }
}
