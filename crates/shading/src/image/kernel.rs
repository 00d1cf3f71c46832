//! Interpolation: which pixels count at a place, and how much (textures spec, section 7.2).
use raggio_image::Mosaic;
use raggio_scene::{ImageMap, Interpolation};

use super::Place;

/// What can be made of several samples of a picture.
pub(super) trait Mix {
    type Mixture;

    /// The sum of the samples `at` some places, each times its weight.
    fn mix<const N: usize>(&self, at: [usize; N], weights: [f64; N]) -> Self::Mixture;
}

/// Mixes the pixels that count at a place. Their weights add up to 1.
pub(super) fn mix_at<M: Mix>(map: &ImageMap, place: Place, samples: &M) -> M::Mixture {
    let grid = Grid { mosaic: &map.source.mosaic, once: map.once };
    if map.interpolation == Interpolation::None {
        return samples.mix(grid.at::<1, 1>(place.x as i64, place.y as i64), [1.0]);
    }
    let (x, y) = (place.x + 0.5, place.y + 0.5);
    let (i, j) = (x as i64, y as i64);
    let (p, q) = (x - i as f64, y - j as f64);
    match map.interpolation {
        Interpolation::Bicubic => samples.mix(grid.at::<4, 16>(i - 2, j - 2), products(cubic(p), cubic(q))),
        Interpolation::NormalizedDistance => samples.mix(grid.at::<2, 4>(i - 1, j - 1), by_distance(p, q)),
        Interpolation::Bilinear | Interpolation::None => {
            samples.mix(grid.at::<2, 4>(i - 1, j - 1), products([1.0 - p, p], [1.0 - q, q]))
        }
    }
}

/// The rows and columns of a picture, which ends at its edges or repeats itself.
struct Grid<'a> {
    mosaic: &'a Mosaic,
    once: bool,
}

impl Grid<'_> {
    /// Where the `N` by `N` pixels stand whose first one is in column `i` and row `j`; `M` is `N` squared.
    #[inline]
    fn at<const N: usize, const M: usize>(&self, i: i64, j: i64) -> [usize; M] {
        let layout = self.mosaic.layout();
        let (mut columns, mut rows) = ([0; N], [0; N]);
        for k in 0..N {
            columns[k] = self.fit(i + k as i64, self.mosaic.width());
            rows[k] = self.fit(j + k as i64, self.mosaic.height());
        }
        let mut at = [0; M];
        if layout.is_tiled() {
            for (k, at) in at.iter_mut().enumerate() {
                *at = layout.in_tiles(columns[k % N], rows[k / N]);
            }
        } else {
            for (k, at) in at.iter_mut().enumerate() {
                *at = layout.in_rows(columns[k % N], rows[k / N]);
            }
        }
        at
    }

    /// The column or row among those that there are.
    #[inline]
    fn fit(&self, i: i64, size: usize) -> usize {
        if (i as usize) < size { i as usize } else { self.beyond(i, size) }
    }

    #[cold]
    fn beyond(&self, i: i64, size: usize) -> usize {
        let size = size as i64;
        (if self.once { i.clamp(0, size - 1) } else { i.rem_euclid(size) }) as usize
    }
}

/// Products of the weights along x and y, row by row.
#[inline]
fn products<const N: usize, const M: usize>(x: [f64; N], y: [f64; N]) -> [f64; M] {
    let mut out = [0.0; M];
    for (k, out) in out.iter_mut().enumerate() {
        *out = x[k % N] * y[k / N];
    }
    out
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
