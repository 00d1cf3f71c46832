//! The parts inside one shape, for quick search: components of a blob, glyphs of a text, triangles of a patch.
use raggio_bvh::{BoxRow, Bvh, Slab};
use raggio_math::{Aabb, Ray, Vec3};

use crate::index::{FEW, padded, row};

/// Boxes of parts; a part is an index.
pub(crate) struct Parts {
    search: Search,
    /// Parts too large for the tree, always visited.
    unbounded: Vec<u32>,
    bounds: Aabb,
}

enum Search {
    /// Few parts, with their boxes once more for points.
    Few(Box<BoxRow>, Vec<Aabb>),
    Many(Bvh),
}

impl Parts {
    /// A tree over the boxes of parts; those with empty boxes are left out.
    pub(crate) fn new(boxes: &[Aabb]) -> Self {
        let bounds = boxes.iter().filter(|b| !b.is_empty()).fold(Aabb::EMPTY, |sum, b| sum.union(b));
        if boxes.len() <= FEW {
            let search = Search::Few(Box::new(row(boxes)), boxes.iter().map(padded).collect());
            return Parts { search, unbounded: Vec::new(), bounds };
        }
        let built = Bvh::build(boxes, 2);
        Parts { search: Search::Many(built.bvh), unbounded: built.unbounded, bounds }
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
        let slab = Slab::new(ray);
        match &self.search {
            Search::Few(row, _) => {
                let (mut touched, mut far) = (row.touched(&slab, range), range.1);
                while let Some(touch) = touched.next(far) {
                    far = each(touch.place);
                }
            }
            Search::Many(bvh) => {
                bvh.closest_prepared(&slab, range, |part, _| Some(each(part as usize)));
            }
        }
    }

    /// Calls `each` with the parts whose boxes hold the point.
    #[inline]
    pub(crate) fn visit_point(&self, p: Vec3, mut each: impl FnMut(usize)) {
        for &part in &self.unbounded {
            each(part as usize);
        }
        match &self.search {
            Search::Few(_, boxes) => {
                (0..boxes.len()).filter(|&part| boxes[part].contains(p)).for_each(each);
            }
            Search::Many(bvh) => {
                bvh.containing(p, |part| {
                    each(part as usize);
                    false
                });
            }
        }
    }
}
