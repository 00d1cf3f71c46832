//! Random and not so random numbers: the jitter tables, counter-seeded streams, Halton points.
//!
//! Every stream starts from a hash of (seed, pixel, sample), so that a picture does not depend on the threads that
//! made it.
use std::f64::consts::TAU;

use raggio_math::noise;

/// The jitter table J of the light spec, appendix A.
#[rustfmt::skip]
const JITTER: [f64; 256] = [
    -0.5, 0.00589, 0.011749, -0.490234, 0.023468, -0.470703, -0.480469, 0.017609, 0.046906, -0.447266, -0.441406, 0.056671, -0.460938, 0.044952, 0.035187, -0.466797,
    0.093781, -0.400391, -0.394531, 0.103546, -0.382813, 0.123077, 0.113312, -0.388672, -0.421875, 0.084015, 0.089874, -0.412109, 0.070343, -0.423828, -0.433594, 0.064484,
    0.187531, -0.306641, -0.300781, 0.197296, -0.289063, 0.216827, 0.207062, -0.294922, -0.265625, 0.240265, 0.246124, -0.255859, 0.226593, -0.267578, -0.277344, 0.220734,
    -0.34375, 0.16214, 0.167999, -0.333984, 0.179718, -0.314453, -0.324219, 0.173859, 0.140656, -0.353516, -0.347656, 0.150421, -0.367188, 0.138702, 0.128937, -0.373047,
    0.375031, -0.119141, -0.113281, 0.384796, -0.101563, 0.404327, 0.394562, -0.107422, -0.078125, 0.427765, 0.433624, -0.068359, 0.414093, -0.080078, -0.089844, 0.408234,
    -0.03125, 0.47464, 0.480499, -0.021484, 0.492218, -0.001953, -0.011719, 0.486359, 0.453156, -0.041016, -0.035156, 0.462921, -0.054688, 0.451202, 0.441437, -0.060547,
    -0.1875, 0.31839, 0.324249, -0.177734, 0.335968, -0.158203, -0.167969, 0.330109, 0.359406, -0.134766, -0.128906, 0.369171, -0.148438, 0.357452, 0.347687, -0.154297,
    0.281281, -0.212891, -0.207031, 0.291046, -0.195313, 0.310577, 0.300812, -0.201172, -0.234375, 0.271515, 0.277374, -0.224609, 0.257843, -0.236328, -0.246094, 0.251984,
    -0.249969, 0.255859, 0.261719, -0.240204, 0.273438, -0.220673, -0.230438, 0.267578, 0.296875, -0.197235, -0.191376, 0.306641, -0.210907, 0.294922, 0.285156, -0.216766,
    0.34375, -0.15036, -0.144501, 0.353516, -0.132782, 0.373047, 0.363281, -0.138641, -0.171844, 0.333984, 0.339844, -0.162079, 0.320313, -0.173798, -0.183563, 0.314453,
    0.4375, -0.05661, -0.050751, 0.447266, -0.039032, 0.466797, 0.457031, -0.044891, -0.015594, 0.490234, 0.496094, -0.005829, 0.476563, -0.017548, -0.027313, 0.470703,
    -0.093719, 0.412109, 0.417969, -0.083954, 0.429688, -0.064423, -0.074188, 0.423828, 0.390625, -0.103485, -0.097626, 0.400391, -0.117157, 0.388672, 0.378906, -0.123016,
    0.125, -0.36911, -0.363251, 0.134766, -0.351532, 0.154297, 0.144531, -0.357391, -0.328094, 0.177734, 0.183594, -0.318329, 0.164063, -0.330048, -0.339813, 0.158203,
    -0.281219, 0.224609, 0.230469, -0.271454, 0.242188, -0.251923, -0.261688, 0.236328, 0.203125, -0.290985, -0.285126, 0.212891, -0.304657, 0.201172, 0.191406, -0.310516,
    -0.437469, 0.068359, 0.074219, -0.427704, 0.085938, -0.408173, -0.417938, 0.080078, 0.109375, -0.384735, -0.378876, 0.119141, -0.398407, 0.107422, 0.097656, -0.404266,
    0.03125, -0.46286, -0.457001, 0.041016, -0.445282, 0.060547, 0.050781, -0.451141, -0.484344, 0.021484, 0.027344, -0.474579, 0.007813, -0.486298, -0.496063, 0.001953,
];

