//! Shadow rays from one point, eight at a time, against what simple things stand in their way: spheres, planes, boxes,
//! and intersections of these.
//!
//! A ray is told to be stopped or to be free only where that is clear of all rounding; about the others nothing is said,
//! and they are to be asked one by one.
use raggio_math::{Affine, EPS, Vec3, Wide, wide};
use smallvec::SmallVec;

use crate::leaf::Prim;
use crate::shapes::{Cuboid, Plane, Sphere};
use crate::standing::Standing;
use crate::tree::{Node, NodeRef, Op, Tree};
use crate::{Geometry, RayClass};

/// Rays that are looked at together.
pub const RAYS: usize = 8;

/// A number for each ray.
pub type Lanes = [f64; RAYS];

/// The most shapes in front of a light that are looked at, and of those the most in one solid.
const MOST: usize = 12;
const MOST_PARTS: usize = 4;

/// What rounding may do, as a share of the numbers that enter a comparison.
const MARGIN: f64 = 1e-9;

/// Simple things that may stand in the way of rays from a point.
#[derive(Default)]
pub struct Screen {
    parts: SmallVec<[Part; 4]>,
    /// Where the parts of each solid end. What all parts of a solid contain is the solid.
    ends: SmallVec<[usize; 4]>,
    /// Is this all that may stand there?
    complete: bool,
    /// Room for how rays meet the parts of one solid.
    meetings: [Meeting; MOST_PARTS],
}

/// What is known about eight rays, a bit each.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Verdict {
    /// Something stops them.
    pub stopped: u8,
    /// Nothing stands in their way.
    pub free: u8,
}

/// A part of a solid in coordinates about the point, with the room that comparisons leave for rounding.
#[derive(Clone, Copy)]
struct Part {
    kind: Kind,
    slack: f64,
    /// Does its outside belong to the solid instead?
    inverted: bool,
}

#[derive(Clone, Copy)]
enum Kind {
    Ball {
        center: Vec3,
        radius2: f64,
    },
    Half {
        normal: Vec3,
        depth: f64,
    },
    /// A box in coordinates of its own, which differ by a linear map.
    Slabs {
        rows: [Vec3; 3],
        low: Vec3,
        high: Vec3,
    },
}

/// Rays from the point.
struct Rays {
    dir: [Lanes; 3],
    /// Nothing beyond counts.
    far: Lanes,
    /// One over what rounding may do to distances.
    slack: Lanes,
}

/// Rays and a part: their directions in its coordinates, and where they cross it: twice, and by how much they do so, in
/// units of what rounding may do.
#[derive(Default)]
struct Meeting {
    dir: [Lanes; 3],
    t: [Lanes; 2],
    clear: [Lanes; 2],
}

impl Geometry {
    /// What simple things of those standing in front of a light can be asked for many rays at once, put into `screen`;
    /// false where that is not worth it. `stops` says whether a leaf lets no light through.
    pub fn screen(
        &self,
        standing: &Standing,
        p: Vec3,
        stops: impl Fn(u32) -> bool,
        screen: &mut Screen,
    ) -> bool {
        let Standing::Listed(list) = standing else { return false };
        screen.parts.clear();
        screen.ends.clear();
        screen.complete = true;
        for &member in list.members() {
            let known = screen.parts.len();
            if !self.tree.add_solid(self.world.members[member as usize].node, p, &stops, screen) {
                screen.parts.truncate(known);
                screen.complete = false;
                continue;
            }
            screen.ends.push(screen.parts.len());
        }
        !screen.ends.is_empty()
    }
}

impl Tree {
    /// Adds the parts of a solid; false where it is not simple.
    fn add_solid(&self, node: NodeRef, p: Vec3, stops: &impl Fn(u32) -> bool, screen: &mut Screen) -> bool {
        match node.node() {
            Node::Leaf(leaf) => self.add_part(leaf, false, p, stops, screen),
            Node::Group(group) => {
                let group = &self.groups[group as usize];
                group.op == Op::Intersection
                    && group.members.len() <= MOST_PARTS
                    && group.clips.is_empty()
                    && group.bounds.is_empty()
                    && group.members.iter().all(|member| match member.node.node() {
                        Node::Leaf(leaf) if member.skip & RayClass::Shadow.bit() == 0 => {
                            self.add_part(leaf, self.leaves.leaves[leaf as usize].inverted, p, stops, screen)
                        }
                        _ => false,
                    })
            }
        }
    }

