//! The way of a photon: from surface to surface until it is stored, stopped or too weak (photon spec, section 2.4).
use raggio_image::{Color, Rgb, grey};
use raggio_math::{MIN_HIT, Ray, Vec3};
use raggio_shading::{Context, Layer};
use smallvec::SmallVec;

use super::shoot::{Pair, Spread};
use super::{Photon, allowed};
use crate::integrator::reflection::{Mirror, reflected, reflected_ray};
use crate::integrator::surface::SurfacePoint;
use crate::integrator::{Beam, Interiors, NormalPath, Tracer, fade, for_each_plain, placed, toggle};
use crate::media::Steps;

/// A photon under way.
pub(super) struct Flight<'a> {
    pub pair: &'a Pair<'a>,
    pub beam: Beam<'a>,
    pub power: Rgb,
    /// The way so far.
    pub way: f64,
    /// Did it pass straight through what it met last?
    pub straight: bool,
}

impl<'a> Flight<'a> {
    /// The way on from the surface in work.
    fn then<'b>(&self, beam: Beam<'b>, power: Rgb) -> Flight<'b>
    where
        'a: 'b,
    {
        Flight { pair: self.pair, beam, power, way: self.way, straight: false }
    }
}

/// What became of a ring.
#[derive(Default)]
pub(super) struct Landed {
    pub photons: Vec<Photon>,
    /// Those that stayed in media.
    pub in_media: Vec<Photon>,
    /// Did any meet the target?
    pub touched: bool,
}

/// What the layers of a surface do to a photon.
struct Passed {
    filter: Rgb,
    through: f32,
    n_top: Vec3,
    n_bottom: Vec3,
    mirrors: SmallVec<[Mirror; 2]>,
}

