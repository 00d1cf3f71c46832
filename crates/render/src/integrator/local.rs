//! A layer's answer to the lights: diffuse, highlights, iridescence (light spec, section 4).
use std::f64::consts::{FRAC_PI_2, TAU};

use glam::Vec3A;
use raggio_geometry::RayClass;
use raggio_image::Rgb;
use raggio_math::{EPS, Vec3, noise};
use raggio_scene::{Finish, Irid};

use super::Tracer;
use super::lobes::Lobes;
use super::surface::SurfacePoint;
use crate::lights::LightSource;

/// Everything about a layer that its answer to a light depends on.
struct Lit<'a> {
    finish: &'a Finish,
    n: &'a Vec3,
    /// The pigment's colour.
    rgb: &'a Rgb,
    opacity: f32,
    /// The ray's direction.
    view: &'a Vec3,
    highlights: bool,
}

/// How much a metal tints at an angle given in quarter turns: Fresnel's curve as an approximation.
pub(super) fn metal_tint(cosine: f64) -> f32 {
    let x = cosine.clamp(-1.0, 1.0).acos().abs() / FRAC_PI_2;
    (0.014567225 / ((x - 1.12) * (x - 1.12)) - 0.011612903).clamp(0.0, 1.0) as f32
}

/// `light` tinted by a metal of colour `rgb`.
pub(super) fn tinted(light: Rgb, metallic: f32, cosine: f64, rgb: Rgb) -> Rgb {
    light * (Rgb::ONE + (rgb - Rgb::ONE) * (metallic * (1.0 - metal_tint(cosine))))
}

impl Tracer<'_> {
    /// What a layer sends back of all lights; as a vector of four numbers, which can be handed on as a whole.
    #[inline]
    pub(super) fn local_light(
        &mut self,
        point: &SurfacePoint<'_>,
        finish: &Finish,
        n: &Vec3,
        rgb: &Rgb,
        opacity: f32,
    ) -> Vec3A {
        let dull = finish.diffuse == 0.0 && finish.diffuse_back == 0.0;
        if dull && finish.specular == 0.0 && finish.phong == 0.0 {
            return Vec3A::ZERO;
        }
        let lit = Lit::new(point, finish, n, rgb, opacity);
        let mut sum = Vec3A::ZERO;
        for (i, &light) in point.lights.iter().enumerate() {
            let source = &self.world.lights[light as usize];
            let wide = self.quality.area_lights() && source.area.as_ref().is_some_and(|a| a.illumination);
            let share = if wide {
                self.light_by_area(point, &lit, i, source).into()
            } else {
                self.light_by_centre(point, &lit, i, source)
            };
            sum += share;
        }
        sum
    }

    /// Not inlined: the compiler would work out before the loop over lights all that any of them might ask for.
    #[inline(never)]
    fn light_by_centre(
        &mut self,
        point: &SurfacePoint<'_>,
        lit: &Lit<'_>,
        i: usize,
        source: &LightSource,
    ) -> Vec3A {
        let p = point.surface.p;
        let path = source.path(p);
        let cosine = lit.n.dot(path.ray.dir);
        let Some(back) = facing(point, lit, cosine) else { return Vec3A::ZERO };
        // Most of what is only shiny sends nothing back, whatever stands in the way of the light.
        let shiny = lit.highlights && !source.shadowless && !back;
        if lit.is_dull(back) && !(shiny && highlight(lit, &path.ray.dir) != 0.0) {
            return Vec3A::ZERO;
        }
        let light = self.arriving_once(point, i, |tracer| {
            let bare = source.arriving(&path, source.position);
            tracer.after_shadows(source, &path, bare, &point.start())
        });
        if light.abs().max_element() <= EPS as f32 {
            return Vec3A::ZERO;
        }
        let sum = self.answer(lit, light, (&path.ray.dir, cosine), back, !source.shadowless, f32::powf);
        self.iridescent(point, lit, &path.ray.dir, sum).into()
    }

    /// `area_illumination`: every point of the light lights by its own direction, all share one shadow.
    #[inline(never)]
    fn light_by_area(
        &mut self,
        point: &SurfacePoint<'_>,
        lit: &Lit<'_>,
        i: usize,
        source: &LightSource,
    ) -> Rgb {
        let Some(grid) = &source.area else { return Rgb::ZERO };
        let p = point.surface.p;
        let centre = source.path(p);
        let shadowed = self.arriving_once(point, i, |tracer| {
            tracer.after_shadows(source, &centre, source.color, &point.start())
        });
        if shadowed.abs().max_element() <= EPS as f32 {
            return Rgb::ZERO;
        }
        let each = shadowed / (grid.size1 * grid.size2) as f32;
        let axes = grid.axes(centre.ray.dir);
        let random = self.streams.numbers().lights;
        grid.pass_over(&mut self.streams.numbers().lights);
        let mut sum = Rgb::ZERO;
        for cell in 0..grid.size1 * grid.size2 {
            let from = source.position + grid.offset(axes, cell, &random);
            let path = source.path_to(p, from);
            let cosine = lit.n.dot(path.ray.dir);
            let Some(back) = facing(point, lit, cosine) else { continue };
            let light = each * source.attenuation(&path, from) as f32;
            let answer =
                self.answer(lit, light, (&path.ray.dir, cosine), back, !source.shadowless, f32::powf);
            sum += self.iridescent(point, lit, &path.ray.dir, answer);
        }
        sum
    }

    /// What a layer sends back of light from some directions.
    pub(crate) fn lit_from(
        &mut self,
        point: &SurfacePoint<'_>,
        finish: &Finish,
        n: Vec3,
        (rgb, opacity): (Rgb, f32),
        lights: impl Iterator<Item = (Vec3, Rgb)>,
        lobes: &mut Lobes,
    ) -> Rgb {
        lobes.begin(finish.brilliance);
        let lit = Lit::new(point, finish, &n, &rgb, opacity);
        let mut sum = Rgb::ZERO;
        for (dir, light) in lights {
            let cosine = n.dot(dir);
            if let Some(back) = facing(point, &lit, cosine) {
                sum += self.answer(&lit, light, (&dir, cosine), back, true, |cosine, _| lobes.power(cosine));
            }
        }
        sum
    }

    /// Diffuse light and, from `shiny` lights, highlights for light from a direction with its cosine. `power` raises
    /// cosines to the finish's `brilliance`.
    #[inline(always)]
    fn answer(
        &mut self,
        lit: &Lit<'_>,
        light: Rgb,
        (dir, cosine): (&Vec3, f64),
        back: bool,
        shiny: bool,
        power: impl FnOnce(f32, f32) -> f32,
    ) -> Rgb {
        let finish = lit.finish;
        let mut sum = Rgb::ZERO;
        let diffuse = if back { finish.diffuse_back } else { finish.diffuse };
        if diffuse > 0.0 {
            let facing = cosine.abs() as f32;
            let lobe = if finish.brilliance == 1.0 { facing } else { power(facing, finish.brilliance) };
            let mut intensity = lobe * diffuse * lit.opacity;
            if finish.crand > 0.0 {
                intensity -= self.streams.numbers().crand.next() as f32 * finish.crand;
            }
            sum += *lit.rgb * light * intensity;
        }
        if lit.highlights && shiny && !back {
            let strength = highlight(lit, dir);
            if strength != 0.0 {
                let tint = match finish.metallic != 0.0 {
                    true => tinted(light, finish.metallic, cosine, *lit.rgb),
                    false => light,
                };
                sum += tint * strength;
            }
        }
        sum
    }

    #[inline(always)]
    fn iridescent(&self, point: &SurfacePoint<'_>, lit: &Lit<'_>, dir: &Vec3, light: Rgb) -> Rgb {
        match &lit.finish.irid {
            Some(irid) if irid.amount != 0.0 => {
                let way = lit.n.dot(*dir).abs() + lit.n.dot(*lit.view).abs();
                light * self.interference(irid, point.surface.p, way)
            }
            _ => light,
        }
    }

    /// Brightening and darkening by a thin film (textures spec, section 9.3).
    #[inline(never)]
    pub(super) fn interference(&self, irid: &Irid, p: Vec3, way: f64) -> Rgb {
        let mut thickness = f64::from(irid.thickness);
        if irid.turbulence != 0.0 {
            let t = noise::turbulence(self.world.rules.noise.generator, p, 5, 0.5, 2.0);
            thickness *= 1.0 + f64::from(irid.turbulence) * (2.0 * t - 1.0);
        }
        let wave = |lambda: f32| {
            let phase = TAU * thickness * way / f64::from(lambda);
            1.0 + irid.amount * phase.cos() as f32
        };
        let lambda = self.world.rules.wavelengths;
        Rgb::new(wave(lambda.x), wave(lambda.y), wave(lambda.z))
    }
}

