//! The hits of a merge on a ray, without a walk: where it is outside of all bodies the nearest beginning of a stretch is
//! next, and inside of any the end of the chain of stretches that overlap.
use raggio_math::Ray;

use super::{CLOSE, Counted, End, Solid};
use crate::body::Ready;

/// Merges of more bodies than this are walked.
pub(super) const MOST_UNITED: usize = 16;

/// The stretches of the bodies that are met in a range.
struct Stretches {
    enter: [f64; MOST_UNITED],
    leave: [f64; MOST_UNITED],
    part: [u32; MOST_UNITED],
    len: usize,
}

/// Ends lie so close that rounding may have put them in the wrong order.
struct Unclear;

#[inline(always)]
fn margin(t: f64) -> f64 {
    CLOSE * (1.0 + t.abs())
}

impl Stretches {
    /// All that reach into the range; `None` where one of them lies beyond its ends.
    #[inline(always)]
    fn of(solid: &Solid, ray: &Ray, (from, to): (f64, f64)) -> Option<Stretches> {
        let (none, nobody) = ([0.0; MOST_UNITED], [0; MOST_UNITED]);
        let mut all = Stretches { enter: none, leave: none, part: nobody, len: 0 };
        let mut ready = Ready::new();
        for (i, part) in (0u32..).zip(&solid.parts) {
            let stretch = part.body.stretch(ray, &mut ready);
            if stretch.beyond || all.len == MOST_UNITED {
                return None;
            }
            if stretch.leave > from && stretch.enter < to {
                (all.enter[all.len], all.leave[all.len]) = (stretch.enter, stretch.leave);
                all.part[all.len] = i;
                all.len += 1;
            }
        }
        Some(all)
    }

    /// Each with its place.
    #[inline(always)]
    fn iter(&self) -> impl Iterator<Item = (usize, f64, f64)> {
        let ends = self.enter.iter().zip(&self.leave);
        ends.take(self.len).enumerate().map(|(i, (&enter, &leave))| (i, enter, leave))
    }

    fn contain(&self, t: f64) -> bool {
        self.iter().any(|(_, enter, leave)| enter <= t && t < leave)
    }

    /// Where a ray that is outside comes in next.
    #[inline(always)]
    fn next_enter(&self, at: f64) -> Result<End, Unclear> {
        let (mut first, mut t) = (MOST_UNITED, f64::INFINITY);
        for (i, enter, _) in self.iter() {
            if enter > at && enter < t {
                (first, t) = (i, enter);
            }
        }
        if first == MOST_UNITED {
            return Ok(End { t, part: 0 });
        }
        let close = margin(t);
        let rival = |(i, enter, leave): (usize, f64, f64)| {
            if i == first { leave - t <= close } else { (enter - t).abs() <= close }
        };
        if self.iter().any(rival) { Err(Unclear) } else { Ok(End { t, part: self.part[first] }) }
    }

    /// Where a ray that is inside comes out.
    #[inline(always)]
    fn next_leave(&self, at: f64) -> Result<End, Unclear> {
        let (mut last, mut t) = (MOST_UNITED, at);
        loop {
            // A stretch that begins hardly before the others end may not overlap with them at all.
            let surely = if last == MOST_UNITED { at } else { t - margin(t) };
            let mut longer = (last, t);
            for (i, enter, leave) in self.iter() {
                if enter <= surely && leave > longer.1 {
                    longer = (i, leave);
                }
            }
            if longer.0 == last {
                break;
            }
            (last, t) = longer;
        }
        let close = margin(t);
        let rival = |(i, enter, leave): (usize, f64, f64)| {
            i != last && ((enter - t).abs() <= close || (leave - t).abs() <= close)
        };
        if last == MOST_UNITED || self.iter().any(rival) {
            return Err(Unclear);
        }
        Ok(End { t, part: self.part[last] })
    }
}

impl Solid {
    /// [`Solid::sweep`] for merges. Answers the distance from which a walk has to go on, if it cannot tell all.
    #[inline]
    pub(super) fn united(
        &self,
        ray: &Ray,
        range: (f64, f64),
        mut found: impl FnMut(Counted<'_>) -> Option<bool>,
    ) -> Option<Option<f64>> {
        let mut at = range.0;
        let Some(stretches) = Stretches::of(self, ray, range) else { return Some(Some(at)) };
        if stretches.len == 0 {
            return Some(None);
        }
        let mut inside = stretches.contain(at);
        loop {
            let next = if inside { stretches.next_leave(at) } else { stretches.next_enter(at) };
            let Ok(End { t, part }) = next else { return Some(Some(at)) };
            if t >= range.1 || !found(Counted { part: &self.parts[part as usize], t })? {
                return Some(None);
            }
            (at, inside) = (t, !inside);
        }
    }
}
