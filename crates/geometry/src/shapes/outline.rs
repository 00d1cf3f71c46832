//! Plane curves that bound an area by the even-odd rule: what prisms and glyphs are made of.
use raggio_math::{Vec2, poly};
use raggio_scene::{Curve2, CurveKind};

/// Ends of pieces this near are one point.
const JOINT: f64 = 1e-9;

/// A set of closed curves.
#[derive(Clone, Debug)]
pub(crate) struct Outline {
    pieces: Vec<Piece>,
    min: Vec2,
    max: Vec2,
}

/// A cubic piece in Bernstein form; joints carry the same bits in both pieces.
#[derive(Clone, Copy, Debug)]
struct Piece {
    points: [Vec2; 4],
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
        Piece { points, kind: curve.kind, curve: *curve }
    }

    /// Parameters at which the piece crosses the line `normal . p + offset = 0`, each end counted by its sign.
    #[inline]
    fn crossings(&self, normal: Vec2, offset: f64, mut each: impl FnMut(f64)) {
        let at = self.points.map(|p| normal.dot(p) + offset);
        let (first, last) = (at[0], at[3]);
        match self.kind {
            CurveKind::Linear => {
                if (first < 0.0) != (last < 0.0) {
                    each(first / (first - last));
                }
            }
            CurveKind::Quadratic => {
                let middle = 0.25 * (3.0 * (at[1] + at[2]) - first - last);
                poly::bernstein_roots(&[first, middle, last]).iter().for_each(|&s| each(s));
            }
            CurveKind::Cubic => poly::bernstein_roots(&at).iter().for_each(|&s| each(s)),
        }
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
        // Control points hold their curve.
        let corners = || pieces.iter().flat_map(|p| p.points);
        let min = corners().fold(Vec2::splat(f64::INFINITY), Vec2::min);
        let max = corners().fold(Vec2::splat(f64::NEG_INFINITY), Vec2::max);
        Outline { pieces, min, max }
    }

    /// A box around it: least and greatest corner.
    pub(crate) fn bounds(&self) -> (Vec2, Vec2) {
        (self.min, self.max)
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
        for piece in &self.pieces {
            let [a, b, c, d] = piece.points;
            if a.x.max(b.x).max(c.x).max(d.x) < p.x {
                continue;
            }
            piece.crossings(Vec2::Y, -p.y, |s| {
                if point(&piece.curve, s).x >= p.x {
                    inside = !inside;
                }
            });
        }
        inside
    }

    /// Calls `each(piece, s, point)` wherever the outline crosses the line `normal . p + offset = 0`.
    #[inline]
    pub(crate) fn crossings(&self, normal: Vec2, offset: f64, mut each: impl FnMut(u32, f64, Vec2)) {
        for (i, piece) in self.pieces.iter().enumerate() {
            piece.crossings(normal, offset, |s| each(i as u32, s, point(&piece.curve, s)));
        }
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
