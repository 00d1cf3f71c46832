//! Shadow rays: what reaches a surface point of a light (light spec, section 5.4).
use std::cmp::Reverse;

use raggio_geometry::{Hit, Interaction, InteriorId, Obstacles, RayClass, Segment, Shaft, Standing};
use raggio_image::Rgb;
use raggio_math::{Ray, Vec3};
use raggio_scene::PhotonFlags;
use raggio_shading::{Context, Layer};
use smallvec::SmallVec;

use super::area::{AreaGrid, AreaScratch, View};
use super::{LightSource, Path};
use crate::integrator::{Interiors, NormalPath, Tracer, fade, for_each_plain, placed, toggle};
use crate::world::{Passing, World};

/// Nearer than this to either end of a segment nothing casts a shadow.
pub const SHADOW_TOLERANCE: f64 = 1e-3;

/// Light that arrives at less than this (as a cosine) may meet even a convex surface again.
const GRAZING: f64 = 1e-4;

/// Where shadow rays begin.
#[derive(Clone, Copy, Debug)]
pub struct Start<'a> {
    /// The interiors around.
    pub interiors: &'a [InteriorId],
    /// Do photons count?
    pub collects: bool,
    /// The convex leaf on whose surface it is, and its normal.
    pub own: Option<(u32, &'a Vec3)>,
}

/// A surface that a shadow ray goes through.
struct Crossing {
    t: f64,
    /// What the surface lets through.
    share: Rgb,
    leaf: u32,
    interior: InteriorId,
}

/// What a shadow ray goes through, in the order in which it was found.
struct Crossings<'a> {
    world: &'a World,
    ray: &'a Ray,
    /// Set where photons bring the light of surfaces that are their targets.
    replaced: Option<&'a PhotonFlags>,
    list: SmallVec<[Crossing; 6]>,
}

impl Start<'_> {
    /// The leaf that does not stand in the way of light that comes in on a path.
    #[inline]
    fn own_before(&self, path: &Path) -> Option<u32> {
        self.own.and_then(|(leaf, n)| (n.dot(path.ray.dir) > GRAZING).then_some(leaf))
    }
}

