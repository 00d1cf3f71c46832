//! The surface of revolution: the square of the radius is a cubic of the height, piece by piece (shapes spec,
//! section 5).
use raggio_math::{Aabb, EPS, Ray, Vec2, Vec3, poly};

use super::collect::{Collect, Offset, searched_from};
use super::revolve::{barrel_bounds, circle_reach, clip_to_barrel, radius, radius_squared};
use super::turn;
use crate::{LocalHit, Surface};

const LEAST: f64 = 1e-4;
/// Ends with a smaller square of the radius have no cap.
const LEAST_CAP: f64 = 1e-4;
/// Parts of a hit: segments from 0, and the two caps.
const BASE: u32 = u32::MAX - 1;
const TOP: u32 = u32::MAX;

/// A surface of revolution.
#[derive(Clone, Debug)]
pub(crate) struct Sor {
    segments: Vec<Segment>,
    /// The greatest radius.
    reach: f64,
    open: bool,
}

/// `r^2 = c0 + c1 h + c2 h^2 + c3 h^3` for `h = y - base` up to the next segment.
#[derive(Clone, Copy, Debug)]
struct Segment {
    base: f64,
    top: f64,
    c: [f64; 4],
    /// The greatest radius.
    reach: f64,
}

impl Segment {
    fn new(p: &[Vec2]) -> Self {
        let (base, top) = (p[1].y, p[2].y);
        let height = top - base;
        let (v1, v2) = (p[1].x * p[1].x, p[2].x * p[2].x);
        let m1 = 2.0 * p[1].x * (p[2].x - p[0].x) / (p[2].y - p[0].y);
        let m2 = 2.0 * p[2].x * (p[3].x - p[1].x) / (p[3].y - p[1].y);
        let rise = (v2 - v1) / height;
        let c = [v1, m1, (3.0 * rise - 2.0 * m1 - m2) / height, (m1 + m2 - 2.0 * rise) / (height * height)];
        let turning = poly::quadratic([c[1], 2.0 * c[2], 3.0 * c[3]]);
        let inner = turning.iter().filter(|h| (0.0..height).contains(*h)).map(|&h| poly::eval(&c, h));
        let reach = inner.fold(v1.max(v2), f64::max).max(0.0).sqrt();
        Segment { base, top, c, reach }
    }

    fn radius_squared(&self, y: f64) -> f64 {
        poly::eval(&self.c, (y - self.base).clamp(0.0, self.top - self.base))
    }

    /// How far a point lies outside: the difference of the squares of its radius and the surface's.
    fn off(&self, p: Vec3) -> f64 {
        p.x * p.x + p.z * p.z - self.radius_squared(p.y)
    }

    /// The distances at which the ray meets the surface on a stretch, as shares of it; [`Segment::off`] is known at its
    /// ends.
    fn meets(&self, ray: &Ray, (lo, hi): (f64, f64), (at_lo, at_hi): (f64, f64)) -> poly::Roots<4> {
        let (start, way) = (ray.at(lo), ray.dir * (hi - lo));
        let [c, b, a] = radius_squared(&Ray::new(start, way));
        let h = [start.y - self.base, way.y];
        let k = &self.c;
        let cubic = [
            c - poly::eval(k, h[0]),
            b - h[1] * (k[1] + h[0] * (2.0 * k[2] + h[0] * 3.0 * k[3])),
            a - h[1] * h[1] * (k[2] + 3.0 * h[0] * k[3]),
            -h[1] * h[1] * h[1] * k[3],
        ];
        poly::roots_in_unit(&cubic, at_lo, at_hi)
    }
}

impl Sor {
    /// Points are (radius, height); the first and the last only steer.
    pub(crate) fn new(points: &[Vec2], open: bool) -> Self {
        let segments: Vec<_> = points.windows(4).map(Segment::new).collect();
        let reach = segments.iter().map(|s| s.reach).fold(0.0, f64::max);
        Sor { segments, reach, open }
    }

    /// Heights and radius of the barrel around it.
    fn barrel(&self) -> ((f64, f64), f64) {
        let heights = match (self.segments.first(), self.segments.last()) {
            (Some(first), Some(last)) => (first.base, last.top),
            _ => (f64::INFINITY, f64::NEG_INFINITY),
        };
        (heights, self.reach)
    }

    fn search(&self, ray: &Ray, to: &mut impl Collect) {
        let (heights, reach) = self.barrel();
        let margin = 1e-9 * (1.0 + heights.0.abs().max(heights.1.abs()));
        let heights = (heights.0 - margin, heights.1 + margin);
        let Some((lo, hi)) = clip_to_barrel(ray, heights, reach * (1.0 + 1e-9), to.range()) else { return };
        self.search_caps(ray, to);
        // From a place nearby digits are not lost to the distance.
        let middle = 0.5 * (lo + hi);
        let near = Ray::new(ray.at(middle), ray.dir);
        self.search_side(&near, (lo - middle, hi - middle), &mut Offset { start: middle, to });
    }

