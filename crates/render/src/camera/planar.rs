//! The projections onto a plane: perspective and orthographic.
use super::{Axes, Place, RawRay};

#[inline(always)]
pub(super) fn perspective(axes: &Axes, place: Place) -> RawRay {
    let dir = axes.direction + axes.right * place.px + axes.up * place.py;
    RawRay { origin: axes.location, dir, plane: (place.px, place.py) }
}

pub(super) fn orthographic(axes: &Axes, place: Place) -> RawRay {
    let origin = axes.location + axes.right * place.px + axes.up * place.py;
    RawRay { origin, dir: axes.direction, plane: (place.px, place.py) }
}
