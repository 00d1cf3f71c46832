//! What may stand in a region of space: lists of the world's members, and before where none of them is met.
use std::sync::Arc;

use raggio_bvh::{BoxRow, Region};
use raggio_math::{Aabb, Vec3};
use smallvec::SmallVec;

use crate::shaft::Shaft;
use crate::tree::{Node, NodeRef};
use crate::{Geometry, RayClass};

/// What may stand in a shaft.
#[derive(Default)]
pub enum Standing {
    /// Too much to be listed, or unknown.
    #[default]
    Anything,
    /// These and nothing else.
    Listed(Arc<List>),
}

/// Members of the world by number, with their boxes.
#[derive(Clone, Default)]
pub struct List {
    /// So few, and none of them groups, that boxes are not worth asking.
    pub(crate) bare: bool,
    members: SmallVec<[u32; BoxRow::MOST]>,
    pub(crate) boxes: BoxRow,
}

/// From where on what stands in a shaft may be met, as shares of the way through.
#[derive(Clone, Copy, Debug)]
pub struct Nearest {
    /// The first of them.
    first: f64,
    /// Which that is, if it is a leaf.
    leaf: Option<u32>,
    /// The others.
    others: f64,
}

/// Up to so many leaves are asked without their boxes.
const BARE: usize = 2;

impl Nearest {
    /// Where nothing stands.
    pub const NOTHING: Nearest = Nearest { first: f64::INFINITY, leaf: None, others: f64::INFINITY };
    /// Where anything may stand.
    pub const UNKNOWN: Nearest = Nearest { first: 0.0, leaf: None, others: 0.0 };

    /// Is nothing met before a share of the way, but perhaps this leaf?
    #[inline]
    pub fn is_clear(&self, share: f64, but: Option<u32>) -> bool {
        share <= self.first || (share <= self.others && self.leaf.is_some() && self.leaf == but)
    }

    fn add(&mut self, node: NodeRef, share: f64) {
        let leaf = match node.node() {
            Node::Leaf(leaf) => Some(leaf),
            Node::Group(_) => None,
        };
        if share < self.first {
            self.others = self.first;
            (self.first, self.leaf) = (share, leaf);
        } else {
            self.others = self.others.min(share);
        }
    }
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

    /// One more member, if there is room.
    fn add(&mut self, member: u32, node: NodeRef, b: &Aabb) -> bool {
        let room = self.members.len() < BoxRow::MOST;
        if room {
            self.bare = self.bare && node.is_leaf() && self.members.len() < BARE;
            self.boxes.put(self.members.len(), b);
            self.members.push(member);
        }
        room
    }

    fn clear(&mut self) {
        self.bare = true;
        self.members.clear();
        self.boxes.clear();
    }
}

impl Geometry {
    /// Has it so few objects that all of them are tested at once anyway?
    #[inline]
    pub fn is_small(&self) -> bool {
        self.world.members.len() <= BoxRow::MOST
    }

    /// Can none of its objects stand in their own light, as far as [`Geometry::is_convex`] tells?
    pub fn is_all_convex(&self) -> bool {
        self.world.members.iter().all(|member| match member.node.node() {
            Node::Leaf(leaf) => self.is_convex(leaf),
            Node::Group(_) => false,
        })
    }

    /// What may stand in a shaft in the way of rays of a class.
    pub fn standing_in(&self, shaft: &Shaft, class: RayClass) -> Standing {
        let mut standing = Standing::Anything;
        self.find_standing(shaft, class, &mut standing);
        standing
    }

    /// The same, into memory that was used before.
    pub fn find_standing(&self, shaft: &Shaft, class: RayClass, standing: &mut Standing) {
        self.list(&shaft.region, class, standing, |node, _| !self.tree.misses(node, shaft));
    }

    /// What may stand in a shaft that lies within the space where `around` stands, and from where on.
    pub fn standing_among(&self, around: &Standing, shaft: &Shaft, class: RayClass) -> (Standing, Nearest) {
        let mut nearest = Nearest::NOTHING;
        let mut reaches = |node: NodeRef, b: &Aabb| {
            let reaches = !self.tree.misses(node, shaft);
            if reaches {
                nearest.add(node, self.tree.share_before(node, b, shaft));
            }
            reaches
        };
        let mut standing = Standing::Anything;
        match around {
            Standing::Anything => self.list(&shaft.region, class, &mut standing, reaches),
            Standing::Listed(around) => {
                let mut list = List::default();
                list.clear();
                around.boxes.within(&shaft.region, |place, b| {
                    let index = around.members[place as usize];
                    let node = self.world.members[index as usize].node;
                    if reaches(node, b) {
                        list.add(index, node, b);
                    }
                });
                // Most lists are those of the space around.
                let same = list.members.len() == around.members.len();
                standing = Standing::Listed(if same { around.clone() } else { Arc::new(list) });
            }
        }
        match standing {
            Standing::Anything => (standing, Nearest::UNKNOWN),
            Standing::Listed(_) => (standing, nearest),
        }
    }

    /// The box around what lies beside a point, and what else rays of a class meet: what has no end or stands around
    /// the point.
    pub fn seen_from(&self, p: Vec3, class: RayClass) -> (Aabb, Standing, Nearest) {
        let (mut list, mut nearest, mut room) = (List::default(), Nearest::NOTHING, true);
        list.clear();
        let beside = self.world.surfaces.beside(p, |index, b| {
            let member = self.world.members[index as usize];
            if member.skip & class.bit() == 0 {
                nearest.add(member.node, 0.0);
                room = room && list.add(index, member.node, b);
            }
        });
        let around = if room { Standing::Listed(Arc::new(list)) } else { Standing::Anything };
        (beside, around, nearest)
    }

    /// Lists the members of the world in a region that are `wanted`.
    fn list(
        &self,
        region: &Region,
        class: RayClass,
        standing: &mut Standing,
        mut wanted: impl FnMut(NodeRef, &Aabb) -> bool,
    ) {
        let mut shared = match std::mem::take(standing) {
            Standing::Listed(list) => list,
            Standing::Anything => Arc::default(),
        };
        let list = Arc::make_mut(&mut shared);
        list.clear();
        let mut too_many = false;
        self.world.surfaces.within(region, |index, b| {
            let member = self.world.members[index as usize];
            if member.skip & class.bit() == 0 && wanted(member.node, b) {
                too_many = !list.add(index, member.node, b);
            }
            too_many
        });
        if !too_many {
            *standing = Standing::Listed(shared);
        }
    }
}
