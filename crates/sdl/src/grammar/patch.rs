//! `bicubic_patch { ... }` (shapes spec, section 3).
use std::sync::Arc;

use raggio_math::{Vec2, Vec3};
use raggio_scene::{Knots, Nurbs, Object, Shape};

use super::object;
use super::util::{comma_float, comma_vec3, count, float, set, set_flag, vec2, word};
use crate::keyword::Kw;
use crate::parser::{Parser, Result, Tok};

/// Deeper subdivision than this would not end; the language has no limit.
const MOST_STEPS: u32 = 12;

struct Head {
    patch_type: Option<i64>,
    /// An addition to the language: hit directly, without facets.
    smooth: bool,
    flatness: f64,
    u_steps: u32,
    v_steps: u32,
    uv: [Vec2; 4],
}

const CORNERS: [Vec2; 4] = [Vec2::ZERO, Vec2::X, Vec2::ONE, Vec2::Y];

/// `bicubic_patch { type t [smooth] flatness f u_steps u v_steps v 16 points }`
pub fn bicubic_patch(p: &mut Parser) -> Result<Object> {
    object::shape(p, "bicubic_patch", |p| {
        let span = p.span();
        let mut head =
            Head { patch_type: None, smooth: false, flatness: 0.0, u_steps: 0, v_steps: 0, uv: CORNERS };
        while head_item(p, &mut head)? {}
        let patch_type = match head.patch_type {
            Some(t @ 0..=1) => t as u8,
            Some(2..) => {
                p.warn("old-patch", "this patch type is no longer supported; using type 1", span);
                1
            }
            _ => {
                return p.error("bad-patch", "undefined bicubic patch type: give `type 0` or `type 1`", span);
            }
        };
        let mut points = Box::new([[Vec3::ZERO; 4]; 4]);
        for point in points.iter_mut().flatten() {
            *point = comma_vec3(p)?;
        }
        let Head { flatness, u_steps, v_steps, uv, .. } = head;
        if head.smooth {
            if uv != CORNERS {
                return p.error("bad-patch", "a smooth bicubic_patch takes no uv_vectors", span);
            }
            return Ok(Shape::Nurbs(Arc::new(surface(&points))));
        }
        Ok(Shape::BicubicPatch { patch_type, flatness, u_steps, v_steps, points, uv: Box::new(uv) })
    })
}

/// The patch as a spline surface of one piece.
fn surface(points: &[[Vec3; 4]; 4]) -> Nurbs {
    let knots = Knots { degree: 3, knots: vec![0., 0., 0., 0., 1., 1., 1., 1.] };
    let points = points.iter().flatten().map(|&point| (point, 1.0)).collect();
    Nurbs { u: knots.clone(), v: knots, points, trims: Vec::new() }
}

fn head_item(p: &mut Parser, head: &mut Head) -> Result<bool> {
    match word(p)? {
        Some(Kw::Type) => {
            p.next()?;
            head.patch_type = Some(float(p)? as i64);
        }
        Some(Kw::Smooth) => {
            set_flag(p, &mut head.smooth)?;
        }
        Some(Kw::Flatness) => {
            set(p, &mut head.flatness)?;
        }
        Some(Kw::U_steps) => {
            p.next()?;
            head.u_steps = count(p, 0, MOST_STEPS)?;
        }
        Some(Kw::V_steps) => {
            p.next()?;
            head.v_steps = count(p, 0, MOST_STEPS)?;
        }
        Some(Kw::Uv_vectors) => {
            p.next()?;
            for uv in &mut head.uv {
                p.comma()?;
                *uv = vec2(p)?;
            }
        }
        _ if p.accept_punct(',')? => {}
        _ if head.patch_type.is_none() && matches!(p.peek()?, Tok::Number(_)) => old_head(p, head)?,
        _ => return Ok(false),
    }
    Ok(true)
}

/// Bare numbers: type, flatness for types 2 and 3, steps along u and v.
fn old_head(p: &mut Parser, head: &mut Head) -> Result<()> {
    let span = p.span();
    p.warn("old-patch", "the numbers of a bicubic_patch should have their words", span);
    let patch_type = float(p)? as i64;
    head.patch_type = Some(patch_type);
    if matches!(patch_type, 2 | 3) {
        head.flatness = comma_float(p)?;
    }
    p.comma()?;
    head.u_steps = count(p, 0, MOST_STEPS)?;
    p.comma()?;
    head.v_steps = count(p, 0, MOST_STEPS)?;
    Ok(())
}
