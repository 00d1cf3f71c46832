//! Hits of smooth surfaces P(u, v), with no facets at any size.
//!
//! The surface is cut into pieces as rays come by, each with a box around it and ranges of its partial derivatives, until
//! the derivatives hardly differ over a piece. If the surface cannot turn from the ray within such a piece there is at
//! most one hit, and it is found by the method of Broyden (1965), Newton's without a derivative at each step. Pieces
//! that do turn from the ray are cut further. What a piece knows does not depend on who asks.
use std::sync::OnceLock;

use raggio_function::Range;
use raggio_math::{Aabb, Ray, Vec2, Vec3};
use smallvec::SmallVec;

use crate::LocalHit;
use crate::index::padded;
use crate::probe::BoxRay;

/// Pieces are cut in two this many times at most.
const MOST_CUTS: u32 = 20;
/// The same where nothing is known of derivatives.
const MOST_BLIND_CUTS: u32 = 16;
/// A piece is smooth where derivatives differ by less than this share of their size.
const ALIKE: f64 = 0.6;
/// Steps of a search for a root.
const MOST_STEPS: u32 = 20;
/// How far outside its piece, in shares of the piece, a root may lie for rounding's sake.
const EDGE: f64 = 1e-7;

/// Hits nearer together than this are one, found from both sides of an edge.
const SAME: f64 = 1e-9;
/// How far outside its piece, in shares of the piece, a search may go.
const MARGIN: f64 = 0.4;

/// A surface over a rectangle of parameters.
pub(crate) trait Sheet: Send + Sync {
    /// The point at parameters within the rectangle, or a little beyond.
    fn point(&self, uv: Vec2) -> Vec3;
    /// What is known of the surface over a part of the rectangle.
    fn enclose(&self, lo: Vec2, hi: Vec2) -> Enclosure;
    /// A root that cannot be found any nearer counts if the ray comes as near as this.
    fn tolerance(&self) -> f64;
    /// Is the surface there at all, at these parameters?
    fn keeps(&self, _uv: Vec2) -> bool {
        true
    }
}

/// Where a part of a surface is, and where its derivatives by u and v are.
pub(crate) struct Enclosure {
    pub(crate) bounds: Aabb,
    pub(crate) du: [Range; 3],
    pub(crate) dv: [Range; 3],
}

/// A surface, ready to be hit.
pub(crate) struct SheetTree<S> {
    pub(crate) sheet: S,
    root: Piece,
}

impl<S> SheetTree<S> {
    /// A box around the surface.
    pub(crate) fn bounds(&self) -> Aabb {
        self.root.bounds
    }
}

struct Piece {
    lo: Vec2,
    hi: Vec2,
    bounds: Aabb,
    /// Middle derivatives, for one whole piece.
    du: Vec3,
    dv: Vec3,
    /// The normal, not normalised.
    normal: [Range; 3],
    /// Do the derivatives hardly differ?
    smooth: bool,
    /// How often the whole was cut to get here.
    depth: u32,
    /// Is it not to be cut further?
    last: bool,
    /// Is u to be cut, and not v?
    cut_u: bool,
    halves: OnceLock<Box<[Piece; 2]>>,
}

/// How the search for a root in a piece ended.
enum Root {
    At(f64, Vec2),
    Outside,
    Lost,
}

/// A ray as the searches need it.
struct Aim {
    origin: Vec3,
    dir: Vec3,
    /// Two directions across the ray.
    across: (Vec3, Vec3),
    boxes: BoxRay,
}

/// The hits of one ray, without memory of their own.
pub(crate) type Hits = SmallVec<[LocalHit; 4]>;

impl<S: Sheet> SheetTree<S> {
    /// The surface over a rectangle of parameters.
    pub(crate) fn new(sheet: S, lo: Vec2, hi: Vec2) -> Self {
        let root = Piece::new(&sheet, lo, hi, 0);
        SheetTree { sheet, root }
    }

    /// Adds the hits within the range, in any order; only the nearest is sure to be there if that is all that is asked.
    /// Answers with the end of the range that still matters.
    pub(crate) fn hits(&self, ray: &Ray, range: (f64, f64), part: u32, nearest: bool, out: &mut Hits) -> f64 {
        let Some(unit) = ray.dir.try_normalize().filter(|_| ray.origin.is_finite()) else { return range.1 };
        let aim = Aim {
            origin: ray.origin,
            dir: ray.dir,
            across: unit.any_orthonormal_pair(),
            boxes: BoxRay::new(ray),
        };
        let mut far = range.1;
        let mut waiting: SmallVec<[(&Piece, f64); 32]> = SmallVec::new();
        waiting.extend(aim.boxes.entry(&self.root.bounds, range).map(|t| (&self.root, t)));
        while let Some((piece, entry)) = waiting.pop() {
            if entry > far {
                continue;
            }
            if piece.last || piece.smooth && piece.faces(&aim) {
                match self.root_in(piece, &aim) {
                    Root::At(t, uv) => {
                        if range.0 < t && t < far && self.sheet.keeps(uv) {
                            add(LocalHit { t, part, u: uv.x, v: uv.y }, out);
                            far = if nearest { t } else { far };
                        }
                        continue;
                    }
                    Root::Lost if !piece.last => {}
                    _ => continue,
                }
            }
            let [a, b] = &**piece.halves.get_or_init(|| Box::new(self.halves(piece)));
            let mut parts = [a, b].map(|p| (p, aim.boxes.entry(&p.bounds, (range.0, far))));
            if parts[0].1 < parts[1].1 {
                parts.swap(0, 1);
            }
            waiting.extend(parts.into_iter().filter_map(|(p, entry)| Some((p, entry?))));
        }
        far
    }

