//! Noise: the lattice and gradient noises of the scene language, turbulence, wave sources, the fixed random table
//! (textures spec, section 1).
//!
//! Invariants: pure functions of their arguments, the same on every machine and thread, no allocation. Deliberately
//! absent: patterns, which live with textures.
mod gradient;
mod lattice;
mod random;
mod tables;
mod turbulence;
mod values;
mod waves;

pub use lattice::dnoise;
pub use random::{hash3, random, random3};
pub use turbulence::{dturbulence, turbulence};
pub use waves::{WaveSource, wave_sources};

pub use random::hash;

use crate::Vec3;

/// Scalar noise in 0..=1 at a point. `generator` is 1 (original), 2 (range corrected) or 3 (gradient noise); any other
/// number means 2.
#[inline]
pub fn noise(generator: u8, p: Vec3) -> f64 {
    match generator {
        1 => clamp01(lattice::scalar(p) + 0.5),
        3 => gradient::noise(p),
        _ => clamp01((lattice::scalar(p) + 1.05242) * 0.48985582),
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
