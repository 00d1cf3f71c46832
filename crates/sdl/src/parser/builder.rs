//! The scene while it is being read.
use std::sync::Arc;

use raggio_math::Vec3;
use raggio_scene::{Atmosphere, Camera, CameraKind, GammaMode, Object, Rgb, Settings, Version};

/// What statements add to; `parse` makes the [`raggio_scene::Scene`] of it at the end.
#[derive(Debug, Default)]
pub struct SceneBuilder {
    /// Top-level objects, lights among them, in the order of the scene.
    pub objects: Vec<Arc<Object>>,
    /// The last `camera`.
    pub camera: Option<Camera>,
    /// Background, sky, fog and so on.
    pub atmosphere: Atmosphere,
}

/// The settings of a scene that says nothing (language spec, section 4.1).
pub fn default_settings(version: Version) -> Settings {
    Settings {
        version,
        gamma: GammaMode::None,
        adc_bailout: 1.0 / 255.0,
        ambient_light: Rgb::ONE,
        irid_wavelength: Rgb::new(0.70, 0.52, 0.48),
        max_trace_level: 5,
        noise_generator: 2,
        number_of_waves: 10,
        mm_per_unit: 10.0,
        subsurface: None,
        radiosity: None,
        photons: None,
        default_radiosity_importance: 1.0,
    }
}

/// The camera of a scene that has none (language spec, section 4.2).
pub fn default_camera() -> Camera {
    Camera {
        kind: CameraKind::Perspective,
        location: Vec3::ZERO,
        direction: Vec3::Z,
        up: Vec3::Y,
        right: Vec3::X * 1.33,
        angle: 2.0 * (1.33_f64 / 2.0).atan().to_degrees(),
        focal_blur: None,
        normal: None,
    }
}
