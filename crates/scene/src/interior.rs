//! The inside of objects: refraction, fading, media.
use std::sync::Arc;

use crate::{Pigment, Placed, Rgb};

/// `interior { ... }`
#[derive(Clone, Debug)]
#[allow(missing_docs)]
pub struct Interior {
    /// Refractive index; 0 takes the atmosphere's.
    pub ior: f32,
    pub dispersion: f32,
    pub dispersion_samples: u32,
    /// The power of the cosine that brightens shadows through the surface; 0 for none.
    pub caustics: f64,
    pub fade_distance: f32,
    pub fade_power: f32,
    pub fade_color: Rgb,
    /// Old `refraction r` of a finish: multiplies what is transmitted.
    pub old_refraction: f32,
    /// Was it made of nothing but old words of a finish? Then combinations take it over.
    pub from_finish: bool,
    pub media: Vec<Placed<Media>>,
}

impl Default for Interior {
    fn default() -> Self {
        Interior {
            ior: 0.0,
            dispersion: 1.0,
            dispersion_samples: 7,
            caustics: 0.0,
            fade_distance: 0.0,
            fade_power: 0.0,
            fade_color: Rgb::ZERO,
            old_refraction: 1.0,
            from_finish: false,
            media: Vec::new(),
        }
    }
}

/// `media { ... }` (spec on media, section 1).
#[derive(Clone, Debug)]
#[allow(missing_docs)]
pub struct Media {
    pub method: u8,
    pub intervals: u32,
    pub samples: (u32, u32),
    pub confidence: f32,
    pub variance: f32,
    pub ratio: f32,
    pub jitter: f32,
    pub aa_level: u32,
    pub aa_threshold: f32,
    pub absorption: Rgb,
    pub emission: Rgb,
    pub scattering: Option<Scattering>,
    /// Their colours multiply.
    pub densities: Vec<Placed<Density>>,
    /// Do photons collect?
    pub collect: bool,
}

impl Default for Media {
    /// As media begin since version 3.5.
    fn default() -> Self {
        Media {
            method: 3,
            intervals: 1,
            samples: (10, 10),
            confidence: 0.9,
            variance: 1.0 / 128.0,
            ratio: 0.9,
            jitter: 0.0,
            aa_level: 3,
            aa_threshold: 0.1,
            absorption: Rgb::ZERO,
            emission: Rgb::ZERO,
            scattering: None,
            densities: Vec::new(),
            collect: true,
        }
    }
}

/// `density { ... }`: a pigment whose default map is grey.
#[derive(Clone, Debug)]
pub struct Density(pub Arc<Pigment>);

/// `scattering { type, color ... }`
#[derive(Clone, Copy, Debug, PartialEq)]
#[allow(missing_docs)]
pub struct Scattering {
    /// 1 isotropic, 2 Mie haze, 3 Mie murky, 4 Rayleigh, 5 Henyey-Greenstein.
    pub kind: u8,
    pub color: Rgb,
    pub eccentricity: f32,
    pub extinction: f32,
}
