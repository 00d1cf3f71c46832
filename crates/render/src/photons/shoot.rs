//! Shooting: for each light and target, rings of photons around the line between them (photon spec, sections 2.2 and
//! 2.3).
use std::f64::consts::PI;
use std::sync::atomic::{AtomicBool, Ordering};

use raggio_geometry::RayClass;
use raggio_image::Rgb;
use raggio_math::{Aabb, EPS, Ray, Vec3};
use rayon::prelude::*;

use super::map::{Nearest, PhotonMap};
use super::travel::{Flight, Landed};
use super::{Maps, Plan, Target, allowed};
use crate::api::Options;
use crate::integrator::{Beam, Interiors, Quality, Tracer};
use crate::lights::LightSource;
use crate::sampling::{Stream, Streams};
use crate::world::World;

/// How many rings are shot before `autostop` looks at them.
const BATCH: usize = 32;

/// A light and a target, with the frame of the rings.
pub(super) struct Pair<'a> {
    pub light: &'a LightSource,
    pub target: &'a Target,
    /// Middle of the target.
    centre: Vec3,
    /// Distance of photons at distance 1 (parallel: everywhere).
    spread: f64,
    /// Step and end of the rings: angles, or lengths for parallel lights.
    step: f64,
    end: f64,
    /// How photons stay in media; `None` where they do not.
    pub media: Option<Spread>,
    /// What photons have to meet to meet the target, if those that do not may be left out.
    aim: Option<Aabb>,
}

/// How photons stay in media.
#[derive(Clone, Copy)]
pub(super) struct Spread {
    /// The most in an interval.
    pub most: u32,
    /// How much farther apart they are than on surfaces.
    pub factor: f64,
    pub jitter: f64,
}

impl Spread {
    fn new(plan: &Plan) -> Option<Spread> {
        let settings = &plan.settings;
        (settings.media_max_steps > 0).then(|| Spread {
            most: settings.media_max_steps,
            factor: settings.media_factor.into(),
            jitter: settings.jitter.into(),
        })
    }
}

/// A ring: its angle, and where its random numbers start.
#[derive(Clone, Copy)]
struct Ring {
    theta: f64,
    random: Stream,
}

/// Shoots all photons of a scene, in the pool of the thread that calls.
pub fn shoot(world: &World, options: &Options, stack: usize, cancel: &AtomicBool) -> Maps {
    let quality = Quality::new(options.quality);
    let Some(plan) = world.photons.as_ref().filter(|_| quality.global_light()) else {
        return Maps::default();
    };
    let lights = world.light_sets.global().iter().map(|&i| &world.lights[i as usize]);
    let lights: Vec<&LightSource> = lights.filter(|l| !l.shadowless).collect();
    let spacing = spacing(plan, &lights);
    let level = plan.settings.max_trace_level.unwrap_or(world.rules.max_trace_level).clamp(1, 256);
    let bailout = plan.settings.adc_bailout.unwrap_or(world.rules.bailout);
    let shooter = Shooter { world, quality, level, bailout, stack, jitter: plan.settings.jitter.into() };
    let mut random = Stream::default();
    let (mut photons, mut in_media) = (Vec::new(), Vec::new());
    for light in &lights {
        for target in &plan.targets {
            if let Some(pair) = Pair::new(world, light, target, spacing, Spread::new(plan)) {
                shooter.pair(
                    &pair,
                    plan.settings.autostop.into(),
                    &mut random,
                    (&mut photons, &mut in_media),
                    cancel,
                );
            }
        }
    }
    let (mut surface, mut media) = (PhotonMap::new(photons), PhotonMap::new(in_media));
    surface.radius = radius(&surface, plan, Room::Surface);
    media.radius = radius(&media, plan, Room::Space);
    Maps { surface, media }
}

