//! Fog, even and near the ground (light spec, section 6.2).
use raggio_image::{Color, Rgb, grey};
use raggio_math::{EPS, Ray, Vec3, noise};
use raggio_scene::{self as scene, FogKind, Turbulence};
use raggio_shading::Noise;

use crate::integrator::Seen;

/// A fog that has an effect.
pub struct Fog {
    kind: FogKind,
    color: Color,
    distance: f64,
    turbulence: Option<Rough>,
    generator: u8,
}

/// What makes fog uneven.
struct Rough {
    turbulence: Turbulence,
    depth: f64,
    /// More than turbulence times depth ever is.
    most: f64,
}

/// A part of the way that makes less of a difference than colours can show.
const UNSEEN: f64 = 1e-9;
/// No octave of turbulence is larger before it is weighted.
const MOST_OCTAVE: f64 = 1.5;

impl Fog {
    /// `None` where the distance is zero, which switches fog off.
    pub fn new(fog: &scene::Fog, noise: Noise) -> Option<Fog> {
        let kind = match fog.kind {
            FogKind::Ground { offset, alt, up } => {
                FogKind::Ground { offset, alt, up: up.try_normalize().unwrap_or(Vec3::Y) }
            }
            FogKind::Constant => FogKind::Constant,
        };
        (fog.distance.abs() > EPS).then(|| Fog {
            kind,
            color: fog.color,
            distance: fog.distance,
            turbulence: fog
                .turbulence
                .filter(|t| t.amount != Vec3::ZERO)
                .map(|t| Rough::new(t, fog.turb_depth)),
            generator: noise.generator,
        })
    }

    /// How much passes unchanged over the way to `depth`.
    fn clearness(&self, ray: &Ray, depth: f64) -> f32 {
        let density = match self.kind {
            FogKind::Constant => 1.0,
            FogKind::Ground { offset, alt, up } => {
                let height = |p: Vec3| (p.dot(up) - offset) / alt;
                mean_density(height(ray.origin), height(ray.at(depth)))
            }
        };
        let mut way = depth;
        if let Some(rough) = &self.turbulence {
            let share = (-depth / self.distance).exp();
            // Over long ways turbulence changes nothing.
            if share * rough.most > UNSEEN {
                way *= 1.0 - share * rough.at(self.generator, ray.at(depth / 2.0)).min(1.0);
            }
        }
        ((-way * density / self.distance).exp() as f32).max(self.color.transmit)
    }

    /// What passes, per channel.
    fn filter(&self, clear: f32) -> Rgb {
        (Rgb::splat(1.0 - self.color.filter) + self.color.rgb * self.color.filter) * clear
    }
}

impl Rough {
    fn new(turbulence: Turbulence, depth: f64) -> Rough {
        let omega = f64::from(turbulence.omega).abs();
        let octaves: f64 = (0..turbulence.octaves as i32).map(|k| omega.powi(k)).sum();
        Rough { turbulence, depth, most: MOST_OCTAVE * octaves * depth.abs() }
    }

    fn at(&self, generator: u8, p: Vec3) -> f64 {
        let t = &self.turbulence;
        noise::turbulence(generator, p * t.amount, t.octaves, t.omega, t.lambda) * self.depth
    }
}

/// The mean of `1 / (1 + y^2)` above zero and 1 below, between two heights.
fn mean_density(y0: f64, y1: f64) -> f64 {
    match (y0 > 0.0, y1 > 0.0) {
        (false, false) => 1.0,
        (false, true) => (y1.atan() - y0) / (y1 - y0),
        (true, false) => (y0.atan() - y1) / (y0 - y1),
        (true, true) if (y0 - y1).abs() <= EPS => 1.0 / (y0 * y0 + 1.0),
        (true, true) => (y0.atan() - y1.atan()) / (y0 - y1),
    }
}

