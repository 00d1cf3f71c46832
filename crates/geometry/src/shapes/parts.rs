//! The parts inside one shape, for quick search: components of a blob, glyphs of a text, triangles of a patch.
use raggio_bvh::Bvh;
use raggio_math::{Aabb, Ray, Vec3};

use crate::index::{FEW, in_order, padded};
use crate::probe::BoxRay;

/// Rays that start farther away are not for the tree, whose boxes are in single precision.
const REACH: f64 = 1e30;

/// Boxes of parts; a part is an index.
pub(crate) struct Parts {
    /// Few parts are asked in a row, and the tree is empty.
    few: Vec<(Aabb, u32)>,
    bvh: Bvh,
    /// Parts too large for the tree, always visited.
    unbounded: Vec<u32>,
    bounds: Aabb,
}

impl Parts {
    /// A tree over the boxes of parts; those with empty boxes are left out.
    pub(crate) fn new(boxes: &[Aabb]) -> Self {
        let bounds = boxes.iter().filter(|b| !b.is_empty()).fold(Aabb::EMPTY, |sum, b| sum.union(b));
        if boxes.len() <= FEW {
            let numbered = boxes.iter().zip(0..).filter(|(b, _)| !b.is_empty());
            let few = numbered.map(|(b, part)| (padded(b), part)).collect();
            return Parts { few, bvh: Bvh::build(&[], 1).bvh, unbounded: Vec::new(), bounds };
        }
        let built = Bvh::build(boxes, 2);
        Parts { few: Vec::new(), bvh: built.bvh, unbounded: built.unbounded, bounds }
    }

    /// The box around everything.
    pub(crate) fn bounds(&self) -> Aabb {
        self.bounds
    }

    /// Calls `each` with the parts that the ray may hit within `range`, the near ones first as far as boxes tell. It
    /// answers with the distance beyond which nothing interests any more. Nothing behind the ray's origin is visited.
    #[inline]
    pub(crate) fn visit_ray(&self, ray: &Ray, range: (f64, f64), mut each: impl FnMut(usize) -> f64) {
        for &part in &self.unbounded {
            each(part as usize);
        }
        let sane = |v: Vec3| v.abs().max_element() < REACH && !v.is_nan();
        if !(sane(ray.origin) && sane(ray.dir)) {
            return;
        }
        if self.few.is_empty() {
            self.bvh.closest(ray, range, |part, _| Some(each(part as usize)));
            return;
        }
        let (mut order, mut far) = ([(0.0, 0); FEW], range.1);
        for &(t, part) in in_order(&self.few, &BoxRay::new(ray), (range.0.max(0.0), far), &mut order) {
            if t > far {
                break;
            }
            far = each(part as usize);
        }
    }

    /// Calls `each` with the parts whose boxes hold the point.
    #[inline]
    pub(crate) fn visit_point(&self, p: Vec3, mut each: impl FnMut(usize)) {
        for &part in &self.unbounded {
            each(part as usize);
        }
        for (_, part) in self.few.iter().filter(|(b, _)| b.contains(p)) {
            each(*part as usize);
        }
        self.bvh.containing(p, |part| {
            each(part as usize);
            false
        });
    }
}
