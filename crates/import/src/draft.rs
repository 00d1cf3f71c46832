//! A mesh on its way: what all formats check and mend in the same way.
use raggio_math::Vec3;
use raggio_scene::{FaceIndices, Mesh, has_area};
use rayon::prelude::*;

use crate::{ImportError, Result};

/// Most vertices, and most triangles: indices have 32 bits, and search structures use some of them.
pub(crate) const MOST: usize = 1 << 30;

/// A point in single precision; `None` where it is not finite there.
pub(crate) fn point<const N: usize>(values: [f64; N]) -> Option<[f32; N]> {
    let narrow = values.map(|v| v as f32);
    narrow.iter().all(|v| v.is_finite()).then_some(narrow)
}

/// Three corners around a polygon: a fan from its first corner.
pub(crate) fn fan<T: Copy>(polygon: &[T]) -> impl Iterator<Item = [T; 3]> + '_ {
    polygon.windows(2).skip(1).map(|pair| [polygon[0], pair[0], pair[1]])
}

/// The mesh as the scene wants it: normals of unit length, no triangle without area, something left.
pub(crate) fn finished(mut mesh: Mesh) -> Result<Mesh> {
    if mesh.vertices.len() > MOST || mesh.faces.len() > MOST {
        return Err(ImportError::Whole("more triangles than Raggio can count".to_owned()));
    }
    unit_normals(&mut mesh);
    let keep: Vec<bool> = mesh.faces.corners.par_iter().map(|&c| has_area(&mesh.vertices, c)).collect();
    mesh.faces.retain(&keep);
    match mesh.faces.is_empty() {
        true => Err(ImportError::Whole("there is no triangle in it".to_owned())),
        false => Ok(mesh),
    }
}

/// Triangles with a normal of length zero at a corner become flat.
fn unit_normals(mesh: &mut Mesh) {
    let mut zero = Vec::new();
    for (i, normal) in mesh.normals.iter_mut().enumerate() {
        match Vec3::from_array(normal.map(f64::from)).try_normalize() {
            Some(unit) => *normal = unit.as_vec3().to_array(),
            None => zero.push(i as u32),
        }
    }
    if zero.is_empty() {
        return;
    }
    let lacking = |corners: &[u32; 3]| corners.iter().any(|i| zero.binary_search(i).is_ok());
    let faces = &mut mesh.faces;
    let kept = |i: usize, corners| faces.normals.of(i, corners).filter(|n| !lacking(n));
    let listed = faces.corners.iter().enumerate().map(|(i, &corners)| kept(i, corners)).collect();
    faces.normals = FaceIndices::Listed(listed);
    for i in zero {
        mesh.normals[i as usize] = [1.0, 0.0, 0.0];
    }
}
