//! The lathe: a profile of curves turned about the y axis (shapes spec, section 5).
use std::cell::Cell;

use raggio_math::{Aabb, Ray, Vec2, Vec3, poly};
use raggio_scene::{Curve2, CurveKind};

use super::collect::{Collect, searched_from};
use super::outline::{Outline, point, slope};
use super::plane_tree::{Line, PlaneTree};
use super::revolve::{Sweep, barrel_bounds, circle_reach, clip_to_barrel, radius, radius_squared};
use super::turn;
use crate::{LocalHit, Surface};

const LEAST: f64 = 1e-4;
/// Rays that rise less than this are followed at their height and then set right.
const LEVEL: f64 = 1e-6;

/// Bent pieces of the profile are cut into so many spans: short ones lie close in their boxes, and mostly hold one
/// root at most.
const SPANS: usize = 2;

/// A lathe; x of its profile is the radius, y the height.
#[derive(Clone, Debug)]
pub(crate) struct Lathe {
    profile: Outline,
    spans: Vec<Span>,
    /// The middle of its heights.
    level: f64,
    /// Over the spans in their order and against it.
    trees: [PlaneTree; 2],
    /// Does the profile end higher than it begins?
    rises: bool,
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
    form: Form,
}

/// Squares of radius and height, and the height, as Bernstein coefficients of twice the curve's degree. Heights count from
/// [`Lathe::level`].
#[derive(Clone, Copy, Debug)]
struct Form {
    radius2: [f64; MOST_COEFFICIENTS],
    height2: [f64; MOST_COEFFICIENTS],
    height: [f64; MOST_COEFFICIENTS],
}

/// What is asked of a ray at every span: `a y^2 + b y + c` is the square of the radius of the cone that it sweeps about the
/// axis, times `dy^2`, for heights from [`Lathe::level`].
struct Cone {
    a: f64,
    b: f64,
    c: f64,
    dy2: f64,
}

/// Of the square of a cubic.
const MOST_COEFFICIENTS: usize = 7;

fn degree(kind: CurveKind) -> usize {
    match kind {
        CurveKind::Linear => 1,
        CurveKind::Quadratic => 2,
        CurveKind::Cubic => 3,
    }
}

impl Form {
    fn new(curve: &Curve2, level: f64) -> Self {
        let degree = degree(curve.kind);
        let bernstein = |pick: fn(Vec2) -> f64| {
            let [a, b, c, d] = [curve.a, curve.b, curve.c, curve.d].map(pick);
            match curve.kind {
                CurveKind::Linear => [d, d + c, 0.0, 0.0],
                CurveKind::Quadratic => [d, d + 0.5 * c, d + c + b, 0.0],
                CurveKind::Cubic => [d, d + c / 3.0, d + (2.0 * c + b) / 3.0, d + c + b + a],
            }
        };
        let (radius, height) = (bernstein(|v| v.x), bernstein(|v| v.y).map(|y| y - level));
        Form {
            radius2: product(degree, &radius, &radius),
            height2: product(degree, &height, &height),
            height: product(degree, &height, &[1.0; 4]),
        }
    }
}

/// The product of two polynomials of one degree in Bernstein form.
fn product(degree: usize, f: &[f64; 4], g: &[f64; 4]) -> [f64; MOST_COEFFICIENTS] {
    let choose = |n: usize, k: usize| (0..k).fold(1.0, |c, i| c * (n - i) as f64 / (i + 1) as f64);
    let mut sum = [0.0; MOST_COEFFICIENTS];
    for i in 0..=degree {
        for j in 0..=degree {
            sum[i + j] += choose(degree, i) * choose(degree, j) / choose(2 * degree, i + j) * f[i] * g[j];
        }
    }
    sum
}

impl Cone {
    /// Of a ray, whose [`radius_squared`] is given.
    fn new(ray: &Ray, [c, b, a]: [f64; 3], level: f64) -> Self {
        let (y, dy) = (ray.origin.y - level, ray.dir.y);
        let b = b * dy;
        Cone { a, b: b - 2.0 * a * y, c: (a * y - b) * y + c * dy * dy, dy2: dy * dy }
    }

    /// Positive for a point of the profile that lies within the cone; zero where the ray meets the turned profile.
    fn off(&self, p: Vec2, level: f64) -> f64 {
        let y = p.y - level;
        (self.a * y + self.b) * y + self.c - p.x * p.x * self.dy2
    }

    /// [`Cone::off`] along a span, as Bernstein coefficients; at its ends it is given.
    #[inline(always)]
    fn off_along<const N: usize>(&self, form: &Form, ends: [f64; 2]) -> [f64; N] {
        let mut off = [0.0; N];
        let squares = form.height2.iter().zip(&form.radius2);
        for (off, (height, (height2, radius2))) in off.iter_mut().zip(form.height.iter().zip(squares)) {
            *off = self.a * height2 + self.b * height + self.c - self.dy2 * radius2;
        }
        (off[0], off[N - 1]) = ends.into();
        off
    }
}

impl Span {
    /// The stretches of a piece. Where two meet, both have the very same end.
    fn of_piece(
        piece: usize,
        curve: &Curve2,
        [start, .., end]: &[Vec2; 4],
        level: f64,
    ) -> impl Iterator<Item = Span> {
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
            let form = Form::new(&curve, level);
            Span { piece: piece as u32, from, width, curve, ends: [joint(k), joint(k + 1)], form }
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

    /// Calls `each(s)` for the curve parameters at which the cone that the ray sweeps about the axis meets the curve.
    #[inline]
    fn meets(&self, cone: &Cone, level: f64, mut each: impl FnMut(f64)) {
        let ends = self.ends.map(|p| cone.off(p, level));
        let each = |s: f64| {
            each(s);
            true
        };
        match self.curve.kind {
            CurveKind::Linear => {
                poly::bernstein_quadratic(cone.off_along(&self.form, ends)).iter().copied().all(each);
            }
            CurveKind::Quadratic => {
                poly::visit_bernstein_roots(&cone.off_along::<5>(&self.form, ends), each);
            }
            CurveKind::Cubic => poly::visit_bernstein_roots(&cone.off_along::<7>(&self.form, ends), each),
        }
    }
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
        let (min, max) = profile.bounds();
        let level = 0.5 * (min.y + max.y);
        let pieces = profile.pieces().enumerate();
        let spans: Vec<_> =
            pieces.flat_map(|(i, (curve, points))| Span::of_piece(i, curve, points, level)).collect();
        let mut boxes: Vec<_> = spans.iter().map(Span::bounds).collect();
        let forth = PlaneTree::new(&boxes);
        boxes.reverse();
        let rises = spans.first().zip(spans.last()).is_some_and(|(a, b)| a.ends[0].y < b.ends[1].y);
        Lathe { profile, spans, level, trees: [forth, PlaneTree::new(&boxes)], rises }
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
        let cone = Cone::new(&near, sweep.radius2, self.level);
        let (first, last) = (lo - middle, Cell::new(hi - middle));
        // What the ray comes to first had best be asked first: what lies beyond a hit need not be.
        let forth = self.rises == (ray.dir.y > 0.0);
        self.trees[usize::from(!forth)].visit(
            |node| sweep.passes(node, (first, last.get())),
            |i, _| {
                let span = &self.spans[if forth { i } else { self.spans.len() - 1 - i }];
                span.meets(&cone, self.level, |s| {
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
        self.profile.contains(Vec2::new(radius(p), p.y))
    }

    fn normal(&self, p: Vec3, hit: &LocalHit) -> Vec3 {
        let rho = radius(p);
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
