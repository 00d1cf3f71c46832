//! Internal functions computed with bounds: the same code over another kind of number.
#[path = "curves.rs"]
#[allow(clippy::duplicate_mod)]
pub(super) mod curves;
#[path = "fractals.rs"]
#[allow(clippy::duplicate_mod)]
pub(super) mod fractals;
#[path = "lumps.rs"]
#[allow(clippy::duplicate_mod)]
pub(super) mod lumps;
#[path = "point.rs"]
#[allow(clippy::duplicate_mod)]
mod point;
#[path = "polynomials.rs"]
#[allow(clippy::duplicate_mod)]
pub(super) mod polynomials;

use super::generator_number;
use crate::bounds::{self, Bounds};

/// Powers that are made by multiplication.
const SMALL_POWERS: std::ops::RangeInclusive<f64> = 0.0..=16.0;

pub(super) type N = Bounds;
pub(super) type Args = super::Args<N>;

pub(super) fn squared(v: N) -> N {
    v.squared()
}

pub(super) fn power(v: N, exponent: f64) -> N {
    if exponent == exponent.trunc() && SMALL_POWERS.contains(&exponent) {
        return v.powi(exponent as i32);
    }
    v.powf(exponent)
}

/// The noise of several octaves: at the point times a scale, times `lambda` more for each that follows.
pub(super) fn noises(generator: u8, at: [N; 3], mut scale: f64, lambda: f64, out: &mut [N]) {
    for out in out {
        *out = bounds::noise::enclose(generator, at.map(|v| v * scale));
        scale *= lambda;
    }
}

/// Within -10 and 10.
pub(super) fn clipped(v: N) -> N {
    v.max(-10.0).min(10.0)
}

/// The length of the vector (x, y).
pub(super) fn length(x: N, y: N) -> N {
    norm(x, y, N::from(0.0))
}

/// The length of the vector (x, y, z).
pub(super) fn norm(x: N, y: N, z: N) -> N {
    Bounds::length([x, y, z])
}

pub(super) fn noise_generator(a: &Args) -> N {
    bounds::noise::enclose(generator_number(a.p[1]), [a.x, a.y, a.z])
}
