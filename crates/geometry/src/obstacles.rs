//! What a shadow ray meets on its way, found in one walk through the boxes.
use raggio_math::{MAX_DISTANCE, MIN_HIT, Ray};
use smallvec::SmallVec;

use crate::index::ENOUGH;
use crate::probe::Probe;
use crate::shapes::ShapeKind;
use crate::solid::Solid;
use crate::standing::Standing;
use crate::tree::{Group, Lists, Member, Node, NodeRef, Scratch};
use crate::{Geometry, Hit, RayClass};

/// Who follows a shadow ray.
pub trait Obstacles {
    /// Does the surface of a leaf stop the ray wherever it is hit?
    fn stops(&self, leaf: u32) -> bool;
    /// Is the distance all that [`Obstacles::meets`] asks of the hits of a leaf? Their [`Hit::local`] may be left out.
    fn is_plain(&self, leaf: u32) -> bool;
    /// Takes note of a hit, in any order; says whether it stops the ray.
    fn meets(&mut self, hit: &Hit) -> bool;
}

/// What stopped the last shadow ray: see [`Geometry::is_stopped`]. Only speed depends on it.
#[derive(Clone, Copy, Debug, Default)]
pub struct BlockerGuess {
    member: Option<u32>,
}

/// The part of a shadow ray on which surfaces count.
#[derive(Clone, Copy, Debug)]
pub struct Segment<'a> {
    /// From a surface point to a light.
    pub ray: &'a Ray,
    /// Where on it.
    pub range: (f64, f64),
    /// Of one object's surfaces nearer to each other than this perhaps only the first is met.
    pub gap: f64,
    /// The leaf that it starts on, if the ray does not meet it again.
    pub own: Option<u32>,
}

/// A shadow ray under way.
struct Way<'a> {
    probe: &'a Probe<'a>,
    segment: &'a Segment<'a>,
}

impl Geometry {
    /// Is a shadow ray stopped on a part of it? Only what is `standing` in the way is asked. If nothing stops it,
    /// `obstacles` has met every surface there, as far as the segment tells no otherwise. `guess` remembers what stopped
    /// the last ray that was asked with it and is tried first; keep one for each light.
    pub fn is_stopped(
        &self,
        segment: &Segment<'_>,
        standing: &Standing,
        guess: &mut BlockerGuess,
        obstacles: &mut impl Obstacles,
    ) -> bool {
        let range = (segment.range.0.max(MIN_HIT), segment.range.1.min(MAX_DISTANCE));
        let segment = &Segment { range, ..*segment };
        let mut stops = |member: &Member| match member.node.node() {
            Node::Leaf(leaf) if member.skip & RayClass::Shadow.bit() == 0 => {
                self.leaf_stops(leaf, segment, obstacles)
            }
            _ => false,
        };
        match standing {
            Standing::Anything if !self.few.is_empty() => return self.few.iter().any(stops),
            Standing::Listed(list) if list.bare => {
                return list.members().iter().any(|&m| stops(&self.world.members[m as usize]));
            }
            _ => {}
        }
        let way = Way { probe: &Probe::new(segment.ray), segment };
        let mut scratch = Scratch::default();
        let mut ask = |member: u32| self.member_stops(member, &way, &mut scratch, obstacles);
        match standing {
            Standing::Anything => {
                let tried = guess.member.filter(|&member| (member as usize) < self.world.members.len());
                if tried.is_some_and(&mut ask) {
                    return true;
                }
                guess.member = None;
                self.world.surfaces.closest(way.probe, range, |member, _, _| {
                    let stopped = tried != Some(member) && ask(member);
                    guess.member = stopped.then_some(member);
                    stopped.then_some(ENOUGH)
                });
                guess.member.is_some()
            }
            Standing::Listed(list) => {
                let mut touched = list.boxes.touched(&way.probe.slab, range);
                let tried = guess.member.and_then(|member| list.place(member));
                let tried = tried.filter(|&place| touched.take(place));
                let rest = std::iter::from_fn(|| Some(touched.next(range.1)?.place));
                let mut members = tried.into_iter().chain(rest).map(|place| list.member(place));
                let stopper = members.find(|&member| ask(member));
                guess.member = stopper.or(guess.member);
                stopper.is_some()
            }
        }
    }

    /// Of two hits at the same distance that of the higher rank is seen.
    pub fn rank(&self, leaf: u32) -> u32 {
        self.tree.leaves.leaves[leaf as usize].rank
    }

