//! From a place on the picture to a ray: every projection, the camera's normal, depth of field, mesh cameras.
mod focal;
mod mesh;
mod planar;
mod round;
mod wide;

use raggio_geometry::{BuildError, Geometry, InteriorId};
use raggio_math::{Aabb, Ray, Vec3};
use raggio_scene::{self as scene, CameraKind};
use raggio_shading::{Context, Noise, Normal};
use smallvec::SmallVec;

pub use focal::{Lens, LensSample};
pub use mesh::MeshRays;

/// The size of the whole picture in pixels.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Frame {
    /// Columns.
    pub width: f64,
    /// Rows.
    pub height: f64,
}

/// A place on the picture in the terms of the camera formulas (light spec, section 1.2).
#[derive(Clone, Copy, Debug)]
struct Place {
    /// From -0.5 at the left to 0.5 at the right.
    px: f64,
    /// From -0.5 at the bottom to 0.5 at the top.
    py: f64,
}

/// A ray before it is normalised, with the plane coordinates at which a camera normal is asked.
struct RawRay {
    origin: Vec3,
    dir: Vec3,
    plane: (f64, f64),
}

/// The four vectors of a camera, with the lengths of right and up before normalising.
#[derive(Clone, Copy, Debug)]
struct Axes {
    location: Vec3,
    direction: Vec3,
    right: Vec3,
    up: Vec3,
    right_length: f64,
    up_length: f64,
}

/// A camera ready to shoot.
pub struct Camera {
    kind: CameraKind,
    axes: Axes,
    /// Horizontal angle in radians.
    angle: f64,
    normal: Option<Normal>,
    /// Depth of field.
    pub lens: Option<Lens>,
    /// Set for mesh cameras, which shoot rays of their own.
    pub mesh: Option<MeshRays>,
    interiors: Option<SmallVec<[InteriorId; 8]>>,
}

impl Camera {
    /// Makes a camera ready.
    pub fn build(camera: &scene::Camera, noise: Noise, geometry: &Geometry) -> Result<Camera, BuildError> {
        if matches!(camera.kind, CameraKind::UserDefined { .. }) {
            return Err(BuildError::Unsupported("a user_defined camera"));
        }
        let mesh = match &camera.kind {
            CameraKind::Mesh(mesh) => Some(MeshRays::new(mesh, camera)),
            _ => None,
        };
        let blurred = camera.focal_blur.as_ref().filter(|b| b.aperture != 0.0 && b.max_samples > 0);
        let lens = blurred.map(|b| Lens::new(b, camera, noise));
        Ok(Camera {
            kind: camera.kind.clone(),
            axes: Axes::new(camera),
            angle: camera.angle.to_radians(),
            normal: camera.normal.as_ref().map(|n| Normal::compile(n, noise)),
            interiors: match starts(camera, lens.as_ref()) {
                Some(b) => geometry.interiors_within(&b),
                None => Some(geometry.interiors_at(camera.location)),
            },
            lens,
            mesh,
        })
    }

    /// The ray through a place in pixel coordinates (a pixel's centre is an integer), or `None` where the projection
    /// has none. `shift` moves the ray on the lens.
    pub fn ray(&self, x: f64, y: f64, frame: Frame, shift: Option<&LensSample>) -> Option<Ray> {
        let place = Place { px: (x + 0.5) / frame.width - 0.5, py: 0.5 - (y + 0.5) / frame.height };
        let raw = match self.kind {
            CameraKind::Perspective => planar::perspective(&self.axes, place),
            _ => self.raw_ray(place)?,
        };
        let (origin, dir) = match (shift, &self.lens) {
            (Some(sample), Some(lens)) => lens.shifted(sample, self.axes.location, raw.dir),
            _ => (raw.origin, raw.dir),
        };
        let mut dir = dir.try_normalize()?;
        if let Some(normal) = &self.normal {
            let p = Vec3::new(raw.plane.0, raw.plane.1, 0.0);
            let context = Context { normal: Some(dir), ray_dir: dir, ..Context::NONE };
            dir = normal.perturb(dir, p, &context).try_normalize().unwrap_or(dir);
        }
        Some(Ray::new(origin, dir))
    }

    /// The interiors around the starts of all rays; `None` where they differ from ray to ray.
    #[inline]
    pub fn interiors(&self) -> Option<&[InteriorId]> {
        self.interiors.as_deref()
    }

    /// Not inlined: what the usual camera makes stays in registers so.
    #[inline(never)]
    fn raw_ray(&self, place: Place) -> Option<RawRay> {
        let axes = &self.axes;
        match &self.kind {
            CameraKind::Perspective => Some(planar::perspective(axes, place)),
            CameraKind::Orthographic => Some(planar::orthographic(axes, place)),
            CameraKind::Fisheye => round::fisheye(axes, place, self.angle),
            CameraKind::Omnimax => round::omnimax(axes, place),
            CameraKind::UltraWideAngle => Some(wide::ultra_wide_angle(axes, place, self.angle)),
            CameraKind::Panoramic => Some(wide::panoramic(axes, place)),
            CameraKind::Cylinder(kind) => Some(wide::cylinder(axes, place, self.angle, *kind)),
            CameraKind::Spherical { v_angle } => {
                Some(wide::spherical(axes, place, self.angle, v_angle.to_radians()))
            }
            CameraKind::Mesh(_) | CameraKind::UserDefined { .. } => None,
        }
    }
}

/// A box around the starts of all rays of a camera, where they do not all start at the eye.
fn starts(camera: &scene::Camera, lens: Option<&Lens>) -> Option<Aabb> {
    let reach = match camera.kind {
        CameraKind::Orthographic => camera.right.length() + camera.up.length(),
        CameraKind::Cylinder(3 | 4) => return Some(Aabb::INFINITE),
        CameraKind::Perspective => lens?.reach(),
        _ => return None,
    };
    Some(Aabb { min: camera.location, max: camera.location }.grown(reach))
}

impl Axes {
    /// Vectors as the projection wants them: normalised for the angular ones.
    fn new(camera: &scene::Camera) -> Axes {
        let angular = matches!(
            camera.kind,
            CameraKind::Fisheye | CameraKind::UltraWideAngle | CameraKind::Omnimax | CameraKind::Cylinder(_)
        );
        let shape = |v: Vec3| if angular { v.try_normalize().unwrap_or(v) } else { v };
        Axes {
            location: camera.location,
            direction: shape(camera.direction),
            right: shape(camera.right),
            up: shape(camera.up),
            right_length: camera.right.length(),
            up_length: camera.up.length(),
        }
    }
}

#[cfg(test)]
mod tests;
