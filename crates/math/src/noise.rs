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
pub use turbulence::{dturbulence, turbulence};
pub use waves::{WaveSource, wave_sources};

pub use random::hash;

use crate::Vec3;

/// Scalar noise in 0..=1 at a point. `generator` is 1 (original), 2 (range corrected) or 3 (gradient noise); any other
/// number means 2.
#[inline]
pub fn noise(generator: u8, p: Vec3) -> f64 {
    match generator {
        1 => original(lattice::scalar(p)),
        3 => gradient::noise(p),
        _ => corrected(lattice::scalar(p)),
    }
}

/// Vector noise of several octaves; compare [`octaves`].
#[inline]
pub fn doctaves(p: Vec3, scale: f64, lambda: f64, out: &mut [Vec3]) {
    lattice::vectors(p, scale, lambda, out);
}

/// Scalar noise of several octaves: at `p` times `scale`, times `lambda` more for each that follows. Twice as fast as
/// one by one.
pub fn octaves(generator: u8, p: Vec3, mut scale: f64, lambda: f64, out: &mut [f64]) {
    if generator == 3 {
        for out in out {
            *out = gradient::noise(p * scale);
            scale *= lambda;
        }
        return;
    }
    lattice::scalars(p, scale, lambda, out);
    match generator {
        1 => out.iter_mut().for_each(|v| *v = original(*v)),
        _ => out.iter_mut().for_each(|v| *v = corrected(*v)),
    }
}

/// Raw lattice noise in the range of generator 1.
#[inline]
fn original(raw: f64) -> f64 {
    clamp01(raw + 0.5)
}

/// Raw lattice noise in the range of generator 2.
#[inline]
fn corrected(raw: f64) -> f64 {
    clamp01((raw + 1.05242) * 0.48985582)
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
