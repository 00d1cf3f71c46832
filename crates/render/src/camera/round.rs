//! The projections onto a disc: fisheye and omnimax.
use raggio_math::Vec3;

use super::{Axes, Place, RawRay};

pub(super) fn fisheye(axes: &Axes, place: Place, angle: f64) -> Option<RawRay> {
    let (a, b) = (2.0 * place.px * axes.right_length, 2.0 * place.py * axes.up_length);
    let (rho, phi) = polar(a, b)?;
    let theta = rho * angle / 2.0;
    Some(RawRay { origin: axes.location, dir: tilted(axes, phi, theta), plane: (phi, theta) })
}

pub(super) fn omnimax(axes: &Axes, place: Place) -> Option<RawRay> {
    /// The aspect at which the dome's picture is as wide as its disc.
    const FULL_WIDTH: f64 = 1.283458;
    let aspect = axes.right_length / axes.up_length;
    let (mut a, mut b) = (2.0 * place.px, 2.0 * place.py);
    if aspect > FULL_WIDTH {
        a *= aspect / FULL_WIDTH;
        b = (b - 1.0) / FULL_WIDTH + 1.0;
    } else if aspect > 1.0 {
        b = (b - 1.0) / aspect + 1.0;
    } else {
        b /= aspect;
    }
    let (rho, phi) = polar(a, b)?;
    let theta = rho * (1.411269 + rho * rho * (-0.09439 + 0.25674 * rho * rho));
    // What lies more than 45 degrees below the horizon is not part of the dome.
    if phi.sin() * theta.sin() < -theta.cos() {
        return None;
    }
    Some(RawRay { origin: axes.location, dir: tilted(axes, phi, theta), plane: (phi, theta) })
}

/// Radius and angle of a point of the unit disc; `None` outside of it.
fn polar(a: f64, b: f64) -> Option<(f64, f64)> {
    let rho = a.hypot(b);
    (rho <= 1.0).then(|| (rho, if rho == 0.0 { 0.0 } else { b.atan2(a) }))
}

/// `theta` away from the direction, towards `phi` counted from right to up.
fn tilted(axes: &Axes, phi: f64, theta: f64) -> Vec3 {
    axes.right * (phi.cos() * theta.sin())
        + axes.up * (phi.sin() * theta.sin())
        + axes.direction * theta.cos()
}
