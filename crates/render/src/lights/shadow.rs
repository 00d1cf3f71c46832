//! Shadow rays: what reaches a surface point of a light (light spec, section 5.4).
use raggio_geometry::{Hit, RayClass, Shaft, Standing};
use raggio_image::Rgb;
use raggio_math::{Ray, Vec3};
use raggio_shading::{Context, Layer};

use super::area::{AreaGrid, View};
use super::{LightSource, Path};
use crate::integrator::{Interiors, NormalPath, Tracer, copied, fade, for_each_plain, placed, toggle};

/// Nearer than this to either end of a segment nothing casts a shadow.
pub const SHADOW_TOLERANCE: f64 = 1e-3;

impl Tracer<'_> {
    /// What is left of `light` at `p` after everything between it and the source. Area lights give their mean. Where
    /// photons count (`collects`), light through their targets is left to them.
    pub fn after_shadows(
        &mut self,
        source: &LightSource,
        p: Vec3,
        path: &Path,
        light: Rgb,
        interiors: &Interiors,
        collects: bool,
    ) -> Rgb {
        if light == Rgb::ZERO || !self.quality.shadows() {
            return light;
        }
        if source.shadowless && source.projected_through.is_none() {
            return light;
        }
        let Some(grid) = source.area.as_ref().filter(|_| self.quality.area_lights()) else {
            let standing = source.before(path, &self.world.geometry);
            return self.walk_to_light(source, p, path, light, interiors, collects, standing);
        };
        let standing = self.before_area(source, grid, p, path);
        let clear = self.is_clear(source);
        let random = self.streams.lights;
        grid.pass_over(&mut self.streams.lights);
        if clear && matches!(&standing, Standing::Listed(list) if list.is_empty()) {
            return light;
        }
        let world = self.world;
        let screen = world.geometry.screen(&standing, p, |leaf| world.stops_at(leaf)).filter(|_| clear);
        let view = View { light: source, grid, p, to_light: path.dir, screen, open: light, random };
        let mut scratch = std::mem::take(&mut self.area_scratch);
        let mean = view.average(&mut scratch, |from| {
            self.walk_to_light(source, p, &source.path_to(p, from), light, interiors, collects, &standing)
        });
        self.area_scratch = scratch;
        mean
    }

    /// What may stand between a point and an area light.
    fn before_area(&self, source: &LightSource, grid: &AreaGrid, p: Vec3, path: &Path) -> Standing {
        if source.parallel || source.projected_through.is_some() || grid.open_samples < 4 {
            return Standing::Anything;
        }
        let corners = grid.corners(grid.axes(path.dir)).map(|offset| source.position + offset);
        match Shaft::new(p, corners, 0.999 * SHADOW_TOLERANCE) {
            Some(shaft) => self.world.geometry.standing_in(&shaft, RayClass::Shadow),
            None => Standing::Anything,
        }
    }

    /// Does empty space leave the light of a source as it is?
    fn is_clear(&self, source: &LightSource) -> bool {
        let empty = self.world.air.is_empty() && self.world.sky.is_clear();
        empty || !source.media_attenuation || !self.quality.volume()
    }

    /// Follows one shadow ray from surface to surface.
    fn walk_to_light(
        &mut self,
        source: &LightSource,
        p: Vec3,
        path: &Path,
        mut light: Rgb,
        interiors: &Interiors,
        collects: bool,
        standing: &Standing,
    ) -> Rgb {
        let world = self.world;
        let replaced = collects && self.photons.as_ref().is_some_and(|photons| photons.on_surfaces());
        let stops =
            |hit: &Hit| world.stops_light(hit) || (replaced && world.photons_replace(hit, &source.photons));
        let mut ray = Ray::new(p, path.dir);
        let mut left = path.distance;
        if let Some(window) = &source.projected_through {
            match window.closest(&ray, (0.0, left), RayClass::Any) {
                None => return Rgb::ZERO,
                Some(_) if source.shadowless => return light,
                Some(hit) => left = hit.t,
            }
        }
        let hazy = world.any_media && self.quality.volume();
        let misty = source.media_attenuation && self.quality.volume();
        let mut list: Option<Interiors> = None;
        let mut guess = self.blockers[source.index];
        while left > 2.0 * SHADOW_TOLERANCE {
            let range = (SHADOW_TOLERANCE, left - SHADOW_TOLERANCE);
            let Some(hit) =
                world.geometry.blocker(&ray, range, RayClass::Shadow, standing, &mut guess, stops)
            else {
                break;
            };
            if stops(&hit) {
                self.blockers[source.index] = guess;
                return Rgb::ZERO;
            }
            let inside = list.get_or_insert_with(|| copied(interiors));
            let material = &world.geometry.materials[world.geometry.material_at(&hit).0 as usize];
            light *= world.even_tint(&hit).unwrap_or_else(|| self.filter(&ray, &hit));
            if light == Rgb::ZERO {
                return light;
            }
            let interior = &world.interior(material.interior).interior;
            if interior.fade_power > 0.0 && inside.contains(&material.interior) {
                light *= fade(interior, hit.t);
            }
            if hazy && !inside.is_empty() {
                light *= self.media_filter(inside, &ray, hit.t);
            }
            if misty && world.all_hollow(inside) {
                light *= self.air_filter(source, &ray, hit.t);
            }
            toggle(inside, material.interior);
            ray.origin = ray.at(hit.t);
            left -= hit.t;
        }
        let open = || world.all_hollow(list.as_ref().unwrap_or(interiors));
        if misty && left > SHADOW_TOLERANCE && open() {
            light *= self.air_filter(source, &ray, left);
        }
        light
    }

    /// What a surface lets through of light: all layers of all its textures.
    fn filter(&self, ray: &Ray, hit: &Hit) -> Rgb {
        let surface = self.world.geometry.interaction(ray, hit);
        let material = self.world.material(&surface);
        let n = if surface.from_inside { -surface.n } else { surface.n };
        let context = Context { normal: Some(n), point: surface.p, ray_dir: ray.dir, uv: surface.uv };
        let uv = material.uv_mapping.then_some(surface.uv);
        let caustics = f64::from(self.world.interior(material.interior).interior.caustics) * 45.0;
        let mut sum = Rgb::ZERO;
        for used in &surface.textures {
            let texture = self.world.texture(used.texture);
            let (path, p) = placed(texture, surface.p, uv);
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

    /// What fog and the media of empty space leave of light.
    fn air_filter(&mut self, source: &LightSource, ray: &Ray, depth: f64) -> Rgb {
        let mut left = Rgb::ONE;
        if source.media_interaction && !self.world.air.is_empty() {
            left *= self.dimmed_by(&[&self.world.air], ray, depth);
        }
        left * self.world.sky.fog_filter(ray, depth)
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
