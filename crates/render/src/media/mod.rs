//! Participating media: what the way through glowing, dimming and scattering stuff adds and takes (media spec,
//! section 1).
mod flight;
mod integrate;
mod lit;
mod phase;
mod reach;

use raggio_geometry::InteriorId;
use raggio_image::{Rgb, grey};
use raggio_math::{Affine, Ray, Vec3};
use raggio_scene::{self as scene, PigmentKind, Placed, Scattering};
use raggio_shading::{Context, Noise, Pigment};
use smallvec::SmallVec;

use crate::integrator::{Beam, Seen, Tracer};
use crate::sampling::chi_square_quantile;
pub use flight::Steps;
use integrate::{Along, intervals};
use lit::{Range, pieces, ranges};
use reach::Shell;

/// The media of one interior or of empty space, compiled.
#[derive(Default)]
pub struct MediaList {
    media: Vec<Medium>,
}

/// A compiled medium.
pub struct Medium {
    emission: Rgb,
    /// What dims light: absorption and what is scattered away.
    extinction: Rgb,
    scattering: Option<Scattering>,
    /// Each with the way from the world into its own coordinates, unless they are the world's.
    densities: Vec<(Pigment, Option<Affine>)>,
    /// Outside of any of them the density is nothing.
    shells: Vec<Shell>,
    /// The density, where it is the same everywhere.
    even: Option<Rgb>,
    /// Do photons count in it?
    collect: bool,
    sampling: Sampling,
}

/// For how many samples stopping is worked out; more of them stop as these do.
const THRESHOLDS: u32 = 1000;

/// How a medium wants to be sampled.
struct Sampling {
    method: u8,
    intervals: u32,
    min: u32,
    max: u32,
    jitter: f64,
    /// By number of samples taken: the variance under which to stop.
    thresholds: Vec<f64>,
    ratio: f64,
    aa_level: u32,
    aa_threshold: f32,
}

/// The media along a ray, those of all its interiors joined.
type Joined<'a> = SmallVec<[&'a Medium; 4]>;

impl MediaList {
    /// Compiles media that were written in the coordinates given.
    pub fn new(media: &[Placed<scene::Media>], world_from_parent: &Affine, noise: Noise) -> MediaList {
        let compile = |m: &Placed<scene::Media>| {
            Medium::new(&m.item, &(*world_from_parent * m.parent_from_item()), noise)
        };
        MediaList { media: media.iter().map(compile).collect() }
    }

    /// Is there nothing?
    pub fn is_empty(&self) -> bool {
        self.media.is_empty()
    }

    /// Do samples lie at random in any of it?
    pub fn is_random(&self) -> bool {
        self.media.iter().any(|m| m.sampling.method != 3 || m.sampling.jitter != 0.0)
    }
}

impl Medium {
    fn new(media: &scene::Media, world_from_media: &Affine, noise: Noise) -> Medium {
        // Where a density is nothing, those after it are not asked: the cheap ones go first.
        let mut written: Vec<_> = media.densities.iter().collect();
        written.sort_by_key(|density| effort(&density.item.0));
        let mut shells = Vec::new();
        let densities: Vec<_> = written
            .into_iter()
            .map(|density| {
                let world_from_density = *world_from_media * density.parent_from_item();
                let density_from_world = world_from_density.inverse();
                shells.extend(Shell::of(&density.item.0, &density_from_world));
                let moved = density_from_world != Affine::IDENTITY;
                (Pigment::compile(&density.item.0, noise), moved.then_some(density_from_world))
            })
            .collect();
        let scattered = media.scattering.map_or(Rgb::ZERO, |s| s.color * s.extinction);
        let even = densities.iter().map(|(pigment, _)| Some(pigment.even_color()?.rgb)).product();
        Medium {
            emission: media.emission,
            extinction: media.absorption + scattered,
            scattering: media.scattering,
            shells,
            even,
            densities,
            collect: media.collect,
            sampling: Sampling::new(media),
        }
    }

    /// Does it dim or scatter light?
    fn matters(&self) -> bool {
        self.scattering.is_some() || self.extinction != Rgb::ZERO
    }

    /// The density at a point of the world.
    #[inline]
    fn density(&self, p: Vec3, context: &Context) -> Rgb {
        if let Some(density) = self.even {
            return density;
        }
        let mut product = Rgb::ONE;
        for (pigment, density_from_world) in &self.densities {
            let p = density_from_world.map_or(p, |way| way.transform_point3(p));
            product *= pigment.rgb(p, context);
            if product == Rgb::ZERO {
                break;
            }
        }
        product
    }
}

