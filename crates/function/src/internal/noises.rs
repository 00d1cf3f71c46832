//! Noise and the fractals made of it.
use raggio_math::Vec3;

use super::Args;

/// Octaves of the fractals are bounded, so that a wild number cannot stop the picture.
const MOST_OCTAVES: f64 = 1000.0;

/// The noise that parameter number `parameter` names; 0, and with it every fraction below 1, is the first generator.
fn generator(a: &Args, parameter: usize) -> impl Fn(Vec3) -> f64 + use<> {
    let g = generator_number(a.p[parameter]);
    move |p| raggio_math::noise::noise(g, p)
}

/// The generator that a parameter names.
pub(crate) fn generator_number(parameter: f64) -> u8 {
    (parameter as i64 & 3).max(1) as u8
}

fn point(a: &Args) -> Vec3 {
    Vec3::new(a.x, a.y, a.z)
}

/// What numbers without a function give.
pub(super) fn nothing(_: &Args) -> f64 {
    0.0
}

pub(super) fn noise_generator(a: &Args) -> f64 {
    generator(a, 1)(point(a))
}

/// Heterogeneous multifractal: octaves are scaled by what lies under them.
pub(super) fn hetero_mf(a: &Args) -> f64 {
    let [_, h, lacunarity, octaves, offset, t, ..] = a.p;
    let noise = generator(a, 6);
    let signal = |p: Vec3| 2.0 * noise(p) - 1.0 + offset;
    let exponent = t.trunc();
    let octaves = octaves.min(MOST_OCTAVES);
    let step = lacunarity.powf(-h);
    let mut sum = signal(point(a));
    let mut p = point(a) * lacunarity;
    let mut weight = step;
    let mut i = 1.0;
    while i < octaves {
        sum += signal(p) * weight * sum.powf(exponent);
        p *= lacunarity;
        weight *= step;
        i += 1.0;
    }
    let rest = octaves.fract();
    if rest != 0.0 { sum + rest * signal(p) * weight * sum } else { sum }
}

/// Octaves of creased noise, divided by the sum of their weights.
pub(super) fn ridge(a: &Args) -> f64 {
    let [_, lambda, octaves, omega, offset, ridge, ..] = a.p;
    let noise = generator(a, 6);
    let crease = 1.0 / ridge.max(1.0 - ridge);
    let scale = 1.0 / offset.max(1.0 - offset);
    let octaves = octaves.min(MOST_OCTAVES);
    let whole = octaves.trunc().max(1.0);
    let (mut l, mut o) = (1.0, 1.0);
    let (mut sum, mut weights) = (0.0, 0.0);
    let mut k = 0.0;
    while k < octaves.max(1.0) {
        let part = if k < whole { o } else { o * octaves.fract() };
        sum += part * (crease * (noise(point(a) * l) - ridge).abs() - offset);
        weights += part;
        l *= lambda;
        o *= omega;
        k += 1.0;
    }
    scale * sum / weights
}

/// Ridged multifractal.
pub(super) fn ridged_mf(a: &Args) -> f64 {
    let [_, h, lacunarity, octaves, offset, gain, ..] = a.p;
    let noise = generator(a, 6);
    let signal = |p: Vec3| {
        let s = offset - (2.0 * noise(p) - 1.0).abs();
        s * s
    };
    let mut p = point(a);
    let mut s = signal(p);
    let mut result = s;
    let mut i = 1.0;
    while i < octaves.min(MOST_OCTAVES) {
        p *= lacunarity;
        let weight = (s * gain).clamp(0.0, 1.0);
        s = weight * signal(p);
        result += s * lacunarity.powf(-i * h);
        i += 1.0;
    }
    result
}
