//! The polygon: closed loops in one plane.
use raggio_math::{Aabb, EPS, Ray, Vec2, Vec3};

use super::beyond;
use crate::{LocalHit, Surface};

/// The least distance a polygon reports.
const LEAST: f64 = 1e-8;

/// Differences of corners shorter than this do not make the plane's frame.
const SHORT: f64 = 1e-5;

/// Loops in a plane; a point belongs where a line from it crosses them an odd number of times.
pub(crate) struct Polygon {
    origin: Vec3,
    x: Vec3,
    y: Vec3,
    normal: Vec3,
    /// Edges of all loops in the plane's coordinates.
    edges: Vec<(Vec2, Vec2)>,
    rows: Rows,
    bounds: Aabb,
}

/// The most rows into which edges are sorted.
const MOST_ROWS: usize = 256;

/// Edges sorted by the rows of y in which they lie.
#[derive(Default)]
struct Rows {
    low: f64,
    /// Rows per length.
    scale: f64,
    /// Where the edges of each row begin, and where those of the last end.
    starts: Vec<u32>,
    edges: Vec<Edge>,
}

#[derive(Clone, Copy)]
struct Edge {
    from: Vec2,
    to_y: f64,
    /// What x grows by for each y.
    lean: f64,
}

impl Rows {
    fn new(edges: &[(Vec2, Vec2)]) -> Self {
        let count = edges.len().min(MOST_ROWS);
        let ends = || edges.iter().map(|(a, _)| a.y);
        let (low, high) = (ends().fold(f64::INFINITY, f64::min), ends().fold(f64::NEG_INFINITY, f64::max));
        let mut rows = Rows { low, scale: count as f64 / (high - low), ..Rows::default() };
        // The row of a point is found by the same sum, so that rounding finds the same row.
        let span = |&(a, b): &(Vec2, Vec2)| (rows.row(a.y.min(b.y)), rows.row(a.y.max(b.y)));
        let spans: Vec<_> = edges.iter().map(span).collect();
        for row in 0..count as u32 {
            rows.starts.push(rows.edges.len() as u32);
            for (&(a, b), _) in edges.iter().zip(&spans).filter(|(_, s)| s.0 <= row && row <= s.1) {
                rows.edges.push(Edge { from: a, to_y: b.y, lean: (b.x - a.x) / (b.y - a.y) });
            }
        }
        rows.starts.push(rows.edges.len() as u32);
        rows
    }

    /// Beyond the ends it is a row that is not there, or one whose edges all lie on the other side.
    #[inline]
    fn row(&self, y: f64) -> u32 {
        ((y - self.low) * self.scale) as u32
    }

    /// The edges that may be at a height.
    #[inline]
    fn at(&self, y: f64) -> &[Edge] {
        // The topmost corner is at the end of the last row.
        let row = (self.row(y) as usize).min(self.starts.len().saturating_sub(2));
        match self.starts[row..] {
            [from, to, ..] => &self.edges[from as usize..to as usize],
            _ => &[],
        }
    }
}

impl Polygon {
    /// Loops that do not lie in one plane make a polygon that is never hit.
    pub(crate) fn new(loops: &[Vec<Vec3>]) -> Self {
        let points: Vec<Vec3> = loops.iter().flatten().copied().collect();
        let nothing = Polygon {
            origin: Vec3::ZERO,
            x: Vec3::X,
            y: Vec3::Y,
            normal: Vec3::Z,
            edges: Vec::new(),
            rows: Rows::default(),
            bounds: Aabb::EMPTY,
        };
        let Some((origin, x, normal)) = frame(&points) else {
            return nothing;
        };
        if points.iter().any(|p| (*p - origin).dot(normal).abs() > EPS) {
            return nothing;
        }
        let y = normal.cross(x);
        let flat = |p: &Vec3| Vec2::new((*p - origin).dot(x), (*p - origin).dot(y));
        let edges: Vec<_> = loops
            .iter()
            .flat_map(|l| l.iter().zip(l.iter().cycle().skip(1)).map(|(a, b)| (flat(a), flat(b))))
            .filter(|(a, b)| a != b)
            .collect();
        let rows = Rows::new(&edges);
        Polygon { origin, x, y, normal, edges, rows, bounds: Aabb::around(points) }
    }

    fn contains(&self, p: Vec2) -> bool {
        let mut odd = false;
        for &Edge { from, to_y, lean } in self.rows.at(p.y) {
            odd ^= (from.y >= p.y) != (to_y >= p.y) && p.x < from.x + (p.y - from.y) * lean;
        }
        odd
    }
}

/// Origin, x axis and normal of the plane of some points.
fn frame(points: &[Vec3]) -> Option<(Vec3, Vec3, Vec3)> {
    let origin = *points.first()?;
    let mut differences = points.iter().map(|p| *p - origin).filter(|d| d.length() > SHORT);
    let x = differences.next()?.normalize();
    let normal = differences.map(|d| x.cross(d.normalize())).find(|n| n.length() > SHORT)?;
    Some((origin, x, normal.normalize()))
}

impl Surface for Polygon {
    fn bounds(&self) -> Aabb {
        self.bounds
    }

    fn reach(&self, along: Vec3) -> Option<f64> {
        let flat = Vec2::new(self.x.dot(along), self.y.dot(along));
        let corners = self.edges.iter().map(|(a, _)| a.dot(flat));
        Some(self.origin.dot(along) + corners.fold(f64::NEG_INFINITY, f64::max))
    }

    fn hits(&self, ray: &Ray, range: (f64, f64), out: &mut Vec<LocalHit>) {
        out.extend(self.closest(ray, range));
    }

    fn closest(&self, ray: &Ray, range: (f64, f64)) -> Option<LocalHit> {
        let (lo, hi) = beyond(range, LEAST);
        let slope = self.normal.dot(ray.dir);
        if slope.abs() < EPS {
            return None;
        }
        let t = (self.origin - ray.origin).dot(self.normal) / slope;
        let p = ray.at(t) - self.origin;
        let there = t > lo && t < hi && self.contains(Vec2::new(p.dot(self.x), p.dot(self.y)));
        there.then(|| LocalHit::at(t))
    }

    fn inside(&self, _: Vec3) -> bool {
        false
    }

    fn is_solid(&self) -> bool {
        false
    }

    fn normal(&self, _: Vec3, _: &LocalHit) -> Vec3 {
        self.normal
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn rows_hold_all_edges_that_are_crossed() {
        let corner = |k: i32| {
            let at = Vec2::from_angle(f64::from(k) * std::f64::consts::TAU / 30.0);
            (at * if k % 2 == 0 { 0.6 } else { 1.1 }).extend(0.0)
        };
        let hole = |k: i32| (Vec2::from_angle(f64::from(k)) * 0.2).extend(0.0);
        let star = Polygon::new(&[(0..30).map(corner).collect(), (0..6).map(hole).collect()]);
        let corners = star.edges.iter().map(|(a, _)| *a);
        let lattice = (0..40_000).map(|k| Vec2::new(f64::from(k % 200), f64::from(k / 200)));
        let mut inside = 0;
        for p in corners.chain(lattice.map(|p| p / 80.0 - Vec2::new(2.3, 1.3))) {
            let crossed = star.edges.iter().filter(|(a, b)| {
                (a.y >= p.y) != (b.y >= p.y) && p.x < a.x + (p.y - a.y) * ((b.x - a.x) / (b.y - a.y))
            });
            assert_eq!(star.contains(p), crossed.count() % 2 == 1, "{p}");
            inside += u32::from(star.contains(p));
        }
        assert!((9_000..20_000).contains(&inside), "{inside}");
    }
}
