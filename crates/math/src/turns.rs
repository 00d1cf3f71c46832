//! Elementary functions that patterns ask by the million: rounding without a call, sines without branches.
//!
//! Invariants: the same bits on every machine; numbers within reach of everyday coordinates are exact, others fall back
//! to the library's function.
use std::f64::consts::{FRAC_1_PI, TAU};

use crate::Vec3;

/// Added to a number below 2^51 it leaves the nearest whole number in the sum.
const ROUND: f64 = 6_755_399_441_055_744.0;
/// Numbers below this can be rounded so.
const REACH: f64 = 2_251_799_813_685_248.0;
/// Angles below this lose less than 1e-11 by being counted in turns.
const ANGLES: f64 = 1e5;

/// The greatest whole number that is not above `v`.
#[inline]
pub fn floor(v: f64) -> f64 {
    if v.abs() < REACH {
        let nearest = (v + ROUND) - ROUND;
        nearest - f64::from(u8::from(nearest > v))
    } else {
        v.floor()
    }
}

/// The part of a number above its floor, 0 to below 1.
#[inline]
pub fn fraction(v: f64) -> f64 {
    v - floor(v)
}

/// A number without its fraction.
#[inline]
pub fn trunc(v: f64) -> f64 {
    floor(v.abs()).copysign(v)
}

/// Each coordinate's [`floor`].
#[inline]
pub fn floors(p: Vec3) -> Vec3 {
    Vec3::new(floor(p.x), floor(p.y), floor(p.z))
}

/// `v % period`, to the bit. What is less than the period is left as it is without a call.
#[inline]
pub fn rest(v: f64, period: f64) -> f64 {
    if v.abs() < period { v } else { long_rest(v, period) }
}

/// Not inlined: the compiler would divide in any case, and choose afterwards.
#[cold]
#[inline(never)]
fn long_rest(v: f64, period: f64) -> f64 {
    v % period
}

/// `v.rem_euclid(period)`, to the bit, in the same way.
#[inline]
pub fn wrapped(v: f64, period: f64) -> f64 {
    let rest = rest(v, period);
    if rest < 0.0 { rest + period.abs() } else { rest }
}

/// What is left of `v` after whole `period`s, with the sign of `v`: `v % period`, to the last bit but a few.
#[inline]
pub fn remainder(v: f64, period: f64) -> f64 {
    const MANY: f64 = 1e3;
    let size = v.abs();
    let count = floor(size / period);
    if count < MANY { (size - count * period).max(0.0).copysign(v) } else { v % period }
}

/// sin(2 pi t) / t by powers of t squared, for t between -1/4 and 1/4.
const SINE: [f64; 10] = sine_series();

/// Taylor's: what follows is 3e-16 at a quarter turn.
const fn sine_series() -> [f64; 10] {
    let mut out = [0.0; 10];
    let (mut term, mut n) = (TAU, 0);
    while n < 10 {
        out[n] = term;
        let k = (2 * n + 2) as f64;
        term *= -TAU * TAU / (k * (k + 1.0));
        n += 1;
    }
    out
}

/// The sine of `t` whole turns, to 1e-15; for `t` beyond the reach of rounding any number between -1 and 1.
#[inline]
pub fn sin_turns(t: f64) -> f64 {
    let halves = t + t + ROUND;
    let g = (t - 0.5 * (halves - ROUND)).clamp(-0.25, 0.25);
    let mut sum = SINE[9];
    let square = g * g;
    for term in SINE[..9].iter().rev() {
        sum = sum * square + term;
    }
    // An odd number of half turns changes the sign.
    f64::from_bits((sum * g).to_bits() ^ (halves.to_bits() << 63))
}

/// The sine of an angle in radians, to 1e-11 for angles that patterns meet.
#[inline]
pub fn sin(angle: f64) -> f64 {
    if angle.abs() < ANGLES { sin_turns(angle * (0.5 * FRAC_1_PI)) } else { angle.sin() }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn rounding_agrees_with_the_library() {
        let near = (-4000..4000).map(|i| f64::from(i) * 0.37);
        let halves = (-40..40).map(|i| f64::from(i) * 0.5);
        let edges = [f64::INFINITY, -1e300, REACH, 1.0 - REACH, -1e-300, 0.99999999999999989, -0.0];
        for v in near.chain(halves).chain(edges) {
            assert_eq!(floor(v), v.floor(), "{v}");
            assert_eq!(trunc(v).to_bits(), v.trunc().to_bits(), "{v}");
            let (left, exact) = (remainder(v, 1.00001), v % 1.00001);
            assert!((left - exact).abs() < 1e-12 || left.is_nan() && exact.is_nan(), "{v}");
        }
        assert!(floor(f64::NAN).is_nan() && remainder(f64::NAN, 1.0).is_nan());
        assert_eq!(floors(Vec3::new(-0.5, 0.5, 7.0)), Vec3::new(-1.0, 0.0, 7.0));
        assert_eq!(fraction(-0.25), 0.75);
        for (v, period) in
            [(2.5, 3.0), (-2.5, 3.0), (7.5, 3.0), (-7.5, 3.0), (-0.0, 1.0), (2.5, -2.0), (-3.0, 3.0)]
        {
            assert_eq!(rest(v, period).to_bits(), f64::to_bits(v % period));
            assert_eq!(wrapped(v, period).to_bits(), v.rem_euclid(period).to_bits(), "{v} {period}");
        }
    }

    #[test]
    fn sines_agree_with_the_library() {
        for i in -20_000..20_000 {
            let t = f64::from(i) * 0.00137;
            assert!((sin_turns(t) - (TAU * t).sin()).abs() < 1e-13, "{t}");
            let angle = 3.0 * t;
            assert!((sin(angle) - angle.sin()).abs() < 1e-13, "{angle}");
        }
        assert!((sin_turns(0.25) - 1.0).abs() < 1e-15);
        assert!(sin_turns(1e17 + 64.0).abs() <= 1.0 && sin_turns(f64::NAN).is_nan());
        assert!((sin(2e7) - 2e7_f64.sin()).abs() < 1e-15);
        assert!((sin(-9e4) - (-9e4_f64).sin()).abs() < 1e-10);
    }
}
