//! Footprints: what one of the camera's pixels covers of a surface, for images that are `smooth`. A cone stands for the
//! pixel; mirrors and lenses let it grow on with the way, as if they were flat.
use raggio_math::{Ray, Vec3};
use raggio_shading::FOOTPRINT_STEP;

use super::surface::SurfacePoint;
use super::{NormalPath, Tracer};

/// How wide a pixel is: where its ray begins, and how much wider after a way of 1.
#[derive(Clone, Copy, Debug, Default)]
pub struct PixelCone {
    start: f64,
    growth: f64,
}

/// Seen at a flatter angle than this a surface is covered no farther.
const LEAST_COSINE: f64 = 1e-3;

impl PixelCone {
    /// From the rays of two neighbouring pixels.
    pub fn between(a: &Ray, b: &Ray) -> PixelCone {
        PixelCone { start: a.origin.distance(b.origin), growth: a.dir.distance(b.dir) }
    }
}

impl Tracer<'_> {
    /// In a layer's space, whose point is `p`: the point, and those a step along the footprint's axes. `None` where the
    /// layer is asked by texture coordinates, and for rays that come from no camera.
    #[inline(never)]
    pub(super) fn footprint(
        &self,
        point: &SurfacePoint<'_>,
        path: &NormalPath<'_>,
        p: Vec3,
    ) -> Option<[Vec3; 3]> {
        let width = self.pixel.start + self.pixel.growth * self.way;
        let here = point.surface.p;
        if width <= 0.0 || path.point(here) != p {
            return None;
        }
        let view = point.beam.ray.dir;
        let across = point.n.cross(view).try_normalize().unwrap_or_else(|| point.n.any_orthonormal_vector());
        let along = across.cross(point.n) / point.n.dot(view).abs().max(LEAST_COSINE);
        let step = width * FOOTPRINT_STEP;
        Some([p, path.point(here + across * step), path.point(here + along * step)])
    }
}
