//! Which part of a surface is there: closed loops of rational curves in its parameters, even-odd.
use raggio_math::{Vec2, Vec4};
use raggio_scene::Trim;

use super::bezier::{Row, part, spans};

/// A piece is halved at most this often; then it is as good as straight.
const MOST_HALVINGS: u32 = 48;

/// Loops as Bezier pieces; control points are (w u, w v, 0, w).
#[derive(Debug, Default)]
pub(super) struct Trims {
    pieces: Vec<Row>,
}

impl Trims {
    pub(super) fn new(trims: &[Trim]) -> Self {
        let mut pieces = Vec::new();
        for trim in trims {
            let points: Vec<Vec4> =
                trim.points.iter().map(|(p, w)| Vec4::new(p.x * w, p.y * w, 0.0, *w)).collect();
            let first = pieces.len();
            pieces.extend(spans(&trim.knots).map(|span| span.bezier(&points)));
            let ends = pieces.get(first).and_then(|p: &Row| p.first()).copied();
            if let (Some(start), Some(end)) = (ends, pieces.last().and_then(|p| p.last()).copied()) {
                // A line closes the loop; it has no length if the loop is closed.
                pieces.push([end, start].into_iter().collect());
            }
        }
        Trims { pieces }
    }

    /// Does a ray from here along u cross the loops an odd number of times?
    pub(super) fn keep(&self, uv: Vec2) -> bool {
        self.pieces.is_empty() || self.pieces.iter().fold(false, |odd, piece| odd != crosses(piece, uv, 0))
    }
}

fn at(p: &Vec4) -> Vec2 {
    Vec2::new(p.x, p.y) / p.w
}

/// Does a piece cross the ray an odd number of times?
fn crosses(piece: &[Vec4], from: Vec2, depth: u32) -> bool {
    let (mut lo, mut hi) = (Vec2::INFINITY, Vec2::NEG_INFINITY);
    for p in piece {
        (lo, hi) = (lo.min(at(p)), hi.max(at(p)));
    }
    if hi.y < from.y || lo.y > from.y || hi.x < from.x {
        return false;
    }
    let (Some(first), Some(last)) = (piece.first(), piece.last()) else { return false };
    let (a, b) = (at(first), at(last));
    let ends_differ = (a.y > from.y) != (b.y > from.y);
    if lo.x > from.x {
        return ends_differ;
    }
    if piece.len() == 2 || depth == MOST_HALVINGS {
        return ends_differ && a.x + (from.y - a.y) / (b.y - a.y) * (b.x - a.x) > from.x;
    }
    let (near, far) = (part(piece, 0.0, 0.5), part(piece, 0.5, 1.0));
    crosses(&near, from, depth + 1) != crosses(&far, from, depth + 1)
}
