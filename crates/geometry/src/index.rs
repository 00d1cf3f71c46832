//! Members of a group by their boxes: a short list, or a tree for the bounded ones and a list for the others.
use std::sync::Arc;

use raggio_bvh::{BoxRow, Built, Bvh, Region};
use raggio_math::{Aabb, Vec3};

use crate::probe::Probe;

/// Up to so many members are asked for in a row, without a tree.
pub(crate) const FEW: usize = BoxRow::MOST;

/// Boxes are padded by this share, and by this much, for what rounding does to points and distances.
const PADDING: f64 = 1e-7;

/// Ends a search: nothing can be nearer.
pub(crate) const ENOUGH: f64 = -1.0;

/// Where the surfaces of members (by number) are.
pub(crate) enum Index {
    Few(Box<BoxRow>),
    Many {
        bvh: Arc<Bvh>,
        /// Those without bounds; always asked.
        listed: Vec<u32>,
    },
}

/// Where a member is known to contain points, and where not.
#[derive(Clone, Copy)]
pub(crate) struct Decider {
    pub(crate) member: u32,
    /// Asking it is as quick as asking its boxes.
    pub(crate) quick: bool,
    /// Outside this box nothing is inside.
    pub(crate) inside: Aabb,
    /// Outside this box everything is inside.
    pub(crate) outside: Aabb,
}

/// Which members are to be asked about a point.
pub(crate) struct Deciders {
    /// Always asked.
    listed: Vec<Decider>,
    /// Asked where their boxes hold the point.
    tree: Option<Arc<Bvh>>,
}

/// A box grown by what rounding may do.
pub(crate) fn padded(b: &Aabb) -> Aabb {
    let pad = |v: Vec3| v.map(|x| if x.is_finite() { (1.0 + x.abs()) * PADDING } else { 0.0 });
    Aabb { min: b.min - pad(b.min), max: b.max + pad(b.max) }
}

/// A few boxes, padded.
pub(crate) fn row(boxes: &[Aabb]) -> BoxRow {
    BoxRow::new(&boxes.iter().map(padded).collect::<Vec<_>>())
}

fn tree(count: usize, boxes: impl Fn(usize) -> Aabb, leaf_size: usize) -> (Arc<Bvh>, Vec<u32>) {
    let Built { bvh, unbounded } = Bvh::build_by(count, boxes, leaf_size);
    (Arc::new(bvh), unbounded)
}

/// Finds so many members of a group: by where the surface of each is, and by where it alone decides about a point
/// (`decision`). `deciders` tells what is known of those that must always be asked, in the order in which they had best
/// be.
pub(crate) fn indices(
    count: usize,
    surface: impl Fn(usize) -> Aabb,
    decision: impl Fn(usize) -> Aabb,
    deciders: impl Fn(Vec<u32>) -> Vec<Decider>,
    leaf_size: usize,
) -> (Index, Deciders) {
    let known = |always: Vec<u32>| {
        let mut known = deciders(always);
        for d in &mut known {
            (d.inside, d.outside) = (padded(&d.inside), padded(&d.outside));
        }
        known
    };
    if count <= FEW {
        let all = (0..count as u32).collect();
        let surfaces: Vec<Aabb> = (0..count).map(surface).collect();
        return (Index::Few(Box::new(row(&surfaces))), Deciders { listed: known(all), tree: None });
    }
    let (bvh, listed) = tree(count, &surface, leaf_size);
    let (deciding, always) = match (0..count).all(|i| surface(i) == decision(i)) {
        true => (bvh.clone(), listed.clone()),
        false => tree(count, decision, leaf_size),
    };
    (Index::Many { bvh, listed }, Deciders { listed: known(always), tree: Some(deciding) })
}

impl Index {
    /// The same without some members, which are sorted.
    pub(crate) fn without(&self, members: &[u32]) -> Index {
        match self {
            Index::Few(row) => {
                let mut row = row.clone();
                members.iter().for_each(|&member| row.take_out(member as usize));
                Index::Few(row)
            }
            Index::Many { bvh, listed } => {
                let listed =
                    listed.iter().copied().filter(|member| members.binary_search(member).is_err()).collect();
                Index::Many { bvh: bvh.clone(), listed }
            }
        }
    }

