//! Text: glyph outlines in the x-y plane, with a depth along z (shapes spec, section 6).
//!
//! Here is the text as it lies in its own frame; the slight turn that the language gives every text belongs to the
//! object's transform.
use raggio_math::{Aabb, EPS, Ray, Vec2, Vec3};
use raggio_scene::Glyph;

use super::collect::{Collect, searched_from};
use super::extruded::{Met, Seen, planes};
use super::outline::{Outline, slope};
use super::parts::Parts;
use crate::{LocalHit, Surface};

const LEAST: f64 = 1e-6;
/// Parts of a hit: piece times 4 plus one of these; the glyph is kept in `v`.
const SIDE: u32 = 0;
const FRONT: u32 = 1;
const BACK: u32 = 2;

/// A text, ready to be hit.
pub(crate) struct Text {
    glyphs: Vec<(Vec2, Outline)>,
    depth: f64,
    parts: Parts,
}

impl Text {
    /// A text of glyphs at their places. With a negative depth only the two faces are there.
    pub(crate) fn new(glyphs: &[Glyph], depth: f64) -> Self {
        let outline = |g: &Glyph| (g.offset, Outline::new(g.contours.iter().flat_map(|c| &c.curves)));
        let glyphs: Vec<_> = glyphs.iter().map(outline).collect();
        let boxes: Vec<_> = glyphs.iter().map(|(at, outline)| glyph_bounds(*at, outline, depth)).collect();
        Text { glyphs, depth, parts: Parts::new(&boxes) }
    }

    fn search(&self, ray: &Ray, to: &mut impl Collect) {
        self.parts.visit_ray(ray, to.range(), |i| {
            self.search_glyph(i, ray, to);
            to.range().1
        });
    }

    fn search_glyph(&self, i: usize, ray: &Ray, to: &mut impl Collect) {
        let (at, outline) = &self.glyphs[i];
        let o = Vec2::new(ray.origin.x, ray.origin.y) - *at;
        let d = Vec2::new(ray.dir.x, ray.dir.y);
        let (low, high) = (self.depth.min(0.0), self.depth.max(0.0));
        let Some((planes, from_behind)) = planes(ray.origin.z, ray.dir.z, (low, high)) else { return };
        // With a negative depth the back lies before the front.
        let front_first = self.depth == 0.0 || from_behind == (self.depth < 0.0);
        let (near, far) = if front_first { (FRONT, BACK) } else { (BACK, FRONT) };
        let (capped, sided) = (ray.dir.z.abs() > EPS, self.depth >= 0.0);
        let seen = Seen { origin: o, dir: d, planes, capped, sided };
        seen.search(outline, to, |t, met| match met {
            Met::Near => LocalHit { t, part: near, u: 0.0, v: i as f64 },
            Met::Far => LocalHit { t, part: far, u: 0.0, v: i as f64 },
            Met::Side(piece, s) => LocalHit { t, part: piece * 4 + SIDE, u: s, v: i as f64 },
        });
    }
}

fn glyph_bounds(at: Vec2, outline: &Outline, depth: f64) -> Aabb {
    let (min, max) = outline.bounds();
    if min.x > max.x {
        return Aabb::EMPTY;
    }
    Aabb::new((min + at).extend(0.0), (max + at).extend(depth))
}

impl Surface for Text {
    searched_from!(LEAST);

    fn bounds(&self) -> Aabb {
        self.parts.bounds()
    }

    fn inside(&self, p: Vec3) -> bool {
        let mut inside = false;
        if 0.0 <= p.z && p.z <= self.depth {
            self.parts.visit_point(p, |i| {
                let (at, outline) = &self.glyphs[i];
                inside |= outline.contains(Vec2::new(p.x, p.y) - *at);
            });
        }
        inside
    }

    fn normal(&self, _p: Vec3, hit: &LocalHit) -> Vec3 {
        match hit.part % 4 {
            FRONT => -Vec3::Z,
            BACK => Vec3::Z,
            _ => {
                let (_, outline) = &self.glyphs[hit.v as usize];
                let along = slope(outline.curve(hit.part / 4), hit.u);
                Vec3::new(along.y, -along.x, 0.0).try_normalize().unwrap_or(Vec3::X)
            }
        }
    }
}
