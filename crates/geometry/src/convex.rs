//! The convex part of an intersection: planes, spheres and other convex bodies, which say at once where a ray can be
//! inside at all; and members that quickly tell that it nowhere is. Clips are as good as members.
use raggio_math::{Aabb, Affine, EPS, Ray, Vec3, transform};

use crate::body::{Body, Ready};
use crate::leaf::Leaves;
use crate::shapes::{Plane, ShapeKind, Stretch};
use crate::tree::{Node, NodeRef};

/// Room for rounding at both ends of a span, as a share of the distance and by itself.
const MARGIN: f64 = 1e-6;

/// Corners are looked for up to here; what reaches as far counts as unbounded.
const FAR: f64 = 1e7;

/// So many planes are looked at for corners.
const MOST_PLANES: usize = 8;

/// More holes than this are not asked.
const MOST_HOLES: usize = 6;

/// Planes, and other bodies, that a point must be inside of.
#[derive(Default)]
pub(crate) struct Convex {
    planes: Vec<Plane>,
    bodies: Vec<Body>,
    /// Bodies that a point must be outside of.
    holes: Vec<Body>,
    /// Leaves of no such form that may say that a ray is nowhere inside them.
    others: Vec<u32>,
}

impl Convex {
    /// Such members of an intersection and clips, if there are any.
    pub(crate) fn of(members: impl Iterator<Item = NodeRef>, leaves: &Leaves) -> Option<Self> {
        let mut convex = Convex::default();
        for node in members {
            let Node::Leaf(index) = node.node() else { continue };
            let inverted = leaves.leaves[index as usize].inverted;
            match Body::of(index, leaves) {
                Some(hole) if inverted => convex.holes.push(hole),
                None if inverted => {}
                Some(Body::Half(plane)) => convex.planes.push(plane),
                // The boxes of members say the same.
                Some(Body::Box(_) | Body::PlacedBox(..)) => {}
                None if leaves.shape(index).is_some_and(ShapeKind::tells_misses) => convex.others.push(index),
                None => {}
                Some(body) => convex.bodies.push(body),
            }
        }
        convex.holes.truncate(MOST_HOLES);
        let empty = convex.planes.is_empty() && convex.bodies.is_empty() && convex.others.is_empty();
        (!empty || !convex.holes.is_empty()).then_some(convex)
    }

    /// The part of a range in which the ray can be inside all of them, and a little more; `None` where it nowhere is.
    #[inline]
    pub(crate) fn span(&self, ray: &Ray, range: (f64, f64), leaves: &Leaves) -> Option<(f64, f64)> {
        let least = |a: f64, b: f64| if a < b { a } else { b };
        let most = |a: f64, b: f64| if a > b { a } else { b };
        let (mut enter, mut leave) = range;
        for plane in &self.planes {
            let (slope, depth) = plane.approach(ray);
            if slope > EPS {
                leave = least(depth / slope, leave);
            } else if slope < -EPS {
                enter = most(depth / slope, enter);
            }
        }
        let mut ready = Ready::new();
        for body in &self.bodies {
            let stretch = body.stretch(ray, &mut ready);
            if !stretch.beyond {
                (enter, leave) = (most(stretch.enter, enter), least(stretch.leave, leave));
            }
        }
        let margin = |t: f64| MARGIN * (1.0 + t.abs());
        let (from, to) = (enter - margin(enter), leave + margin(leave));
        // No order where the ray is nowhere inside a body.
        if from.is_nan() || to.is_nan() || from > to {
            return None;
        }
        let (mut from, mut to) = (most(from, range.0), least(to, range.1));
        for hole in &self.holes {
            let Stretch { enter, leave, beyond } = hole.stretch(ray, &mut ready);
            let (first, last) = (enter + margin(enter), leave - margin(leave));
            if !beyond && first < from {
                from = most(last, from);
            }
            if !beyond && last > to {
                to = least(first, to);
            }
            if from > to {
                return None;
            }
        }
        let misses = self.others.iter().any(|&leaf| leaves.plainly_misses(leaf, ray, (from, to)));
        (!misses).then_some((from, to))
    }

    /// Its planes in other coordinates.
    pub(crate) fn planes_in(&self, there_from_here: &Affine) -> Self {
        let moved = |plane: &Plane| {
            let (normal, distance) = plane.side();
            let n = transform::normal_by_inverse(&there_from_here.inverse(), normal).normalize_or(normal);
            Plane::new(n, n.dot(there_from_here.transform_point3(normal * distance)))
        };
        Convex { planes: self.planes.iter().map(moved).collect(), ..Convex::default() }
    }

    /// A box around what the planes leave of a box without bounds; a box that has bounds stays as it is.
    pub(crate) fn bounds_within(&self, within: &Aabb) -> Aabb {
        if within.is_finite() { *within } else { self.cut(within) }
    }

    /// A box around what the planes leave of a box, where some of them are at no right angle to an axis.
    pub(crate) fn slanted_bounds_within(&self, within: &Aabb) -> Aabb {
        let straight = |plane: &Plane| plane.side().0.abs().max_element() >= 1.0 - EPS;
        if self.planes.iter().all(straight) { *within } else { self.cut(within) }
    }

