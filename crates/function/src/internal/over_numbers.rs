//! Internal functions computed with numbers.
#[path = "curves.rs"]
pub(super) mod curves;
#[path = "fractals.rs"]
pub(super) mod fractals;
#[path = "lumps.rs"]
pub(super) mod lumps;
#[path = "point.rs"]
mod point;
#[path = "polynomials.rs"]
pub(super) mod polynomials;

use crate::builtin::{maximum, minimum};
use fractals::AT_ONCE;

use super::generator_number;

pub(super) type N = f64;
pub(super) type Args = super::Args<N>;

pub(super) fn squared(v: N) -> N {
    v * v
}

pub(super) fn power(v: N, exponent: f64) -> N {
    v.powf(exponent)
}

/// The noise of several octaves, [`AT_ONCE`] at most: at the point times a scale, times `lambda` more for each that follows.
pub(super) fn noises(generator: u8, [x, y, z]: [N; 3], scale: f64, lambda: f64, out: &mut [N]) {
    let made: [f64; AT_ONCE] =
        raggio_math::noise::octaves(generator, raggio_math::Vec3::new(x, y, z), scale, lambda);
    out.iter_mut().zip(made).for_each(|(out, made)| *out = made);
}

/// Within -10 and 10; not-a-number gives -10.
pub(super) fn clipped(v: N) -> N {
    minimum(maximum(-10.0, v), 10.0)
}

/// The length of the vector (x, y). Faster than `f64::hypot`, which also minds overflow.
pub(super) fn length(x: N, y: N) -> N {
    (x * x + y * y).sqrt()
}

/// The length of the vector (x, y, z).
pub(super) fn norm(x: N, y: N, z: N) -> N {
    (x * x + y * y + z * z).sqrt()
}

/// The point (x, y) turned by an angle in radians.
pub(super) fn turned(x: N, y: N, angle: f64) -> (N, N) {
    let (sin, cos) = angle.sin_cos();
    (x * cos - y * sin, x * sin + y * cos)
}