/// The distance of photons at distance 1 of a density of 1, by `spacing` or from `count`.
fn spacing(plan: &Plan, lights: &[&LightSource]) -> f64 {
    let spacing = f64::from(plan.settings.spacing);
    if plan.settings.count == 0 {
        return spacing;
    }
    let estimate = |light: &LightSource, target: &Target| {
        let (bends, mirrors) = effects(light, target);
        if !bends && !mirrors {
            return 0.0;
        }
        let reach = target.bounds.size().length() / 2.0;
        let density = f64::from(target.flags.target.unwrap_or(1.0));
        let mut count = 0.5 * PI * (reach / (density * spacing)).powi(2);
        if bends && mirrors {
            count *= 1.5;
        }
        match (target.flags.collect.unwrap_or(true), bends, mirrors) {
            (true, true, true) => count * 3.0,
            (true, true, false) => count * 2.0,
            _ => count,
        }
    };
    let sum: f64 = lights.iter().flat_map(|l| plan.targets.iter().map(move |t| estimate(l, t))).sum();
    spacing * (sum / f64::from(plan.settings.count)).sqrt()
}

/// Are photons refracted and reflected between these?
fn effects(light: &LightSource, target: &Target) -> (bool, bool) {
    (
        allowed(target.flags.refraction, light.photons.refraction),
        allowed(target.flags.reflection, light.photons.reflection),
    )
}

impl<'a> Pair<'a> {
    fn new(
        world: &World,
        light: &'a LightSource,
        target: &'a Target,
        spacing: f64,
        media: Option<Spread>,
    ) -> Option<Self> {
        if effects(light, target) == (false, false) {
            return None;
        }
        let centre = target.bounds.centre();
        let reach = target.bounds.size().length() / 2.0;
        let distance = (centre - light.position).length();
        let mut spread = f64::from(target.flags.target.unwrap_or(1.0)) * spacing;
        if !light.parallel {
            spread /= distance.max(EPS);
        }
        spread *= f64::from(light.photon_samples()).sqrt();
        let (step, end) = if light.parallel {
            (spread, reach)
        } else {
            (spread.atan(), if distance >= reach { (reach / distance).asin() } else { PI })
        };
        // Media whose samples lie at random have to be met, so that those after them lie where they did.
        let aim = (!world.random_media).then(|| target.bounds.grown(2e-3));
        (step > 0.0).then_some(Pair { light, target, centre, spread, step, end, media, aim })
    }

    /// How far to look for the target along the way of a photon that goes straight; `None` where it is not met.
    pub fn target_within(&self, ray: &Ray, reach: f64) -> Option<f64> {
        let Some(aim) = &self.aim else { return Some(reach) };
        aim.hit(ray).filter(|(_, far)| *far > 0.0).map(|(_, far)| reach.min(far))
    }

    /// How far apart photons are after a way.
    pub fn distance_at(&self, way: f64) -> f64 {
        if self.light.parallel { self.spread } else { self.spread * way }
    }

    /// A photon that lands after a way, with its power by the area that it stands for.
    pub fn landing(&self, p: Vec3, power: Rgb, way: f64, toward: Vec3) -> super::Photon {
        let area = self.distance_at(way).powi(2) * self.light.fading(way);
        super::Photon::new(p, power * area as f32, toward)
    }

    /// Calls `each` with the angles of a ring's photons; gives where the random numbers go on.
    fn ring(&self, ring: Ring, jitter: f64, mut each: impl FnMut(f64, f64)) -> Stream {
        let mut random = ring.random;
        let round = if ring.theta < EPS {
            2.0 * PI
        } else if self.light.parallel {
            self.step / ring.theta
        } else {
            self.step / ring.theta.sin()
        };
        let start = -PI + 0.5 * round * random.next();
        let end = PI - round / 2.0 + (start + PI);
        let mut phi = start;
        while phi < end {
            let turned = phi + round * (random.next() - 0.5) * jitter;
            let tilted = ring.theta + self.step * (random.next() - 0.5) * jitter;
            each(turned, tilted);
            phi += round.max(1e-6);
        }
        random
    }

