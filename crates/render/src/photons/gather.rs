//! Gathering: the photons around a point as light (photon spec, section 2.7).
use std::f64::consts::PI;

use raggio_image::Rgb;
use raggio_math::Vec3;
use raggio_math::noise::hash3;
use raggio_math::turns::floor;
use raggio_scene::Finish;

use super::Maps;
use super::map::{Nearest, PhotonMap};
use crate::integrator::Tracer;
use crate::integrator::lobes::Lobes;
use crate::integrator::surface::SurfacePoint;

/// What a tracer keeps for photons.
pub struct State<'w> {
    maps: &'w Maps,
    gather_min: usize,
    gather_max: usize,
    expand_increase: f64,
    expand_min: usize,
    /// How far the photons of the last searches nearby reached, on surfaces and in media.
    likely: [Reaches; 2],
    nearest: Nearest,
    /// What the first search found, while the second looks farther.
    first: Nearest,
    /// Of the finishes that photons light.
    lobes: Lobes,
}

/// A number for each part of space; parts far from each other may share one.
struct Reaches(Vec<f64>);

impl Default for Reaches {
    fn default() -> Self {
        Reaches(vec![f64::INFINITY; 256])
    }
}

impl Reaches {
    /// That of the part around a point, which is as wide as `side`.
    fn around(&mut self, p: Vec3, side: f64) -> &mut f64 {
        let cell = (p / side).map(floor);
        let place = hash3(cell.x as i64, cell.y as i64, cell.z as i64) % self.0.len();
        &mut self.0[place]
    }
}

impl<'w> State<'w> {
    /// For maps and a plan's numbers.
    pub fn new(maps: &'w Maps, plan: &super::Plan) -> Self {
        let settings = &plan.settings;
        State {
            maps,
            gather_min: settings.gather_min as usize,
            gather_max: settings.gather_max as usize,
            expand_increase: settings.expand_increase.into(),
            expand_min: settings.expand_min as usize,
            likely: Default::default(),
            nearest: Nearest::default(),
            first: Nearest::default(),
            lobes: Lobes::default(),
        }
    }

    /// Do photons fall on surfaces?
    pub fn on_surfaces(&self) -> bool {
        !self.maps.surface.is_empty()
    }

    /// The light that photons bring to a point of a medium, each weighed by where it comes from.
    pub fn in_media(&mut self, p: Vec3, weight: impl Fn(Vec3) -> f32) -> Rgb {
        let map = &self.maps.media;
        if map.is_empty() {
            return Rgb::ZERO;
        }
        let radius = self.gather(map, p, None);
        let photons = self.nearest.numbers().map(|number| map.photon(number));
        let sum: Rgb = photons.map(|photon| photon.power * weight(photon.toward)).sum();
        if radius > 0.0 { sum * (0.75 / (PI * radius.powi(3))) as f32 } else { Rgb::ZERO }
    }

    /// Finds the photons around a point, of a surface if it has a normal; gives the radius that they fill.
    fn gather(&mut self, map: &PhotonMap, p: Vec3, n: Option<Vec3>) -> f64 {
        let (asked, place) = (map.radius, (p, n));
        let likely = self.likely[usize::from(n.is_none())].around(p, asked);
        map.search(place, asked, self.gather_max, likely, &mut self.nearest);
        let first = self.nearest.radius(asked);
        let count = self.nearest.len();
        if count >= self.gather_min {
            return first;
        }
        std::mem::swap(&mut self.nearest, &mut self.first);
        let density = (count as f64 / (first * first)).max(1e-16);
        map.search(place, 3.0 * asked, self.gather_max, likely, &mut self.nearest);
        let second = self.nearest.radius(3.0 * asked);
        let wider = self.nearest.len();
        let grown = (wider as f64 / (second * second) - density) / density;
        if grown < self.expand_increase || (wider > 0 && wider < self.expand_min) {
            return second;
        }
        std::mem::swap(&mut self.nearest, &mut self.first);
        first
    }
}

impl Tracer<'_> {
    /// The light that photons bring to a layer. `known` is the radius of the layers before, which share its photons.
    #[inline(never)]
    pub(crate) fn photon_light(
        &mut self,
        point: &SurfacePoint<'_>,
        finish: &Finish,
        n: Vec3,
        rgb: Rgb,
        opacity: f32,
        known: &mut Option<f64>,
    ) -> Rgb {
        let dull = finish.diffuse == 0.0 && finish.phong == 0.0 && finish.specular == 0.0;
        if dull || !point.material.photons.collect.unwrap_or(true) {
            return Rgb::ZERO;
        }
        let Some(mut state) = self.photons.take() else { return Rgb::ZERO };
        let map = &state.maps.surface;
        let radius = *known.get_or_insert_with(|| state.gather(map, point.surface.p, Some(n)));
        let thrown = state.nearest.numbers().map(|number| {
            let photon = map.photon(number);
            let slant = point.n.dot(photon.toward).clamp(0.1, 1.0);
            (photon.toward, photon.power / slant as f32)
        });
        let sum = self.lit_from(point, finish, n, (rgb, opacity), thrown, &mut state.lobes);
        self.photons = Some(state);
        if radius > 0.0 { sum / (PI * radius * radius) as f32 } else { Rgb::ZERO }
    }
}
