//! Where light enters: places around a point for light that is scattered often, and along the refracted ray for light
//! that is scattered once (subsurface spec, sections 4.3 to 4.6).
use std::f64::consts::{PI, TAU};
use std::sync::LazyLock;

use raggio_geometry::RayClass;
use raggio_image::Rgb;
use raggio_math::{EPS, MIN_HIT, Ray, Vec3};

use super::{Site, fresnel_transmission};
use crate::integrator::refraction::refracted_direction;
use crate::integrator::{Beam, Tracer};
use crate::lights::{LightSource, Start};
use crate::sampling::halton;

/// A place where light enters.
struct Entry {
    p: Vec3,
    n: Vec3,
    t: f64,
    same: bool,
}

impl Tracer<'_> {
    /// The first surface along a ray, and whether it bounds the same interior.
    fn entry(&self, site: &Site<'_>, ray: &Ray, reach: f64) -> Option<Entry> {
        let world = self.world;
        let hit = world.geometry.closest(ray, (MIN_HIT, reach), RayClass::Any)?;
        let surface = world.geometry.interaction(ray, &hit);
        let same = world.material(&surface).interior == site.point.material.interior;
        Some(Entry { p: surface.p, n: surface.n, t: hit.t, same })
    }

    /// What arrives of a light at a place on the surface, with the direction to it.
    fn light_at(&mut self, site: &Site<'_>, light: &LightSource, p: Vec3) -> (Rgb, Vec3) {
        let path = light.path(p);
        let bare = light.arriving(&path, light.position);
        let collects = site.point.material.photons.collect.unwrap_or(true);
        let start = Start { interiors: &[], collects, own: None };
        (self.after_shadows(light, &path, bare, &start), path.ray.dir)
    }

    /// Light that was scattered so often that its direction is lost.
    pub(super) fn scattered_often(&mut self, site: &Site<'_>, samples: u32) -> Rgb {
        let mean = site.coefficients.mean_extinction();
        if samples == 0 || mean <= 0.0 {
            return Rgb::ZERO;
        }
        let free_path = 1.0 / (mean * site.mm_per_unit);
        let x = site.point.surface.p;
        let inward = Ray::new(x, -site.n);
        let depth = match self.entry(site, &inward, 2.0 * free_path) {
            Some(entry) if entry.same => entry.t / 2.0,
            Some(entry) => free_path.min(entry.t - EPS),
            None => free_path,
        };
        let base = inward.at(depth);
        let leaving = fresnel_transmission(site.eta, site.cos_out);
        let (mut sum, mut hits) = (Rgb::ZERO, 0);
        for _ in 0..samples {
            let ray = Ray::new(base, self.next_sphere_direction());
            let Some(entry) = self.entry(site, &ray, f64::INFINITY) else { continue };
            hits += 1;
            if !entry.same {
                continue;
            }
            let mut light = Rgb::ZERO;
            for &i in site.point.lights {
                let source = &self.world.lights[i as usize];
                let (arriving, dir) = self.light_at(site, source, entry.p);
                let c = entry.n.dot(dir).abs();
                light += arriving * (c * fresnel_transmission(site.eta, c)) as f32;
            }
            if light == Rgb::ZERO {
                continue;
            }
            let cosine = entry.n.dot(ray.dir).abs().max(0.01);
            let area = 4.0 * PI * (entry.t * site.mm_per_unit).powi(2) / cosine;
            let answer = site.coefficients.dipole((entry.p - x).length() * site.mm_per_unit);
            sum += light * answer * (area * leaving) as f32;
        }
        if hits > 0 { sum / hits as f32 } else { Rgb::ZERO }
    }

    /// Light that was scattered once, and what passes straight through.
    pub(super) fn scattered_once(&mut self, site: &Site<'_>, samples: u32) -> Rgb {
        if samples == 0 {
            return Rgb::ZERO;
        }
        let beam = &site.point.beam;
        let Some(dir) = refracted_direction(beam.ray.dir, site.n, 1.0 / site.eta) else { return Rgb::ZERO };
        let inside = Ray::new(site.point.surface.p, dir);
        let exit = self.entry(site, &inside, f64::INFINITY);
        let depth = exit.as_ref().map_or(f64::INFINITY, |e| e.t * site.mm_per_unit);
        let mut sum = [0.0; 3];
        for _ in 0..samples {
            for (channel, sum) in sum.iter_mut().enumerate() {
                *sum += f64::from(self.single_sample(site, &inside, depth, channel));
            }
        }
        let scattered = Rgb::from_array(sum.map(|v| (v / f64::from(samples)) as f32));
        scattered + exit.filter(|e| e.same).map_or(Rgb::ZERO, |e| self.unscattered(site, &inside, &e, depth))
    }

    /// One scattering event of one channel.
    fn single_sample(&mut self, site: &Site<'_>, inside: &Ray, depth: f64, channel: usize) -> f32 {
        let medium = site.coefficients.channels[channel];
        let random = self.streams.numbers().lights.next();
        if medium.extinction <= 0.0 || random <= 0.0 {
            return 0.0;
        }
        let way = random.ln().abs() / medium.extinction;
        if way >= depth {
            return 0.0;
        }
        let b = inside.at(way / site.mm_per_unit);
        let bent = |cosine: f64| (1.0 - (1.0 - cosine * cosine) / (site.eta * site.eta)).max(1e-12).sqrt();
        let mut sum = 0.0;
        for &i in site.point.lights {
            let source = &self.world.lights[i as usize];
            let Some(entry) = self.entry(site, &source.path(b).ray, f64::INFINITY) else {
                continue;
            };
            if !entry.same {
                continue;
            }
            let (light, dir) = self.light_at(site, source, entry.p);
            let cosine = entry.n.dot(dir).abs();
            let inner = bent(cosine);
            let path = entry.t * site.mm_per_unit * cosine / inner;
            let geometry = bent(site.cos_out) / inner;
            let surfaces =
                fresnel_transmission(site.eta, cosine) * fresnel_transmission(site.eta, site.cos_out);
            let event = medium.scattering * cosine * surfaces / (4.0 * medium.extinction * (1.0 + geometry));
            let dimmed = (-(path + way) * medium.extinction).exp();
            sum += light[channel] * (event * dimmed) as f32;
        }
        sum
    }

    /// What is seen straight through.
    fn unscattered(&mut self, site: &Site<'_>, inside: &Ray, exit: &Entry, depth: f64) -> Rgb {
        let left = site.coefficients.unscattered(depth);
        if left.max_element() <= self.bailout {
            return Rgb::ZERO;
        }
        let Some(dir) = refracted_direction(inside.dir, exit.n, site.eta) else { return Rgb::ZERO };
        let ray = Ray::new(exit.p, dir);
        let beam = Beam { ray: &ray, weight: left.max_element(), reach: f64::INFINITY, ..*site.point.beam };
        self.trace(&beam, false).rgb() * left
    }

    /// Directions spread evenly over the sphere, one after the other.
    fn next_sphere_direction(&mut self) -> Vec3 {
        let place = &mut self.streams.numbers().scatter;
        *place = (*place + 1) % CYCLE;
        DIRECTIONS[*place as usize]
    }
}

/// After so many the directions start again.
const CYCLE: u32 = 32767;

/// Directions spread evenly over the sphere, by Halton's sequence.
static DIRECTIONS: LazyLock<Vec<Vec3>> = LazyLock::new(|| {
    let direction = |k: u32| {
        let (x, angle) = (2.0 * halton(2, k) - 1.0, TAU * halton(3, k));
        let flat = (1.0 - x * x).max(0.0).sqrt();
        Vec3::new(x, flat * angle.cos(), flat * angle.sin())
    };
    (1..=CYCLE).map(direction).collect()
});
