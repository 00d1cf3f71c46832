//! Rainbows (light spec, section 6.3).
use std::f64::consts::PI;
use std::sync::Arc;

use raggio_image::{Color, Rgb};
use raggio_math::{EPS, Ray, Vec3};
use raggio_scene::{self as scene, ColorMap, PigmentKind};
use raggio_shading::{Context, Noise, Pigment};

use crate::integrator::Seen;
use crate::sampling::Stream;

/// A rainbow ready to be seen.
pub struct Rainbow {
    /// Towards the middle of the bow, and its frame.
    direction: Vec3,
    right: Vec3,
    up: Vec3,
    /// Inner edge and width in radians.
    inner: f64,
    width: f64,
    distance: f64,
    jitter: f64,
    /// Half angles in radians.
    arc: f64,
    falloff: f64,
    colors: Colors,
}

/// Where the colours across the bow come from.
enum Colors {
    Map(Arc<ColorMap>),
    /// Anything else is asked along x.
    Pigment(Box<Pigment>),
}

impl Rainbow {
    /// Makes a rainbow ready.
    pub fn new(bow: &scene::Rainbow, noise: Noise) -> Rainbow {
        let unit = |v: Vec3| v.try_normalize().unwrap_or(Vec3::Y);
        let direction = unit(bow.direction);
        let right = unit(bow.up.cross(direction));
        // 180 radians and not degrees: without these words nothing is cut off.
        let half = |angle: Option<f64>| angle.map(|a| a * PI / 360.0);
        let arc = half(bow.arc_angle).unwrap_or(180.0);
        Rainbow {
            direction,
            right,
            up: unit(direction.cross(right)),
            inner: (bow.angle - bow.width / 2.0).to_radians(),
            width: bow.width.to_radians(),
            distance: bow.distance,
            jitter: bow.jitter,
            arc,
            falloff: half(bow.falloff_angle).unwrap_or(arc),
            colors: match &bow.pigment.kind {
                PigmentKind::ColorMap { map, .. } => Colors::Map(map.clone()),
                _ => Colors::Pigment(Box::new(Pigment::compile(&bow.pigment, noise))),
            },
        }
    }

    /// What the bow makes of `behind`, and the part of it that is seen through; `None` beside the bow.
    fn over(&self, ray: &Ray, depth: f64, random: &mut Stream, behind: Rgb) -> Option<(Rgb, f32)> {
        let (x, y) = (ray.dir.dot(self.right), ray.dir.dot(self.up));
        let forward = ray.dir.dot(self.direction);
        let across = x.hypot(y);
        let beta = (if across > 0.0 { y / across } else { y }).clamp(-1.0, 1.0).acos();
        if beta > self.arc || forward < 0.0 {
            return None;
        }
        let mut index = (forward.min(1.0).acos() - self.inner) / self.width;
        if self.jitter != 0.0 {
            index += (2.0 * random.next() - 1.0) * self.jitter;
        }
        if !(0.0..=1.0 - EPS).contains(&index) {
            return None;
        }
        let color = self.colors.at(index);
        let fade = if beta > self.falloff && self.arc != self.falloff {
            let z = ((beta - self.falloff) / (self.arc - self.falloff)) as f32;
            (3.0 - 2.0 * z) * z * z
        } else {
            0.0
        };
        let clear =
            ((-depth / self.distance).exp() as f32).max(fade * (1.0 - color.transmit) + color.transmit);
        let tint = color.filter * (1.0 - clear);
        let filtered = behind * (Rgb::splat(1.0 - tint) + color.rgb * tint);
        Some((filtered * clear + color.rgb * (1.0 - clear), clear * color.transmit))
    }
}

impl Colors {
    fn at(&self, index: f64) -> Color {
        match self {
            Colors::Map(map) => look_up(map, index),
            Colors::Pigment(pigment) => pigment.eval(Vec3::X * index, &Context::NONE).unwrap_or_default(),
        }
    }
}

/// The colour at a position of a map (textures spec, section 9.1).
fn look_up(map: &ColorMap, value: f64) -> Color {
    let place = |i: usize| f64::from(map[i].0);
    match map.iter().position(|entry| value <= f64::from(entry.0)) {
        None => map.last().map_or(Color::BLACK, |entry| entry.1),
        Some(0) => map[0].1,
        Some(i) if value == place(i) => map[i].1,
        Some(i) => map[i - 1].1.lerp(map[i].1, (value - place(i - 1)) / (place(i) - place(i - 1))),
    }
}

/// Lays the rainbows over what was seen: the mean of what each makes of it.
pub(super) fn apply(bows: &[Rainbow], ray: &Ray, depth: f64, random: &mut Stream, seen: &mut Seen) {
    let (mut sum, mut count, mut through) = (Rgb::ZERO, 0.0, 1.0);
    for bow in bows {
        if let Some((rgb, clear)) = bow.over(ray, depth, random, seen.rgb()) {
            sum += rgb;
            count += 1.0;
            through *= clear;
        }
    }
    if count > 0.0 {
        *seen = Seen::new(sum / count, seen.transmit() * through);
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use raggio_math::FAR;

    fn bow() -> Rainbow {
        let map = vec![
            (0.0, Color::from_array([1.0, 0.0, 0.0, 0.0, 0.5])),
            (1.0, Color::from_array([0.0, 0.0, 1.0, 0.0, 0.5])),
        ];
        Rainbow {
            direction: Vec3::Z,
            right: Vec3::X,
            up: Vec3::Y,
            inner: 40f64.to_radians(),
            width: 4f64.to_radians(),
            distance: 1e7,
            jitter: 0.0,
            arc: 180.0,
            falloff: 180.0,
            colors: Colors::Map(Arc::new(map)),
        }
    }

    fn seen_at(degrees: f64) -> Seen {
        let angle = degrees.to_radians();
        let mut seen = Seen::new(Rgb::ONE, 1.0);
        let ray = Ray::new(Vec3::ZERO, Vec3::new(0.0, angle.sin(), angle.cos()));
        apply(&[bow()], &ray, FAR, &mut Stream::default(), &mut seen);
        seen
    }

    #[test]
    fn the_bow_stands_at_its_angle() {
        let red = seen_at(40.0 + 1e-6);
        assert!((red.rgb() - Rgb::new(1.0, 0.5, 0.5)).length() < 1e-4, "{red:?}");
        let middle = seen_at(42.0);
        assert!((middle.rgb() - Rgb::new(0.75, 0.5, 0.75)).length() < 1e-4);
        assert!((middle.transmit() - 0.25).abs() < 1e-6);
        for outside in [39.9, 44.1, 120.0] {
            assert_eq!(seen_at(outside), Seen::new(Rgb::ONE, 1.0));
        }
    }
}
