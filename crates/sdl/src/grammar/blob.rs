//! `blob { ... }` (shapes spec, section 4).
use std::sync::Arc;

use raggio_math::{Affine, EPS};
use raggio_scene::{Blob, BlobComponent, BlobShape, Object, Placed, Shape, Texture};

use super::object;
use super::util::{comma_float, comma_vec3, set, vec3, word};
use super::{interior, texture};
use crate::keyword::Kw;
use crate::parser::{Parser, Result};

/// `blob { [threshold t] components }`
pub fn blob(p: &mut Parser) -> Result<Object> {
    object::shape(p, "blob", |p| {
        let span = p.span();
        let mut blob = Blob { threshold: 1.0, components: Vec::new() };
        while item(p, &mut blob)? {}
        if blob.components.is_empty() {
            return p.error("empty-blob", "need at least one component in a blob", span);
        }
        Ok(Shape::Blob(Arc::new(blob)))
    })
}

fn item(p: &mut Parser, blob: &mut Blob) -> Result<bool> {
    match word(p)? {
        Some(Kw::Threshold) => return set(p, &mut blob.threshold),
        Some(Kw::Component) => {
            p.next()?;
            let (strength, radius) = (super::util::float(p)?, comma_float(p)?);
            let center = comma_vec3(p)?;
            add(blob, component(BlobShape::Sphere { center, radius: radius.abs() }, strength));
        }
        Some(Kw::Sphere) => {
            p.next()?;
            p.expect('{')?;
            let (center, radius) = (vec3(p)?, comma_float(p)?.abs());
            let sphere = with_modifiers(p, BlobShape::Sphere { center, radius })?;
            add(blob, sphere);
        }
        Some(Kw::Cylinder) => {
            p.next()?;
            p.expect('{')?;
            let span = p.span();
            let (base, cap, radius) = (vec3(p)?, comma_vec3(p)?, comma_float(p)?.abs());
            if (cap - base).length() < EPS {
                return p.error("degenerate-component", "degenerate cylindrical component in blob", span);
            }
            let cylinder = with_modifiers(p, BlobShape::Cylinder { base, cap, radius })?;
            add(blob, cylinder);
        }
        _ => return p.accept_punct(','),
    }
    Ok(true)
}

/// Adds a component unless its field is empty.
fn add(blob: &mut Blob, component: BlobComponent) {
    let (BlobShape::Sphere { radius, .. } | BlobShape::Cylinder { radius, .. }) = component.shape;
    if radius > 0.0 || blob.components.is_empty() {
        blob.components.push(component);
    }
}

fn component(shape: BlobShape, strength: f64) -> BlobComponent {
    BlobComponent { shape, strength, blob_from_component: Affine::IDENTITY, texture: None }
}

/// `[, [strength] s] modifiers }`
fn with_modifiers(p: &mut Parser, shape: BlobShape) -> Result<BlobComponent> {
    let mut component = component(shape, 1.0);
    p.comma()?;
    p.accept(Kw::Strength)?;
    if p.at_expression()? {
        component.strength = super::util::float(p)?;
    }
    super::util::until(p, '}', "a blob's component", |p| component_item(p, &mut component))?;
    Ok(component)
}

fn component_item(p: &mut Parser, c: &mut BlobComponent) -> Result<bool> {
    if let Some(t) = p.accept_transform()? {
        c.blob_from_component = t * c.blob_from_component;
        if let Some(texture) = &mut c.texture {
            texture.transform(&t);
        }
        return Ok(true);
    }
    match word(p)? {
        Some(Kw::Strength) => set(p, &mut c.strength),
        Some(Kw::Texture) => {
            p.next()?;
            let over = texture::block(p)?;
            interior::add_texture(p, &mut c.texture, over)?;
            Ok(true)
        }
        Some(part @ (Kw::Pigment | Kw::Normal | Kw::Finish)) => {
            let mut whole: Texture = match c.texture.take() {
                Some(placed) => interior::settled(placed),
                None => (*p.defaults.texture).clone(),
            };
            texture::layer_part(p, &mut whole, part)?;
            c.texture = Some(Placed::new(Arc::new(whole)));
            Ok(true)
        }
        _ => Ok(false),
    }
}
