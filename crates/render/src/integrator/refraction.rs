//! Going through a surface: Snell's law, total reflection, fading inside (light spec, sections 3.3 and 3.5).
use raggio_image::Rgb;
use raggio_math::{EPS, Ray, Vec3};
use raggio_scene::Interior;

use super::dispersion;
use super::interiors::Crossing;
use super::reflection::{reflected, reflected_ray};
use super::surface::SurfacePoint;
use super::{Beam, Seen, Tracer};
use crate::world::{World, WorldInterior};

/// What lies behind a surface.
pub(super) struct Behind {
    pub seen: Seen,
    /// Was it all reflected?
    pub total: bool,
}

/// A ray on its way behind a surface.
pub struct Bent<'a> {
    /// The ray.
    pub beam: Beam<'a>,
    /// Its part of each colour.
    pub hue: Rgb,
    /// Its part of the whole.
    pub share: f32,
    /// Was it reflected instead, beyond the critical angle?
    pub total: bool,
    /// Does it go straight on?
    straight: bool,
}

impl Tracer<'_> {
    /// Follows the ray through the surface.
    #[inline(never)]
    pub(super) fn refract(&mut self, point: &SurfacePoint<'_>, n: Vec3, weight: f32) -> Behind {
        let mut behind = Behind { seen: Seen::BLACK, total: false };
        let world = self.world;
        world.bend(point, n, weight, &mut |bent| {
            let seen = self.trace(&bent.beam, bent.straight);
            behind.seen.add_share(&seen, bent.hue, bent.share);
            behind.total = bent.total && bent.share == 1.0;
        });
        behind
    }
}

impl World {
    /// Calls `each` with the ray behind a surface, or with many where colours part.
    pub(crate) fn bend(
        &self,
        point: &SurfacePoint<'_>,
        n: Vec3,
        weight: f32,
        each: &mut dyn FnMut(Bent<'_>),
    ) {
        let crossing = self.cross(point.beam.interiors, point.material.interior);
        let spreads = crossing.dispersion != 1.0;
        let own = point.beam.wavelength;
        if (crossing.eta - 1.0).abs() < EPS && !spreads {
            let ray = Ray::new(point.surface.p, point.beam.ray.dir);
            let beam = through(point, &ray, weight, &crossing);
            return each(Bent { beam, hue: Rgb::ONE, share: 1.0, total: false, straight: true });
        }
        let mut one = |wavelength: Option<f64>, hue: Rgb, share: f32| {
            let eta = match wavelength {
                Some(wavelength) if spreads => dispersion::eta(&crossing, wavelength),
                _ => crossing.eta,
            };
            let refracted = refracted_direction(point.beam.ray.dir, n, eta);
            let total = refracted.is_none();
            let ray = match refracted {
                Some(dir) => Ray::new(point.surface.p, dir),
                None => reflected_ray(point, n),
            };
            let beam = match total {
                false => through(point, &ray, weight, &crossing),
                true => reflected(point, &ray, weight),
            };
            each(Bent { beam: Beam { wavelength, ..beam }, hue, share, total, straight: false });
        };
        if !spreads || own.is_some() {
            return one(own, Rgb::ONE, 1.0);
        }
        let count = crossing.samples.max(1);
        let share = 1.0 / count as f32;
        for i in 0..count {
            let (wavelength, hue) = dispersion::sample(i, count);
            one(Some(wavelength), hue * share, share);
        }
    }
}

fn through<'a>(point: &SurfacePoint<'_>, ray: &'a Ray, weight: f32, crossing: &'a Crossing) -> Beam<'a> {
    Beam {
        ray,
        interiors: &crossing.interiors,
        weight,
        class: point.beam.class,
        alpha: point.beam.alpha,
        wavelength: point.beam.wavelength,
        reach: f64::INFINITY,
    }
}

/// Snell's law for unit vectors; `None` is total reflection.
pub(crate) fn refracted_direction(d: Vec3, n: Vec3, eta: f64) -> Option<Vec3> {
    let cosine = d.dot(n);
    let (c, m) = if cosine <= 0.0 { (-cosine, n) } else { (cosine, -n) };
    let t = 1.0 + eta * eta * (c * c - 1.0);
    if t < 0.0 {
        return None;
    }
    (d * eta + m * (eta * c - t.sqrt())).try_normalize()
}

impl WorldInterior {
    /// What is left of light that came through the object to the point, for a ray that was inside it.
    pub(super) fn seen_through(&self, point: &SurfacePoint<'_>) -> Rgb {
        let old = self.interior.old_refraction;
        let inside = point.beam.interiors.contains(&point.material.interior);
        if inside { fade(&self.interior, point.depth) * old } else { Rgb::splat(old) }
    }
}

/// The part of light that is left after a way inside (light spec, section 3.5).
pub(crate) fn fade(interior: &Interior, depth: f64) -> Rgb {
    if f64::from(interior.fade_distance).abs() <= EPS {
        return Rgb::ONE;
    }
    let way = (depth / f64::from(interior.fade_distance)) as f32;
    let color = interior.fade_color;
    if interior.fade_power >= 1000.0 {
        let dim = (color - Rgb::ONE) * way;
        return Rgb::new(dim.x.exp(), dim.y.exp(), dim.z.exp());
    }
    color + (Rgb::ONE - color) / (1.0 + way.powf(interior.fade_power))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn refraction_obeys_snell() {
        for (eta, degrees) in [(1.0 / 1.5, 40.0), (1.5, 30.0), (1.0 / 2.4, 85.0)] {
            let i = f64::to_radians(degrees);
            let d = Vec3::new(i.sin(), -i.cos(), 0.0);
            let t = refracted_direction(d, Vec3::Y, eta).unwrap();
            assert!((t.x - eta * i.sin()).abs() < 1e-12 && t.y < 0.0);
            assert!((t.length() - 1.0).abs() < 1e-12);
            // The other side of the normal changes nothing.
            assert_eq!(refracted_direction(d, -Vec3::Y, eta), Some(t));
        }
    }

    #[test]
    fn beyond_the_critical_angle_nothing_passes() {
        let at = |degrees: f64| {
            let i = degrees.to_radians();
            refracted_direction(Vec3::new(i.sin(), -i.cos(), 0.0), Vec3::Y, 1.5)
        };
        // asin(1 / 1.5) is 41.81 degrees.
        assert!(at(41.8).is_some());
        assert!(at(41.82).is_none());
    }

    #[test]
    fn fading_by_power_and_exponentially() {
        let mut interior = Interior {
            fade_distance: 2.0,
            fade_power: 2.0,
            fade_color: Rgb::new(0.0, 0.5, 1.0),
            ..Default::default()
        };
        assert!((fade(&interior, 4.0) - Rgb::new(0.2, 0.6, 1.0)).length() < 1e-6);
        interior.fade_power = 1001.0;
        assert!((fade(&interior, 4.0).x - (-2f32).exp()).abs() < 1e-6);
        interior.fade_distance = 0.0;
        assert_eq!(fade(&interior, 4.0), Rgb::ONE);
    }
}
