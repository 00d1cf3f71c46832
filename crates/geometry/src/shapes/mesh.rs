//! The mesh of triangles.
use std::sync::Arc;

use raggio_bvh::mesh::{MeshBvh, TriangleHit};
use raggio_math::{Aabb, Ray, Vec2, Vec3};
use raggio_scene::{FaceTexture, Mesh, MeshFace};

use super::beyond;
use crate::texturing::PartUses;
use crate::{LocalHit, Surface};

/// The least distance a mesh reports.
const LEAST: f64 = 1e-6;

/// Normals whose squared differences are within this are one: the triangle is flat.
const SAME_NORMAL: f64 = 1e-10;

/// A mesh ready to be hit. Parts of hits are faces, with the weights of the second and third corner.
pub(crate) struct MeshShape {
    mesh: Arc<Mesh>,
    triangles: MeshBvh,
    /// See [`MeshBvh::parts`].
    parts: Vec<Aabb>,
}

impl From<TriangleHit> for LocalHit {
    fn from(hit: TriangleHit) -> Self {
        LocalHit { t: hit.t, part: hit.face, u: hit.u, v: hit.v }
    }
}

impl MeshShape {
    pub(crate) fn new(mesh: &Arc<Mesh>) -> Self {
        let triangles = MeshBvh::build(&mesh.vertices, &mesh.faces.corners);
        let parts = triangles.parts();
        MeshShape { mesh: mesh.clone(), triangles, parts }
    }

    /// The nearest hit, or any that `stops` says yes to. Not inlined: it makes rays ready in a way that no other shape
    /// needs.
    #[inline(never)]
    pub(crate) fn closest_or(
        &self,
        ray: &Ray,
        range: (f64, f64),
        mut stops: impl FnMut(&LocalHit) -> bool,
    ) -> Option<LocalHit> {
        let hit = self.triangles.nearest(ray, beyond(range, LEAST), |&hit| stops(&hit.into()));
        hit.map(LocalHit::from)
    }

    fn face(&self, hit: &LocalHit) -> MeshFace {
        self.mesh.faces.face(hit.part as usize)
    }

    fn face_normal(&self, hit: &LocalHit) -> Vec3 {
        let [a, b, c] = self.mesh.faces.corners[hit.part as usize]
            .map(|i| Vec3::from_array(self.mesh.vertices[i as usize].map(f64::from)));
        (c - a).cross(b - a).normalize_or(Vec3::X)
    }

    /// The textures of a face: one, or three mixed by the weights of the corners.
    pub(crate) fn part_uses(&self, hit: &LocalHit, out: &mut PartUses) {
        match self.face(hit).texture {
            FaceTexture::Object => {}
            FaceTexture::One(texture) => out.push((texture, 1.0)),
            FaceTexture::Three(textures) => {
                out.extend(textures.into_iter().zip(weights(hit).map(|w| w as f32)));
            }
        }
    }
}

fn weights(hit: &LocalHit) -> [f64; 3] {
    [1.0 - hit.u - hit.v, hit.u, hit.v]
}

impl Surface for MeshShape {
    fn bounds(&self) -> Aabb {
        self.triangles.bounds()
    }

    fn reach(&self, along: Vec3) -> Option<f64> {
        let farthest = |part: &Aabb| (part.min * along).max(part.max * along).element_sum();
        Some(self.parts.iter().map(farthest).fold(f64::NEG_INFINITY, f64::max))
    }

    fn hits(&self, ray: &Ray, range: (f64, f64), out: &mut Vec<LocalHit>) {
        self.triangles.all(ray, beyond(range, LEAST), |hit| out.push(hit.into()));
    }

    #[inline]
    fn closest(&self, ray: &Ray, range: (f64, f64)) -> Option<LocalHit> {
        self.closest_or(ray, range, |_| false)
    }

    /// A ray along the mesh's inside vector leaves it an odd number of times.
    fn inside(&self, p: Vec3) -> bool {
        let Some(dir) = self.mesh.inside_vector else {
            return false;
        };
        if !self.triangles.bounds().contains(p) {
            return false;
        }
        let mut odd = false;
        self.triangles.all(&Ray::new(p, dir), (LEAST, f64::INFINITY), |_| odd = !odd);
        odd
    }

    fn is_solid(&self) -> bool {
        self.mesh.inside_vector.is_some()
    }

    fn normal(&self, _: Vec3, hit: &LocalHit) -> Vec3 {
        let face_normal = self.face_normal(hit);
        let Some(indices) = self.face(hit).normals else {
            return face_normal;
        };
        let n = indices.map(|i| Vec3::from_array(self.mesh.normals[i as usize].map(f64::from)));
        let near = |a: Vec3, b: Vec3| (a - b).length_squared() <= SAME_NORMAL;
        if near(n[0], n[1]) && near(n[0], n[2]) {
            return face_normal;
        }
        let w = weights(hit);
        (n[0] * w[0] + n[1] * w[1] + n[2] * w[2]).normalize_or(face_normal)
    }

    fn uv(&self, _: Vec3, hit: &LocalHit) -> Option<Vec2> {
        let Some(indices) = self.face(hit).uvs else {
            return Some(Vec2::ZERO);
        };
        let uv = indices.map(|i| Vec2::from_array(self.mesh.uvs[i as usize].map(f64::from)));
        let w = weights(hit);
        Some(uv[0] * w[0] + uv[1] * w[1] + uv[2] * w[2])
    }
}