    fn halves(&self, piece: &Piece) -> [Piece; 2] {
        let middle = 0.5 * (piece.lo + piece.hi);
        let (mut below, mut above) = (piece.hi, piece.lo);
        if piece.cut_u {
            (below.x, above.x) = (middle.x, middle.x);
        } else {
            (below.y, above.y) = (middle.y, middle.y);
        }
        let depth = piece.depth + 1;
        [Piece::new(&self.sheet, piece.lo, below, depth), Piece::new(&self.sheet, above, piece.hi, depth)]
    }

    /// The hit in a piece that has one at most. Coordinates of the search are shares of the piece.
    fn root_in(&self, piece: &Piece, aim: &Aim) -> Root {
        let size = piece.hi - piece.lo;
        let off = |p: Vec3| Vec2::new(aim.across.0.dot(p - aim.origin), aim.across.1.dot(p - aim.origin));
        let turned = |d: Vec3| Vec2::new(aim.across.0.dot(d), aim.across.1.dot(d));
        let (mut ju, mut jv) = (turned(piece.du), turned(piece.dv));
        let mut at = Vec2::splat(0.5);
        let mut p = self.sheet.point(piece.lo + at * size);
        let mut f = off(p);
        let scale = aim.origin.abs().max_element().max(p.abs().max_element());
        for _ in 0..MOST_STEPS {
            if f.length() <= 1e-13 * scale {
                break;
            }
            let det = ju.perp_dot(jv);
            let step = Vec2::new(-f.perp_dot(jv), -ju.perp_dot(f)) / det;
            if !step.is_finite() {
                break;
            }
            let next = (at + step).clamp(Vec2::splat(-MARGIN), Vec2::splat(1.0 + MARGIN));
            let step = next - at;
            if step == Vec2::ZERO {
                // Pushed outwards where it was stopped before.
                return Root::Outside;
            }
            p = self.sheet.point(piece.lo + next * size);
            let off = off(p);
            let miss = (off - f - ju * step.x - jv * step.y) / step.length_squared();
            (ju, jv) = (ju + miss * step.x, jv + miss * step.y);
            (at, f) = (next, off);
            if step.abs().max_element() < 1e-13 {
                break;
            }
        }
        let inside = at.cmpge(Vec2::splat(-EDGE)).all() && at.cmple(Vec2::splat(1.0 + EDGE)).all();
        let near = f.length() <= 1e-9 * scale;
        if inside && (near || piece.last && f.length() <= self.sheet.tolerance()) {
            let t = (p - aim.origin).dot(aim.dir) / aim.dir.length_squared();
            return Root::At(t, (piece.lo + at * size).clamp(piece.lo, piece.hi));
        }
        if near { Root::Outside } else { Root::Lost }
    }
}

/// Adds a hit, unless a neighbouring piece has found it already.
fn add(hit: LocalHit, out: &mut Hits) {
    if !out.iter().any(|h| (h.t - hit.t).abs() <= SAME * (1.0 + hit.t.abs())) {
        out.push(hit);
    }
}

impl Piece {
    fn new(sheet: &impl Sheet, lo: Vec2, hi: Vec2, depth: u32) -> Self {
        let Enclosure { bounds, du, dv } = sheet.enclose(lo, hi);
        let size = hi - lo;
        let (mut along_u, mut along_v) = (middle(&du) * size.x, middle(&dv) * size.y);
        let (reach_u, reach_v) = (reach(&du) * size.x, reach(&dv) * size.y);
        let mut cut_u = reach_u >= reach_v;
        let blind = !(reach_u.is_finite() && reach_v.is_finite());
        if blind {
            cut_u = depth.is_multiple_of(2);
            along_u = sheet.point(Vec2::new(hi.x, lo.y)) - sheet.point(lo);
            along_v = sheet.point(Vec2::new(lo.x, hi.y)) - sheet.point(lo);
        }
        Piece {
            lo,
            hi,
            bounds: padded(&bounds),
            du: along_u,
            dv: along_v,
            normal: cross(&du, &dv),
            smooth: alike(&du) && alike(&dv),
            depth,
            last: depth >= if blind { MOST_BLIND_CUTS } else { MOST_CUTS },
            cut_u,
            halves: OnceLock::new(),
        }
    }

    /// Is the same side turned to the ray all over?
    fn faces(&self, aim: &Aim) -> bool {
        let range = (0..3).fold(Range::ZERO, |sum, k| sum + self.normal[k] * aim.dir[k]);
        range.lo > 0.0 || range.hi < 0.0
    }
}

/// The greatest length that the derivative may have.
fn reach(d: &[Range; 3]) -> f64 {
    Vec3::from(d.map(Range::size)).length()
}

fn middle(d: &[Range; 3]) -> Vec3 {
    Vec3::from(d.map(Range::middle))
}

fn alike(d: &[Range; 3]) -> bool {
    let differences: f64 = d.iter().map(|r| r.width()).sum();
    differences <= ALIKE * middle(d).length()
}

fn cross(a: &[Range; 3], b: &[Range; 3]) -> [Range; 3] {
    std::array::from_fn(|k| {
        let (i, j) = ((k + 1) % 3, (k + 2) % 3);
        a[i] * b[j] - a[j] * b[i]
    })
}
