//! Objects: which block is which shape, and what all blocks have in common.
use std::sync::Arc;

use raggio_scene::{Csg, Object, ObjectKind, Shape, Texture};

use super::util::{take, word};
use super::{
    blob, csg, curves, height_field, interior, isosurface, julia, light, modifiers, nurbs, patch, poly,
    quadrics, text, triangles,
};
use crate::keyword::Kw;
use crate::parser::{Parser, Result, Tok};
use crate::value::Kind;

/// The object whose block comes next, if one does.
pub fn any(p: &mut Parser) -> Result<Option<Object>> {
    if nurbs::comes_next(p)? {
        return nurbs::nurbs_patch(p).map(Some);
    }
    let Some(name) = word(p)? else { return Ok(None) };
    let Some(read) = reader(name) else { return Ok(None) };
    p.next()?;
    let (object, undefined) = p.noting_undefined(read)?;
    Ok(Some(if undefined { nothing() } else { object }))
}

/// The same, or an object's identifier that stands alone.
pub fn any_or_identifier(p: &mut Parser) -> Result<Option<Object>> {
    if p.peek()? != Tok::Value(Kind::Object) {
        return any(p);
    }
    let span = p.span();
    let object = take!(p, Object);
    p.warn("bare-object", "an object's name should stand in `object { }`", span);
    Ok(Some(Arc::unwrap_or_clone(object)))
}

type Reader = fn(&mut Parser) -> Result<Object>;

/// The room that reads the block of a word.
fn reader(name: Kw) -> Option<Reader> {
    Some(match name {
        Kw::Sphere => quadrics::sphere,
        Kw::Box => quadrics::box_,
        Kw::Plane => quadrics::plane,
        Kw::Cylinder => quadrics::cylinder,
        Kw::Cone => quadrics::cone,
        Kw::Disc => quadrics::disc,
        Kw::Torus => quadrics::torus,
        Kw::Ovus => quadrics::ovus,
        Kw::Superellipsoid => quadrics::superellipsoid,
        Kw::Quadric => poly::quadric,
        Kw::Cubic => poly::cubic,
        Kw::Quartic => poly::quartic,
        Kw::Poly => poly::poly,
        Kw::Polynomial => poly::polynomial,
        Kw::Triangle => triangles::triangle,
        Kw::Smooth_triangle => triangles::smooth_triangle,
        Kw::Polygon => triangles::polygon,
        Kw::Mesh => super::mesh::mesh,
        Kw::Mesh2 => super::mesh2::mesh2,
        Kw::Bicubic_patch => patch::bicubic_patch,
        Kw::Height_field => height_field::height_field,
        Kw::Blob => blob::blob,
        Kw::Julia_fractal => julia::julia_fractal,
        Kw::Lathe => curves::lathe,
        Kw::Sor => curves::sor,
        Kw::Prism => super::prism::prism,
        Kw::Sphere_sweep => curves::sphere_sweep,
        Kw::Text => text::text,
        Kw::Isosurface => isosurface::isosurface,
        Kw::Parametric => isosurface::parametric,
        Kw::Union | Kw::Composite => csg::union,
        Kw::Merge => csg::merge,
        Kw::Intersection => csg::intersection,
        Kw::Difference => csg::difference,
        Kw::Object => object,
        Kw::Light_source => light::light_source,
        Kw::Light_group => light::light_group,
        _ => return None,
    })
}

/// Reads `{ head modifiers }`. Instead of the head there may be the identifier of an object, which is copied.
pub fn build(p: &mut Parser, what: &str, head: impl FnOnce(&mut Parser) -> Result<Object>) -> Result<Object> {
    let (mut head, mut object) = (Some(head), None);
    let span = p.span();
    p.block(what, |p| {
        if let Some(object) = &mut object {
            return modifiers::modifier(p, object);
        }
        object = match p.peek()? {
            Tok::Value(Kind::Object) => Some(Arc::unwrap_or_clone(take!(p, Object))),
            _ => match head.take() {
                Some(head) => Some(p.allowing_undefined(head)?),
                None => return Ok(false),
            },
        };
        Ok(true)
    })?;
    match object {
        Some(object) => Ok(finished(object)),
        None => p.error("empty-object", format!("`{what}` is empty"), span),
    }
}

