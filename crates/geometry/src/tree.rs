//! The compiled tree: leaves, and groups of them that must be asked together (CSG, clipped or bounded objects).
//!
//! Unions, merges and intersections are all that is left of the operations: a difference is an intersection with
//! inverted members, and inversion has been carried down to the leaves. A surface point counts where the other members
//! have it so (shapes spec, section 8), so a hit is judged on its own and queries may be cut to any range.
use std::cell::Cell;

use raggio_math::{Ray, Vec3};

use crate::convex::Convex;
use crate::index::{Deciders, ENOUGH, Index};
use crate::leaf::{Leaves, put};
use crate::probe::Probe;
use crate::solid::Solid;
use crate::{Hit, LocalHit};

/// A node: a leaf or a group.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct NodeRef(u32);

/// What a [`NodeRef`] stands for.
pub(crate) enum Node {
    Leaf(u32),
    Group(u32),
}

impl NodeRef {
    const GROUP: u32 = 1 << 31;

    pub(crate) fn leaf(index: usize) -> Self {
        NodeRef(index as u32)
    }

    pub(crate) fn group(index: usize) -> Self {
        NodeRef(index as u32 | Self::GROUP)
    }

    #[inline]
    pub(crate) fn is_leaf(self) -> bool {
        self.0 & Self::GROUP == 0
    }

    #[inline]
    pub(crate) fn node(self) -> Node {
        match self.0 & Self::GROUP {
            0 => Node::Leaf(self.0),
            _ => Node::Group(self.0 & !Self::GROUP),
        }
    }
}

/// How a group combines its members.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Op {
    Union,
    Merge,
    Intersection,
}

/// A member of a group.
#[derive(Clone, Copy)]
pub(crate) struct Member {
    pub(crate) node: NodeRef,
    /// Classes of rays that do not see it; bits of [`crate::RayClass`].
    pub(crate) skip: u8,
}

/// Objects asked together.
pub(crate) struct Group {
    pub(crate) op: Op,
    pub(crate) members: Vec<Member>,
    /// Where the members' surfaces are.
    pub(crate) surfaces: Index,
    /// Which members may decide alone about inside: by containing a point (union, merge), or not (intersection).
    pub(crate) deciders: Deciders,
    /// Points outside any of them do not exist.
    pub(crate) clips: Vec<NodeRef>,
    /// Rays that miss any of them miss the group.
    pub(crate) bounds: Vec<NodeRef>,
    /// What it lies within: planes and other simple members of an intersection, and of the clips.
    pub(crate) convex: Option<Convex>,
    /// The whole of it, if it is small and simple.
    pub(crate) solid: Option<Box<Solid>>,
    /// Do the ranks of leaves decide between equally near hits, or does the first found?
    pub(crate) ranked: bool,
}

/// Lists of hits.
#[derive(Default)]
pub(crate) struct Lists {
    pub(crate) hits: Vec<Hit>,
    pub(crate) local: Vec<LocalHit>,
}

thread_local! {
    /// Lists kept from ray to ray, so that none allocates.
    static LISTS: Cell<Lists> = Cell::default();
}

/// Room for lists of hits, fetched when first it is needed.
#[derive(Default)]
pub(crate) struct Scratch(Option<Lists>);

impl Scratch {
    pub(crate) fn lists(&mut self) -> &mut Lists {
        self.0.get_or_insert_with(|| LISTS.take())
    }
}

impl Drop for Scratch {
    #[inline]
    fn drop(&mut self) {
        if let Some(lists) = self.0.take() {
            LISTS.set(lists);
        }
    }
}

/// Leaves and groups.
pub(crate) struct Tree {
    pub(crate) leaves: Leaves,
    pub(crate) groups: Vec<Group>,
}

/// No member of a group.
const NOBODY: u32 = u32::MAX;

impl Group {
    /// The part of a range in which a ray may hit it, as far as its convex part tells.
    #[inline(always)]
    fn span(&self, ray: &Ray, range: (f64, f64), leaves: &Leaves) -> Option<(f64, f64)> {
        match &self.convex {
            None => Some(range),
            Some(convex) => convex.span(ray, range, leaves),
        }
    }

    /// Does every hit of a member count?
    fn all_count(&self) -> bool {
        self.op == Op::Union && self.clips.is_empty()
    }
}

impl Tree {
    /// The nearest hit of a node, for rays of the class whose bit is `class`; or any hit that `stops` says yes to.
    #[inline]
    pub(crate) fn closest<F: Fn(&Hit) -> bool>(
        &self,
        node: NodeRef,
        probe: &Probe,
        range: (f64, f64),
        class: u8,
        scratch: &mut Scratch,
        stops: &F,
    ) -> Option<Hit> {
        match node.node() {
            Node::Leaf(leaf) => self.leaves.closest(leaf, probe.ray, range, stops),
            Node::Group(group) => {
                self.group_closest(&self.groups[group as usize], probe, range, class, scratch, stops)
            }
        }
    }

