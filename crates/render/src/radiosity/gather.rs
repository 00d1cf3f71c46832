//! A gather: rays in all directions over a surface point.
use std::f64::consts::TAU;

use raggio_geometry::{Hit, RayClass};
use raggio_image::Rgb;
use raggio_math::{MIN_HIT, Ray, Vec3};

use super::cache::Sample;
use super::{Rules, State};
use crate::integrator::surface::SurfacePoint;
use crate::integrator::{Beam, Tracer};
use crate::sampling::halton;

/// A gather under way.
pub(super) struct Gather<'a> {
    rules: &'a Rules,
    point: &'a SurfacePoint<'a>,
    n: Vec3,
    /// How much its rays count.
    weight: f32,
    /// Where they go, one for each.
    pub directions: Vec<Vec3>,
    /// Which of them surely lead to the bare sky, as bits, if that is known.
    open: Option<Vec<u8>>,
}

/// What a ray of a gather brings.
#[derive(Clone, Copy)]
pub(super) struct Brought {
    /// How far it went.
    distance: Option<f64>,
    /// Light times quality.
    light: Rgb,
    /// How well the light is known; 0 where none was asked for.
    quality: f32,
}

impl Gather<'_> {
    /// Does ray number `i` surely lead to the bare sky?
    #[inline]
    fn is_open(&self, i: u32) -> bool {
        self.open.as_ref().is_some_and(|open| open[i as usize / 8] >> (i % 8) & 1 == 1)
    }
}

/// Sums over the rays of a gather.
struct Sums {
    light: Rgb,
    quality: f32,
    rays: u32,
    inverse_distances: f64,
    nearest: f64,
    toward: Vec3,
}

impl Sums {
    fn add(&mut self, dir: Vec3, ray: &Brought) {
        self.rays += 1;
        if let Some(t) = ray.distance {
            self.inverse_distances += 1.0 / t;
            if t < self.nearest {
                (self.nearest, self.toward) = (t, dir);
            }
        }
        self.light += ray.light;
        self.quality += ray.quality;
    }
}

impl Rules {
    /// What counts at most of the light that a ray brings.
    #[inline]
    fn limited(&self, light: Rgb) -> Rgb {
        let (most, brightest) = (self.settings.max_sample, light.max_element());
        if most > 0.0 && brightest > most { light * (most / brightest) } else { light }
    }
}

impl Tracer<'_> {
    /// Samples the light from all around and keeps the result; gives light and quality.
    pub(super) fn gather(&mut self, point: &SurfacePoint<'_>, n: Vec3, raw: Vec3) -> (Rgb, f32) {
        let Some(state) = self.radiosity.as_mut() else { return (Rgb::ZERO, 0.0) };
        let (rules, depth) = (state.rules, state.depth);
        let ray_quality = state.ray_quality;
        state.depth += 1;
        let before = (self.level, self.max_level, self.bailout, self.quality);
        let settings = &rules.settings;
        self.level = (1.5 * f64::from(depth + 1)) as u16;
        self.max_level = self.max_level.max(self.level + 1);
        self.bailout = settings.adc_bailout;
        self.quality = self.quality.for_gather(settings.media);
        let weight = (settings.brightness / 2.0).powi(depth as i32 + 1).max(settings.adc_bailout);
        let directions = self.directions(n, raw, depth, rules.rays(depth));
        let world = self.world;
        let bare = world.air.is_empty() && world.sky.is_clear() && !rules.uneven;
        let open = bare.then(|| world.geometry.open_rays(point.surface.p, raw, &directions)).flatten();
        let sums = self.shoot_around(&Gather { rules, point, n, weight, directions, open });
        (self.level, self.max_level, self.bailout, self.quality) = before;
        let Some(state) = self.radiosity.as_mut() else { return (Rgb::ZERO, 0.0) };
        state.depth = depth;
        let light = if sums.quality > 0.0 { sums.light / sums.quality } else { Rgb::ZERO };
        let quality = sums.quality / sums.rays.max(1) as f32;
        state.keep(point.surface.p, n, light, quality, &sums);
        state.ray_quality = ray_quality.max(quality);
        (light, quality)
    }

    fn shoot_around(&mut self, gather: &Gather<'_>) -> Sums {
        let mut sums = Sums {
            light: Rgb::ZERO,
            quality: 0.0,
            rays: 0,
            inverse_distances: 0.0,
            nearest: f64::INFINITY,
            toward: gather.n,
        };
        let guesses = self.look_ahead(gather);
        for (i, &dir) in (0..).zip(&gather.directions) {
            let foreseen = guesses.as_ref().and_then(|guesses| self.foreseen(guesses, i));
            let brought = foreseen.unwrap_or_else(|| self.gather_ray(gather, i));
            sums.add(dir, &brought);
        }
        sums
    }

    /// The directions of a gather's rays over a surface.
    fn directions(&mut self, n: Vec3, raw: Vec3, depth: u32, count: u32) -> Vec<Vec3> {
        let mut directions = Vec::with_capacity(count as usize);
        let (wanted, given) = (Turn::about(n), Turn::about(raw));
        let mut draws = 0;
        while directions.len() < count as usize {
            let bent = draws < 5 * count && n != raw;
            draws += 1;
            let turn = if bent { &wanted } else { &given };
            let dir = turn.apply(self.next_direction(depth));
            if !bent || dir.dot(raw) > 0.0 {
                directions.push(dir);
            }
        }
        directions
    }

    /// Shoots ray number `i`. Rays to objects of little importance only bring their distance.
    pub(super) fn gather_ray(&mut self, gather: &Gather<'_>, i: u32) -> Brought {
        let Gather { rules, point, directions, .. } = gather;
        let dir = directions[i as usize];
        if gather.is_open(i) {
            return self.bare_ray(gather, dir);
        }
        let ray = Ray::new(point.surface.p, dir);
        let beam = Beam {
            ray: &ray,
            interiors: &[],
            weight: gather.weight,
            class: RayClass::Radiosity,
            alpha: false,
            wavelength: None,
            reach: f64::INFINITY,
        };
        let mut hit = Hit::NONE;
        let found = self.world.geometry.closest_into(&ray, (MIN_HIT, beam.reach), beam.class, &mut hit);
        let hit = found.then_some(&hit);
        let distance = hit.map(|hit| hit.t);
        let mut quality = 1.0;
        if rules.uneven {
            let importance = match hit {
                Some(hit) => {
                    let surface = self.world.geometry.interaction(&ray, hit);
                    self.world.material(&surface).radiosity_importance
                }
                None => None,
            };
            let importance = importance.unwrap_or(rules.default_importance);
            let count = directions.len() as u32;
            let last = count.max(2) - 1;
            if importance < i as f32 / last as f32 {
                return Brought { distance, light: Rgb::ZERO, quality: 0.0 };
            }
            if importance < 1.0 {
                quality = count as f32 / ((importance * last as f32).floor() + 1.0);
            }
        }
        self.set_ray_quality(1.0);
        let light = rules.limited(self.follow(&beam, hit, false).rgb());
        quality *= self.radiosity.as_ref().map_or(1.0, |s| s.ray_quality);
        Brought { distance, light: light * quality, quality }
    }

    /// What a ray brings that leads to the bare sky.
    #[inline]
    fn bare_ray(&self, gather: &Gather<'_>, dir: Vec3) -> Brought {
        let light = gather.rules.limited(self.world.sky.beyond(dir, false).rgb());
        Brought { distance: None, light, quality: 1.0 }
    }

    fn set_ray_quality(&mut self, quality: f32) {
        if let Some(state) = &mut self.radiosity {
            state.ray_quality = quality;
        }
    }

    /// The next direction about the y axis, more often near it (by cosine).
    fn next_direction(&mut self, depth: u32) -> Vec3 {
        let Some(state) = self.radiosity.as_mut() else { return Vec3::Y };
        let cursor = &mut state.cursors[depth as usize];
        let k = *cursor;
        *cursor = (k + 1) % state.rules.settings.count_pool.max(1);
        state.rules.directions.get(k as usize).copied().unwrap_or_else(|| direction(k))
    }
}

