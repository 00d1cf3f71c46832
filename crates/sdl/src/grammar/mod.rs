//! The grammar: one file a block of the language.
//!
//! Each file reads its block from the token stream of the parser, in which directives and macros have already happened,
//! and makes the waist's data of it. `Draft` is everywhere a thing that is not complete yet: it begins as a copy of a
//! default or of an identifier's value, items change it, and `finish` makes the immutable result.

mod atmosphere;
mod blob;
mod camera;
mod csg;
mod curves;
mod default_map;
pub(crate) mod defaults;
mod finish;
mod font;
pub(crate) mod function;
mod function_expr;
mod height_field;
mod image;
mod interior;
mod isosurface;
mod julia;
mod kern;
mod light;
mod loose;
mod maps;
mod media;
mod mesh;
mod mesh2;
mod modifiers;
mod normal;
mod nurbs;
mod object;
mod old_layers;
mod patch;
mod pattern;
mod pattern_kind;
mod pigment;
mod poly;
mod prism;
mod quadrics;
mod settings;
mod spline;
mod text;
mod texture;
mod triangles;
mod util;
mod warp;

use std::sync::Arc;

use raggio_scene::{Object, ObjectKind, Shape};

pub use defaults::Defaults;

use crate::keyword::Kw;
use crate::parser::{Parser, Result};
use crate::value::Value;

/// One statement of the scene; false if none begins here.
pub(crate) fn statement(p: &mut Parser) -> Result<bool> {
    let span = p.span();
    if let Some(object) = object::any_or_identifier(p)? {
        add(p, object);
        return Ok(true);
    }
    match util::word(p)? {
        Some(Kw::Camera) => {
            p.next()?;
            let camera = camera::block(p)?;
            if p.scene.camera.is_some() {
                p.warn("second-camera", "only one camera counts; this one replaces the one before", span);
            }
            p.scene.camera = Some(camera);
            Ok(true)
        }
        Some(Kw::Global_settings) => {
            p.next()?;
            settings::block(p)?;
            Ok(true)
        }
        Some(_) => Ok(atmosphere::statement(p)? || settings::loose(p)?),
        None => Ok(false),
    }
}

/// Links a finished object to the scene.
fn add(p: &mut Parser, mut object: Object) {
    let default = p.defaults.texture.clone();
    match &object.kind {
        ObjectKind::Light(_) => {}
        ObjectKind::Shape(shape) => {
            if !keeps_bounds(shape) {
                object.bounds.clear();
            }
            object::apply_default_texture(&mut object, &default);
        }
        ObjectKind::Csg { .. } | ObjectKind::LightGroup { .. } => {
            object::apply_default_texture(&mut object, &default);
        }
    }
    p.scene.objects.push(Arc::new(object));
}

/// Simple top-level shapes lose their bounds, which could only cut them.
fn keeps_bounds(shape: &Shape) -> bool {
    matches!(shape, Shape::Poly { .. } | Shape::Quadric(_))
}

/// The value of a block on the right side of a declaration; `None` if no block of the grammar begins here.
pub(crate) fn declared_value(p: &mut Parser) -> Result<Option<Value>> {
    if let Some(texture) = texture::layers(p)? {
        return Ok(Some(Value::Texture(Arc::new(texture))));
    }
    if let Some(object) = object::any(p)? {
        return Ok(Some(Value::Object(Arc::new(object))));
    }
    let Some(key) = util::word(p)? else { return Ok(None) };
    if key == Kw::Transform {
        return Ok(p.accept_transform()?.map(|t| Value::Transform(Box::new(t))));
    }
    if !is_declarable(key) {
        return Ok(None);
    }
    p.next()?;
    block_value(p, key).map(Some)
}

fn is_declarable(key: Kw) -> bool {
    matches!(
        key,
        Kw::Pigment
            | Kw::Normal
            | Kw::Finish
            | Kw::Material
            | Kw::Interior
            | Kw::Media
            | Kw::Density
            | Kw::Color_map
            | Kw::Colour_map
            | Kw::Pigment_map
            | Kw::Normal_map
            | Kw::Texture_map
            | Kw::Density_map
            | Kw::Slope_map
            | Kw::Camera
            | Kw::Fog
            | Kw::Rainbow
            | Kw::Sky_sphere
    )
}

/// The value of the block whose word has been read; one of those that [`is_declarable`] names.
fn block_value(p: &mut Parser, key: Kw) -> Result<Value> {
    Ok(match key {
        Kw::Pigment => {
            let base = p.defaults.pigment();
            Value::Pigment(pigment::block(p, &base)?)
        }
        Kw::Normal => {
            let base = p.defaults.normal();
            Value::Normal(normal::block(p, base.as_deref())?.unwrap_or_else(normal::flat))
        }
        Kw::Finish => {
            let base = p.defaults.finish();
            Value::Finish(Arc::new(finish::block(p, base)?))
        }
        Kw::Material => Value::Material(Arc::new(interior::material(p)?)),
        Kw::Interior => Value::Interior(Arc::new(interior::block(p)?)),
        Kw::Media => Value::Media(Arc::new(media::block(p)?)),
        Kw::Density => Value::Density(Arc::new(pigment::density(p)?)),
        Kw::Color_map | Kw::Colour_map => Value::ColorMap(maps::color_map(p)?),
        Kw::Pigment_map => Value::PigmentMap(pigment::pigment_map(p)?),
        Kw::Normal_map => Value::NormalMap(normal::normal_map(p)?),
        Kw::Texture_map => Value::TextureMap(texture::texture_map(p)?),
        Kw::Density_map => Value::DensityMap(pigment::density_map(p)?),
        Kw::Slope_map => Value::SlopeMap(maps::slope_map(p)?),
        Kw::Camera => Value::Camera(Arc::new(camera::block(p)?)),
        Kw::Fog => Value::Fog(Arc::new(atmosphere::fog(p)?)),
        Kw::Rainbow => Value::Rainbow(Arc::new(atmosphere::rainbow(p)?)),
        _ => Value::SkySphere(Arc::new(atmosphere::sky_sphere(p)?)),
    })
}
