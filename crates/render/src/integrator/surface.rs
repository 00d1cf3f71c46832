//! The colour of a surface point: all its textures, then the media before it (light spec, section 3.2).
use raggio_geometry::{Hit, Interaction, Material, TextureUse, TextureUses};
use raggio_image::Rgb;
use raggio_math::Vec3;
use raggio_shading::{Context, Layer, Texture};

use super::{Beam, Seen, Tracer, for_each_plain, placed};
use crate::lights::Start;
use crate::world::WorldTexture;

/// A surface point in work.
pub struct SurfacePoint<'a> {
    /// The ray that found it.
    pub beam: &'a Beam<'a>,
    /// How far that ray went.
    pub depth: f64,
    /// The leaf that was hit, if it is convex.
    pub convex: Option<u32>,
    /// What is known about it.
    pub surface: &'a Interaction,
    /// What hangs on it.
    pub material: &'a Material,
    /// The normal that faces the ray.
    pub n: Vec3,
    /// Which lights shine on it.
    pub lights: &'a [u32],
    /// Where its part of the tracer's list of arriving light begins, if more than one layer asks for that light.
    pub arriving: Option<usize>,
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

impl<'a> SurfacePoint<'a> {
    /// Where shadow rays begin.
    #[inline]
    pub fn start(&self) -> Start<'a> {
        Start {
            interiors: self.beam.interiors,
            collects: self.material.photons.collect.unwrap_or(true),
            own: self.convex.map(|leaf| (leaf, &self.surface.n)),
        }
    }
}

impl<'w> Tracer<'w> {
    /// What a ray sees that hit a surface.
    pub(super) fn surface(&mut self, beam: &Beam<'_>, hit: &Hit) -> Seen {
        let world = self.world;
        let surface = world.geometry.interaction(beam.ray, hit);
        let material = world.material(&surface);
        let lights = world.light_sets.of(material);
        let alone = self.single_layer(&surface);
        let known = self.arriving.len();
        if alone.is_none() {
            self.arriving.resize(known + lights.len(), None);
        }
        let point = SurfacePoint {
            beam,
            depth: hit.t,
            convex: world.geometry.is_convex(hit.leaf).then_some(hit.leaf),
            n: if surface.from_inside { -surface.n } else { surface.n },
            surface: &surface,
            material,
            lights,
            arriving: alone.is_none().then_some(known),
        };
        let way = self.way;
        self.way += hit.t;
        let mut seen = match alone {
            Some((texture, layer)) if self.quality.lights() => self.one_layer(&point, texture, layer),
            _ => self.textures(&point),
        };
        self.way = way;
        self.arriving.truncate(known);
        if world.any_media && self.quality.volume() && !beam.interiors.is_empty() {
            self.contained_media(beam, hit.t, lights, &mut seen);
        }
        seen
    }

    /// The texture of a surface that has but one, of one layer.
    fn single_layer(&self, surface: &Interaction) -> Option<(&'w WorldTexture, &'w Layer)> {
        let TextureUses::One(TextureUse { texture, weight: 1.0 }) = surface.textures else { return None };
        let texture = self.world.texture(texture);
        let Texture::Layers(layers) = &*texture.texture else { return None };
        let [layer] = &layers[..] else { return None };
        Some((texture, layer))
    }

    /// The weighted sum over all textures of a point.
    #[inline(never)]
    fn textures(&mut self, point: &SurfacePoint<'_>) -> Seen {
        let world = self.world;
        let context = point.context();
        let (mut rgb, mut transmit) = (Rgb::ZERO, 0.0);
        for used in point.surface.textures.as_slice() {
            if used.weight < self.bailout {
                continue;
            }
            let texture = world.texture(used.texture);
            let (path, p) = placed(texture, point.surface, point.material);
            for_each_plain(
                &texture.texture,
                p,
                used.weight,
                &path,
                &context,
                &mut |layers, p, share, path| {
                    let seen = self.layers(point, layers, (p, path), &context);
                    rgb += seen.rgb() * share;
                    transmit += seen.transmit() * share;
                },
            );
        }
        Seen::new(rgb, transmit)
    }

    /// The light that arrives at a point from its `i`th light after shadows, worked out once for all layers.
    #[inline(always)]
    pub(super) fn arriving_once(
        &mut self,
        point: &SurfacePoint<'_>,
        i: usize,
        work_out: impl FnOnce(&mut Self) -> Rgb,
    ) -> Rgb {
        let Some(start) = point.arriving else { return work_out(self) };
        if let Some(known) = self.arriving[start + i] {
            return known;
        }
        let value = work_out(self);
        self.arriving[start + i] = Some(value);
        value
    }
}
