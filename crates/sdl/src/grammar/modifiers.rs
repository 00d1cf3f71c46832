//! What may follow the head of any object: transforms, textures, clips, flags (manual 3.7, section 3.4.5.5).
use std::sync::Arc;

use raggio_scene::{Csg, Object, ObjectKind, PhotonFlags, Placed, Shape};

use super::util::{at_color, color, float32, set_flag, set32, take, word};
use super::{finish, interior, object, texture};
use crate::keyword::Kw;
use crate::parser::{Parser, Result, Tok};
use crate::value::{Kind, Material};

/// One modifier of an object.
pub fn modifier(p: &mut Parser, object: &mut Object) -> Result<bool> {
    if let Some(t) = p.allowing_undefined(Parser::accept_transform)? {
        match &mut object.kind {
            ObjectKind::Light(light) => Arc::make_mut(light).transform(&t),
            _ => object.transform(&t),
        }
        // POV-Ray's fractals forget `inverse` when they are moved.
        object.inverse &= !matches!(&object.kind, ObjectKind::Shape(s) if matches!(**s, Shape::Julia(_)));
        return Ok(true);
    }
    let key = match p.peek()? {
        Tok::Kw(key) => key,
        _ => return loose(p, object),
    };
    if flag(p, object, key)? || surface(p, object, key)? {
        return Ok(true);
    }
    match key {
        Kw::Interior => {
            p.next()?;
            object.interior = Some(Placed::new(Arc::new(interior::block(p)?)));
        }
        Kw::Clipped_by | Kw::Bounded_by => clips(p, object, key)?,
        Kw::Photons => {
            p.next()?;
            photons(p, &mut object.photons)?;
        }
        Kw::Radiosity => {
            p.next()?;
            let mut importance = 1.0;
            p.block("radiosity", |p| match word(p)? {
                Some(Kw::Importance) => set32(p, &mut importance),
                _ => Ok(false),
            })?;
            object.radiosity_importance = Some(importance);
        }
        _ => return loose(p, object),
    }
    Ok(true)
}

/// Words that switch something on or off.
fn flag(p: &mut Parser, o: &mut Object, key: Kw) -> Result<bool> {
    match key {
        Kw::Hollow => {
            p.next()?;
            o.hollow = Some(p.flag()?);
            Ok(true)
        }
        Kw::Inverse => {
            let span = p.span();
            p.next()?;
            if object::is_patch(o) {
                p.warn("inverted-patch", "cannot invert a patch object; it has no inside", span);
            }
            o.inverse = !o.inverse;
            Ok(true)
        }
        Kw::No_shadow => {
            p.next()?;
            o.no_shadow = true;
            Ok(true)
        }
        Kw::No_image => set_flag(p, &mut o.no_image),
        Kw::No_reflection => set_flag(p, &mut o.no_reflection),
        Kw::No_radiosity => set_flag(p, &mut o.no_radiosity),
        Kw::Double_illuminate => {
            p.next()?;
            let on = p.flag()?;
            set_double_illuminate(o, on);
            Ok(true)
        }
        Kw::Sturm | Kw::Hierarchy | Kw::Split_union | Kw::Cutaway_textures => limited_flag(p, o, key),
        Kw::Uv_mapping => {
            let span = p.span();
            if o.texture.is_some() {
                return p.error("late-uv-mapping", "uv_mapping must be specified before texture", span);
            }
            set_flag(p, &mut o.uv_mapping)
        }
        _ => Ok(false),
    }
}

