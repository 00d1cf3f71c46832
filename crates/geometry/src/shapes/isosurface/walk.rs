//! A ray's way through the boxes of a field.
use raggio_math::{Ray, Vec3};

use super::field::{Cell, Field, Kind, MOST_LATE_CUTS};

/// Room for as many boxes as can wait.
const ROOM: usize = MOST_LATE_CUTS as usize + 2;

/// A ray's way through the boxes that are not cut, in their order.
pub(super) struct Walk<'a> {
    field: &'a Field,
    /// By axis; the fourth is none.
    origin: [f64; 4],
    inverse: [f64; 4],
    /// Bits of the axes along which the ray goes backwards: there the upper half of a box comes first.
    backwards: usize,
    /// Where the ray goes on, and where its way ends.
    at: f64,
    end: f64,
    /// Boxes to go on with, the next one last, and where the ray leaves them.
    waiting: [(&'a Cell, f64); ROOM],
    /// How many boxes wait.
    count: usize,
    /// The last box that was not free, and where the ray comes into it and leaves it.
    last: (&'a Cell, f64),
    from: f64,
}

impl<'a> Walk<'a> {
    /// The way of a ray, whose direction's inverse is known, between two parameters.
    #[inline]
    pub(super) fn new(field: &'a Field, ray: &Ray, inverse: Vec3, (from, end): (f64, f64)) -> Self {
        let back = |along: f64| usize::from(along.is_sign_negative());
        let root = field.root();
        Walk {
            field,
            origin: [ray.origin.x, ray.origin.y, ray.origin.z, 0.0],
            inverse: [inverse.x, inverse.y, inverse.z, 0.0],
            backwards: back(ray.dir.x) | back(ray.dir.y) << 1 | back(ray.dir.z) << 2,
            at: from,
            end,
            waiting: [(root, end); ROOM],
            count: 1,
            last: (root, end),
            from,
        }
    }

    /// The next box that is not cut, and the stretch of the ray in it.
    #[inline(always)]
    pub(super) fn next(&mut self) -> Option<(&'a Cell, (f64, f64))> {
        let (cell, to) = self.pop()?;
        let stretch = (self.at, to);
        self.at = to;
        Some((cell, stretch))
    }

    /// Remembers a box as the last that was not free.
    #[inline(always)]
    pub(super) fn remember(&mut self, cell: &'a Cell, (from, to): (f64, f64)) {
        (self.from, self.last) = (from, (cell, to));
    }

    /// The box that is not cut where the walk goes on, and where the ray leaves it. The parts around it that the ray
    /// comes to wait from then on.
    #[inline(always)]
    fn pop(&mut self) -> Option<(&'a Cell, f64)> {
        let mut count = self.count.checked_sub(1)?;
        let (mut cell, mut to) = *self.waiting.get(count)?;
        // Read once for each box: other threads may join its halves at any time.
        let mut kind = cell.kind();
        while kind < Kind::LATE {
            let halves = self.field.halves(cell);
            (cell, to) = self.step(cell, halves, kind.axis(), to, &mut count);
            kind = cell.kind();
        }
        self.count = count;
        Some((cell, to))
    }

    /// The half of a box where the walk goes on, and where the ray leaves it. The other half waits, if the ray comes there.
    #[inline(always)]
    fn step(
        &mut self,
        cell: &Cell,
        halves: &'a [Cell; 2],
        axis: usize,
        to: f64,
        count: &mut usize,
    ) -> (&'a Cell, f64) {
        let near = self.backwards >> axis & 1;
        // Along the plane this is infinite, with the sign that leads to the side where the ray is.
        let crossing = (cell.plane - self.origin[axis]) * self.inverse[axis];
        if crossing <= self.at {
            return (&halves[near ^ 1], to);
        }
        // Whether the other half is reached is hard to foresee, so it is written down in any case.
        if let Some(waiting) = self.waiting.get_mut(*count) {
            *waiting = (&halves[near ^ 1], to);
        }
        let comes_there = crossing < to;
        *count += usize::from(comes_there);
        (&halves[near], if comes_there { crossing } else { to })
    }

    /// The box that is not cut where the walk goes on, and where the ray leaves it.
    #[inline(never)]
    pub(super) fn here(&mut self) -> (&'a Cell, f64) {
        let here = self.pop().unwrap_or(self.last);
        self.push(here);
        here
    }

    #[inline]
    fn push(&mut self, next: (&'a Cell, f64)) {
        if let Some(waiting) = self.waiting.get_mut(self.count) {
            *waiting = next;
            self.count += 1;
        }
    }

    /// Goes on elsewhere; a long way back begins anew.
    #[inline]
    pub(super) fn go_to(&mut self, t: f64) {
        if t >= self.at {
            while self.count > 0 && self.waiting.get(self.count - 1).is_some_and(|&(_, to)| to <= t) {
                self.count -= 1;
            }
        } else if t >= self.from && self.last.1 == self.at {
            self.push(self.last);
        } else {
            self.count = 0;
            self.push((self.field.root(), self.end));
        }
        (self.from, self.at) = (t, t);
    }
}
