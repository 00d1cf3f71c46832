//! The slope of any pattern as a bump (textures spec, section 8.2).
use raggio_math::Vec3;

use crate::map::{Blend, Map};
use crate::pattern::each;
use crate::{Context, Pattern};

/// Directions in which the pattern is sampled: the corners of a tetrahedron.
const PYRAMID: [Vec3; 4] = [
    Vec3::new(0.942809041, -0.333333333, 0.0),
    Vec3::new(-0.471404521, -0.333333333, 0.816496581),
    Vec3::new(-0.471404521, -0.333333333, -0.816496581),
    Vec3::new(0.0, 1.0, 0.0),
];

/// The step that strengths are given for.
const USUAL_STEP: f64 = 0.02;

#[derive(Debug)]
pub(super) struct Slope {
    step: f64,
    strength: f64,
    map: Option<Map<Knot>>,
}

/// An entry of a `slope_map`.
#[derive(Clone, Copy, Debug)]
struct Knot {
    height: f64,
    slope: f64,
}

impl Slope {
    /// `map` holds positions, heights and slopes.
    pub fn new(amount: f64, step: f64, map: Option<&[(f32, f32, f32)]>) -> Self {
        let step = if step == 0.0 { USUAL_STEP } else { step };
        let knot = |&(at, height, slope): &(f32, f32, f32)| {
            (at, Knot { height: f64::from(height), slope: f64::from(slope) })
        };
        Slope {
            step,
            strength: -5.0 * amount * USUAL_STEP / step,
            map: map.map(|m| Map::new(m.iter().map(knot))),
        }
    }

    /// The normal bent at a warped point.
    pub fn bend(&self, pattern: &Pattern, n: Vec3, p: Vec3, context: &Context) -> Vec3 {
        let points = each(&PYRAMID, |&direction| p + self.step * direction);
        let values = pattern.eval_warped4(&points, context);
        PYRAMID
            .iter()
            .zip(values)
            .fold(n, |bent, (&direction, value)| bent + direction * (self.strength * self.height(value)))
    }

    fn height(&self, value: f64) -> f64 {
        match self.map.as_ref().map(|map| map.at(value)) {
            None => value,
            Some(Blend::One(knot)) => knot.map_or(0.0, |knot| knot.height),
            Some(Blend::Two(low, high, u)) => hermite(low, high, u),
        }
    }
}

/// A cubic through both heights; slopes are per interval, whatever its width.
fn hermite(a: &Knot, b: &Knot, u: f64) -> f64 {
    let rise = a.height - b.height;
    let cubic = a.slope + b.slope + 2.0 * rise;
    let square = -(2.0 * a.slope + b.slope + 3.0 * rise);
    ((cubic * u + square) * u + a.slope) * u + a.height
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_cubic_meets_heights_and_slopes() {
        let (a, b) = (Knot { height: 0.2, slope: 1.5 }, Knot { height: 0.9, slope: -2.0 });
        let (h, slope_at) = (1e-6, |u: f64| (hermite(&a, &b, u + 1e-6) - hermite(&a, &b, u)) / 1e-6);
        assert!((hermite(&a, &b, 0.0) - 0.2).abs() < 1e-12);
        assert!((hermite(&a, &b, 1.0) - 0.9).abs() < 1e-12);
        assert!((slope_at(0.0) - 1.5).abs() < 1e-4);
        assert!((slope_at(1.0 - h) + 2.0).abs() < 1e-4);
    }
}
