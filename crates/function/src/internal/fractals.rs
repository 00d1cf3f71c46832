//! Fractals made of noise.
use std::cell::Cell;

use super::{Args, N, generator_number, noises, power, squared};

/// Octaves are bounded, so that a wild number cannot stop the picture.
const MOST_OCTAVES: f64 = 1000.0;

/// The noises of octaves, each so many times finer than the one before; made several at once.
struct Octaves {
    generator: u8,
    at: [N; 3],
    lambda: f64,
    scale: f64,
    /// How many are to be made yet.
    left: usize,
    made: [N; AT_ONCE],
    /// How many of those that are made were taken.
    taken: usize,
}

/// How many octaves are made at once.
pub const AT_ONCE: usize = 8;

impl Octaves {
    /// Of the generator that the last parameter names.
    fn new(a: &Args, lambda: f64, count: f64) -> Self {
        Octaves {
            generator: generator_number(a.p[6]),
            at: [a.x, a.y, a.z],
            lambda,
            scale: 1.0,
            left: count.ceil().max(1.0) as usize,
            made: [N::from(0.0); AT_ONCE],
            taken: AT_ONCE,
        }
    }

    fn next(&mut self) -> N {
        if self.taken == AT_ONCE {
            let count = self.left.clamp(1, AT_ONCE);
            noises(self.generator, self.at, self.scale, self.lambda, &mut self.made[..count]);
            self.left = self.left.saturating_sub(count);
            self.scale *= self.lambda.powi(count as i32);
            self.taken = 0;
        }
        self.taken += 1;
        self.made[self.taken - 1]
    }
}

/// Heterogeneous multifractal: octaves are scaled by what lies under them.
pub fn hetero_mf(a: &Args) -> N {
    let [_, h, lacunarity, octaves, offset, t, ..] = a.p;
    let octaves = octaves.min(MOST_OCTAVES);
    let mut noise = Octaves::new(a, lacunarity, octaves + 1.0);
    let mut signal = || 2.0 * noise.next() - 1.0 + offset;
    let exponent = t.trunc();
    let step = lacunarity.powf(-h);
    let mut sum = signal();
    let mut weight = step;
    let mut i = 1.0;
    while i < octaves {
        sum += signal() * weight * power(sum, exponent);
        weight *= step;
        i += 1.0;
    }
    let rest = octaves.fract();
    if rest != 0.0 { sum + rest * signal() * weight * sum } else { sum }
}

/// Octaves of creased noise, divided by the sum of their weights.
pub fn ridge(a: &Args) -> N {
    let [_, lambda, octaves, omega, offset, ridge, ..] = a.p;
    let crease = 1.0 / ridge.max(1.0 - ridge);
    let scale = 1.0 / offset.max(1.0 - offset);
    let octaves = octaves.min(MOST_OCTAVES);
    let whole = octaves.trunc().max(1.0);
    let mut noise = Octaves::new(a, lambda, octaves);
    let mut o = 1.0;
    let (mut sum, mut weights) = (N::from(0.0), 0.0);
    let mut k = 0.0;
    while k < octaves.max(1.0) {
        let part = if k < whole { o } else { o * octaves.fract() };
        sum += part * (crease * (noise.next() - ridge).abs() - offset);
        weights += part;
        o *= omega;
        k += 1.0;
    }
    scale * sum / weights
}

/// How strong the octaves of a ridged multifractal are. A function asks with the same numbers at every point, and powers
/// take as long as noise: each thread remembers those of its last question.
#[derive(Clone, Copy)]
struct Strengths {
    lacunarity: f64,
    h: f64,
    first: [f64; KNOWN],
}

/// So many octaves are remembered.
const KNOWN: usize = 12;

thread_local! {
    static LAST: Cell<Strengths> = const { Cell::new(Strengths { lacunarity: f64::NAN, h: 0.0, first: [0.0; KNOWN] }) };
}

impl Strengths {
    fn of(lacunarity: f64, h: f64) -> Strengths {
        let last = LAST.get();
        if last.lacunarity == lacunarity && last.h == h {
            return last;
        }
        let first = std::array::from_fn(|i| strength(lacunarity, h, i as f64));
        let new = Strengths { lacunarity, h, first };
        LAST.set(new);
        new
    }

    fn octave(&self, i: f64) -> f64 {
        let known = self.first.get(i as usize);
        known.copied().unwrap_or_else(|| strength(self.lacunarity, self.h, i))
    }
}

fn strength(lacunarity: f64, h: f64, i: f64) -> f64 {
    lacunarity.powf(-i * h)
}

/// Ridged multifractal.
pub fn ridged_mf(a: &Args) -> N {
    let [_, h, lacunarity, octaves, offset, gain, ..] = a.p;
    let octaves = octaves.min(MOST_OCTAVES);
    let mut noise = Octaves::new(a, lacunarity, octaves);
    let mut signal = || squared(offset - (2.0 * noise.next() - 1.0).abs());
    let strengths = Strengths::of(lacunarity, h);
    let mut s = signal();
    let mut result = s;
    let mut i = 1.0;
    while i < octaves {
        let weight = (s * gain).clamp(0.0, 1.0);
        s = weight * signal();
        result += s * strengths.octave(i);
        i += 1.0;
    }
    result
}
