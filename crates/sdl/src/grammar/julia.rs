//! `julia_fractal { ... }` (shapes spec, section 4).
use raggio_math::EPS;
use raggio_scene::{Julia, JuliaAlgebra, JuliaFunction, Object, Shape};

use super::object;
use super::util::{comma_float, count, float, set, vec4, word};
use crate::keyword::Kw;
use crate::parser::{Parser, Result};

/// `julia_fractal { <parameter> items }`
pub fn julia_fractal(p: &mut Parser) -> Result<Object> {
    let object = object::shape(p, "julia_fractal", |p| {
        let span = p.span();
        let mut julia = Julia {
            parameter: vec4(p)?,
            algebra: JuliaAlgebra::Quaternion,
            function: JuliaFunction::Sqr,
            max_iteration: 20,
            precision: 20.0,
            slice: [0.0, 0.0, 0.0, 1.0],
            slice_distance: 0.0,
        };
        while item(p, &mut julia)? {}
        let simple = matches!(julia.function, JuliaFunction::Sqr | JuliaFunction::Cube);
        if julia.algebra == JuliaAlgebra::Quaternion && !simple {
            return p.error("bad-julia", "illegal function: quaternion only supports sqr and cube", span);
        }
        julia.precision = julia.precision.max(1.0);
        Ok(Shape::Julia(Box::new(julia)))
    })?;
    // POV-Ray takes no notice of `inverse` among a fractal's own modifiers; around it, in `object { }`, it counts.
    Ok(Object { inverse: false, ..object })
}

fn item(p: &mut Parser, julia: &mut Julia) -> Result<bool> {
    let Some(key) = word(p)? else { return p.accept_punct(',') };
    match key {
        Kw::Quaternion | Kw::Hypercomplex => {
            p.next()?;
            julia.algebra =
                if key == Kw::Quaternion { JuliaAlgebra::Quaternion } else { JuliaAlgebra::Hypercomplex };
        }
        Kw::Max_iteration => {
            p.next()?;
            julia.max_iteration = count(p, 1, 1 << 20)?;
        }
        Kw::Precision => return set(p, &mut julia.precision),
        Kw::Slice => {
            p.next()?;
            slice(p, julia)?;
        }
        Kw::Pwr => {
            p.next()?;
            p.expect('(')?;
            julia.function = JuliaFunction::Pwr(float(p)?, comma_float(p)?);
            p.expect(')')?;
        }
        _ => match function(key) {
            Some(function) => {
                p.next()?;
                julia.function = function;
            }
            None => return Ok(false),
        },
    }
    Ok(true)
}

/// `slice <normal>, distance`; the normal is made of unit length.
fn slice(p: &mut Parser, julia: &mut Julia) -> Result<()> {
    let span = p.span();
    let normal = vec4(p)?;
    julia.slice_distance = comma_float(p)?;
    let length = normal.iter().map(|c| c * c).sum::<f64>().sqrt();
    if length < EPS {
        return p.error("bad-julia", "slice vector is zero", span);
    }
    julia.slice = normal.map(|c| c / length);
    if julia.slice[3].abs() < EPS {
        return p.error("bad-julia", "slice t component is zero", span);
    }
    Ok(())
}

fn function(key: Kw) -> Option<JuliaFunction> {
    Some(match key {
        Kw::Sqr => JuliaFunction::Sqr,
        Kw::Cube => JuliaFunction::Cube,
        Kw::Exp => JuliaFunction::Exp,
        Kw::Reciprocal => JuliaFunction::Reciprocal,
        Kw::Sin => JuliaFunction::Sin,
        Kw::Asin => JuliaFunction::Asin,
        Kw::Sinh => JuliaFunction::Sinh,
        Kw::Asinh => JuliaFunction::Asinh,
        Kw::Cos => JuliaFunction::Cos,
        Kw::Acos => JuliaFunction::Acos,
        Kw::Cosh => JuliaFunction::Cosh,
        Kw::Acosh => JuliaFunction::Acosh,
        Kw::Tan => JuliaFunction::Tan,
        Kw::Atan => JuliaFunction::Atan,
        Kw::Tanh => JuliaFunction::Tanh,
        Kw::Atanh => JuliaFunction::Atanh,
        Kw::Ln => JuliaFunction::Ln,
        _ => return None,
    })
}
