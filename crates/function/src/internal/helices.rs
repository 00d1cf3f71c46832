//! Coils: helices, spirals, bundles of tubes.
use std::f64::consts::{PI, TAU};

use raggio_math::turns::remainder;

use super::{Args, length, turned};

/// The size of the point (x, y) measured by the cross section of a coil: 1 is round, 0 square, between and beyond
/// superelliptical.
fn section(x: f64, y: f64, shape: f64) -> f64 {
    if shape == 1.0 {
        length(x, y)
    } else if shape == 0.0 {
        x.abs().max(y.abs())
    } else {
        (x.abs().powf(2.0 / shape) + y.abs().powf(2.0 / shape)).powf(0.5 * shape)
    }
}

/// The angle from 0 to a whole turn that points the same way.
fn one_turn(angle: f64) -> f64 {
    let rest = remainder(angle, TAU);
    if rest < 0.0 { rest + TAU } else { rest }
}

pub(super) fn helix1(a: &Args) -> f64 {
    let [_, count, period, minor, major, shape, cross, degrees, ..] = a.p;
    let q = length(a.x, a.z);
    let turn = one_turn(count * a.z.atan2(a.x) + a.y * count * period);
    let along = (turn - PI) / shape / (count * period);
    let across = q - major;
    let (u, v) = if cross == 1.0 { (across, along) } else { turned(across, along, degrees.to_radians()) };
    -minor + (major + q).min(section(u, v, cross))
}

pub(super) fn helix2(a: &Args) -> f64 {
    let [_, _, period, minor, major, _, cross, ..] = a.p;
    let angle = a.y * period;
    let (u, v) = turned(a.x - major * angle.cos(), a.z - major * angle.sin(), -angle);
    section(u, v, cross) - minor
}

pub(super) fn helical_torus(a: &Args) -> f64 {
    let [_, p1, p2, p3, p4, p5, p6, p7, p8, p9, p10] = a.p;
    let q = length(a.x, a.z);
    let x = if a.x == 0.0 && a.z == 0.0 { 1e-6 } else { a.x };
    let azimuth = x.atan2(a.z);
    let wind = (q - p1).atan2(a.y);
    let rho = length(q - p1, a.y);
    let turn = one_turn(azimuth * p2 + wind * p3) - PI;
    let groove = (p8 * (turn * p9).atan2(rho - p6) + azimuth * p10).cos() * p4 + p5;
    let body = p5 + p6 - p1 - q;
    let coil = groove - ((rho - p6) * (rho - p6) + turn * turn * p7).sqrt().min(rho + p6);
    -body.max(coil)
}

/// At most this many tubes.
const MOST_TUBES: f64 = 10_000.0;

pub(super) fn polytubes(a: &Args) -> f64 {
    let y = a.y;
    let [_, count, p2, p3, p4, p5, p6, ..] = a.p;
    let radius = p2 + y * (p3 + y * (p4 + y * (p5 + y * p6)));
    let tubes = count.clamp(0.0, MOST_TUBES) as u32;
    (0..tubes)
        .map(|i| {
            let (sin, cos) = (TAU * f64::from(i) / count).sin_cos();
            length(a.x - radius * sin, a.z - radius * cos)
        })
        .fold(f64::INFINITY, f64::min)
}

pub(super) fn spiral(a: &Args) -> f64 {
    let [_, gap, thick, outer, _, _, cross, ..] = a.p;
    let q = length(a.x, a.z) + gap * a.z.atan2(a.x) / TAU;
    let across = section(q % gap - 0.5 * gap, a.y, cross);
    let radius = a.r2().sqrt();
    -(outer - radius).min(thick - across.min(radius))
}
