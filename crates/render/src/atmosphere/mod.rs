//! Empty space: background, sky sphere, rainbows, fog (light spec, section 6).
mod fog;
mod rainbow;
mod sky;

use raggio_math::{Ray, Vec3};
use raggio_scene::Scene;
use raggio_shading::Noise;

use crate::integrator::{Beam, Seen};
use crate::sampling::Stream;
use fog::Fog;
use rainbow::Rainbow;
use sky::Dome;

/// Everything that fills empty space but media.
pub struct Sky {
    dome: Dome,
    fogs: Vec<Fog>,
    rainbows: Vec<Rainbow>,
}

impl Sky {
    /// Makes the sky of a scene ready.
    pub fn new(scene: &Scene, noise: Noise) -> Sky {
        let atmosphere = &scene.atmosphere;
        Sky {
            dome: Dome::new(scene, noise),
            fogs: atmosphere.fogs.iter().filter_map(|f| Fog::new(f, noise)).collect(),
            rainbows: atmosphere.rainbows.iter().map(|r| Rainbow::new(r, noise)).collect(),
        }
    }

    /// Is there neither fog nor rainbow?
    pub fn is_clear(&self) -> bool {
        self.fogs.is_empty() && self.rainbows.is_empty()
    }

    /// What a ray sees that hits nothing.
    pub fn miss(&self, beam: &Beam<'_>) -> Seen {
        self.beyond(beam.ray.dir, beam.alpha)
    }

    /// What lies behind everything in a direction. `alpha`: transparency is kept.
    #[inline]
    pub fn beyond(&self, dir: Vec3, alpha: bool) -> Seen {
        self.dome.miss(dir, alpha)
    }

    /// Lays the rainbows over what was seen at `depth`.
    pub fn rainbows(&self, ray: &Ray, depth: f64, random: &mut Stream, seen: &mut Seen) {
        if !self.rainbows.is_empty() {
            rainbow::apply(&self.rainbows, ray, depth, random, seen);
        }
    }

    /// Lays the fogs over what was seen at `depth`.
    pub fn fogs(&self, ray: &Ray, depth: f64, seen: &mut Seen) {
        if !self.fogs.is_empty() {
            fog::apply(&self.fogs, ray, depth, seen);
        }
    }

    /// What the fogs leave of light that comes along a ray.
    pub fn fog_filter(&self, ray: &Ray, depth: f64) -> raggio_image::Rgb {
        fog::filter(&self.fogs, ray, depth)
    }
}