/// Jitter in -0.5..0.5 for a position in pixel units (light spec, section 2.4).
pub fn jitter2d(x: f64, y: f64) -> (f64, f64) {
    let pick = |a: f64, b: f64| {
        let inner = noise::hash(a as i64) as i64;
        JITTER[noise::hash(inner ^ (b as i64)) & 255]
    };
    (pick(1021.0 * x, 1019.0 * y), pick(1019.0 * x, 1021.0 * y))
}

/// Mixes words into one well spread word (the finalizer of SplitMix64, Steele et al. 2014).
pub fn mix(words: [u64; 4]) -> u64 {
    words.iter().fold(0x9e37_79b9_7f4a_7c15, |state, word| {
        let mut z = (state ^ word).wrapping_add(0x9e37_79b9_7f4a_7c15);
        z = (z ^ (z >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        z ^ (z >> 31)
    })
}

/// A place in the table of 32768 Mersenne twister numbers.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Stream(u16);

impl Stream {
    /// The next number in 0..1; the place moves on before it is read.
    #[inline]
    pub fn next(&mut self) -> f64 {
        self.0 = (self.0 + 1) & 0x7fff;
        noise::random(usize::from(self.0))
    }
}

impl Stream {
    /// Leaves out some numbers.
    pub fn skip(&mut self, count: u32) {
        self.0 = (u32::from(self.0).wrapping_add(count) & 0x7fff) as u16;
    }
}

/// The linear congruential generator behind `crand`.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Lcg(u32);

impl Lcg {
    /// The next number in 0..=1.
    #[inline]
    pub fn next(&mut self) -> f64 {
        self.0 = self.0.wrapping_mul(1_812_433_253).wrapping_add(12345);
        f64::from(self.0) / f64::from(u32::MAX)
    }
}

/// The random numbers that one camera sample may use, looked up when the first is asked for.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Streams {
    key: [u64; 4],
    numbers: Option<Numbers>,
}

/// Where the random numbers of a camera sample go on.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Numbers {
    /// Area lights and rainbows.
    pub lights: Stream,
    /// Media.
    pub media: Stream,
    /// `crand`
    pub crand: Lcg,
    /// Where the directions of scattered light go on.
    pub scatter: u32,
}

impl Streams {
    /// The streams of one camera sample.
    #[inline]
    pub fn new(seed: u64, x: i64, y: i64, sample: u64) -> Self {
        Streams { key: [seed, x as u64, y as u64, sample], numbers: None }
    }

    /// The numbers themselves.
    #[inline]
    pub fn numbers(&mut self) -> &mut Numbers {
        self.numbers.get_or_insert_with(|| Numbers::new(self.key))
    }
}

impl Numbers {
    #[cold]
    fn new(key: [u64; 4]) -> Self {
        let word = mix(key);
        Numbers {
            lights: Stream((word & 0x7fff) as u16),
            media: Stream(((word >> 16) & 0x7fff) as u16),
            crand: Lcg((word >> 32) as u32),
            scatter: ((word >> 40) % 32767) as u32,
        }
    }
}

/// The radical inverse of `index` in a base: the Halton sequence.
pub fn halton(base: u32, mut index: u32) -> f64 {
    let (step, mut scale, mut value) = (1.0 / f64::from(base), 1.0, 0.0);
    while index > 0 {
        scale *= step;
        value += scale * f64::from(index % base);
        index /= base;
    }
    value
}

/// A point of a disc of diameter 1 by the polar map of two numbers in 0..1.
pub fn disc(a: f64, b: f64) -> (f64, f64) {
    let (radius, angle) = ((a / 4.0).sqrt(), TAU * b);
    (radius * angle.cos(), radius * angle.sin())
}

/// The value that a chi-square variable with `freedom` degrees exceeds with probability `upper`.
pub fn chi_square_quantile(upper: f64, freedom: f64) -> f64 {
    if !(upper > 0.0 && freedom > 0.0) {
        return f64::INFINITY;
    }
    let (mut lo, mut hi) = (0.0, freedom.max(1.0));
    while gamma_q(freedom / 2.0, hi / 2.0) > upper && hi < 1e12 {
        hi *= 2.0;
    }
    for _ in 0..100 {
        let middle = 0.5 * (lo + hi);
        if gamma_q(freedom / 2.0, middle / 2.0) > upper { lo = middle } else { hi = middle }
    }
    0.5 * (lo + hi)
}

