//! Internal functions computed with bounds: the same code over another kind of number.
#[path = "curves.rs"]
#[allow(clippy::duplicate_mod)]
pub(super) mod curves;
#[path = "lumps.rs"]
#[allow(clippy::duplicate_mod)]
pub(super) mod lumps;
#[path = "point.rs"]
#[allow(clippy::duplicate_mod)]
mod point;
#[path = "polynomials.rs"]
#[allow(clippy::duplicate_mod)]
pub(super) mod polynomials;

use crate::bounds::{self, Bounds};

pub(super) type N = Bounds;
pub(super) type Args = super::Args<N>;

pub(super) fn squared(v: N) -> N {
    v.squared()
}

/// Within -10 and 10.
pub(super) fn clipped(v: N) -> N {
    v.max(-10.0).min(10.0)
}

/// The length of the vector (x, y).
pub(super) fn length(x: N, y: N) -> N {
    (x.squared() + y.squared()).sqrt()
}

pub(super) fn noise_generator(a: &Args) -> N {
    bounds::noise::enclose(super::noises::generator_number(a.p[1]), [a.x, a.y, a.z])
}
