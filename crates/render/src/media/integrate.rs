//! Sampling along a ray: intervals, the three methods, the sum (media spec, sections 1.4 and 1.5).
use raggio_geometry::InteriorId;
use raggio_image::Rgb;
use raggio_math::{Ray, Vec3};
use raggio_shading::Context;
use smallvec::SmallVec;

use super::lit::{LitRanges, Range};
use super::phase::{is_isotropic, phase};
use super::reach::Reach;
use super::{Joined, Medium, exp};
use crate::integrator::Tracer;
use crate::lights::Start;

/// Everything that stays the same along a segment.
pub(super) struct Along<'a> {
    pub media: Joined<'a>,
    pub leader: &'a Medium,
    /// The smallest threshold of all media.
    pub aa_threshold: f32,
    pub ray: Ray,
    context: Context,
    pub lights: LitRanges,
    pub interiors: &'a [InteriorId],
    /// Only dimming counts.
    pub shadow: bool,
    /// What all media together are, where that is the same everywhere.
    pub even: Option<Stuff>,
    /// Where each medium can be anything at all; empty where they may be everywhere.
    reaches: SmallVec<[Reach; 4]>,
}

/// What all media together are at a point, before any light.
#[derive(Clone, Copy, Default)]
pub(super) struct Stuff {
    glow: Rgb,
    dim: Rgb,
    scattered: Rgb,
}

impl<'a> Along<'a> {
    /// A segment of a ray, of a length, through some media of which one leads. Only dimming counts, and no lights.
    pub(super) fn new(
        media: Joined<'a>,
        leader: &'a Medium,
        ray: Ray,
        depth: f64,
        interiors: &'a [InteriorId],
    ) -> Self {
        let aa_threshold = media.iter().map(|m| m.sampling.aa_threshold).fold(f32::INFINITY, f32::min);
        let even = Stuff::even(&media);
        let bounded = media.iter().any(|medium| !medium.shells.is_empty());
        let reach = |medium: &&Medium| Reach::of(&medium.shells, &ray, depth);
        let reaches = if bounded { media.iter().map(reach).collect() } else { SmallVec::new() };
        let context = Context { ray_dir: ray.dir, ..Context::NONE };
        let lights = LitRanges::new();
        Along { media, leader, aa_threshold, ray, context, lights, interiors, shadow: true, even, reaches }
    }

    /// The same with light that it sends, and that of lights scattered in it.
    pub(super) fn lit_by(self, lights: LitRanges) -> Self {
        Along { lights, shadow: false, ..self }
    }

    /// What all media together are at distance `t`, at a point.
    #[inline]
    fn stuff(&self, t: f64, p: Vec3) -> Stuff {
        self.even.unwrap_or_else(|| {
            let mut sum = Stuff::default();
            self.each_density(t, p, |medium, density| sum.add(medium, density));
            sum
        })
    }

    /// How they dim light there.
    #[inline]
    fn dim(&self, t: f64, p: Vec3) -> Rgb {
        let mut sum = Rgb::ZERO;
        self.each_density(t, p, |medium, density| sum += density * medium.extinction);
        sum
    }

    #[inline(always)]
    fn each_density(&self, t: f64, p: Vec3, mut tell: impl FnMut(&Medium, Rgb)) {
        for (i, medium) in self.media.iter().enumerate() {
            if self.reaches.get(i).is_none_or(|reach| reach.contains(t)) {
                tell(medium, medium.density(p, &self.context));
            }
        }
    }
}

impl Stuff {
    /// Adds a medium of a density.
    #[inline]
    fn add(&mut self, medium: &Medium, density: Rgb) {
        self.dim += density * medium.extinction;
        self.glow += density * medium.emission;
        if let Some(scattering) = &medium.scattering {
            self.scattered += density * scattering.color;
        }
    }

    /// The sum over media that are the same everywhere, if all are.
    fn even(media: &Joined<'_>) -> Option<Stuff> {
        let mut sum = Stuff::default();
        for medium in media {
            sum.add(medium, medium.even?);
        }
        Some(sum)
    }
}

