//! An outline swept straight from one plane to another: what prisms and letters have in common.
use raggio_math::{EPS, Vec2};

use super::collect::Collect;
use super::outline::Outline;
use super::plane_tree::Line;
use crate::LocalHit;

/// What of it a ray meets.
pub(super) enum Met {
    /// The cap at which it enters.
    Near,
    /// The cap at which it leaves.
    Far,
    /// The side, at a parameter of a piece of the outline.
    Side(u32, f64),
}

/// A ray seen along the way of the sweep.
pub(super) struct Seen {
    pub(super) origin: Vec2,
    pub(super) dir: Vec2,
    /// Where it comes to the first plane and to the second.
    pub(super) planes: (f64, f64),
    /// Are there caps, and does the ray run across them?
    pub(super) capped: bool,
    /// Are there sides?
    pub(super) sided: bool,
}

impl Seen {
    fn at(&self, t: f64) -> Vec2 {
        self.origin + self.dir * t
    }

    /// Hands over what the ray meets; `hit` makes the hit at a distance.
    #[inline]
    pub(super) fn search(
        &self,
        outline: &Outline,
        to: &mut impl Collect,
        hit: impl Fn(f64, Met) -> LocalHit,
    ) {
        let (near, far) = self.planes;
        let (lo, hi) = to.range();
        if far <= lo || near >= hi {
            return;
        }
        let enters = (self.capped && lo < near).then(|| outline.contains(self.at(near)));
        if enters == Some(true) {
            to.push(hit(near, Met::Near));
        }
        let slab = (near.max(lo), far.min(to.range().1));
        let sides = self.search_side(outline, slab, to, &hit);
        let asks_far = self.capped && lo < far && far < to.range().1;
        if !asks_far {
            return;
        }
        // Each side between the caps is a change between inside and outside.
        let leaves = match enters {
            Some(enters) if self.sided && slab == self.planes => enters != (sides % 2 == 1),
            _ => outline.contains(self.at(far)),
        };
        if leaves {
            to.push(hit(far, Met::Far));
        }
    }

    /// Answers how many sides there are between two distances.
    #[inline]
    fn search_side(
        &self,
        outline: &Outline,
        slab: (f64, f64),
        to: &mut impl Collect,
        hit: &impl Fn(f64, Met) -> LocalHit,
    ) -> u32 {
        let (o, d) = (self.origin, self.dir);
        let length = d.length_squared();
        let mut count = 0;
        // Level with the way of the sweep there is no side, nor behind a cap that has been met.
        if !self.sided || length < EPS * EPS || slab.0 >= slab.1 {
            return count;
        }
        let normal = Vec2::new(-d.y, d.x);
        let line = Line::new(normal, -normal.dot(o)).between(self.at(slab.0), self.at(slab.1));
        outline.crossings(&line, |piece, s, p| {
            let t = (p - o).dot(d) / length;
            if slab.0 <= t && t <= slab.1 {
                count += 1;
                to.push(hit(t, Met::Side(piece, s)));
            }
        });
        count
    }
}

/// Where `o + t d` comes to the first of two planes and to the second, and whether the upper one comes first; infinite
/// distances for what runs between them without an end, `None` for what runs outside.
#[inline]
pub(super) fn planes(o: f64, d: f64, (low, high): (f64, f64)) -> Option<((f64, f64), bool)> {
    if d == 0.0 {
        return (low <= o && o <= high).then_some(((f64::NEG_INFINITY, f64::INFINITY), false));
    }
    let (a, b) = ((low - o) / d, (high - o) / d);
    Some(if d < 0.0 { ((b, a), true) } else { ((a, b), false) })
}
