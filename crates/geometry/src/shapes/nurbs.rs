//! Rational B-spline surfaces, hit without facets.
//!
//! The surface is taken apart into rational Bezier patches, and each of them is searched as a [`Sheet`]: the hull of
//! control points bounds the surface over any part, and with it the derivatives.
mod bezier;
mod trim;

use raggio_function::Range;
use raggio_math::{Aabb, Ray, Vec2, Vec3, Vec4};
use raggio_scene::Nurbs;

use self::bezier::{Grid, spans};
use self::trim::Trims;
use super::parts::Parts;
use super::sheet::{Enclosure, Hits, Sheet, SheetTree};
use crate::{LocalHit, Surface};

const LEAST: f64 = 1e-6;

/// A surface, ready to be hit.
pub(crate) struct NurbsPatch {
    patches: Vec<SheetTree<Patch>>,
    parts: Parts,
    /// Where the parameters begin and end.
    domain: (Vec2, Vec2),
}

/// A rational Bezier patch over a rectangle of the surface's parameters.
struct Patch {
    lo: Vec2,
    hi: Vec2,
    /// Homogeneous control points.
    net: Grid,
    trims: std::sync::Arc<Trims>,
}

impl Patch {
    /// Where in the patch, 0 to 1, parameters are.
    fn share(&self, uv: Vec2) -> Vec2 {
        (uv - self.lo) / (self.hi - self.lo)
    }

    /// The partial derivatives by u and v.
    fn slopes(&self, uv: Vec2) -> (Vec3, Vec3) {
        let (point, du, dv) = self.net.with_slopes(self.share(uv));
        let p = point.truncate() / point.w;
        let of = |d: Vec4, size: f64| (d.truncate() - p * d.w) / (point.w * size);
        let size = self.hi - self.lo;
        (of(du, size.x), of(dv, size.y))
    }
}

impl Sheet for Patch {
    fn point(&self, uv: Vec2) -> Vec3 {
        let p = self.net.at(self.share(uv));
        p.truncate() / p.w
    }

    fn enclose(&self, lo: Vec2, hi: Vec2) -> Enclosure {
        let mut part = self.net.part(self.share(lo), self.share(hi));
        let points = || part.points().iter().map(|p| p.truncate() / p.w);
        let bounds = Aabb::around(points());
        // Differences are small around the middle, whatever the place.
        let centre = bounds.centre();
        part.move_by(-centre);
        let (du, dv) = part.slope_ranges(hi - lo);
        let local = [0, 1, 2].map(|k| Range::new(bounds.min[k] - centre[k], bounds.max[k] - centre[k]));
        let inverse = part.weights().inverse();
        let of = |d: [Range; 4]| [0, 1, 2].map(|k| (d[k] - local[k] * d[3]) * inverse);
        Enclosure { bounds, du: of(du), dv: of(dv) }
    }

    fn tolerance(&self) -> f64 {
        0.0
    }

    fn keeps(&self, uv: Vec2) -> bool {
        self.trims.keep(uv)
    }
}

impl NurbsPatch {
    /// Takes the surface apart.
    pub(crate) fn new(nurbs: &Nurbs) -> Self {
        let trims = std::sync::Arc::new(Trims::new(&nurbs.trims));
        let points = nurbs.points.iter().map(|(p, w)| (*p * *w).extend(*w)).collect();
        let whole = Grid::new(nurbs.u.points(), points);
        let mut patches = Vec::new();
        for u in spans(&nurbs.u) {
            let strip = whole.along_u(|column| u.bezier(column));
            for v in spans(&nurbs.v) {
                let net = strip.along_v(|row| v.bezier(row));
                let (lo, hi) = (Vec2::new(u.from, v.from), Vec2::new(u.to, v.to));
                patches.push(SheetTree::new(Patch { lo, hi, net, trims: trims.clone() }, lo, hi));
            }
        }
        let boxes: Vec<Aabb> = patches.iter().map(SheetTree::bounds).collect();
        let ((u0, u1), (v0, v1)) = (nurbs.u.domain(), nurbs.v.domain());
        NurbsPatch { patches, parts: Parts::new(&boxes), domain: (Vec2::new(u0, v0), Vec2::new(u1, v1)) }
    }

    fn search(&self, ray: &Ray, range: (f64, f64), nearest: bool) -> Hits {
        let mut range = super::beyond(range, LEAST);
        let mut out = Hits::new();
        self.parts.visit_ray(ray, range, |i| {
            range.1 = self.patches[i].hits(ray, range, i as u32, nearest, &mut out);
            range.1
        });
        out
    }
}

impl Surface for NurbsPatch {
    fn hits(&self, ray: &Ray, range: (f64, f64), out: &mut Vec<LocalHit>) {
        out.extend(self.search(ray, range, false));
    }

    fn closest(&self, ray: &Ray, range: (f64, f64)) -> Option<LocalHit> {
        self.search(ray, range, true).into_iter().min_by(|a, b| a.t.total_cmp(&b.t))
    }

    fn bounds(&self) -> Aabb {
        self.parts.bounds()
    }

    fn inside(&self, _p: Vec3) -> bool {
        false
    }

    fn is_solid(&self) -> bool {
        false
    }

    /// dP/du x dP/dv; where a side has shrunk to a point, that of a place nearby.
    fn normal(&self, _p: Vec3, hit: &LocalHit) -> Vec3 {
        let patch = &self.patches[hit.part as usize].sheet;
        let uv = Vec2::new(hit.u, hit.v);
        let at = |uv: Vec2| {
            let (du, dv) = patch.slopes(uv);
            let n = du.cross(dv);
            (n.length() > 1e-9 * du.length().max(dv.length()).powi(2)).then(|| n.normalize())
        };
        let inwards = uv.lerp(0.5 * (patch.lo + patch.hi), 1e-4);
        at(uv).or_else(|| at(inwards)).unwrap_or(Vec3::X)
    }

    /// The parameters, each from 0 to 1.
    fn uv(&self, _p: Vec3, hit: &LocalHit) -> Option<Vec2> {
        let (lo, hi) = self.domain;
        Some((Vec2::new(hit.u, hit.v) - lo) / (hi - lo))
    }
}

#[cfg(test)]
pub(super) mod tests;
