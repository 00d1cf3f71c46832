//! What isosurfaces and parametric surfaces are contained by.
use raggio_math::{Aabb, Ray, Vec3, poly};
use raggio_scene::Container;

/// A side of a container: axis and direction of a box's face, or the sphere.
const SPHERE: u32 = 6;

/// The box around a container.
pub(crate) fn bounds(container: &Container) -> Aabb {
    match *container {
        Container::Box { min, max } => Aabb { min, max },
        Container::Sphere { center, radius } => Aabb { min: center, max: center }.grown(radius.abs()),
    }
}

/// Is the point within?
pub(crate) fn contains(container: &Container, p: Vec3) -> bool {
    match *container {
        Container::Box { min, max } => Aabb { min, max }.contains(p),
        Container::Sphere { center, radius } => (p - center).length_squared() <= radius * radius,
    }
}

/// Where the ray enters and leaves, whose direction's inverse is known; the entry may be negative.
#[inline(always)]
pub(crate) fn span(container: &Container, ray: &Ray, inverse: Vec3) -> Option<(f64, f64)> {
    match *container {
        Container::Box { min, max } => Aabb { min, max }.hit_by(ray, inverse),
        Container::Sphere { center, radius } => {
            let o = ray.origin - center;
            let c = [o.length_squared() - radius * radius, 2.0 * o.dot(ray.dir), ray.dir.length_squared()];
            match poly::quadratic(c)[..] {
                [a, b] => Some((a, b)),
                _ => None,
            }
        }
    }
}

/// Which side the point lies on, for [`wall_normal`].
pub(crate) fn wall(container: &Container, p: Vec3) -> u32 {
    let Container::Box { min, max } = *container else { return SPHERE };
    let away = |side: u32| {
        let axis = side as usize / 2;
        let face = if side.is_multiple_of(2) { min[axis] } else { max[axis] };
        (p[axis] - face).abs()
    };
    (0..6).min_by(|&a, &b| away(a).total_cmp(&away(b))).unwrap_or(0)
}

/// The outward normal of a side.
pub(crate) fn wall_normal(container: &Container, side: u32, p: Vec3) -> Vec3 {
    if let (Container::Sphere { center, .. }, _) = (*container, side) {
        return (p - center).normalize_or(Vec3::X);
    }
    let normal = Vec3::AXES[side as usize / 2 % 3];
    if side.is_multiple_of(2) { -normal } else { normal }
}
