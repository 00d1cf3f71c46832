//! Orbits of several points at once, by lanes.
use raggio_math::{Vec4, Wide};

use crate::shapes::{hypercomplex, quaternion};
use quaternion::Power;

/// How many orbits are followed together.
pub(in crate::shapes) const LANES: usize = 4;
/// A number for each of some orbits.
pub(in crate::shapes) type Lanes = [f64; LANES];

/// What orbits that can be followed together repeat.
#[derive(Clone, Copy)]
pub(in crate::shapes) enum Law {
    Quaternions(Power),
    /// Squares of hypercomplex numbers.
    Squares,
}

/// Orbits that start on a ray.
pub(in crate::shapes) struct Orbits {
    pub(super) law: Law,
    /// The number at the ray's beginning, and the change along it.
    pub(in crate::shapes) line: [Vec4; 2],
    pub(in crate::shapes) parameter: Vec4,
    pub(in crate::shapes) steps: u32,
    pub(in crate::shapes) escape: f64,
}

/// How some orbits end.
#[derive(Clone, Copy)]
pub(in crate::shapes) struct Ends {
    /// The steps at which they escape, or all steps.
    step: [u64; LANES],
    /// The squared sizes last looked at.
    size2: Lanes,
    /// What is known of their derivatives there: of quaternions the squares of their sizes, of hypercomplex numbers how
    /// fast half the squared size grows along the ray.
    pub(in crate::shapes) slope: Lanes,
}

impl Ends {
    pub(in crate::shapes) const NONE: Ends =
        Ends { step: [0; LANES], size2: [0.0; LANES], slope: [0.0; LANES] };

    /// The step at which an orbit escapes, or the number of steps, and the squared size last looked at.
    #[inline(always)]
    pub(super) fn last(&self, lane: usize) -> (u32, f64) {
        (self.step[lane] as u32, self.size2[lane])
    }

    /// Takes note of the squared size of an orbit, if that is bound still, and of whether it is from here on.
    #[inline(always)]
    pub(in crate::shapes) fn look(&mut self, lane: usize, bound: &mut [u64; LANES], size2: f64, escape: f64) {
        self.size2[lane] = choose(bound[lane], size2, self.size2[lane]);
        bound[lane] &= if size2 <= escape { u64::MAX } else { 0 };
        self.step[lane] = self.step[lane].wrapping_sub(bound[lane]);
    }
}

/// `a` where all bits are set, `b` where none is.
#[inline(always)]
pub(in crate::shapes) fn choose(bits: u64, a: f64, b: f64) -> f64 {
    f64::from_bits(a.to_bits() & bits | b.to_bits() & !bits)
}

/// The orbits from some places on a ray.
pub(super) struct From<'a>(pub(super) &'a Orbits, pub(super) Lanes);

impl Wide for From<'_> {
    type Output = Ends;

    #[inline(always)]
    fn run(self) -> Ends {
        let From(orbits, t) = self;
        match orbits.law {
            Law::Quaternions(Power::Square) => quaternion::follow_all(Power::Square, orbits, t),
            Law::Quaternions(Power::Cube) => quaternion::follow_all(Power::Cube, orbits, t),
            Law::Squares => hypercomplex::follow_squares(orbits, t),
        }
    }
}
