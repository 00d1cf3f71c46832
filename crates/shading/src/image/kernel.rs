//! Interpolation: which pixels count at a place, and how much (textures spec, section 7.2).
use raggio_scene::{ImageMap, Interpolation};

use super::Place;

/// Calls `tap` with the index and the weight of every pixel that counts. Weights add up to 1.
pub(super) fn for_each_tap(map: &ImageMap, place: Place, mut tap: impl FnMut(usize, f64)) {
    let bitmap = &map.source.bitmap;
    let fit = |i: i64, size: usize| {
        let size = size as i64;
        (if map.once { i.clamp(0, size - 1) } else { i.rem_euclid(size) }) as usize
    };
    let index = |i: i64, j: i64| fit(j, bitmap.height) * bitmap.width + fit(i, bitmap.width);
    if map.interpolation == Interpolation::None {
        return tap(index(place.x.trunc() as i64, place.y.trunc() as i64), 1.0);
    }
    let (x, y) = (place.x + 0.5, place.y + 0.5);
    let (i, j) = (x.trunc() as i64, y.trunc() as i64);
    let (p, q) = (x - x.trunc(), y - y.trunc());
    match map.interpolation {
        Interpolation::None => {}
        Interpolation::Bilinear => {
            separable(i - 1, j - 1, [1.0 - p, p], [1.0 - q, q], |i, j, w| tap(index(i, j), w));
        }
        Interpolation::Bicubic => {
            separable(i - 2, j - 2, cubic(p), cubic(q), |i, j, w| tap(index(i, j), w));
        }
        Interpolation::NormalizedDistance => {
            let weights = by_distance(p, q);
            for (k, weight) in weights.into_iter().enumerate() {
                tap(index(i - 1 + (k % 2) as i64, j - 1 + (k / 2) as i64), weight);
            }
        }
    }
}

/// Products of weights along x and y, from pixel (i, j) on.
fn separable<const N: usize>(i: i64, j: i64, x: [f64; N], y: [f64; N], mut tap: impl FnMut(i64, i64, f64)) {
    for (dj, wy) in y.into_iter().enumerate() {
        for (di, wx) in x.into_iter().enumerate() {
            tap(i + di as i64, j + dj as i64, wx * wy);
        }
    }
}

/// Catmull-Rom weights of four pixels in a row.
fn cubic(p: f64) -> [f64; 4] {
    let q = 1.0 - p;
    [
        -p * q * q / 2.0,
        q * (q * (3.0 * p + 1.0) + 1.0) / 2.0,
        p * (p * (3.0 * q + 1.0) + 1.0) / 2.0,
        -q * p * p / 2.0,
    ]
}

/// Weights that fall with the squared distance of (p, q) to the corners (0, 0), (1, 0), (0, 1), (1, 1).
fn by_distance(p: f64, q: f64) -> [f64; 4] {
    // Exactly on a corner that pixel alone counts.
    const NEAR: f64 = 1e-12;
    let weight = |x: f64, y: f64| 1.0 / (x * x + y * y).max(NEAR);
    let weights = [weight(p, q), weight(1.0 - p, q), weight(p, 1.0 - q), weight(1.0 - p, 1.0 - q)];
    let sum: f64 = weights.iter().sum();
    weights.map(|w| w / sum)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn weights_add_up_to_one() {
        for i in 0..10 {
            let p = f64::from(i) / 10.0;
            assert!((cubic(p).iter().sum::<f64>() - 1.0).abs() < 1e-12);
            assert!((by_distance(p, 1.0 - p).iter().sum::<f64>() - 1.0).abs() < 1e-12);
        }
        assert!((by_distance(0.0, 0.0)[0] - 1.0).abs() < 1e-9);
    }
}
