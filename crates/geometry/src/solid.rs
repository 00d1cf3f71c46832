//! Small combinations of simple bodies, asked in one sweep along the ray.
//!
//! A ball, box, half space, cone or quadric is met by a ray in one stretch: inside is within it, or beyond. Between the
//! ends of all stretches nothing changes, so a walk from end to end only keeps count of how many members of each group
//! contain the ray; an end is a hit where the counts of the groups around its leaf say so. Where ends lie so close that
//! rounding may have put them in the wrong order the point itself is asked, as in all other combinations.
use raggio_math::Ray;

use crate::body::Body;
use crate::leaf::Leaves;
use crate::probe::Probe;
use crate::tree::{Group, Node, NodeRef, Op, Tree};
use crate::{Hit, LocalHit};
use limits::First;
use united::MOST_UNITED;
use walk::Walk;

/// So many leaves, and groups, a combination may have.
const MOST_PARTS: usize = 64;
const MOST_LEVELS: usize = 16;

/// Ends nearer to each other than this, as a share of the distance and by itself, may be in the wrong order.
const CLOSE: f64 = 1e-6;
/// A hit is looked for again in its leaf by so much around its distance.
const AROUND: f64 = 1e-9;

/// A combination ready for sweeps.
pub(crate) struct Solid {
    parts: Vec<Part>,
    levels: Vec<Level>,
    /// Does every part hold or bar all others?
    limited: bool,
    /// Is it a merge, and of few?
    united: bool,
    /// Are its parts the members of its group, each inside its box?
    boxed: bool,
    /// How many members of each level contain a ray that is in none of the bodies.
    outside: [u8; MOST_LEVELS],
}

/// A leaf in its group.
struct Part {
    body: Body,
    leaf: u32,
    level: u8,
    inverted: bool,
    /// See [`Body::has_parts`].
    has_parts: bool,
    /// Only cuts: a clip.
    silent: bool,
    /// Nothing counts outside it.
    holds: bool,
    /// Nothing counts inside its body.
    bars: bool,
    rank: u32,
}

/// A group, or the clips around one.
struct Level {
    op: Op,
    size: u8,
    parent: Option<u8>,
}

/// An end of a stretch.
#[derive(Clone, Copy)]
struct End {
    t: f64,
    part: u32,
}

/// An end that is a hit.
pub(crate) struct Counted<'a> {
    part: &'a Part,
    t: f64,
}

impl Level {
    #[inline(always)]
    fn is_inside(&self, count: u8) -> bool {
        match self.op {
            Op::Intersection => count == self.size,
            Op::Union | Op::Merge => count > 0,
        }
    }

    /// Does the hit of a member count, as far as so many others that contain it say?
    #[inline(always)]
    fn lets_count(&self, others: u8) -> bool {
        match self.op {
            Op::Intersection => others + 1 == self.size,
            Op::Merge => others == 0,
            Op::Union => true,
        }
    }
}

impl Counted<'_> {
    pub(crate) fn leaf(&self) -> u32 {
        self.part.leaf
    }

    /// The hit without the shape's own words.
    pub(crate) fn bare(&self) -> Hit {
        let Part { leaf, inverted, .. } = *self.part;
        Hit { t: self.t, leaf, inverted, local: LocalHit::default() }
    }

    /// The hit, looked for again in its leaf if that has words of its own; `None` where rounding hides it.
    #[inline]
    pub(crate) fn hit(&self, tree: &Tree, ray: &Ray) -> Option<Hit> {
        if !self.part.has_parts {
            return Some(self.bare());
        }
        let around = AROUND * (1.0 + self.t);
        let range = (self.t - around, self.t + around);
        let hit = tree.leaves.closest(self.part.leaf, ray, range, &|_| false)?;
        // Who goes on from there must not find the same end again.
        Some(Hit { t: self.t, ..hit })
    }
}

impl Solid {
    /// Prepares a group for sweeps, if all its leaves are simple bodies and they are few.
    pub(crate) fn new(group: &Group, leaves: &Leaves, groups: &[Group]) -> Option<Solid> {
        if group.op == Op::Union && group.clips.is_empty() {
            return None;
        }
        let mut solid = Solid {
            parts: Vec::new(),
            levels: Vec::new(),
            limited: false,
            united: false,
            boxed: false,
            outside: [0; MOST_LEVELS],
        };
        solid.add_group(group, None, false, leaves, groups)?;
        solid.mark_limits();
        solid.limited = solid.parts.iter().all(|part| part.holds || part.bars);
        // What limits the rest comes first.
        solid.parts.sort_by_key(|part| !part.holds);
        solid.united = solid.levels.iter().all(|level| level.op == Op::Merge)
            && solid.parts.iter().all(|part| !part.inverted)
            && solid.parts.len() <= MOST_UNITED;
        solid.boxed = solid.levels.len() == 1 && solid.parts.iter().all(|part| part.body.is_bounded());
        let mut walk = Walk::outside(&solid);
        for part in solid.parts.iter().filter(|part| part.inverted) {
            walk.change(part.level, true);
        }
        solid.outside = walk.counts;
        solid.parts.shrink_to_fit();
        solid.levels.shrink_to_fit();
        Some(solid)
    }

