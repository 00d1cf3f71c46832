//! What the shapes around the y axis have in common.
use raggio_math::{Aabb, Ray, Vec3};

use super::plane_tree::Node;
use super::quadric::two_roots;

/// The part of `range` in which the ray is in the cylinder `y_range` by `radius` about the y axis.
pub(crate) fn clip_to_barrel(
    ray: &Ray,
    y_range: (f64, f64),
    radius: f64,
    range: (f64, f64),
) -> Option<(f64, f64)> {
    clip_to_cylinder(ray, radius, clip_to_slab(ray.origin.y, ray.dir.y, y_range, range)?)
}

/// The part of `range` in which the ray is in the endless cylinder about the y axis.
#[inline]
pub(crate) fn clip_to_cylinder(ray: &Ray, radius: f64, (mut lo, mut hi): (f64, f64)) -> Option<(f64, f64)> {
    let [c, b, a] = radius_squared(ray);
    let c = c - radius * radius;
    if a > 0.0 {
        let (first, last) = two_roots(a, 0.5 * b, c)?;
        (lo, hi) = (greater(lo, first), least(hi, last));
    } else if c > 0.0 {
        return None;
    }
    (lo <= hi && lo.is_finite() && hi.is_finite()).then_some((lo, hi))
}

/// The part of `range` in which `o + t d` lies in the slab.
#[inline]
pub(crate) fn clip_to_slab(o: f64, d: f64, slab: (f64, f64), range: (f64, f64)) -> Option<(f64, f64)> {
    if d == 0.0 {
        return (slab.0 <= o && o <= slab.1).then_some(range);
    }
    let (a, b) = ((slab.0 - o) / d, (slab.1 - o) / d);
    let (a, b) = if d < 0.0 { (b, a) } else { (a, b) };
    let (lo, hi) = (greater(a, range.0), least(b, range.1));
    (lo <= hi).then_some((lo, hi))
}

/// The distance from the axis. Not by way of `hypot`, which takes much longer and minds only what is as large as 1e150.
#[inline(always)]
pub(crate) fn radius(p: Vec3) -> f64 {
    (p.x * p.x + p.z * p.z).sqrt()
}

/// `x^2 + z^2` along the ray, coefficients rising.
#[inline(always)]
pub(crate) fn radius_squared(ray: &Ray) -> [f64; 3] {
    let (o, d) = (ray.origin, ray.dir);
    [o.x * o.x + o.z * o.z, 2.0 * (o.x * d.x + o.z * d.z), d.x * d.x + d.z * d.z]
}

/// The box around a barrel.
pub(crate) fn barrel_bounds(y_range: (f64, f64), radius: f64) -> Aabb {
    Aabb::new(Vec3::new(-radius, y_range.0, -radius), Vec3::new(radius, y_range.1, radius))
}

/// How far a circle about the axis reaches along a vector.
pub(crate) fn circle_reach(height: f64, radius: f64, along: Vec3) -> f64 {
    height * along.y + radius.abs() * along.x.hypot(along.z)
}

/// What is asked of a ray at every box of radius and height.
pub(crate) struct Sweep {
    oy: f64,
    /// One over its rise.
    pub(crate) per_y: f64,
    /// The ray's [`radius_squared`].
    pub(crate) radius2: [f64; 3],
    /// Where it is nearest to the axis.
    nearest: f64,
}

impl Sweep {
    pub(crate) fn new(ray: &Ray) -> Self {
        let radius2 = radius_squared(ray);
        // A ray along the axis keeps its radius.
        let nearest = if radius2[2] > 0.0 { -0.5 * radius2[1] / radius2[2] } else { 0.0 };
        // Finite, so that no product with zero is undefined.
        let per_y = (1.0 / ray.dir.y).clamp(-1e300, 1e300);
        Sweep { oy: ray.origin.y, per_y, radius2, nearest }
    }

    /// Does the ray pass by all that is turned from a box, for distances within `range`?
    #[inline(always)]
    pub(crate) fn passes(&self, node: &Node, range: (f64, f64)) -> bool {
        let (t0, t1) = ((node.min.y - self.oy) * self.per_y, (node.max.y - self.oy) * self.per_y);
        let (lo, hi) = (greater(least(t0, t1), range.0), least(greater(t0, t1), range.1));
        if lo > hi {
            return true;
        }
        let [c, b, a] = self.radius2;
        let radius2 = |t: f64| (a * t + b) * t + c;
        let inner = greater(greater(node.min.x, -node.max.x), 0.0);
        if greater(radius2(lo), radius2(hi)) < inner * inner {
            return true;
        }
        let outer = greater(node.max.x, -node.min.x);
        radius2(least(greater(self.nearest, lo), hi)) > outer * outer
    }
}

/// The smaller of two numbers; quicker than the library's, which looks for what is no number.
#[inline(always)]
fn least(a: f64, b: f64) -> f64 {
    if a < b { a } else { b }
}

/// The greater of two numbers.
#[inline(always)]
fn greater(a: f64, b: f64) -> f64 {
    if a > b { a } else { b }
}
