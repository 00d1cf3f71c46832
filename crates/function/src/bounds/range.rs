//! Intervals: where numbers lie.
use std::f64::consts::{FRAC_PI_2, PI, TAU};

/// The numbers from `lo` to `hi`, both included.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Range {
    /// The least number.
    pub lo: f64,
    /// The greatest number.
    pub hi: f64,
}

impl Range {
    /// Every number.
    pub const ALL: Range = Range { lo: f64::NEG_INFINITY, hi: f64::INFINITY };
    /// Only zero.
    pub const ZERO: Range = Range { lo: 0.0, hi: 0.0 };

    /// From the lesser to the greater; everything if either is not a number.
    #[inline]
    pub fn new(a: f64, b: f64) -> Range {
        if a <= b {
            Range { lo: a, hi: b }
        } else if b < a {
            Range { lo: b, hi: a }
        } else {
            Range::ALL
        }
    }

    /// One number.
    #[inline]
    pub fn one(v: f64) -> Range {
        Range::new(v, v)
    }

    /// As far to either side of zero.
    #[inline]
    pub fn within(size: f64) -> Range {
        Range::new(-size, size)
    }

    /// The middle.
    #[inline]
    pub fn middle(self) -> f64 {
        0.5 * (self.lo + self.hi)
    }

    /// How far the ends are apart.
    #[inline]
    pub fn width(self) -> f64 {
        self.hi - self.lo
    }

    /// The greatest distance from zero.
    #[inline]
    pub fn size(self) -> f64 {
        greater(self.hi, -self.lo)
    }

    /// Is nothing known?
    #[inline]
    pub fn is_all(self) -> bool {
        self.lo == f64::NEG_INFINITY && self.hi == f64::INFINITY
    }

    /// Does it hold the number?
    #[inline]
    pub fn contains(self, v: f64) -> bool {
        self.lo <= v && v <= self.hi
    }

    /// The smallest range around both.
    #[inline]
    pub fn hull(self, other: Range) -> Range {
        Range { lo: lesser(self.lo, other.lo), hi: greater(self.hi, other.hi) }
    }

    /// What both have in common; where rounding leaves nothing, this range.
    #[inline]
    pub fn meet(self, other: Range) -> Range {
        let (lo, hi) = (greater(self.lo, other.lo), lesser(self.hi, other.hi));
        if lo <= hi { Range { lo, hi } } else { self }
    }

    /// The products with a number that is neither zero nor infinite.
    #[inline]
    pub(super) fn scaled(self, k: f64) -> Range {
        let (a, b) = (self.lo * k, self.hi * k);
        if k > 0.0 { Range { lo: a, hi: b } } else { Range { lo: b, hi: a } }
    }

    /// The squares.
    #[inline]
    pub fn squared(self) -> Range {
        let (a, b) = (self.lo * self.lo, self.hi * self.hi);
        Range { lo: if self.contains(0.0) { 0.0 } else { a.min(b) }, hi: a.max(b) }
    }

    /// The inverses; everything if zero is among the numbers.
    #[inline]
    pub fn inverse(self) -> Range {
        if self.lo > 0.0 || self.hi < 0.0 {
            Range { lo: 1.0 / self.hi, hi: 1.0 / self.lo }
        } else if self.lo == 0.0 && self.hi > 0.0 {
            Range { lo: 1.0 / self.hi, hi: f64::INFINITY }
        } else {
            Range::ALL
        }
    }

    /// The values of a function that never falls.
    #[inline]
    pub fn rising(self, f: impl Fn(f64) -> f64) -> Range {
        Range::new(f(self.lo), f(self.hi))
    }

    /// The sines.
    pub fn sin(self) -> Range {
        let reaches = |peak: f64| ((self.lo - peak) / TAU).ceil() <= ((self.hi - peak) / TAU).floor();
        let (a, b) = (self.lo.sin(), self.hi.sin());
        Range {
            lo: if self.width() >= TAU || reaches(-FRAC_PI_2) { -1.0 } else { a.min(b) },
            hi: if self.width() >= TAU || reaches(FRAC_PI_2) { 1.0 } else { a.max(b) },
        }
    }

    /// The cosines.
    pub fn cos(self) -> Range {
        (self + Range::one(FRAC_PI_2)).sin()
    }

    /// The azimuths of the points of a rectangle without the origin, and whether they were counted beyond pi, because
    /// the rectangle lies across the seam.
    pub(super) fn azimuth(y: Range, x: Range) -> Option<(Range, bool)> {
        if x.contains(0.0) && y.contains(0.0) {
            return None;
        }
        let seam = x.hi < 0.0 && y.lo < 0.0 && y.hi >= 0.0;
        let angle = |y: f64, x: f64| {
            let angle = y.atan2(x);
            if seam && angle < 0.0 { angle + 2.0 * PI } else { angle }
        };
        let corners =
            [angle(y.lo, x.lo), angle(y.lo, x.hi), angle(y.hi, x.lo), angle(y.hi, x.hi)].map(Range::one);
        Some((corners.into_iter().reduce(Range::hull)?, seam))
    }
}

impl std::ops::Add for Range {
    type Output = Range;
    #[inline]
    fn add(self, o: Range) -> Range {
        Range { lo: self.lo + o.lo, hi: self.hi + o.hi }
    }
}

impl std::ops::Neg for Range {
    type Output = Range;
    #[inline]
    fn neg(self) -> Range {
        Range { lo: -self.hi, hi: -self.lo }
    }
}

impl std::ops::Sub for Range {
    type Output = Range;
    #[inline]
    fn sub(self, o: Range) -> Range {
        self + -o
    }
}

/// The lesser of two numbers, in one instruction where `f64::min` minds what is no number.
#[inline]
pub(super) fn lesser(a: f64, b: f64) -> f64 {
    if a < b { a } else { b }
}

/// The greater of two numbers.
#[inline]
pub(super) fn greater(a: f64, b: f64) -> f64 {
    if a > b { a } else { b }
}

/// The product, where nothing times anything is nothing.
#[inline]
fn times(a: f64, b: f64) -> f64 {
    if a == 0.0 || b == 0.0 { 0.0 } else { a * b }
}

impl std::ops::Mul for Range {
    type Output = Range;
    #[inline]
    fn mul(self, o: Range) -> Range {
        let mut p = [self.lo * o.lo, self.lo * o.hi, self.hi * o.lo, self.hi * o.hi];
        if !(p[0] + p[1] + p[2] + p[3]).is_finite() {
            p = [times(self.lo, o.lo), times(self.lo, o.hi), times(self.hi, o.lo), times(self.hi, o.hi)];
        }
        Range {
            lo: lesser(lesser(p[0], p[1]), lesser(p[2], p[3])),
            hi: greater(greater(p[0], p[1]), greater(p[2], p[3])),
        }
    }
}

impl std::ops::Mul<f64> for Range {
    type Output = Range;
    #[inline]
    fn mul(self, k: f64) -> Range {
        self * Range { lo: k, hi: k }
    }
}
