//! Surfaces given by functions (shapes spec, section 7).
use raggio_math::{Vec2, Vec3};
use raggio_scene::{Container, Isosurface, IsosurfaceEvaluate, Object, Parametric, Shape};

use super::function::after_word_or_identifier;
use super::object;
use super::util::{comma_float, comma_vec3, float, set, vec2, vec3, word};
use crate::keyword::Kw;
use crate::parser::{Parser, Result};

const UNIT: Container = Container::Box { min: Vec3::NEG_ONE, max: Vec3::ONE };

/// `isosurface { function { } items }`
pub fn isosurface(p: &mut Parser) -> Result<Object> {
    object::shape(p, "isosurface", |p| {
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
        while iso_item(p, &mut iso)? {}
        Ok(Shape::Isosurface(Box::new(mended(p, iso))))
    })
}

fn iso_item(p: &mut Parser, iso: &mut Isosurface) -> Result<bool> {
    match word(p)? {
        Some(Kw::Contained_by) => iso.container = container(p)?,
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

/// `contained_by { box { a, b } }` or `contained_by { sphere { c, r } }`
fn container(p: &mut Parser) -> Result<Container> {
    p.next()?;
    p.expect('{')?;
    let container = if p.accept(Kw::Box)? {
        p.expect('{')?;
        let (a, b) = (vec3(p)?, comma_vec3(p)?);
        Container::Box { min: a.min(b), max: a.max(b) }
    } else if p.accept(Kw::Sphere)? {
        p.expect('{')?;
        Container::Sphere { center: vec3(p)?, radius: comma_float(p)?.abs() }
    } else {
        return p.expected("`box` or `sphere`");
    };
    p.expect('}')?;
    p.expect('}')?;
    Ok(container)
}

/// `parametric { function { x } function { y } function { z } <u, v>, <u, v> items }`
pub fn parametric(p: &mut Parser) -> Result<Object> {
    object::shape(p, "parametric", |p| {
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
        while parametric_item(p, &mut parametric)? {}
        Ok(Shape::Parametric(Box::new(parametric)))
    })
}

fn parametric_item(p: &mut Parser, surface: &mut Parametric) -> Result<bool> {
    match word(p)? {
        Some(Kw::Contained_by) => surface.container = container(p)?,
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