    fn add_part(
        &self,
        leaf: u32,
        inverted: bool,
        p: Vec3,
        stops: &impl Fn(u32) -> bool,
        screen: &mut Screen,
    ) -> bool {
        if screen.parts.len() == MOST || !stops(leaf) {
            return false;
        }
        let (kind, scale) = match &self.leaves.leaves[leaf as usize].prim {
            Prim::Sphere { sphere, .. } => Kind::ball(sphere, p),
            Prim::Plane(plane) => Kind::half(plane, p),
            Prim::Box(cuboid) => Kind::slabs(cuboid, &Affine::IDENTITY, p),
            Prim::PlacedBox { cuboid, place, .. } => {
                Kind::slabs(cuboid, &self.leaves.places[*place as usize], p)
            }
            _ => return false,
        };
        screen.parts.push(Part { kind, slack: 1.0 / (MARGIN * scale), inverted });
        true
    }
}

impl Kind {
    fn ball(sphere: &Sphere, p: Vec3) -> (Kind, f64) {
        let (center, radius) = sphere.place();
        let center = center - p;
        (Kind::Ball { center, radius2: radius * radius }, 1.0 + radius * radius + center.length_squared())
    }

    fn half(plane: &Plane, p: Vec3) -> (Kind, f64) {
        let (normal, distance) = plane.side();
        let to_origin = normal.dot(p);
        (Kind::Half { normal, depth: distance - to_origin }, 1.0 + distance.abs() + to_origin.abs())
    }

    fn slabs(cuboid: &Cuboid, object_from_world: &Affine, p: Vec3) -> (Kind, f64) {
        let (b, origin) = (cuboid.extent(), object_from_world.transform_point3(p));
        let m = &object_from_world.matrix3;
        let rows = [m.row(0), m.row(1), m.row(2)];
        let scale = 1.0 + origin.abs().max_element() + b.min.abs().max(b.max.abs()).max_element();
        (Kind::Slabs { rows, low: b.min - origin, high: b.max - origin }, scale)
    }
}

impl Screen {
    /// Looks at the rays towards eight places, given about the point; nothing nearer to either end than a distance
    /// counts.
    pub fn verdict(&mut self, targets: &[Lanes; 3], near: f64) -> Verdict {
        let mut verdict = wide(Look { screen: self, targets, near });
        if !self.complete {
            verdict.free = 0;
        }
        verdict
    }
}

struct Look<'a> {
    screen: &'a mut Screen,
    targets: &'a [Lanes; 3],
    near: f64,
}

impl Wide for Look<'_> {
    type Output = Verdict;

    #[inline(always)]
    fn run(self) -> Verdict {
        let rays = Rays::towards(self.targets, self.near);
        let Screen { parts, ends, meetings, .. } = self.screen;
        let mut most = [f64::NEG_INFINITY; RAYS];
        let mut start = 0;
        for &end in &*ends {
            let parts = &parts[start..end];
            start = end;
            for (part, meeting) in parts.iter().zip(&mut *meetings) {
                *meeting = part.meet(&rays);
            }
            for (i, meeting) in meetings[..parts.len()].iter().enumerate() {
                for (t, clear) in meeting.t.iter().zip(meeting.clear) {
                    let mut counts = clear;
                    rays.keep_within(t, self.near, &mut counts);
                    if counts.iter().all(|&c| c < -1.0) {
                        continue;
                    }
                    for (j, other) in parts.iter().enumerate() {
                        if i != j {
                            other.keep_inside(&meetings[j].dir, t, &mut counts);
                        }
                    }
                    most = each(|k| greater(most[k], counts[k]));
                }
            }
        }
        let mut verdict = Verdict::default();
        for (k, most) in most.into_iter().enumerate() {
            verdict.stopped |= u8::from(most > 1.0) << k;
            verdict.free |= u8::from(most < -1.0) << k;
        }
        verdict
    }
}

#[inline(always)]
fn each(f: impl Fn(usize) -> f64) -> Lanes {
    let mut lanes = [0.0; RAYS];
    for (k, lane) in lanes.iter_mut().enumerate() {
        *lane = f(k);
    }
    lanes
}

#[inline(always)]
fn lesser(a: f64, b: f64) -> f64 {
    if a < b { a } else { b }
}

#[inline(always)]
fn greater(a: f64, b: f64) -> f64 {
    if a > b { a } else { b }
}

