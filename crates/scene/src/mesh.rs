//! Triangle meshes, kept lean: what no face has takes no memory.
use std::sync::Arc;

use raggio_math::Vec3;

use crate::Texture;

/// A triangle mesh. All indices are in range; triangles without area have been dropped.
#[derive(Clone, Debug, Default)]
pub struct Mesh {
    /// Corner points, in single precision as the language keeps them.
    pub vertices: Vec<[f32; 3]>,
    /// Normals of unit length.
    pub normals: Vec<[f32; 3]>,
    /// Texture coordinates.
    pub uvs: Vec<[f32; 2]>,
    /// Textures that faces name.
    pub textures: Vec<Arc<Texture>>,
    /// The triangles.
    pub faces: Faces,
    /// `inside_vector`, unit length; `None`: nothing is inside.
    pub inside_vector: Option<Vec3>,
}

/// The triangles of a mesh, one list for each thing that a triangle may have. Meshes of millions of triangles are made
/// from the lists, small ones face by face.
#[derive(Clone, Debug, Default)]
pub struct Faces {
    /// Corners of each triangle.
    pub corners: Vec<[u32; 3]>,
    /// Normals at the corners.
    pub normals: FaceIndices,
    /// Texture coordinates at the corners.
    pub uvs: FaceIndices,
    /// The texture of each triangle; empty where all have the object's.
    pub textures: Vec<FaceTexture>,
}

/// Indices of something that triangles have at their corners.
#[derive(Clone, Debug, Default, PartialEq)]
pub enum FaceIndices {
    /// No triangle has it.
    #[default]
    None,
    /// There is one for each vertex: the triangles' corners are the indices.
    Corners,
    /// Indices for each triangle.
    Listed(Vec<Option<[u32; 3]>>),
}

/// A triangle of a mesh.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct MeshFace {
    /// Corners.
    pub vertices: [u32; 3],
    /// Normals at the corners; `None` is flat.
    pub normals: Option<[u32; 3]>,
    /// Texture coordinates at the corners; `None` is (0, 0).
    pub uvs: Option<[u32; 3]>,
    /// Its texture or textures.
    pub texture: FaceTexture,
}

/// Which texture a face has.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum FaceTexture {
    /// The object's.
    Object,
    /// One of the mesh's list.
    One(u32),
    /// One at each corner, mixed between.
    Three([u32; 3]),
}

impl FaceIndices {
    /// Those of triangle `i`, whose corners are given.
    #[inline]
    pub fn of(&self, i: usize, corners: [u32; 3]) -> Option<[u32; 3]> {
        match self {
            FaceIndices::None => None,
            FaceIndices::Corners => Some(corners),
            FaceIndices::Listed(list) => list[i],
        }
    }

    /// Adds those of a triangle behind `corners`, the triangles that are there.
    fn push(&mut self, indices: Option<[u32; 3]>, own_corners: [u32; 3], corners: &[[u32; 3]]) {
        let as_corners = indices == Some(own_corners);
        match self {
            FaceIndices::Listed(list) => list.push(indices),
            FaceIndices::None if indices.is_none() => {}
            FaceIndices::None if as_corners && corners.is_empty() => *self = FaceIndices::Corners,
            FaceIndices::Corners if as_corners => {}
            FaceIndices::None | FaceIndices::Corners => {
                let mut list: Vec<_> = corners.iter().enumerate().map(|(i, &c)| self.of(i, c)).collect();
                list.push(indices);
                *self = FaceIndices::Listed(list);
            }
        }
    }

    /// Drops the triangles that are not to be kept.
    fn retain(&mut self, keep: &[bool]) {
        if let FaceIndices::Listed(list) = self {
            retain(list, keep);
        }
    }
}

/// Keeps the items whose flag is set.
fn retain<T>(list: &mut Vec<T>, keep: &[bool]) {
    let mut flags = keep.iter();
    list.retain(|_| flags.next().copied().unwrap_or(true));
}

impl Faces {
    /// How many triangles.
    pub fn len(&self) -> usize {
        self.corners.len()
    }

    /// No triangle at all?
    pub fn is_empty(&self) -> bool {
        self.corners.is_empty()
    }