/// Part of a segment with the sums of its samples.
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct Interval {
    pub(super) start: f64,
    pub(super) length: f64,
    lit: bool,
    glow: Rgb,
    glow_squares: Rgb,
    depth: Rgb,
    samples: f32,
}

pub(super) type Intervals = SmallVec<[Interval; 2]>;

/// What stuff does at a point: the light it sends, and how it dims.
#[derive(Clone, Copy)]
pub(super) struct Sample {
    glow: Rgb,
    pub(super) dim: Rgb,
}

/// Divides pieces into sampling intervals.
pub(super) fn intervals(pieces: &[(Range, bool)], leader: &Medium) -> Intervals {
    let wanted = (leader.sampling.intervals as usize).max(pieces.len());
    let mut all = Intervals::new();
    let mut add = |(start, end): Range, lit: bool, n: usize| {
        let length = (end - start) / n as f64;
        all.extend((0..n).map(|i| Interval {
            start: start + length * i as f64,
            length,
            lit,
            ..Interval::default()
        }));
    };
    if let [(range, lit)] = *pieces {
        let simple = !lit && leader.densities.is_empty();
        add(range, lit, if simple { 1 } else { wanted });
        return all;
    }
    let ratio = leader.sampling.ratio;
    let weight = |lit: bool| if lit { ratio } else { 1.0 - ratio };
    let sum: f64 = pieces.iter().map(|p| weight(p.1)).sum();
    let mut remaining = wanted;
    for (i, &(range, lit)) in pieces.iter().enumerate() {
        let share = (weight(lit) / sum * wanted as f64) as usize + 1;
        let n = share.min((remaining + i + 1).saturating_sub(pieces.len())).max(1);
        remaining = remaining.saturating_sub(n);
        add(range, lit, n);
    }
    all
}

