//! Sums of noise over octaves (textures spec, section 1.5).
use super::{clamp01, doctaves, octaves};
use crate::Vec3;

/// The most octaves that count.
const MOST: usize = 10;

/// Octaves outside this range are clipped to it.
fn octaves_in_range(octaves: u32) -> usize {
    (octaves as usize).clamp(1, MOST)
}

/// Scalar turbulence: `octaves` (1 to 10) of noise, each `lambda` times finer and `omega` times weaker than the one
/// before. Not normalised. `omega` and `lambda` are single precision because the language keeps them so.
pub fn turbulence(generator: u8, p: Vec3, octaves_wanted: u32, omega: f32, lambda: f32) -> f64 {
    let mut values = [0.0; MOST];
    let values = &mut values[..octaves_in_range(octaves_wanted)];
    octaves(generator, p, 1.0, lambda.into(), values);
    let octave = |n: f64| if generator == 1 { n } else { 2.0 * n - 0.5 };
    let omega = f64::from(omega);
    let mut sum = clamp01(octave(values[0]));
    let mut weight = omega;
    for n in values[1..].iter().copied() {
        sum += weight * octave(n);
        weight *= omega;
    }
    sum
}

/// Vector turbulence: octaves of [`dnoise`](super::dnoise) summed in the same way.
pub fn dturbulence(p: Vec3, octaves: u32, omega: f32, lambda: f32) -> Vec3 {
    let mut values = [Vec3::ZERO; MOST];
    let values = &mut values[..octaves_in_range(octaves)];
    doctaves(p, 1.0, lambda.into(), values);
    let (mut sum, mut weight) = (Vec3::ZERO, 1.0);
    for value in values {
        sum += *value * weight;
        weight *= f64::from(omega);
    }
    sum
}
