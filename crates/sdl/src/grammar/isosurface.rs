//! Surfaces given by functions (shapes spec, section 7).
use std::sync::Arc;

use raggio_math::{Affine, Vec2, Vec3};
use raggio_scene::{Container, Csg, Isosurface, IsosurfaceEvaluate, Object, ObjectKind, Parametric, Shape};

use super::function::after_word_or_identifier;
use super::object;
use super::util::{comma_float, float, set, vec2, word};
use crate::keyword::Kw;
use crate::parser::{Parser, Result};

const UNIT: Container = Container::Box { min: Vec3::NEG_ONE, max: Vec3::ONE };

/// `isosurface { function { } items }`
pub fn isosurface(p: &mut Parser) -> Result<Object> {
    object::build(p, "isosurface", |p| {
        let Some(function) = after_word_or_identifier(p)? else { return p.expected("`function`") };
        let mut iso = Isosurface {
            function,
            container: UNIT,
            threshold: 0.0,
            accuracy: 0.001,
            max_gradient: 1.1,
            evaluate: None,
            max_trace: 1,
            open: false,
        };
        let mut solid = None;
        while iso_item(p, &mut iso, &mut solid)? {}
        let open = iso.open;
        iso.open |= solid.is_some();
        let surface = object::of_shape(Shape::Isosurface(Box::new(mended(p, iso))));
        Ok(match solid {
            Some(solid) => contained(surface, solid, open),
            None => surface,
        })
    })
}

/// The part of a surface that lies within a solid. The solid's own surface closes it unless it is to stay open.
fn contained(mut surface: Object, solid: Arc<Object>, open: bool) -> Object {
    if open {
        surface.clips.push(solid);
        return surface;
    }
    Object::new(ObjectKind::Csg { op: Csg::Intersection, children: Arc::new(vec![Arc::new(surface), solid]) })
}

fn iso_item(p: &mut Parser, iso: &mut Isosurface, solid: &mut Option<Arc<Object>>) -> Result<bool> {
    match word(p)? {
        Some(Kw::Contained_by) => (iso.container, *solid) = container(p)?,
        Some(Kw::Threshold) => return set(p, &mut iso.threshold),
        Some(Kw::Accuracy) => return set(p, &mut iso.accuracy),
        Some(Kw::Max_gradient) => return set(p, &mut iso.max_gradient),
        Some(Kw::Evaluate) => {
            p.next()?;
            let (minimum, increase, decrease) = (float(p)?, comma_float(p)?, comma_float(p)?);
            iso.evaluate = Some(IsosurfaceEvaluate { minimum, increase, decrease });
        }
        Some(Kw::Max_trace) => {
            p.next()?;
            iso.max_trace = float(p)?.clamp(1.0, 10.0) as u32;
        }
        Some(Kw::All_intersections) => {
            p.next()?;
            iso.max_trace = 10;
        }
        Some(Kw::Open) => {
            p.next()?;
            iso.open = true;
        }
        _ => return p.accept_punct(','),
    }
    Ok(true)
}

/// Numbers that make no sense are replaced by the defaults.
fn mended(p: &mut Parser, mut iso: Isosurface) -> Isosurface {
    let span = p.span();
    if iso.accuracy <= 0.0 {
        p.warn("bad-isosurface", "accuracy must be positive; 0.001 is used", span);
        iso.accuracy = 0.001;
    }
    if iso.max_gradient <= 0.0 {
        p.warn("bad-isosurface", "max_gradient must be positive; 1.1 is used", span);
        iso.max_gradient = 1.1;
    }
    iso
}

/// `contained_by { box { a, b } }`, `contained_by { sphere { c, r } }` or, an addition to the language, any bounded
/// solid: it comes with the box around it.
fn container(p: &mut Parser) -> Result<(Container, Option<Arc<Object>>)> {
    p.next()?;
    p.expect('{')?;
    let Some(object) = object::any_or_identifier(p)? else {
        return p.expected("`box`, `sphere` or another bounded solid");
    };
    let span = p.span();
    p.expect('}')?;
    if object.parent_from_object == Affine::IDENTITY
        && let ObjectKind::Shape(shape) = &object.kind
    {
        match *shape.as_ref() {
            Shape::Box { min, max } => return Ok((Container::Box { min, max }, None)),
            Shape::Sphere { center, radius } => {
                return Ok((Container::Sphere { center, radius: radius.abs() }, None));
            }
            _ => {}
        }
    }
    let object = Arc::new(object);
    let bounds = p.bounds(&object);
    if object.inverse || !bounds.is_finite() || bounds.is_empty() || object::is_patch(&object) {
        return p.error("bad-container", "what contains a surface must be a bounded solid", span);
    }
    // Larger than the solid, so that no side of the box lies in a side of the solid.
    let margin = 0.01 * bounds.size();
    Ok((Container::Box { min: bounds.min - margin, max: bounds.max + margin }, Some(object)))
}

/// `parametric { function { x } function { y } function { z } <u, v>, <u, v> items }`
pub fn parametric(p: &mut Parser) -> Result<Object> {
    object::build(p, "parametric", |p| {
        let mut functions = Vec::new();
        while functions.len() < 3 {
            match after_word_or_identifier(p)? {
                Some(function) => functions.push(function),
                None => return p.expected("three functions: of x, of y and of z"),
            }
            p.comma()?;
        }
        let [fx, fy, fz] = &functions[..] else { return p.expected("three functions") };
        let a = vec2(p)?;
        p.comma()?;
        let b = vec2(p)?;
        let mut parametric = Parametric {
            functions: [fx.clone(), fy.clone(), fz.clone()],
            uv_min: Vec2::min(a, b),
            uv_max: Vec2::max(a, b),
            container: UNIT,
            max_gradient: 1.0,
            accuracy: 0.001,
            precompute_depth: 0,
        };
        let mut solid = None;
        while parametric_item(p, &mut parametric, &mut solid)? {}
        let mut surface = object::of_shape(Shape::Parametric(Box::new(parametric)));
        surface.clips.extend(solid);
        Ok(surface)
    })
}

fn parametric_item(
    p: &mut Parser,
    surface: &mut Parametric,
    solid: &mut Option<Arc<Object>>,
) -> Result<bool> {
    match word(p)? {
        Some(Kw::Contained_by) => (surface.container, *solid) = container(p)?,
        Some(Kw::Accuracy) => return set(p, &mut surface.accuracy),
        Some(Kw::Max_gradient) => return set(p, &mut surface.max_gradient),
        Some(Kw::Precompute) => {
            p.next()?;
            surface.precompute_depth = p.int("precompute depth", 1..=20)? as u32;
            while matches!(word(p)?, Some(Kw::X | Kw::Y | Kw::Z)) || p.accept_punct(',')? {
                if word(p)?.is_some_and(|axis| matches!(axis, Kw::X | Kw::Y | Kw::Z)) {
                    p.next()?;
                }
            }
        }
        _ => return p.accept_punct(','),
    }
    Ok(true)
}