/// Direction number `k` about the y axis, by Halton's sequence.
pub(super) fn direction(k: u32) -> Vec3 {
    let (radius, angle) = (halton(2, k + 1), TAU * halton(3, k + 1));
    let flat = radius.sqrt();
    Vec3::new(flat * angle.cos(), (1.0 - radius).sqrt(), flat * angle.sin())
}

impl State<'_> {
    /// Keeps a gather's result for other points.
    fn keep(&mut self, p: Vec3, n: Vec3, light: Rgb, quality: f32, sums: &Sums) {
        let settings = &self.rules.settings;
        let scale = f64::from(1u32 << self.depth.min(20));
        let from_eye = (self.rules.eye - p).length() * scale;
        let (low, high) =
            (from_eye * f64::from(settings.minimum_reuse), from_eye * f64::from(settings.maximum_reuse));
        if sums.nearest <= 1e-4 * high {
            return;
        }
        let mean =
            if sums.inverse_distances > 0.0 { f64::from(sums.rays) / sums.inverse_distances } else { high };
        let sample = Sample {
            p,
            n,
            light,
            mean_distance: mean.max(low).min(high),
            nearest: sums.nearest.min(high),
            toward: sums.toward,
            quality,
        };
        // The error may be raised by a quarter for surfaces that count little.
        let reach = sample.mean_distance * (f64::from(settings.error_bound) + 0.25) * scale;
        let shrink = if self.depth == 0 { 1.0 } else { 8.0 };
        if self.turns.is_some() {
            self.made.push((self.depth, sample.clone()));
        }
        self.own.insert(self.depth, sample, reach / shrink);
    }
}

/// From directions about the y axis to those about another one.
enum Turn {
    Same,
    Opposite,
    /// Where the three axes come to lie.
    Axes([Vec3; 3]),
}

impl Turn {
    fn about(n: Vec3) -> Turn {
        if n.y.abs() > 0.999 {
            return if n.y > 0.0 { Turn::Same } else { Turn::Opposite };
        }
        let helper = if n.z.abs() > 0.9 { Vec3::Y } else { Vec3::Z };
        let x = n.cross(helper).try_normalize().unwrap_or(Vec3::X);
        let z = x.cross(n).try_normalize().unwrap_or(Vec3::Z);
        Turn::Axes([x, n, z])
    }

    #[inline]
    fn apply(&self, v: Vec3) -> Vec3 {
        match *self {
            Turn::Same => v,
            Turn::Opposite => -v,
            Turn::Axes([x, n, z]) => x * v.x + n * v.y + z * v.z,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn directions_are_unit_vectors_over_the_surface() {
        for n in [Vec3::Y, -Vec3::Y, Vec3::new(0.1, 0.2, -0.97).normalize(), Vec3::X] {
            let v = Turn::about(n).apply(Vec3::new(0.6, 0.8, 0.0));
            assert!((v.length() - 1.0).abs() < 1e-12 && v.dot(n) > 0.79, "{n}");
        }
    }
}
