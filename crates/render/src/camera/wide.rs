//! The projections onto cylinders and spheres.
use std::f64::consts::{FRAC_PI_2, PI};

use raggio_math::{EPS, FAR, Vec3};

use super::{Axes, Place, RawRay};

pub(super) fn ultra_wide_angle(axes: &Axes, place: Place, angle: f64) -> RawRay {
    let alpha = place.px * angle;
    let beta = place.py * angle * (axes.up_length / axes.right_length);
    let dir = axes.right * alpha.sin() + axes.up * beta.sin() + axes.direction * (alpha.cos() * beta.cos());
    RawRay { origin: axes.location, dir, plane: (alpha, beta) }
}

pub(super) fn panoramic(axes: &Axes, place: Place) -> RawRay {
    let lambda = (0.5 - place.px) * PI;
    let beta = 2.0 * place.py * FRAC_PI_2;
    let rise = if (beta.abs() - FRAC_PI_2).abs() < EPS { FAR.copysign(beta) } else { beta.tan() };
    let dir = axes.right * lambda.cos() + axes.up * rise + axes.direction * lambda.sin();
    RawRay { origin: axes.location, dir, plane: (lambda, beta) }
}

pub(super) fn cylinder(axes: &Axes, place: Place, angle: f64, kind: u8) -> RawRay {
    let Axes { location, direction, right, up, .. } = *axes;
    // Vertical cylinders (1 and 3) bend across, horizontal ones bend along.
    let vertical = matches!(kind, 1 | 3);
    let (bend, along) = if vertical {
        (place.px * angle, place.py * axes.up_length)
    } else {
        (place.py * angle, place.px * axes.right_length)
    };
    let (round, straight) = if vertical { (right, up) } else { (up, right) };
    let around = round * bend.sin() + direction * bend.cos();
    let plane = if vertical { (bend, along) } else { (along, bend) };
    if kind <= 2 {
        RawRay { origin: location, dir: around + straight * along, plane }
    } else {
        RawRay { origin: location + straight * along, dir: around, plane }
    }
}

pub(super) fn spherical(axes: &Axes, place: Place, horizontal: f64, vertical: f64) -> RawRay {
    let (phi, lambda) = (place.py * vertical, place.px * horizontal);
    let unit = |v: Vec3| v.try_normalize().unwrap_or(v);
    let tilted = turned(axes.direction, unit(axes.right), -phi);
    RawRay { origin: axes.location, dir: turned(tilted, unit(axes.up), lambda), plane: (lambda, phi) }
}

/// Rodrigues' rotation about a unit axis.
fn turned(v: Vec3, axis: Vec3, angle: f64) -> Vec3 {
    v * angle.cos() + axis.cross(v) * angle.sin() + axis * (axis.dot(v) * (1.0 - angle.cos()))
}
