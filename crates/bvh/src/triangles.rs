//! Meshes of triangles in flat arrays, with a watertight test.
use raggio_math::{Aabb, Ray, Vec3};

use crate::Bvh;

/// Triangles that share a leaf.
const LEAF_SIZE: usize = 4;

/// Where a ray meets a triangle.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct TriangleHit {
    /// The ray's parameter.
    pub t: f64,
    /// Which triangle.
    pub face: u32,
    /// Weight of the second corner.
    pub u: f64,
    /// Weight of the third corner.
    pub v: f64,
}

/// A mesh ready to be hit. Corners are kept in single precision; the test is in double precision, so hits need no
/// refinement.
pub struct Triangles {
    vertices: Vec<[f32; 3]>,
    faces: Vec<[u32; 3]>,
    bvh: Bvh,
    bounds: Aabb,
}

/// A ray turned so that z is its longest axis, then sheared onto it (Woop, Benthin, Wald 2013: an edge gives the same
/// answer for both of its triangles, so no ray slips between them).
struct Sheared {
    origin: Vec3,
    axes: [usize; 3],
    shear: Vec3,
}

impl Sheared {
    #[inline(always)]
    fn new(ray: &Ray) -> Self {
        let d = ray.dir.abs();
        let z = if d.x > d.y && d.x > d.z { 0 } else { 1 + usize::from(d.z >= d.y) };
        let (x, y) = ((z + 1) % 3, (z + 2) % 3);
        let shear = Vec3::new(ray.dir[x], ray.dir[y], 1.0) / ray.dir[z];
        Sheared { origin: ray.origin, axes: [x, y, z], shear }
    }

    /// A corner as the ray sees it.
    #[inline(always)]
    fn place(&self, p: &[f32; 3]) -> Vec3 {
        let q = Vec3::new(f64::from(p[0]), f64::from(p[1]), f64::from(p[2])) - self.origin;
        let [x, y, z] = self.axes;
        Vec3::new(q[x] - self.shear.x * q[z], q[y] - self.shear.y * q[z], q[z] * self.shear.z)
    }

    /// The parameter and the weights of the second and third corner. Edges count.
    #[inline(always)]
    fn hit(&self, corners: [&[f32; 3]; 3], range: (f64, f64)) -> Option<(f64, f64, f64)> {
        let [a, b, c] = corners.map(|p| self.place(p));
        let u = c.x * b.y - c.y * b.x;
        let v = a.x * c.y - a.y * c.x;
        let w = b.x * a.y - b.y * a.x;
        if (u < 0.0 || v < 0.0 || w < 0.0) && (u > 0.0 || v > 0.0 || w > 0.0) {
            return None;
        }
        let sum = u + v + w;
        if sum == 0.0 {
            return None;
        }
        let t = (u * a.z + v * b.z + w * c.z) / sum;
        (t > range.0 && t < range.1).then(|| (t, v / sum, w / sum))
    }
}

impl Triangles {
    /// Builds the search structure. Every index of `faces` must be in range of `vertices`.
    pub fn new(vertices: Vec<[f32; 3]>, faces: Vec<[u32; 3]>) -> Self {
        let point = |i: u32| Vec3::from_array(vertices[i as usize].map(f64::from));
        let boxes: Vec<Aabb> = faces.iter().map(|f| Aabb::around(f.map(point))).collect();
        let bounds = boxes.iter().fold(Aabb::EMPTY, |all, b| all.union(b));
        let bvh = Bvh::build(&boxes, LEAF_SIZE).bvh;
        Triangles { vertices, faces, bvh, bounds }
    }

    /// A box around all triangles.
    pub fn bounds(&self) -> Aabb {
        self.bounds
    }

    /// The corners of a triangle.
    pub fn corners(&self, face: u32) -> [Vec3; 3] {
        self.faces[face as usize].map(|i| Vec3::from_array(self.vertices[i as usize].map(f64::from)))
    }

    /// The nearest hit with `range.0 < t < range.1`.
    pub fn closest(&self, ray: &Ray, range: (f64, f64)) -> Option<TriangleHit> {
        let sheared = Sheared::new(ray);
        let mut best = None;
        self.bvh.closest(ray, range, |face, t_max| {
            let hit = self.hit(&sheared, face, (range.0, t_max))?;
            best = Some(hit);
            Some(hit.t)
        });
        best
    }

    /// Every hit with `range.0 < t < range.1`, in any order.
    pub fn all(&self, ray: &Ray, range: (f64, f64), mut found: impl FnMut(TriangleHit)) {
        let sheared = Sheared::new(ray);
        self.bvh.all(ray, range, |face| {
            if let Some(hit) = self.hit(&sheared, face, range) {
                found(hit);
            }
        });
    }

    #[inline(always)]
    fn hit(&self, ray: &Sheared, face: u32, range: (f64, f64)) -> Option<TriangleHit> {
        let corners = self.faces[face as usize].map(|i| &self.vertices[i as usize]);
        ray.hit(corners, range).map(|(t, u, v)| TriangleHit { t, face, u, v })
    }
}
