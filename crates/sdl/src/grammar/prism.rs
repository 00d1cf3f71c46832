//! `prism { ... }` (shapes spec, section 5).
use std::sync::Arc;

use raggio_diag::Span;
use raggio_math::{EPS, Vec2};
use raggio_scene::{Curve2, Object, Prism, Shape, SplineKind};

use super::curves::counted_points;
use super::object::{self, nothing, of_shape};
use super::spline;
use super::util::{comma_float, float, word};
use crate::keyword::Kw;
use crate::parser::{Parser, Result};

/// `prism { [sweep] [kind] h1, h2, n, points [open] }`
pub fn prism(p: &mut Parser) -> Result<Object> {
    object::build(p, "prism", |p| {
        let span = p.span();
        let (mut conic, mut kind) = (false, SplineKind::Linear);
        while let Some(key) = word(p)? {
            match (key, spline::kind(key)) {
                (Kw::Linear_sweep, _) => conic = false,
                (Kw::Conic_sweep, _) => conic = true,
                (_, Some(named)) if named != SplineKind::BSpline => kind = named,
                _ => break,
            }
            p.next()?;
        }
        let (a, b) = (float(p)?, comma_float(p)?);
        p.comma()?;
        let points = counted_points(p)?;
        p.comma()?;
        let open = p.accept(Kw::Open)?;
        check_count(p, kind, points.len(), span)?;
        let (curves, closed) = outline(kind, &points);
        match (closed, kind) {
            (true, _) => {}
            (false, SplineKind::Linear) => {
                p.warn("open-prism", "this linear prism is not closed; closing it", span);
            }
            (false, _) => {
                p.warn("open-prism", "this prism is not closed; ignoring it", span);
                return Ok(nothing());
            }
        }
        let heights = (a.min(b), a.max(b));
        Ok(of_shape(Shape::Prism(Arc::new(Prism { conic, heights, curves, open }))))
    })
}

fn check_count(p: &Parser, kind: SplineKind, n: usize, span: Span) -> Result<()> {
    let fault = match kind {
        SplineKind::Linear if n < 3 => "a prism with linear splines must have at least three points",
        SplineKind::Quadratic if n < 5 => "a prism with quadratic splines must have at least five points",
        SplineKind::Cubic if n < 6 => "a prism with cubic splines must have at least six points",
        SplineKind::Bezier if n < 4 || !n.is_multiple_of(4) => {
            "a prism with Bezier splines must have four points per segment"
        }
        _ => return Ok(()),
    };
    p.error("bad-prism", fault, span)
}

/// The pieces of all loops together, and whether the last loop was closed.
fn outline(kind: SplineKind, points: &[Vec2]) -> (Vec<Curve2>, bool) {
    match kind {
        SplineKind::Linear => linear_loops(points),
        SplineKind::Quadratic => led_loops(kind, points, 0),
        SplineKind::Cubic | SplineKind::BSpline => led_loops(kind, points, 1),
        SplineKind::Bezier => bezier_loops(points),
    }
}

fn same(a: Vec2, b: Vec2) -> bool {
    (a - b).abs().max_element() < EPS
}

/// Each loop runs until a point repeats its first; an open last one is closed.
fn linear_loops(points: &[Vec2]) -> (Vec<Curve2>, bool) {
    let (mut curves, mut start, mut closed) = (Vec::new(), 0, true);
    for i in 1..points.len() {
        if start == i {
            closed = false;
            continue;
        }
        curves.push(spline::line(points[i - 1], points[i]));
        closed = same(points[i], points[start]);
        if closed {
            start = i + 1;
        }
    }
    if let (false, Some(&last), Some(&first)) = (closed, points.last(), points.get(start)) {
        curves.push(spline::line(last, first));
    }
    (curves, closed)
}

/// Loops of a lead-in point, the points from the first back to the first, and `lead_out` points that only steer. What is
/// left after the last such loop is nothing.
fn led_loops(kind: SplineKind, points: &[Vec2], lead_out: usize) -> (Vec<Curve2>, bool) {
    let (mut curves, mut rest) = (Vec::new(), points);
    while rest.len() > 1 {
        let first = rest[1];
        let Some(length) = rest[2..].iter().position(|&point| same(point, first)) else { break };
        let end = length + 3 + lead_out;
        if end > rest.len() {
            break;
        }
        curves.extend(spline::pieces(kind, &rest[..end]));
        rest = &rest[end..];
    }
    let closed = !curves.is_empty();
    (curves, closed)
}

/// Chains of segments, each running from its last point to its first; a jump begins a new loop.
fn bezier_loops(points: &[Vec2]) -> (Vec<Curve2>, bool) {
    let (mut curves, mut closed) = (Vec::new(), true);
    let mut start: Option<Vec2> = None;
    let mut end = Vec2::ZERO;
    for s in points.chunks_exact(4) {
        if start.is_none_or(|_| !same(s[0], end)) {
            closed &= start.is_none_or(|first| same(first, end));
            start = Some(s[0]);
        }
        end = s[3];
        curves.push(spline::bezier(s[3], s[2], s[1], s[0]));
    }
    (curves, closed && start.is_none_or(|first| same(first, end)))
}

#[cfg(test)]
mod tests {
    use super::*;

    fn square(at: f64) -> Vec<Vec2> {
        [(0.0, 0.0), (1.0, 0.0), (1.0, 1.0), (0.0, 1.0), (0.0, 0.0)]
            .map(|(x, y)| Vec2::new(x + at, y))
            .to_vec()
    }

    #[test]
    fn linear_outlines_split_where_they_close() {
        let (curves, closed) = outline(SplineKind::Linear, &[square(0.0), square(5.0)].concat());
        assert_eq!((curves.len(), closed), (8, true));
        let (curves, closed) = outline(SplineKind::Linear, &square(0.0)[..4]);
        assert_eq!((curves.len(), closed), (4, false));
        assert_eq!(curves[3], spline::line(Vec2::Y, Vec2::ZERO));
    }

    #[test]
    fn quadratic_outlines_begin_with_a_point_that_steers() {
        let points = [vec![Vec2::new(-1.0, 0.0)], square(0.0)].concat();
        let (curves, closed) = outline(SplineKind::Quadratic, &points);
        assert_eq!((curves.len(), closed), (4, true));
        assert_eq!(curves[0].d, Vec2::ZERO);
        assert!(!outline(SplineKind::Quadratic, &points[..5]).1);
        for more in 1..4 {
            let points = [&points[..], &square(5.0)[..more]].concat();
            assert_eq!(outline(SplineKind::Quadratic, &points).0, curves);
        }
    }

    #[test]
    fn cubic_outlines_need_a_lead_out() {
        let points = [vec![Vec2::new(-1.0, 0.0)], square(0.0), vec![Vec2::new(1.0, -1.0)]].concat();
        let (curves, closed) = outline(SplineKind::Cubic, &points);
        assert_eq!((curves.len(), closed), (4, true));
    }
}
