//! The cache of light samples, by depth, and how much a sample counts at a point.
use raggio_image::Rgb;
use raggio_math::Vec3;

use super::octree::Octree;

/// Diffuse light at a place.
#[derive(Clone, Debug)]
pub struct Sample {
    /// Where.
    pub p: Vec3,
    /// The surface's normal.
    pub n: Vec3,
    /// The mean light from all around.
    pub light: Rgb,
    /// The harmonic mean of the distances to what is seen.
    pub mean_distance: f64,
    /// The least of them.
    pub nearest: f64,
    /// The direction of the least.
    pub toward: Vec3,
    /// How well the light is known.
    pub quality: f32,
}

/// What is asked of the cache.
pub struct Query {
    /// Where.
    pub p: Vec3,
    /// The surface's normal.
    pub n: Vec3,
    /// The greatest error.
    pub error: f64,
    /// Weights fall off as in the final picture.
    pub sharp: bool,
}

/// Weighted samples.
#[derive(Default)]
pub struct Found {
    /// The weighted sum of light.
    pub sum: Rgb,
    /// The sum of weights.
    pub weight: f32,
}

/// Samples with less weight do not count.
const LEAST_WEIGHT: f64 = 1e-3;

/// Samples of all depths.
#[derive(Default)]
pub struct Cache {
    trees: Vec<Octree>,
}

impl Cache {
    /// An empty cache for so many depths.
    pub fn new(depths: u32) -> Cache {
        Cache { trees: (0..depths).map(|_| Octree::default()).collect() }
    }

    /// Adds to `found` what counts at a point.
    pub fn look_up(&self, depth: u32, query: &Query, found: &mut Found) {
        let Some(tree) = self.trees.get(depth as usize) else { return };
        tree.visit(query, |sample| {
            let weight = sample.weight(query);
            if weight > LEAST_WEIGHT {
                let weight = weight as f32 * sample.quality;
                found.sum += sample.light * weight;
                found.weight += weight;
            }
        });
    }

    /// Keeps a sample that counts within `radius`.
    pub fn insert(&mut self, depth: u32, sample: Sample, radius: f64) {
        if let Some(tree) = self.trees.get_mut(depth as usize) {
            tree.insert(sample, radius);
        }
    }

    /// Takes over all samples of another cache.
    pub fn absorb(&mut self, other: Cache) {
        for (tree, other) in self.trees.iter_mut().zip(other.trees) {
            for (sample, radius) in other.into_samples() {
                tree.insert(sample, radius);
            }
        }
    }
}

impl Sample {
    /// Does the sample count at a point?
    pub fn counts_at(&self, query: &Query) -> bool {
        self.weight(query) > LEAST_WEIGHT
    }

    /// How much the sample counts; 0 where it does not fit.
    #[inline]
    fn weight(&self, query: &Query) -> f64 {
        let offset = query.p - self.p;
        let farthest = self.mean_distance * query.error;
        let square = offset.length_squared();
        if square >= farthest * farthest {
            return 0.0;
        }
        let x = square.sqrt();
        let away = if x > 1e-6 { offset / x } else { Vec3::ZERO };
        let mut reach = self.mean_distance;
        let closing = self.toward.dot(away);
        if closing > 0.0 {
            reach = closing * self.nearest + (1.0 - closing) * self.mean_distance;
            if x >= reach * query.error {
                return 0.0;
            }
        }
        let turn = 2.0 * (1.0 - query.n.dot(self.n)).abs().sqrt();
        let error = x / reach + turn;
        if error >= query.error {
            return 0.0;
        }
        let y = error / query.error;
        let weight = match (query.sharp, y < 0.5) {
            (false, _) => 1.0 - y,
            (true, true) => 1.0 - 2.0 * y * y,
            (true, false) => 2.0 * (1.0 - y) * (1.0 - y),
        };
        // What lies before the sample's surface may see other things.
        let between = query.n + self.n;
        if x <= 1e-6 || away.dot(between) >= 0.0 {
            return weight;
        }
        let front = between.try_normalize().map_or(0.0, |m| away.dot(m));
        if front <= -0.05 { 0.0 } else { weight * (1.0 + front / 0.05) }
    }
}

#[cfg(test)]
pub(super) mod tests {
    use super::*;

    pub fn sample(p: Vec3) -> Sample {
        Sample {
            p,
            n: Vec3::Y,
            light: Rgb::ONE,
            mean_distance: 2.0,
            nearest: 2.0,
            toward: Vec3::Y,
            quality: 1.0,
        }
    }

    #[test]
    fn weights_fall_from_one_to_nothing() {
        let query = |x: f64, sharp| Query { p: Vec3::X * x, n: Vec3::Y, error: 1.0, sharp };
        let s = sample(Vec3::ZERO);
        assert_eq!(s.weight(&query(0.0, false)), 1.0);
        assert!((s.weight(&query(1.0, false)) - 0.5).abs() < 1e-12);
        assert!((s.weight(&query(0.5, true)) - 0.875).abs() < 1e-12);
        assert_eq!(s.weight(&query(2.0, true)), 0.0);
        let behind = Query { p: Vec3::new(0.5, -0.5, 0.0), n: Vec3::Y, error: 1.0, sharp: false };
        assert_eq!(s.weight(&behind), 0.0);
    }
}