impl Rays {
    #[inline(always)]
    fn towards(targets: &[Lanes; 3], near: f64) -> Rays {
        let [x, y, z] = targets;
        let distance = each(|k| (x[k] * x[k] + y[k] * y[k] + z[k] * z[k]).sqrt());
        let inverse = each(|k| 1.0 / distance[k]);
        Rays {
            dir: [each(|k| x[k] * inverse[k]), each(|k| y[k] * inverse[k]), each(|k| z[k] * inverse[k])],
            far: each(|k| distance[k] - near),
            slack: each(|k| 1.0 / (MARGIN * (1.0 + distance[k]))),
        }
    }

    /// The part of the directions along a vector.
    #[inline(always)]
    fn along(&self, v: Vec3) -> Lanes {
        each(|k| self.dir[0][k] * v.x + self.dir[1][k] * v.y + self.dir[2][k] * v.z)
    }

    /// Lowers numbers where distances are out of range. What is not a number lowers nothing, here and below: points at
    /// infinity are out of range.
    #[inline(always)]
    fn keep_within(&self, t: &Lanes, near: f64, counts: &mut Lanes) {
        for k in 0..RAYS {
            let inside = lesser(t[k] - near, self.far[k] - t[k]) * self.slack[k];
            counts[k] = lesser(inside, counts[k]);
        }
    }
}

impl Part {
    #[inline(always)]
    fn meet(&self, rays: &Rays) -> Meeting {
        let dir = match &self.kind {
            Kind::Slabs { rows, .. } => [rays.along(rows[0]), rays.along(rows[1]), rays.along(rows[2])],
            Kind::Half { normal, .. } => [rays.along(*normal), [0.0; RAYS], [0.0; RAYS]],
            Kind::Ball { .. } => rays.dir,
        };
        let (t, clear) = match &self.kind {
            Kind::Ball { center, radius2 } => {
                let middle = rays.along(*center);
                let half2 = each(|k| {
                    let x = center.x - dir[0][k] * middle[k];
                    let y = center.y - dir[1][k] * middle[k];
                    let z = center.z - dir[2][k] * middle[k];
                    radius2 - (x * x + y * y + z * z)
                });
                let half = each(|k| greater(half2[k], 0.0).sqrt());
                let clear = each(|k| (half2[k] - EPS) * self.slack);
                ([each(|k| middle[k] - half[k]), each(|k| middle[k] + half[k])], [clear; 2])
            }
            Kind::Half { depth, .. } => {
                let clear = each(|k| (dir[0][k].abs() - EPS) / (0.01 * EPS));
                ([each(|k| depth / dir[0][k]); 2], [clear, [f64::NEG_INFINITY; RAYS]])
            }
            Kind::Slabs { low, high, .. } => {
                let (mut entry, mut exit) = ([f64::NEG_INFINITY; RAYS], [f64::INFINITY; RAYS]);
                for i in 0..3 {
                    // Step by step, so that the compiler keeps eight together: it took the divisions one by one.
                    let inverse = each(|k| 1.0 / dir[i][k]);
                    let (a, b) = (each(|k| low[i] * inverse[k]), each(|k| high[i] * inverse[k]));
                    entry = each(|k| greater(lesser(a[k], b[k]), entry[k]));
                    exit = each(|k| lesser(greater(a[k], b[k]), exit[k]));
                }
                ([entry, exit], [each(|k| (exit[k] - entry[k]) * rays.slack[k]); 2])
            }
        };
        Meeting { dir, t, clear }
    }

