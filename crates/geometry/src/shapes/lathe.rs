//! The lathe: a profile of curves turned about the y axis (shapes spec, section 5).
use std::cell::Cell;

use raggio_math::{Aabb, Ray, Vec2, Vec3, poly};
use raggio_scene::{Curve2, CurveKind};

use super::collect::{Collect, searched_from};
use super::outline::{Outline, point, slope};
use super::plane_tree::{Line, PlaneTree};
use super::revolve::{Sweep, barrel_bounds, circle_reach, clip_to_barrel, radius_squared};
use super::turn;
use crate::{LocalHit, Surface};

const LEAST: f64 = 1e-4;
/// Rays that rise less than this are followed at their height and then set right.
const LEVEL: f64 = 1e-6;

/// Bent pieces of the profile are cut into so many spans: short ones lie close in their boxes, and mostly hold one
/// root at most.
const SPANS: usize = 4;

/// A lathe; x of its profile is the radius, y the height.
#[derive(Clone, Debug)]
pub(crate) struct Lathe {
    profile: Outline,
    spans: Vec<Span>,
    tree: PlaneTree,
}

/// A stretch of a piece of the profile.
#[derive(Clone, Copy, Debug)]
struct Span {
    piece: u32,
    /// Where it begins in the piece, and how much of it there is.
    from: f64,
    width: f64,
    /// By its own parameter in 0..=1.
    curve: Curve2,
    ends: [Vec2; 2],
}

impl Span {
    /// The stretches of a piece. Where two meet, both have the very same end.
    fn of_piece(piece: usize, curve: &Curve2, [start, .., end]: &[Vec2; 4]) -> impl Iterator<Item = Span> {
        let count = if curve.kind == CurveKind::Linear { 1 } else { SPANS };
        let (whole, start, end) = (*curve, *start, *end);
        let width = 1.0 / count as f64;
        let joint = move |k: usize| match k {
            0 => start,
            k if k == count => end,
            k => point(&whole, k as f64 * width),
        };
        (0..count).map(move |k| {
            let from = k as f64 * width;
            let curve = Curve2 {
                a: whole.a * (width * width * width),
                b: (whole.a * (3.0 * from) + whole.b) * (width * width),
                c: slope(&whole, from) * width,
                d: point(&whole, from),
                kind: whole.kind,
            };
            Span { piece: piece as u32, from, width, curve, ends: [joint(k), joint(k + 1)] }
        })
    }

    /// Control points and ends.
    fn points(&self) -> [Vec2; 6] {
        let Curve2 { a, b, c, d, .. } = self.curve;
        [d, d + c / 3.0, d + (c * 2.0 + b) / 3.0, d + c + b + a, self.ends[0], self.ends[1]]
    }

    /// A box around its points.
    fn bounds(&self) -> (Vec2, Vec2) {
        let corner = |pick: fn(Vec2, Vec2) -> Vec2| self.points().into_iter().fold(self.curve.d, pick);
        (corner(Vec2::min), corner(Vec2::max))
    }

    /// Calls `each(s)` for the curve parameters at which the cone that the ray sweeps about the axis meets the curve:
    /// `|o dy + d (y(s) - oy)|^2 = r(s)^2 dy^2` in x and z. `radius2` is the ray's [`radius_squared`].
    fn meets(&self, ray: &Ray, radius2: [f64; 3], each: impl FnMut(f64)) {
        let (oy, dy) = (ray.origin.y, ray.dir.y);
        let [c, b, a] = radius2;
        let (b, c) = (b * dy, c * dy * dy);
        let off = |p: Vec2| {
            let y = p.y - oy;
            (a * y + b) * y + c - p.x * p.x * dy * dy
        };
        let (first, last) = (off(self.ends[0]), off(self.ends[1]));
        let curve = &self.curve;
        let y = [curve.d.y - oy, curve.c.y, curve.b.y, curve.a.y];
        let r = [curve.d.x * dy, curve.c.x * dy, curve.b.x * dy, curve.a.x * dy];
        let power = [a, b, c];
        match curve.kind {
            CurveKind::Linear => {
                let middle =
                    c + 0.5 * b * (y[0] + y[0] + y[1]) + a * y[0] * (y[0] + y[1]) - r[0] * (r[0] + r[1]);
                poly::bernstein_quadratic([first, middle, last]).iter().copied().for_each(each);
            }
            CurveKind::Quadratic => meet_roots::<3, 5>(&y, &r, power, first, last, each),
            CurveKind::Cubic => meet_roots::<4, 7>(&y, &r, power, first, last, each),
        }
    }
}

/// The roots in 0..=1 of `a y^2 + b y + c - r^2`, for polynomials y and r of N coefficients.
fn meet_roots<const N: usize, const M: usize>(
    y: &[f64; 4],
    r: &[f64; 4],
    [a, b, c]: [f64; 3],
    first: f64,
    last: f64,
    each: impl FnMut(f64),
) {
    let mut sum = [0.0; M];
    sum[0] = c;
    for i in 0..N {
        sum[i] += b * y[i];
        for j in 0..N {
            sum[i + j] += a * y[i] * y[j] - r[i] * r[j];
        }
    }
    poly::roots_in_unit(&sum, first, last).iter().copied().for_each(each);
}

