//! The ovus: two balls about the y axis, joined by a part of a spindle torus (shapes spec, section 2).
use raggio_math::{Aabb, Ray, Vec2, Vec3, poly};

use super::collect::{Collect, searched_from};
use super::revolve::{barrel_bounds, clip_to_barrel, radius};
use super::torus::torus_curve;
use super::turn;
use crate::{LocalHit, Surface};

const LEAST: f64 = 1e-4;
/// Parts of a hit.
const BOTTOM: u32 = 0;
const TOP: u32 = 1;
const JOIN: u32 = 2;

/// An egg.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Ovus {
    bottom: f64,
    top: f64,
    join: Join,
}

/// `(rho + inset)^2 + (y - height)^2 = radius^2` for `from < y < to`.
#[derive(Clone, Copy, Debug)]
struct Join {
    radius: f64,
    height: f64,
    inset: f64,
    from: f64,
    to: f64,
}

impl Join {
    /// `None` where the top ball holds everything.
    fn new(b: f64, t: f64) -> Option<Join> {
        if t >= 2.0 * b {
            return None;
        }
        if b > t {
            let (s, v) = (2.0 * b, 2.0 * t - b - t * t / (2.0 * b));
            let h = (b * b - v * v).sqrt();
            return Some(Join { radius: s, height: v, inset: h, from: -v, to: (b - v) * t / (s - t) + b });
        }
        let (s, v) = (2.0 * t, b - 2.0 * t + 1.5 * t * t / b);
        let h = (t * t - (v - b) * (v - b)).sqrt();
        Some(Join { radius: s, height: v, inset: h, from: -v * b / (s - b), to: 2.0 * b - v })
    }
}

impl Ovus {
    /// Both radii positive; a top of twice the bottom or more is a sphere.
    pub(crate) fn new(bottom: f64, top: f64) -> Self {
        let everything =
            Join { radius: 0.0, height: 0.0, inset: 0.0, from: f64::NEG_INFINITY, to: f64::NEG_INFINITY };
        Ovus { bottom, top, join: Join::new(bottom, top).unwrap_or(everything) }
    }

    fn heights(&self) -> (f64, f64) {
        let low = if self.join.from.is_finite() { -self.bottom } else { self.bottom - self.top };
        (low, self.bottom + self.top)
    }

    fn search(&self, ray: &Ray, to: &mut impl Collect) {
        let Join { from, to: end, .. } = self.join;
        self.search_ball(ray, (BOTTOM, 0.0, self.bottom), (f64::NEG_INFINITY, from), to);
        self.search_ball(ray, (TOP, self.bottom, self.top), (end, f64::INFINITY), to);
        self.search_join(ray, to);
    }

    /// One ball where its height lies in the closed range.
    fn search_ball(
        &self,
        ray: &Ray,
        (part, height, radius): (u32, f64, f64),
        heights: (f64, f64),
        to: &mut impl Collect,
    ) {
        let from_centre = ray.origin - Vec3::new(0.0, height, 0.0);
        let middle = -from_centre.dot(ray.dir);
        let half2 = radius * radius - (from_centre + ray.dir * middle).length_squared();
        if half2.is_nan() || half2 <= 0.0 {
            return;
        }
        let half = half2.sqrt();
        for t in [middle - half, middle + half] {
            let y = ray.origin.y + t * ray.dir.y;
            if heights.0 <= y && y <= heights.1 {
                to.push(LocalHit { t, part, ..LocalHit::default() });
            }
        }
    }

    fn search_join(&self, ray: &Ray, to: &mut impl Collect) {
        let j = &self.join;
        let reach = (j.radius - j.inset).max(self.bottom.max(self.top));
        let Some((lo, hi)) = clip_to_barrel(ray, (j.from, j.to), reach, to.range()) else { return };
        let start = Ray::new(ray.at(lo) - Vec3::new(0.0, j.height, 0.0), ray.dir);
        let curve = torus_curve(&start, hi - lo, j.inset, j.radius);
        for &s in poly::bernstein_roots(&curve).iter() {
            // Of the two sheets of the spindle only the inner one is the egg's.
            let t = s * (hi - lo);
            let p = start.at(t);
            let inner = p.length_squared() + j.inset * j.inset <= j.radius * j.radius;
            if inner {
                to.push(LocalHit { t: lo + t, part: JOIN, ..LocalHit::default() });
            }
        }
    }
}

impl Surface for Ovus {
    searched_from!(LEAST);

    fn bounds(&self) -> Aabb {
        let reach = (self.join.radius - self.join.inset).max(self.bottom.max(self.top));
        barrel_bounds(self.heights(), reach)
    }

    fn reach(&self, along: Vec3) -> Option<f64> {
        let j = &self.join;
        let (level, length) = (along.x.hypot(along.z), along.length());
        let ball = |height: f64, radius: f64| height * along.y + radius * length;
        let joined = ball(j.height, j.radius) - j.inset * level;
        let (bounds, (low, high)) = (self.bounds(), self.heights());
        let barrel = bounds.max.x * level + (low * along.y).max(high * along.y);
        Some(barrel.min(joined.max(ball(0.0, self.bottom)).max(ball(self.bottom, self.top))))
    }

    fn inside(&self, p: Vec3) -> bool {
        let from_top = Vec3::new(p.x, p.y - self.bottom, p.z);
        if p.length_squared() < self.bottom * self.bottom || from_top.length_squared() < self.top * self.top {
            return true;
        }
        let j = &self.join;
        let off = Vec2::new(radius(p) + j.inset, p.y - j.height);
        j.from < p.y && p.y < j.to && off.length_squared() < j.radius * j.radius
    }

    fn normal(&self, p: Vec3, hit: &LocalHit) -> Vec3 {
        let n = match hit.part {
            BOTTOM => p,
            TOP => Vec3::new(p.x, p.y - self.bottom, p.z),
            _ => {
                let rho = radius(p);
                let k = if rho > 0.0 { 1.0 + self.join.inset / rho } else { 0.0 };
                Vec3::new(p.x * k, p.y - self.join.height, p.z * k)
            }
        };
        n.try_normalize().unwrap_or(Vec3::Y)
    }

    fn uv(&self, p: Vec3, _hit: &LocalHit) -> Option<Vec2> {
        let q = Vec3::new(p.x, p.y - 0.5 * self.top, p.z).try_normalize().unwrap_or(Vec3::Y);
        let v = 0.5 + q.y.clamp(-1.0, 1.0).asin() / std::f64::consts::PI;
        Some(Vec2::new(turn(p.x, p.z), v))
    }
}