    /// Lowers numbers where the points at some distances are outside.
    #[inline(always)]
    fn keep_inside(&self, dir: &[Lanes; 3], t: &Lanes, counts: &mut Lanes) {
        let inside = match &self.kind {
            Kind::Ball { center, radius2 } => each(|k| {
                let x = dir[0][k] * t[k] - center.x;
                let y = dir[1][k] * t[k] - center.y;
                let z = dir[2][k] * t[k] - center.z;
                radius2 - (x * x + y * y + z * z)
            }),
            Kind::Half { depth, .. } => each(|k| depth - dir[0][k] * t[k]),
            Kind::Slabs { low, high, .. } => {
                let mut inside = [f64::INFINITY; RAYS];
                for i in 0..3 {
                    for k in 0..RAYS {
                        let q = dir[i][k] * t[k];
                        inside[k] = lesser(lesser(q - low[i], high[i] - q), inside[k]);
                    }
                }
                inside
            }
        };
        let slack = if self.inverted { -self.slack } else { self.slack };
        for k in 0..RAYS {
            counts[k] = lesser(inside[k] * slack, counts[k]);
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{BlockerGuess, Hit, Obstacles, Segment, Shaft};
    use raggio_math::Ray;
    use raggio_scene::{Csg, Object, ObjectKind, Shape};
    use std::sync::Arc;

    fn shape(shape: Shape) -> Arc<Object> {
        Arc::new(Object::new(ObjectKind::Shape(Arc::new(shape))))
    }

    fn csg(op: Csg, children: Vec<Arc<Object>>) -> Object {
        Object::new(ObjectKind::Csg { op, children: Arc::new(children) })
    }

    /// A turned frame, a lens, a cut ball, a box and a ball above a floor.
    fn things() -> Geometry {
        let cube = |r: f64, h: f64| shape(Shape::Box { min: Vec3::new(-r, -h, -r), max: Vec3::new(r, h, r) });
        let ball =
            |x: f64, y: f64, z: f64, radius: f64| shape(Shape::Sphere { center: Vec3::new(x, y, z), radius });
        let mut frame =
            csg(Csg::Difference { cutaway_textures: false }, vec![cube(1.0, 0.2), cube(0.5, 0.4)]);
        frame.transform(&Affine::from_rotation_x(0.4));
        let lens = csg(Csg::Intersection, vec![ball(2.5, 0.0, 0.0, 1.0), ball(2.5, 0.9, 0.0, 1.0)]);
        let side = shape(Shape::Plane { normal: Vec3::new(0.6, 0.8, 0.0), distance: -1.5 });
        let cut = csg(Csg::Intersection, vec![ball(-2.5, 0.0, 0.0, 1.0), side]);
        let floor = shape(Shape::Plane { normal: Vec3::Y, distance: -2.0 });
        let all = csg(
            Csg::Union,
            vec![
                Arc::new(frame),
                Arc::new(lens),
                Arc::new(cut),
                floor,
                ball(0.0, 0.2, 2.0, 0.5),
                cube(0.2, 0.9),
            ],
        );
        Geometry::of_object(&Arc::new(all)).expect("simple shapes")
    }

    /// Nothing lets light through.
    struct Wall;

    impl Obstacles for Wall {
        fn stops(&self, _leaf: u32) -> bool {
            true
        }
        fn is_plain(&self, _leaf: u32) -> bool {
            true
        }
        fn meets(&mut self, _hit: &Hit) -> bool {
            true
        }
    }

    #[test]
    fn verdicts_agree_with_single_rays() {
        let (geometry, near) = (things(), 1e-3);
        let (mut stopped, mut free) = (0, 0);
        let mut screen = Screen::default();
        for i in 0..400 {
            let p =
                (Vec3::new(3.0, 11.0, 17.0) * (f64::from(i) * 0.37)).map(f64::cos) * Vec3::new(4.0, 1.9, 4.0);
            let light = Vec3::new(0.5, 5.0, -0.5);
            let corners = [(-1.0, -1.0), (1.0, -1.0), (1.0, 1.0), (-1.0, 1.0)];
            let patch = corners.map(|(x, z)| light + Vec3::new(x, 0.0, z));
            let shaft = Shaft::new(p, patch, 0.999 * near).expect("a shaft");
            let standing = geometry.standing_in(&shaft, RayClass::Shadow);
            if !geometry.screen(&standing, p, |_| true, &mut screen) {
                continue;
            }
            let at = |k: usize| light + Vec3::new(0.25 * k as f64 - 0.875, 0.0, (k as f64).sin());
            let targets = [0, 1, 2].map(|axis| std::array::from_fn(|k| (at(k) - p)[axis]));
            let verdict = screen.verdict(&targets, near);
            for k in 0..RAYS {
                let way = at(k) - p;
                let ray = Ray::new(p, way.normalize());
                let range = (near, way.length() - near);
                let mut guess = BlockerGuess::default();
                let segment = Segment { ray: &ray, range, gap: near, own: None };
                let hit = geometry.is_stopped(&segment, &standing, &mut guess, &mut Wall);
                let (is_stopped, is_free) = (verdict.stopped >> k & 1 == 1, verdict.free >> k & 1 == 1);
                assert_eq!((is_stopped, is_free), (hit, !hit), "{i} {k}");
                stopped += u32::from(is_stopped);
                free += u32::from(is_free);
            }
        }
        assert!(stopped > 300 && free > 300, "{stopped} {free}");
    }
}
