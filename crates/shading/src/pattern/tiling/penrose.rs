//! Tilings 26 and 27: Penrose's kites and darts, and his rhombs, by deflation from one large tile.
use raggio_math::Vec2;

use super::EPS6;

/// The golden ratio.
pub(super) const PHI: f64 = 1.618_033_988_749_894_9;
/// Nearer to the centre than this the value is 1.
pub(super) const CENTRE: f64 = 1e-10;

/// Sine and cosine of a number of degrees.
pub(super) fn sin_cos(degrees: f64) -> (f64, f64) {
    degrees.to_radians().sin_cos()
}

/// The point turned by some degrees from x toward z.
pub(super) fn rot(p: Vec2, degrees: f64) -> Vec2 {
    let (s, c) = sin_cos(degrees);
    Vec2::new(c * p.x - s * p.y, s * p.x + c * p.y)
}

/// The mirror image in z >= 0.
pub(super) fn mirror(p: Vec2) -> Vec2 {
    Vec2::new(p.x, p.y.abs())
}

/// The image in the first tenth of the circle under fivefold symmetry.
pub(super) fn fold5(p: Vec2) -> Vec2 {
    let r = p.length();
    let p = mirror(p);
    let p = if p.x >= r * sin_cos(36.0).1 {
        p
    } else if p.x < r * sin_cos(108.0).1 {
        rot(p, -144.0)
    } else {
        rot(p, -72.0)
    };
    mirror(p)
}

/// The distance from the line through (c, 0) at some degrees.
fn line(p: Vec2, degrees: f64, c: f64) -> f64 {
    let (s, k) = sin_cos(degrees);
    (s * (p.x - c) - k * p.y).abs()
}

/// How many times `base` a length is, in whole powers.
pub(super) fn levels(length: f64, base: f64) -> i32 {
    (length.ln() / base.ln()).ceil().max(0.0) as i32
}

/// Which pair of tiles.
#[derive(Debug)]
pub(in crate::pattern) enum Penrose {
    Kites,
    Rhombs,
}

/// Half tiles of the deflation.
#[derive(Clone, Copy)]
enum Half {
    /// Of a kite.
    K,
    /// Of a dart.
    L,
}

impl Penrose {
    pub fn value(&self, x: f64, z: f64) -> f64 {
        let p = Vec2::new(x, z);
        if p.length() <= CENTRE {
            return 1.0;
        }
        let mut p = fold5(p);
        if matches!(self, Penrose::Rhombs) {
            p /= PHI;
        }
        let (s108, c108) = sin_cos(108.0);
        let size = (s108 * p.x - c108 * p.y).abs() / sin_cos(18.0).1;
        let m = levels(size, PHI * PHI);
        p *= PHI.powi(-2 * m);
        if m % 2 == 1 {
            p = mirror(rot(p, -36.0));
        }
        let (half, p) = deflate(p, 2 * m);
        match self {
            Penrose::Kites => kites(half, p),
            Penrose::Rhombs => rhombs(half, p),
        }
    }
}

/// Goes down from a large half kite to the small half tile that holds the point.
fn deflate(mut p: Vec2, level: i32) -> (Half, Vec2) {
    let mut half = Half::K;
    for _ in 0..level {
        p = mirror(p);
        let rise = p.x - 1.0 / PHI;
        let (next, q) = match half {
            Half::K if p.y < rise * 144_f64.to_radians().tan() => (Half::L, p),
            Half::K => (Half::K, rot(p - rot(Vec2::X, 36.0), 108.0)),
            Half::L if p.y < rise * 108_f64.to_radians().tan() => (Half::K, rot(p, -36.0)),
            Half::L => (Half::L, rot(p - Vec2::X, -144.0)),
        };
        (half, p) = (next, q * PHI);
    }
    (half, mirror(p))
}

fn low(d: f64) -> f64 {
    (0.5 - d / 2.0).clamp(0.0, 0.5 - EPS6)
}

fn high(d: f64) -> f64 {
    (1.0 - d / 2.0).max(0.5 + EPS6)
}

fn kites(half: Half, p: Vec2) -> f64 {
    const STEEPNESS: f64 = 4.46;
    match half {
        Half::K => low(STEEPNESS * line(p, 36.0, 0.0).min(line(p, 108.0, 1.0))),
        Half::L => high(STEEPNESS * p.y.min(line(p, 144.0, 1.0))),
    }
}

fn rhombs(half: Half, p: Vec2) -> f64 {
    const STEEPNESS: f64 = 5.55;
    let divide = line(p, 72.0, 1.0 / PHI);
    match half {
        Half::K if p.y < (p.x - 1.0 / PHI) * 72_f64.to_radians().tan() => {
            high(STEEPNESS * divide.min(line(p, 108.0, 1.0)))
        }
        Half::K => low(STEEPNESS * p.y.min(divide)),
        Half::L => low(STEEPNESS * line(p, 36.0, 0.0).min(line(p, 144.0, 1.0))),
    }
}
