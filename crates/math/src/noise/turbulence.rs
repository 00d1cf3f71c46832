//! Sums of noise over octaves (textures spec, section 1.5).
use super::{clamp01, dnoise, noise};
use crate::Vec3;

/// Octaves outside this range are clipped to it.
fn octaves_in_range(octaves: u32) -> u32 {
    octaves.clamp(1, 10)
}

/// Scalar turbulence: `octaves` (1 to 10) of noise, each `lambda` times finer and `omega` times weaker than the one
/// before. Not normalised. `omega` and `lambda` are single precision because the language keeps them so.
pub fn turbulence(generator: u8, p: Vec3, octaves: u32, omega: f32, lambda: f32) -> f64 {
    // Chosen once, not once an octave.
    match generator {
        1 => sum_octaves(|q| noise(1, q), p, octaves, omega, lambda),
        3 => sum_octaves(|q| 2.0 * noise(3, q) - 0.5, p, octaves, omega, lambda),
        _ => sum_octaves(|q| 2.0 * noise(2, q) - 0.5, p, octaves, omega, lambda),
    }
}

fn sum_octaves(octave: impl Fn(Vec3) -> f64, p: Vec3, octaves: u32, omega: f32, lambda: f32) -> f64 {
    let (omega, lambda) = (f64::from(omega), f64::from(lambda));
    let mut sum = clamp01(octave(p));
    let (mut weight, mut scale) = (omega, lambda);
    for _ in 1..octaves_in_range(octaves) {
        sum += weight * octave(p * scale);
        weight *= omega;
        scale *= lambda;
    }
    sum
}

/// Vector turbulence: octaves of [`dnoise`] summed in the same way.
pub fn dturbulence(p: Vec3, octaves: u32, omega: f32, lambda: f32) -> Vec3 {
    let (omega, lambda) = (f64::from(omega), f64::from(lambda));
    let mut sum = dnoise(p);
    let (mut weight, mut scale) = (omega, lambda);
    for _ in 1..octaves_in_range(octaves) {
        sum += dnoise(p * scale) * weight;
        weight *= omega;
        scale *= lambda;
    }
    sum
}
