//! A ray: an origin and a direction, in whatever space the caller names.
use crate::{Affine, Vec3};

/// A half-line. `dir` is of unit length in world space; in a shape's own space it may have any length, so that
/// `t` means the same distance in both.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Ray {
    /// Where the ray starts.
    pub origin: Vec3,
    /// Where it goes.
    pub dir: Vec3,
}

impl Ray {
    /// A ray from `origin` along `dir`.
    #[inline]
    pub fn new(origin: Vec3, dir: Vec3) -> Self {
        Ray { origin, dir }
    }

    /// The point at parameter `t`.
    #[inline]
    pub fn at(&self, t: f64) -> Vec3 {
        self.origin + self.dir * t
    }

    /// The same ray seen from another space. The direction is not renormalised, so `t` keeps its meaning.
    #[inline]
    pub fn transformed(&self, to_from_here: &Affine) -> Ray {
        Ray {
            origin: to_from_here.transform_point3(self.origin),
            dir: to_from_here.transform_vector3(self.dir),
        }
    }
}
