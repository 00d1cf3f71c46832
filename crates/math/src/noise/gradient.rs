//! Gradient noise (generator 3), after Perlin (textures spec, section 1.3).
use super::tables::{GRADIENT_TABLES, GRADIENTS};
use super::{clamp01, s_curve};
use crate::Vec3;

/// Keeps the cells of everyday coordinates positive; the fraction is the published one.
const SHIFT: f64 = 10_000_000.023157213;
const MASK: usize = GRADIENTS - 1;

/// The cell of a coordinate and the fraction within it.
#[inline]
fn split(c: f64) -> (usize, f64) {
    let t = c + SHIFT;
    let i = t as i64;
    let i = i.wrapping_sub(i64::from(t < i as f64));
    (i as usize & MASK, t - i as f64)
}

/// Noise in 0..=1.
#[inline]
pub(super) fn noise(p: Vec3) -> f64 {
    noise_at(p.x, p.y, p.z)
}

fn noise_at(x: f64, y: f64, z: f64) -> f64 {
    let tables = &**GRADIENT_TABLES;
    let ((bx, fx), (by, fy), (bz, fz)) = (split(x), split(y), split(z));
    let permute = |i: usize| usize::from(tables.permutation[i & MASK]);
    let corner = |hy: usize, dx: f64, dy: f64, dz: usize| {
        let g = &tables.gradients[(hy + ((bz + dz) & MASK)) & MASK];
        g[0] * (fx - dx) + g[1] * (fy - dy) + g[2] * (fz - dz as f64)
    };
    let (sx, sy, sz) = (s_curve(fx), s_curve(fy), s_curve(fz));
    let along_z = |hx: usize, dx: f64, dy: usize| {
        let hy = permute(hx + ((by + dy) & MASK));
        let (a, b) = (corner(hy, dx, dy as f64, 0), corner(hy, dx, dy as f64, 1));
        a + sz * (b - a)
    };
    let along_y = |dx: usize| {
        let hx = permute(bx + dx);
        let (a, b) = (along_z(hx, dx as f64, 0), along_z(hx, dx as f64, 1));
        a + sy * (b - a)
    };
    let (a, b) = (along_y(0), along_y(1));
    clamp01(0.5 * (1.59 * (a + sx * (b - a)) + 0.985))
}