    /// The ray of a photon that leaves a point of the light.
    fn ray(&self, from: Vec3, phi: f64, theta: f64) -> Ray {
        let helper = |t: Vec3| if (t.z.abs() - 1.0).abs() < 0.1 { Vec3::Y } else { Vec3::Z };
        let unit = |v: Vec3| v.try_normalize().unwrap_or(Vec3::X);
        if self.light.parallel {
            let axis = self.light.axis;
            let side = unit(axis.cross(helper(axis)));
            let back = axis.dot(self.centre - from);
            return Ray::new(self.centre - axis * back + turned(side * theta, axis, phi), axis);
        }
        let t = unit(self.centre - from);
        let side = unit(t.cross(helper(t)));
        Ray::new(from, turned(t * theta.cos() - side * theta.sin(), t, phi))
    }
}

/// Rodrigues' rotation about a unit axis.
fn turned(v: Vec3, k: Vec3, angle: f64) -> Vec3 {
    v * angle.cos() + k.cross(v) * angle.sin() + k * (k.dot(v) * (1.0 - angle.cos()))
}

/// What all pairs have in common.
struct Shooter<'w> {
    world: &'w World,
    quality: Quality,
    level: u16,
    bailout: f32,
    stack: usize,
    jitter: f64,
}

impl Shooter<'_> {
    /// Shoots at one target, ring after ring, until the rings have passed it.
    fn pair(
        &self,
        pair: &Pair<'_>,
        autostop: f64,
        random: &mut Stream,
        (photons, in_media): (&mut Vec<super::Photon>, &mut Vec<super::Photon>),
        cancel: &AtomicBool,
    ) {
        let mut theta = 0.0;
        let mut touched = false;
        while theta < pair.end && !cancel.load(Ordering::Relaxed) {
            let mut rings = Vec::with_capacity(BATCH);
            while theta < pair.end && rings.len() < BATCH {
                let ring = Ring { theta, random: *random };
                *random = pair.ring(ring, 0.0, |_, _| ());
                rings.push(ring);
                theta += pair.step;
            }
            let shot: Vec<_> = rings.par_iter().with_max_len(1).map(|r| self.ring(pair, *r)).collect();
            for (ring, landed) in rings.iter().zip(shot) {
                touched |= landed.touched;
                photons.extend(landed.photons);
                in_media.extend(landed.in_media);
                if touched && !landed.touched && ring.theta > autostop * pair.end {
                    return;
                }
            }
        }
    }

    fn ring(&self, pair: &Pair<'_>, ring: Ring) -> Landed {
        let mut tracer = Tracer::new(self.world, self.quality, self.level, self.stack);
        tracer.bailout = self.bailout;
        tracer.streams = Streams::new(1, ring.theta.to_bits() as i64, 0, 0);
        let mut landed = Landed::default();
        pair.ring(ring, self.jitter, |phi, theta| {
            for from in pair.light.photon_points() {
                let ray = pair.ray(from, phi, theta);
                self.photon(pair, ray, from, &mut tracer, &mut landed);
            }
        });
        landed
    }

    fn photon(
        &self,
        pair: &Pair<'_>,
        mut ray: Ray,
        from: Vec3,
        tracer: &mut Tracer<'_>,
        landed: &mut Landed,
    ) {
        let power = pair.light.photon_power(&ray, from);
        if power.max_element() < 1e-5 {
            return;
        }
        let mut way = 0.0;
        if let Some(window) = &pair.light.projected_through {
            let Some(t) = behind(window, &ray) else { return };
            ray.origin = ray.at(t);
            way = t;
        }
        let interiors: Interiors = self.world.geometry.interiors_at(ray.origin);
        let beam = Beam {
            ray: &ray,
            interiors: &interiors,
            weight: 1.0,
            class: RayClass::Photon,
            alpha: false,
            wavelength: None,
            reach: f64::INFINITY,
        };
        tracer.fly(&Flight { pair, beam, power, way, straight: false }, landed);
    }
}

