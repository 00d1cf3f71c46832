//! The polygon: closed loops in one plane.
use raggio_math::{Aabb, EPS, Ray, Vec2, Vec3};

use super::beyond;
use super::plane_tree::PlaneTree;
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
    tree: PlaneTree,
    bounds: Aabb,
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
            tree: PlaneTree::new(&[]),
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
        let boxes: Vec<_> = edges.iter().map(|&(a, b): &(Vec2, Vec2)| (a.min(b), a.max(b))).collect();
        let tree = PlaneTree::new(&boxes);
        Polygon { origin, x, y, normal, edges, tree, bounds: Aabb::around(points) }
    }

    fn contains(&self, p: Vec2) -> bool {
        let mut odd = false;
        self.tree.visit(
            |node| node.max.x < p.x || node.min.y > p.y || node.max.y < p.y,
            |i, _| {
                let (a, b) = self.edges[i];
                if (a.y >= p.y) != (b.y >= p.y) && p.x < a.x + (p.y - a.y) / (b.y - a.y) * (b.x - a.x) {
                    odd = !odd;
                }
            },
        );
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