    /// At most so many boxes around all members; `None` where one has no end.
    pub(crate) fn cover(&self, most: usize) -> Option<Vec<Aabb>> {
        let boxes = match self {
            Index::Few(row) => row.cover(),
            Index::Many { listed, .. } if !listed.is_empty() => return None,
            Index::Many { bvh, .. } => bvh.cover(most),
        };
        boxes.iter().all(Aabb::is_finite).then_some(boxes)
    }

    /// Visits members on the ray, near ones first as far as boxes tell; see [`Bvh::closest`]. The visitor is told the
    /// member, the distance beyond which nothing interests any more, and between where its box lies on the ray.
    #[inline]
    pub(crate) fn closest(
        &self,
        probe: &Probe,
        range: (f64, f64),
        mut visit: impl FnMut(u32, f64, (f64, f64)) -> Option<f64>,
    ) {
        let mut far = range.1;
        match self {
            Index::Few(row) => {
                let mut touched = row.touched(&probe.slab, range);
                while let Some(touch) = touched.next(far) {
                    let within = (touch.range.0.max(range.0), touch.range.1);
                    far = visit(touch.place as u32, far, within).unwrap_or(far);
                }
            }
            Index::Many { bvh, listed } => {
                for &member in listed {
                    far = visit(member, far, (range.0, far)).unwrap_or(far);
                    if far < 0.0 {
                        return;
                    }
                }
                bvh.closest_prepared(&probe.slab, (range.0, far), |member, far| {
                    visit(member, far, (range.0, far))
                });
            }
        }
    }

    /// Bits of the members on the ray, where they are few.
    #[inline]
    pub(crate) fn touched(&self, probe: &Probe, range: (f64, f64)) -> Option<u32> {
        match self {
            Index::Few(row) => Some(row.touched(&probe.slab, range).places()),
            Index::Many { .. } => None,
        }
    }

    /// Visits the members that may reach into a region, each with a box around it, until `visit` says that it has seen
    /// enough.
    pub(crate) fn within(&self, region: &Region, mut visit: impl FnMut(u32, &Aabb) -> bool) {
        match self {
            Index::Few(row) => {
                let mut enough = false;
                row.within(region, |member, b| enough = enough || visit(member, b));
            }
            Index::Many { bvh, listed } => {
                if !listed.iter().any(|&member| visit(member, &Aabb::INFINITE)) {
                    bvh.within(region, visit);
                }
            }
        }
    }

    /// The box around all members that lie beside a point. Those whose boxes have no end or hold the point are visited,
    /// each with a box around it.
    pub(crate) fn beside(&self, p: Vec3, mut around: impl FnMut(u32, &Aabb)) -> Aabb {
        match self {
            Index::Few(row) => row.beside(p, around),
            Index::Many { bvh, listed } => {
                listed.iter().for_each(|&member| around(member, &Aabb::INFINITE));
                bvh.beside(p, around)
            }
        }
    }

    /// Visits all members on the ray.
    pub(crate) fn all(&self, probe: &Probe, range: (f64, f64), mut visit: impl FnMut(u32)) {
        match self {
            Index::Few(row) => row.touched(&probe.slab, range).each(|member| visit(member as u32)),
            Index::Many { bvh, listed } => {
                listed.iter().for_each(|&member| visit(member));
                bvh.closest_prepared(&probe.slab, range, |member, _| {
                    visit(member);
                    None
                });
            }
        }
    }
}

impl Deciders {
    /// Visits members that may decide about the point until `visit` says yes; returns whether it has. `visit` is told
    /// the member and, where boxes already tell it, whether the member contains the point.
    #[inline]
    pub(crate) fn any(&self, p: Vec3, mut visit: impl FnMut(u32, Option<bool>) -> bool) -> bool {
        self.listed.iter().any(|d| visit(d.member, d.contains(p)))
            || self.tree.as_ref().is_some_and(|tree| tree.containing(p, |member| visit(member, None)))
    }
}

impl Decider {
    #[inline]
    fn contains(&self, p: Vec3) -> Option<bool> {
        if self.quick {
            return None;
        }
        if !self.inside.contains(p) {
            return Some(false);
        }
        (!self.outside.contains(p)).then_some(true)
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
            // Zero times infinity counts as nothing, and so does what rounding has left of a zero.
            if column[k].abs() > 1e-15 * column.length() {
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
