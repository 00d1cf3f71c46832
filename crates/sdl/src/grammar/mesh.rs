//! `mesh { triangle { } ... }` (shapes spec, section 3), and what both kinds of mesh share.
use std::sync::Arc;

use raggio_math::{Vec2, Vec3};
use raggio_scene::{FaceTexture, Mesh, MeshFace, Object, Shape, Texture};
use rustc_hash::FxHashMap;

use super::object;
use super::util::{comma_vec3, take, vec2, vec3};
use crate::keyword::Kw;
use crate::parser::{Parser, Result, Tok};
use crate::value::Kind;

/// A mesh that is being filled; equal corners and textures are kept once.
#[derive(Default)]
struct Builder {
    mesh: Mesh,
    vertices: FxHashMap<[u32; 3], u32>,
    normals: FxHashMap<[u32; 3], u32>,
    uvs: FxHashMap<[u32; 2], u32>,
    textures: FxHashMap<*const Texture, u32>,
    zero_normal: bool,
}

/// The index of a value in a list that holds each value once.
fn index_of<const N: usize>(
    list: &mut Vec<[f32; N]>,
    known: &mut FxHashMap<[u32; N], u32>,
    value: [f32; N],
) -> u32 {
    *known.entry(value.map(f32::to_bits)).or_insert_with(|| {
        list.push(value);
        list.len() as u32 - 1
    })
}

impl Builder {
    fn vertex(&mut self, v: Vec3) -> u32 {
        index_of(&mut self.mesh.vertices, &mut self.vertices, v.as_vec3().to_array())
    }

    /// Normals that agree make a flat triangle, whose own normal counts.
    fn normals(&mut self, normals: [Vec3; 3]) -> Option<[u32; 3]> {
        let units = normals.map(|n| n.try_normalize().unwrap_or(Vec3::X));
        self.zero_normal |= normals.iter().any(|n| n.try_normalize().is_none());
        let same = |a: Vec3, b: Vec3| (a - b).length_squared() <= 1e-10;
        if same(units[0], units[1]) && same(units[0], units[2]) {
            return None;
        }
        Some(units.map(|n| index_of(&mut self.mesh.normals, &mut self.normals, n.as_vec3().to_array())))
    }

    fn uv(&mut self, uv: Vec2) -> u32 {
        index_of(&mut self.mesh.uvs, &mut self.uvs, uv.as_vec2().to_array())
    }

    fn texture(&mut self, texture: Arc<Texture>) -> u32 {
        *self.textures.entry(Arc::as_ptr(&texture)).or_insert_with(|| {
            self.mesh.textures.push(texture);
            self.mesh.textures.len() as u32 - 1
        })
    }

    /// Adds a triangle unless it has no area.
    fn face(&mut self, points: [Vec3; 3], normals: Option<[Vec3; 3]>, extras: Extras) {
        let stored = points.map(|v| v.as_vec3().as_dvec3());
        if super::triangles::face_normal(stored) == Vec3::ZERO {
            return;
        }
        let vertices = points.map(|v| self.vertex(v));
        let normals = normals.and_then(|n| self.normals(n));
        let uvs = extras.uvs.map(|uvs| uvs.map(|uv| self.uv(uv)));
        let texture = match extras.textures {
            None => FaceTexture::Object,
            Some([a, b, c]) if Arc::ptr_eq(&a, &b) && Arc::ptr_eq(&b, &c) => {
                FaceTexture::One(self.texture(a))
            }
            Some(textures) => FaceTexture::Three(textures.map(|texture| self.texture(texture))),
        };
        self.mesh.faces.push(MeshFace { vertices, normals, uvs, texture });
    }
}

/// What a triangle of a mesh may say beside its corners.
#[derive(Default)]
struct Extras {
    uvs: Option<[Vec2; 3]>,
    textures: Option<[Arc<Texture>; 3]>,
}