    /// Not inlined, so that leaves need not pay for the room that groups work in.
    #[inline(never)]
    pub(crate) fn group_closest<F: Fn(&Hit) -> bool>(
        &self,
        group: &Group,
        probe: &Probe,
        range: (f64, f64),
        class: u8,
        scratch: &mut Scratch,
        stops: &F,
    ) -> Option<Hit> {
        if let Some(solid) = &group.solid
            && let Some(found) = solid.closest(self, group, probe, range)
        {
            return found;
        }
        let start = range.0;
        let range = group.span(probe.ray, range, &self.leaves)?;
        if !self.within_bounds(group, probe, scratch) {
            return None;
        }
        let mut best = Hit::NONE;
        let members = &group.surfaces;
        let found = if group.all_count() {
            self.closest_of_all(group, members, probe, range, class, scratch, stops, &mut best)
        } else {
            let ask = |index, range, out: &mut Hit| {
                put(self.closest_that_counts(group, index, probe, start, range, class, scratch), out)
            };
            self.closest_member(group, members, probe, range, class, stops, &mut best, ask)
        };
        found.then_some(best)
    }

    /// Puts the nearest hit of some members of a group in which all hits count, its bounds not asked, where it is
    /// wanted, and says whether there is one.
    #[inline]
    pub(crate) fn closest_of_all<F: Fn(&Hit) -> bool>(
        &self,
        group: &Group,
        members: &Index,
        probe: &Probe,
        range: (f64, f64),
        class: u8,
        scratch: &mut Scratch,
        stops: &F,
        best: &mut Hit,
    ) -> bool {
        self.closest_member(group, members, probe, range, class, stops, best, |index, range, out| match group
            .members[index as usize]
            .node
            .node()
        {
            Node::Leaf(leaf) => self.leaves.closest_apart(leaf, probe.ray, range, stops, out),
            Node::Group(group) => {
                let group = &self.groups[group as usize];
                put(self.group_closest(group, probe, range, class, scratch, stops), out)
            }
        })
    }

    /// Puts the nearest of the hits that `ask` finds of some members of a group, or any that `stops` says yes to, into
    /// `best`, and says whether there is one. So does `ask` with the hit of a member.
    #[inline(always)]
    fn closest_member(
        &self,
        group: &Group,
        members: &Index,
        probe: &Probe,
        range: (f64, f64),
        class: u8,
        stops: &impl Fn(&Hit) -> bool,
        best: &mut Hit,
        mut ask: impl FnMut(u32, (f64, f64), &mut Hit) -> bool,
    ) -> bool {
        let mut found = false;
        members.closest(probe, range, |index, far, within| {
            let member = &group.members[index as usize];
            if member.skip & class != 0 {
                return None;
            }
            // A group with bounds may show more than its box holds.
            let mut range = if member.node.is_leaf() { within } else { (range.0, far) };
            if group.ranked && found {
                let mut other = Hit::NONE;
                if range.1 == far {
                    range.1 = far.next_up();
                }
                if !ask(index, range, &mut other) || !self.stands_before(&other, best) {
                    return None;
                }
                *best = other;
            } else if !ask(index, range, best) {
                return None;
            }
            found = true;
            Some(if stops(best) { ENOUGH } else { best.t })
        });
        found
    }

    /// Which of two hits is seen? Of equally near ones the leaves' ranks decide, so that coincident surfaces look as
    /// they do in POV-Ray.
    fn stands_before(&self, a: &Hit, b: &Hit) -> bool {
        let rank = |hit: &Hit| self.leaves.leaves[hit.leaf as usize].rank;
        a.t < b.t || (a.t == b.t && rank(a) > rank(b))
    }

    /// What a ray meets first of a member from `start` on, if the group sees no more of it than that.
    fn only_first(&self, group: &Group, member: NodeRef, ray: &Ray, start: f64) -> Option<Option<Hit>> {
        match member.node() {
            Node::Leaf(leaf) if group.op != Op::Union && self.leaves.leaves[leaf as usize].first_only => {
                Some(self.leaves.closest(leaf, ray, (start, f64::INFINITY), &|_| false))
            }
            _ => None,
        }
    }

    /// The nearest of a member's hits that the group lets count; the ray begins at `start`.
    fn closest_that_counts(
        &self,
        group: &Group,
        member: u32,
        probe: &Probe,
        start: f64,
        range: (f64, f64),
        class: u8,
        scratch: &mut Scratch,
    ) -> Option<Hit> {
        let node = group.members[member as usize].node;
        let counts = |t: f64| self.counts(group, member, probe.ray.at(t));
        if let Some(first) = self.only_first(group, node, probe.ray, start) {
            return first.filter(|hit| range.0 < hit.t && hit.t < range.1 && counts(hit.t));
        }
        if let Node::Leaf(leaf) = node.node() {
            let ray = probe.ray;
            let found = self.leaves.closest_of_few(leaf, ray, range, 0.0, |hit| counts(hit.t));
            if let Some(found) = found.or_else(|| self.leaves.closest_counted(leaf, ray, range, counts)) {
                return found;
            }
        }
        let start = scratch.lists().hits.len();
        self.hits(node, probe, range, class, scratch);
        let found = &mut scratch.lists().hits[start..];
        let rank = |hit: &Hit| self.leaves.leaves[hit.leaf as usize].rank;
        found.sort_unstable_by(|a, b| a.t.total_cmp(&b.t).then_with(|| rank(b).cmp(&rank(a))));
        let best = found.iter().find(|hit| counts(hit.t)).copied();
        scratch.lists().hits.truncate(start);
        best
    }