impl Tracer<'_> {
    /// Light from along the segment, and its optical depth.
    pub(super) fn integrate(&mut self, along: &Along<'_>, mut intervals: Intervals) -> (Rgb, Rgb) {
        match along.leader.sampling.method {
            3 => intervals.iter_mut().for_each(|interval| self.adaptive(along, interval)),
            _ => self.stochastic(along, &mut intervals),
        }
        let (mut glow, mut depth) = (Rgb::ZERO, Rgb::ZERO);
        for interval in &intervals {
            glow += interval.glow / interval.samples * exp(-depth);
            depth += interval.depth / interval.samples;
        }
        (glow, depth)
    }

    /// Optical depth along a segment of which only dimming counts.
    pub(super) fn optical_depth(&mut self, along: &Along<'_>, intervals: Intervals) -> Rgb {
        // Where nothing glows nothing differs, so that method 3 refines nothing.
        if along.leader.sampling.method == 3 && along.aa_threshold >= 0.0 {
            return intervals.iter().fold(Rgb::ZERO, |sum, interval| sum + self.even_depth(along, interval));
        }
        self.integrate(along, intervals).1
    }

    /// The optical depth of an interval by the samples that method 3 always takes.
    fn even_depth(&mut self, along: &Along<'_>, interval: &Interval) -> Rgb {
        let sampling = &along.leader.sampling;
        let n = sampling.steps();
        let step = 1.0 / f64::from(n + 1);
        let length = interval.length as f32;
        let mut dim = |d: f64, width: f64| {
            let d = d + width * sampling.jitter * (self.streams.numbers().media.next() - 0.5);
            let t = interval.start + d * interval.length;
            along.dim(t, along.ray.at(t)) * length
        };
        let mut before = dim(0.0, step);
        let mut depth = Rgb::ZERO;
        for j in 1..=n {
            let here = dim(f64::from(j) * step, step);
            let ends = (f64::from(j - 1) * step, f64::from(j) * step);
            let middle = dim((ends.0 + ends.1) / 2.0, ends.1 - ends.0);
            let third = 1.0 / 3.0;
            depth += if sampling.aa_level <= 1 {
                before * third + middle * third + here * third
            } else {
                let half = middle * (1.0 / 6.0);
                (before * third + half) + (here * third + half)
            };
            before = here;
        }
        depth / n as f32
    }

    /// Methods 1 and 2: samples at random or stratified, and more where they differ much.
    fn stochastic(&mut self, along: &Along<'_>, intervals: &mut Intervals) {
        let sampling = &along.leader.sampling;
        for interval in intervals.iter_mut() {
            for j in 0..sampling.min {
                let u = self.streams.numbers().media.next();
                let d = match sampling.method {
                    2 => (f64::from(j) + 0.5 + u * sampling.jitter) / f64::from(sampling.min),
                    _ => u,
                };
                self.add_sample(along, interval, d);
            }
        }
        if along.shadow || sampling.max <= sampling.min {
            return;
        }
        for interval in intervals.iter_mut() {
            while interval.samples <= sampling.max as f32 && interval.uncertain(&sampling.thresholds) {
                let d = self.streams.numbers().media.next();
                self.add_sample(along, interval, d);
            }
        }
    }

    fn add_sample(&mut self, along: &Along<'_>, interval: &mut Interval, d: f64) {
        let sample = self.medium_at(along, interval.start + d * interval.length, interval.lit);
        let length = interval.length as f32;
        let glow = sample.glow * length * exp(-sample.dim * (d as f32 * length));
        interval.glow += glow;
        interval.glow_squares += glow * glow;
        interval.depth += sample.dim * length;
        interval.samples += 1.0;
    }

    /// Method 3: evenly spaced samples, refined where neighbours differ.
    fn adaptive(&mut self, along: &Along<'_>, interval: &mut Interval) {
        let sampling = &along.leader.sampling;
        let n = sampling.steps();
        let level = sampling.aa_level as i32 - 1;
        if let Some(sample) = self.steady(along, interval) {
            self.streams.numbers().media.skip(2 * n + 1);
            let mean = refine(&mut |_, _| sample, (0.0, 1.0), sample, sample, level, along.aa_threshold);
            let (mut glow, mut depth) = (Rgb::ZERO, Rgb::ZERO);
            for _ in 0..n {
                glow += seen_through(mean.glow, depth / n as f32);
                depth += mean.dim;
            }
            (interval.glow, interval.depth, interval.samples) = (glow, depth, n as f32);
            return;
        }
        let step = 1.0 / f64::from(n + 1);
        let jittered = |tracer: &mut Self, d: f64, width: f64| {
            let d = d + width * sampling.jitter * (tracer.streams.numbers().media.next() - 0.5);
            let sample = tracer.medium_at(along, interval.start + d * interval.length, interval.lit);
            let length = interval.length as f32;
            Sample { glow: sample.glow * length, dim: sample.dim * length }
        };
        let mut before = jittered(self, 0.0, step);
        let (mut glow, mut depth) = (Rgb::ZERO, Rgb::ZERO);
        for j in 1..=n {
            let here = jittered(self, f64::from(j) * step, step);
            let ends = (f64::from(j - 1) * step, f64::from(j) * step);
            let mut sample = |d, width| jittered(self, d, width);
            let mean = refine(&mut sample, ends, before, here, level, along.aa_threshold);
            glow += seen_through(mean.glow, depth / n as f32);
            depth += mean.dim;
            before = here;
        }
        interval.glow = glow;
        interval.depth = depth;
        interval.samples = n as f32;
    }

    /// The sample of method 3 that all of an interval are alike, if they are: even stuff out of the light.
    fn steady(&self, along: &Along<'_>, interval: &Interval) -> Option<Sample> {
        let stuff = along.even.filter(|_| along.aa_threshold >= 0.0)?;
        let dark = !interval.lit && self.photons.is_none();
        let length = interval.length as f32;
        let sample = Sample { glow: stuff.glow * length, dim: stuff.dim * length };
        (dark || stuff.scattered == Rgb::ZERO).then_some(sample)
    }

    /// What all media together do at distance `t`.
    pub(super) fn medium_at(&mut self, along: &Along<'_>, t: f64, lit: bool) -> Sample {
        let p = along.ray.at(t);
        let Stuff { mut glow, dim, scattered } = along.stuff(t, p);
        if along.shadow {
            return Sample { glow: Rgb::ZERO, dim };
        }
        if scattered == Rgb::ZERO {
            return Sample { glow, dim };
        }
        if let Some(photons) = &mut self.photons {
            let isotropic = along.media.iter().all(|m| m.scattering.as_ref().is_none_or(is_isotropic));
            let phase = |toward: Vec3| mean_phase(&along.media, toward.dot(along.ray.dir));
            glow +=
                scattered * if isotropic { photons.in_media(p, |_| 1.0) } else { photons.in_media(p, phase) };
        }
        if !lit {
            return Sample { glow, dim };
        }
        for &(light, range) in &along.lights {
            if t < range.0 || t > range.1 {
                continue;
            }
            let source = &self.world.lights[light as usize];
            let path = source.path(p);
            let bare = source.arriving(&path, source.position);
            let collects = along.media.iter().any(|m| m.collect);
            let start = Start { interiors: along.interiors, collects, own: None };
            let light = self.after_shadows(source, &path, bare, &start);
            if light != Rgb::ZERO {
                glow += scattered * light * mean_phase(&along.media, path.ray.dir.dot(along.ray.dir));
            }
        }
        Sample { glow, dim }
    }
}