    fn search_caps(&self, ray: &Ray, to: &mut impl Collect) {
        if self.open || ray.dir.y.abs() <= EPS {
            return;
        }
        for (part, height, radius2) in self.caps() {
            let t = (height - ray.origin.y) / ray.dir.y;
            let p = ray.at(t);
            if p.x * p.x + p.z * p.z <= radius2 {
                to.push(LocalHit { t, part, ..LocalHit::default() });
            }
        }
    }

    /// The segments in the order in which the ray comes to them. A level ray at a joint belongs to the one above.
    fn search_side(&self, ray: &Ray, (lo, hi): (f64, f64), to: &mut impl Collect) {
        let (upwards, y) = (ray.dir.y >= 0.0, ray.origin.y + lo * ray.dir.y);
        let below = match upwards {
            true => self.segments.partition_point(|s| s.top <= y),
            false => self.segments.partition_point(|s| s.base < y),
        };
        let count = if upwards { self.segments.len() - below } else { below };
        // Finite, so that no product with zero is undefined.
        let per_y = (1.0 / ray.dir.y).clamp(-1e300, 1e300);
        let joint = |height: f64| match ray.dir.y == 0.0 {
            true if height > ray.origin.y => hi,
            true => lo,
            false => ((height - ray.origin.y) * per_y).clamp(lo, hi),
        };
        // Where two segments meet, both take the side of the ray that the first has found.
        let mut start = None;
        for k in 0..count {
            let i = if upwards { below + k } else { below - 1 - k };
            let s = &self.segments[i];
            let (first, last) = if upwards { (s.base, s.top) } else { (s.top, s.base) };
            let (a, off_a) = start.unwrap_or_else(|| (joint(first), s.off(ray.at(joint(first)))));
            if a >= hi.min(to.range().1) {
                return;
            }
            let b = joint(last);
            let off_b = s.off(ray.at(b));
            for &share in s.meets(ray, (a, b), (off_a, off_b)).iter() {
                to.push(LocalHit { t: a + share * (b - a), part: i as u32, ..LocalHit::default() });
            }
            start = Some((b, off_b));
        }
    }

    /// Part, height and square of the radius of the caps.
    fn caps(&self) -> impl Iterator<Item = (u32, f64, f64)> + '_ {
        let base = self.segments.first().map(|s| (BASE, s.base, s.radius_squared(s.base)));
        let top = self.segments.last().map(|s| (TOP, s.top, s.radius_squared(s.top)));
        base.into_iter().chain(top).filter(|cap| cap.2 > LEAST_CAP)
    }

    fn segment_at(&self, y: f64) -> Option<&Segment> {
        self.segments.iter().find(|s| s.base <= y && y <= s.top)
    }
}

impl Surface for Sor {
    searched_from!(LEAST);

    fn bounds(&self) -> Aabb {
        if self.segments.is_empty() {
            return Aabb::EMPTY;
        }
        let (heights, reach) = self.barrel();
        barrel_bounds(heights, reach)
    }

    fn reach(&self, along: Vec3) -> Option<f64> {
        let circle = |s: &Segment, y: f64| circle_reach(y, s.reach, along);
        let reaches = self.segments.iter().map(|s| circle(s, s.base).max(circle(s, s.top)));
        Some(reaches.fold(f64::NEG_INFINITY, f64::max))
    }

    fn inside(&self, p: Vec3) -> bool {
        self.segment_at(p.y).is_some_and(|s| p.x * p.x + p.z * p.z <= s.radius_squared(p.y))
    }

    fn normal(&self, p: Vec3, hit: &LocalHit) -> Vec3 {
        match hit.part {
            BASE => -Vec3::Y,
            TOP => Vec3::Y,
            part => {
                let Segment { c, base, .. } = &self.segments[part as usize];
                let h = p.y - base;
                let slope = c[1] + h * (2.0 * c[2] + h * 3.0 * c[3]);
                Vec3::new(p.x, -0.5 * slope, p.z).try_normalize().unwrap_or(Vec3::Y)
            }
        }
    }

    fn uv(&self, p: Vec3, hit: &LocalHit) -> Option<Vec2> {
        let share = |y: f64| radius(p) / self.segment_at(y).map_or(1.0, |s| s.radius_squared(y).sqrt());
        let v = match hit.part {
            BASE => share(self.segments[0].base) - 1.0,
            TOP => 2.0 - share(self.segments[self.segments.len() - 1].top),
            part => {
                let s = &self.segments[part as usize];
                (f64::from(part) + (p.y - s.base) / (s.top - s.base)) / self.segments.len() as f64
            }
        };
        Some(Vec2::new(turn(p.x, p.z), v))
    }
}