impl Sampling {
    fn new(media: &scene::Media) -> Sampling {
        let (min, max) = (media.samples.0.max(1), media.samples.1);
        let quantile = |n: u32| chi_square_quantile(f64::from(media.confidence), f64::from(n));
        let last = if max > 1 { quantile(max - 1) } else { 0.0 };
        let scale = if last > 0.0 && last.is_finite() { 1.0 / last } else { 1e-10 };
        let threshold = |n: u32| match quantile(n) {
            q if q.is_finite() => f64::from(media.variance) * q * scale,
            _ => 0.0,
        };
        let adaptive = media.method != 3 && max > min;
        Sampling {
            method: media.method,
            intervals: media.intervals.max(1),
            min,
            max,
            jitter: f64::from(media.jitter),
            thresholds: if adaptive {
                (0..=max.min(THRESHOLDS)).map(threshold).collect()
            } else {
                Vec::new()
            },
            ratio: f64::from(media.ratio),
            aa_level: media.aa_level,
            aa_threshold: media.aa_threshold,
        }
    }

    /// How many steps method 3 takes through an interval.
    fn steps(&self) -> u32 {
        (self.min / 2 + 1).max(2)
    }
}

/// About how long a pigment takes: 0 for a simple formula, 1 for much noise, crackle and the like.
fn effort(pigment: &scene::Pigment) -> u8 {
    use scene::{PatternKind, Warp};
    let turbulent = |warp: &Warp| matches!(warp, Warp::Turbulence(_) | Warp::ClassicTurbulence(_));
    let of = |pattern: &scene::Pattern| {
        let simple = matches!(
            pattern.kind,
            PatternKind::Boxed
                | PatternKind::Cylindrical
                | PatternKind::Gradient(_)
                | PatternKind::Planar
                | PatternKind::Spherical
        );
        u8::from(!simple || pattern.warps.iter().any(turbulent))
    };
    match &pigment.kind {
        PigmentKind::Solid { .. } => 0,
        PigmentKind::ColorMap { pattern, .. } => of(pattern),
        _ => 1,
    }
}

/// The medium that decides how to sample: the first with the most intervals.
fn leader<'a>(media: &Joined<'a>) -> Option<&'a Medium> {
    let most = media.iter().map(|m| m.sampling.intervals).max()?;
    media.iter().find(|m| m.sampling.intervals == most).copied()
}

impl Tracer<'_> {
    /// Lays the media of all interiors of a ray over what was seen at `depth`.
    pub fn contained_media(&mut self, beam: &Beam<'_>, depth: f64, lights: &[u32], seen: &mut Seen) {
        let world = self.world;
        if !world.all_hollow(beam.interiors) {
            return;
        }
        let lists: SmallVec<[&MediaList; 8]> =
            beam.interiors.iter().map(|&id| &world.interior(id).media).collect();
        self.media_along(&lists, beam, depth, lights, seen);
    }

    /// Lays media over what was seen at `depth`. `lights` are those that shine on what ends the way.
    pub fn media_along(
        &mut self,
        lists: &[&MediaList],
        beam: &Beam<'_>,
        depth: f64,
        lights: &[u32],
        seen: &mut Seen,
    ) {
        let media: Joined<'_> = lists.iter().flat_map(|list| &list.media).collect();
        let Some(leader) = leader(&media) else { return };
        let lights = ranges(self.world, beam.ray, depth, lights);
        let intervals = intervals(&pieces(&lights, depth), leader);
        let along = Along::new(media, leader, *beam.ray, depth, beam.interiors).lit_by(lights);
        let (glow, depth) = self.integrate(&along, intervals);
        let left = exp(-depth);
        *seen = Seen::new(seen.rgb() * left + glow, seen.transmit() * grey(left));
    }

    /// What the media of a shadow ray's interiors leave of light over a segment.
    pub fn media_filter(&mut self, interiors: &[InteriorId], ray: &Ray, depth: f64) -> Rgb {
        let world = self.world;
        if !world.all_hollow(interiors) {
            return Rgb::ONE;
        }
        let lists: SmallVec<[&MediaList; 8]> =
            interiors.iter().map(|&id| &world.interior(id).media).collect();
        self.dimmed_by(&lists, ray, depth)
    }

    /// What media leave of light over a segment.
    pub fn dimmed_by(&mut self, lists: &[&MediaList], ray: &Ray, depth: f64) -> Rgb {
        let all = || lists.iter().flat_map(|list| &list.media);
        let even: Option<Rgb> = all().map(|m| Some(m.even? * m.extinction)).sum();
        if let Some(sum) = even {
            return exp(-sum * depth as f32);
        }
        let media: Joined<'_> = all().collect();
        let Some(leader) = leader(&media) else { return Rgb::ONE };
        if media.iter().all(|m| m.extinction == Rgb::ZERO) {
            return Rgb::ONE;
        }
        let whole: Range = (0.0, depth);
        let along = Along::new(media, leader, *ray, depth, &[]);
        let intervals = intervals(&[(whole, false)], leader);
        exp(-self.optical_depth(&along, intervals))
    }
}

/// Of each part; what is clear stays clear at no cost, and grey takes one look.
#[inline]
fn exp(v: Rgb) -> Rgb {
    if v == Rgb::ZERO {
        return Rgb::ONE;
    }
    if v.x == v.y && v.y == v.z {
        return Rgb::splat(v.x.exp());
    }
    Rgb::new(v.x.exp(), v.y.exp(), v.z.exp())
}
