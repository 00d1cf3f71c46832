//! The mesh camera: rays that leave from the faces of meshes (light spec, section 1.2).
use raggio_math::{Affine, EPS, Ray, Vec2, Vec3};
use raggio_scene::{self as scene, Mesh, MeshFace, Placed};
use std::sync::Arc;

use super::Frame;

/// A mesh camera ready to shoot.
pub struct MeshRays {
    meshes: Vec<Placed<Mesh>>,
    /// Faces of all meshes together.
    total_faces: usize,
    method: u8,
    rays_per_pixel: u32,
    smooth: bool,
    /// Moves the start along the ray.
    offset: f64,
    backwards: bool,
    /// Hits beyond it do not count; infinite where nothing was said.
    pub max_distance: f64,
    /// Method 3: faces by rows of the texture plane.
    uv_rows: Vec<Vec<u32>>,
}

/// A face of a mesh, and the place on it by barycentric weights (the middle where `None`).
type Start<'a> = (&'a Placed<Mesh>, usize, Option<[f64; 3]>);

/// How far a point may lie outside a texture triangle: texture places are kept in single precision, and a
/// point on the seam of two faces must not fall between them.
const UV_SLACK: f64 = 1e-5;

/// Rows of the face index of method 3.
const UV_ROWS: usize = 256;

impl MeshRays {
    /// Makes a mesh camera ready.
    pub fn new(mesh: &Arc<scene::MeshCamera>, camera: &scene::Camera) -> Self {
        let uv_rows = match (mesh.method, mesh.meshes.first()) {
            (3, Some(first)) => index_rows(&first.item),
            _ => Vec::new(),
        };
        MeshRays {
            meshes: mesh.meshes.clone(),
            total_faces: mesh.meshes.iter().map(|m| m.item.faces.len()).sum(),
            method: mesh.method,
            rays_per_pixel: mesh.rays_per_pixel.max(1),
            smooth: mesh.smooth,
            offset: camera.location.z,
            backwards: camera.direction.z < -EPS,
            max_distance: if mesh.max_distance >= EPS { mesh.max_distance } else { f64::INFINITY },
            uv_rows,
        }
    }

    /// How many rays a pixel may have.
    pub fn rays_per_pixel(&self) -> u32 {
        self.rays_per_pixel
    }

    /// Ray `k` of a pixel; `None` where there is no face.
    pub fn ray(&self, x: f64, y: f64, k: u32, frame: Frame) -> Option<Ray> {
        let x = (x + 0.5).clamp(0.0, frame.width - 1.0);
        let y = (y - 0.5).clamp(0.0, frame.height - 1.0);
        let across = frame.width as usize;
        let index = y as usize * across + x as usize;
        let (mesh, face, at) = match self.method {
            0 => (self.meshes.get(k as usize)?, index, None),
            1 => self.concatenated(index + k as usize * self.total_faces)?,
            2 => {
                let strip = frame.width / self.meshes.len() as f64;
                let mesh = self.meshes.get((x / strip) as usize)?;
                (mesh, y as usize * (across / self.meshes.len()) + x as usize, None)
            }
            _ => {
                let uv = Vec2::new((x - 0.5) / frame.width, 1.0 - (y + 0.5) / frame.height);
                let mesh = self.meshes.first()?;
                let (face, weights) = self.face_at(&mesh.item, uv)?;
                (mesh, face, Some(weights))
            }
        };
        let face = mesh.item.faces.get(face)?;
        Some(self.leaving(&mesh.item, &face, at, &mesh.parent_from_item()))
    }

    fn concatenated(&self, mut index: usize) -> Option<Start<'_>> {
        for mesh in &self.meshes {
            if index < mesh.item.faces.len() {
                return Some((mesh, index, None));
            }
            index -= mesh.item.faces.len();
        }
        None
    }

    fn leaving(&self, mesh: &Mesh, face: &MeshFace, at: Option<[f64; 3]>, world_from_mesh: &Affine) -> Ray {
        let weights = at.unwrap_or([1.0 / 3.0; 3]);
        let points = face.vertices.map(|v| wide(mesh.vertices[v as usize]));
        let mix = |p: [Vec3; 3]| p[0] * weights[0] + p[1] * weights[1] + p[2] * weights[2];
        // The side from which the corners run clockwise is the front.
        let flat = (points[2] - points[0]).cross(points[1] - points[0]);
        let normal = match (self.smooth && at.is_some(), face.normals) {
            (true, Some(normals)) => mix(normals.map(|n| wide(mesh.normals[n as usize]))),
            _ => flat,
        };
        let normal = normal.try_normalize().unwrap_or(Vec3::Z);
        let origin = mix(points) + normal * self.offset;
        let dir = if self.backwards { -normal } else { normal };
        let dir = world_from_mesh.transform_vector3(dir);
        Ray::new(world_from_mesh.transform_point3(origin), dir.try_normalize().unwrap_or(Vec3::Z))
    }

    /// The first face whose texture triangle holds the point, with the point's barycentric weights.
    fn face_at(&self, mesh: &Mesh, uv: Vec2) -> Option<(usize, [f64; 3])> {
        let row = self.uv_rows.get(row_of(uv.y))?;
        row.iter().find_map(|&f| {
            let [a, b, c] = corners(mesh, &mesh.faces.face(f as usize))?;
            let area = (b - a).perp_dot(c - a);
            let (v, w) = ((uv - a).perp_dot(c - a) / area, (b - a).perp_dot(uv - a) / area);
            let u = 1.0 - v - w;
            (u.min(v).min(w) >= -UV_SLACK).then_some((f as usize, [u, v, w]))
        })
    }
}

fn wide(p: [f32; 3]) -> Vec3 {
    Vec3::new(p[0].into(), p[1].into(), p[2].into())
}

fn corners(mesh: &Mesh, face: &MeshFace) -> Option<[Vec2; 3]> {
    Some(face.uvs?.map(|i| {
        let [u, v] = mesh.uvs[i as usize];
        Vec2::new(u.into(), v.into())
    }))
}

fn row_of(v: f64) -> usize {
    ((v * UV_ROWS as f64).max(0.0) as usize).min(UV_ROWS - 1)
}

fn index_rows(mesh: &Mesh) -> Vec<Vec<u32>> {
    let mut rows = vec![Vec::new(); UV_ROWS];
    for (i, face) in mesh.faces.iter().enumerate() {
        if let Some(c) = corners(mesh, &face) {
            let (low, high) = (c[0].y.min(c[1].y).min(c[2].y), c[0].y.max(c[1].y).max(c[2].y));
            for row in &mut rows[row_of(low)..=row_of(high)] {
                row.push(i as u32);
            }
        }
    }
    rows
}