/// Flags that only some kinds of object take.
fn limited_flag(p: &mut Parser, o: &mut Object, key: Kw) -> Result<bool> {
    let span = p.span();
    p.next()?;
    let on = p.flag()?;
    let takes = match (&mut o.kind, key) {
        (ObjectKind::Shape(shape), Kw::Sturm) => takes_sturm(shape),
        (ObjectKind::Shape(shape), Kw::Hierarchy) => {
            matches!(**shape, Shape::Blob(_) | Shape::HeightField(_) | Shape::Mesh(_))
        }
        (ObjectKind::Csg { op: Csg::Union, .. }, Kw::Split_union) => true,
        (ObjectKind::Csg { op, .. }, Kw::Cutaway_textures) => match op {
            Csg::Intersection | Csg::CutawayIntersection => {
                *op = if on { Csg::CutawayIntersection } else { Csg::Intersection };
                true
            }
            Csg::Difference { cutaway_textures } => {
                *cutaway_textures = on;
                true
            }
            Csg::Union | Csg::Merge => false,
        },
        _ => false,
    };
    match key {
        _ if !takes => {
            let message = format!("`{}` cannot be used with this object", key.word());
            return p.error("wrong-flag", message, span);
        }
        Kw::Sturm => o.sturm = on,
        Kw::Hierarchy => o.hierarchy = on,
        Kw::Split_union => o.split_union = on,
        _ => {}
    }
    Ok(true)
}

fn takes_sturm(shape: &Shape) -> bool {
    matches!(
        shape,
        Shape::Blob(_)
            | Shape::Lathe { .. }
            | Shape::Sor { .. }
            | Shape::Prism(_)
            | Shape::Torus { .. }
            | Shape::Ovus { .. }
            | Shape::Poly { .. }
            | Shape::Quadric(_)
            | Shape::Sphere { .. }
    )
}

/// The word on a CSG goes to all its members.
fn set_double_illuminate(object: &mut Object, on: bool) {
    object.double_illuminate = on;
    if let ObjectKind::Csg { children, .. } | ObjectKind::LightGroup { children, .. } = &mut object.kind {
        for child in Arc::make_mut(children) {
            set_double_illuminate(Arc::make_mut(child), on);
        }
    }
}

/// `texture`, its parts, `interior_texture`, `material`.
fn surface(p: &mut Parser, o: &mut Object, key: Kw) -> Result<bool> {
    match key {
        Kw::Texture => {
            p.next()?;
            let over = texture::block(p)?;
            interior::add_texture(p, &mut o.texture, over)?;
        }
        Kw::Interior_texture => {
            p.next()?;
            let over = texture::block(p)?;
            interior::add_texture(p, &mut o.interior_texture, over)?;
        }
        Kw::Pigment | Kw::Normal | Kw::Finish => {
            let mut whole = own_texture(p, o);
            texture::layer_part(p, &mut whole, key)?;
            o.texture = Some(Placed::new(Arc::new(whole)));
        }
        Kw::Material => {
            p.next()?;
            let Material { texture, interior_texture, interior } = interior::material(p)?;
            if let Some(over) = texture {
                interior::add_texture(p, &mut o.texture, interior::settled(over))?;
            }
            if let Some(over) = interior_texture {
                interior::add_texture(p, &mut o.interior_texture, interior::settled(over))?;
            }
            o.interior = interior.or(o.interior.take());
        }
        _ => return Ok(false),
    }
    Ok(true)
}

/// The object's texture to be modified, or a copy of the default one.
fn own_texture(p: &Parser, o: &mut Object) -> raggio_scene::Texture {
    match o.texture.take() {
        Some(placed) => interior::settled(placed),
        None => (*p.defaults.texture).clone(),
    }
}

/// Words of a finish, and colours, which stand in the object itself.
fn loose(p: &mut Parser, o: &mut Object) -> Result<bool> {
    let span = p.span();
    if p.peek()? == Tok::Value(Kind::Texture) {
        let over = take!(p, Texture);
        interior::add_texture(p, &mut o.texture, Arc::unwrap_or_clone(over))?;
        p.warn("loose-texture", "a texture's name should stand in `texture { }`", span);
        return Ok(true);
    }
    if at_color(p)? {
        color(p)?;
        p.warn("loose-color", "a quick colour belongs in a pigment; this colour is ignored", span);
        return Ok(true);
    }
    let base = match &o.texture {
        Some(_) => None,
        None => Some(p.defaults.finish()),
    };
    let mut draft = finish::Draft::new(base.unwrap_or_else(|| top_finish(o)));
    if !finish::item(p, &mut draft)? {
        return Ok(false);
    }
    let mut whole = own_texture(p, o);
    if let raggio_scene::TextureKind::Layers(layers) = &mut whole.kind
        && let Some(layer) = layers.last_mut()
    {
        layer.finish = draft.finish();
    }
    o.texture = Some(Placed::new(Arc::new(whole)));
    p.warn("loose-finish", "this word belongs in a `finish` block", span);
    Ok(true)
}

