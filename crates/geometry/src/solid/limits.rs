//! The first hit of a combination on a ray, without a walk: where every part limits all others, as in intersections and
//! differences, what the parts so far leave of the ray's first way through is all that need be kept.
use raggio_math::Ray;

use super::{CLOSE, End, Solid};
use crate::body::Ready;

/// What the limits tell.
pub(super) enum First {
    /// No hit.
    Nothing,
    /// Ends lie so close that rounding may have put them in the wrong order.
    Unclear,
    Found {
        end: End,
        /// The only end after it that can be a hit, if it is known already.
        last: Option<End>,
    },
}

/// So often the search for the end of a way may begin again.
const MOST_WAYS: usize = 4;

/// The first way through, as far as it is known.
struct Way {
    enter: End,
    /// The greatest of the other ends at which it could have begun.
    rival_enter: f64,
    leave: End,
    rival_leave: f64,
    /// Another way through may follow.
    cut: bool,
}

#[inline(always)]
fn margin(t: f64) -> f64 {
    CLOSE * (1.0 + t.abs())
}

impl Way {
    const NOBODY: u32 = u32::MAX;

    #[inline(always)]
    fn begin_at(&mut self, end: End) {
        if end.t > self.enter.t {
            (self.rival_enter, self.enter) = (self.enter.t, end);
        } else if end.t > self.rival_enter && end.part != self.enter.part {
            self.rival_enter = end.t;
        }
    }

    /// Answers whether it now ends there.
    #[inline(always)]
    fn end_at(&mut self, end: End) -> bool {
        if end.t < self.leave.t {
            (self.rival_leave, self.leave) = (self.leave.t, end);
            return true;
        }
        if end.t < self.rival_leave {
            self.rival_leave = end.t;
        }
        false
    }

    /// Takes a stretch out; answers whether that is clear.
    #[inline(always)]
    fn without(&mut self, enter: End, leave: End, (from, to): (f64, f64)) -> bool {
        let start = if self.enter.t > from { self.enter.t } else { from };
        let close = margin(start);
        if leave.t < start - close || enter.t >= to || enter.t > self.leave.t + margin(self.leave.t) {
            return true;
        }
        if enter.t > start + close {
            self.cut |= self.end_at(enter);
            return true;
        }
        // Where the way begins just where this ends, another that covers both may yet make it clear.
        let covered = enter.t < start - close && (leave.t > start + close || self.enter.t > from);
        if covered {
            self.begin_at(leave);
        }
        covered
    }

    /// Does it begin beyond an end that was found when it began sooner?
    #[inline(always)]
    fn is_outdated(&self) -> bool {
        self.cut && self.leave.t < self.enter.t - margin(self.enter.t)
    }

    #[inline(always)]
    fn first(&self, (from, to): (f64, f64)) -> First {
        let enters = self.enter.t > from;
        let start = if enters { self.enter.t } else { from };
        let close = margin(start);
        if start >= to || (self.leave.t < start - close && !self.cut) {
            return First::Nothing;
        }
        if self.leave.t <= start + close {
            return First::Unclear;
        }
        let leave_is_clear = self.rival_leave - self.leave.t > margin(self.leave.t);
        let last = (leave_is_clear && !self.cut).then_some(self.leave);
        match enters {
            true if start - self.rival_enter <= close => First::Unclear,
            true => First::Found { end: self.enter, last },
            false if self.leave.t >= to => First::Nothing,
            false if !leave_is_clear => First::Unclear,
            false => First::Found { end: self.leave, last },
        }
    }
}

impl Solid {
    /// The first hit, for combinations whose parts all limit the others.
    #[inline(always)]
    pub(super) fn first(&self, ray: &Ray, range: (f64, f64)) -> First {
        let nobody = |t: f64| End { t, part: Way::NOBODY };
        let mut way = Way {
            enter: nobody(f64::NEG_INFINITY),
            rival_enter: f64::NEG_INFINITY,
            leave: nobody(f64::INFINITY),
            rival_leave: f64::INFINITY,
            cut: false,
        };
        let mut ready = Ready::new();
        let told = self.narrow(ray, range, &mut ready, &mut way);
        if told.is_none() && way.is_outdated() {
            return self.first_again(ray, range, &mut ready, &mut way);
        }
        told.unwrap_or_else(|| way.first(range))
    }

    /// Looks for the end of a way of which only the beginning is known so far.
    #[inline(never)]
    fn first_again(&self, ray: &Ray, range: (f64, f64), ready: &mut Ready, way: &mut Way) -> First {
        for _ in 0..MOST_WAYS {
            way.leave = End { t: f64::INFINITY, part: Way::NOBODY };
            (way.rival_leave, way.cut) = (f64::INFINITY, false);
            if let Some(told) = self.narrow(ray, range, ready, way) {
                return told;
            }
            if !way.is_outdated() {
                return way.first(range);
            }
        }
        First::Unclear
    }

    /// Takes from a way what the parts do not let through; answers at once if nothing is left, or it is not clear what.
    #[inline(always)]
    fn narrow(&self, ray: &Ray, range: (f64, f64), ready: &mut Ready, way: &mut Way) -> Option<First> {
        let end = |t: f64, part: u32| End { t, part };
        for (i, part) in (0u32..).zip(&self.parts) {
            let stretch = part.body.stretch(ray, ready);
            let (enter, leave) = (end(stretch.enter, i), end(stretch.leave, i));
            if part.holds == stretch.beyond {
                if !way.without(enter, leave, range) {
                    return Some(First::Unclear);
                }
                continue;
            }
            if stretch.enter >= range.1 || stretch.leave <= range.0 {
                return Some(First::Nothing);
            }
            way.begin_at(enter);
            // Nothing follows on the end of what holds.
            way.cut &= !way.end_at(leave);
        }
        None
    }
}
