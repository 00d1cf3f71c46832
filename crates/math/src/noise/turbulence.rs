//! Sums of noise over octaves (textures spec, section 1.5).
use super::lattice::{self, Octaves};
use super::{MOST_OCTAVES, clamp01, octave_groups};
use crate::Vec3;

// Coordinates go in one by one, in registers: read back from memory in parts of another size than those just stored they
// have to be waited for, which takes longer than an octave.

/// Octaves outside this range are clipped to it.
fn octaves_in_range(octaves: u32) -> usize {
    (octaves as usize).clamp(1, MOST_OCTAVES)
}

/// Scalar turbulence: `octaves` (1 to 10) of noise, each `lambda` times finer and `omega` times weaker than the one
/// before. Not normalised. `omega` and `lambda` are single precision because the language keeps them so.
#[inline]
pub fn turbulence(generator: u8, p: Vec3, octaves: u32, omega: f32, lambda: f32) -> f64 {
    scalar_sum(generator, p.x, p.y, p.z, octaves, omega, lambda)
}

fn scalar_sum(generator: u8, x: f64, y: f64, z: f64, octaves: u32, omega: f32, lambda: f32) -> f64 {
    let octaves = first_at(Vec3::new(x, y, z), octaves, lambda);
    let groups = octave_groups(generator, octaves);
    let octave = |n: f64| if generator == 1 { n } else { 2.0 * n - 0.5 };
    let omega = f64::from(omega);
    let values = &groups.as_flattened()[..octaves.count];
    let mut sum = clamp01(octave(values[0]));
    let mut weight = omega;
    for &n in &values[1..] {
        sum += weight * octave(n);
        weight *= omega;
    }
    sum
}

/// Vector turbulence: octaves of [`dnoise`](super::dnoise) summed in the same way.
#[inline]
pub fn dturbulence(p: Vec3, octaves: u32, omega: f32, lambda: f32) -> Vec3 {
    vector_sum(p.x, p.y, p.z, octaves, omega, lambda)
}

fn vector_sum(x: f64, y: f64, z: f64, octaves: u32, omega: f32, lambda: f32) -> Vec3 {
    lattice::vector_sum(&first_at(Vec3::new(x, y, z), octaves, lambda), omega.into())
}

fn first_at(p: Vec3, octaves: u32, lambda: f32) -> Octaves {
    Octaves { p, scale: 1.0, lambda: lambda.into(), count: octaves_in_range(octaves) }
}
