//! Mirrors: how much a layer reflects, and what (light spec, section 3.4).
use raggio_geometry::RayClass;
use raggio_image::Rgb;
use raggio_math::{EPS, Ray, Vec3};
use raggio_scene::{Finish, Irid, Reflection};
use raggio_shading::Layer;

use super::local::tinted;
use super::surface::SurfacePoint;
use super::{Beam, Tracer};

/// A layer's reflection, put off until all layers are known.
pub struct Mirror {
    /// The layer's normal.
    pub n: Vec3,
    /// What part of each colour is reflected.
    pub reflectivity: Rgb,
    /// What a thin film makes of the light that is seen in the mirror; it takes nothing from the layers below.
    film: Rgb,
    weight: f32,
    exponent: f32,
}

impl Tracer<'_> {
    /// What a layer will mirror; `None` where it has no reflection at all.
    #[inline(always)]
    pub(crate) fn mirror(
        &self,
        point: &SurfacePoint<'_>,
        layer: &Layer,
        n: Vec3,
        rgb: Rgb,
        through: f32,
    ) -> Option<Mirror> {
        layer.mirrors.then(|| self.mirror_of(point, &layer.finish, n, rgb, through))
    }

    /// What a layer with a reflection will mirror.
    fn mirror_of(
        &self,
        point: &SurfacePoint<'_>,
        finish: &Finish,
        n: Vec3,
        rgb: Rgb,
        through: f32,
    ) -> Mirror {
        let reflection = &finish.reflection;
        let cosine = -point.beam.ray.dir.dot(n);
        let (mut reflectivity, factor) = if reflection.fresnel {
            let index = self.world.fresnel_index(point.beam.interiors, point.material.interior);
            let share = fresnel(index, cosine);
            let reflectivity = share_of(reflection, share);
            (reflectivity, reflectivity.max_element())
        } else {
            (
                share_of(reflection, grazing(cosine, reflection.falloff)),
                reflection.min.max(reflection.max).max_element(),
            )
        };
        if reflection.metallic != 0.0 {
            reflectivity = tinted(reflectivity, reflection.metallic, cosine, rgb);
        }
        let weight = point.beam.weight * through * factor;
        let film = self.film(finish.irid.as_ref(), point, n);
        Mirror { n, reflectivity, film, weight, exponent: reflection.exponent }
    }

    /// What a thin film makes of light that is seen mirrored.
    pub(super) fn film(&self, irid: Option<&Irid>, point: &SurfacePoint<'_>, n: Vec3) -> Rgb {
        let Some(irid) = irid else { return Rgb::ONE };
        let d = point.beam.ray.dir;
        let way = n.dot(d).abs() + n.dot(reflected_direction(d, n, point.n)).abs();
        self.interference(irid, point.surface.p, way)
    }

    /// The light that comes by way of a mirror.
    pub(super) fn mirrored(&mut self, point: &SurfacePoint<'_>, mirror: &Mirror) -> Rgb {
        if mirror.reflectivity == Rgb::ZERO || mirror.weight < self.bailout || !self.quality.reflection() {
            return Rgb::ZERO;
        }
        let ray = reflected_ray(point, mirror.n);
        let rgb = self.trace(&reflected(point, &ray, mirror.weight), false).rgb();
        mirror.apply(rgb) * mirror.film
    }
}

impl Mirror {
    /// What is left of light after the mirror.
    pub fn apply(&self, light: Rgb) -> Rgb {
        let raised =
            if self.exponent == 1.0 { light } else { light.max(Rgb::ZERO).powf(1.0 / self.exponent) };
        self.reflectivity * raised
    }
}

/// Where a surface mirrors a ray to.
#[inline]
pub(crate) fn reflected_ray(point: &SurfacePoint<'_>, n: Vec3) -> Ray {
    Ray::new(point.surface.p, reflected_direction(point.beam.ray.dir, n, point.n))
}

/// The beam along a ray that a surface mirrors.
pub(crate) fn reflected<'a>(point: &SurfacePoint<'a>, ray: &'a Ray, weight: f32) -> Beam<'a> {
    let beam = point.beam;
    let class = match beam.class {
        RayClass::Camera => RayClass::Reflected,
        RayClass::Photon => RayClass::ReflectedPhoton,
        other => other,
    };
    Beam {
        ray,
        interiors: beam.interiors,
        weight,
        class,
        alpha: false,
        wavelength: beam.wavelength,
        reach: f64::INFINITY,
    }
}