impl Tracer<'_> {
    /// What is left of `light` at the start of the way to its source after everything on that way. Area lights give
    /// their mean. Where photons count, light through their targets is left to them.
    pub fn after_shadows(&mut self, source: &LightSource, path: &Path, light: Rgb, start: &Start<'_>) -> Rgb {
        if light == Rgb::ZERO || !self.quality.shadows() {
            return light;
        }
        if source.shadowless && source.projected_through.is_none() {
            return light;
        }
        let Some(grid) = source.area.as_ref().filter(|_| self.quality.area_lights()) else {
            let geometry = &self.world.geometry;
            let own = start.own_before(path);
            let before = source.before(path, own, geometry);
            let clear = before.is_clear(own);
            if clear && self.is_clear(source) && source.projected_through.is_none() {
                return light;
            }
            return self.walk_to_light(source, path, light, start, own, before.standing);
        };
        let mut scratch = self.area_scratch.take().unwrap_or_default();
        let mean = self.after_soft_shadows(source, grid, path, light, start, &mut scratch);
        self.area_scratch = Some(scratch);
        mean
    }

    /// What is left of an area light's light, in the mean.
    #[inline(never)]
    fn after_soft_shadows(
        &mut self,
        source: &LightSource,
        grid: &AreaGrid,
        path: &Path,
        light: Rgb,
        start: &Start<'_>,
        scratch: &mut AreaScratch,
    ) -> Rgb {
        let p = path.ray.origin;
        self.before_area(source, grid, path, &mut scratch.standing);
        let clear = self.is_clear(source);
        let random = self.streams.numbers().lights;
        grid.pass_over(&mut self.streams.numbers().lights);
        if clear && matches!(&scratch.standing, Standing::Listed(list) if list.is_empty()) {
            return light;
        }
        let world = self.world;
        let stops = |leaf| world.stops_at(leaf);
        let screened = clear && world.geometry.screen(&scratch.standing, p, stops, &mut scratch.screen);
        let view = View { light: source, grid, p, to_light: path.ray.dir, screened, open: light, random };
        view.average(scratch, |from, standing| {
            let path = source.path_to(p, from);
            self.walk_to_light(source, &path, light, start, start.own_before(&path), standing)
        })
    }

    /// Finds what may stand between a point and an area light.
    fn before_area(&self, source: &LightSource, grid: &AreaGrid, path: &Path, standing: &mut Standing) {
        if source.parallel || source.projected_through.is_some() || grid.open_samples < 4 {
            *standing = Standing::Anything;
            return;
        }
        let corners = grid.corners(grid.axes(path.ray.dir)).map(|offset| source.position + offset);
        match Shaft::new(path.ray.origin, corners, 0.999 * SHADOW_TOLERANCE) {
            Some(shaft) => self.world.geometry.find_standing(&shaft, RayClass::Shadow, standing),
            None => *standing = Standing::Anything,
        }
    }

    /// Does empty space leave the light of a source as it is?
    fn is_clear(&self, source: &LightSource) -> bool {
        let empty = self.world.air.is_empty() && self.world.sky.is_clear();
        empty || !source.media_attenuation || !self.quality.volume()
    }

    /// Follows one shadow ray through all surfaces on its way but those of its `own` leaf.
    fn walk_to_light(
        &mut self,
        source: &LightSource,
        path: &Path,
        light: Rgb,
        start: &Start<'_>,
        own: Option<u32>,
        standing: &Standing,
    ) -> Rgb {
        let world = self.world;
        let ray = &path.ray;
        let mut distance = path.distance;
        if let Some(window) = &source.projected_through {
            match window.closest(ray, (0.0, distance), RayClass::Any) {
                None => return Rgb::ZERO,
                Some(_) if source.shadowless => return light,
                Some(hit) => distance = hit.t,
            }
        }
        let replaced = start.collects && self.photons.as_ref().is_some_and(|photons| photons.on_surfaces());
        let replaced = replaced.then_some(&source.photons);
        let mut crossings = Crossings { world, ray, replaced, list: SmallVec::new() };
        if distance > 2.0 * SHADOW_TOLERANCE {
            let range = (SHADOW_TOLERANCE, distance - SHADOW_TOLERANCE);
            let guess = &mut self.blockers[source.index];
            let geometry = &world.geometry;
            let segment = Segment { ray, range, gap: SHADOW_TOLERANCE, own };
            if geometry.is_stopped(&segment, standing, guess, &mut crossings) {
                return Rgb::ZERO;
            }
        }
        let hazy = world.any_media && self.quality.volume();
        let misty = source.media_attenuation && self.quality.volume();
        if crossings.list.is_empty() && !misty {
            return light;
        }
        let list = crossings.sorted();
        self.through(source, ray, distance, light, start.interiors, list, (hazy, misty))
    }

    /// What is left of light after the surfaces on its way and what lies between them: media where it is `hazy`, and
    /// those of empty space where it is `misty`.
    #[inline(never)]
    fn through(
        &mut self,
        source: &LightSource,
        ray: &Ray,
        distance: f64,
        mut light: Rgb,
        interiors: &[InteriorId],
        crossings: &[Crossing],
        (hazy, misty): (bool, bool),
    ) -> Rgb {
        let world = self.world;
        let mut inside = Interiors::from_slice(interiors);
        let mut ray = *ray;
        let mut at = 0.0;
        for crossing in crossings {
            let way = crossing.t - at;
            if way <= SHADOW_TOLERANCE && at > 0.0 {
                continue;
            }
            light *= crossing.share;
            let interior = &world.interior(crossing.interior).interior;
            if interior.fade_power > 0.0 && inside.contains(&crossing.interior) {
                light *= fade(interior, way);
            }
            if hazy && !inside.is_empty() {
                light *= self.media_filter(&inside, &ray, way);
            }
            if misty && world.all_hollow(&inside) {
                light *= self.air_filter(source, &ray, way);
            }
            toggle(&mut inside, crossing.interior);
            ray.origin += ray.dir * way;
            at = crossing.t;
        }
        let left = distance - at;
        if misty && left > SHADOW_TOLERANCE && world.all_hollow(&inside) {
            light *= self.air_filter(source, &ray, left);
        }
        light
    }

    /// What fog and the media of empty space leave of light.
    fn air_filter(&mut self, source: &LightSource, ray: &Ray, depth: f64) -> Rgb {
        let mut left = Rgb::ONE;
        if source.media_interaction && !self.world.air.is_empty() {
            left *= self.dimmed_by(&[&self.world.air], ray, depth);
        }
        left * self.world.sky.fog_filter(ray, depth)
    }
}