impl Interval {
    /// Do the samples so far differ too much?
    fn uncertain(&self, thresholds: &[f64]) -> bool {
        let n = self.samples;
        let mean = self.glow / n;
        let variance = (self.glow_squares / n - mean * mean) / n;
        let limit = thresholds.get(n as usize).or(thresholds.last());
        limit.is_some_and(|&limit| f64::from(variance.max_element()) >= limit)
    }
}

/// The mean phase function of all media, those without scattering counting as isotropic.
fn mean_phase(media: &Joined<'_>, cosine: f64) -> f32 {
    let sum: f64 = media.iter().map(|m| m.scattering.as_ref().map_or(1.0, |s| phase(s, cosine))).sum();
    (sum / media.len() as f64) as f32
}

impl Sample {
    #[inline(always)]
    fn times(self, v: f32) -> Sample {
        Sample { glow: self.glow * v, dim: self.dim * v }
    }

    #[inline(always)]
    fn plus(self, other: Sample) -> Sample {
        Sample { glow: self.glow + other.glow, dim: self.dim + other.dim }
    }
}

/// What is left of light behind so much.
#[inline]
fn seen_through(light: Rgb, depth: Rgb) -> Rgb {
    if light == Rgb::ZERO { light } else { light * exp(-depth) }
}

/// The mean between two samples, with more samples between them where their light differs.
fn refine(
    sample: &mut impl FnMut(f64, f64) -> Sample,
    ends: Range,
    a: Sample,
    b: Sample,
    level: i32,
    threshold: f32,
) -> Sample {
    let d = (ends.0 + ends.1) / 2.0;
    let m = sample(d, ends.1 - ends.0);
    let third = 1.0 / 3.0;
    if level <= 0 {
        return a.times(third).plus(m.times(third)).plus(b.times(third));
    }
    let half = m.times(1.0 / 6.0);
    let differs = |x: Sample| (x.glow - m.glow).abs().element_sum() > threshold;
    let left = match differs(a) {
        true => refine(sample, (ends.0, d), a, m, level - 1, threshold).times(0.5),
        false => a.times(third).plus(half),
    };
    let right = match differs(b) {
        true => refine(sample, (d, ends.1), m, b, level - 1, threshold).times(0.5),
        false => b.times(third).plus(half),
    };
    left.plus(right)
}
