//! The prism: an outline in the x-z plane swept along y, straight or towards the origin (shapes spec, section 5).
use raggio_math::{Aabb, EPS, Ray, Vec2, Vec3};

use super::collect::{Collect, searched_from};
use super::extruded::{Met, Seen, planes};
use super::outline::{Outline, slope};
use super::plane_tree::Line;
use super::revolve::clip_to_slab;
use crate::{LocalHit, Surface};

const LEAST: f64 = 1e-4;
/// Parts of a hit at and above this are the caps.
const CAP: u32 = u32::MAX - 1;

/// A prism, ready to be hit.
#[derive(Clone, Debug)]
pub(crate) struct Prism {
    outline: Outline,
    heights: (f64, f64),
    conic: bool,
    open: bool,
    bounds: Aabb,
}

impl Prism {
    /// Makes a prism ready.
    pub(crate) fn new(prism: &raggio_scene::Prism) -> Self {
        let outline = Outline::new(&prism.curves);
        let heights = prism.heights;
        let bounds = bounds(&outline, heights, prism.conic);
        Prism { outline, heights, conic: prism.conic, open: prism.open, bounds }
    }

    fn search(&self, ray: &Ray, to: &mut impl Collect) {
        let Some((near, far)) = self.bounds.grown(1e-9).hit(ray) else { return };
        if far <= to.range().0 || near >= to.range().1 {
            return;
        }
        if !self.conic {
            return self.search_straight(ray, to);
        }
        if !self.open {
            self.search_caps(ray, to);
        }
        self.search_cone(ray, to);
    }

    fn search_caps(&self, ray: &Ray, to: &mut impl Collect) {
        if ray.dir.y.abs() < EPS {
            return;
        }
        for (k, h) in [(0, self.heights.0), (1, self.heights.1)] {
            let t = (h - ray.origin.y) / ray.dir.y;
            let (lo, hi) = to.range();
            if lo < t && t < hi && self.section_contains(ray.at(t), h) {
                to.push(LocalHit { t, part: CAP + k, ..LocalHit::default() });
            }
        }
    }

    /// Is the point in the outline as it is at height `h`?
    fn section_contains(&self, p: Vec3, h: f64) -> bool {
        let q = Vec2::new(p.x, p.z);
        if !self.conic {
            return self.outline.contains(q);
        }
        h.abs() > EPS && self.outline.contains(q / h)
    }

    fn search_straight(&self, ray: &Ray, to: &mut impl Collect) {
        let Some((planes, from_above)) = planes(ray.origin.y, ray.dir.y, self.heights) else { return };
        let seen = Seen {
            origin: Vec2::new(ray.origin.x, ray.origin.z),
            dir: Vec2::new(ray.dir.x, ray.dir.z),
            planes,
            capped: !self.open && ray.dir.y.abs() >= EPS,
            sided: true,
        };
        let (near, far) = (CAP + u32::from(from_above), CAP + u32::from(!from_above));
        seen.search(&self.outline, to, |t, met| match met {
            Met::Near => LocalHit { t, part: near, ..LocalHit::default() },
            Met::Far => LocalHit { t, part: far, ..LocalHit::default() },
            Met::Side(part, s) => LocalHit { t, part, u: s, v: 0.0 },
        });
    }

    /// The plane through the origin and the ray meets the outline at height 1 in a line.
    fn search_cone(&self, ray: &Ray, to: &mut impl Collect) {
        let (o, d) = (ray.origin, ray.dir);
        let n = o.cross(d);
        let Some(slab) = clip_to_slab(o.y, d.y, self.heights, to.range()) else { return };
        if n.length_squared() < EPS * EPS {
            return;
        }
        let mut line = Line::new(Vec2::new(n.x, n.z), n.y);
        // Seen from the tip, what lies between two points on the same side of it stays between them.
        let (a, b) = (o + d * slab.0, o + d * slab.1);
        if a.y * b.y > 0.0 {
            line = line.between(Vec2::new(a.x, a.z) / a.y, Vec2::new(b.x, b.z) / b.y);
        }
        self.outline.crossings(&line, |part, s, p| {
            // o + t d is a multiple of c.
            let c = Vec3::new(p.x, 1.0, p.y);
            let (oc, dc) = (o.cross(c), d.cross(c));
            let t = -oc.dot(dc) / dc.length_squared();
            if slab.0 <= t && t <= slab.1 {
                to.push(LocalHit { t, part, u: s, v: 0.0 });
            }
        });
    }
}

/// The box around the two end sections.
fn bounds(outline: &Outline, heights: (f64, f64), conic: bool) -> Aabb {
    let (min, max) = outline.bounds();
    let section = |h: f64| {
        let k = if conic { h } else { 1.0 };
        Aabb::new(Vec3::new(min.x * k, h, min.y * k), Vec3::new(max.x * k, h, max.y * k))
    };
    if min.x > max.x { Aabb::EMPTY } else { section(heights.0).union(&section(heights.1)) }
}

impl Surface for Prism {
    searched_from!(LEAST);

    fn bounds(&self) -> Aabb {
        self.bounds
    }

    fn reach(&self, along: Vec3) -> Option<f64> {
        let section = |h: f64| {
            let k = if self.conic { h } else { 1.0 };
            self.outline.reach(Vec2::new(along.x, along.z) * k) + h * along.y
        };
        Some(section(self.heights.0).max(section(self.heights.1)))
    }

    fn inside(&self, p: Vec3) -> bool {
        self.heights.0 <= p.y && p.y < self.heights.1 && self.section_contains(p, p.y)
    }

    fn normal(&self, p: Vec3, hit: &LocalHit) -> Vec3 {
        if hit.part >= CAP {
            return Vec3::Y;
        }
        let along = slope(self.outline.curve(hit.part), hit.u);
        let mut n = Vec3::new(along.y, 0.0, -along.x);
        if self.conic && p.y.abs() > EPS {
            n.y = -(p.x * n.x + p.z * n.z) / p.y;
        }
        n.try_normalize().unwrap_or(Vec3::Y)
    }
}
