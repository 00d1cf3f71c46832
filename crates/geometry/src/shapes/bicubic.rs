//! The bicubic patch, cut into triangles with the normals of the true surface (shapes spec, section 3).
use raggio_math::{Aabb, Ray, Vec2, Vec3};

use super::collect::{Collect, searched_from};
use super::parts::Parts;
use crate::{LocalHit, Surface};

const LEAST: f64 = 1e-5;
/// Halvings beyond this in one direction would fill the memory and change nothing that can be seen.
const MOST_STEPS: u32 = 10;
/// Barycentric coordinates this little below zero still count, so that neighbours leave no crack.
const EDGE: f64 = 1e-10;

/// `points[i][j]`, i along u, j along v.
type Grid = [[Vec3; 4]; 4];

/// A patch, ready to be hit.
pub(crate) struct Bicubic {
    triangles: Vec<Triangle>,
    parts: Parts,
    /// Texture coordinates of the corners, around the patch.
    uv: [Vec2; 4],
}

#[derive(Clone, Copy, Debug)]
struct Triangle {
    points: [Vec3; 3],
    normals: [Vec3; 3],
    /// The patch's parameters (u, v).
    params: [Vec2; 3],
}

/// What decides how far the patch is cut.
struct Limits {
    flatness: f64,
    u_steps: u32,
    v_steps: u32,
}

impl Bicubic {
    /// Cuts the patch.
    pub(crate) fn new(points: &Grid, flatness: f64, u_steps: u32, v_steps: u32, uv: [Vec2; 4]) -> Self {
        let limits = Limits { flatness, u_steps: u_steps.min(MOST_STEPS), v_steps: v_steps.min(MOST_STEPS) };
        let mut triangles = Vec::new();
        cut(points, points, (Vec2::ZERO, Vec2::ONE), 0, &limits, &mut triangles);
        let boxes: Vec<_> = triangles.iter().map(|t| Aabb::around(t.points)).collect();
        Bicubic { triangles, parts: Parts::new(&boxes), uv }
    }

    fn search(&self, ray: &Ray, to: &mut impl Collect) {
        self.parts.visit_ray(ray, to.range(), |i| {
            if let Some((t, u, v)) = self.triangles[i].hit(ray) {
                to.push(LocalHit { t, part: i as u32, u, v });
            }
            to.range().1
        });
    }
}

impl Triangle {
    /// Distance and the weights of the second and third corner (Moeller and Trumbore, 1997).
    fn hit(&self, ray: &Ray) -> Option<(f64, f64, f64)> {
        let [a, b, c] = self.points;
        let (e1, e2) = (b - a, c - a);
        let p = ray.dir.cross(e2);
        let det = e1.dot(p);
        let from = ray.origin - a;
        let u = from.dot(p) / det;
        let q = from.cross(e1);
        let v = ray.dir.dot(q) / det;
        // False for a triangle without area, too: all of these are then not numbers.
        let within = u >= -EDGE && v >= -EDGE && u + v <= 1.0 + EDGE;
        within.then(|| (e2.dot(q) / det, u, v))
    }
}

/// Appends the triangles of the part of the patch over a rectangle of parameters, whose control points are `part`.
fn cut(patch: &Grid, part: &Grid, rect: (Vec2, Vec2), depth: u32, limits: &Limits, out: &mut Vec<Triangle>) {
    let (along_u, along_v) = (depth < limits.u_steps, depth < limits.v_steps);
    if !(along_u || along_v) || is_flat(part, limits.flatness) {
        return add_cell(patch, part, rect, out);
    }
    let middle = 0.5 * (rect.0 + rect.1);
    let halves_u = if along_u {
        let (near, far) = halves(part);
        vec![(near, rect.0.x, middle.x), (far, middle.x, rect.1.x)]
    } else {
        vec![(*part, rect.0.x, rect.1.x)]
    };
    for (part, u0, u1) in halves_u {
        let mut corner = |part: &Grid, v0, v1| {
            cut(patch, part, (Vec2::new(u0, v0), Vec2::new(u1, v1)), depth + 1, limits, out);
        };
        if along_v {
            let (near, far) = halves(&transposed(&part));
            corner(&transposed(&near), rect.0.y, middle.y);
            corner(&transposed(&far), middle.y, rect.1.y);
        } else {
            corner(&part, rect.0.y, rect.1.y);
        }
    }
}

