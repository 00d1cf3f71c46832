//! Convex regions of space, and which boxes reach into them.
use raggio_math::{Aabb, Vec3, Wide, wide};

use crate::node::{Kind, Node, WIDTH};
use crate::round::{down, up};
use crate::{BoxRow, Bvh};

/// What a plane may be off by, as a share of the numbers that go into it.
const ROUNDING: f64 = 1e-12;

/// A box cut by four half spaces.
#[derive(Clone, Copy, Debug)]
pub struct Region {
    /// The box.
    pub bounds: Aabb,
    /// The points with `normal . p <= distance` are within; a zero normal cuts nothing.
    pub planes: [(Vec3, f64); 4],
}

/// Which children of a node reach into a region: a bit each.
struct Reaching<'a> {
    region: &'a Region,
    limits: Limits,
    node: &'a Node,
}

/// The corners of a region's box, rounded outwards.
type Limits = ([f32; 3], [f32; 3]);

impl Wide for Reaching<'_> {
    type Output = u8;

    #[inline(always)]
    fn run(self) -> u8 {
        let (bounds, (min, max)) = (&self.node.bounds, self.limits);
        let mut outside = [false; WIDTH];
        for k in 0..3 {
            for i in 0..WIDTH {
                let (lo, hi) = (bounds[k][i], bounds[k + 3][i]);
                // A place without a box reaches nowhere, not even into all of space.
                outside[i] |= !((lo <= hi) & (lo <= max[k]) & (min[k] <= hi));
            }
        }
        for &(normal, distance) in &self.region.planes {
            // The boxes' corners that are deepest within.
            let [x, y, z] = [0, 1, 2].map(|k| if normal[k] > 0.0 { &bounds[k] } else { &bounds[k + 3] });
            for i in 0..WIDTH {
                let (x, y, z) =
                    (normal.x * f64::from(x[i]), normal.y * f64::from(y[i]), normal.z * f64::from(z[i]));
                let slack = (x.abs() + y.abs() + z.abs() + distance.abs()) * ROUNDING;
                outside[i] |= x + y + z - distance > slack;
            }
        }
        outside.iter().enumerate().fold(0, |reaching, (i, &out)| reaching | u8::from(!out) << i)
    }
}

impl Region {
    /// Visits the children of a node that reach into the region.
    #[inline]
    fn children(&self, limits: Limits, node: &Node, mut visit: impl FnMut(usize, &Aabb)) {
        let mut reaching = wide(Reaching { region: self, limits, node });
        while reaching != 0 {
            let i = reaching.trailing_zeros() as usize;
            reaching &= reaching - 1;
            visit(i, &node.child_box(i));
        }
    }

    fn limits(&self) -> Limits {
        (self.bounds.min.to_array().map(down), self.bounds.max.to_array().map(up))
    }
}

impl BoxRow {
    /// Visits the boxes, by their places, that reach into a region.
    pub fn within(&self, region: &Region, mut visit: impl FnMut(u32, &Aabb)) {
        region.children(region.limits(), &self.node, |i, b| visit(i as u32, b));
    }

    /// The box around all boxes that lie beside a point; see [`Bvh::beside`].
    pub fn beside(&self, p: Vec3, mut around: impl FnMut(u32, &Aabb)) -> Aabb {
        let mut all = Aabb::EMPTY;
        for (i, b) in self.node.children() {
            match is_beside(&b, p) {
                true => all = all.union(&b),
                false => around(i as u32, &b),
            }
        }
        all
    }
}

/// Is a box finite, and does it not hold a point?
fn is_beside(b: &Aabb, p: Vec3) -> bool {
    b.is_finite() && !b.contains(p)
}

impl Bvh {
    /// Visits the primitives whose boxes reach into a region, each with a box around it, until `visit` says that it has
    /// seen enough.
    pub fn within(&self, region: &Region, mut visit: impl FnMut(u32, &Aabb) -> bool) {
        let limits = region.limits();
        let mut stack: smallvec::SmallVec<[u32; 64]> = smallvec::SmallVec::new();
        let mut enough = false;
        if !self.nodes.is_empty() {
            stack.push(0);
        }
        while let (Some(index), false) = (stack.pop(), enough) {
            let node = &self.nodes[index as usize];
            region.children(limits, node, |i, b| match node.child(i).kind() {
                Kind::Inner(inner) => stack.push(inner as u32),
                Kind::Leaf(run) => {
                    enough = enough || self.prims[run].iter().any(|&prim| visit(prim, b));
                }
            });
        }
    }

