//! The ordered list of interiors around a ray, and what crossing a surface does to it (light spec, section 3.3).
use raggio_geometry::InteriorId;

use super::Interiors;
use crate::world::World;

/// What crossing a surface means for the ray.
#[derive(Clone, Debug)]
pub(super) struct Crossing {
    /// The list behind the surface.
    pub interiors: Interiors,
    /// Relative refractive index.
    pub eta: f64,
    /// Relative dispersion.
    pub dispersion: f64,
    /// Samples of the dispersion.
    pub samples: u32,
}

/// The list after a straight crossing: the interior leaves it or enters it.
pub fn toggle(list: &mut Interiors, id: InteriorId) {
    match list.iter().position(|&other| other == id) {
        Some(i) => {
            list.remove(i);
        }
        None => list.push(id),
    }
}

impl World {
    /// Crosses a surface of an object with interior `id`.
    pub(super) fn cross(&self, list: &[InteriorId], id: InteriorId) -> Crossing {
        let this = self.interior(id);
        let air = (self.rules.air_ior, self.rules.air_dispersion, 0);
        let of = |id: InteriorId| {
            let i = self.interior(id);
            (i.ior, i.dispersion, i.interior.dispersion_samples)
        };
        let own = (this.ior, this.dispersion, this.interior.dispersion_samples);
        let mut interiors = Interiors::from_slice(list);
        toggle(&mut interiors, id);
        let (from, to) = match (list.last(), list.contains(&id)) {
            (None, _) => (air, own),
            (Some(&last), true) if last == id => (own, interiors.last().map_or(air, |&id| of(id))),
            // Left while something else that was entered later is still around: nothing bends.
            (Some(_), true) => ((1.0, 1.0, 0), (1.0, 1.0, 0)),
            (Some(&last), false) => (of(last), own),
        };
        Crossing { interiors, eta: from.0 / to.0, dispersion: from.1 / to.1, samples: from.2.max(to.2) }
    }

    /// The relative index that Fresnel's formula wants: of what lies behind the surface over what lies before it.
    pub(crate) fn fresnel_index(&self, list: &[InteriorId], id: InteriorId) -> f64 {
        let ior = self.interior(id).ior;
        let last = list.last().map(|&id| self.interior(id).ior);
        match (last, list.contains(&id)) {
            (last, false) => ior / last.unwrap_or(self.rules.air_ior),
            (_, true) if list.len() == 1 => self.rules.air_ior / ior,
            (last, true) => last.unwrap_or(ior) / ior,
        }
    }
}