/// Mirrors `d` at a bent normal, so that it does not go into the surface with the raw normal `raw`.
fn reflected_direction(d: Vec3, n: Vec3, raw: Vec3) -> Vec3 {
    let mirror = |v: Vec3, n: Vec3| v - n * (2.0 * v.dot(n));
    let mut r = mirror(d, n);
    if r.dot(raw) < 0.0 {
        r = if r.dot(n) < 0.0 { mirror(d, raw) } else { mirror(r, raw) };
    }
    r.try_normalize().unwrap_or(raw)
}

fn share_of(reflection: &Reflection, share: f64) -> Rgb {
    if share < EPS {
        reflection.min
    } else if (share - 1.0).abs() < EPS {
        reflection.max
    } else {
        reflection.max * share as f32 + reflection.min * (1.0 - share) as f32
    }
}

/// The share of the grazing colour where no physics is asked for.
fn grazing(cosine: f64, falloff: f32) -> f64 {
    let base = (1.0 - cosine).max(0.0);
    if falloff == 1.0 { base } else { base.powf(f64::from(falloff)) }
}

/// The part of unpolarised light that a dielectric reflects (Fresnel's equations in the form of Cook and Torrance
/// 1982); 1 beyond the critical angle.
pub(crate) fn fresnel(index: f64, cosine: f64) -> f64 {
    let s = index * index + cosine * cosine - 1.0;
    if s <= 0.0 {
        return 1.0;
    }
    let (g, c) = (s.sqrt(), cosine);
    let ratio = (g - c) / (g + c);
    let other = (c * (g + c) - 1.0) / (c * (g - c) + 1.0);
    (0.5 * ratio * ratio * (1.0 + other * other)).clamp(0.0, 1.0)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn fresnel_agrees_with_the_amplitude_equations() {
        for (index, degrees) in [(1.5, 0.0), (1.5, 30.0), (1.33, 60.0), (2.4, 80.0), (1.0 / 1.5, 30.0)] {
            let (i, n): (f64, f64) = (f64::to_radians(degrees), index);
            let (ci, ct) = (i.cos(), (1.0 - (i.sin() / n).powi(2)).sqrt());
            let (s, p) = ((ci - n * ct) / (ci + n * ct), (n * ci - ct) / (n * ci + ct));
            assert!((fresnel(n, ci) - (s * s + p * p) / 2.0).abs() < 1e-12, "{index} {degrees}");
        }
        assert!((fresnel(1.5, 1.0) - 0.04).abs() < 1e-12);
        assert_eq!(fresnel(1.0 / 1.5, 45f64.to_radians().cos()), 1.0);
    }

    #[test]
    fn bent_normals_do_not_mirror_into_the_surface() {
        let raw = Vec3::Y;
        let n = Vec3::new(0.8, 0.6, 0.0);
        for d in [Vec3::new(-1.0, -0.1, 0.0), Vec3::new(1.0, -0.2, 0.1), Vec3::new(0.1, -1.0, 0.3)] {
            let r = reflected_direction(d.normalize(), n, raw);
            assert!(r.dot(raw) >= 0.0 && (r.length() - 1.0).abs() < 1e-12, "{d} {r}");
        }
        assert!((reflected_direction(-Vec3::Y, raw, raw) - Vec3::Y).length() < 1e-15);
    }

    #[test]
    fn plain_reflection_goes_from_min_to_max_by_falloff() {
        let reflection = Reflection { min: Rgb::splat(0.2), max: Rgb::splat(0.8), ..Default::default() };
        assert_eq!(share_of(&reflection, grazing(1.0, 3.0)), Rgb::splat(0.2));
        assert_eq!(share_of(&reflection, grazing(0.0, 3.0)), Rgb::splat(0.8));
        let middle = share_of(&reflection, grazing(0.5, 2.0)).x;
        assert!((middle - (0.25 * 0.8 + 0.75 * 0.2)).abs() < 1e-6);
    }
}
