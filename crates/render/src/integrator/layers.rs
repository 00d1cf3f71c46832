//! A plain texture: its layers from the top down, then what shines through and what is mirrored (light spec,
//! section 3.2).
use glam::Vec3A;
use raggio_image::{Color, Rgb, grey};
use raggio_math::{EPS, Vec3};
use raggio_scene::{Finish, Irid};
use raggio_shading::{Context, Layer};
use smallvec::SmallVec;

use super::reflection::Mirror;
use super::surface::SurfacePoint;
use super::{NormalPath, Seen, Tracer, placed};
use crate::world::WorldTexture;

/// What layers of a point share, each found once for all of them.
#[derive(Default)]
struct Shared {
    /// Diffuse light from other surfaces before and behind.
    around: [Option<Rgb>; 2],
    /// The radius of the photons gathered.
    photons: Option<f64>,
}

/// What the layers so far leave for what lies below.
struct Below {
    /// What the layers let through.
    filter: Rgb,
    /// The same as one number.
    through: f32,
    /// Did any layer have a colour?
    colored: bool,
}

/// The layer on top, at which rays are bent.
struct Top<'a> {
    n: Vec3,
    /// Its thin film, which colours total reflection.
    irid: Option<&'a Irid>,
}

/// A layer where it is looked at.
#[derive(Clone, Copy)]
struct Look {
    /// Its colour, clear white where it has none.
    color: Color,
    /// Has it a colour?
    found: bool,
    /// Its normal.
    n: Vec3,
}

/// The place at which a layer is asked: a point of its own space, and the way of normals to there.
type At<'a> = (Vec3, &'a NormalPath<'a>);

impl Below {
    /// Where nothing lies above.
    const UNTOUCHED: Below = Below { filter: Rgb::ONE, through: 1.0, colored: false };

    /// One more layer lies above.
    #[inline(always)]
    fn cover(&mut self, look: &Look, finish: &Finish, mirror: Option<&Mirror>) {
        if look.found {
            self.colored = true;
            self.filter *= look.color.transmission();
            if let Some(mirror) = mirror.filter(|_| finish.conserve_energy) {
                self.filter *= (Rgb::ONE - mirror.reflectivity).min(Rgb::ONE);
            }
        }
        self.through = grey(self.filter).abs().min(1.0);
    }
}

