//! Where a function first falls below zero along a ray.
//!
//! A root is sought on a grid, a stretch of the ray halved until the steps are below the accuracy; the hit is the first
//! point of the grid with a negative value. Where little is known of the function it is looked at as the scene's maximal
//! gradient demands. Elsewhere what the bounds prove free of roots is skipped, and where the function falls all the way
//! the grid point is found by interval Newton steps, so that the place is the one that halving would find.
use raggio_function::Range;
use raggio_math::{Ray, Vec3};

use super::Isosurface;
use super::field::{Cell, Model};
use super::grid::{Grid, Sample};
use super::walk::Walk;

/// Slopes that spread over more than this share of what the maximal gradient allows tell nothing.
pub(super) const TELLING: f64 = 0.9;

/// The function along a ray, above the threshold or, with the sign turned, below it.
pub(super) struct Search<'a> {
    surface: &'a Isosurface,
    /// In the object's coordinates; its direction is as long as a world unit is there.
    ray: &'a Ray,
    /// The sizes of the direction's parts, and its length.
    sizes: Vec3,
    stretch: f64,
    pub sign: f64,
    pub gradient: f64,
    /// Does what was not found so far surely not exist?
    pub proved: bool,
}

/// Where a search along known stretches stands.
struct Progress {
    /// The last point up to which nothing is left to be found, but for what is postponed.
    done: i64,
    /// Points after this one, up to `done`, are postponed: nothing is known of the slopes there.
    unknown_from: i64,
    /// The last sample, if the function was looked at.
    last: Option<Sample>,
    /// What the value is surely not below where the walk stands.
    least: f64,
}

impl<'a> Search<'a> {
    pub(super) fn new(surface: &'a Isosurface, ray: &'a Ray) -> Self {
        let stretch = ray.dir.length();
        Search {
            surface,
            ray,
            sizes: ray.dir.abs(),
            stretch,
            sign: 1.0,
            gradient: surface.max_gradient,
            proved: true,
        }
    }

    #[inline]
    pub(super) fn value(&self, t: f64) -> f64 {
        self.sign * self.surface.value(self.ray.at(t))
    }

    /// Where a search begins that may begin at a parameter or at zero, where the walk does, and where the function's
    /// value lies there: a single number, unless its sign is known without looking.
    pub(super) fn start(&self, enter: f64, walk: Option<&mut Walk>) -> (f64, Range) {
        let (start, accuracy) = (enter.max(0.0), self.surface.accuracy);
        let is_signed = |value: Range| !value.contains(0.0);
        let Some(walk) = walk else { return self.start_unknown(start) };
        if start >= accuracy {
            return (start, self.where_value_is(start, walk, is_signed));
        }
        // A ray that starts on the surface must not meet it again at once.
        let close = self.close();
        let is_clear = |value: Range| value.size() < close || value.lo >= close || value.hi <= -close;
        let value = self.where_value_is(start, walk, is_clear);
        let is_close = value.size() < close;
        if !is_close {
            return (start, value);
        }
        let next = 5.0 * accuracy;
        let (cell, to) = walk.here();
        walk.go_to(next);
        let slope = cell.model().along(self.ray.dir);
        let known = value + slope * (next - start);
        if next < to && cell.model().is_known() && is_signed(known) {
            return (next, known);
        }
        (next, self.where_value_is(next, walk, is_signed))
    }

    /// The same where nothing is known of the function.
    fn start_unknown(&self, start: f64) -> (f64, Range) {
        let there = |t: f64| (t, Range::one(self.surface.value(self.ray.at(t))));
        let first = there(start);
        if start < self.surface.accuracy && first.1.size() < self.close() {
            return there(5.0 * self.surface.accuracy);
        }
        first
    }

    /// Values below this are those of points on the surface.
    fn close(&self) -> f64 {
        4.0 * self.gradient * self.surface.accuracy
    }

    /// Where the function's value at a parameter lies: a single number, unless the walk, which begins there, tells
    /// enough.
    #[inline]
    fn where_value_is(&self, t: f64, walk: &mut Walk, enough: impl Fn(Range) -> bool) -> Range {
        let p = self.ray.at(t);
        let known = walk.here().0.value_at(p);
        if enough(known) { known } else { Range::one(self.surface.value(p)) }
    }

    fn sample(&self, grid: &Grid, index: i64) -> Sample {
        let t = grid.at(index);
        Sample { index, t, value: self.value(t) }
    }

