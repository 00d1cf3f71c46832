//! Members of a group by their boxes: a tree for the bounded ones, a list for the others.
use raggio_bvh::{Built, Bvh};
use raggio_math::{Aabb, Ray, Vec3};

/// Members (by number) with their boxes.
pub(crate) struct Index {
    bvh: Bvh,
    /// Those without bounds; always asked.
    listed: Vec<u32>,
}

impl Index {
    pub(crate) fn new(boxes: &[Aabb]) -> Self {
        // Members may be costly, so each has a box of its own until there are a great many.
        let leaf_size = if boxes.len() > 1024 { 2 } else { 1 };
        let Built { bvh, unbounded } = Bvh::build(boxes, leaf_size);
        Index { bvh, listed: unbounded }
    }

    /// Visits members on the ray, near ones first as far as boxes tell; see [`Bvh::closest`].
    #[inline]
    pub(crate) fn closest(
        &self,
        ray: &Ray,
        range: (f64, f64),
        mut visit: impl FnMut(u32, f64) -> Option<f64>,
    ) {
        let mut far = range.1;
        for &member in &self.listed {
            if let Some(t) = visit(member, far) {
                far = t;
            }
        }
        self.bvh.closest(ray, (range.0, far), visit);
    }

    /// Visits all members on the ray.
    pub(crate) fn all(&self, ray: &Ray, range: (f64, f64), mut visit: impl FnMut(u32)) {
        self.listed.iter().for_each(|&member| visit(member));
        self.bvh.all(ray, range, visit);
    }

    /// Visits members around the point until `visit` says yes; returns whether it has.
    pub(crate) fn any_around(&self, p: Vec3, mut visit: impl FnMut(u32) -> bool) -> bool {
        self.listed.iter().any(|&member| visit(member)) || self.bvh.containing(p, visit)
    }
}

/// The box around a transformed box; tighter than [`Aabb::transformed`] for boxes that are infinite along some axes.
pub(crate) fn transformed(b: &Aabb, to_from_here: &raggio_math::Affine) -> Aabb {
    if b.is_empty() {
        return Aabb::EMPTY;
    }
    let m = &to_from_here.matrix3;
    let (mut min, mut max) = (to_from_here.translation, to_from_here.translation);
    for (column, (lo, hi)) in [m.x_axis, m.y_axis, m.z_axis].iter().zip([
        (b.min.x, b.max.x),
        (b.min.y, b.max.y),
        (b.min.z, b.max.z),
    ]) {
        for k in 0..3 {
            // Zero times infinity counts as nothing.
            if column[k] != 0.0 {
                let (p, q) = (column[k] * lo, column[k] * hi);
                min[k] += p.min(q);
                max[k] += p.max(q);
            }
        }
    }
    Aabb { min, max }
}

#[cfg(test)]
mod tests {
    use super::*;
    use raggio_math::transform::{rotate, scale, translate};

    #[test]
    fn an_infinite_slab_keeps_its_finite_sides() {
        let inf = f64::INFINITY;
        let slab = Aabb { min: Vec3::new(-inf, -1.0, -inf), max: Vec3::new(inf, 1.0, inf) };
        let t = translate(Vec3::Y) * scale(Vec3::new(1.0, -2.0, 1.0));
        let moved = transformed(&slab, &t);
        assert_eq!((moved.min.y, moved.max.y), (-1.0, 3.0));
        assert_eq!(moved.max.x, inf);
        let turned = transformed(&slab, &rotate(Vec3::new(10.0, 20.0, 30.0)));
        assert_eq!(turned, Aabb::INFINITE);
    }

    #[test]
    fn a_finite_box_is_carried_as_by_its_corners() {
        let b = Aabb::new(Vec3::new(-1.0, 2.0, 0.5), Vec3::new(3.0, 4.0, 1.0));
        let t = rotate(Vec3::new(10.0, 20.0, 30.0)) * scale(Vec3::new(1.0, -2.0, 0.3));
        let (a, c) = (transformed(&b, &t), b.transformed(&t));
        assert!((a.min - c.min).length() < 1e-12 && (a.max - c.max).length() < 1e-12);
    }
}