/// `mesh { ... }`
pub fn mesh(p: &mut Parser) -> Result<Object> {
    object::shape(p, "mesh", |p| {
        let span = p.span();
        if p.peek()? == Tok::Unknown && p.text() == "file" {
            return from_file(p);
        }
        let mut builder = Builder::default();
        loop {
            match p.peek()? {
                Tok::Kw(Kw::Triangle) => flat_face(p, &mut builder)?,
                Tok::Kw(Kw::Smooth_triangle) => smooth_face(p, &mut builder)?,
                Tok::Kw(Kw::Inside_vector) => builder.mesh.inside_vector = inside_vector(p)?,
                _ => break,
            }
        }
        if builder.mesh.faces.is_empty() {
            return p.error("empty-mesh", "no triangles in triangle mesh", span);
        }
        if builder.zero_normal {
            p.warn("zero-normal", "a normal in this mesh is zero; it is taken as <1, 0, 0>", span);
        }
        Ok(Shape::Mesh(Arc::new(builder.mesh)))
    })
}

/// `file "model.ply" [inside_vector v]`, an addition to the language. `file` is no word of the language elsewhere, and a
/// scene that declares it has it for itself.
fn from_file(p: &mut Parser) -> Result<Shape> {
    p.next()?;
    let name = p.path()?;
    let mut mesh = p.model(&name)?;
    if p.peek()? == Tok::Kw(Kw::Inside_vector) {
        mesh.inside_vector = inside_vector(p)?;
    }
    Ok(Shape::Mesh(Arc::new(mesh)))
}

/// `inside_vector v`; the zero vector means none.
pub fn inside_vector(p: &mut Parser) -> Result<Option<Vec3>> {
    p.next()?;
    Ok(vec3(p)?.try_normalize())
}

fn flat_face(p: &mut Parser, builder: &mut Builder) -> Result<()> {
    p.next()?;
    p.expect('{')?;
    let points = [vec3(p)?, comma_vec3(p)?, comma_vec3(p)?];
    let extras = extras(p)?;
    builder.face(points, None, extras);
    Ok(())
}

fn smooth_face(p: &mut Parser, builder: &mut Builder) -> Result<()> {
    p.next()?;
    p.expect('{')?;
    let c = [vec3(p)?, comma_vec3(p)?, comma_vec3(p)?, comma_vec3(p)?, comma_vec3(p)?, comma_vec3(p)?];
    let extras = extras(p)?;
    builder.face([c[0], c[2], c[4]], Some([c[1], c[3], c[5]]), extras);
    Ok(())
}

/// `uv_vectors`, `texture`, `texture_list` up to the closing brace.
fn extras(p: &mut Parser) -> Result<Extras> {
    let mut extras = Extras::default();
    while !p.accept_punct('}')? {
        if p.accept(Kw::Uv_vectors)? {
            let mut uvs = [Vec2::ZERO; 3];
            for uv in &mut uvs {
                p.comma()?;
                *uv = vec2(p)?;
            }
            extras.uvs = Some(uvs);
        } else if p.accept(Kw::Texture)? {
            p.expect('{')?;
            let texture = texture_identifier(p)?;
            p.expect('}')?;
            extras.textures = Some([texture.clone(), texture.clone(), texture]);
        } else if p.accept(Kw::Texture_list)? {
            p.expect('{')?;
            let [a, b, c] = [texture_identifier(p)?, texture_identifier(p)?, texture_identifier(p)?];
            p.expect('}')?;
            extras.textures = Some([a, b, c]);
        } else if !p.accept_punct(',')? {
            return p.expected("`uv_vectors`, `texture`, `texture_list` or `}`");
        }
    }
    Ok(extras)
}

fn texture_identifier(p: &mut Parser) -> Result<Arc<Texture>> {
    p.comma()?;
    match p.peek()? {
        Tok::Value(Kind::Texture) => Ok(take!(p, Texture)),
        _ => p.expected("the name of a declared texture"),
    }
}