impl<'a> Lit<'a> {
    fn new(
        point: &'a SurfacePoint<'_>,
        finish: &'a Finish,
        n: &'a Vec3,
        rgb: &'a Rgb,
        opacity: f32,
    ) -> Lit<'a> {
        let shines = finish.phong > 0.0 || finish.specular > 0.0;
        let highlights = shines && point.beam.class != RayClass::Radiosity;
        Lit { finish, n, rgb, opacity, view: &point.beam.ray.dir, highlights }
    }

    /// Is nothing sent back of light but highlights?
    #[inline]
    fn is_dull(&self, back: bool) -> bool {
        let diffuse = if back { self.finish.diffuse_back } else { self.finish.diffuse };
        diffuse <= 0.0 || ((self.opacity == 0.0 || *self.rgb == Rgb::ZERO) && self.finish.crand == 0.0)
    }
}

/// Does light count that comes at an angle with that cosine? `Some(true)` is light from behind.
#[inline]
fn facing(point: &SurfacePoint<'_>, lit: &Lit<'_>, cosine: f64) -> Option<bool> {
    if point.material.double_illuminate || cosine >= EPS {
        return Some(false);
    }
    (lit.finish.diffuse_back != 0.0).then_some(true)
}

/// `x` to the power of `exponent`; 0 below 1e-11, where most of a surface lies and nothing is seen.
fn lobe(x: f64, exponent: f64) -> f32 {
    // The logarithm of x is at most x - 1.
    if exponent * (x - 1.0) < -25.0 { 0.0 } else { (x as f32).powf(exponent as f32) }
}

/// The strength of `phong` and `specular` highlights together.
#[inline(never)]
fn highlight(lit: &Lit<'_>, dir: &Vec3) -> f32 {
    let (finish, view, n) = (lit.finish, *lit.view, *lit.n);
    let mut strength = 0.0;
    if finish.phong > 0.0 {
        let mirrored = view - n * (2.0 * view.dot(n));
        let x = mirrored.dot(*dir);
        // Sharp highlights are cut where their power would be lost in rounding.
        if x > 0.0 && (finish.phong_size < 60.0 || x > 0.0008) {
            strength += finish.phong * lobe(x, f64::from(finish.phong_size));
        }
    }
    if finish.specular > 0.0 {
        let halfway = (*dir - view) * 0.5;
        let x = n.dot(halfway) / halfway.length();
        if x > 0.0 {
            strength += finish.specular * lobe(x, 1.0 / f64::from(finish.roughness));
        }
    }
    strength
}