/// One step of Newton's method towards the place where ray and turned curve are the same in height and radius.
fn polished(ray: &Ray, curve: &Curve2, s: f64, t: f64) -> (f64, f64) {
    let [c, b, a] = radius_squared(ray);
    let (p, along) = (point(curve, s), slope(curve, s));
    let f1 = ray.origin.y + t * ray.dir.y - p.y;
    let f2 = c + t * (b + t * a) - p.x * p.x;
    let (f2_t, f2_s) = (b + 2.0 * a * t, -2.0 * p.x * along.x);
    let det = ray.dir.y * f2_s + along.y * f2_t;
    let dt = -(f1 * f2_s + along.y * f2) / det;
    let ds = -(ray.dir.y * f2 - f2_t * f1) / det;
    // Where the ray grazes, the step is wild and the start is the better answer.
    if dt.abs() < 1e-4 && ds.abs() < 1e-4 { (s + ds, t + dt) } else { (s, t) }
}

impl Lathe {
    /// A lathe of the given profile.
    pub(crate) fn new(curves: &[Curve2]) -> Self {
        let profile = Outline::new(curves);
        let pieces = profile.pieces().enumerate();
        let spans: Vec<_> =
            pieces.flat_map(|(i, (curve, points))| Span::of_piece(i, curve, points)).collect();
        let boxes: Vec<_> = spans.iter().map(Span::bounds).collect();
        Lathe { profile, spans, tree: PlaneTree::new(&boxes) }
    }

    /// Heights and radius of the barrel around it.
    fn barrel(&self) -> ((f64, f64), f64) {
        let (min, max) = self.profile.bounds();
        ((min.y, max.y), max.x.max(-min.x))
    }

    fn search(&self, ray: &Ray, to: &mut impl Collect) {
        if ray.dir.y.abs() < LEVEL {
            return self.search_level(ray, to);
        }
        // A margin, so that what is shaved off here is no part of the surface.
        let ((low, high), radius) = self.barrel();
        let margin = 1e-9 * (1.0 + low.abs().max(high.abs()));
        let stretch = clip_to_barrel(ray, (low - margin, high + margin), radius * (1.0 + 1e-9), to.range());
        let Some((lo, hi)) = stretch else { return };
        // From a place nearby digits are not lost to the distance.
        let middle = 0.5 * (lo + hi);
        let near = Ray::new(ray.at(middle), ray.dir);
        let sweep = Sweep::new(&near);
        let (first, last) = (lo - middle, Cell::new(hi - middle));
        self.tree.visit(
            |node| sweep.passes(node, (first, last.get())),
            |i, _| {
                let span = &self.spans[i];
                span.meets(&near, sweep.radius2, |s| {
                    let t = (point(&span.curve, s).y - near.origin.y) * sweep.per_y;
                    let (s, t) = polished(&near, &span.curve, s, t);
                    let u = span.from + s * span.width;
                    to.push(LocalHit { t: middle + t, part: span.piece, u, v: 0.0 });
                });
                last.set(last.get().min(to.range().1 - middle));
            },
        );
    }

    /// For a ray that stays at one height: the radii there, and the ray's way through those circles.
    fn search_level(&self, ray: &Ray, to: &mut impl Collect) {
        let shift = -ray.origin.dot(ray.dir);
        let near = Ray::new(ray.at(shift), ray.dir);
        let [c, b, a] = radius_squared(&near);
        self.profile.crossings(&Line::new(Vec2::Y, -near.origin.y), |part, s, p| {
            for &t in poly::quadratic([c - p.x * p.x, b, a]).iter() {
                let (s, t) = polished(&near, self.profile.curve(part), s, t);
                to.push(LocalHit { t: shift + t, part, u: s, v: 0.0 });
            }
        });
    }
}

impl Surface for Lathe {
    searched_from!(LEAST);

    fn bounds(&self) -> Aabb {
        if self.spans.is_empty() {
            return Aabb::EMPTY;
        }
        let (heights, radius) = self.barrel();
        barrel_bounds(heights, radius)
    }

    fn reach(&self, along: Vec3) -> Option<f64> {
        let points = self.spans.iter().flat_map(Span::points);
        Some(points.map(|p| circle_reach(p.y, p.x, along)).fold(f64::NEG_INFINITY, f64::max))
    }

    fn inside(&self, p: Vec3) -> bool {
        self.profile.contains(Vec2::new(p.x.hypot(p.z), p.y))
    }

    fn normal(&self, p: Vec3, hit: &LocalHit) -> Vec3 {
        let rho = p.x.hypot(p.z);
        if rho * rho <= raggio_math::EPS {
            return Vec3::Y;
        }
        let along = slope(self.profile.curve(hit.part), hit.u);
        let n = Vec3::new(along.y * p.x, -along.x * rho, along.y * p.z);
        n.try_normalize().unwrap_or(Vec3::Y)
    }

    fn uv(&self, p: Vec3, hit: &LocalHit) -> Option<Vec2> {
        let v = (f64::from(hit.part) + hit.u) / self.profile.pieces().len() as f64;
        Some(Vec2::new(turn(p.x, p.z), v))
    }
}
