//! Subsurface light: light that enters a surface, is scattered inside and leaves elsewhere (subsurface spec, section 4;
//! the dipole of Jensen, Marschner, Levoy and Hanrahan 2001).
mod dipole;
mod scatter;

use raggio_image::Rgb;
use raggio_math::Vec3;
use raggio_scene::{Finish, SubsurfaceSettings};

use crate::integrator::Tracer;
use crate::integrator::surface::SurfacePoint;
pub use dipole::Albedo;
use dipole::{Coefficients, fresnel_transmission};

/// A scene's settings.
#[derive(Clone, Copy)]
pub struct Rules {
    samples: SubsurfaceSettings,
    mm_per_unit: f64,
}

impl Rules {
    /// `None` where the scene has no subsurface light.
    pub fn new(settings: &raggio_scene::Settings) -> Option<Rules> {
        let mm_per_unit = f64::from(settings.mm_per_unit);
        settings.subsurface.map(|samples| Rules { samples, mm_per_unit })
    }

    /// Samples of multiple and of single scattering; fewer for light that is scattered twice over.
    fn samples(&self, depth: u32) -> (u32, u32) {
        match depth {
            0 => (self.samples.diffuse_samples, self.samples.single_samples),
            1 => (1, 1),
            _ => (0, 0),
        }
    }
}

/// A surface point with what scatters under it.
struct Site<'a> {
    point: &'a SurfacePoint<'a>,
    coefficients: Coefficients,
    /// Refractive index of the inside as seen from outside.
    eta: f64,
    /// The layer's normal, which faces the ray.
    n: Vec3,
    /// Cosine between the normal and the way back to the viewer.
    cos_out: f64,
    mm_per_unit: f64,
}

impl Tracer<'_> {
    /// The light from under the surface of a layer, instead of its diffuse light; `None` where it has none.
    pub(crate) fn light_from_below(
        &mut self,
        point: &SurfacePoint<'_>,
        finish: &Finish,
        n: Vec3,
        rgb: Rgb,
    ) -> Option<Rgb> {
        let world = self.world;
        let rules = world.subsurface.as_ref().filter(|_| self.quality.global_light())?;
        let translucency = finish.subsurface?.translucency;
        let (many, single) = rules.samples(self.scatter_depth);
        if many == 0 && single == 0 {
            return Some(Rgb::ZERO);
        }
        let albedo = world.interior(point.material.interior).albedo.as_ref()?;
        let eta = world.fresnel_index(point.beam.interiors, point.material.interior);
        let site = Site {
            point,
            coefficients: Coefficients::new(albedo, rgb * finish.diffuse_raw, translucency, eta),
            eta,
            n,
            cos_out: (-point.beam.ray.dir.dot(n)).clamp(0.0, 1.0),
            mm_per_unit: rules.mm_per_unit,
        };
        self.scatter_depth += 1;
        let sum = self.scattered_often(&site, many) + self.scattered_once(&site, single);
        self.scatter_depth -= 1;
        Some(sum)
    }
}
