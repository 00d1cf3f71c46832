//! Light sources.
use std::sync::Arc;

use raggio_math::{Affine, Vec3};

use crate::{Object, PhotonFlags, Rgb};

/// `light_source { ... }`
#[derive(Clone, Debug)]
pub struct Light {
    /// Where it stands.
    pub location: Vec3,
    /// Its colour; may be over 1 or under 0.
    pub color: Rgb,
    /// How it spreads.
    pub kind: LightKind,
    /// Where it points; used by all kinds but plain point lights.
    pub point_at: Vec3,
    /// `parallel` (cylinder lights always are).
    pub parallel: bool,
    /// `fade_distance`; 0 means none.
    pub fade_distance: f64,
    /// `fade_power`; 0 means none.
    pub fade_power: f64,
    /// Soft shadows.
    pub area: Option<AreaLight>,
    /// Does scattering media see it?
    pub media_interaction: bool,
    /// Do fog and atmospheric media dim it?
    pub media_attenuation: bool,
    /// The object that shows where it is; already moved to the light and casting no shadow.
    pub looks_like: Option<Arc<Object>>,
    /// Light only passes through this object.
    pub projected_through: Option<Arc<Object>>,
    /// Photon switches.
    pub photons: PhotonFlags,
}

/// How a light spreads.
#[derive(Clone, Copy, Debug, PartialEq)]
#[allow(missing_docs)]
pub enum LightKind {
    Point,
    /// `shadowless`: no shadows, no highlights.
    Shadowless,
    /// Angles of the half cones in degrees.
    Spot {
        radius: f64,
        falloff: f64,
        tightness: f64,
    },
    /// Radii in scene units.
    Cylinder {
        radius: f64,
        falloff: f64,
        tightness: f64,
    },
}

/// `area_light <axis1>, <axis2>, size1, size2`
#[derive(Clone, Copy, Debug, PartialEq)]
#[allow(missing_docs)]
pub struct AreaLight {
    pub axis1: Vec3,
    pub axis2: Vec3,
    pub size1: u32,
    pub size2: u32,
    /// `None` takes every sample.
    pub adaptive: Option<u32>,
    pub jitter: bool,
    pub circular: bool,
    pub orient: bool,
    pub area_illumination: bool,
    /// `photons { area_light }`
    pub photons_area: bool,
}

impl Light {
    /// A point light without anything special.
    pub fn new(location: Vec3, color: Rgb) -> Self {
        Light {
            location,
            color,
            kind: LightKind::Point,
            point_at: Vec3::Z,
            parallel: false,
            fade_distance: 0.0,
            fade_power: 0.0,
            area: None,
            media_interaction: true,
            media_attenuation: false,
            looks_like: None,
            projected_through: None,
            photons: PhotonFlags::default(),
        }
    }

    /// Moves the light and what belongs to it.
    pub fn transform(&mut self, t: &Affine) {
        self.location = t.transform_point3(self.location);
        self.point_at = t.transform_point3(self.point_at);
        if let Some(area) = &mut self.area {
            area.axis1 = t.transform_vector3(area.axis1);
            area.axis2 = t.transform_vector3(area.axis2);
        }
        for object in [&mut self.looks_like, &mut self.projected_through].into_iter().flatten() {
            Arc::make_mut(object).transform(t);
        }
    }
}
