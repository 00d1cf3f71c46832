//! Where a function first falls below zero along a ray.
//!
//! A root is sought on a grid, a stretch of the ray halved until the steps are below the accuracy; the hit is the first
//! point of the grid with a negative value. Where little is known of the function it is looked at as the scene's maximal
//! gradient demands. Elsewhere what the bounds prove free of roots is skipped, and where the function falls all the way
//! the grid point is found by interval Newton steps, so that the place is the one that halving would find.
use raggio_function::Range;
use raggio_math::Ray;

use super::Isosurface;
use super::field::{Model, Walk};
use super::grid::{Grid, Sample};

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
    /// Does what was not found so far surely not exist?
    pub proved: bool,
}

/// Where a search along known stretches stands.
struct Progress {
    /// The last point up to which nothing is left to be found, but for what is postponed.
    done: u64,
    /// Points after this one, up to `done`, are postponed: nothing is known of the slopes there.
    unknown_from: u64,
    /// The last sample, if the function was looked at.
    last: Option<Sample>,
}

impl Search<'_> {
    #[inline]
    pub(super) fn value(&self, t: f64) -> f64 {
        self.sign * self.surface.value(self.ray.at(t))
    }

    /// Where the function's value at a parameter lies: a single number, unless the walk, which begins there, tells
    /// enough.
    pub(super) fn where_value_is(
        &self,
        t: f64,
        walk: Option<&Walk>,
        enough: impl Fn(Range) -> bool,
    ) -> Range {
        let known = walk.map(|walk| walk.cell.value_at(self.ray.at(t))).filter(|&known| enough(known));
        known.unwrap_or_else(|| Range::one(self.surface.value(self.ray.at(t))))
    }

    fn sample(&self, grid: &Grid, index: u64) -> Sample {
        let t = grid.at(index);
        Sample { index, t, value: self.value(t) }
    }

    /// The first root between `start` and `end`, on the way that is known, if one is. The function's value at the start
    /// is found where it is needed, unless it is there.
    pub(super) fn first_root(
        &mut self,
        start: (f64, Option<f64>),
        end: f64,
        walk: Option<&mut Walk>,
    ) -> Option<f64> {
        let grid = Grid::new(start.0, end, self.surface.accuracy);
        let first = start.1.map(|value| Sample { index: 0, t: start.0, value });
        let Some(walk) = walk else {
            let first = first.unwrap_or_else(|| self.sample(&grid, 0));
            let last = self.sample(&grid, grid.count);
            let steepest = Range::within(self.gradient * self.stretch);
            return self.first(&grid, first, last, steepest).map(|s| s.t);
        };
        let mut progress = Progress { done: 0, unknown_from: 0, last: first };
        while !walk.over {
            if !self.is_free(walk) {
                let to = walk.stretch.1;
                let last = if to < end { grid.not_before(to).saturating_sub(1) } else { grid.count };
                let first = grid.not_before(walk.stretch.0).max(progress.done + 1);
                if first <= last
                    && let Some(index) =
                        self.in_stretch(&grid, (first, last), walk.cell.model(), &mut progress)
                {
                    return Some(grid.at(index));
                }
            }
            walk.advance();
        }
        self.postponed(&grid, &mut progress).map(|index| grid.at(index))
    }

    /// Is there surely nothing below zero where the walk stands?
    #[inline]
    fn is_free(&self, walk: &Walk) -> bool {
        if walk.cell.is_empty(self.sign) {
            return true;
        }
        // Between the ends the least possible value is not less than at one of them.
        let least = |t: f64| {
            let (middle, off) = walk.cell.model().at(self.ray.at(t));
            self.sign * middle - off
        };
        least(walk.stretch.0) >= 0.0 && least(walk.stretch.1) >= 0.0
    }

    /// The first of some points in a box that is below zero, or one that was postponed.
    #[inline]
    fn in_stretch(
        &mut self,
        grid: &Grid,
        (first, last): (u64, u64),
        model: &Model,
        progress: &mut Progress,
    ) -> Option<u64> {
        let ends = model.is_known().then(|| (self.known(grid, first, model), self.known(grid, last, model)));
        let slope = model.along(self.ray.dir * self.sign);
        if let Some((a, b)) = ends.filter(|_| slope.hi <= 0.0) {
            let before = self.postponed(grid, progress);
            (progress.done, progress.unknown_from) = (last, last);
            return before.or_else(|| self.falling(grid, a, b, slope));
        }
        let Some(((a, b), slope)) = ends.zip(self.telling(slope)) else {
            if progress.done + 1 < first || progress.unknown_from >= progress.done {
                if let Some(found) = self.postponed(grid, progress) {
                    return Some(found);
                }
                progress.unknown_from = first - 1;
            }
            progress.done = last;
            return None;
        };
        if let Some(found) = self.postponed(grid, progress) {
            return Some(found);
        }
        (progress.done, progress.unknown_from) = (last, last);
        self.bent(grid, a, b, slope)
    }

    /// Searches what was postponed.
    #[inline]
    fn postponed(&mut self, grid: &Grid, progress: &mut Progress) -> Option<u64> {
        if progress.unknown_from >= progress.done {
            return None;
        }
        self.proved = false;
        let from = progress.unknown_from;
        let a = progress.last.filter(|last| last.index == from).unwrap_or_else(|| self.sample(grid, from));
        let b = self.sample(grid, progress.done);
        (progress.unknown_from, progress.last) = (progress.done, Some(b));
        self.first(grid, a, b, Range::within(self.gradient * self.stretch)).map(|s| s.index)
    }

    /// What a box tells of the value at a point of the grid.
    #[inline]
    fn known(&self, grid: &Grid, index: u64, model: &Model) -> Known {
        let t = grid.at(index);
        let (middle, off) = model.at(self.ray.at(t));
        let middle = self.sign * middle;
        Known { index, t, value: Range { lo: middle - off, hi: middle + off } }
    }

    /// Slopes along the ray, if they tell more than the maximal gradient.
    #[inline]
    fn telling(&mut self, slope: Range) -> Option<Range> {
        let most = self.gradient * self.stretch;
        let met = slope.meet(Range::within(most));
        self.proved &= met == slope;
        (met.width() < TELLING * 2.0 * most).then_some(met)
    }

    /// The first point below zero where the function never rises: interval Newton steps (Moore, 1966) on whole points.
    fn falling(&self, grid: &Grid, a: Known, b: Known, slope: Range) -> Option<u64> {
        // Distances per value to a root: at least, at most, and in the middle.
        let (steep, flat) = (-1.0 / slope.lo, 1.0 / (-slope.hi).max(f64::MIN_POSITIVE));
        let typical = -2.0 / (slope.lo + slope.hi);
        let reach = |t: f64, value: f64, per_value: f64| grid.not_before(t + value * per_value);
        // The point that is sought is one of these; the one behind the last stands for none.
        // What may be below zero at once begins with the first of them: rounding must not go past it.
        let mut low = if a.value.lo > 0.0 { a.index.max(reach(a.t, a.value.lo, steep)) } else { a.index };
        let mut high = (b.index + 1).min(reach(a.t, a.value.hi.max(0.0), flat)).max(low);
        let mut guess = reach(a.t, a.value.middle(), typical);
        let mut turn = 0;
        while low < high {
            turn += 1;
            let index = if turn % 4 == 0 { low.midpoint(high) } else { guess }.clamp(low, high - 1);
            let at = self.sample(grid, index);
            let reach = |per_value: f64| reach(at.t, at.value, per_value);
            guess = reach(typical);
            if at.value < 0.0 {
                high = index.min(reach(steep));
                low = low.max(reach(flat)).min(high);
                // The point before may be the one where the sign changes.
                guess = guess.min(high.saturating_sub(1));
            } else {
                low = (index + 1).max(reach(steep));
                high = high.min(reach(flat)).max(low);
            }
        }
        (low <= b.index).then_some(low)
    }

    /// The first point below zero where the function may rise and fall.
    fn bent(&mut self, grid: &Grid, a: Known, b: Known, slope: Range) -> Option<u64> {
        let a = self.sample(grid, a.index);
        if a.value < 0.0 || a.index == b.index {
            return (a.value < 0.0).then_some(a.index);
        }
        let b = self.sample(grid, b.index);
        self.first(grid, a, b, slope).map(|s| s.index)
    }

    /// The first sample below zero between two of them, the first of which is not.
    fn first(&mut self, grid: &Grid, a: Sample, b: Sample, slope: Range) -> Option<Sample> {
        if b.index - a.index <= 1 {
            return (b.value < 0.0).then_some(b);
        }
        self.learn((b.value - a.value).abs() / (self.stretch * (b.t - a.t)));
        let slope =
            if self.surface.evaluate.is_some() { Range::within(self.gradient * self.stretch) } else { slope };
        if least(a, b, slope) >= 0.0 {
            return None;
        }
        let middle = self.sample(grid, a.index.midpoint(b.index));
        // So far away that numbers are coarser than the accuracy.
        if !(a.t < middle.t && middle.t < b.t) {
            return (b.value < 0.0).then_some(b);
        }
        self.first(grid, a, middle, slope).or_else(|| self.first(grid, middle, b, slope))
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

/// What is known of the function at a point of the grid without looking.
#[derive(Clone, Copy)]
struct Known {
    index: u64,
    t: f64,
    value: Range,
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
