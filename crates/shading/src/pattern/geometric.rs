//! Patterns of plain geometry: distances, angles, quilts.
use std::f64::consts::{PI, TAU};

use raggio_math::turns::{remainder, sin, trunc};
use raggio_math::{Vec2, Vec3};

/// 1 at the middle, falling to 0 at distance 1 and staying there.
pub(super) fn falling(distance: f64) -> f64 {
    if distance > 1.0 { 0.0 } else { 1.0 - distance }
}

/// Only what is above 1 wraps here; the rest is left to the wave form.
pub(super) fn above_one_wraps(v: f64) -> f64 {
    if v > 1.0 { remainder(v, 1.0) } else { v }
}

pub(super) fn leopard(p: Vec3) -> f64 {
    let v = (sin(p.x) + sin(p.y) + sin(p.z)) / 3.0;
    v * v
}

pub(super) fn radial(p: Vec3) -> f64 {
    if p.x.abs() < 0.001 && p.z.abs() < 0.001 {
        return 0.25;
    }
    0.25 + (p.x.atan2(p.z) + PI) / TAU
}

/// Where a point lies in its quilt cell, and how strongly the quilt bulges there.
pub(crate) fn quilt_strength(p: Vec3, controls: Vec2) -> (Vec3, f64) {
    // At whole negative numbers the lower cell counts.
    let cell = |c: f64| if c >= 0.0 { trunc(c) } else { trunc(c) - 1.0 };
    let q = p - Vec3::new(cell(p.x), cell(p.y), cell(p.z)) - Vec3::splat(0.5);
    let l = q.length();
    let r = 1.0 - l;
    // 2 / sqrt(3), as the language rounds it.
    let strength = 1.154700538 * (l * l * l + 3.0 * l * r * r * controls.x + 3.0 * l * l * r * controls.y);
    (q, strength)
}

pub(super) fn quilted(p: Vec3, controls: Vec2) -> f64 {
    let (q, strength) = quilt_strength(p, controls);
    strength * q.abs().element_sum() / 3.0
}
