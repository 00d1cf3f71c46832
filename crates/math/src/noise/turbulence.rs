//! Sums of noise over octaves (textures spec, section 1.5).
use super::lattice::{self, Octaves};
use super::{MOST_OCTAVES, clamp01, gradient, range};
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
    let start = (0.0, 1.0, f64::from(omega));
    // The first octave is clipped.
    let clipped = |i: usize, n: f64| if i == 0 { clamp01(n) } else { n };
    match generator {
        1 => sum_of::<0>(generator, &octaves, start, clipped).0,
        _ => sum_of::<0>(generator, &octaves, start, |i, n| clipped(i, 2.0 * n - 0.5)).0,
    }
}

/// Adds `N` octaves of scalar noise to a sum, at `p` times a scale and twice as fine for each that follows, half as
/// strong for each that follows, and each as `octave` changes it. Gives the sum and the weight of the next octave.
#[inline]
pub fn octave_sum<const N: usize>(
    generator: u8,
    p: Vec3,
    scale: f64,
    (sum, weight): (f64, f64),
    octave: impl Fn(f64) -> f64 + Copy,
) -> (f64, f64) {
    let octaves = Octaves { p, scale, lambda: 2.0, count: N };
    sum_of::<N>(generator, &octaves, (sum, weight, 0.5), move |_, n| octave(n))
}

/// The same for any octaves; see [`lattice::scalar_sum`].
#[inline]
fn sum_of<const N: usize>(
    generator: u8,
    octaves: &Octaves,
    start: (f64, f64, f64),
    octave: impl Fn(usize, f64) -> f64 + Copy,
) -> (f64, f64) {
    if generator != 3 {
        return lattice::scalar_sum::<N>(octaves, &range(generator), start, octave);
    }
    let (mut sum, mut weight, omega) = start;
    for (i, p) in octaves.points().enumerate() {
        sum += weight * octave(i, gradient::noise(p));
        weight *= omega;
    }
    (sum, weight)
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