/// Reads `{ head modifiers }` of a shape.
pub fn shape(p: &mut Parser, what: &str, head: impl FnOnce(&mut Parser) -> Result<Shape>) -> Result<Object> {
    build(p, what, |p| Ok(of_shape(head(p)?)))
}

/// A shape as a bare object.
pub fn of_shape(shape: Shape) -> Object {
    Object::new(ObjectKind::Shape(Arc::new(shape)))
}

/// An object that is never hit, which takes the place of degenerate ones.
pub fn nothing() -> Object {
    Object::new(ObjectKind::Csg { op: Csg::Union, children: Arc::new(Vec::new()) })
}

/// What is left to do when an object's block ends.
pub fn finished(mut object: Object) -> Object {
    if let Some(texture) = &object.texture {
        interior::adopt_legacy(&texture.item, &mut object.interior);
    }
    object
}

/// `object { OBJECT modifiers }`
fn object(p: &mut Parser) -> Result<Object> {
    build(p, "object", |p| match any(p)? {
        Some(object) => Ok(object),
        None => p.expected("an object or the name of one"),
    })
}

/// Does any part of the object answer true?
fn any_part(object: &Object, test: &impl Fn(&Object) -> bool) -> bool {
    test(object)
        || match &object.kind {
            ObjectKind::Csg { children, .. } | ObjectKind::LightGroup { children, .. } => {
                children.iter().any(|child| any_part(child, test))
            }
            ObjectKind::Shape(_) | ObjectKind::Light(_) => false,
        }
}

/// Is the object, or a part of it, a surface without an inside?
pub fn is_patch(object: &Object) -> bool {
    any_part(object, &|part| match &part.kind {
        ObjectKind::Shape(shape) => match &**shape {
            Shape::Triangle { .. }
            | Shape::SmoothTriangle { .. }
            | Shape::BicubicPatch { .. }
            | Shape::Parametric(_)
            | Shape::Nurbs(_) => true,
            Shape::Mesh(mesh) => mesh.inside_vector.is_none(),
            _ => false,
        },
        ObjectKind::Light(_) => true,
        _ => false,
    })
}

/// Refuses what cannot clip, bound or fill an object pattern: patches and objects with textures.
pub fn refuse_patch(p: &mut Parser, object: &Object) -> Result<()> {
    if is_patch(object) || any_part(object, &|part| part.texture.is_some()) {
        let span = p.span();
        return p.error(
            "illegal-clip",
            "illegal texture or patch in clip, bound or object pattern: it takes solid objects without textures",
            span,
        );
    }
    Ok(())
}

/// Gives the default texture to whatever of a top-level object would have none. Members of a CSG with
/// `cutaway_textures` stay bare, for there that means something, unless none of them has a texture.
pub fn apply_default_texture(object: &mut Object, default: &Arc<Texture>) {
    if object.texture.is_some() {
        return;
    }
    if let ObjectKind::Csg { op, children } = &mut object.kind {
        let cutaway = is_cutaway(*op);
        let textured = |child: &Arc<Object>| any_part(child, &|part| part.texture.is_some());
        let within = children.iter().any(|child| any_part(child, &has_cutaway));
        if (cutaway && children.iter().any(textured)) || (!cutaway && within) {
            for child in Arc::make_mut(children) {
                if !cutaway || matches!(child.kind, ObjectKind::Csg { .. }) {
                    apply_default_texture(Arc::make_mut(child), default);
                }
            }
            return;
        }
    }
    object.texture = Some(raggio_scene::Placed::new(default.clone()));
}

fn has_cutaway(object: &Object) -> bool {
    matches!(object.kind, ObjectKind::Csg { op, .. } if is_cutaway(op))
}

fn is_cutaway(op: Csg) -> bool {
    matches!(op, Csg::Difference { cutaway_textures: true } | Csg::CutawayIntersection)
}
