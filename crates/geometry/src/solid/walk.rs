//! All hits of a combination on a ray: a walk from end to end of the stretches of its parts.
use raggio_math::{Ray, Vec3};
use smallvec::SmallVec;

use super::{CLOSE, Counted, End, MOST_LEVELS, Part, Solid};
use crate::body::Ready;
use crate::leaf::Leaves;
use crate::shapes::Stretch;
use crate::tree::Tree;

/// Where a walk stands.
pub(super) struct Walk<'a> {
    solid: &'a Solid,
    /// How many members of each level contain the ray here.
    pub(super) counts: [u8; MOST_LEVELS],
    /// Bits of the parts that contain it.
    contains: u64,
}

impl Solid {
    /// [`Solid::sweep`] for all combinations, from end to end.
    pub(super) fn walk(
        &self,
        tree: &Tree,
        ray: &Ray,
        range: (f64, f64),
        mut found: impl FnMut(Counted<'_>) -> Option<bool>,
    ) -> Option<()> {
        let mut walk = Walk::outside(self);
        let mut ends: SmallVec<[End; 24]> = SmallVec::new();
        if !walk.start(ray, range, &mut ends) {
            return Some(());
        }
        let ends = ends.as_mut_slice();
        ends.sort_unstable_by(|a, b| a.t.total_cmp(&b.t));
        let mut i = 0;
        while i < ends.len() && ends[i].t < range.1 {
            let mut next = i + 1;
            while next < ends.len() && ends[next].t - ends[next - 1].t <= CLOSE * (1.0 + ends[next].t) {
                next += 1;
            }
            let goes_on = match &mut ends[i..next] {
                [End { t, part }] => walk.pass(*t, *part as usize, &mut found)?,
                close => walk.pass_close(&tree.leaves, ray, range.1, close, &mut found)?,
            };
            if !goes_on {
                break;
            }
            i = next;
        }
        Some(())
    }
}

impl<'a> Walk<'a> {
    /// Outside of all bodies.
    pub(super) fn outside(solid: &'a Solid) -> Self {
        Walk { solid, counts: solid.outside, contains: 0 }
    }

    /// Finds the ends of stretches within the range, as far as they can matter, and what contains the ray before the
    /// first of them. False where nothing can count.
    #[inline]
    fn start(&mut self, ray: &Ray, range: (f64, f64), ends: &mut SmallVec<[End; 24]>) -> bool {
        let (mut from, mut to) = range;
        let mut ready = Ready::new();
        for (i, part) in self.solid.parts.iter().enumerate() {
            let Stretch { enter, leave, beyond } = part.body.stretch(ray, &mut ready);
            if part.holds && !beyond {
                if leave <= from || enter >= to {
                    return false;
                }
                let (first, last) =
                    (enter - CLOSE * (1.0 + enter.abs()), leave + CLOSE * (1.0 + leave.abs()));
                (from, to) = (from.max(first), to.min(last));
            }
            if part.bars && !beyond && enter < from && leave > to {
                return false;
            }
            if (enter <= from && from < leave) != beyond {
                self.turn(i);
            }
            for t in [enter, leave] {
                if t > from && t <= to {
                    ends.push(End { t, part: i as u32 });
                }
            }
        }
        !ends.is_empty()
    }

    /// Goes past an end that has no others near; answers whether hits are still wanted.
    #[inline]
    fn pass(
        &mut self,
        t: f64,
        part: usize,
        found: &mut impl FnMut(Counted<'_>) -> Option<bool>,
    ) -> Option<bool> {
        let goes_on = self.meet(t, part, found)?;
        self.turn(part);
        Some(goes_on)
    }

    /// Goes past ends that lie so close that only the points themselves can be asked.
    fn pass_close(
        &mut self,
        leaves: &Leaves,
        ray: &Ray,
        to: f64,
        ends: &mut [End],
        found: &mut impl FnMut(Counted<'_>) -> Option<bool>,
    ) -> Option<bool> {
        let rank = |end: &End| self.solid.parts[end.part as usize].rank;
        ends.sort_unstable_by(|a, b| a.t.total_cmp(&b.t).then_with(|| rank(b).cmp(&rank(a))));
        let behind = ends.iter().fold(self.contains, |bits, end| bits ^ 1 << end.part);
        let mut asked = f64::NAN;
        for &End { t, part } in ends.iter().take_while(|end| end.t < to) {
            if t != asked {
                self.turn_to(self.asked(leaves, ends, ray.at(t)));
                asked = t;
            }
            if !self.meet(t, part as usize, found)? {
                return Some(false);
            }
        }
        self.turn_to(behind);
        Some(true)
    }

    /// Tells of an end, if it counts; answers whether more are wanted.
    #[inline]
    fn meet(&self, t: f64, part: usize, found: &mut impl FnMut(Counted<'_>) -> Option<bool>) -> Option<bool> {
        let counted = Counted { part: &self.solid.parts[part], t };
        if counted.part.silent || !self.lets_count(part) { Some(true) } else { found(counted) }
    }

    /// Bits of the parts that contain a point: those that have ends near it are asked, of the others it is known.
    fn asked(&self, leaves: &Leaves, ends: &[End], p: Vec3) -> u64 {
        ends.iter().fold(self.contains, |bits, end| {
            let Part { leaf, inverted, .. } = self.solid.parts[end.part as usize];
            let contains = leaves.inside(leaf, p) != inverted;
            bits & !(1 << end.part) | u64::from(contains) << end.part
        })
    }

    /// The ray enters or leaves bodies until these contain it.
    #[inline]
    fn turn_to(&mut self, contains: u64) {
        let mut others = self.contains ^ contains;
        while others != 0 {
            self.turn(others.trailing_zeros() as usize);
            others &= others - 1;
        }
    }

    /// The ray enters or leaves the body of a part.
    #[inline]
    fn turn(&mut self, part: usize) {
        self.contains ^= 1 << part;
        let Part { level, inverted, .. } = self.solid.parts[part];
        self.change(level, (self.contains >> part & 1 == 1) != inverted);
    }

    /// A member of a level begins to contain the ray, or no longer does.
    #[inline]
    pub(super) fn change(&mut self, level: u8, mut contains: bool) {
        let mut at = usize::from(level);
        loop {
            let level = &self.solid.levels[at];
            let count = self.counts[at];
            self.counts[at] = if contains { count.wrapping_add(1) } else { count.wrapping_sub(1) };
            let now = level.is_inside(self.counts[at]);
            if now == level.is_inside(count) {
                return;
            }
            contains = now;
            let Some(parent) = level.parent else { return };
            at = usize::from(parent);
        }
    }

    /// Do the groups around a part let its hit here count?
    #[inline]
    fn lets_count(&self, part: usize) -> bool {
        let Part { level, inverted, .. } = self.solid.parts[part];
        let mut own = (self.contains >> part & 1 == 1) != inverted;
        let mut at = usize::from(level);
        loop {
            let level = &self.solid.levels[at];
            let count = self.counts[at];
            if !level.lets_count(count.wrapping_sub(u8::from(own))) {
                return false;
            }
            own = level.is_inside(count);
            let Some(parent) = level.parent else { return true };
            at = usize::from(parent);
        }
    }
}
