//! The sources of `ripples` and `waves` (textures spec, section 1.7).
use super::dnoise;
use super::tables::{bits15, step};
use crate::Vec3;

/// A point that waves spread from.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct WaveSource {
    /// Where, on the unit sphere.
    pub center: Vec3,
    /// How many waves per unit, relative to the pattern's frequency.
    pub frequency: f64,
}

/// The first `count` sources; at least one.
pub fn wave_sources(count: u32) -> Vec<WaveSource> {
    let mut r = (-560_851_967_i32) as u32;
    (0..count.max(1))
        .map(|i| {
            r = step(r);
            let center = dnoise(Vec3::X * f64::from(i)).normalize_or_zero();
            WaveSource { center, frequency: bits15(r) as f64 * 0.000030518509476 + 0.01 }
        })
        .collect()
}
