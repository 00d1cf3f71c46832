//! Shafts: the space between a point and a patch of light, and what may stand in it.
//!
//! All shadow rays from a point to an area light go through one shaft (Haines and Wallace, "Shaft culling for efficient
//! ray-cast radiosity", 1991). What does not reach into it stops none of them.
use raggio_bvh::Region;
use raggio_math::{Aabb, Affine, Vec3};

use crate::leaf::{Leaf, Leaves, Prim};
use crate::tree::{Node, NodeRef, Op, Tree};

/// The corners of a shaft: near the point, then far.
pub(crate) type Corners = [Vec3; 8];

/// Shares of the way through a shaft are made smaller by this share, for what rounding does.
const ROUNDING: f64 = 1e-9;

/// All segments from a point to the points of a patch with four corners, without the part next to the point.
pub struct Shaft {
    corners: Corners,
    pub(crate) region: Region,
    /// The point.
    eye: Vec3,
    /// Is what stands in it remembered for many rays, so that it is worth looking into groups?
    lasting: bool,
}

/// Groups of more members are not looked into.
const MOST_MEMBERS: usize = 32;

impl Shaft {
    /// A box instead of a shaft.
    pub(crate) fn of_box(b: &Aabb) -> Shaft {
        let corner = |i: usize| {
            let pick = |bit: usize, lo: f64, hi: f64| if i & bit == 0 { lo } else { hi };
            Vec3::new(pick(1, b.min.x, b.max.x), pick(2, b.min.y, b.max.y), pick(4, b.min.z, b.max.z))
        };
        Shaft {
            corners: std::array::from_fn(corner),
            region: Region { bounds: *b, planes: [(Vec3::ZERO, 0.0); 4] },
            eye: b.centre(),
            lasting: false,
        }
    }

    /// The shaft from `p` to the patch with corners in order around it, from the distance `start` on. `None` where the
    /// point lies in a corner.
    pub fn new(p: Vec3, patch: [Vec3; 4], start: f64) -> Option<Shaft> {
        let mut corners = [p; 8];
        for (i, &far) in patch.iter().enumerate() {
            corners[i] = p + (far - p).try_normalize()? * start;
            corners[i + 4] = far;
        }
        let region = region(corners, patch.map(|far| far - p), p);
        Some(Shaft { corners, region, eye: p, lasting: false })
    }

    /// The frustum between two patches that look the same from a point. What stands in it is remembered.
    pub fn between(p: Vec3, near: [Vec3; 4], far: [Vec3; 4]) -> Shaft {
        let corners = std::array::from_fn(|i| if i < 4 { near[i] } else { far[i - 4] });
        Shaft { corners, region: region(corners, far.map(|far| far - p), p), eye: p, lasting: true }
    }

    /// Its edges, from the point to the far corners.
    fn edges(&self) -> [Vec3; 4] {
        std::array::from_fn(|i| self.corners[i + 4] - self.eye)
    }

    /// The share of the way before which it does not reach a box.
    fn share_before(&self, b: &Aabb) -> f64 {
        let edges = Aabb::around(self.edges());
        let (lo, hi) = (b.min - self.eye, b.max - self.eye);
        let share = |k: usize| {
            if lo[k] > 0.0 && edges.max[k] > 0.0 {
                lo[k] / edges.max[k]
            } else if hi[k] < 0.0 && edges.min[k] < 0.0 {
                hi[k] / edges.min[k]
            } else {
                0.0
            }
        };
        share(0).max(share(1)).max(share(2))
    }
}

/// The region within the sides of a shaft that has some edges from a point on.
fn region(corners: Corners, edges: [Vec3; 4], p: Vec3) -> Region {
    let middle = (edges[0] + edges[1] + edges[2] + edges[3]) * 0.25;
    let planes = [0, 1, 2, 3].map(|i| {
        let normal = edges[i].cross(edges[(i + 1) % 4]);
        let side = normal.dot(middle);
        // A side that all of the patch is in sorts out nothing.
        let flat = side.abs() <= 1e-9 * normal.length() * middle.length();
        let normal = if flat { Vec3::ZERO } else { normal * -side.signum() };
        (normal, normal.dot(p))
    });
    Region { bounds: Aabb::around(corners), planes }
}

