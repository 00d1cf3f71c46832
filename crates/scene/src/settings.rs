//! Global settings and the version rules that outlive parsing.
use crate::{Curve, Rgb};

/// The language versions in force at the end of the scene, in hundredths (370 is 3.7).
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Version {
    /// The version that syntax and noise defaults follow.
    pub language: u16,
    /// The version that gamma, alpha and layering follow: `language` if a `#version` was executed, else 362.
    pub effective: u16,
}

/// How colours of the scene relate to linear light (language spec, section 5.1).
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum GammaMode {
    /// No gamma handling at all: values go to the file as they are.
    None,
    /// Working space given by its curve; linear for `assumed_gamma 1.0`.
    Working(Curve),
}

/// `global_settings { ... }`
#[derive(Clone, Debug)]
pub struct Settings {
    /// The language versions at the end of the scene.
    pub version: Version,
    /// Working space.
    pub gamma: GammaMode,
    /// Rays with less weight than this are not traced.
    pub adc_bailout: f32,
    /// Multiplies every finish's ambient.
    pub ambient_light: Rgb,
    /// Wavelengths of red, green and blue for `irid`.
    pub irid_wavelength: Rgb,
    /// Most rays in a row, the camera's included; 1..=256.
    pub max_trace_level: u16,
    /// Noise generator of patterns that name none: 1, 2 or 3.
    pub noise_generator: u8,
    /// Sources of `ripples` and `waves`.
    pub number_of_waves: u32,
    /// Millimetres per unit, for subsurface light.
    pub mm_per_unit: f32,
    /// Subsurface light transport; `None` switches it off.
    pub subsurface: Option<SubsurfaceSettings>,
    /// Radiosity; `None` switches it off.
    pub radiosity: Option<RadiositySettings>,
    /// Photons; `None` switches them off.
    pub photons: Option<Photons>,
    /// `radiosity { importance }` of objects that give none.
    pub default_radiosity_importance: f32,
}

/// `subsurface { ... }` in the global settings.
#[derive(Clone, Copy, Debug)]
pub struct SubsurfaceSettings {
    /// Samples of multiple scattering.
    pub diffuse_samples: u32,
    /// Samples of single scattering.
    pub single_samples: u32,
    /// Does radiosity light enter as well?
    pub radiosity: bool,
}

/// `radiosity { ... }` in the global settings. Meanings: manual 3.7, section 3.4.3.4.
#[derive(Clone, Copy, Debug)]
#[allow(missing_docs)]
pub struct RadiositySettings {
    pub adc_bailout: f32,
    pub always_sample: bool,
    pub brightness: f32,
    pub count: u32,
    pub count_pool: u32,
    pub error_bound: f32,
    pub gray_threshold: f32,
    pub low_error_factor: f32,
    pub max_sample: f32,
    pub maximum_reuse: f32,
    pub minimum_reuse: f32,
    pub media: bool,
    pub nearest_count: u32,
    pub nearest_count_adaptive: u32,
    pub normal: bool,
    pub pretrace_start: f32,
    pub pretrace_end: f32,
    pub recursion_limit: u32,
    pub subsurface: bool,
}

impl Default for RadiositySettings {
    fn default() -> Self {
        RadiositySettings {
            adc_bailout: 0.01,
            always_sample: false,
            brightness: 1.0,
            count: 35,
            count_pool: 1600,
            error_bound: 1.8,
            gray_threshold: 0.0,
            low_error_factor: 0.5,
            max_sample: -1.0,
            maximum_reuse: 0.2,
            minimum_reuse: 0.015,
            media: false,
            nearest_count: 5,
            nearest_count_adaptive: 0,
            normal: false,
            pretrace_start: 0.08,
            pretrace_end: 0.04,
            recursion_limit: 2,
            subsurface: false,
        }
    }
}

/// `photons { ... }` in the global settings. Meanings: manual 3.7, section 3.4.3.3 and the spec, section 2.
#[derive(Clone, Debug)]
#[allow(missing_docs)]
pub struct Photons {
    pub spacing: f32,
    pub count: u32,
    pub gather_min: u32,
    pub gather_max: u32,
    pub jitter: f32,
    pub max_trace_level: Option<u16>,
    pub adc_bailout: Option<f32>,
    pub autostop: f32,
    pub expand_increase: f32,
    pub expand_min: u32,
    /// `radius r1, m1, r2, m2`: surface radius and multiplier, media radius and multiplier; radius <= 0: automatic.
    pub radius: [f32; 4],
    pub media_max_steps: u32,
    pub media_factor: f32,
    pub save_file: Option<String>,
    pub load_file: Option<String>,
}

impl Default for Photons {
    fn default() -> Self {
        Photons {
            spacing: 1.0,
            count: 0,
            gather_min: 20,
            gather_max: 100,
            jitter: 0.4,
            max_trace_level: None,
            adc_bailout: None,
            autostop: 0.5,
            expand_increase: 0.2,
            expand_min: 35,
            radius: [-1.0, 1.0, -1.0, 1.0],
            media_max_steps: 0,
            media_factor: 1.0,
            save_file: None,
            load_file: None,
        }
    }
}
