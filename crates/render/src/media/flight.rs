//! Photons on their way through media: where they are stored and what is left of them (photon spec, section 2.6).
use raggio_image::Rgb;

use super::integrate::{Along, intervals};
use super::lit::{pieces, ranges};
use super::{Joined, MediaList, exp, leader};
use crate::integrator::{Beam, Tracer};

/// How photons are stored in media.
pub struct Steps {
    /// The distance from one to the next.
    pub spacing: f64,
    /// The most of them in an interval.
    pub most: u32,
    /// How far they are moved at random, in parts of the distance.
    pub jitter: f64,
}

impl Tracer<'_> {
    /// What is left of a photon's power after a segment. `store` is told the distance, the power, and how much longer
    /// than wanted the steps are, for every photon that stays.
    pub fn media_photons(
        &mut self,
        beam: &Beam<'_>,
        depth: f64,
        lights: &[u32],
        steps: &Steps,
        mut power: Rgb,
        store: &mut dyn FnMut(f64, Rgb, f64),
    ) -> Rgb {
        let world = self.world;
        if !world.all_hollow(beam.interiors) {
            return power;
        }
        let lists: Vec<&MediaList> = beam.interiors.iter().map(|&id| &world.interior(id).media).collect();
        let media: Joined<'_> = lists.iter().flat_map(|list| &list.media).collect();
        let Some(leader) = leader(&media).filter(|_| media.iter().any(|m| m.matters())) else {
            return power;
        };
        let stored = media.iter().any(|m| m.scattering.is_some()) && media.iter().any(|m| m.collect);
        let intervals = intervals(&pieces(&ranges(world, beam.ray, depth, lights), depth), leader);
        let along = Along::new(media, leader, *beam.ray, depth, beam.interiors);
        for interval in &intervals {
            let wanted = (interval.length / steps.spacing).floor();
            let count = wanted.clamp(0.0, f64::from(steps.most));
            let stretch = if wanted > count { interval.length / (steps.spacing * count) } else { 1.0 };
            let mut thickness = Rgb::ZERO;
            for j in 0..count as u32 {
                let moved = (self.streams.numbers().media.next() - 0.5) * steps.jitter;
                let t = interval.start + (f64::from(j) + 0.5 + moved) / count * interval.length;
                if stored {
                    store(t, power, stretch);
                }
                thickness += self.medium_at(&along, t, false).dim * interval.length as f32;
            }
            if count > 0.0 {
                power *= exp(-thickness / count as f32);
            }
        }
        power
    }
}
