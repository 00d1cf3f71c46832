//! The lathe: a profile of curves turned about the y axis (shapes spec, section 5).
use raggio_math::{Aabb, Ray, Vec2, Vec3, poly};
use raggio_scene::{Curve2, CurveKind};

use super::collect::{Collect, searched_from};
use super::outline::{Outline, point, slope};
use super::revolve::{barrel_bounds, clip_to_barrel, radius_squared};
use super::turn;
use crate::{LocalHit, Surface};

const LEAST: f64 = 1e-4;
/// Rays that rise less than this are followed at their height and then set right.
const LEVEL: f64 = 1e-6;

/// A lathe; x of its profile is the radius, y the height.
#[derive(Clone, Debug)]
pub(crate) struct Lathe {
    profile: Outline,
    segments: Vec<Segment>,
}

/// A piece of the profile.
#[derive(Clone, Copy, Debug)]
struct Segment {
    curve: Curve2,
    ends: [Vec2; 2],
    heights: (f64, f64),
    radii: (f64, f64),
}

impl Segment {
    fn new((curve, p): (&Curve2, &[Vec2; 4])) -> Self {
        let low = p[0].min(p[1]).min(p[2].min(p[3]));
        let high = p[0].max(p[1]).max(p[2].max(p[3]));
        let inner = if low.x > 0.0 { low.x } else { (-high.x).max(0.0) };
        Segment {
            curve: *curve,
            ends: [p[0], p[3]],
            heights: (low.y, high.y),
            radii: (inner, high.x.max(-low.x)),
        }
    }

    /// Calls `each(s)` for the curve parameters at which the cone that the ray sweeps about the axis meets the curve:
    /// `|o dy + d (y(s) - oy)|^2 = r(s)^2 dy^2` in x and z.
    fn meets(&self, ray: &Ray, each: impl FnMut(f64)) {
        let (o, d) = (ray.origin, ray.dir);
        let [c, b, a] = radius_squared(ray);
        let (b, c) = (b * d.y, c * d.y * d.y);
        let off = |p: Vec2| {
            let y = p.y - o.y;
            (a * y + b) * y + c - p.x * p.x * d.y * d.y
        };
        let (first, last) = (off(self.ends[0]), off(self.ends[1]));
        let curve = &self.curve;
        let y = [curve.d.y - o.y, curve.c.y, curve.b.y, curve.a.y];
        let r = [curve.d.x, curve.c.x, curve.b.x, curve.a.x].map(|r| r * d.y);
        let power = [a, b, c];
        match curve.kind {
            CurveKind::Linear => meet_roots::<2, 3>(&y, &r, power, first, last, each),
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
        let segments = profile.pieces().map(Segment::new).collect();
        Lathe { profile, segments }
    }

    fn search(&self, ray: &Ray, to: &mut impl Collect) {
        if ray.dir.y.abs() < LEVEL {
            return self.search_level(ray, to);
        }
        for (i, segment) in self.segments.iter().enumerate() {
            // A margin, so that what is shaved off here is no part of the surface.
            let heights = (segment.heights.0 - 1e-9, segment.heights.1 + 1e-9);
            let stretch = clip_to_barrel(ray, heights, segment.radii.1 * (1.0 + 1e-9), to.range());
            let Some((lo, hi)) = stretch else { continue };
            let middle = 0.5 * (lo + hi);
            let near = Ray::new(ray.at(middle), ray.dir);
            let axis_distance = |t: f64| {
                let p = ray.at(t);
                p.x * p.x + p.z * p.z
            };
            let inner = segment.radii.0 * segment.radii.0;
            if axis_distance(lo).max(axis_distance(hi)) < inner * (1.0 - 1e-9) {
                continue;
            }
            segment.meets(&near, |s| {
                let t = (point(&segment.curve, s).y - near.origin.y) / near.dir.y;
                let (s, t) = polished(&near, &segment.curve, s, t);
                to.push(LocalHit { t: middle + t, part: i as u32, u: s, v: 0.0 });
            });
        }
    }

    /// For a ray that stays at one height: the radii there, and the ray's way through those circles.
    fn search_level(&self, ray: &Ray, to: &mut impl Collect) {
        let shift = -ray.origin.dot(ray.dir);
        let near = Ray::new(ray.at(shift), ray.dir);
        let [c, b, a] = radius_squared(&near);
        self.profile.crossings(Vec2::Y, -near.origin.y, |part, s, p| {
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
        let (min, max) = self.profile.bounds();
        if self.segments.is_empty() {
            return Aabb::EMPTY;
        }
        barrel_bounds((min.y, max.y), max.x.max(-min.x))
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
        let v = (f64::from(hit.part) + hit.u) / self.segments.len() as f64;
        Some(Vec2::new(turn(p.x, p.z), v))
    }
}