    /// The box around all primitives that lie beside a point. Those whose boxes have no end or hold the point are
    /// visited, each with a box around it. Nodes beside the point are not looked into.
    pub fn beside(&self, p: Vec3, mut around: impl FnMut(u32, &Aabb)) -> Aabb {
        let mut all = Aabb::EMPTY;
        let mut stack: smallvec::SmallVec<[u32; 64]> = smallvec::SmallVec::new();
        if !self.nodes.is_empty() {
            stack.push(0);
        }
        while let Some(index) = stack.pop() {
            let node = &self.nodes[index as usize];
            for (i, b) in node.children() {
                match node.child(i).kind() {
                    _ if is_beside(&b, p) => all = all.union(&b),
                    Kind::Inner(inner) => stack.push(inner as u32),
                    Kind::Leaf(run) => self.prims[run].iter().for_each(|&prim| around(prim, &b)),
                }
            }
        }
        all
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn boxes_beyond_a_side_or_a_plane_are_left_out() {
        let slope = (Vec3::new(1.0, 1.0, 0.0), 4.0);
        let region = Region {
            bounds: Aabb::new(Vec3::ZERO, Vec3::splat(4.0)),
            planes: [slope, (Vec3::ZERO, 0.0), (Vec3::ZERO, 0.0), (Vec3::ZERO, 0.0)],
        };
        let at = |x: f64, y: f64| Aabb::new(Vec3::new(x, y, 1.0), Vec3::new(x + 0.5, y + 0.5, 2.0));
        let mut half = Aabb::INFINITE;
        half.min.y = 3.0;
        let boxes = [at(1.0, 1.0), at(3.0, 3.0), at(2.0, 2.0), at(5.0, 0.0), Aabb::EMPTY, half];
        let mut few = Vec::new();
        BoxRow::new(&boxes).within(&region, |i, _| few.push(i));
        assert_eq!(few, [0, 2, 5]);
        few.clear();
        let all = Region { bounds: Aabb::INFINITE, planes: [(Vec3::ZERO, 0.0); 4] };
        BoxRow::new(&boxes).within(&all, |i, _| few.push(i));
        assert_eq!(few, [0, 1, 2, 3, 5]);
        let many: Vec<Aabb> =
            (0..400).map(|i| at(f64::from(i % 20) * 0.3, f64::from(i / 20) * 0.3)).collect();
        let mut found = Vec::new();
        Bvh::build(&many, 1).bvh.within(&region, |i, _| {
            found.push(i);
            false
        });
        found.sort_unstable();
        let expected: Vec<u32> =
            (0..400).filter(|&i| many[i as usize].min.x + many[i as usize].min.y <= 4.0 + 1e-6).collect();
        let within = expected.iter().filter(|&&i| many[i as usize].min.max_element() <= 4.0).count();
        assert!(found.iter().all(|i| expected.contains(i)) && found.len() == within, "{}", found.len());
    }

    #[test]
    fn boxes_around_a_point_are_told_from_those_beside_it() {
        let cube = |x: f64, y: f64, half: f64| {
            let c = Vec3::new(x, y, 0.0);
            Aabb::new(c - Vec3::splat(half), c + Vec3::splat(half))
        };
        let p = Vec3::new(7.0, 9.0, 0.25);
        let mut boxes: Vec<Aabb> =
            (0..300).map(|i| cube(f64::from(i % 20), f64::from(i / 20), 0.4)).collect();
        boxes.extend([cube(0.0, 0.0, 50.0), cube(3.0, 3.0, 6.5), Aabb::EMPTY]);
        let around: Vec<u32> = (0..302).filter(|&i| boxes[i as usize].contains(p)).collect();
        assert_eq!(around, [187, 300, 301]);
        let (mut found, built) = (Vec::new(), Bvh::build(&boxes, 1));
        let all = built.bvh.beside(p, |i, b| {
            assert!(b.contains(p));
            found.push(i);
        });
        found.sort_unstable();
        assert_eq!(found, around);
        assert!((all.min - cube(0.0, 0.0, 0.4).min).length() < 1e-5);
        assert!((all.max - cube(19.0, 14.0, 0.4).max).length() < 1e-5);
        let mut half = Aabb::INFINITE;
        half.max.x = -2.0;
        let mut few = Vec::new();
        let row = BoxRow::new(&[cube(1.0, 1.0, 1.0), half, Aabb::EMPTY, cube(7.0, 9.0, 1.0)]);
        let beside = row.beside(p, |i, _| few.push(i));
        assert_eq!((few, beside), (vec![1, 3], cube(1.0, 1.0, 1.0)));
    }
}