    fn member_stops(
        &self,
        member: u32,
        way: &Way<'_>,
        scratch: &mut Scratch,
        obstacles: &mut impl Obstacles,
    ) -> bool {
        let member = &self.world.members[member as usize];
        if member.skip & RayClass::Shadow.bit() != 0 {
            return false;
        }
        let group = match member.node.node() {
            Node::Leaf(leaf) => {
                return self.leaf_stops(leaf, way.segment, obstacles);
            }
            Node::Group(group) => &self.tree.groups[group as usize],
        };
        let solid = group.solid.as_ref();
        let swept = solid.and_then(|solid| self.solid_stops(solid, group, way, obstacles));
        swept.unwrap_or_else(|| self.group_stops(member.node, way, scratch, obstacles))
    }

    #[inline]
    fn leaf_stops(&self, leaf: u32, segment: &Segment<'_>, obstacles: &mut impl Obstacles) -> bool {
        if segment.own == Some(leaf) {
            return false;
        }
        if obstacles.stops(leaf) {
            return self.tree.leaves.closest(leaf, segment.ray, segment.range, &|_| true).is_some();
        }
        self.stops_in_places(leaf, segment, obstacles)
    }

    /// Is a ray stopped by one of the surfaces of a leaf that may let it through? Not inlined: from a loop the compiler
    /// would take out what any shape may ask of the ray, and work it out for every leaf.
    #[inline(never)]
    fn stops_in_places(&self, leaf: u32, segment: &Segment<'_>, obstacles: &mut impl Obstacles) -> bool {
        let Segment { ray, range, gap, .. } = *segment;
        let leaves = &self.tree.leaves;
        if let Some(found) = leaves.closest_of_few(leaf, ray, range, gap, |hit| obstacles.meets(hit)) {
            return found.is_some();
        }
        if leaves.shape(leaf).is_some_and(ShapeKind::finds_all_at_once) {
            return self.one_of_all_stops(leaf, segment, obstacles);
        }
        one_stops(range, gap, obstacles, |range, _| leaves.closest(leaf, ray, range, &|_| false))
    }

    /// [`Geometry::stops_in_places`] by one search for all surfaces.
    fn one_of_all_stops(&self, leaf: u32, segment: &Segment<'_>, obstacles: &mut impl Obstacles) -> bool {
        let Segment { ray, range: (mut from, to), gap, .. } = *segment;
        let mut scratch = Scratch::default();
        let Lists { hits, local } = scratch.lists();
        let start = hits.len();
        self.tree.leaves.hits(leaf, ray, (from, to), local, hits);
        let found = &mut hits[start..];
        found.sort_unstable_by(|a, b| a.t.total_cmp(&b.t));
        let stopped = found.iter().any(|hit| {
            let met = hit.t > from;
            if met {
                from = hit.t + gap;
            }
            met && obstacles.meets(hit)
        });
        hits.truncate(start);
        stopped
    }

    /// `None` where the sweep cannot tell.
    fn solid_stops(
        &self,
        solid: &Solid,
        group: &Group,
        way: &Way<'_>,
        obstacles: &mut impl Obstacles,
    ) -> Option<bool> {
        let mut hits: SmallVec<[Hit; 6]> = SmallVec::new();
        let mut stopped = false;
        let ray = way.probe.ray;
        solid.sweep(&self.tree, group, way.probe, way.segment.range, |end| {
            stopped = obstacles.stops(end.leaf());
            if !stopped {
                hits.push(if obstacles.is_plain(end.leaf()) {
                    end.bare()
                } else {
                    end.hit(&self.tree, ray)?
                });
            }
            Some(!stopped)
        })?;
        Some(stopped || hits.iter().any(|hit| obstacles.meets(hit)))
    }

    fn group_stops(
        &self,
        node: NodeRef,
        way: &Way<'_>,
        scratch: &mut Scratch,
        obstacles: &mut impl Obstacles,
    ) -> bool {
        one_stops(way.segment.range, way.segment.gap, obstacles, |range, obstacles| {
            let stops = |hit: &Hit| obstacles.stops(hit.leaf);
            self.tree.closest(node, way.probe, range, RayClass::Shadow.bit(), scratch, &stops)
        })
    }
}

/// Does one of the surfaces that `closest` finds, one after another, stop the light?
#[inline(always)]
fn one_stops<O: Obstacles>(
    mut range: (f64, f64),
    gap: f64,
    obstacles: &mut O,
    mut closest: impl FnMut((f64, f64), &O) -> Option<Hit>,
) -> bool {
    while range.0 < range.1 {
        let Some(hit) = closest(range, obstacles) else { return false };
        if obstacles.stops(hit.leaf) || obstacles.meets(&hit) {
            return true;
        }
        range.0 = hit.t + gap;
    }
    false
}