/// The distance behind the last surface of an object that light is projected through.
fn behind(window: &raggio_geometry::Geometry, ray: &Ray) -> Option<f64> {
    let mut last = None;
    let mut start = 0.0;
    while let Some(hit) = window.closest(ray, (start, f64::INFINITY), RayClass::Any) {
        last = Some(hit.t);
        start = hit.t + EPS.max(hit.t * 1e-9);
    }
    last
}

impl LightSource {
    /// From how many points photons leave.
    fn photon_samples(&self) -> u32 {
        self.area.as_ref().filter(|a| a.photons && !self.parallel).map_or(1, |a| a.size1 * a.size2)
    }

    /// The points from which photons leave: the grid of an area light that asks for it.
    fn photon_points(&self) -> impl Iterator<Item = Vec3> {
        let grid = self.area.as_ref().filter(|a| a.photons && !self.parallel);
        let (n1, n2) = grid.map_or((1, 1), |a| (a.size1, a.size2));
        (0..n1).flat_map(move |i| {
            (0..n2).map(move |j| self.position + grid.map_or(Vec3::ZERO, |a| a.plain_offset(i, j)))
        })
    }

    /// The power that leaves along a ray: the light's colour by its cone, not by distance.
    fn photon_power(&self, ray: &Ray, from: Vec3) -> Rgb {
        self.color * self.emission(ray, from) as f32 / self.photon_samples() as f32
    }
}

/// Where photons lie, which decides on what their density is.
#[derive(Clone, Copy, PartialEq)]
enum Room {
    Surface,
    Space,
}

impl Room {
    /// The part of the room within a radius.
    fn within(self, radius: f64) -> f64 {
        match self {
            Room::Surface => PI * radius * radius,
            Room::Space => 4.0 / 3.0 * PI * radius.powi(3),
        }
    }

    /// The radius of so much room.
    fn radius(self, room: f64) -> f64 {
        match self {
            Room::Surface => (room / PI).sqrt(),
            Room::Space => (0.75 * room / PI).cbrt(),
        }
    }
}

/// The radius of gathers: as given, or from how dense photons lie around some of them.
fn radius(map: &PhotonMap, plan: &Plan, room: Room) -> f64 {
    let [surface, surface_factor, media, media_factor] = plan.settings.radius.map(f64::from);
    let (given, factor) = match room {
        Room::Surface => (surface, surface_factor),
        Room::Space => (media, media_factor),
    };
    if given > 0.0 || map.is_empty() {
        return given.max(0.0) * factor;
    }
    let max = plan.settings.gather_max as usize;
    let samples = (map.len() / 20).clamp(100, 1000).min(map.len());
    let stride = map.len() / samples;
    let (mut nearest, mut likely) = (Nearest::default(), f64::INFINITY);
    let mut density = |i: usize, radius: f64| {
        let photon = map.photon((i * stride) as u32);
        let p = Vec3::new(photon.p[0].into(), photon.p[1].into(), photon.p[2].into());
        map.search((p, None), radius, max, &mut likely, &mut nearest);
        nearest.len() as f64 / room.within(nearest.radius(radius)).max(1e-30)
    };
    // The cube of far distances must stay finite.
    let mean = (0..samples).map(|i| density(i, 1e100)).sum::<f64>() / samples as f64;
    let first = room.radius(max as f64 / mean);
    let thin = |&i: &usize| {
        let here = density(i, first);
        here > 0.05 * mean && here < 0.7 * mean
    };
    let share = (0..samples).filter(thin).count() as f64 / samples as f64;
    let wider = if room == Room::Space { 2.0 } else { 1.0 };
    first * (1.0 + 20.0 * share) * factor * wider
}
