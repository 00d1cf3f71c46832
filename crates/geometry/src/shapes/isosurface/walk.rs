//! A ray's way through the boxes of a field.
use raggio_math::Ray;
use smallvec::SmallVec;

use super::field::{Cell, Field, MOST_CUTS, NONE};

/// A ray's way through the boxes that are not cut, in their order.
pub(super) struct Walk<'a> {
    field: &'a Field,
    origin: [f64; 3],
    inverse: [f64; 3],
    /// Which half of a box comes first, by the axis of the cut.
    near: [usize; 3],
    /// Where the ray goes on, and where its way ends.
    at: f64,
    end: f64,
    /// Where the ray comes into the last box.
    from: f64,
    /// Boxes to go on with, the next one last, and where the ray leaves them.
    waiting: SmallVec<[(&'a Cell, f64); MOST_CUTS as usize + 1]>,
    /// The last box that was not free, and where the ray leaves it.
    last: (&'a Cell, f64),
}

impl<'a> Walk<'a> {
    /// The way of a ray between two parameters.
    #[inline]
    pub(super) fn new(field: &'a Field, ray: &Ray, (from, end): (f64, f64)) -> Self {
        let near = |along: f64| usize::from(along.is_sign_negative());
        let root = field.root();
        let mut waiting = SmallVec::new();
        waiting.push((root, end));
        Walk {
            field,
            origin: ray.origin.into(),
            inverse: ray.dir.recip().into(),
            near: [near(ray.dir.x), near(ray.dir.y), near(ray.dir.z)],
            from,
            at: from,
            end,
            waiting,
            last: (root, end),
        }
    }

    /// The next box that is not cut and where the stretch of the ray is not free, and this stretch.
    #[inline]
    pub(super) fn next(
        &mut self,
        mut is_free: impl FnMut(&Cell, (f64, f64)) -> bool,
    ) -> Option<(&'a Cell, (f64, f64))> {
        while let Some((mut cell, mut to)) = self.waiting.pop() {
            let from = self.at;
            while cell.axis != NONE {
                (cell, to) = self.half(cell, to);
            }
            self.at = to;
            if !is_free(cell, (from, to)) {
                (self.from, self.last) = (from, (cell, to));
                return Some((cell, (from, to)));
            }
        }
        None
    }

    /// The half of a box where the ray goes on, and where the ray leaves it. The other half waits, if the ray comes there.
    #[inline]
    fn half(&mut self, cell: &'a Cell, to: f64) -> (&'a Cell, f64) {
        let axis = usize::from(cell.axis);
        let halves = self.field.halves(cell);
        // Along the plane this is infinite, with the sign that leads to the side where the ray is.
        let crossing = (cell.plane - self.origin[axis]) * self.inverse[axis];
        let near = self.near[axis];
        if crossing <= self.at {
            (&halves[near ^ 1], to)
        } else if crossing < to {
            self.waiting.push((&halves[near ^ 1], to));
            (&halves[near], crossing)
        } else {
            (&halves[near], to)
        }
    }

    /// The box that is not cut where the walk goes on, and where the ray leaves it.
    #[inline]
    pub(super) fn here(&mut self) -> (&'a Cell, f64) {
        let (mut cell, mut to) = self.waiting.pop().unwrap_or(self.last);
        while cell.axis != NONE {
            (cell, to) = self.half(cell, to);
        }
        self.waiting.push((cell, to));
        (cell, to)
    }

    /// Goes on elsewhere; a long way back begins anew.
    #[inline]
    pub(super) fn go_to(&mut self, t: f64) {
        if t >= self.at {
            while self.waiting.last().is_some_and(|&(_, to)| to <= t) {
                self.waiting.pop();
            }
        } else if t >= self.from && self.last.1 == self.at {
            self.waiting.push(self.last);
        } else {
            self.waiting.clear();
            self.waiting.push((self.field.root(), self.end));
        }
        (self.from, self.at) = (t, t);
    }
}
