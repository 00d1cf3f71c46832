//! Noise: the lattice and gradient noises of the scene language, turbulence, wave sources, the fixed random table
//! (textures spec, section 1).
//!
//! Invariants: pure functions of their arguments, the same on every machine and thread, no allocation. Deliberately
//! absent: patterns, which live with textures.
#[cfg(target_arch = "x86_64")]
mod avx2;
mod gradient;
mod lattice;
mod random;
mod tables;
mod turbulence;
mod values;
mod waves;

pub use lattice::{corners, dnoise};
pub use random::{hash3, random, random3};
pub use turbulence::{dturbulence, octave_sum, turbulence};
pub use waves::{WaveSource, wave_sources};

pub use random::hash;

use crate::Vec3;
use lattice::{LANES, Octaves, Range};

/// Scalar noise in 0..=1 at a point. `generator` is 1 (original), 2 (range corrected) or 3 (gradient noise); any other
/// number means 2.
#[inline]
pub fn noise(generator: u8, p: Vec3) -> f64 {
    match generator {
        3 => gradient::noise(p),
        _ => range(generator).apply(lattice::scalar(p)),
    }
}

/// [`noise`] at four points, faster than one by one.
#[inline]
pub fn noise4(generator: u8, points: &[Vec3; 4]) -> [f64; 4] {
    match generator {
        3 => points.map(gradient::noise),
        _ => lattice::four(points, range(generator)),
    }
}

/// The most octaves that anything has.
const MOST_OCTAVES: usize = 10;

/// Octaves are worked out in groups.
const GROUPS: usize = MOST_OCTAVES.div_ceil(LANES);

/// Scalar noise of `N` octaves, at most 10: at `p` times `scale`, times `lambda` more for each that follows. Twice as
/// fast as one by one.
#[inline]
pub fn octaves<const N: usize>(generator: u8, p: Vec3, scale: f64, lambda: f64) -> [f64; N] {
    let groups = octave_groups(generator, Octaves { p, scale, lambda, count: N });
    let mut out = [0.0; N];
    out.copy_from_slice(&groups.as_flattened()[..N]);
    out
}

/// Vector noise of several octaves; compare [`octaves`].
#[inline]
pub fn doctaves<const N: usize>(p: Vec3, scale: f64, lambda: f64) -> [Vec3; N] {
    let groups = vector_groups(Octaves { p, scale, lambda, count: N });
    let mut out = [Vec3::ZERO; N];
    for (i, out) in out.iter_mut().enumerate() {
        let [x, y, z] = &groups[i / LANES];
        *out = Vec3::new(x[i % LANES], y[i % LANES], z[i % LANES]);
    }
    out
}

#[inline]
fn octave_groups(generator: u8, octaves: Octaves) -> [[f64; LANES]; GROUPS] {
    let mut groups = [[0.0; LANES]; GROUPS];
    match generator {
        3 => {
            for (p, out) in octaves.points().zip(groups.as_flattened_mut()) {
                *out = gradient::noise(p);
            }
        }
        _ => lattice::scalars(&octaves, range(generator), &mut groups),
    }
    groups
}

#[inline]
fn vector_groups(octaves: Octaves) -> [[[f64; LANES]; 3]; GROUPS] {
    let mut groups = [[[0.0; LANES]; 3]; GROUPS];
    lattice::vectors(&octaves, &mut groups);
    groups
}

/// How raw lattice noise becomes that of generator 1 or 2.
#[inline]
fn range(generator: u8) -> Range {
    match generator {
        1 => Range { add: 0.5, times: 1.0 },
        _ => Range { add: 1.05242, times: 0.48985582 },
    }
}

/// Clips to 0..=1; a NaN becomes 0.
#[inline]
fn clamp01(v: f64) -> f64 {
    if v > 0.0 { v.min(1.0) } else { 0.0 }
}

/// The weight curve between lattice points.
#[inline]
fn s_curve(f: f64) -> f64 {
    f * f * (3.0 - 2.0 * f)
}
