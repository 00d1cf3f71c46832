//! The triangle test in double precision: hits need no refinement.
use raggio_math::{Ray, Vec3};

use super::{Block, TriangleHit};

/// A ray turned so that z is its longest axis, then sheared onto it (Woop, Benthin, Wald 2013: an edge gives the same
/// answer for both of its triangles, so no ray slips between them).
pub(crate) struct Sheared {
    pub(crate) origin: Vec3,
    /// Axes of the mesh that are now x, y and z.
    pub(crate) axes: [usize; 3],
    /// What x and y lose for each z, and the parameter for each z.
    pub(crate) shear: Vec3,
}

impl Sheared {
    #[inline(always)]
    pub(crate) fn new(ray: &Ray) -> Self {
        let d = ray.dir.abs();
        let z = if d.x > d.y && d.x > d.z { 0 } else { 1 + usize::from(d.z >= d.y) };
        let (x, y) = ((z + 1) % 3, (z + 2) % 3);
        let shear = Vec3::new(ray.dir[x], ray.dir[y], 1.0) / ray.dir[z];
        Sheared { origin: ray.origin, axes: [x, y, z], shear }
    }

    /// A corner as the ray sees it.
    fn place(&self, p: Vec3) -> Vec3 {
        let q = p - self.origin;
        let [x, y, z] = self.axes;
        Vec3::new(
            (-self.shear.x).mul_add(q[z], q[x]),
            (-self.shear.y).mul_add(q[z], q[y]),
            q[z] * self.shear.z,
        )
    }

    /// The parameter and the weights of the second and third corner. Edges count.
    fn hit(&self, corners: [Vec3; 3], range: (f64, f64)) -> Option<(f64, f64, f64)> {
        let [a, b, c] = corners.map(|p| self.place(p));
        let u = c.x * b.y - c.y * b.x;
        let v = a.x * c.y - a.y * c.x;
        let w = b.x * a.y - b.y * a.x;
        let one_sided = u.min(v).min(w) >= 0.0 || u.max(v).max(w) <= 0.0;
        let sum = u + v + w;
        let t = (u * a.z + v * b.z + w * c.z) / sum;
        // A sum of 0 makes t infinite or not a number.
        (one_sided && t > range.0 && t < range.1).then(|| (t, v / sum, w / sum))
    }

    /// Shows `found` the hits with the triangles of a block.
    pub(crate) fn hits<B: Block>(&self, block: &B, range: (f64, f64), mut found: impl FnMut(TriangleHit)) {
        for lane in 0..block.lanes() {
            let corners = [0, 1, 2].map(|k| Vec3::from_array(block.corner(lane, k).map(f64::from)));
            if let Some((t, u, v)) = self.hit(corners, range) {
                found(TriangleHit { t, face: block.triangle(lane), u, v });
            }
        }
    }
}
