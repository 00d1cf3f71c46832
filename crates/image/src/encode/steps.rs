//! Rounding to bytes by a table of the values at which the byte changes: the same bytes as by the curve itself, without
//! a power for every channel of every pixel.
use super::dither::rounded;

/// Bits of a number that do not tell its part of 0..=1: an octave has 256 parts, so that of the usual curves none has more
/// than one step.
const REST: u32 = 15;
/// The part of 2^-20; what is below belongs to it.
const LOWEST: u32 = ((127 - 20) << 23) >> REST;
/// Parts that know where to begin; the last begins at 1.
const PARTS: usize = ((127 << 23) >> REST) as usize - LOWEST as usize + 1;

/// The values at which the encoded byte changes.
pub(super) struct Steps {
    /// By byte: the least value that gives it or more; the last is never reached.
    least: [f32; 257],
    /// By part of 0..=1: the byte at its beginning.
    start: Box<[u8; PARTS]>,
}

impl Steps {
    /// The steps of a rising curve.
    pub fn new(encode: impl Fn(f32) -> f32) -> Steps {
        let mut least = [f32::INFINITY; 257];
        for (byte, least) in least.iter_mut().enumerate().take(256) {
            *least = least_value(|v| usize::from(rounded(encode(v), 255.0)) >= byte);
        }
        let mut start = Box::new([0; PARTS]);
        for (part, start) in (LOWEST..).zip(start.iter_mut()).skip(1) {
            let v = f32::from_bits(part << REST);
            *start = least[1..256].partition_point(|&l| l <= v) as u8;
        }
        Steps { least, start }
    }

    /// The byte of a value. A NaN becomes 0.
    #[inline]
    pub fn byte(&self, v: f32) -> u8 {
        let v = if v > 0.0 { v.min(1.0) } else { 0.0 };
        let part = (v.to_bits() >> REST).saturating_sub(LOWEST) as usize;
        let mut byte = usize::from(self.start[part.min(PARTS - 1)]);
        // Whether there is a step is anybody's guess, whether there are two is not.
        byte += usize::from(v >= self.least[byte + 1]);
        while v >= self.least[byte + 1] {
            byte += 1;
        }
        byte as u8
    }
}

/// The least number from 0 to 1 of which something holds that holds of all greater ones; infinite if of none.
fn least_value(holds: impl Fn(f32) -> bool) -> f32 {
    let (mut below, mut above) = (0, 1f32.to_bits());
    if holds(0.0) {
        return 0.0;
    }
    if !holds(1.0) {
        return f32::INFINITY;
    }
    while above - below > 1 {
        let middle = (below + above) / 2;
        if holds(f32::from_bits(middle)) { above = middle } else { below = middle }
    }
    f32::from_bits(above)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::Curve;

    #[test]
    fn steps_give_the_bytes_of_their_curve() {
        for curve in [Curve::Srgb, Curve::Linear, Curve::Power(2.2), Curve::Power(0.5)] {
            let encode = |v: f32| Curve::Linear.convert(curve, v);
            let steps = Steps::new(encode);
            let mut values: Vec<f32> = (-50..4100).map(|i| i as f32 / 4000.0).collect();
            values.extend((0..2000).map(|i| (i as f32 / 2000.0).powi(5)));
            values.extend([f32::NAN, f32::INFINITY, f32::NEG_INFINITY, 1e30, 1e-30, 0.0031308]);
            for v in values {
                assert_eq!(u16::from(steps.byte(v)), rounded(encode(v), 255.0), "{curve:?} {v}");
            }
        }
    }
}