/// The regularised upper incomplete gamma function, by series or continued fraction (Abramowitz and Stegun 6.5.29,
/// 6.5.31).
fn gamma_q(a: f64, x: f64) -> f64 {
    if x <= 0.0 {
        return 1.0;
    }
    let front = (a * x.ln() - x - ln_gamma(a)).exp();
    if x < a + 1.0 {
        let (mut term, mut sum, mut n) = (1.0 / a, 1.0 / a, a);
        while term.abs() > sum.abs() * 1e-16 {
            n += 1.0;
            term *= x / n;
            sum += term;
        }
        return 1.0 - front * sum;
    }
    // Lentz's method.
    let mut b = x + 1.0 - a;
    let (mut c, mut d) = (1e300, 1.0 / b);
    let mut h = d;
    for i in 1..10_000 {
        let an = -f64::from(i) * (f64::from(i) - a);
        b += 2.0;
        d = 1.0 / (an * d + b);
        c = b + an / c;
        h *= c * d;
        if (c * d - 1.0).abs() < 1e-15 {
            break;
        }
    }
    front * h
}

/// The logarithm of the gamma function for positive arguments, by Stirling's series after shifting the argument up.
fn ln_gamma(mut x: f64) -> f64 {
    let mut shift = 0.0;
    while x < 15.0 {
        shift += x.ln();
        x += 1.0;
    }
    let y = 1.0 / (x * x);
    let series = (1.0 / 12.0 - y * (1.0 / 360.0 - y * (1.0 / 1260.0 - y / 1680.0))) / x;
    (x - 0.5) * x.ln() - x + 0.5 * TAU.ln() + series - shift
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn chi_square_agrees_with_printed_tables() {
        for (upper, freedom, value) in
            [(0.05, 1.0, 3.841_459), (0.9, 10.0, 4.865_182), (0.01, 30.0, 50.892_181), (0.5, 2.0, 1.386_294)]
        {
            assert!((chi_square_quantile(upper, freedom) - value).abs() < 1e-6, "{upper} {freedom}");
        }
        assert!(chi_square_quantile(1.0, 3.0) < 1e-20);
    }

    #[test]
    fn halton_starts_as_written_in_books() {
        let base2: Vec<f64> = (1..5).map(|i| halton(2, i)).collect();
        assert_eq!(base2, [0.5, 0.25, 0.75, 0.125]);
        assert!((halton(3, 5) - 7.0 / 9.0).abs() < 1e-15);
    }

    #[test]
    fn the_random_table_is_the_default_mersenne_twister() {
        let mut s = Stream::default();
        for expected in [0.135_477_00, 0.905_791_93, 0.835_008_59] {
            assert!((s.next() - expected).abs() < 1e-8);
        }
    }

    #[test]
    fn crand_starts_with_the_increment() {
        assert!((Lcg::default().next() - 12345.0 / 4_294_967_295.0).abs() < 1e-15);
    }

    #[test]
    fn jitter_is_a_function_of_place_and_stays_within_half_a_unit() {
        let all: Vec<(f64, f64)> = (0..64).map(|i| jitter2d(f64::from(i) * 0.37, 2.0)).collect();
        assert!(all.iter().all(|j| j.0.abs() <= 0.5 && j.1.abs() <= 0.5));
        assert!(all.iter().any(|j| j.0 > 0.2) && all.iter().any(|j| j.0 < -0.2));
        assert_eq!(jitter2d(3.25, -1.5), jitter2d(3.25, -1.5));
    }

    #[test]
    fn streams_depend_on_pixel_sample_and_seed() {
        let first = |seed, x, y, k| Streams::new(seed, x, y, k).numbers().lights.next();
        assert_ne!(first(0, 1, 2, 0), first(0, 2, 1, 0));
        assert_ne!(first(0, 1, 2, 0), first(0, 1, 2, 1));
        assert_ne!(first(0, 1, 2, 0), first(1, 1, 2, 0));
        assert_eq!(first(3, 1, 2, 5), first(3, 1, 2, 5));
    }
}