    /// Appends every hit of a node, in any order.
    fn hits(&self, node: NodeRef, probe: &Probe, range: (f64, f64), class: u8, scratch: &mut Scratch) {
        let group = match node.node() {
            Node::Leaf(leaf) => {
                let Lists { hits, local } = scratch.lists();
                return self.leaves.hits(leaf, probe.ray, range, local, hits);
            }
            Node::Group(group) => &self.groups[group as usize],
        };
        if let Some(solid) = &group.solid {
            let hits = &mut scratch.lists().hits;
            let start = hits.len();
            let swept = solid.sweep(self, group, probe, range, |end| {
                hits.push(end.hit(self, probe.ray)?);
                Some(true)
            });
            if swept.is_some() {
                return;
            }
            hits.truncate(start);
        }
        let start = range.0;
        let Some(range) = group.span(probe.ray, range, &self.leaves) else { return };
        if !self.within_bounds(group, probe, scratch) {
            return;
        }
        let all_count = group.all_count();
        group.surfaces.all(probe, range, |index| {
            let member = &group.members[index as usize];
            if member.skip & class != 0 {
                return;
            }
            let before = scratch.lists().hits.len();
            match self.only_first(group, member.node, probe.ray, start) {
                Some(first) => {
                    scratch.lists().hits.extend(first.filter(|hit| range.0 < hit.t && hit.t < range.1));
                }
                None => self.hits(member.node, probe, range, class, scratch),
            }
            if all_count {
                return;
            }
            let hits = &mut scratch.lists().hits;
            let mut kept = before;
            for i in before..hits.len() {
                if self.counts(group, index, probe.ray.at(hits[i].t)) {
                    hits.swap(kept, i);
                    kept += 1;
                }
            }
            hits.truncate(kept);
        });
    }

    /// Does a point on the surface of a member belong to the surface of the group?
    pub(crate) fn counts(&self, group: &Group, member: u32, p: Vec3) -> bool {
        self.within_clips(group, p)
            && match group.op {
                Op::Union => true,
                Op::Merge => !self.any_contains(group, p, member),
                Op::Intersection => !self.any_lacks(group, p, member),
            }
    }

    /// Is the point inside the node?
    pub(crate) fn inside(&self, node: NodeRef, p: Vec3) -> bool {
        match node.node() {
            Node::Leaf(leaf) => self.leaves.inside(leaf, p),
            Node::Group(group) => self.group_inside(&self.groups[group as usize], p),
        }
    }

    pub(crate) fn group_inside(&self, group: &Group, p: Vec3) -> bool {
        self.within_clips(group, p) && self.unclipped_inside(group, p)
    }

    /// Is the point inside the node, if that had no clips of its own?
    pub(crate) fn inside_unclipped(&self, node: NodeRef, p: Vec3) -> bool {
        match node.node() {
            Node::Leaf(leaf) => self.leaves.inside(leaf, p),
            Node::Group(group) => self.unclipped_inside(&self.groups[group as usize], p),
        }
    }

    fn unclipped_inside(&self, group: &Group, p: Vec3) -> bool {
        match group.op {
            Op::Union | Op::Merge => self.any_contains(group, p, NOBODY),
            Op::Intersection => !self.any_lacks(group, p, NOBODY),
        }
    }

    fn any_contains(&self, group: &Group, p: Vec3, except: u32) -> bool {
        let inside = |m: u32| self.inside(group.members[m as usize].node, p);
        group.deciders.any(p, |m, known| m != except && known.unwrap_or_else(|| inside(m)))
    }

    fn any_lacks(&self, group: &Group, p: Vec3, except: u32) -> bool {
        let inside = |m: u32| self.inside(group.members[m as usize].node, p);
        group.deciders.any(p, |m, known| m != except && !known.unwrap_or_else(|| inside(m)))
    }

    pub(crate) fn within_clips(&self, group: &Group, p: Vec3) -> bool {
        group.clips.iter().all(|&clip| self.inside(clip, p))
    }

    /// A ray is shot at the group only if it starts inside every bound or hits it (shapes spec, section 1.4).
    #[inline]
    fn within_bounds(&self, group: &Group, probe: &Probe, scratch: &mut Scratch) -> bool {
        group.bounds.iter().all(|&bound| {
            self.inside(bound, probe.ray.origin)
                || self.closest(bound, probe, (0.0, f64::INFINITY), 0, scratch, &|_| true).is_some()
        })
    }
}
