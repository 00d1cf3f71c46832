//! The points of a ray at which an isosurface's function counts.

/// A stretch is halved at most this often.
const MOST_HALVINGS: i32 = 40;

/// Points at equal distances, a power of two of steps.
#[derive(Clone, Copy, Debug)]
pub(super) struct Grid {
    start: f64,
    step: f64,
    per_step: f64,
    /// The number of steps.
    pub count: i64,
}

/// The function at a point of the grid.
#[derive(Clone, Copy, Debug)]
pub(super) struct Sample {
    pub index: i64,
    pub t: f64,
    pub value: f64,
}

impl Grid {
    /// From `start` to `end`, halved until the steps are below the accuracy.
    #[inline]
    pub(super) fn new(start: f64, end: f64, accuracy: f64) -> Grid {
        let length = end - start;
        let steps = length / accuracy;
        let halvings = if steps >= 1.0 { (exponent(steps) + 1).min(MOST_HALVINGS) } else { 0 };
        let count = 1_i64 << halvings;
        Grid { start, step: length / count as f64, per_step: count as f64 / length, count }
    }

    /// Where a point is.
    #[inline]
    pub(super) fn at(&self, index: i64) -> f64 {
        self.start + index as f64 * self.step
    }

    /// The first point that is not before `t`; beyond the last one if there is none.
    #[inline]
    pub(super) fn not_before(&self, t: f64) -> i64 {
        let steps = (t - self.start) * self.per_step;
        let whole = steps as i64;
        // Rounding up without a call of the system's library.
        whole.saturating_add(i64::from((whole as f64) < steps)).clamp(0, self.count + 1)
    }
}

/// The exponent of a positive number's power of two.
#[inline]
fn exponent(v: f64) -> i32 {
    ((v.to_bits() >> 52) & 0x7ff) as i32 - 1023
}
