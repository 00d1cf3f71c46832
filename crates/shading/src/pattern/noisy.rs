//! Patterns made of noise, turbulence and waves.
use std::f64::consts::{FRAC_PI_2, TAU};

use raggio_math::Vec3;
use raggio_math::noise::{WaveSource, doctaves, dturbulence, octaves, turbulence};
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
    let mut values = [0.0; 6];
    octaves(generator, p, 4.0, 2.0, &mut values);
    let (mut sum, mut weight) = (0.0, 1.0);
    for n in values {
        sum += weight * if generator == 1 { (0.5 - n).abs() } else { (1.0 - 2.0 * n).abs().min(0.5) };
        weight *= 0.5;
    }
    sum
}

pub(super) fn wrinkles(p: Vec3, generator: u8) -> f64 {
    let mut values = [0.0; 10];
    octaves(generator, p, 1.0, 2.0, &mut values);
    let (mut sum, mut weight) = (0.0, 0.5);
    for n in values {
        sum += weight * if generator == 1 { n } else { (2.0 * n - 0.5).clamp(0.0, 1.0) };
        weight *= 0.5;
    }
    sum
}

/// A spiral of `arms` arms about the z axis.
pub(super) fn spiral(p: Vec3, arms: f64, noise: u8, turbulence: &Turbulence) -> f64 {
    let r = p.x.hypot(p.y);
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
        return p.x.hypot(p.y);
    }
    let d = p + dturbulence(p, t.octaves, t.omega, t.lambda);
    (p.x + cycle(d.x * t.amount.x)).hypot(p.y + cycle(d.y * t.amount.y))
}

/// What `ripples` and `waves` are computed from, as patterns and as normals.
#[derive(Clone, Debug)]
pub(crate) struct Waves {
    /// Where they spread from.
    pub sources: Box<[WaveSource]>,
    /// `frequency`
    pub frequency: f64,
    /// `phase`
    pub phase: f64,
}

impl Waves {
    /// The sources of the scene with the pattern's frequency and phase.
    pub fn new(pattern: &scene::Pattern, count: u32) -> Self {
        Waves {
            sources: super::sources(count),
            frequency: f64::from(pattern.frequency),
            phase: f64::from(pattern.phase),
        }
    }

    /// The way from a source to a point, and its length, where 0 counts as 1.
    fn way(source: &WaveSource, p: Vec3) -> (Vec3, f64) {
        let d = p - source.center;
        let l = d.length();
        (d, if l == 0.0 { 1.0 } else { l })
    }

    fn mean(&self, f: impl Fn(&WaveSource) -> f64) -> f64 {
        self.sources.iter().map(f).sum::<f64>() / self.sources.len() as f64
    }

    pub(super) fn ripples(&self, p: Vec3) -> f64 {
        let height = |s: &WaveSource| cycle(Waves::way(s, p).1 * self.frequency + self.phase);
        0.5 * (1.0 + self.mean(height))
    }

    pub(super) fn waves(&self, p: Vec3) -> f64 {
        let height = |s: &WaveSource| {
            cycle(Waves::way(s, p).1 * self.frequency * s.frequency + self.phase) / s.frequency
        };
        0.2 * (2.5 + self.mean(height))
    }

    /// How `ripples` bend a normal.
    pub fn ripple_bend(&self, p: Vec3, amount: f64) -> Vec3 {
        self.bend(p, |l, _| amount * cycle(l * self.frequency + self.phase))
    }

    /// How `waves` bend a normal.
    pub fn wave_bend(&self, p: Vec3, amount: f64) -> Vec3 {
        self.bend(p, |l, s| amount * cycle(l * self.frequency * s.frequency + self.phase) / s.frequency)
    }

    fn bend(&self, p: Vec3, strength: impl Fn(f64, &WaveSource) -> f64) -> Vec3 {
        let sum: Vec3 = self
            .sources
            .iter()
            .map(|s| {
                let (d, l) = Waves::way(s, p);
                d * (strength(l, s) / l)
            })
            .sum();
        sum / self.sources.len() as f64
    }
}

/// How `wrinkles` bend a normal.
pub(crate) fn wrinkle_bend(p: Vec3) -> Vec3 {
    let mut values = [Vec3::ZERO; 10];
    doctaves(p, 1.0, 2.0, &mut values);
    let (mut sum, mut weight) = (Vec3::ZERO, 1.0);
    for value in values {
        sum += value.abs() * weight;
        weight *= 0.5;
    }
    sum
}
