//! The first point of a grid where a function that may rise and fall is below zero, between proved slopes.
//!
//! From a known value no slope leads below zero at once. Between two of them, what is left is looked at where the function
//! may be lowest (Piyavskii 1972, Shubert 1972), and once it is below zero somewhere, where it may have come there.
use raggio_function::Range;

use super::grid::Grid;
use super::search::Search;

/// Where on the ray, and what the function is not below there.
pub(super) type Known = (f64, f64);

/// Slopes on a stretch.
#[derive(Clone, Copy)]
pub(super) struct Slopes {
    highest: f64,
    /// Distance per value along the steepest fall and along the steepest rise, and per difference of slopes.
    fall: f64,
    rise: f64,
    width: f64,
}

impl Slopes {
    /// Slopes that rise somewhere.
    pub(super) fn new(range: Range) -> Self {
        let fall = -1.0 / range.lo.min(-f64::MIN_POSITIVE);
        Slopes { highest: range.hi, fall, rise: 1.0 / range.hi, width: 1.0 / range.width() }
    }

    /// Before which place the function is surely not below zero.
    #[inline(always)]
    fn not_yet(&self, (t, value): Known) -> f64 {
        if value > 0.0 { t + value * self.fall } else { f64::NEG_INFINITY }
    }

    /// Behind which place it is surely not below zero.
    #[inline(always)]
    fn no_more(&self, (t, value): Known) -> f64 {
        if value > 0.0 { t - value * self.rise } else { f64::INFINITY }
    }

    /// Where the steepest fall from one place meets the steepest rise to another.
    #[inline(always)]
    fn lowest(&self, a: Known, b: Known) -> f64 {
        a.0 + (a.1 - b.1 + self.highest * (b.0 - a.0)) * self.width
    }
}

impl Search<'_> {
    /// The first point below zero of those from `low` to `high`, which lie between two places; else the last place that
    /// was looked at.
    pub(super) fn first_of(
        &self,
        grid: &Grid,
        (mut low, mut high): (u64, u64),
        mut a: Known,
        b: Known,
        slopes: &Slopes,
    ) -> Result<u64, Known> {
        let end = slopes.no_more(b);
        loop {
            let start = slopes.not_yet(a);
            if start > end {
                return Err(a);
            }
            (low, high) = (grid.not_before(start).max(low), grid.not_before(end).min(high));
            if low > high {
                return Err(a);
            }
            let index = grid.not_before(slopes.lowest(a, b)).clamp(low, high);
            let t = grid.at(index);
            let at = (t, self.value(t));
            if at.1 < 0.0 {
                return Ok(self.first_before(grid, (low, index), a, at, slopes));
            }
            if low < index
                && let Ok(found) = self.first_of(grid, (low, index - 1), a, at, slopes)
            {
                return Ok(found);
            }
            (a, low) = (at, index + 1);
        }
    }

    /// The first point below zero from `low` to `high`, where the function is below zero.
    fn first_before(
        &self,
        grid: &Grid,
        (mut low, mut high): (u64, u64),
        mut a: Known,
        mut b: (f64, f64),
        slopes: &Slopes,
    ) -> u64 {
        let mut turn = 0;
        loop {
            low = grid.not_before(slopes.not_yet(a)).max(low);
            // What is so near to a place below zero is below it, too.
            high = grid.not_before(b.0 + b.1 * slopes.fall).min(high);
            if low >= high {
                return high;
            }
            turn += 1;
            let index = if turn % 4 == 0 || a.1 <= 0.0 {
                low.midpoint(high)
            } else {
                grid.not_before(a.0 + (b.0 - a.0) * a.1 / (a.1 - b.1)).clamp(low, high - 1)
            };
            let t = grid.at(index);
            let at = (t, self.value(t));
            if at.1 < 0.0 {
                (b, high) = (at, index);
                continue;
            }
            if low < index
                && let Ok(found) = self.first_of(grid, (low, index - 1), a, at, slopes)
            {
                return found;
            }
            (a, low) = (at, index + 1);
        }
    }
}
