//! Where a function first falls below zero along a ray.
//!
//! A root is sought on a grid, a stretch of the ray halved until the steps are below the accuracy; the hit is the first
//! point of the grid with a negative value. What the slopes prove free of roots is skipped, and where the function
//! falls all the way the grid point is found by interpolation, so that the place is the one that halving would find.
use std::ops::ControlFlow;

use raggio_function::Range;
use raggio_math::Ray;

use super::Isosurface;
use super::field::Stretch;

/// A stretch is halved at most this often.
const MOST_HALVINGS: u32 = 40;
/// Slopes that spread over more than this share of what the maximal gradient allows tell nothing.
const TELLING: f64 = 0.9;

/// The function along a ray, above the threshold or, with the sign turned, below it.
pub(super) struct Search<'a> {
    pub surface: &'a Isosurface,
    /// In the object's coordinates; its direction is as long as a world unit is there.
    pub ray: Ray,
    /// The length of the direction.
    pub stretch: f64,
    pub sign: f64,
    pub gradient: f64,
}

/// The points of a ray at which the function is looked at.
#[derive(Clone, Copy)]
struct Grid {
    start: f64,
    step: f64,
    count: u64,
}

impl Grid {
    /// From `start` to `end` in steps below the accuracy, a power of two of them.
    fn new(start: f64, end: f64, accuracy: f64) -> Grid {
        let mut grid = Grid { start, step: end - start, count: 1 };
        while grid.step >= accuracy && grid.count < 1 << MOST_HALVINGS {
            grid.step *= 0.5;
            grid.count *= 2;
        }
        grid
    }

    /// The first point that is not before `t`.
    fn not_before(&self, t: f64) -> u64 {
        (((t - self.start) / self.step).ceil() as u64).min(self.count)
    }

    /// The last point that is not after `t`.
    fn not_after(&self, t: f64) -> u64 {
        (((t - self.start) / self.step).floor() as u64).min(self.count)
    }
}

/// The function at a point of the grid.
#[derive(Clone, Copy)]
struct Sample {
    index: u64,
    t: f64,
    value: f64,
}

/// A part of the grid with the slopes that it may have; no slopes are those of the maximal gradient.
#[derive(Clone, Copy)]
struct Part {
    from: u64,
    to: u64,
    slope: Option<Range>,
}