/// Lays all fogs over what was seen. Their own colours do not dim each other.
pub(super) fn apply(fogs: &[Fog], ray: &Ray, depth: f64, seen: &mut Seen) {
    let (mut own, mut filter) = (Rgb::ZERO, Rgb::ONE);
    for fog in fogs {
        let clear = fog.clearness(ray, depth);
        own += fog.color.rgb * (1.0 - clear);
        filter *= fog.filter(clear);
    }
    *seen = Seen::new(own + seen.rgb() * filter, seen.transmit() * grey(filter));
}

/// What the fogs leave of light, without their own colour.
pub(super) fn filter(fogs: &[Fog], ray: &Ray, depth: f64) -> Rgb {
    fogs.iter().map(|fog| fog.filter(fog.clearness(ray, depth))).product()
}

#[cfg(test)]
mod tests {
    use super::*;

    fn fog(kind: FogKind) -> Fog {
        let fog = scene::Fog {
            kind,
            color: Color::from_array([0.5, 0.25, 1.0, 0.0, 0.0]),
            distance: 10.0,
            turbulence: None,
            turb_depth: 0.5,
        };
        Fog::new(&fog, Noise { generator: 2, waves: 10 }).unwrap()
    }

    #[test]
    fn even_fog_thins_out_exponentially() {
        let mut seen = Seen::new(Rgb::ONE, 1.0);
        apply(&[fog(FogKind::Constant)], &Ray::new(Vec3::ZERO, Vec3::Z), 5.0, &mut seen);
        let a = (-0.5f32).exp();
        assert!((seen.rgb() - (Rgb::new(0.5, 0.25, 1.0) * (1.0 - a) + Rgb::splat(a))).length() < 1e-6);
        assert!((seen.transmit() - a).abs() < 1e-6);
    }

    #[test]
    fn turbulence_counts_until_it_cannot_be_seen() {
        let even = fog(FogKind::Constant);
        let turbulence = Turbulence { amount: Vec3::ONE, ..Turbulence::default() };
        let rough = Fog { turbulence: Some(Rough::new(turbulence, 0.5)), ..fog(FogKind::Constant) };
        let clear =
            |fog: &Fog, depth: f64| fog.clearness(&Ray::new(Vec3::new(0.3, 0.7, 0.1), Vec3::Z), depth);
        assert!((clear(&rough, 5.0) - clear(&even, 5.0)).abs() > 1e-3);
        let limit = 10.0 * (1.5 * 0.5 * 2.0 / UNSEEN).ln();
        for depth in [0.8 * limit, 0.9 * limit, 0.99 * limit, 1.01 * limit] {
            assert!((clear(&rough, depth) - clear(&even, depth)).abs() < 1e-7, "{depth}");
        }
    }

    #[test]
    fn ground_fog_is_the_integral_of_its_density() {
        let density = |y: f64| if y <= 0.0 { 1.0 } else { 1.0 / (1.0 + y * y) };
        for (y0, y1) in [(-2.0, -1.0), (-1.0, 2.0), (3.0, -0.5), (0.5, 4.0)] {
            let n = 20_000;
            let sum: f64 =
                (0..n).map(|i| density(y0 + (y1 - y0) * (f64::from(i) + 0.5) / f64::from(n))).sum();
            assert!((mean_density(y0, y1) - sum / f64::from(n)).abs() < 1e-6, "{y0} {y1}");
        }
        assert!((mean_density(2.0, 2.0) - 0.2).abs() < 1e-12);
    }

    #[test]
    fn two_fogs_multiply_what_lies_behind_and_add_their_own() {
        let fogs = [fog(FogKind::Constant), fog(FogKind::Constant)];
        let mut seen = Seen::BLACK;
        apply(&fogs, &Ray::new(Vec3::ZERO, Vec3::Z), 5.0, &mut seen);
        assert!((seen.rgb().x - (1.0 - (-0.5f32).exp())).abs() < 1e-6);
    }
}
