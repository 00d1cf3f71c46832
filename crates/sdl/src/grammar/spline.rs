//! Plane curves from control points: the coefficients of their pieces (shapes spec, section 5).
use raggio_math::Vec2;
use raggio_scene::{Curve2, CurveKind, SplineKind};

use crate::keyword::Kw;

/// The kind that a word names.
pub fn kind(word: Kw) -> Option<SplineKind> {
    Some(match word {
        Kw::Linear_spline => SplineKind::Linear,
        Kw::Quadratic_spline => SplineKind::Quadratic,
        Kw::Cubic_spline => SplineKind::Cubic,
        Kw::Bezier_spline => SplineKind::Bezier,
        Kw::B_spline => SplineKind::BSpline,
        _ => return None,
    })
}

/// A straight piece.
pub fn line(p0: Vec2, p1: Vec2) -> Curve2 {
    Curve2 { a: Vec2::ZERO, b: Vec2::ZERO, c: p1 - p0, d: p0, kind: CurveKind::Linear }
}

/// From `p1` to `p2`, with `p0` as the lead-in.
pub fn quadratic(p0: Vec2, p1: Vec2, p2: Vec2) -> Curve2 {
    let (b, c) = ((p0 - 2.0 * p1 + p2) / 2.0, (p2 - p0) / 2.0);
    Curve2 { a: Vec2::ZERO, b, c, d: p1, kind: CurveKind::Quadratic }
}

/// From `p1` to `p2` (Catmull-Rom).
pub fn cubic(p0: Vec2, p1: Vec2, p2: Vec2, p3: Vec2) -> Curve2 {
    Curve2 {
        a: (-p0 + 3.0 * p1 - 3.0 * p2 + p3) / 2.0,
        b: (2.0 * p0 - 5.0 * p1 + 4.0 * p2 - p3) / 2.0,
        c: (p2 - p0) / 2.0,
        d: p1,
        kind: CurveKind::Cubic,
    }
}

/// From `p0` to `p3`, with `p1` and `p2` as handles.
pub fn bezier(p0: Vec2, p1: Vec2, p2: Vec2, p3: Vec2) -> Curve2 {
    Curve2 {
        a: -p0 + 3.0 * p1 - 3.0 * p2 + p3,
        b: 3.0 * p0 - 6.0 * p1 + 3.0 * p2,
        c: 3.0 * (p1 - p0),
        d: p0,
        kind: CurveKind::Cubic,
    }
}

/// All pieces of one chain of control points.
pub fn pieces(kind: SplineKind, points: &[Vec2]) -> Vec<Curve2> {
    match kind {
        SplineKind::Linear => points.windows(2).map(|p| line(p[0], p[1])).collect(),
        SplineKind::Quadratic => points.windows(3).map(|p| quadratic(p[0], p[1], p[2])).collect(),
        SplineKind::Cubic | SplineKind::BSpline => {
            points.windows(4).map(|p| cubic(p[0], p[1], p[2], p[3])).collect()
        }
        SplineKind::Bezier => points.chunks_exact(4).map(|p| bezier(p[0], p[1], p[2], p[3])).collect(),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn at(c: &Curve2, t: f64) -> Vec2 {
        ((c.a * t + c.b) * t + c.c) * t + c.d
    }

    #[test]
    fn pieces_run_between_their_points() {
        let p = [Vec2::new(0.0, 1.0), Vec2::new(2.0, 3.0), Vec2::new(5.0, 4.0), Vec2::new(6.0, -2.0)];
        let near = |a: Vec2, b: Vec2| assert!((a - b).length() < 1e-12, "{a} {b}");
        near(at(&line(p[0], p[1]), 1.0), p[1]);
        near(at(&quadratic(p[0], p[1], p[2]), 0.0), p[1]);
        near(at(&quadratic(p[0], p[1], p[2]), 1.0), p[2]);
        near(at(&quadratic(p[0], p[1], p[2]), -1.0), p[0]);
        near(at(&cubic(p[0], p[1], p[2], p[3]), 0.0), p[1]);
        near(at(&cubic(p[0], p[1], p[2], p[3]), 1.0), p[2]);
        near(at(&bezier(p[0], p[1], p[2], p[3]), 1.0), p[3]);
        near(at(&bezier(p[0], p[1], p[2], p[3]), 0.5), (p[0] + 3.0 * p[1] + 3.0 * p[2] + p[3]) / 8.0);
        assert_eq!(pieces(SplineKind::Quadratic, &p).len(), 2);
    }
}
