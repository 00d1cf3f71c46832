//! What a shadow ray meets on its way, found in one walk through the boxes.
use raggio_math::{MAX_DISTANCE, MIN_HIT, Ray};
use smallvec::SmallVec;

use crate::index::ENOUGH;
use crate::probe::Probe;
use crate::shaft::Standing;
use crate::shapes::ShapeKind;
use crate::solid::Solid;
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

/// A shadow ray under way.
struct Way<'a> {
    probe: &'a Probe<'a>,
    range: (f64, f64),
    /// Of one object's surfaces nearer to each other than this only the first is met.
    gap: f64,
}

impl Geometry {
    /// Is a shadow ray stopped between `range.0` and `range.1`? Only what is `standing` in the way is asked. If nothing
    /// stops it, `obstacles` has met every surface in the range; of one object's surfaces that lie nearer to each other
    /// than `gap` perhaps only the first. `guess` remembers what stopped the last ray that was asked with it and is
    /// tried first; keep one for each light.
    pub fn is_stopped(
        &self,
        ray: &Ray,
        range: (f64, f64),
        gap: f64,
        standing: &Standing,
        guess: &mut BlockerGuess,
        obstacles: &mut impl Obstacles,
    ) -> bool {
        let range = (range.0.max(MIN_HIT), range.1.min(MAX_DISTANCE));
        let mut stops = |member: &Member| match member.node.node() {
            Node::Leaf(leaf) if member.skip & RayClass::Shadow.bit() == 0 => {
                self.leaf_stops(leaf, ray, range, gap, obstacles)
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
        let way = Way { probe: &Probe::new(ray), range, gap };
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
                return self.leaf_stops(leaf, way.probe.ray, way.range, way.gap, obstacles);
            }
            Node::Group(group) => &self.tree.groups[group as usize],
        };
        let solid = group.solid.as_ref();
        let swept = solid.and_then(|solid| self.solid_stops(solid, group, way, obstacles));
        swept.unwrap_or_else(|| self.group_stops(member.node, way, scratch, obstacles))
    }

    #[inline]
    fn leaf_stops(
        &self,
        leaf: u32,
        ray: &Ray,
        range: (f64, f64),
        gap: f64,
        obstacles: &mut impl Obstacles,
    ) -> bool {
        if obstacles.stops(leaf) {
            return self.tree.leaves.closest(leaf, ray, range, &|_| true).is_some();
        }
        self.stops_in_places(leaf, ray, range, gap, obstacles)
    }

    /// Is a ray stopped by one of the surfaces of a leaf that may let it through? Not inlined: from a loop the compiler
    /// would take out what any shape may ask of the ray, and work it out for every leaf.
    #[inline(never)]
    fn stops_in_places(
        &self,
        leaf: u32,
        ray: &Ray,
        range: (f64, f64),
        gap: f64,
        obstacles: &mut impl Obstacles,
    ) -> bool {
        let leaves = &self.tree.leaves;
        if let Some(found) = leaves.closest_of_few(leaf, ray, range, gap, |hit| obstacles.meets(hit)) {
            return found.is_some();
        }
        if leaves.shape(leaf).is_some_and(ShapeKind::finds_all_at_once) {
            return self.one_of_all_stops(leaf, ray, range, gap, obstacles);
        }
        one_stops(range, gap, obstacles, |range, _| leaves.closest(leaf, ray, range, &|_| false))
    }

    /// [`Geometry::stops_in_places`] by one search for all surfaces.
    fn one_of_all_stops(
        &self,
        leaf: u32,
        ray: &Ray,
        (mut from, to): (f64, f64),
        gap: f64,
        obstacles: &mut impl Obstacles,
    ) -> bool {
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
        solid.sweep(&self.tree, group, way.probe, way.range, |end| {
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
        one_stops(way.range, way.gap, obstacles, |range, obstacles| {
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