    fn add_group(
        &mut self,
        group: &Group,
        parent: Option<u8>,
        silent: bool,
        leaves: &Leaves,
        groups: &[Group],
    ) -> Option<()> {
        if !group.bounds.is_empty() || group.members.is_empty() || group.members.iter().any(|m| m.skip != 0) {
            return None;
        }
        let mut around = parent;
        if !group.clips.is_empty() {
            around = Some(self.add_level(Op::Intersection, group.clips.len() + 1, parent)?);
            for &clip in &group.clips {
                self.add_node(clip, around?, true, leaves, groups)?;
            }
        }
        let level = self.add_level(group.op, group.members.len(), around)?;
        for member in &group.members {
            self.add_node(member.node, level, silent, leaves, groups)?;
        }
        Some(())
    }

    fn add_level(&mut self, op: Op, size: usize, parent: Option<u8>) -> Option<u8> {
        let room = self.levels.len() < MOST_LEVELS && size <= MOST_PARTS;
        self.levels.push(Level { op, size: u8::try_from(size).ok()?, parent });
        room.then_some(self.levels.len() as u8 - 1)
    }

    fn add_node(
        &mut self,
        node: NodeRef,
        level: u8,
        silent: bool,
        leaves: &Leaves,
        groups: &[Group],
    ) -> Option<()> {
        match node.node() {
            Node::Group(at) => self.add_group(&groups[at as usize], Some(level), silent, leaves, groups),
            Node::Leaf(leaf) => {
                let room = self.parts.len() < MOST_PARTS;
                let crate::leaf::Leaf { inverted, rank, .. } = leaves.leaves[leaf as usize];
                let body = Body::of(leaf, leaves)?;
                let (has_parts, holds, bars) = (body.has_parts(), false, false);
                self.parts.push(Part { body, leaf, level, inverted, has_parts, silent, holds, bars, rank });
                room.then_some(())
            }
        }
    }

    /// Under nothing but intersections, and combinations of one member, nothing counts outside a part.
    fn mark_limits(&mut self) {
        let mut limits = [false; MOST_LEVELS];
        for (i, level) in self.levels.iter().enumerate() {
            let all = level.op == Op::Intersection || level.size == 1;
            limits[i] = all && level.parent.is_none_or(|p| limits[usize::from(p)]);
        }
        for part in &mut self.parts {
            let limiting = limits[usize::from(part.level)];
            (part.holds, part.bars) = (limiting && !part.inverted, limiting && part.inverted);
        }
    }

    /// The nearest hit; `None` where the sweep cannot tell.
    #[inline]
    pub(crate) fn closest(
        &self,
        tree: &Tree,
        group: &Group,
        probe: &Probe,
        range: (f64, f64),
    ) -> Option<Option<Hit>> {
        let mut best = None;
        self.sweep(tree, group, probe, range, |end| {
            best = Some(end.hit(tree, probe.ray)?);
            Some(false)
        })?;
        Some(best)
    }

    /// Calls `found` with the ends that are hits, the nearest first, for as long as it answers true. `None` where the
    /// sweep, or `found`, cannot tell: what was found so far is void. `group` is the one that it was made of.
    pub(crate) fn sweep(
        &self,
        tree: &Tree,
        group: &Group,
        probe: &Probe,
        mut range: (f64, f64),
        mut found: impl FnMut(Counted<'_>) -> Option<bool>,
    ) -> Option<()> {
        let ray = probe.ray;
        if self.limited {
            let mut goes_on = |end: End| {
                let part = &self.parts[end.part as usize];
                if part.silent { Some(true) } else { found(Counted { part, t: end.t }) }
            };
            match self.first(ray, range) {
                First::Nothing => return Some(()),
                First::Unclear => {}
                First::Found { end, last } => {
                    if !goes_on(end)? {
                        return Some(());
                    }
                    if let Some(last) = last {
                        if end.t < last.t && last.t < range.1 {
                            goes_on(last)?;
                        }
                        return Some(());
                    }
                    range.0 = end.t;
                }
            }
        }
        if self.united {
            match self.united(group, probe, range, &mut found)? {
                None => return Some(()),
                Some(from) => range.0 = from,
            }
        }
        self.walk(tree, ray, range, found)
    }
}

mod limits;
#[cfg(test)]
mod tests;
mod united;
mod walk;
