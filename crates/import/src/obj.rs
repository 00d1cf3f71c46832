//! Wavefront OBJ: corners, normals, texture coordinates, polygons, materials.
//!
//! Groups, smoothing groups, lines, points and free-form surfaces are left aside.
use std::sync::Arc;

use raggio_scene::{FaceTexture, Mesh, MeshFace, Texture};
use rustc_hash::FxHashMap;

use crate::text::{Lines, Words};
use crate::{Result, Surroundings, draft, mtl};

/// A corner of a polygon: place, texture coordinates, normal.
type Corner = (u32, Option<u32>, Option<u32>);

struct Reader<'a> {
    around: &'a Surroundings<'a>,
    mesh: Mesh,
    library: FxHashMap<String, Arc<Texture>>,
    /// Indices of materials in the mesh's list.
    used: FxHashMap<String, u32>,
    texture: FaceTexture,
    /// Corners of the polygon that is being read.
    polygon: Vec<Corner>,
}

/// Reads a file, and the material libraries that it names.
pub(crate) fn read(bytes: &[u8], around: &Surroundings) -> Result<Mesh> {
    let mut reader = Reader {
        around,
        mesh: Mesh::default(),
        library: FxHashMap::default(),
        used: FxHashMap::default(),
        texture: FaceTexture::Object,
        polygon: Vec::new(),
    };
    for mut words in Lines::new(bytes) {
        reader.line(&mut words)?;
    }
    draft::finished(reader.mesh)
}

impl Reader<'_> {
    fn line(&mut self, words: &mut Words) -> Result<()> {
        match words.next().unwrap_or_default() {
            b"v" => self.mesh.vertices.push(words.point()?),
            b"vn" => self.mesh.normals.push(words.point()?),
            // The second coordinate may be left out, a third has no meaning here.
            b"vt" => {
                let u = words.number()?;
                let v = words.next().and_then(crate::text::number).unwrap_or(0.0);
                match draft::point([u, v]) {
                    Some(uv) => self.mesh.uvs.push(uv),
                    None => return words.error("this number is too large"),
                }
            }
            b"f" => self.face(words)?,
            b"mtllib" => self.library(words)?,
            b"usemtl" => self.texture = self.material(&words.name()),
            _ => {}
        }
        Ok(())
    }

    fn face(&mut self, words: &mut Words) -> Result<()> {
        self.polygon.clear();
        while let Some(word) = words.next() {
            if word.starts_with(b"#") {
                break;
            }
            match self.corner(word) {
                Some(corner) => self.polygon.push(corner),
                None => {
                    let word = String::from_utf8_lossy(word).into_owned();
                    return words.error(format!("`{word}` names nothing that came before this line"));
                }
            }
        }
        if self.polygon.len() < 3 {
            return words.error("a face has three corners or more");
        }
        for corners in draft::fan(&self.polygon) {
            let [a, b, c] = corners;
            let all = |part: fn(Corner) -> Option<u32>| Some([part(a)?, part(b)?, part(c)?]);
            self.mesh.faces.push(MeshFace {
                vertices: corners.map(|corner| corner.0),
                uvs: all(|corner| corner.1),
                normals: all(|corner| corner.2),
                texture: self.texture,
            });
        }
        Ok(())
    }

    /// `v`, `v/vt`, `v//vn` or `v/vt/vn`.
    fn corner(&self, word: &[u8]) -> Option<Corner> {
        let mut parts = word.split(|&b| b == b'/');
        let vertex = index(parts.next()?, self.mesh.vertices.len())?;
        let mut further = |count: usize| match parts.next() {
            None | Some(b"") => Some(None),
            Some(part) => index(part, count).map(Some),
        };
        let (uv, normal) = (further(self.mesh.uvs.len())?, further(self.mesh.normals.len())?);
        parts.next().is_none().then_some((vertex, uv, normal))
    }

    fn library(&mut self, words: &mut Words) -> Result<()> {
        let name = words.name();
        // A library that is not there leaves the model without materials, not without shape.
        let Some(bytes) = (self.around.find)(&name) else { return Ok(()) };
        match mtl::read(&bytes, self.around) {
            Ok(materials) => self.library.extend(materials),
            Err(fault) => return words.error(format!("in the material library {name}: {fault}")),
        }
        Ok(())
    }

    fn material(&mut self, name: &str) -> FaceTexture {
        if let Some(&index) = self.used.get(name) {
            return FaceTexture::One(index);
        }
        let Some(texture) = self.library.get(name) else { return FaceTexture::Object };
        let index = self.mesh.textures.len() as u32;
        self.mesh.textures.push(texture.clone());
        self.used.insert(name.to_owned(), index);
        FaceTexture::One(index)
    }
}

/// A place in a list of `count`: from 1 from the start, from -1 from the end.
fn index(word: &[u8], count: usize) -> Option<u32> {
    let given: i64 = std::str::from_utf8(word).ok()?.parse().ok()?;
    let index = if given > 0 { given - 1 } else { given.checked_add(count as i64)? };
    let in_range = given != 0 && (0..count as i64).contains(&index) && count <= draft::MOST;
    in_range.then_some(index as u32)
}
