//! Solids whose code takes one way or another at different points.
use std::f64::consts::FRAC_PI_6;

use super::{Args, length};

pub(super) fn comma(a: &Args) -> f64 {
    let p = a.p[1];
    let x = if a.x == 0.0 && a.z == 0.0 { 1e-4 } else { a.x };
    let half = 0.5 * a.z.atan2(x);
    let rho = length(x + 0.25 * p, a.z);
    let tail = a.z.min(half.cos() * 0.5 * p - length(rho - 0.75 * p, a.y));
    let off = x - 0.5 * p;
    let head = 0.5 * p - (off * off + a.z * a.z + a.y * a.y).sqrt();
    -tail.max(head)
}

const HALF_SQRT_3: f64 = 0.866_025_403_784_438_6;

/// Where the point lies in its cell of a hexagonal tiling, in the first sextant's quarter.
fn hexagon(a: &Args) -> (f64, f64) {
    let u = (a.x.abs() % (2.0 * HALF_SQRT_3) - HALF_SQRT_3).abs();
    let v = (a.y.abs() % 3.0 - 1.5).abs();
    let (cu, cv) = (HALF_SQRT_3 - u, 1.5 - v);
    if u * u + v * v > cu * cu + cv * cv { (cu, cv) } else { (u, v) }
}

pub(super) fn hex_x(a: &Args) -> f64 {
    let (u, v) = hexagon(a);
    if v.atan2(u) < FRAC_PI_6 { u } else { u * 0.5 + v * HALF_SQRT_3 }
}

pub(super) fn hex_y(a: &Args) -> f64 {
    let (u, v) = hexagon(a);
    if v.atan2(u) < FRAC_PI_6 { v } else { (v * 0.5 - u * HALF_SQRT_3).abs() }
}

pub(super) fn enneper(a: &Args) -> f64 {
    let (x2, y2, z2) = a.squares();
    let z = if a.z.abs() < 0.2 { 0.2 } else { a.z };
    let first = (y2 - x2) / (2.0 * z) + 2.0 * z2 / 9.0;
    let second = (y2 - x2) / (4.0 * z);
    a.field(-(first.powi(3) - 6.0 * second * second))
}
