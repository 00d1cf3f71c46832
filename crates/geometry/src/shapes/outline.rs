//! Plane curves that bound an area by the even-odd rule: what prisms and glyphs are made of.
use raggio_math::{Vec2, poly};
use raggio_scene::{Curve2, CurveKind};

use super::plane_tree::{Line, PlaneTree};

/// Ends of pieces this near are one point.
const JOINT: f64 = 1e-9;

/// A set of closed curves.
#[derive(Clone, Debug)]
pub(crate) struct Outline {
    pieces: Vec<Piece>,
    tree: PlaneTree,
    min: Vec2,
    max: Vec2,
}

/// A cubic piece in Bernstein form; joints carry the same bits in both pieces.
#[derive(Clone, Copy, Debug)]
struct Piece {
    points: [Vec2; 4],
    /// The middle control point, if it is a quadratic.
    middle: Vec2,
    kind: CurveKind,
    curve: Curve2,
}

impl Piece {
    fn new(curve: &Curve2) -> Self {
        let axis = |pick: fn(Vec2) -> f64| {
            let [a, b, c, d] = [curve.a, curve.b, curve.c, curve.d].map(pick);
            [d, d + c / 3.0, d + (2.0 * c + b) / 3.0, d + c + b + a]
        };
        let (x, y) = (axis(|v| v.x), axis(|v| v.y));
        let points = std::array::from_fn(|k| Vec2::new(x[k], y[k]));
        Piece { points, middle: curve.d + curve.c * 0.5, kind: curve.kind, curve: *curve }
    }

    /// Parameters at which the piece crosses the line, each end counted by its sign.
    #[inline]
    fn crossings(&self, line: &Line, mut each: impl FnMut(f64)) {
        let [a, b, c, d] = &self.points;
        let (first, last) = (line.side(*a), line.side(*d));
        match self.kind {
            CurveKind::Linear => {
                if (first < 0.0) != (last < 0.0) {
                    each(first / (first - last));
                }
            }
            CurveKind::Quadratic => {
                for &s in poly::bernstein_quadratic([first, line.side(self.middle), last]).iter() {
                    each(s);
                }
            }
            CurveKind::Cubic => {
                for &s in poly::bernstein_roots(&[first, line.side(*b), line.side(*c), last]).iter() {
                    each(s);
                }
            }
        }
    }

    /// A box around it: control points hold their curve.
    fn bounds(&self) -> (Vec2, Vec2) {
        let [a, b, c, d] = self.points;
        (a.min(b).min(c).min(d), a.max(b).max(c).max(d))
    }
}

/// The curve at parameter `s`.
#[inline]
pub(crate) fn point(c: &Curve2, s: f64) -> Vec2 {
    ((c.a * s + c.b) * s + c.c) * s + c.d
}

/// The derivative at parameter `s`.
#[inline]
pub(crate) fn slope(c: &Curve2, s: f64) -> Vec2 {
    (c.a * (3.0 * s) + c.b * 2.0) * s + c.c
}

impl Outline {
    /// The area within the pieces of all loops together.
    pub(crate) fn new<'a>(curves: impl IntoIterator<Item = &'a Curve2>) -> Self {
        let mut pieces: Vec<Piece> = curves.into_iter().map(Piece::new).collect();
        weld(&mut pieces);
        let boxes: Vec<_> = pieces.iter().map(Piece::bounds).collect();
        let min = boxes.iter().fold(Vec2::splat(f64::INFINITY), |sum, b| sum.min(b.0));
        let max = boxes.iter().fold(Vec2::splat(f64::NEG_INFINITY), |sum, b| sum.max(b.1));
        Outline { pieces, tree: PlaneTree::new(&boxes), min, max }
    }

    /// A box around it: least and greatest corner.
    pub(crate) fn bounds(&self) -> (Vec2, Vec2) {
        (self.min, self.max)
    }

    /// How far its control points reach along a vector.
    pub(crate) fn reach(&self, along: Vec2) -> f64 {
        let points = self.pieces.iter().flat_map(|p| p.points);
        points.map(|p| p.dot(along)).fold(f64::NEG_INFINITY, f64::max)
    }

    /// The pieces: curve and control points.
    pub(crate) fn pieces(&self) -> impl ExactSizeIterator<Item = (&Curve2, &[Vec2; 4])> {
        self.pieces.iter().map(|p| (&p.curve, &p.points))
    }

    /// The curve of a piece.
    pub(crate) fn curve(&self, piece: u32) -> &Curve2 {
        &self.pieces[piece as usize].curve
    }

    /// Is the point inside by the even-odd rule?
    pub(crate) fn contains(&self, p: Vec2) -> bool {
        if !(p.cmpge(self.min).all() && p.cmple(self.max).all()) {
            return false;
        }
        let mut inside = false;
        let line = Line::new(Vec2::Y, -p.y);
        self.tree.visit(
            |node| node.max.x < p.x || node.min.y > p.y || node.max.y < p.y,
            |i, node| {
                let piece = &self.pieces[i];
                // Wholly on the far side only the ends count.
                if node.min.x > p.x {
                    inside ^= (line.side(piece.points[0]) < 0.0) != (line.side(piece.points[3]) < 0.0);
                    return;
                }
                piece.crossings(&line, |s| inside ^= point(&piece.curve, s).x >= p.x);
            },
        );
        inside
    }

    /// Calls `each(piece, s, point)` wherever the outline crosses the line, at least where the line matters.
    #[inline]
    pub(crate) fn crossings(&self, line: &Line, mut each: impl FnMut(u32, f64, Vec2)) {
        self.tree.visit(
            |node| line.misses(node),
            |i, _| {
                let piece = &self.pieces[i];
                piece.crossings(line, |s| each(i as u32, s, point(&piece.curve, s)));
            },
        );
    }
}

/// Gives the end of each piece the very bits of the start that follows it, so that a crossing at a joint is counted
/// once. A loop's last piece meets the start of its first.
fn weld(pieces: &mut [Piece]) {
    let meets = |a: Vec2, b: Vec2| (a - b).abs().max_element() <= JOINT * (1.0 + a.abs().max_element());
    let mut start = 0;
    for i in 0..pieces.len() {
        let end = pieces[i].points[3];
        let next = pieces.get(i + 1).map(|p| p.points[0]).filter(|&p| meets(p, end));
        match next {
            Some(p) => pieces[i].points[3] = p,
            None => {
                if meets(pieces[start].points[0], end) {
                    pieces[i].points[3] = pieces[start].points[0];
                }
                start = i + 1;
            }
        }
    }
}