impl Tracer<'_> {
    /// Follows a photon.
    pub(super) fn fly(&mut self, flight: &Flight<'_>, landed: &mut Landed) {
        let beam = &flight.beam;
        if self.level >= self.max_level || beam.weight < self.bailout || self.stack_is_spent() {
            return;
        }
        let world = self.world;
        let before_target = self.level == 0 || flight.straight;
        let reach = match before_target {
            true => flight.pair.target_within(beam.ray, beam.reach),
            false => Some(beam.reach),
        };
        let Some(reach) = reach else { return };
        let Some(hit) = world.geometry.closest(beam.ray, (MIN_HIT, reach), beam.class) else { return };
        let surface = world.geometry.interaction(beam.ray, &hit);
        let material = world.material(&surface);
        let target = flight.pair.target.owns(material, beam.ray, &hit);
        if before_target && target {
            landed.touched = true;
        } else if before_target && !material.photons.pass_through {
            return;
        }
        let mut power = flight.power;
        if !beam.interiors.is_empty() {
            power = match flight.pair.media.filter(|_| self.level > 0 && !flight.straight) {
                Some(media) => self.stay(flight, media, hit.t, world.light_sets.of(material), landed),
                None => power * self.media_filter(beam.interiors, beam.ray, hit.t),
            };
        }
        let interior = &world.interior(material.interior).interior;
        if interior.fade_power > 0.0 && beam.interiors.contains(&material.interior) {
            power *= fade(interior, hit.t);
        }
        let way = flight.way + hit.t;
        if self.level > 0 && !flight.straight && material.photons.collect.unwrap_or(true) {
            landed.photons.push(flight.pair.landing(surface.p, power, way, -beam.ray.dir));
        }
        let point = SurfacePoint {
            beam,
            depth: hit.t,
            convex: None,
            n: if surface.from_inside { -surface.n } else { surface.n },
            surface: &surface,
            material,
            lights: &[],
            arriving: None,
        };
        self.level += 1;
        let next = Flight { pair: flight.pair, beam: *beam, power, way, straight: false };
        self.at_surface(&next, &point, before_target && !target, landed);
        self.level -= 1;
    }

    /// Leaves photons in the media of a segment; gives what is left of the power.
    fn stay(
        &mut self,
        flight: &Flight<'_>,
        media: Spread,
        depth: f64,
        lights: &[u32],
        landed: &mut Landed,
    ) -> Rgb {
        let (pair, beam) = (flight.pair, &flight.beam);
        let spacing = pair.distance_at(flight.way) * media.factor;
        let steps = Steps { spacing, most: media.most, jitter: media.jitter };
        self.media_photons(beam, depth, lights, &steps, flight.power, &mut |t, power, stretch| {
            let way = flight.way + t;
            let longer = media.factor * stretch * pair.distance_at(way);
            landed.in_media.push(pair.landing(beam.ray.at(t), power * longer as f32, way, -beam.ray.dir));
        })
    }

    /// Does at a surface what all its textures do, each with its share.
    fn at_surface(
        &mut self,
        flight: &Flight<'_>,
        point: &SurfacePoint<'_>,
        passing: bool,
        landed: &mut Landed,
    ) {
        let world = self.world;
        let context = point.context();
        for used in point.surface.textures.as_slice() {
            let texture = world.texture(used.texture);
            let (path, p) = placed(texture, point.surface, point.material);
            for_each_plain(
                &texture.texture,
                p,
                used.weight,
                &path,
                &context,
                &mut |layers, p, share, path| {
                    let passed = self.photon_layers(point, layers, p, path, &context);
                    let power = flight.power * share;
                    if passing {
                        self.pass(flight, point, power, &passed, landed);
                    } else {
                        self.split(flight, point, power, &passed, landed);
                    }
                },
            );
        }
    }

    fn photon_layers(
        &self,
        point: &SurfacePoint<'_>,
        layers: &[Layer],
        p: Vec3,
        path: &NormalPath<'_>,
        context: &Context,
    ) -> Passed {
        let (mut filter, mut through) = (Rgb::ONE, 1.0);
        let (mut n_top, mut n_bottom) = (point.n, point.n);
        let mut mirrors = SmallVec::new();
        for (i, layer) in layers.iter().rev().enumerate() {
            if through <= self.bailout {
                break;
            }
            n_bottom = match &layer.normal {
                Some(normal) => path.bend(normal, point.n, p, context),
                None => point.n,
            };
            if i == 0 {
                n_top = n_bottom;
            }
            let found = layer.pigment.eval(p, context);
            let color = found.unwrap_or(Color { rgb: Rgb::ONE, filter: 0.0, transmit: 1.0 });
            let mirror = self.mirror(point, layer, n_bottom, color.rgb, through);
            if found.is_some() {
                filter *= Color { rgb: color.rgb * filter, ..color }.transmission();
            }
            if let Some(mirror) = mirror {
                if layer.finish.conserve_energy && found.is_some() {
                    filter *= (Rgb::ONE - mirror.reflectivity).min(Rgb::ONE);
                }
                mirrors.push(mirror);
            }
            through = grey(filter).abs().min(1.0);
        }
        Passed { filter, through, n_top, n_bottom, mirrors }
    }

    /// Straight on through an object that lets photons pass on their way to the target.
    fn pass(
        &mut self,
        flight: &Flight<'_>,
        point: &SurfacePoint<'_>,
        power: Rgb,
        passed: &Passed,
        landed: &mut Landed,
    ) {
        let mut interiors = Interiors::from_slice(flight.beam.interiors);
        toggle(&mut interiors, point.material.interior);
        let ray = Ray::new(point.surface.p, flight.beam.ray.dir);
        let weight = flight.beam.weight * passed.filter.abs().max_element();
        let beam = Beam { ray: &ray, interiors: &interiors, weight, ..flight.beam };
        let power = power * passed.filter;
        self.fly(&Flight { straight: true, ..flight.then(beam, power) }, landed);
    }

    /// Refracts and reflects.
    fn split(
        &mut self,
        flight: &Flight<'_>,
        point: &SurfacePoint<'_>,
        power: Rgb,
        passed: &Passed,
        landed: &mut Landed,
    ) {
        let (object, light) = (&point.material.photons, &flight.pair.light.photons);
        let mut total = false;
        if allowed(object.refraction, light.refraction) && passed.through > self.bailout {
            let weight = flight.beam.weight * passed.filter.abs().max_element();
            self.world.bend(point, passed.n_top, weight, &mut |bent| {
                total = bent.total && bent.share == 1.0;
                let filter = if bent.total { Rgb::ONE } else { passed.filter };
                self.fly(&flight.then(bent.beam, power * bent.hue * filter), landed);
            });
        }
        if !allowed(object.reflection, light.reflection) {
            return;
        }
        for mirror in &passed.mirrors {
            let same = (mirror.n - passed.n_top).abs().max_element() < raggio_math::EPS;
            if mirror.reflectivity == Rgb::ZERO || (total && same) {
                continue;
            }
            let weight = flight.beam.weight * mirror.reflectivity.max_element();
            let ray = reflected_ray(point, passed.n_bottom);
            let beam = reflected(point, &ray, weight);
            self.fly(&flight.then(beam, mirror.apply(power)), landed);
        }
    }
}
