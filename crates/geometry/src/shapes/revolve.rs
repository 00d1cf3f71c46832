//! What the shapes around the y axis have in common.
use raggio_math::{Aabb, Ray, Vec3, poly};

/// The part of `range` in which the ray is in the cylinder `y_range` by `radius` about the y axis.
pub(crate) fn clip_to_barrel(
    ray: &Ray,
    y_range: (f64, f64),
    radius: f64,
    range: (f64, f64),
) -> Option<(f64, f64)> {
    let (mut lo, mut hi) = clip_to_slab(ray.origin.y, ray.dir.y, y_range, range)?;
    let [c, b, a] = radius_squared(ray);
    let c = c - radius * radius;
    if a > 0.0 {
        let roots = poly::quadratic([c, b, a]);
        let (first, last) = (roots.first()?, roots.last()?);
        (lo, hi) = (lo.max(*first), hi.min(*last));
    } else if c > 0.0 {
        return None;
    }
    (lo <= hi && lo.is_finite() && hi.is_finite()).then_some((lo, hi))
}

/// The part of `range` in which `o + t d` lies in the slab.
pub(crate) fn clip_to_slab(o: f64, d: f64, slab: (f64, f64), range: (f64, f64)) -> Option<(f64, f64)> {
    if d == 0.0 {
        return (slab.0 <= o && o <= slab.1).then_some(range);
    }
    let (a, b) = ((slab.0 - o) / d, (slab.1 - o) / d);
    let (lo, hi) = (range.0.max(a.min(b)), range.1.min(a.max(b)));
    (lo <= hi).then_some((lo, hi))
}

/// `x^2 + z^2` along the ray, coefficients rising.
pub(crate) fn radius_squared(ray: &Ray) -> [f64; 3] {
    let (o, d) = (ray.origin, ray.dir);
    [o.x * o.x + o.z * o.z, 2.0 * (o.x * d.x + o.z * d.z), d.x * d.x + d.z * d.z]
}

/// The box around a barrel.
pub(crate) fn barrel_bounds(y_range: (f64, f64), radius: f64) -> Aabb {
    Aabb::new(Vec3::new(-radius, y_range.0, -radius), Vec3::new(radius, y_range.1, radius))
}
