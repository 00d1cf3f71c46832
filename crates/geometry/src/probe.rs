//! A ray in the world, made ready once for all the boxes on its way.
use raggio_bvh::Slab;
use raggio_math::{Aabb, Ray, Vec3};

/// Inverse directions are kept finite, so that no product of zero and infinity can arise.
const MAX_INVERSE: f64 = 1e300;

/// A ray with what the tests of boxes need of it.
pub(crate) struct Probe<'r> {
    pub(crate) ray: &'r Ray,
    pub(crate) slab: Slab,
}

/// A ray with what tests of single boxes need of it.
pub(crate) struct BoxRay {
    origin: Vec3,
    inverse: Vec3,
}

impl<'r> Probe<'r> {
    /// Not inlined, as [`Slab::new`] is not; the slab is made where it stays.
    #[inline(never)]
    pub(crate) fn new(ray: &'r Ray) -> Self {
        Probe { ray, slab: Slab::new_here(ray) }
    }
}

impl BoxRay {
    #[inline]
    pub(crate) fn new(ray: &Ray) -> Self {
        let inverse = ray.dir.map(|d| (1.0 / d).clamp(-MAX_INVERSE, MAX_INVERSE));
        BoxRay { origin: ray.origin, inverse }
    }

    /// Where within the range the ray is first in the box.
    #[inline(always)]
    pub(crate) fn entry(&self, b: &Aabb, range: (f64, f64)) -> Option<f64> {
        let (mut near, mut far) = range;
        for k in 0..3 {
            let a = (b.min[k] - self.origin[k]) * self.inverse[k];
            let c = (b.max[k] - self.origin[k]) * self.inverse[k];
            let (enter, leave) = if self.inverse[k] < 0.0 { (c, a) } else { (a, c) };
            near = if enter > near { enter } else { near };
            far = if leave < far { leave } else { far };
        }
        (near <= far).then_some(near)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn boxes_are_entered_where_they_begin() {
        let b = Aabb::new(Vec3::new(1.0, -1.0, -1.0), Vec3::new(2.0, 1.0, 1.0));
        let entry = |o: Vec3, d: Vec3| BoxRay::new(&Ray::new(o, d)).entry(&b, (0.5, 10.0));
        assert_eq!(entry(Vec3::ZERO, Vec3::X), Some(1.0));
        assert_eq!(entry(Vec3::ZERO, -Vec3::X), None);
        assert_eq!(entry(Vec3::X * 1.5, Vec3::new(0.0, -0.0, -1.0)), Some(0.5));
        assert_eq!(entry(Vec3::Y * 1.5, Vec3::X), None);
        assert_eq!(entry(Vec3::X * -20.0, Vec3::X), None);
        assert_eq!(BoxRay::new(&Ray::new(Vec3::ZERO, Vec3::X)).entry(&Aabb::INFINITE, (0.5, 9.0)), Some(0.5));
    }
}
