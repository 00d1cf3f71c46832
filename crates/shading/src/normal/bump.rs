//! `bump_map`: an image as heights (textures spec, section 7.3).
use raggio_math::{EPS, Vec3};

use crate::image::Image;

/// The normal bent by the image's slope where the point lies on it.
pub(super) fn bend(image: &Image, size: f64, n: Vec3, p: Vec3) -> Vec3 {
    let Some([here, left, right]) = image.heights(p, size) else { return n };
    let slope = Vec3::new(left - right, 2.0, 2.0 * here - left - right).normalize_or(Vec3::Y);
    let across = n.cross(Vec3::Y);
    let (x, y) = if across.length() < EPS {
        (Vec3::X, Vec3::new(0.0, 1.0_f64.copysign(n.y), 0.0))
    } else {
        (across.normalize(), n)
    };
    let z = x.cross(y).normalize_or(Vec3::Z);
    slope.x * x + slope.y * y - slope.z * z
}