impl Search<'_> {
    pub(super) fn value(&self, t: f64) -> f64 {
        self.sign * self.surface.value(self.ray.at(t))
    }

    fn sample(&self, grid: &Grid, index: u64) -> Sample {
        let t = grid.start + index as f64 * grid.step;
        Sample { index, t, value: self.value(t) }
    }

    /// The first root between `start`, where the function has a value, and `end`; those beyond `limit` may be left out.
    pub(super) fn first_root(&mut self, start: (f64, f64), end: f64, limit: f64) -> Option<f64> {
        let grid = Grid::new(start.0, end, self.surface.accuracy);
        let first = Sample { index: 0, t: start.0, value: start.1 };
        let Some(field) = &self.surface.field else {
            let last = self.sample(&grid, grid.count);
            return self.first(&grid, first, last, None).map(|s| s.t);
        };
        let (mut at, mut part) = (first, Part { from: 0, to: 0, slope: None });
        let ray = self.ray;
        let found = field.walk(&ray, (start.0, end.min(limit + grid.step)), |stretch| {
            let slope = self.telling_slope(&stretch);
            let empty = if self.sign > 0.0 { stretch.value.lo > 0.0 } else { stretch.value.hi < 0.0 };
            // The first point behind an empty stretch need not be above zero.
            let to = if empty && stretch.to < end {
                grid.not_after(stretch.to)
            } else {
                grid.not_before(stretch.to)
            };
            if to <= part.to {
                return ControlFlow::Continue(());
            }
            if !empty && slope.is_none() && part.slope.is_none() {
                part.to = to;
                return ControlFlow::Continue(());
            }
            if let Some(found) = self.in_part(&grid, &mut at, &part) {
                return ControlFlow::Break(found);
            }
            part =
                Part { from: if empty { to } else { part.to }, to, slope: if empty { None } else { slope } };
            ControlFlow::Continue(())
        });
        match found {
            ControlFlow::Break(found) => Some(found.t),
            ControlFlow::Continue(()) => self.in_part(&grid, &mut at, &part).map(|s| s.t),
        }
    }

    /// The slopes along a stretch, if they tell more than the maximal gradient.
    fn telling_slope(&self, stretch: &Stretch) -> Option<Range> {
        let most = self.gradient * self.stretch;
        let slope = if self.sign > 0.0 { stretch.slope } else { -stretch.slope };
        let slope = slope.meet(Range::within(most));
        (slope.width() < TELLING * 2.0 * most).then_some(slope)
    }

    /// Searches a part of the grid; `at` is the last sample before, and after it the part's end.
    fn in_part(&mut self, grid: &Grid, at: &mut Sample, part: &Part) -> Option<Sample> {
        if part.from >= part.to {
            return None;
        }
        let from = if at.index == part.from { *at } else { self.sample(grid, part.from) };
        *at = self.sample(grid, part.to);
        self.first(grid, from, *at, part.slope)
    }

    /// The first sample below zero between two of them.
    fn first(&mut self, grid: &Grid, a: Sample, b: Sample, slope: Option<Range>) -> Option<Sample> {
        if b.index - a.index <= 1 {
            return (b.value < 0.0).then_some(b);
        }
        self.learn((b.value - a.value).abs() / (self.stretch * (b.t - a.t)));
        let range = slope.unwrap_or(Range::within(self.gradient * self.stretch));
        if least(a, b, range) >= 0.0 && (slope.is_none() || b.value >= 0.0) {
            return None;
        }
        if range.hi <= 0.0 && a.value >= 0.0 && b.value < 0.0 {
            return Some(self.crossing(grid, a, b));
        }
        let middle = self.sample(grid, a.index.midpoint(b.index));
        // So far away that numbers are coarser than the accuracy.
        if !(a.t < middle.t && middle.t < b.t) {
            return (b.value < 0.0).then_some(b);
        }
        self.first(grid, a, middle, slope).or_else(|| self.first(grid, middle, b, slope))
    }

    /// The first sample below zero where the function falls all the way from `a`, not below zero, to `b`, below it.
    fn crossing(&self, grid: &Grid, mut a: Sample, mut b: Sample) -> Sample {
        let mut halve = 0;
        while b.index - a.index > 1 {
            let share = a.value / (a.value - b.value);
            let guess = grid.not_before(a.t + share * (b.t - a.t)).clamp(a.index + 1, b.index - 1);
            // Interpolation may creep along a bend.
            let index = if halve == 3 { a.index.midpoint(b.index) } else { guess };
            halve = (halve + 1) % 4;
            let middle = self.sample(grid, index);
            if middle.value < 0.0 {
                b = middle;
            } else {
                a = middle;
            }
        }
        b
    }

    /// `evaluate`: a steeper slope than expected raises the gradient.
    fn learn(&mut self, slope: f64) {
        if let Some(raggio_scene::IsosurfaceEvaluate { increase, .. }) = self.surface.evaluate
            && slope.is_finite()
            && self.gradient < slope * increase
        {
            self.gradient = slope * increase * increase;
        }
    }

    /// `evaluate`: a gradient above the minimum sinks from search to search.
    pub(super) fn relax(&mut self) {
        if let Some(raggio_scene::IsosurfaceEvaluate { minimum, decrease, .. }) = self.surface.evaluate
            && self.gradient > minimum
        {
            self.gradient *= decrease;
        }
    }
}

/// The least value that a function with slopes in a range can have between two samples.
fn least(a: Sample, b: Sample, slope: Range) -> f64 {
    if slope.lo >= 0.0 {
        return a.value;
    }
    if slope.hi <= 0.0 {
        return b.value;
    }
    // Where the steepest fall from a meets the steepest rise to b.
    let length = b.t - a.t;
    (slope.hi * a.value - slope.lo * b.value + slope.hi * slope.lo * length) / (slope.hi - slope.lo)
}