fn top_finish(o: &Object) -> raggio_scene::Finish {
    match o.texture.as_ref().map(|placed| &placed.item.kind) {
        Some(raggio_scene::TextureKind::Layers(layers)) => {
            layers.last().map(|l| l.finish).unwrap_or_default()
        }
        _ => raggio_scene::Finish::default(),
    }
}

/// `clipped_by { objects }`, `bounded_by { objects }`, and either of them taking over the other's list.
fn clips(p: &mut Parser, o: &mut Object, key: Kw) -> Result<()> {
    p.next()?;
    let other = if key == Kw::Clipped_by { Kw::Bounded_by } else { Kw::Clipped_by };
    let (mut linked, mut objects) = (false, Vec::<Arc<Object>>::new());
    p.block(key.word(), |p| {
        if objects.is_empty() && p.accept(other)? {
            linked = true;
            return Ok(true);
        }
        // A transform after the objects moves them all.
        if !objects.is_empty()
            && let Some(t) = p.accept_transform()?
        {
            objects.iter_mut().for_each(|object| Arc::make_mut(object).transform(&t));
            return Ok(true);
        }
        let object = match p.peek()? {
            Tok::Value(Kind::Object) => take!(p, Object),
            _ => match object::any(p)? {
                Some(object) => Arc::new(object),
                None => return Ok(false),
            },
        };
        object::refuse_patch(p, &object)?;
        objects.push(object);
        Ok(true)
    })?;
    match (key, linked) {
        (Kw::Clipped_by, true) => o.clips = o.bounds.clone(),
        (Kw::Clipped_by, false) => o.clips.extend(objects),
        (_, true) => o.bounds = o.clips.clone(),
        (_, false) => o.bounds.extend(objects),
    }
    Ok(())
}

/// `photons { ... }` of an object; the word has been read.
fn photons(p: &mut Parser, flags: &mut PhotonFlags) -> Result<()> {
    p.block("photons", |p| match word(p)? {
        Some(key) => photon_item(p, flags, key),
        None => Ok(false),
    })
}

fn photon_item(p: &mut Parser, f: &mut PhotonFlags, key: Kw) -> Result<bool> {
    match key {
        Kw::Target => {
            p.next()?;
            let density = if p.at_expression()? { float32(p)? } else { 1.0 };
            f.target = (density > 0.0).then_some(density);
            if conflict(f) {
                match f.refraction {
                    Some(true) => f.pass_through = false,
                    _ => f.refraction = Some(false),
                }
            }
        }
        Kw::Reflection => {
            p.next()?;
            f.reflection = Some(p.flag()?);
        }
        Kw::Refraction => {
            p.next()?;
            f.refraction = Some(p.flag()?);
            if conflict(f) {
                f.pass_through = false;
            }
        }
        Kw::Pass_through => {
            p.next()?;
            f.pass_through = p.flag()?;
            if conflict(f) {
                f.refraction = Some(false);
            }
        }
        Kw::Collect => {
            p.next()?;
            f.collect = Some(p.flag()?);
        }
        _ => return Ok(false),
    }
    Ok(true)
}

/// A target that refracts cannot let photons pass; the word written last wins.
fn conflict(f: &PhotonFlags) -> bool {
    f.pass_through && f.target.is_some() && f.refraction != Some(false)
}
