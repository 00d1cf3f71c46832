//! Single triangles, flat and smooth, kept in the world's coordinates.
use raggio_math::{Aabb, Affine, Ray, Vec3, transform};

use super::beyond;
use crate::{LocalHit, Surface};

/// The least distance a triangle reports.
const LEAST: f64 = 1e-6;

/// A triangle; `normals` of a smooth one are of unit length. Hits carry the weights of the second and third corner.
pub(crate) struct Triangle {
    points: [Vec3; 3],
    normals: Option<Box<[Vec3; 3]>>,
    /// Zero where the triangle is never hit.
    face_normal: Vec3,
}

impl Triangle {
    /// A triangle carried by a transform. One that has not been moved keeps the normal of its corners' order; one that
    /// has takes the normal of the order that the language brings them into: seen along the longest axis of the normal
    /// they turn one way for x and z, the other for y. Degenerate ones, and smooth ones whose normals do not all point
    /// to the same side, are never hit.
    pub(crate) fn new(points: [Vec3; 3], normals: Option<[Vec3; 3]>, world_from_object: &Affine) -> Self {
        let (mut points, mut normals) = (points, normals);
        if *world_from_object != Affine::IDENTITY {
            let n = cross(&points);
            let size = n.abs();
            let negative = match (size.x >= size.y && size.x >= size.z, size.y >= size.z) {
                (true, _) => n.x <= 0.0,
                (_, true) => n.y >= 0.0,
                _ => n.z <= 0.0,
            };
            if !negative {
                points.swap(0, 1);
                normals.iter_mut().for_each(|n| n.swap(0, 1));
            }
            points = points.map(|p| world_from_object.transform_point3(p));
            let back = world_from_object.inverse();
            normals =
                normals.map(|ns| ns.map(|n| transform::normal_by_inverse(&back, n).normalize_or_zero()));
        }
        let mut face_normal = cross(&points).normalize_or_zero();
        if let Some(ns) = &normals {
            let sides = ns.map(|n| n.dot(face_normal));
            if !(sides.iter().all(|&s| s > 0.0) || sides.iter().all(|&s| s < 0.0)) {
                face_normal = Vec3::ZERO;
            }
        }
        Triangle { points, normals: normals.map(Box::new), face_normal }
    }
}

fn cross(points: &[Vec3; 3]) -> Vec3 {
    (points[0] - points[1]).cross(points[2] - points[1])
}

/// Where a line meets a triangle: the parameter, and the weights of the second and third corner. The sign of the
/// volume over each edge decides, so that two triangles with a common edge leave no gap; edges count.
#[inline]
pub(crate) fn meet(points: &[Vec3; 3], face_normal: Vec3, ray: &Ray) -> Option<(f64, f64, f64)> {
    // One by one: `map` over an array of vectors goes through memory.
    let (a, b, c) = (points[0] - ray.origin, points[1] - ray.origin, points[2] - ray.origin);
    let u = ray.dir.dot(c.cross(b));
    let v = ray.dir.dot(a.cross(c));
    let w = ray.dir.dot(b.cross(a));
    if (u < 0.0 || v < 0.0 || w < 0.0) && (u > 0.0 || v > 0.0 || w > 0.0) {
        return None;
    }
    let (sum, slope) = (u + v + w, face_normal.dot(ray.dir));
    if sum == 0.0 || slope == 0.0 {
        return None;
    }
    Some((face_normal.dot(a) / slope, v / sum, w / sum))
}

impl Surface for Triangle {
    fn bounds(&self) -> Aabb {
        match self.face_normal == Vec3::ZERO {
            true => Aabb::EMPTY,
            false => Aabb::around(self.points),
        }
    }

    fn hits(&self, ray: &Ray, range: (f64, f64), out: &mut Vec<LocalHit>) {
        out.extend(self.closest(ray, range));
    }

    #[inline]
    fn closest(&self, ray: &Ray, range: (f64, f64)) -> Option<LocalHit> {
        let (lo, hi) = beyond(range, LEAST);
        let (t, u, v) = meet(&self.points, self.face_normal, ray)?;
        (t > lo && t < hi).then_some(LocalHit { t, part: 0, u, v })
    }

    fn inside(&self, _: Vec3) -> bool {
        false
    }

    fn is_solid(&self) -> bool {
        false
    }

    fn normal(&self, _: Vec3, hit: &LocalHit) -> Vec3 {
        match &self.normals {
            Some(n) => {
                let blend = n[0] * (1.0 - hit.u - hit.v) + n[1] * hit.u + n[2] * hit.v;
                blend.normalize_or(self.face_normal)
            }
            None => self.face_normal,
        }
    }
}
