//! `mesh2 { vertex_vectors { } ... }` (shapes spec, section 3).
use std::sync::Arc;

use raggio_diag::Span;
use raggio_scene::{FaceIndices, FaceTexture, Faces, Mesh, Object, Shape, Texture};

use super::mesh::inside_vector;
use super::object;
use super::texture;
use super::util::{comma_vec3, float, take, vec2, word};
use crate::keyword::Kw;
use crate::parser::{Parser, Result, Tok};
use crate::value::Kind;

/// Most entries of one list.
const MOST: i64 = 1 << 30;

/// The lists of a mesh2 as they are written.
#[derive(Default)]
struct Lists {
    vertices: Option<Vec<[f32; 3]>>,
    normals: Option<Vec<[f32; 3]>>,
    uvs: Option<Vec<[f32; 2]>>,
    textures: Vec<Arc<Texture>>,
    faces: Vec<[u32; 3]>,
    face_textures: Vec<FaceTexture>,
    uv_indices: Option<Vec<[u32; 3]>>,
    normal_indices: Option<Vec<[u32; 3]>>,
}

/// `mesh2 { ... }`
pub fn mesh2(p: &mut Parser) -> Result<Object> {
    object::shape(p, "mesh2", |p| {
        let span = p.span();
        let (mut lists, mut inside) = (Lists::default(), None);
        while let Some(key) = word(p)? {
            if key == Kw::Inside_vector {
                inside = inside_vector(p)?;
            } else if !list(p, &mut lists, key)? {
                break;
            }
        }
        let mut mesh = assembled(p, lists, span)?;
        mesh.inside_vector = inside;
        Ok(Shape::Mesh(Arc::new(mesh)))
    })
}

/// One list with its word.
fn list(p: &mut Parser, lists: &mut Lists, key: Kw) -> Result<bool> {
    match key {
        Kw::Vertex_vectors => {
            once(p, key, lists.vertices.is_some())?;
            lists.vertices = Some(counted(p, |p| Ok(comma_vec3(p)?.as_vec3().to_array()))?);
        }
        Kw::Normal_vectors => {
            once(p, key, lists.normals.is_some())?;
            lists.normals = Some(counted(p, |p| {
                let normal = comma_vec3(p)?;
                Ok(normal.try_normalize().unwrap_or(raggio_math::Vec3::X).as_vec3().to_array())
            })?);
        }
        Kw::Uv_vectors => {
            once(p, key, lists.uvs.is_some())?;
            lists.uvs = Some(counted(p, |p| {
                p.comma()?;
                Ok(vec2(p)?.as_vec2().to_array())
            })?);
        }
        Kw::Texture_list => {
            once(p, key, !lists.textures.is_empty())?;
            lists.textures = counted(p, listed_texture)?;
        }
        Kw::Face_indices => {
            once(p, key, !lists.faces.is_empty())?;
            let textures = lists.textures.len();
            let mut face_textures = Vec::new();
            lists.faces = counted(p, |p| {
                let corners = indices(p)?;
                if textures > 0 {
                    face_textures.push(face_texture(p, textures)?);
                }
                Ok(corners)
            })?;
            lists.face_textures = face_textures;
        }
        Kw::Uv_indices => {
            once(p, key, lists.uv_indices.is_some())?;
            lists.uv_indices = Some(counted(p, indices)?);
        }
        Kw::Normal_indices => {
            once(p, key, lists.normal_indices.is_some())?;
            lists.normal_indices = Some(counted(p, indices)?);
        }
        _ => return Ok(false),
    }
    Ok(true)
}

/// Consumes the word; warns if its list has been there before.
fn once(p: &mut Parser, key: Kw, repeated: bool) -> Result<()> {
    let span = p.span();
    p.next()?;
    if repeated {
        p.warn("repeated-list", format!("duplicate {} block; the last one counts", key.word()), span);
    }
    Ok(())
}

/// `{ n, item, item ... }`
fn counted<T>(p: &mut Parser, mut item: impl FnMut(&mut Parser) -> Result<T>) -> Result<Vec<T>> {
    p.expect('{')?;
    let n = p.int("number of entries", 0..=MOST)? as usize;
    p.comma()?;
    let mut items = Vec::with_capacity(n.min(1 << 16));
    for _ in 0..n {
        items.push(item(p)?);
        p.comma()?;
    }
    p.expect('}')?;
    Ok(items)
}

/// `texture { ... }`, or a texture's bare name.
fn listed_texture(p: &mut Parser) -> Result<Arc<Texture>> {
    match p.peek()? {
        Tok::Value(Kind::Texture) => Ok(take!(p, Texture)),
        Tok::Kw(Kw::Texture) => {
            p.next()?;
            texture::block(p).map(Arc::new)
        }
        _ => p.expected("a texture"),
    }
}