    /// Triangle `i`, which must be one of them.
    #[inline]
    pub fn face(&self, i: usize) -> MeshFace {
        let vertices = self.corners[i];
        MeshFace {
            vertices,
            normals: self.normals.of(i, vertices),
            uvs: self.uvs.of(i, vertices),
            texture: self.textures.get(i).copied().unwrap_or(FaceTexture::Object),
        }
    }

    /// Triangle `i`, if there is one.
    pub fn get(&self, i: usize) -> Option<MeshFace> {
        (i < self.len()).then(|| self.face(i))
    }

    /// All triangles.
    pub fn iter(&self) -> impl Iterator<Item = MeshFace> {
        (0..self.len()).map(|i| self.face(i))
    }

    /// Adds a triangle.
    pub fn push(&mut self, face: MeshFace) {
        self.normals.push(face.normals, face.vertices, &self.corners);
        self.uvs.push(face.uvs, face.vertices, &self.corners);
        if !self.textures.is_empty() || face.texture != FaceTexture::Object {
            self.textures.resize(self.len(), FaceTexture::Object);
            self.textures.push(face.texture);
        }
        self.corners.push(face.vertices);
    }

    /// Drops triangles without area, as [`Mesh`] wants it.
    pub fn drop_degenerate(&mut self, vertices: &[[f32; 3]]) {
        if self.corners.iter().all(|&c| has_area(vertices, c)) {
            return;
        }
        let keep: Vec<bool> = self.corners.iter().map(|&c| has_area(vertices, c)).collect();
        self.retain(&keep);
    }

    /// Drops the triangles that are not to be kept.
    pub fn retain(&mut self, keep: &[bool]) {
        if keep.contains(&false) {
            retain(&mut self.corners, keep);
            retain(&mut self.textures, keep);
            self.normals.retain(keep);
            self.uvs.retain(keep);
        }
    }
}

impl FromIterator<MeshFace> for Faces {
    fn from_iter<I: IntoIterator<Item = MeshFace>>(faces: I) -> Self {
        let mut all = Faces::default();
        faces.into_iter().for_each(|face| all.push(face));
        all
    }
}

/// Has a triangle with these corners an area?
#[inline]
pub fn has_area(vertices: &[[f32; 3]], corners: [u32; 3]) -> bool {
    let [a, b, c] = corners.map(|i| Vec3::from_array(vertices[i as usize].map(f64::from)));
    (a - b).cross(c - b) != Vec3::ZERO
}

#[cfg(test)]
mod tests {
    use super::*;

    fn face(normals: Option<[u32; 3]>, texture: FaceTexture) -> MeshFace {
        MeshFace { vertices: [0, 1, 2], normals, uvs: None, texture }
    }

    #[test]
    fn faces_come_back_as_they_were_pushed() {
        let kinds = [None, Some([0, 1, 2]), Some([2, 1, 0])];
        let textures = [FaceTexture::Object, FaceTexture::One(3)];
        for order in 0..81 {
            let pick = |k: u32| face(kinds[(order / 3usize.pow(k)) % 3], textures[(order >> k) & 1]);
            let pushed: Vec<MeshFace> = (0..4).map(pick).collect();
            let faces = Faces::from_iter(pushed.clone());
            assert_eq!(faces.iter().collect::<Vec<_>>(), pushed);
        }
    }

    #[test]
    fn what_no_face_has_takes_no_memory() {
        let flat = Faces::from_iter([face(None, FaceTexture::Object); 3]);
        assert_eq!((flat.normals, flat.textures.capacity()), (FaceIndices::None, 0));
        let smooth = Faces::from_iter([face(Some([0, 1, 2]), FaceTexture::Object); 3]);
        assert_eq!(smooth.normals, FaceIndices::Corners);
    }

    #[test]
    fn faces_without_area_go_with_all_they_have() {
        let vertices = [[0.0; 3], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0]];
        let thin = MeshFace { vertices: [0, 1, 1], ..face(Some([1, 1, 1]), FaceTexture::One(1)) };
        let good = face(None, FaceTexture::One(2));
        let mut faces = Faces::from_iter([thin, good, thin]);
        faces.drop_degenerate(&vertices);
        assert_eq!(faces.iter().collect::<Vec<_>>(), [good]);
    }
}
