//! Patterns that look at the surface: `slope` and `aoi`.
use std::f64::consts::PI;

use raggio_math::{EPS, Vec3};
use raggio_scene as scene;

use crate::Context;

/// A compiled `slope`.
#[derive(Debug)]
pub(super) struct Slope {
    direction: Direction,
    range: Range,
    altitude: Option<Altitude>,
}

#[derive(Debug)]
enum Direction {
    /// Unit.
    Along(Vec3),
    To(Vec3),
}

#[derive(Debug)]
struct Altitude {
    /// Unit.
    axis: Vec3,
    range: Range,
    /// How much the slope counts beside the altitude, 0..=1.
    slope_weight: f64,
}

/// The part of the values that becomes 0..1.
#[derive(Debug)]
struct Range {
    low: f64,
    width: f64,
}

impl Range {
    fn new((low, high): (f64, f64)) -> Self {
        Range { low, width: high - low }
    }

    fn rescale(&self, v: f64) -> f64 {
        if self.width == 0.0 { v } else { (v - self.low) / self.width }
    }
}

impl Slope {
    pub fn new(settings: &scene::SlopeSettings) -> Self {
        let length = settings.direction.length();
        let direction = if settings.point_at {
            Direction::To(settings.direction)
        } else {
            Direction::Along(settings.direction.normalize_or_zero())
        };
        let altitude = settings.altitude.map(|axis| {
            let total = length + axis.length();
            Altitude {
                axis: axis.normalize_or_zero(),
                range: Range::new(settings.altitude_range),
                slope_weight: if total > 0.0 { length / total } else { 1.0 },
            }
        });
        Slope { direction, range: Range::new(settings.slope_range), altitude }
    }

    pub fn value(&self, p: Vec3, context: &Context) -> f64 {
        let Some(normal) = context.normal else { return 0.0 };
        let direction = match self.direction {
            Direction::Along(direction) => direction,
            Direction::To(point) => (point - context.point).normalize_or_zero(),
        };
        let turned = normal.dot(direction).clamp(-1.0, 1.0).asin() / PI + 0.5;
        let slope = self.range.rescale(turned);
        match &self.altitude {
            None if slope == 1.0 => 1.0 - EPS,
            None => slope - slope.floor(),
            Some(altitude) => altitude.mix(slope, p),
        }
    }
}

impl Altitude {
    fn mix(&self, slope: f64, p: Vec3) -> f64 {
        let height = self.range.rescale(p.dot(self.axis));
        let v = self.slope_weight * slope + (1.0 - self.slope_weight) * height;
        if (v - 1.0).abs() < EPS { 1.0 - EPS } else { v - v.floor() }
    }
}

/// The angle between the surface and the ray: 0.5 at a right angle, 0 or 1 head on.
pub(super) fn aoi(context: &Context) -> f64 {
    match context.normal {
        Some(n) if context.ray_dir != Vec3::ZERO => {
            let cosine = n.normalize_or_zero().dot(context.ray_dir.normalize_or_zero());
            cosine.clamp(-1.0, 1.0).acos() / PI
        }
        _ => 0.0,
    }
}
