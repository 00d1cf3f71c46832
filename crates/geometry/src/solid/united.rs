//! The hits of a merge on a ray, without a walk: where it is outside of all bodies the nearest beginning of a stretch is
//! next, and inside of any the end of the chain of stretches that overlap.
use raggio_math::Ray;

use super::{CLOSE, Counted, Solid};
use crate::body::Ready;
use crate::probe::Probe;
use crate::tree::Group;

/// Merges of more bodies than this are walked.
pub(super) const MOST_UNITED: usize = 12;

/// The stretches of the bodies that are met in a range.
struct Stretches {
    enter: [f64; MOST_UNITED],
    leave: [f64; MOST_UNITED],
    part: [u32; MOST_UNITED],
    len: usize,
}

impl Stretches {
    const NONE: Stretches =
        Stretches { enter: [0.0; MOST_UNITED], leave: [0.0; MOST_UNITED], part: [0; MOST_UNITED], len: 0 };

    /// Adds those of the parts whose bits are given that reach into the range; false where one of them lies beyond its
    /// ends. Not inlined: what bodies ask of the ray alone would be worked out before it is known that there are any.
    #[inline(never)]
    fn add_all(&mut self, solid: &Solid, mut parts: u32, ray: &Ray, from: f64, to: f64) -> bool {
        let mut ready = Ready::new();
        while parts != 0 {
            let i = parts.trailing_zeros();
            parts &= parts - 1;
            let stretch = solid.parts[i as usize].body.stretch(ray, &mut ready);
            if stretch.beyond || self.len == MOST_UNITED {
                return false;
            }
            if stretch.leave > from && stretch.enter < to {
                (self.enter[self.len], self.leave[self.len]) = (stretch.enter, stretch.leave);
                self.part[self.len] = i;
                self.len += 1;
            }
        }
        true
    }

    #[inline(always)]
    fn contain(&self, t: f64) -> bool {
        let mut contain = false;
        for i in 0..self.len.min(MOST_UNITED) {
            contain |= self.enter[i] <= t && t < self.leave[i];
        }
        contain
    }

    /// Is the end of a stretch that is next along the ray the only one there?
    #[inline(always)]
    fn is_alone(&self, end: usize, t: f64) -> bool {
        let close = CLOSE * (1.0 + t.abs());
        let mut near = 0;
        for i in 0..self.len.min(MOST_UNITED) {
            near += u32::from((self.enter[i] - t).abs() <= close);
            near += u32::from((self.leave[i] - t).abs() <= close);
        }
        end < MOST_UNITED && near == 1
    }

    /// Where a ray that is outside comes in next: which stretch, and where.
    #[inline(always)]
    fn next_enter(&self, at: f64) -> (usize, f64) {
        let (mut first, mut t) = (MOST_UNITED, f64::INFINITY);
        for i in 0..self.len.min(MOST_UNITED) {
            if self.enter[i] > at && self.enter[i] < t {
                (first, t) = (i, self.enter[i]);
            }
        }
        (first, t)
    }

    /// Where a ray that is inside comes out.
    #[inline(always)]
    fn next_leave(&self, at: f64) -> (usize, f64) {
        let (mut last, mut t, mut surely) = (MOST_UNITED, at, at);
        loop {
            let before = last;
            for i in 0..self.len.min(MOST_UNITED) {
                if self.enter[i] <= surely && self.leave[i] > t {
                    (last, t) = (i, self.leave[i]);
                }
            }
            if last == before {
                return (last, t);
            }
            // A stretch that begins hardly before the others end may not overlap with them at all.
            surely = t - CLOSE * (1.0 + t.abs());
        }
    }
}

impl Solid {
    /// [`Solid::sweep`] for merges. Answers the distance from which a walk has to go on, if it cannot tell all.
    #[inline]
    pub(super) fn united(
        &self,
        group: &Group,
        probe: &Probe,
        range: (f64, f64),
        mut found: impl FnMut(Counted<'_>) -> Option<bool>,
    ) -> Option<Option<f64>> {
        let all = (1 << self.parts.len()) - 1;
        let parts = if self.boxed { group.surfaces.touched(probe, range).unwrap_or(all) } else { all };
        if parts == 0 {
            return Some(None);
        }
        let mut stretches = Stretches::NONE;
        if !stretches.add_all(self, parts, probe.ray, range.0, range.1) {
            return Some(Some(range.0));
        }
        if stretches.len == 0 {
            return Some(None);
        }
        let mut at = range.0;
        let mut inside = stretches.contain(at);
        loop {
            let (end, t) = if inside { stretches.next_leave(at) } else { stretches.next_enter(at) };
            if t >= range.1 {
                return Some(None);
            }
            // Rounding may have put ends that lie close in the wrong order.
            if !stretches.is_alone(end, t) {
                return Some(Some(at));
            }
            let part = &self.parts[stretches.part[end] as usize];
            if !found(Counted { part, t })? {
                return Some(None);
            }
            (at, inside) = (t, !inside);
        }
    }
}
