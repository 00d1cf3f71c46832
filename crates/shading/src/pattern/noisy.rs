//! Patterns made of noise, turbulence and waves.
use std::f64::consts::{FRAC_PI_2, TAU};

use raggio_math::noise::{doctaves, dturbulence, noise4, octave_sum, turbulence};
use raggio_math::{Vec2, Vec3};
use raggio_scene as scene;

use super::wave::cycle;

/// The turbulence that some patterns use inside their formula.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Turbulence(pub scene::Turbulence);

impl Turbulence {
    /// Scalar turbulence at a point.
    fn scalar(&self, noise: u8, p: Vec3) -> f64 {
        turbulence(noise, p, self.0.octaves, self.0.omega, self.0.lambda)
    }

    /// Scalar turbulence times the amount along x: what shifts the veins of marble and the arms of spirals.
    pub fn along_x(&self, noise: u8, p: Vec3) -> f64 {
        if self.0.amount.x == 0.0 { 0.0 } else { self.0.amount.x * self.scalar(noise, p) }
    }
}

pub(super) fn agate(p: Vec3, noise: u8, turbulence: &Turbulence, strength: f64) -> f64 {
    let v = 0.5 * (cycle(1.3 * strength * turbulence.scalar(noise, p) + 1.1 * p.z) + 1.0);
    v.clamp(0.0, 1.0).powf(0.77)
}

pub(super) fn granite(p: Vec3, generator: u8) -> f64 {
    octave_sum::<6>(generator, p, 4.0, (0.0, 1.0), |n| grain(n, generator)).0
}

pub(super) fn granite4(points: &[Vec3; 4], generator: u8) -> [f64; 4] {
    octaves_of_four::<6>(points, generator, (4.0, 1.0), |n| grain(n, generator))
}

fn grain(n: f64, generator: u8) -> f64 {
    if generator == 1 { (0.5 - n).abs() } else { (1.0 - 2.0 * n).abs().min(0.5) }
}

pub(super) fn wrinkles(p: Vec3, generator: u8) -> f64 {
    octave_sum::<10>(generator, p, 1.0, (0.0, 0.5), |n| wrinkle(n, generator)).0
}

/// The value of `wrinkles`; `None` where its first four octaves are above `bound` already, as the others only add.
pub(super) fn wrinkles_unless_above(p: Vec3, bound: f64, generator: u8) -> Option<f64> {
    let first = octave_sum::<4>(generator, p, 1.0, (0.0, 0.5), |n| wrinkle(n, generator));
    (first.0 <= bound).then(|| octave_sum::<6>(generator, p, 16.0, first, |n| wrinkle(n, generator)).0)
}

pub(super) fn wrinkles4(points: &[Vec3; 4], generator: u8) -> [f64; 4] {
    octaves_of_four::<10>(points, generator, (1.0, 0.5), |n| wrinkle(n, generator))
}

fn wrinkle(n: f64, generator: u8) -> f64 {
    if generator == 1 { n } else { (2.0 * n - 0.5).clamp(0.0, 1.0) }
}

/// Sums over `N` octaves at four points, each octave twice as fine and half as strong as the one before.
fn octaves_of_four<const N: usize>(
    points: &[Vec3; 4],
    generator: u8,
    (mut scale, mut weight): (f64, f64),
    octave: impl Fn(f64) -> f64,
) -> [f64; 4] {
    let mut sums = [0.0; 4];
    for _ in 0..N {
        let [a, b, c, d] = *points;
        let values = noise4(generator, &[a * scale, b * scale, c * scale, d * scale]);
        for (sum, n) in sums.iter_mut().zip(values) {
            *sum += weight * octave(n);
        }
        (scale, weight) = (2.0 * scale, 0.5 * weight);
    }
    sums
}

/// A spiral of `arms` arms about the z axis.
pub(super) fn spiral(p: Vec3, arms: f64, noise: u8, turbulence: &Turbulence) -> f64 {
    let r = p.truncate().length();
    let phi = if r == 0.0 {
        0.0
    } else if p.x < 0.0 {
        3.0 * FRAC_PI_2 - (p.y / r).asin()
    } else {
        FRAC_PI_2 + (p.y / r).asin()
    };
    p.z + r + arms * phi / TAU + turbulence.along_x(noise, p)
}

/// Rings about the z axis.
pub(super) fn wood(p: Vec3, turbulence: &Turbulence) -> f64 {
    let t = &turbulence.0;
    if t.amount == Vec3::ZERO {
        return p.truncate().length();
    }
    let d = p + dturbulence(p, t.octaves, t.omega, t.lambda);
    Vec2::new(p.x + cycle(d.x * t.amount.x), p.y + cycle(d.y * t.amount.y)).length()
}

/// How `wrinkles` bend a normal.
pub(crate) fn wrinkle_bend(p: Vec3) -> Vec3 {
    let (mut sum, mut weight) = (Vec3::ZERO, 1.0);
    for value in doctaves::<10>(p, 1.0, 2.0) {
        sum += value.abs() * weight;
        weight *= 0.5;
    }
    sum
}
