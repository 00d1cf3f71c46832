//! Solids of few words: distances, exponential lumps, prisms, coordinates.
use std::f64::consts::{FRAC_PI_6, PI};

use super::{Args, length};

pub(super) fn blob(a: &Args) -> f64 {
    let (_, y2, z2) = a.squares();
    let [_, distance, s1, k1, s2, k2, ..] = a.p;
    let part = |x: f64, k: f64| 1.0 - ((x * x + y2 + z2) * k * k).min(1.0);
    let (left, right) = (part(a.x + 0.5 * distance, k1), part(a.x - 0.5 * distance, k2));
    -(s1 * left * left + s2 * right * right)
}

pub(super) fn blob2(a: &Args) -> f64 {
    let (_, y2, z2) = a.squares();
    let far = (a.x - a.p[1]) * (a.x - a.p[1]) + y2 + z2;
    a.p[4] - a.p[3] * ((-a.p[2] * a.r2()).exp() + (-a.p[2] * far).exp())
}

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

/// Three ellipsoidal lumps, long in z, y and x.
fn ellipsoids(a: &Args) -> [f64; 3] {
    let (x2, y2, z2) = a.squares();
    let [_, p1, p2, ..] = a.p;
    [p1 * x2 + p1 * y2 + z2, p1 * x2 + y2 + p1 * z2, x2 + p1 * y2 + p1 * z2].map(|e| (-p2 * e).exp())
}

pub(super) fn cross_ellipsoids(a: &Args) -> f64 {
    let [e1, e2, e3] = ellipsoids(a);
    a.p[4] - a.p[3] * e1.max(e2).max(e3)
}

pub(super) fn isect_ellipsoids(a: &Args) -> f64 {
    let [e1, e2, e3] = ellipsoids(a);
    a.p[4] - a.p[3] * e1.min(e2).min(e3)
}

pub(super) fn flange_cover(a: &Args) -> f64 {
    let [e1, e2, e3] = ellipsoids(a);
    a.p[4] - a.p[3] * (e1 + e2 + e3)
}

pub(super) fn spikes(a: &Args) -> f64 {
    let [e1, e2, e3] = ellipsoids(a);
    -a.p[3] * (a.p[5] * (-a.p[4] * a.r2()).exp() - e1 - e2 - e3)
}

pub(super) fn spikes_2d(a: &Args) -> f64 {
    let (x2, _, z2) = a.squares();
    a.y - a.p[1] * (a.p[2] * a.x).cos() * (a.p[3] * a.z).cos() * (-a.p[4] * (x2 + z2)).exp()
}

pub(super) fn ellipsoid(a: &Args) -> f64 {
    let (x2, y2, z2) = a.squares();
    (x2 * a.p[1] * a.p[1] + y2 * a.p[2] * a.p[2] + z2 * a.p[3] * a.p[3]).sqrt()
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

pub(super) fn mesh1(a: &Args) -> f64 {
    let [_, p1, p2, p3, p4, p5, ..] = a.p;
    let across = |v: f64, p: f64| (v.rem_euclid(2.0 * p) - p).abs() * p3;
    let (warp, weft) = (p4 * (a.z * PI / p2).cos(), p4 * (a.x * PI / p1).cos());
    let thread = |w: f64, wave: f64| length(w, (a.y + wave) * p5);
    thread(across(a.x, p1), -warp)
        .min(thread(across(a.x - p1, p1), warp))
        .min(thread(across(a.z, p2), weft))
        .min(thread(across(a.z - p2, p2), -weft))
}

/// The polar angle of spherical coordinates.
pub(super) fn ph(a: &Args) -> f64 {
    length(a.x, a.z).atan2(a.y)
}

/// The azimuth of spherical coordinates.
pub(super) fn th(a: &Args) -> f64 {
    a.x.atan2(a.z)
}

/// The radius of spherical coordinates.
pub(super) fn r(a: &Args) -> f64 {
    a.r2().sqrt()
}

pub(super) fn poly4(a: &Args) -> f64 {
    let y = a.y;
    let [_, p1, p2, p3, p4, p5, ..] = a.p;
    let profile = p1 + y * (p2 + y * (p3 + y * (p4 + y * p5)));
    length(a.x, a.z) - profile.max(-5.0)
}

pub(super) fn quantum(a: &Args) -> f64 {
    let cos = length(a.x, a.z).atan2(a.y).cos();
    let radius = 2.0 * a.r2().sqrt();
    let t = radius * radius * (-0.333_333_33 * radius).exp() * (3.0 * cos * cos - 1.0);
    -0.1 * (t * t - 12.0)
}

pub(super) fn rounded_box(a: &Args) -> f64 {
    let [_, radius, hx, hy, hz, ..] = a.p;
    let out = |c: f64, half: f64| (c.abs() - (half - radius)).max(0.0);
    let (dx, dy, dz) = (out(a.x, hx), out(a.y, hy), out(a.z, hz));
    -radius + (dx * dx + dy * dy + dz * dz).sqrt() - 1e-6
}

pub(super) fn sphere(a: &Args) -> f64 {
    a.r2().sqrt() - a.p[1]
}

pub(super) fn superellipsoid(a: &Args) -> f64 {
    let (e, n) = (a.p[1], a.p[2]);
    let flat = (a.x.abs().powf(2.0 / e) + a.y.abs().powf(2.0 / e)).powf(e / n);
    1.0 - (flat + a.z.abs().powf(2.0 / n)).powf(0.5 * n)
}

pub(super) fn torus(a: &Args) -> f64 {
    length(length(a.x, a.z) - a.p[1], a.y) - a.p[2]
}
