//! A ray's way through the boxes of a field.
use raggio_math::{Ray, Vec3};

use super::field::{Cell, Field, Kind, MOST_LATE_CUTS};

/// Room for as many boxes as can wait.
const ROOM: usize = MOST_LATE_CUTS as usize + 2;

/// A ray along one axis.
#[derive(Clone, Copy)]
struct AxisRay {
    origin: f64,
    inverse: f64,
    /// Which half of a box comes first: the upper one where the ray goes backwards.
    near: usize,
}

impl AxisRay {
    #[inline(always)]
    fn new(origin: f64, along: f64, inverse: f64) -> Self {
        AxisRay { origin, inverse, near: usize::from(along.is_sign_negative()) }
    }
}

/// A ray's way through the boxes that are not cut, in their order.
pub(super) struct Walk<'a> {
    field: &'a Field,
    /// The fourth is none.
    axes: [AxisRay; 4],
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
    #[inline(always)]
    pub(super) fn new(field: &'a Field, ray: &Ray, inverse: Vec3, (from, end): (f64, f64)) -> Self {
        let Ray { origin, dir } = ray;
        let axes = [
            AxisRay::new(origin.x, dir.x, inverse.x),
            AxisRay::new(origin.y, dir.y, inverse.y),
            AxisRay::new(origin.z, dir.z, inverse.z),
            AxisRay::new(0.0, 0.0, 0.0),
        ];
        let root = field.root();
        Walk { field, axes, at: from, end, waiting: [(root, end); ROOM], count: 1, last: (root, end), from }
    }

    /// The next box that is not cut and where the stretch of the ray is not free, and this stretch.
    #[inline]
    pub(super) fn next(
        &mut self,
        mut is_free: impl FnMut(&Cell, (f64, f64)) -> bool,
    ) -> Option<(&'a Cell, (f64, f64))> {
        while let Some((cell, to)) = self.pop() {
            let stretch = (self.at, to);
            self.at = to;
            if !is_free(cell, stretch) {
                (self.from, self.last) = (stretch.0, (cell, to));
                return Some((cell, stretch));
            }
        }
        None
    }

    /// The box that is not cut where the walk goes on, and where the ray leaves it. The parts around it that the ray
    /// comes to wait from then on.
    #[inline(always)]
    fn pop(&mut self) -> Option<(&'a Cell, f64)> {
        let mut count = self.count.checked_sub(1)?;
        let (mut cell, mut to) = *self.waiting.get(count)?;
        let from = self.at;
        while cell.kind < Kind::Open {
            let Some(halves) = self.field.halves(cell) else { break };
            let axis = &self.axes[cell.kind.axis()];
            let near = axis.near & 1;
            // Along the plane this is infinite, with the sign that leads to the side where the ray is.
            let crossing = (cell.plane - axis.origin) * axis.inverse;
            if crossing <= from {
                cell = &halves[near ^ 1];
                continue;
            }
            cell = &halves[near];
            // Whether the other half is reached is hard to foresee, so it is written down in any case.
            if let Some(waiting) = self.waiting.get_mut(count) {
                *waiting = (&halves[near ^ 1], to);
            }
            let comes_there = crossing < to;
            count += usize::from(comes_there);
            to = if comes_there { crossing } else { to };
        }
        self.count = count;
        Some((cell, to))
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