    fn cut(&self, within: &Aabb) -> Aabb {
        if self.planes.is_empty() || self.planes.len() > MOST_PLANES || within.is_empty() {
            return *within;
        }
        let far = Vec3::splat(FAR);
        let (min, max) = (within.min.max(-far), within.max.min(far));
        let mut sides: Vec<(Vec3, f64)> = self.planes.iter().map(Plane::side).collect();
        for (k, axis) in Vec3::AXES.into_iter().enumerate() {
            sides.extend([(axis, max[k]), (-axis, -min[k])]);
        }
        let held = Aabb::around(corners(&sides)).grown(MARGIN);
        if held.is_empty() {
            return *within;
        }
        // What reaches the far sides has no bounds there.
        let edge = Vec3::splat(FAR * (1.0 - MARGIN));
        Aabb {
            min: Vec3::select(held.min.cmplt(-edge), within.min, within.min.max(held.min)),
            max: Vec3::select(held.max.cmpgt(edge), within.max, within.max.min(held.max)),
        }
    }
}

/// The corners of what lies within some sides, each given by its normal and distance.
fn corners(sides: &[(Vec3, f64)]) -> Vec<Vec3> {
    let mut found = Vec::new();
    for (i, &(a, da)) in sides.iter().enumerate() {
        for (j, &(b, db)) in sides.iter().enumerate().skip(i + 1) {
            let edge = a.cross(b);
            for &(c, dc) in &sides[j + 1..] {
                let volume = edge.dot(c);
                if volume.abs() < 1e-9 {
                    continue;
                }
                let p = (b.cross(c) * da + c.cross(a) * db + edge * dc) / volume;
                let slack = |d: f64| MARGIN * (1.0 + d.abs().max(p.abs().max_element()));
                if sides.iter().all(|&(n, d)| n.dot(p) - d <= slack(d)) {
                    found.push(p);
                }
            }
        }
    }
    found
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::shapes::Sphere;

    fn convex(sides: &[(f64, f64, f64, f64)]) -> Convex {
        let plane = |&(x, y, z, d): &(f64, f64, f64, f64)| Plane::new(Vec3::new(x, y, z).normalize(), d);
        Convex { planes: sides.iter().map(plane).collect(), ..Convex::default() }
    }

    #[test]
    fn a_wedge_between_slanted_planes_has_a_box() {
        let wedge = convex(&[
            (0.0, 1.0, 0.0, -0.15),
            (0.0, -1.0, 0.0, 3.0),
            (0.0, 0.0, -1.0, 35.0),
            (-1.0, 0.0, 1.0, 0.0),
            (1.0, 0.0, 1.0, 0.0),
        ]);
        let b = wedge.bounds_within(&Aabb::INFINITE);
        assert!((b.min - Vec3::new(-35.0, -3.0, -35.0)).length() < 1e-3, "{b:?}");
        assert!((b.max - Vec3::new(35.0, -0.15, 0.0)).length() < 1e-3, "{b:?}");
        let open = convex(&[(0.0, 1.0, 0.0, 2.0), (1.0, 0.0, 1.0, 0.0)]).bounds_within(&Aabb::INFINITE);
        assert_eq!(open.min, Aabb::INFINITE.min);
        assert!((open.max.y - 2.0).abs() < 1e-3 && open.max.x.is_infinite(), "{open:?}");
    }

    #[test]
    fn spans_end_where_planes_and_spheres_do() {
        let mut both = convex(&[(0.0, 1.0, 0.0, 0.5)]);
        both.bodies.push(Body::Ball(Sphere::new(Vec3::ZERO, 1.0)));
        let up = Ray::new(Vec3::new(0.0, -3.0, 0.0), Vec3::Y);
        let span = |ray: &Ray, range| both.span(ray, range, &Leaves::default());
        let (from, to) = span(&up, (0.0, 10.0)).unwrap();
        assert!((from - 2.0).abs() < 1e-5 && (to - 3.5).abs() < 1e-5);
        assert!(span(&Ray::new(Vec3::new(2.0, -3.0, 0.0), Vec3::Y), (0.0, 10.0)).is_none());
        assert!(span(&Ray::new(Vec3::new(0.0, 3.0, 0.0), Vec3::Y), (0.0, 10.0)).is_none());
        assert!(span(&up, (4.0, 10.0)).is_none());
    }

    #[test]
    fn spans_leave_out_what_lies_in_holes() {
        let hole = |y: f64, radius: f64| Body::Ball(Sphere::new(Vec3::Y * y, radius));
        let span = |holes: Vec<Body>| {
            let all = Convex { bodies: vec![hole(0.0, 2.0)], holes, ..Convex::default() };
            all.span(&Ray::new(Vec3::Y * -3.0, Vec3::Y), (0.0, 10.0), &Leaves::default())
        };
        let is = |found: Option<(f64, f64)>, from: f64, to: f64| {
            found.is_some_and(|(a, b)| (a - from).abs() < 1e-4 && (b - to).abs() < 1e-4)
        };
        assert!(is(span(vec![]), 1.0, 5.0));
        assert!(is(span(vec![hole(0.0, 1.0)]), 1.0, 5.0));
        assert!(is(span(vec![hole(-2.0, 1.0)]), 2.0, 5.0));
        assert!(is(span(vec![hole(2.0, 1.0), hole(-2.0, 1.5)]), 2.5, 4.0));
        assert!(span(vec![hole(2.0, 2.5), hole(-2.0, 2.5)]).is_none());
    }
}