impl World {
    /// What a surface lets through of light: all layers of all its textures.
    fn filter(&self, ray: &Ray, surface: &Interaction) -> Rgb {
        let material = self.material(surface);
        let n = if surface.from_inside { -surface.n } else { surface.n };
        let context = Context { normal: Some(n), point: surface.p, ray_dir: ray.dir, uv: surface.uv };
        let caustics = self.interior(material.interior).interior.caustics;
        let mut sum = Rgb::ZERO;
        for used in surface.textures.as_slice() {
            let texture = self.texture(used.texture);
            let (path, p) = placed(texture, surface, material);
            for_each_plain(
                &texture.texture,
                p,
                used.weight,
                &path,
                &context,
                &mut |layers, p, share, path| {
                    sum += layers_filter(layers, p, n, path, &context, caustics) * share;
                },
            );
        }
        sum
    }
}

impl Crossings<'_> {
    /// The surfaces from the point to the light. Of equally near ones of an object that is first which is seen.
    fn sorted(&mut self) -> &[Crossing] {
        if self.list.len() > 1 {
            let rank = |crossing: &Crossing| Reverse(self.world.geometry.rank(crossing.leaf));
            self.list.sort_unstable_by(|a, b| a.t.total_cmp(&b.t).then_with(|| rank(a).cmp(&rank(b))));
        }
        &self.list
    }
}

impl Obstacles for Crossings<'_> {
    #[inline]
    fn stops(&self, leaf: u32) -> bool {
        self.world.stops_at(leaf)
            || self.replaced.is_some_and(|flags| self.world.photons_replace(leaf, flags))
    }

    #[inline]
    fn is_plain(&self, leaf: u32) -> bool {
        self.world.passing(leaf) != Passing::Varies
    }

    #[inline]
    fn meets(&mut self, hit: &Hit) -> bool {
        let share = match self.world.passing(hit.leaf) {
            Passing::Nothing => return true,
            Passing::Always(share) => share,
            Passing::Varies => self.world.filter(self.ray, &self.world.geometry.interaction(self.ray, hit)),
        };
        let material = self.world.geometry.material_at(hit.leaf);
        let interior = self.world.geometry.materials[material.0 as usize].interior;
        self.list.push(Crossing { t: hit.t, share, leaf: hit.leaf, interior });
        share == Rgb::ZERO
    }
}

fn layers_filter(
    layers: &[Layer],
    p: Vec3,
    n: Vec3,
    path: &NormalPath<'_>,
    context: &Context,
    caustics: f64,
) -> Rgb {
    let mut product = Rgb::ONE;
    for layer in layers {
        if let Some(color) = layer.pigment.eval(p, context) {
            product *= color.transmission();
            if product == Rgb::ZERO {
                break;
            }
        }
        if caustics != 0.0 {
            let bent = match &layer.normal {
                Some(normal) => path.bend(normal, n, p, context),
                None => n,
            };
            product *= 1.0 + bent.dot(context.ray_dir).abs().powf(caustics) as f32;
        }
    }
    product
}
