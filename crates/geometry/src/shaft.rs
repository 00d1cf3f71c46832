//! Shafts: the space between a point and a patch of light, and what may stand in it.
//!
//! All shadow rays from a point to an area light go through one shaft (Haines and Wallace, "Shaft culling for efficient
//! ray-cast radiosity", 1991). What does not reach into it stops none of them.
use raggio_bvh::{BoxRow, Region};
use raggio_math::{Aabb, Affine, Vec3};
use smallvec::SmallVec;

use crate::leaf::{Leaf, Leaves, Prim};
use crate::tree::{Node, NodeRef, Op, Tree};
use crate::{Geometry, RayClass};

/// The corners of a shaft: near the point, then far.
pub(crate) type Corners = [Vec3; 8];

/// All segments from a point to the points of a patch with four corners, without the part next to the point.
pub struct Shaft {
    corners: Corners,
    region: Region,
    /// Is what stands in it remembered for many rays, so that it is worth looking into groups?
    lasting: bool,
}

/// What may stand in a shaft.
#[derive(Default)]
pub enum Standing {
    /// Too much to be listed, or unknown.
    #[default]
    Anything,
    /// These and nothing else.
    Listed(Box<List>),
}

/// Members of the world by number, with their boxes.
#[derive(Default)]
pub struct List {
    members: SmallVec<[u32; BoxRow::MOST]>,
    pub(crate) boxes: BoxRow,
    /// So few, and none of them groups, that boxes are not worth asking.
    pub(crate) bare: bool,
}

/// Up to so many leaves are asked without their boxes.
const BARE: usize = 2;

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
        Some(Shaft { corners, region: region(corners, patch.map(|far| far - p), p), lasting: false })
    }

    /// The frustum between two patches that look the same from a point. What stands in it is remembered.
    pub fn between(p: Vec3, near: [Vec3; 4], far: [Vec3; 4]) -> Shaft {
        let corners = std::array::from_fn(|i| if i < 4 { near[i] } else { far[i - 4] });
        Shaft { corners, region: region(corners, far.map(|far| far - p), p), lasting: true }
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

impl Standing {
    /// Is it so little that asking it costs next to nothing?
    pub fn is_little(&self) -> bool {
        matches!(self, Standing::Listed(list) if list.bare)
    }
}

impl List {
    /// Does nothing stand there?
    pub fn is_empty(&self) -> bool {
        self.members.is_empty()
    }

    pub(crate) fn members(&self) -> &[u32] {
        &self.members
    }

    pub(crate) fn member(&self, place: usize) -> u32 {
        self.members[place]
    }

    pub(crate) fn place(&self, member: u32) -> Option<usize> {
        self.members.iter().position(|&m| m == member)
    }
}

impl Geometry {
    /// Has it so few objects that all of them are tested at once anyway?
    pub fn is_small(&self) -> bool {
        self.world.members.len() <= BoxRow::MOST
    }

    /// What may stand in a shaft in the way of rays of a class.
    pub fn standing_in(&self, shaft: &Shaft, class: RayClass) -> Standing {
        let mut standing = Standing::Anything;
        self.find_standing(shaft, class, &mut standing);
        standing
    }

    /// The same, into memory that was used before.
    pub fn find_standing(&self, shaft: &Shaft, class: RayClass, standing: &mut Standing) {
        let mut list = match std::mem::take(standing) {
            Standing::Listed(list) => list,
            Standing::Anything => Box::default(),
        };
        list.members.clear();
        list.boxes.clear();
        let mut too_many = false;
        self.world.surfaces.within(&shaft.region, |index, b| {
            let member = self.world.members[index as usize];
            if member.skip & class.bit() != 0 || self.tree.misses(member.node, shaft) {
                return false;
            }
            too_many = list.members.len() == BoxRow::MOST;
            if !too_many {
                list.boxes.put(list.members.len(), b);
                list.members.push(index);
            }
            too_many
        });
        if !too_many {
            let leaf = |&m: &u32| self.world.members[m as usize].node.is_leaf();
            list.bare = list.members.len() <= BARE && list.members.iter().all(leaf);
            *standing = Standing::Listed(list);
        }
    }
}

impl Tree {
    /// Is it plain that the surface of a node does not reach into a shaft?
    fn misses(&self, node: NodeRef, shaft: &Shaft) -> bool {
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

impl Leaves {
    fn misses(&self, leaf: u32, corners: &Corners) -> bool {
        let moved = |to: &Affine| corners.map(|p| to.transform_point3(p));
        match &self.leaves[leaf as usize].prim {
            Prim::Sphere { sphere, .. } => sphere.misses(corners),
            Prim::Plane(plane) => plane.misses(corners),
            Prim::Box(cuboid) => cuboid.misses(corners),
            Prim::PlacedBox { cuboid, place } => cuboid.misses(&moved(&self.places[*place as usize])),
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
