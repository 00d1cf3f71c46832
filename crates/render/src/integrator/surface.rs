//! The colour of a surface point: all its textures, then the media before it (light spec, section 3.2).
use raggio_geometry::{Hit, Interaction, Material};
use raggio_image::Rgb;
use raggio_math::Vec3;
use raggio_shading::Context;

use super::{Beam, Seen, Tracer, for_each_plain, placed};

/// A surface point in work.
pub struct SurfacePoint<'a> {
    /// The ray that found it.
    pub beam: &'a Beam,
    /// How far that ray went.
    pub depth: f64,
    /// What is known about it.
    pub surface: &'a Interaction,
    /// What hangs on it.
    pub material: &'a Material,
    /// The normal that faces the ray.
    pub n: Vec3,
    /// Which lights shine on it.
    pub lights: &'a [u32],
    /// Where its part of the tracer's list of arriving light begins.
    pub arriving: usize,
}

impl SurfacePoint<'_> {
    /// What patterns may ask for.
    pub fn context(&self) -> Context {
        Context {
            normal: Some(self.n),
            point: self.surface.p,
            ray_dir: self.beam.ray.dir,
            uv: self.surface.uv,
        }
    }
}

impl Tracer<'_> {
    /// What a ray sees that hit a surface.
    pub(super) fn surface(&mut self, beam: &Beam, hit: &Hit) -> Seen {
        let world = self.world;
        let surface = world.geometry.interaction(&beam.ray, hit);
        let material = world.material(&surface);
        let lights = world.light_sets.of(material);
        let arriving = self.arriving.len();
        self.arriving.resize(arriving + lights.len(), None);
        let point = SurfacePoint {
            beam,
            depth: hit.t,
            n: if surface.from_inside { -surface.n } else { surface.n },
            surface: &surface,
            material,
            lights,
            arriving,
        };
        let way = self.way;
        self.way += hit.t;
        let mut seen = self.textures(&point);
        self.way = way;
        self.arriving.truncate(arriving);
        if world.any_media && self.quality.volume() && !beam.interiors.is_empty() {
            self.contained_media(beam, hit.t, lights, &mut seen);
        }
        seen
    }

    /// The weighted sum over all textures of a point.
    fn textures(&mut self, point: &SurfacePoint<'_>) -> Seen {
        let world = self.world;
        let context = point.context();
        let uv = point.material.uv_mapping.then_some(point.surface.uv);
        let (mut rgb, mut transmit) = (Rgb::ZERO, 0.0);
        for used in &point.surface.textures {
            if used.weight < self.bailout {
                continue;
            }
            let texture = world.texture(used.texture);
            let (path, p) = placed(texture, point.surface.p, uv);
            for_each_plain(
                &texture.texture,
                p,
                used.weight,
                &path,
                &context,
                &mut |layers, p, share, path| {
                    let seen = self.layers(point, layers, p, path, &context);
                    rgb += seen.rgb * share;
                    transmit += seen.transmit * share;
                },
            );
        }
        Seen { rgb, transmit }
    }

    /// The light that arrives at a point from its `i`th light after shadows, worked out once for all layers.
    pub(super) fn arriving_once(
        &mut self,
        point: &SurfacePoint<'_>,
        i: usize,
        work_out: impl FnOnce(&mut Self) -> Rgb,
    ) -> Rgb {
        if let Some(known) = self.arriving[point.arriving + i] {
            return known;
        }
        let value = work_out(self);
        self.arriving[point.arriving + i] = Some(value);
        value
    }
}
