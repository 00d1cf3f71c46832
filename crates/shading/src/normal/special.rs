//! Patterns that bend normals by a rule of their own (textures spec, section 8.1).
use raggio_math::noise::{dnoise, noise};
use raggio_math::{Vec2, Vec3};
use raggio_scene::{self as scene, NormalPattern};

use crate::compiler::Compiler;
use crate::pattern::{Metric, Waves, nearest_feature, quilt_strength, wrinkle_bend};

#[derive(Debug)]
pub(super) struct Special {
    amount: f64,
    rule: Rule,
}

#[derive(Debug)]
enum Rule {
    Bumps,
    Dents { noise: u8 },
    Wrinkles,
    Quilted { controls: Vec2 },
    Spreading(Waves),
    Facets { size: f64, coords: f64, metric: Metric },
}

impl Compiler {
    pub(super) fn special(&self, pattern: &NormalPattern, settings: &scene::Pattern, amount: f64) -> Special {
        let rule = match *pattern {
            NormalPattern::Bumps => Rule::Bumps,
            NormalPattern::Dents => Rule::Dents { noise: self.generator(settings) },
            NormalPattern::Wrinkles => Rule::Wrinkles,
            NormalPattern::Quilted { control0, control1 } => {
                Rule::Quilted { controls: Vec2::new(f64::from(control0), f64::from(control1)) }
            }
            NormalPattern::Ripples => Rule::Spreading(Waves::of_one_frequency(settings, self.noise.waves)),
            NormalPattern::Waves => Rule::Spreading(Waves::of_own_frequencies(settings, self.noise.waves)),
            NormalPattern::Facets { size, coords, metric } => {
                Rule::Facets { size, coords, metric: Metric::signed(metric) }
            }
        };
        Special { amount, rule }
    }
}

impl Special {
    /// The normal bent at a point, both in the pattern's space.
    pub fn bend(&self, n: Vec3, p: Vec3) -> Vec3 {
        let a = self.amount;
        match &self.rule {
            Rule::Bumps => n + a * dnoise(p),
            Rule::Dents { noise: generator } => n + a * noise(*generator, p).powi(3) * dnoise(p),
            Rule::Wrinkles => n + a * wrinkle_bend(p),
            Rule::Quilted { controls } => {
                let (q, strength) = quilt_strength(p, *controls);
                n + a * strength * q
            }
            Rule::Spreading(waves) => n + waves.bend(p, a),
            Rule::Facets { size, coords, metric } => facet(n, p, *size, *coords, *metric),
        }
    }
}

/// Without `coords` nearby normals snap to the same direction; with it nearby points do.
fn facet(n: Vec3, p: Vec3, size: f64, coords: f64, metric: Metric) -> Vec3 {
    const LEAST_SIZE: f64 = 1e-6;
    let n = n.normalize_or(n);
    let q = if coords == 0.0 { n } else { p };
    let q = if size < LEAST_SIZE { q / LEAST_SIZE } else { q / size };
    let feature = nearest_feature(q, metric);
    if coords == 0.0 {
        return feature;
    }
    let d = dnoise(feature);
    n + coords * (d - d.dot(n) * n)
}