impl Tree {
    /// Is it plain that the surface of a node does not reach into a shaft?
    pub(crate) fn misses(&self, node: NodeRef, shaft: &Shaft) -> bool {
        let group = match node.node() {
            Node::Leaf(leaf) => return self.leaves.misses(leaf, &shaft.corners),
            Node::Group(group) => &self.groups[group as usize],
        };
        if !shaft.lasting || group.members.len() > MOST_MEMBERS {
            return false;
        }
        let members = || group.members.iter().map(|member| member.node);
        let lacks = |node| self.lacks(node, shaft);
        group.clips.iter().copied().any(lacks)
            || (group.op == Op::Intersection && members().any(lacks))
            || members().all(|member| self.misses(member, shaft))
    }

    /// Is it plain that no point of a shaft is inside a node?
    fn lacks(&self, node: NodeRef, shaft: &Shaft) -> bool {
        match node.node() {
            Node::Leaf(leaf) => self.leaves.lacks(leaf, &shaft.corners),
            Node::Group(_) => false,
        }
    }
}

impl Tree {
    /// A share of the way through a shaft before which a node with that box is not met, wherever in the shaft that is.
    pub(crate) fn share_before(&self, node: NodeRef, b: &Aabb, shaft: &Shaft) -> f64 {
        let exact = match node.node() {
            Node::Leaf(leaf) => self.leaves.share_before(leaf, shaft),
            Node::Group(_) => 0.0,
        };
        exact.max(shaft.share_before(b)) * (1.0 - ROUNDING)
    }
}

impl Leaves {
    /// What shapes without bounds, or around the shaft's point, know better than their boxes.
    fn share_before(&self, leaf: u32, shaft: &Shaft) -> f64 {
        match &self.leaves[leaf as usize].prim {
            Prim::Sphere { sphere, .. } => {
                sphere.room_around(shaft.eye)
                    / shaft.edges().map(Vec3::length).into_iter().fold(0.0, f64::max)
            }
            Prim::Plane(plane) => shaft
                .edges()
                .map(|edge| plane.share_along(shaft.eye, edge))
                .into_iter()
                .fold(f64::INFINITY, f64::min),
            _ => 0.0,
        }
    }

    fn misses(&self, leaf: u32, corners: &Corners) -> bool {
        let moved = |to: &Affine| corners.map(|p| to.transform_point3(p));
        match &self.leaves[leaf as usize].prim {
            Prim::Sphere { sphere, .. } => sphere.misses(corners),
            Prim::Plane(plane) => plane.misses(corners),
            Prim::Box(cuboid) => cuboid.misses(corners),
            Prim::PlacedBox { cuboid, place, .. } => cuboid.misses(&moved(&self.places[*place as usize])),
            Prim::World(s) => self.shapes[*s as usize].misses(corners),
            Prim::Placed { shape, place } => {
                self.shapes[*shape as usize].misses(&moved(&self.places[*place as usize]))
            }
        }
    }

    /// Is it plain that no point of a hull is inside a leaf, its inversion counted?
    fn lacks(&self, leaf: u32, corners: &Corners) -> bool {
        let Leaf { prim, inverted, .. } = &self.leaves[leaf as usize];
        let apart = |shape: u32, corners: &Corners| !inverted && self.shapes[shape as usize].lacks(corners);
        match prim {
            // All of the hull is on one side of the surface.
            Prim::Sphere { .. } | Prim::Plane(_) | Prim::Box(_) | Prim::PlacedBox { .. } => {
                !self.inside(leaf, corners[0]) && self.misses(leaf, corners)
            }
            Prim::World(shape) => apart(*shape, corners),
            Prim::Placed { shape, place } => {
                let object_from_world = &self.places[*place as usize];
                apart(*shape, &corners.map(|p| object_from_world.transform_point3(p)))
            }
        }
    }
}