/// `<a, b, c>` as indices.
fn indices(p: &mut Parser) -> Result<[u32; 3]> {
    let span = p.span();
    let v = comma_vec3(p)?;
    if v.min_element() < 0.0 || v.max_element() >= MOST as f64 {
        return p.error("bad-index", "mesh index out of range", span);
    }
    Ok([v.x as u32, v.y as u32, v.z as u32])
}

/// `[, texture [, texture, texture]]` behind a face's corners
fn face_texture(p: &mut Parser, textures: usize) -> Result<FaceTexture> {
    let mut listed = Vec::new();
    while listed.len() < 3 {
        p.comma()?;
        if p.peek()? == Tok::Punct('<') || !p.at_expression()? {
            break;
        }
        let span = p.span();
        let index = float(p)?;
        if index < 0.0 || index as usize >= textures {
            return p.error("bad-index", "texture index out of range in mesh2", span);
        }
        listed.push(index as u32);
    }
    Ok(match listed[..] {
        [a, b, c] => FaceTexture::Three([a, b, c]),
        [a, ..] => FaceTexture::One(a),
        [] => FaceTexture::Object,
    })
}

/// Checks the lists against each other and makes the mesh; triangles without area are dropped.
fn assembled(p: &mut Parser, lists: Lists, span: Span) -> Result<Mesh> {
    let Some(vertices) = lists.vertices.filter(|list| !list.is_empty()) else {
        return p.error("bad-mesh2", "vertex vectors not found in mesh2", span);
    };
    if lists.faces.is_empty() {
        return p.error("bad-mesh2", "no triangles in triangle mesh", span);
    }
    let corners = lists.faces;
    let fault = |message: &str| p.error("bad-mesh2", message, span);
    check(p, &corners, vertices.len(), "mesh face index out of range", span)?;
    let uvs = lists.uvs.unwrap_or_default();
    let uv_indices = match lists.uv_indices {
        Some(indices) if indices.len() == corners.len() => {
            check(p, &indices, uvs.len(), "mesh uv index out of range", span)?;
            FaceIndices::Listed(indices.into_iter().map(Some).collect())
        }
        Some(_) => return fault("number of uv indices must equal number of faces"),
        None if uvs.len() == vertices.len() && uvs.len() > 1 => FaceIndices::Corners,
        None if uvs.len() == 1 => FaceIndices::Listed(vec![Some([0; 3]); corners.len()]),
        None if uvs.is_empty() => FaceIndices::None,
        None => return fault("missing uv_indices section in mesh2"),
    };
    let normals = lists.normals.unwrap_or_default();
    let normal_indices = match lists.normal_indices {
        Some(indices) if indices.len() <= corners.len() => {
            check(p, &indices, normals.len(), "mesh normal index out of range", span)?;
            let listed = |i: usize| indices.get(i).copied().filter(|&n| !agree(&normals, n));
            FaceIndices::Listed((0..corners.len()).map(listed).collect())
        }
        Some(_) => return fault("number of normal indices cannot be more than the number of faces"),
        None if normals.len() == vertices.len() => at_corners(&normals, &corners),
        None if normals.is_empty() => FaceIndices::None,
        None => return fault("missing normal_indices section in mesh2"),
    };
    let mut faces =
        Faces { corners, normals: normal_indices, uvs: uv_indices, textures: lists.face_textures };
    faces.drop_degenerate(&vertices);
    Ok(Mesh { vertices, normals, uvs, textures: lists.textures, faces, inside_vector: None })
}

/// A normal for each vertex.
fn at_corners(normals: &[[f32; 3]], corners: &[[u32; 3]]) -> FaceIndices {
    if !corners.iter().any(|&c| agree(normals, c)) {
        return FaceIndices::Corners;
    }
    FaceIndices::Listed(corners.iter().map(|&c| Some(c).filter(|&c| !agree(normals, c))).collect())
}

fn check(p: &Parser, indices: &[[u32; 3]], size: usize, message: &str, span: Span) -> Result<()> {
    match indices.iter().flatten().all(|&i| (i as usize) < size) {
        true => Ok(()),
        false => p.error("bad-index", message, span),
    }
}

/// Normals that agree make a flat triangle, whose own normal counts.
fn agree(normals: &[[f32; 3]], indices: [u32; 3]) -> bool {
    let [a, b, c] = indices.map(|i| raggio_math::Vec3::from_array(normals[i as usize].map(f64::from)));
    (a - b).length_squared() <= 1e-10 && (a - c).length_squared() <= 1e-10
}