    /// The first root between a start, where the value lies in a range if anything is known of it, and `end`, on the way
    /// that is known, if one is.
    pub(super) fn first_root(
        &mut self,
        (start, value): (f64, Range),
        end: f64,
        walk: Option<&mut Walk>,
    ) -> Option<f64> {
        let grid = Grid::new(start, end, self.surface.accuracy);
        let value = if self.sign < 0.0 { Range { lo: -value.hi, hi: -value.lo } } else { value };
        let first = (value.lo == value.hi).then_some(Sample { index: 0, t: start, value: value.lo });
        let Some(walk) = walk else {
            let first = first.unwrap_or_else(|| self.sample(&grid, 0));
            let last = self.sample(&grid, grid.count);
            let steepest = Range::within(self.gradient * self.stretch);
            return self.first(&grid, first, last, steepest).map(|s| s.t);
        };
        let mut progress = Progress { done: 0, unknown_from: 0, last: first, least: value.lo };
        while let Some((cell, stretch)) = walk.next() {
            if self.is_free(cell, stretch, &mut progress.least) {
                continue;
            }
            walk.remember(cell, stretch);
            let last = if stretch.1 < end { (grid.not_before(stretch.1) - 1).max(0) } else { grid.count };
            let first = grid.not_before(stretch.0).max(progress.done + 1);
            // Behind a stretch that is not free the value may be anything.
            let entry = (stretch.0, std::mem::replace(&mut progress.least, f64::NEG_INFINITY));
            if first <= last {
                let found = self.in_stretch(&grid, (first, last), entry, cell, &mut progress);
                if let Some(index) = found {
                    return Some(grid.at(index));
                }
            }
        }
        self.postponed(&grid, &mut progress).map(|index| grid.at(index))
    }

    /// Is there surely nothing below zero in a stretch of a box? The value where it begins is not below `least`, which is
    /// then made to hold for its end.
    #[inline(always)]
    fn is_free(&self, cell: &Cell, (from, to): (f64, f64), least: &mut f64) -> bool {
        if cell.is_positive(self.sign) {
            *least = 0.0;
            return true;
        }
        let (model, length) = (cell.model(), to - from);
        let (rise, off) = model.change(self.ray.dir, self.sizes);
        let rise = self.sign * rise;
        let slope = Range { lo: rise - off, hi: rise + off };
        if *least >= 0.0 && slope.lo >= 0.0 {
            *least += slope.lo * length;
            return true;
        }
        let (entry, from_centre) = model.near(self.ray.at(from));
        let entry = self.sign * entry;
        let exit = entry + rise * length;
        let entry = entry - model.off_at(from_centre);
        let exit = exit - model.off_at(from_centre + self.ray.dir * length);
        // Between the ends what the model allows is not less than at one of them.
        let is_convex = entry >= 0.0 && exit >= 0.0;
        let entry = greater(entry, *least);
        let exit = greater(exit, *least + slope.lo * length);
        let is_free = entry >= 0.0 && exit >= 0.0 && (is_convex || lowest(entry, exit, length, slope) >= 0.0);
        if is_free {
            *least = exit;
        }
        is_free
    }

    /// The first of some points in a box that is below zero, or one that was postponed. Where the ray enters the box
    /// the value is not below what `entry` says.
    #[inline]
    fn in_stretch(
        &mut self,
        grid: &Grid,
        (first, last): (i64, i64),
        entry: (f64, f64),
        cell: &Cell,
        progress: &mut Progress,
    ) -> Option<i64> {
        let model = cell.model();
        let ends = model.is_known().then(|| (self.known(grid, first, model), self.known(grid, last, model)));
        let slope = model.along(self.ray.dir * self.sign);
        if let Some((a, b)) = ends.filter(|_| slope.hi <= 0.0) {
            let before = self.postponed(grid, progress);
            (progress.done, progress.unknown_from) = (last, last);
            return if before.is_some() { before } else { self.falling(grid, a, b, slope) };
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
        if let Some(field) = &self.surface.field {
            field.note_search(cell);
        }
        let least = a.value.lo.max(entry.1 + slope.lo * (a.t - entry.0));
        self.bent(grid, Known { value: Range { lo: least, ..a.value }, ..a }, b, slope)
    }

    /// Searches what was postponed.
    #[inline]
    fn postponed(&mut self, grid: &Grid, progress: &mut Progress) -> Option<i64> {
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
    fn known(&self, grid: &Grid, index: i64, model: &Model) -> Known {
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
    fn falling(&self, grid: &Grid, a: Known, b: Known, slope: Range) -> Option<i64> {
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
                // A search that begins below zero ends with its first point, whatever is known before it.
                high = index.min(reach(steep)).max(a.index);
                low = low.max(reach(flat)).min(high);
                // The point before may be the one where the sign changes.
                guess = guess.min(high - 1);
            } else {
                low = (index + 1).max(reach(steep));
                high = high.min(reach(flat)).max(low);
            }
        }
        (low <= b.index).then_some(low)
    }

    /// The first point below zero where the function may rise and fall.
    fn bent(&mut self, grid: &Grid, a: Known, b: Known, slope: Range) -> Option<i64> {
        let a = if a.value.lo >= 0.0 {
            Sample { index: a.index, t: a.t, value: a.value.lo }
        } else {
            self.sample(grid, a.index)
        };
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
        if lowest(a.value, b.value, b.t - a.t, slope) >= 0.0 {
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
    index: i64,
    t: f64,
    value: Range,
}

/// The greater of two numbers; the second, if one is none.
#[inline(always)]
fn greater(a: f64, b: f64) -> f64 {
    if a > b { a } else { b }
}

/// The least value that a function with slopes in a range can have on a way between two values.
#[inline]
fn lowest(a: f64, b: f64, length: f64, slope: Range) -> f64 {
    if slope.lo >= 0.0 {
        return a;
    }
    if slope.hi <= 0.0 {
        return b;
    }
    // Where the steepest fall from a meets the steepest rise to b.
    (slope.hi * a - slope.lo * b + slope.hi * slope.lo * length) / (slope.hi - slope.lo)
}
