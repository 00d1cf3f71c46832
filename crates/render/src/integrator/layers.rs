//! A plain texture: its layers from the top down, then what shines through and what is mirrored (light spec,
//! section 3.2).
use raggio_image::{Color, Rgb, grey};
use raggio_math::{EPS, Vec3};
use raggio_scene::{Finish, Irid};
use raggio_shading::{Context, Layer};
use smallvec::SmallVec;

use super::reflection::Mirror;
use super::surface::SurfacePoint;
use super::{NormalPath, Seen, Tracer};

/// What the layers so far leave for what lies below.
struct Stack<'a> {
    /// The sum of light.
    light: Rgb,
    /// What the layers let through.
    filter: Rgb,
    /// The same as one number.
    through: f32,
    /// Did any layer have a colour?
    colored: bool,
    /// The normal of the top layer.
    n_top: Vec3,
    /// The thin film of the top layer, which colours total reflection.
    irid_top: Option<&'a Irid>,
    /// Diffuse light from other surfaces before and behind, found once for all layers.
    around: [Option<Rgb>; 2],
    /// The radius of the photons gathered, found once for all layers.
    photons: Option<f64>,
    mirrors: SmallVec<[Mirror; 2]>,
}

impl Tracer<'_> {
    /// What is seen of a plain texture at texture point `p`.
    pub(super) fn layers(
        &mut self,
        point: &SurfacePoint<'_>,
        layers: &[Layer],
        p: Vec3,
        path: &NormalPath<'_>,
        context: &Context,
    ) -> Seen {
        if !self.quality.lights() {
            return self.flat(layers, p, context);
        }
        let mut stack = Stack {
            light: Rgb::ZERO,
            filter: Rgb::ONE,
            through: 1.0,
            colored: false,
            n_top: point.n,
            irid_top: None,
            around: [None; 2],
            photons: None,
            mirrors: SmallVec::new(),
        };
        for (i, layer) in layers.iter().rev().enumerate() {
            if stack.through <= self.bailout {
                break;
            }
            let n = match &layer.normal {
                Some(normal) if self.quality.normals() => path.bend(normal, point.n, p, context),
                _ => point.n,
            };
            if i == 0 {
                stack.n_top = n;
                stack.irid_top = layer.finish.irid.as_ref();
            }
            self.layer(point, layer, n, (p, path), context, &mut stack);
        }
        self.beyond(point, &stack)
    }

    /// Adds one layer.
    #[inline(always)]
    fn layer(
        &mut self,
        point: &SurfacePoint<'_>,
        layer: &Layer,
        n: Vec3,
        (p, path): (Vec3, &NormalPath<'_>),
        context: &Context,
        stack: &mut Stack<'_>,
    ) {
        let footprint = match layer.pigment.is_smooth() {
            true => self.footprint(point, path, p),
            false => None,
        };
        let found = match footprint {
            Some(points) => layer.pigment.eval_over(&points, context),
            None => self.pigment(layer, p, context),
        };
        let color = found.unwrap_or(Color { rgb: Rgb::ONE, filter: 0.0, transmit: 1.0 });
        let finish = &layer.finish;
        let mirror = self.mirror(point, finish, n, color.rgb, stack.through);
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
        if self.radiosity.is_some() {
            own += self.light_around(point, finish, n, tint, stack);
        }
        let lit = match &self.radiosity {
            Some(state) if state.skips_lights() => Rgb::ZERO,
            _ => self.light_of_lights(point, finish, n, color.rgb, opacity),
        };
        let thrown = match &self.photons {
            Some(photons) if photons.on_surfaces() => {
                self.photon_light(point, finish, n, color.rgb, opacity, &mut stack.photons)
            }
            _ => Rgb::ZERO,
        };
        stack.light += stack.filter * (tint * own + lit + thrown);
        if found.is_some() {
            stack.colored = true;
            stack.filter *= color.transmission();
        }
        if let Some(mirror) = mirror {
            if finish.conserve_energy && found.is_some() {
                stack.filter *= (Rgb::ONE - mirror.reflectivity).min(Rgb::ONE);
            }
            stack.mirrors.push(mirror);
        }
        stack.through = grey(stack.filter).abs().min(1.0);
    }

    /// What a layer sends back of the light of lights. Light from under the surface takes the place of diffuse light.
    fn light_of_lights(
        &mut self,
        point: &SurfacePoint<'_>,
        finish: &Finish,
        n: Vec3,
        rgb: Rgb,
        opacity: f32,
    ) -> Rgb {
        let below = finish.subsurface.and_then(|_| self.light_from_below(point, finish, n, rgb));
        let shiny = below.map(|_| Finish { diffuse: 0.0, diffuse_back: 0.0, ..*finish });
        let reflected = self.local_light(point, shiny.as_ref().unwrap_or(finish), n, rgb, opacity);
        below.map_or(reflected, |below| below + reflected)
    }

    /// What a layer sends back of the light of other surfaces, before it is tinted.
    #[inline(never)]
    fn light_around(
        &mut self,
        point: &SurfacePoint<'_>,
        finish: &Finish,
        n: Vec3,
        tint: Rgb,
        stack: &mut Stack<'_>,
    ) -> Rgb {
        let mut sum = Rgb::ZERO;
        let sides = [(finish.diffuse_raw, n), (finish.diffuse_back_raw, -n)];
        for ((diffuse, n), around) in sides.into_iter().zip(&mut stack.around) {
            let share = grey(stack.filter * tint) * diffuse;
            if around.is_none() && share > self.bailout {
                *around = self.irradiance(point, n, point.beam.weight * share);
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
        Seen { rgb, transmit: 0.0 }
    }

    /// Adds what shines through and what the layers mirror.
    fn beyond(&mut self, point: &SurfacePoint<'_>, stack: &Stack<'_>) -> Seen {
        let mut seen = Seen { rgb: stack.light, transmit: 0.0 };
        let mut total = false;
        if stack.through > self.bailout && self.quality.refraction() {
            let weight = point.beam.weight * stack.filter.abs().max_element();
            let behind = self.refract(point, stack.n_top, weight);
            let fade = self.world.interior(point.material.interior).seen_through(point);
            total = behind.total;
            if total {
                seen.rgb += fade * behind.seen.rgb * self.film(stack.irid_top, point, stack.n_top);
            } else {
                let filter = if stack.colored { stack.filter } else { Rgb::ONE };
                seen.rgb += fade * behind.seen.rgb * filter;
                seen.transmit = grey(fade) * behind.seen.transmit * stack.through;
            }
        }
        for mirror in &stack.mirrors {
            let same = (mirror.n - stack.n_top).abs().max_element() < EPS;
            if !(total && same) {
                seen.rgb += self.mirrored(point, mirror);
            }
        }
        seen
    }
}
