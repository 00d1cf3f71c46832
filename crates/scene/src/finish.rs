//! The finish: how a surface answers light (light spec, sections 3.4 and 4).
use crate::Rgb;

/// `finish { ... }`. `albedo` has already scaled the numbers.
#[derive(Clone, Copy, Debug, PartialEq)]
#[allow(missing_docs)]
pub struct Finish {
    pub ambient: Rgb,
    pub emission: Rgb,
    pub diffuse: f32,
    pub diffuse_back: f32,
    /// `diffuse` before `albedo`, which radiosity and subsurface light use.
    pub diffuse_raw: f32,
    /// The same for the back.
    pub diffuse_back_raw: f32,
    pub brilliance: f32,
    pub crand: f32,
    pub phong: f32,
    pub phong_size: f32,
    pub specular: f32,
    pub roughness: f32,
    /// Metallic tint of highlights, 0 is off.
    pub metallic: f32,
    pub reflection: Reflection,
    pub conserve_energy: bool,
    pub irid: Option<Irid>,
    pub subsurface: Option<Subsurface>,
    /// Old words that the front end carries on to the interior of the objects that have this finish; engines ignore it.
    pub legacy_interior: Option<LegacyInterior>,
}

/// `ior`, `caustics` and `refraction` written in a finish, where they once belonged.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[allow(missing_docs)]
pub struct LegacyInterior {
    pub ior: Option<f32>,
    pub caustics: Option<f32>,
    pub refraction: Option<f32>,
}

/// `reflection { ... }`
#[derive(Clone, Copy, Debug, PartialEq)]
#[allow(missing_docs)]
pub struct Reflection {
    /// Seen straight on.
    pub min: Rgb,
    /// Seen at a grazing angle.
    pub max: Rgb,
    pub fresnel: bool,
    pub falloff: f32,
    pub exponent: f32,
    pub metallic: f32,
}

/// `irid { amount thickness t turbulence k }`
#[derive(Clone, Copy, Debug, PartialEq)]
#[allow(missing_docs)]
pub struct Irid {
    pub amount: f32,
    pub thickness: f32,
    pub turbulence: f32,
}

/// `subsurface { translucency c }`
#[derive(Clone, Copy, Debug, PartialEq)]
#[allow(missing_docs)]
pub struct Subsurface {
    pub translucency: Rgb,
    pub anisotropy: Rgb,
}

impl Default for Finish {
    fn default() -> Self {
        Finish {
            ambient: Rgb::splat(0.1),
            emission: Rgb::ZERO,
            diffuse: 0.6,
            diffuse_back: 0.0,
            diffuse_raw: 0.6,
            diffuse_back_raw: 0.0,
            brilliance: 1.0,
            crand: 0.0,
            phong: 0.0,
            phong_size: 40.0,
            specular: 0.0,
            roughness: 0.05,
            metallic: 0.0,
            reflection: Reflection::default(),
            conserve_energy: false,
            irid: None,
            subsurface: None,
            legacy_interior: None,
        }
    }
}

impl Default for Reflection {
    fn default() -> Self {
        Reflection {
            min: Rgb::ZERO,
            max: Rgb::ZERO,
            fresnel: false,
            falloff: 1.0,
            exponent: 1.0,
            metallic: 0.0,
        }
    }
}
