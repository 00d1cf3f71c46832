//! Surfaces of revolution and sphere sweeps (shapes spec, section 5).
use raggio_diag::Span;
use raggio_math::{EPS, Vec2};
use raggio_scene::{Object, Shape, SplineKind, SweepSphere};

use super::object;
use super::spline;
use super::util::{comma_float, comma_vec3, float, vec2, word};
use crate::keyword::Kw;
use crate::parser::{Parser, Result};

/// Most control points of a curve.
const MOST_POINTS: i64 = 1 << 24;

/// `n, point, point ...`
pub fn counted_points(p: &mut Parser) -> Result<Vec<Vec2>> {
    let n = p.int("number of points", 0..=MOST_POINTS)?;
    let mut points = Vec::new();
    for _ in 0..n {
        p.comma()?;
        points.push(vec2(p)?);
    }
    Ok(points)
}

/// `lathe { [kind] n, points }`
pub fn lathe(p: &mut Parser) -> Result<Object> {
    object::shape(p, "lathe", |p| {
        let span = p.span();
        let mut kind = SplineKind::Linear;
        if let Some(named) = word(p)?.and_then(spline::kind).filter(|&k| k != SplineKind::BSpline) {
            p.next()?;
            kind = named;
        }
        let points = counted_points(p)?;
        check_lathe(p, kind, &points, span)?;
        Ok(Shape::Lathe { curves: spline::pieces(kind, &points).into(), kind })
    })
}

fn check_lathe(p: &Parser, kind: SplineKind, points: &[Vec2], span: Span) -> Result<()> {
    let n = points.len();
    let fault = match kind {
        SplineKind::Linear if n < 2 => "a lathe with linear splines must have at least two points",
        SplineKind::Quadratic if n < 3 => "a lathe with quadratic splines must have at least three points",
        SplineKind::Cubic if n < 4 => "a lathe with cubic splines must have at least four points",
        SplineKind::Bezier if n < 4 || !n.is_multiple_of(4) => {
            "a lathe with Bezier splines must have four points per segment"
        }
        _ if points[1..n - 1].iter().any(|point| point.x < 0.0) => {
            "incorrect point in lathe: a radius cannot be negative"
        }
        _ => return Ok(()),
    };
    p.error("bad-lathe", fault, span)
}

/// `sor { n, points [open] }`
pub fn sor(p: &mut Parser) -> Result<Object> {
    object::shape(p, "sor", |p| {
        let span = p.span();
        let points = counted_points(p)?;
        let open = p.accept(Kw::Open)?;
        let n = points.len();
        if n < 4 {
            return p.error("bad-sor", "a surface of revolution must have at least four points", span);
        }
        let falls = points[1..n - 1].windows(2).any(|pair| pair[1].y <= pair[0].y);
        let level = points.windows(3).any(|three| (three[2].y - three[0].y).abs() < EPS);
        if falls || level || points.iter().any(|point| point.x < 0.0) {
            let message =
                "incorrect point in surface of revolution: radii cannot be negative and heights must rise";
            return p.error("bad-sor", message, span);
        }
        Ok(Shape::Sor { points: points.into(), open })
    })
}

/// `sphere_sweep { kind n, center, radius ... [tolerance t] }`
pub fn sphere_sweep(p: &mut Parser) -> Result<Object> {
    object::shape(p, "sphere_sweep", |p| {
        let span = p.span();
        let kind = match word(p)?.and_then(spline::kind) {
            Some(kind @ (SplineKind::Linear | SplineKind::Cubic | SplineKind::BSpline)) => kind,
            _ => return p.expected("`linear_spline`, `cubic_spline` or `b_spline`"),
        };
        p.next()?;
        p.comma()?;
        let n = p.int("number of spheres", 0..=MOST_POINTS)?;
        if n < if kind == SplineKind::Linear { 2 } else { 4 } {
            return p.error("bad-sweep", "too few modeling spheres for this kind of spline", span);
        }
        let mut spheres = Vec::new();
        for _ in 0..n {
            spheres.push(SweepSphere { center: comma_vec3(p)?, radius: comma_float(p)? });
        }
        p.comma()?;
        let tolerance = if p.accept(Kw::Tolerance)? { float(p)? } else { 1e-6 };
        Ok(Shape::SphereSweep { kind, spheres: spheres.into(), tolerance })
    })
}
