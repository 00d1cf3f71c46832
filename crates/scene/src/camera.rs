//! Cameras, after all of their statements have been applied (light spec, section 1).
use std::sync::Arc;

use raggio_math::Vec3;

use crate::{Mesh, Normal, Pigment, Placed};

/// The view. Vectors are final: `look_at`, `angle` and transforms are already in them.
#[derive(Clone, Debug)]
pub struct Camera {
    /// Which projection.
    pub kind: CameraKind,
    /// The eye.
    pub location: Vec3,
    /// Forward; its length matters.
    pub direction: Vec3,
    /// Up; its length matters.
    pub up: Vec3,
    /// Right; its length matters, and its sense gives handedness.
    pub right: Vec3,
    /// Horizontal angle in degrees, for the kinds that keep it.
    pub angle: f64,
    /// Depth of field.
    pub focal_blur: Option<FocalBlur>,
    /// Perturbs the rays.
    pub normal: Option<Arc<Normal>>,
}

/// Projections.
#[derive(Clone, Debug)]
#[allow(missing_docs)]
pub enum CameraKind {
    Perspective,
    Orthographic,
    Fisheye,
    UltraWideAngle,
    Omnimax,
    Panoramic,
    /// 1..=4
    Cylinder(u8),
    /// With the vertical angle in degrees.
    Spherical {
        v_angle: f64,
    },
    Mesh(Arc<MeshCamera>),
    /// `user_defined` of 3.8: location and direction as functions of the picture's coordinates.
    UserDefined {
        location: [Option<Arc<crate::Function>>; 3],
        direction: [Option<Arc<crate::Function>>; 3],
    },
}

/// Depth of field (light spec, section 1.3).
#[derive(Clone, Debug)]
pub struct FocalBlur {
    /// Diameter of the lens, twice over.
    pub aperture: f64,
    /// Fewest samples.
    pub min_samples: u32,
    /// Most samples.
    pub max_samples: u32,
    /// Confidence of the stopping test.
    pub confidence: f64,
    /// Variance of the stopping test.
    pub variance: f64,
    /// Distance from the eye to the plane in focus.
    pub focal_distance: f64,
    /// Shape of the lens.
    pub bokeh: Option<Arc<Pigment>>,
}

/// A camera whose rays start on the faces of meshes.
#[derive(Clone, Debug)]
#[allow(missing_docs)]
pub struct MeshCamera {
    pub rays_per_pixel: u32,
    pub method: u8,
    pub max_distance: f64,
    pub meshes: Vec<Placed<Mesh>>,
    pub smooth: bool,
}
