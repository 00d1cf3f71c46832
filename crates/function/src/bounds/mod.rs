//! Bounds of a function over a box: where its values lie, and where its partial derivatives do.
//!
//! Interval arithmetic with forward differentiation (Moore, Kearfott and Cloud, "Introduction to Interval Analysis",
//! 2009). Every rule here encloses the exact result, but for the last digits, which are not rounded outwards.
mod elementary;
mod enclose;
mod lattice;
pub(crate) mod noise;
mod range;

use elementary::each;
pub use range::Range;

/// How many variables slopes are kept for.
pub const VARIABLES: usize = 3;

/// What is known of a quantity over a box.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Bounds {
    /// Its values. If that is everything, it may even be no number.
    pub value: Range,
    /// Its slopes along the variables: every difference quotient within the box lies there.
    pub slopes: [Range; VARIABLES],
    /// If not zero, the value is known only but for whole multiples of that many turns (2 pi).
    turns: f64,
}

impl Bounds {
    /// Nothing is known.
    pub const UNKNOWN: Bounds = Bounds { value: Range::ALL, slopes: [Range::ALL; VARIABLES], turns: 0.0 };

    /// A number.
    #[inline]
    pub fn constant(v: f64) -> Bounds {
        Bounds::new(Range::one(v), [Range::ZERO; VARIABLES])
    }

    /// One of the variables, within a range.
    pub fn variable(axis: usize, range: Range) -> Bounds {
        let slopes = each(|k| Range::one(f64::from(u8::from(k == axis))));
        Bounds::new(range, slopes)
    }

    #[inline]
    fn new(value: Range, slopes: [Range; VARIABLES]) -> Bounds {
        Bounds { value, slopes, turns: 0.0 }
    }

    /// A value that may jump.
    fn jumping(value: Range) -> Bounds {
        Bounds::new(value, [Range::ALL; VARIABLES])
    }

    /// The number that it is, if it is one.
    fn as_constant(&self) -> Option<f64> {
        (self.value.lo == self.value.hi && self.slopes == [Range::ZERO; VARIABLES]).then_some(self.value.lo)
    }

    /// Can nothing be told from the value?
    #[inline]
    pub fn is_vague(&self) -> bool {
        self.turns != 0.0 || self.value.is_all()
    }

    /// The bounds as they count outside: an angle known but for whole turns is not known.
    pub(crate) fn settled(self) -> Bounds {
        if self.turns == 0.0 { self } else { Bounds::UNKNOWN }
    }

    /// The value of a function of this, whose derivative lies in a range.
    #[inline]
    pub fn through(&self, value: Range, derivative: Range) -> Bounds {
        Bounds::new(value, each(|k| self.slopes[k] * derivative))
    }

    /// The value of a function of a point, whose partial derivatives lie in ranges.
    pub fn of_point(value: Range, gradient: [Range; VARIABLES], at: &[Bounds; VARIABLES]) -> Bounds {
        let slope = |v: usize| {
            let part = |k: usize| gradient[k] * at[k].slopes[v];
            part(0) + part(1) + part(2)
        };
        Bounds::new(value, each(slope))
    }

    /// Either of two, with a jump between them.
    fn either(self, other: Bounds) -> Bounds {
        if self.is_vague() || other.is_vague() {
            return Bounds::UNKNOWN;
        }
        Bounds::jumping(self.value.hull(other.value))
    }
}
