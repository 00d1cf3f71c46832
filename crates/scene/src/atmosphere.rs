//! What fills empty space: background, sky, fog, rainbows, media.
use std::sync::Arc;

use raggio_math::Vec3;

use crate::{Color, Media, Pigment, Placed, Rgb};

/// Everything outside objects.
#[derive(Clone, Debug)]
pub struct Atmosphere {
    /// `background`; `None` is black, and transparent in pictures with alpha.
    pub background: Option<Background>,
    /// The last `sky_sphere`.
    pub sky_sphere: Option<SkySphere>,
    /// All `fog` statements.
    pub fogs: Vec<Fog>,
    /// All `rainbow` statements.
    pub rainbows: Vec<Rainbow>,
    /// Top-level `media`.
    pub media: Vec<Placed<Media>>,
    /// Refractive index of empty space.
    pub ior: f32,
    /// Its dispersion.
    pub dispersion: f32,
}

impl Default for Atmosphere {
    fn default() -> Self {
        Atmosphere {
            background: None,
            sky_sphere: None,
            fogs: Vec::new(),
            rainbows: Vec::new(),
            media: Vec::new(),
            ior: 1.0,
            dispersion: 1.0,
        }
    }
}

/// `background { ... }`
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Background {
    /// Its colour.
    pub color: Color,
}

/// `sky_sphere { ... }`; the last pigment lies on top.
#[derive(Clone, Debug)]
pub struct SkySphere {
    /// Pigments with the sky's own transform.
    pub pigments: Vec<Placed<Pigment>>,
    /// Multiplies the colour.
    pub emission: Rgb,
}

/// `fog { ... }`
#[derive(Clone, Debug)]
#[allow(missing_docs)]
pub struct Fog {
    pub kind: FogKind,
    pub color: Color,
    pub distance: f64,
    /// Turbulence vector, octaves, omega and lambda; `None` without `turbulence`.
    pub turbulence: Option<crate::Turbulence>,
    pub turb_depth: f64,
}

/// How fog is spread.
#[derive(Clone, Copy, Debug, PartialEq)]
#[allow(missing_docs)]
pub enum FogKind {
    Constant,
    Ground { offset: f64, alt: f64, up: Vec3 },
}

/// `rainbow { ... }`; angles in degrees, as written.
#[derive(Clone, Debug)]
#[allow(missing_docs)]
pub struct Rainbow {
    pub direction: Vec3,
    pub up: Vec3,
    pub angle: f64,
    pub width: f64,
    pub distance: f64,
    pub jitter: f64,
    pub arc_angle: Option<f64>,
    pub falloff_angle: Option<f64>,
    pub pigment: Arc<Pigment>,
}