fn transposed(g: &Grid) -> Grid {
    std::array::from_fn(|i| std::array::from_fn(|j| g[j][i]))
}

/// De Casteljau's halving in u.
fn halves(g: &Grid) -> (Grid, Grid) {
    let (mut near, mut far) = (*g, *g);
    for j in 0..4 {
        let p = [g[0][j], g[1][j], g[2][j], g[3][j]];
        let mid = |a: Vec3, b: Vec3| 0.5 * (a + b);
        let (ab, bc, cd) = (mid(p[0], p[1]), mid(p[1], p[2]), mid(p[2], p[3]));
        let (abc, bcd) = (mid(ab, bc), mid(bc, cd));
        let whole = mid(abc, bcd);
        (near[1][j], near[2][j], near[3][j]) = (ab, abc, whole);
        (far[0][j], far[1][j], far[2][j]) = (whole, bcd, cd);
    }
    (near, far)
}

/// Are all control points within `flatness` of the plane of three corners?
fn is_flat(g: &Grid, flatness: f64) -> bool {
    let (a, b, mut c) = (g[0][0], g[0][3], g[3][0]);
    let same = |p: Vec3, q: Vec3| (p - q).abs().max_element() < raggio_math::EPS;
    if flatness <= 0.0 || same(a, b) {
        return false;
    }
    if same(a, c) || same(b, c) {
        c = g[3][3];
    }
    let Some(normal) = (b - a).cross(c - a).try_normalize() else { return false };
    g.iter().flatten().all(|&p| (p - a).dot(normal).abs() < flatness)
}

fn add_cell(patch: &Grid, part: &Grid, (lo, hi): (Vec2, Vec2), out: &mut Vec<Triangle>) {
    let corners = [
        (part[0][0], lo),
        (part[0][3], Vec2::new(lo.x, hi.y)),
        (part[3][3], hi),
        (part[3][0], Vec2::new(hi.x, lo.y)),
    ]
    .map(|(p, at)| (p, normal_at(patch, at), at));
    for [a, b, c] in [[0, 1, 2], [0, 2, 3]].map(|t| t.map(|k: usize| corners[k])) {
        out.push(Triangle { points: [a.0, b.0, c.0], normals: [a.1, b.1, c.1], params: [a.2, b.2, c.2] });
    }
}

/// The unit normal of the true surface, dP/du x dP/dv; x where there is none.
fn normal_at(g: &Grid, at: Vec2) -> Vec3 {
    let basis = |t: f64| {
        let s = 1.0 - t;
        ([s * s * s, 3.0 * s * s * t, 3.0 * s * t * t, t * t * t], {
            [-3.0 * s * s, 3.0 * s * (s - 2.0 * t), 3.0 * t * (2.0 * s - t), 3.0 * t * t]
        })
    };
    let ((u, du), (v, dv)) = (basis(at.x), basis(at.y));
    let sum = |a: &[f64; 4], b: &[f64; 4]| -> Vec3 {
        (0..16).map(|k| g[k / 4][k % 4] * (a[k / 4] * b[k % 4])).sum()
    };
    sum(&du, &v).cross(sum(&u, &dv)).try_normalize().unwrap_or(Vec3::X)
}

impl Surface for Bicubic {
    searched_from!(LEAST);

    fn bounds(&self) -> Aabb {
        self.parts.bounds()
    }

    fn reach(&self, along: Vec3) -> Option<f64> {
        let corners = self.triangles.iter().flat_map(|t| t.points);
        Some(corners.map(|p| p.dot(along)).fold(f64::NEG_INFINITY, f64::max))
    }

    fn inside(&self, _p: Vec3) -> bool {
        false
    }

    fn is_solid(&self) -> bool {
        false
    }

    fn normal(&self, _p: Vec3, hit: &LocalHit) -> Vec3 {
        let [a, b, c] = self.triangles[hit.part as usize].normals;
        (a * (1.0 - hit.u - hit.v) + b * hit.u + c * hit.v).try_normalize().unwrap_or(Vec3::X)
    }

    fn uv(&self, _p: Vec3, hit: &LocalHit) -> Option<Vec2> {
        let [a, b, c] = self.triangles[hit.part as usize].params;
        let at = a * (1.0 - hit.u - hit.v) + b * hit.u + c * hit.v;
        let [s0, s1, s2, s3] = self.uv;
        Some(s0.lerp(s1, at.y).lerp(s3.lerp(s2, at.y), at.x))
    }
}
