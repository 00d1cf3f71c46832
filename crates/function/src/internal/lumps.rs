//! Solids of few words: distances, exponential lumps, prisms, coordinates.
use std::f64::consts::PI;

use super::{Args, N, length, norm};

pub fn blob(a: &Args) -> N {
    let (_, y2, z2) = a.squares();
    let [_, distance, s1, k1, s2, k2, ..] = a.p;
    let part = |x: N, k: f64| 1.0 - ((x * x + y2 + z2) * k * k).min(1.0);
    let (left, right) = (part(a.x + 0.5 * distance, k1), part(a.x - 0.5 * distance, k2));
    -(s1 * left * left + s2 * right * right)
}

pub fn blob2(a: &Args) -> N {
    let (_, y2, z2) = a.squares();
    let far = (a.x - a.p[1]) * (a.x - a.p[1]) + y2 + z2;
    a.p[4] - a.p[3] * ((-a.p[2] * a.r2()).exp() + (-a.p[2] * far).exp())
}

/// Three ellipsoidal lumps, long in z, y and x.
fn ellipsoids(a: &Args) -> [N; 3] {
    let (x2, y2, z2) = a.squares();
    let [_, p1, p2, ..] = a.p;
    [p1 * x2 + p1 * y2 + z2, p1 * x2 + y2 + p1 * z2, x2 + p1 * y2 + p1 * z2].map(|e| (-p2 * e).exp())
}

pub fn cross_ellipsoids(a: &Args) -> N {
    let [e1, e2, e3] = ellipsoids(a);
    a.p[4] - a.p[3] * e1.max(e2).max(e3)
}

pub fn isect_ellipsoids(a: &Args) -> N {
    let [e1, e2, e3] = ellipsoids(a);
    a.p[4] - a.p[3] * e1.min(e2).min(e3)
}

pub fn flange_cover(a: &Args) -> N {
    let [e1, e2, e3] = ellipsoids(a);
    a.p[4] - a.p[3] * (e1 + e2 + e3)
}

pub fn spikes(a: &Args) -> N {
    let [e1, e2, e3] = ellipsoids(a);
    -a.p[3] * (a.p[5] * (-a.p[4] * a.r2()).exp() - e1 - e2 - e3)
}

pub fn spikes_2d(a: &Args) -> N {
    let (x2, _, z2) = a.squares();
    a.y - a.p[1] * (a.p[2] * a.x).cos() * (a.p[3] * a.z).cos() * (-a.p[4] * (x2 + z2)).exp()
}

pub fn ellipsoid(a: &Args) -> N {
    let (x2, y2, z2) = a.squares();
    (x2 * a.p[1] * a.p[1] + y2 * a.p[2] * a.p[2] + z2 * a.p[3] * a.p[3]).sqrt()
}

pub fn mesh1(a: &Args) -> N {
    let [_, p1, p2, p3, p4, p5, ..] = a.p;
    let across = |v: N, p: f64| (v.rem_euclid(2.0 * p) - p).abs() * p3;
    let (warp, weft) = (p4 * (a.z * PI / p2).cos(), p4 * (a.x * PI / p1).cos());
    let thread = |w: N, wave: N| length(w, (a.y + wave) * p5);
    thread(across(a.x, p1), -warp)
        .min(thread(across(a.x - p1, p1), warp))
        .min(thread(across(a.z, p2), weft))
        .min(thread(across(a.z - p2, p2), -weft))
}

/// The polar angle of spherical coordinates.
pub fn ph(a: &Args) -> N {
    length(a.x, a.z).atan2(a.y)
}

/// The azimuth of spherical coordinates.
pub fn th(a: &Args) -> N {
    a.x.atan2(a.z)
}

/// The radius of spherical coordinates.
pub fn r(a: &Args) -> N {
    norm(a.x, a.y, a.z)
}

pub fn poly4(a: &Args) -> N {
    let y = a.y;
    let [_, p1, p2, p3, p4, p5, ..] = a.p;
    let profile = p1 + y * (p2 + y * (p3 + y * (p4 + y * p5)));
    length(a.x, a.z) - profile.max(-5.0)
}

pub fn quantum(a: &Args) -> N {
    let cos = length(a.x, a.z).atan2(a.y).cos();
    let radius = 2.0 * a.r2().sqrt();
    let t = radius * radius * (-0.333_333_33 * radius).exp() * (3.0 * cos * cos - 1.0);
    -0.1 * (t * t - 12.0)
}

pub fn rounded_box(a: &Args) -> N {
    let [_, radius, hx, hy, hz, ..] = a.p;
    let out = |c: N, half: f64| (c.abs() - (half - radius)).max(0.0);
    let (dx, dy, dz) = (out(a.x, hx), out(a.y, hy), out(a.z, hz));
    -radius + norm(dx, dy, dz) - 1e-6
}

pub fn sphere(a: &Args) -> N {
    norm(a.x, a.y, a.z) - a.p[1]
}

pub fn superellipsoid(a: &Args) -> N {
    let (e, n) = (a.p[1], a.p[2]);
    let flat = (a.x.abs().powf(2.0 / e) + a.y.abs().powf(2.0 / e)).powf(e / n);
    1.0 - (flat + a.z.abs().powf(2.0 / n)).powf(0.5 * n)
}

pub fn torus(a: &Args) -> N {
    length(length(a.x, a.z) - a.p[1], a.y) - a.p[2]
}