impl Tracer<'_> {
    /// What is seen of a texture of one layer.
    pub(super) fn one_layer(
        &mut self,
        point: &SurfacePoint<'_>,
        texture: &WorldTexture,
        layer: &Layer,
    ) -> Seen {
        // What counts no more than this is left out, were it the whole.
        if self.bailout >= 1.0 {
            return Seen::BLACK;
        }
        let look = match layer.plain_color() {
            Some(&color) if !self.quality.quick_color() => Look { color, found: true, n: point.n },
            _ => self.look_alone(point, texture, layer),
        };
        let rgb = self.shine(point, &layer.finish, &look, Rgb::ONE, &mut Shared::default());
        if self.is_last() {
            return Seen::opaque(rgb);
        }
        let mut below = Below::UNTOUCHED;
        let mirror = self.mirror(point, layer, look.n, look.color.rgb, 1.0);
        below.cover(&look, &layer.finish, mirror.as_ref());
        if below.through <= self.bailout && mirror.is_none() {
            return Seen::opaque(rgb);
        }
        let top = Top { n: look.n, irid: layer.finish.irid.as_ref() };
        self.beyond(point, rgb, &below, &top, mirror.as_slice())
    }

    /// Looks at the only layer of a texture.
    #[inline(never)]
    fn look_alone(&self, point: &SurfacePoint<'_>, texture: &WorldTexture, layer: &Layer) -> Look {
        let (path, p) = placed(texture, point.surface, point.material);
        self.look(point, layer, (p, &path), &point.context())
    }

    /// What is seen of a plain texture at a place.
    pub(super) fn layers(
        &mut self,
        point: &SurfacePoint<'_>,
        layers: &[Layer],
        at: At<'_>,
        context: &Context,
    ) -> Seen {
        if !self.quality.lights() {
            return self.flat(layers, at.0, context);
        }
        let (mut light, mut shared) = (Rgb::ZERO, Shared::default());
        let mut mirrors: SmallVec<[Mirror; 2]> = SmallVec::new();
        let mut below = Below::UNTOUCHED;
        let mut top = Top { n: point.n, irid: None };
        for (i, layer) in layers.iter().rev().enumerate() {
            if below.through <= self.bailout {
                break;
            }
            let look = self.look(point, layer, at, context);
            if i == 0 {
                top = Top { n: look.n, irid: layer.finish.irid.as_ref() };
            }
            let mirror = self.mirror(point, layer, look.n, look.color.rgb, below.through);
            light += below.filter * self.shine(point, &layer.finish, &look, below.filter, &mut shared);
            below.cover(&look, &layer.finish, mirror.as_ref());
            mirrors.extend(mirror);
        }
        self.beyond(point, light, &below, &top, &mirrors)
    }

    /// A layer's colour and its normal.
    fn look(&self, point: &SurfacePoint<'_>, layer: &Layer, (p, path): At<'_>, context: &Context) -> Look {
        let footprint = match layer.pigment.is_smooth() {
            true => self.footprint(point, path, p),
            false => None,
        };
        let found = match footprint {
            Some(points) => layer.pigment.eval_over(&points, context),
            None => self.pigment(layer, p, context),
        };
        let n = match &layer.normal {
            Some(normal) if self.quality.normals() => path.bend(normal, point.n, p, context),
            _ => point.n,
        };
        let clear = Color { rgb: Rgb::ONE, filter: 0.0, transmit: 1.0 };
        Look { color: found.unwrap_or(clear), found: found.is_some(), n }
    }

    /// The light that a layer sends out, of which `filter` is seen.
    #[inline(always)]
    fn shine(
        &mut self,
        point: &SurfacePoint<'_>,
        finish: &Finish,
        look: &Look,
        filter: Rgb,
        shared: &mut Shared,
    ) -> Rgb {
        let Look { color, n, .. } = look;
        let opacity = if self.world.rules.modern {
            color.opacity()
        } else {
            1.0 - (color.filter * color.rgb.max_element() + color.transmit)
        };
        let mut own = finish.emission;
        if !(self.world.rules.modern && self.radiosity.is_some()) {
            own += finish.ambient * self.world.rules.ambient_light;
        }
        let tint = color.rgb * opacity;
        if self.radiosity.as_ref().is_some_and(|state| state.gathers()) {
            own += self.light_around(point, finish, *n, grey(filter * tint), &mut shared.around);
        }
        let lit = match &self.radiosity {
            Some(state) if state.skips_lights() => Vec3A::ZERO,
            _ => self.light_of_lights(point, finish, n, &color.rgb, opacity),
        };
        let thrown = match &self.photons {
            Some(photons) if photons.on_surfaces() => {
                self.photon_light(point, finish, *n, color.rgb, opacity, &mut shared.photons)
            }
            _ => Rgb::ZERO,
        };
        tint * own + Rgb::from(lit) + thrown
    }

    /// What a layer sends back of the light of lights. Light from under the surface takes the place of diffuse light.
    fn light_of_lights(
        &mut self,
        point: &SurfacePoint<'_>,
        finish: &Finish,
        n: &Vec3,
        rgb: &Rgb,
        opacity: f32,
    ) -> Vec3A {
        let below = finish.subsurface.and_then(|_| self.light_from_below(point, finish, *n, *rgb));
        let shiny = below.map(|_| Finish { diffuse: 0.0, diffuse_back: 0.0, ..*finish });
        let reflected = self.local_light(point, shiny.as_ref().unwrap_or(finish), n, rgb, opacity);
        below.map_or(reflected, |below| Vec3A::from(below) + reflected)
    }

    /// What a layer sends back of the light of other surfaces, before it is tinted; `share` of it is seen.
    #[inline(never)]
    fn light_around(
        &mut self,
        point: &SurfacePoint<'_>,
        finish: &Finish,
        n: Vec3,
        share: f32,
        around: &mut [Option<Rgb>; 2],
    ) -> Rgb {
        let mut sum = Rgb::ZERO;
        // Steep bumps may lean over: the sides are those of the surface itself.
        let sides = [(finish.diffuse_raw, (n, point.n)), (finish.diffuse_back_raw, (-n, -point.n))];
        for ((diffuse, normals), around) in sides.into_iter().zip(around) {
            let share = share * diffuse;
            if around.is_none() && share > self.bailout {
                *around = self.irradiance(point, normals, point.beam.weight * share);
            }
            sum += around.unwrap_or(Rgb::ZERO) * diffuse;
        }
        sum
    }

    /// A layer's colour, or its quick one.
    fn pigment(&self, layer: &Layer, p: Vec3, context: &Context) -> Option<Color> {
        if self.quality.quick_color()
            && let Some(quick) = layer.pigment.quick_color()
        {
            return Some(quick);
        }
        layer.pigment.eval(p, context)
    }

    /// Quality 0 and 1: the colour of the last layer that shows.
    #[cold]
    fn flat(&self, layers: &[Layer], p: Vec3, context: &Context) -> Seen {
        let mut rgb = Rgb::ZERO;
        let (mut filter, mut through) = (Rgb::ONE, 1.0);
        for layer in layers.iter().rev() {
            if through <= self.bailout {
                break;
            }
            match self.pigment(layer, p, context) {
                Some(color) => {
                    rgb = color.rgb;
                    filter *= color.transmission();
                }
                None => rgb = Rgb::ONE,
            }
            through = grey(filter).abs().min(1.0);
        }
        Seen::opaque(rgb)
    }

    /// Adds what shines through and what the layers mirror.
    #[inline(never)]
    fn beyond(
        &mut self,
        point: &SurfacePoint<'_>,
        light: Rgb,
        below: &Below,
        top: &Top<'_>,
        mirrors: &[Mirror],
    ) -> Seen {
        if self.is_last() {
            return Seen::opaque(light);
        }
        let (mut rgb, mut transmit) = (light, 0.0);
        let mut total = false;
        if below.through > self.bailout && self.quality.refraction() {
            let weight = point.beam.weight * below.filter.abs().max_element();
            let behind = self.refract(point, top.n, weight);
            let fade = self.world.interior(point.material.interior).seen_through(point);
            total = behind.total;
            if total {
                rgb += fade * behind.seen.rgb() * self.film(top.irid, point, top.n);
            } else {
                let filter = if below.colored { below.filter } else { Rgb::ONE };
                rgb += fade * behind.seen.rgb() * filter;
                transmit = grey(fade) * behind.seen.transmit() * below.through;
            }
        }
        for mirror in mirrors {
            let same = (mirror.n - top.n).abs().max_element() < EPS;
            if !(total && same) {
                rgb += self.mirrored(point, mirror);
            }
        }
        Seen::new(rgb, transmit)
    }
}
