//! The parametric surface: three functions of u and v (shapes spec, section 7).
//!
//! Each function is known to stay within a slope, so over a rectangle of parameters the surface stays in a box around
//! its four corners. Rectangles whose boxes the ray misses are dropped, others are halved. The steps are POV-Ray's, since
//! the place found, which at grazing rays may lie a good way off the surface, is part of the picture.
use std::sync::Arc;

use raggio_function::Function;
use raggio_math::{Aabb, EPS, Ray, Vec2, Vec3};
use raggio_scene::Container;
use smallvec::SmallVec;

use super::collect::Collect;
use super::container;
use crate::{LocalHit, Surface};

const LEAST: f64 = 0.0;
/// Boxes of more levels than this are made anew for each ray.
const MOST_LEVELS: u32 = 16;

/// A parametric surface, ready to be hit.
#[derive(Clone, Debug)]
pub(crate) struct Parametric {
    functions: [Arc<Function>; 3],
    whole: Rect,
    container: Container,
    max_gradient: f64,
    accuracy: f64,
    /// Boxes of the first levels of halving; the children of box k are 2k and 2k + 1, the whole is 1.
    boxes: Vec<Aabb>,
}

/// A rectangle of parameters.
#[derive(Clone, Copy, Debug)]
struct Rect {
    lo: Vec2,
    hi: Vec2,
    /// Its place among the boxes kept.
    index: usize,
}

impl Rect {
    /// The lower and the upper half of the longer side; of u if they are equal.
    fn halves(&self) -> (Rect, Rect) {
        let size = self.hi - self.lo;
        let (mut lower, mut upper) = (*self, *self);
        if size.x >= size.y {
            lower.hi.x = 0.5 * (self.lo.x + self.hi.x);
            upper.lo.x = lower.hi.x;
        } else {
            lower.hi.y = 0.5 * (self.lo.y + self.hi.y);
            upper.lo.y = lower.hi.y;
        }
        lower.index = self.index.saturating_mul(2);
        upper.index = lower.index.saturating_add(1);
        (lower, upper)
    }
}

impl Parametric {
    /// Makes a surface ready; `precompute_depth` levels of boxes are kept.
    pub(crate) fn new(p: &raggio_scene::Parametric) -> Self {
        let whole = Rect { lo: p.uv_min.min(p.uv_max), hi: p.uv_max.max(p.uv_min), index: 1 };
        let mut surface = Parametric {
            functions: p.functions.clone(),
            whole,
            container: p.container,
            max_gradient: p.max_gradient,
            accuracy: p.accuracy,
            boxes: Vec::new(),
        };
        let count = 2usize << p.precompute_depth.min(MOST_LEVELS);
        let mut boxes = vec![Aabb::INFINITE; count];
        let mut waiting = vec![whole];
        while let Some(rect) = waiting.pop().filter(|_| count > 2) {
            boxes[rect.index] = surface.rect_box(&rect);
            let (lower, upper) = rect.halves();
            if upper.index < count {
                waiting.extend([lower, upper]);
            }
        }
        surface.boxes = if count > 2 { boxes } else { Vec::new() };
        surface
    }

    fn point(&self, at: Vec2) -> Vec3 {
        let args = [at.x, at.y];
        Vec3::new(self.functions[0].eval(&args), self.functions[1].eval(&args), self.functions[2].eval(&args))
    }

    fn bounds_of(&self, rect: &Rect) -> Aabb {
        self.boxes.get(rect.index).copied().unwrap_or_else(|| self.rect_box(rect))
    }

    /// A box around the surface over a rectangle, lowered by the accuracy: first along two edges of constant u, then
    /// between those.
    fn rect_box(&self, rect: &Rect) -> Aabb {
        let size = rect.hi - rect.lo;
        let spread = |a: Vec3, b: Vec3, h: f64| {
            (0.5 * (Vec3::splat(self.max_gradient * h) - (a - b).abs())).max(Vec3::ZERO)
        };
        let corner = |u: f64, v: f64| self.point(Vec2::new(u, v)) - Vec3::splat(self.accuracy);
        let edge = |u: f64| {
            let (a, b) = (corner(u, rect.lo.y), corner(u, rect.hi.y));
            let more = spread(a, b, size.y);
            (a.min(b) - more, a.max(b) + more)
        };
        let ((low0, high0), (low1, high1)) = (edge(rect.lo.x), edge(rect.hi.x));
        Aabb {
            min: low0.min(low1) - spread(low0, low1, size.x),
            max: high0.max(high1) + spread(high0, high1, size.x),
        }
    }

    fn search(&self, ray: &Ray, to: &mut impl Collect) {
        let Some((enter, leave)) = container::span(&self.container, ray) else { return };
        let least = enter.max(0.0) + 4.0 * self.accuracy;
        let mut waiting: SmallVec<[Rect; 64]> = SmallVec::new();
        waiting.push(self.whole);
        while let Some(rect) = waiting.pop() {
            let bounds = self.bounds_of(&rect);
            let Some((near, far)) = bounds.hit(ray) else { continue };
            let limits = (least.max(to.range().0), leave.min(to.range().1));
            if !(far >= limits.0 && near <= limits.1) {
                continue;
            }
            let size = rect.hi - rect.lo;
            let finest = 1e-15 * rect.lo.abs().max(rect.hi.abs()).max_element();
            if size.max_element().min(bounds.size().max_element()) < self.accuracy.max(finest) {
                to.push(LocalHit { t: entry(&bounds, ray), part: 0, u: rect.lo.x, v: rect.lo.y });
                continue;
            }
            let (lower, upper) = rect.halves();
            waiting.extend([upper, lower]);
        }
    }

    /// The point and its derivatives by u and v, by forward differences.
    fn slopes(&self, uv: Vec2) -> (Vec3, Vec3, Vec3) {
        let p = self.point(uv);
        let slope = |step: Vec2| (self.point(uv + step * self.accuracy) - p) / self.accuracy;
        (p, slope(Vec2::X), slope(Vec2::Y))
    }
}

/// Where the ray enters the last slab of the box that it is not parallel to.
fn entry(bounds: &Aabb, ray: &Ray) -> f64 {
    let axis = (0..3).rev().find(|&k| ray.dir[k].abs() > EPS).unwrap_or(0);
    let to = |face: f64| (face - ray.origin[axis]) / ray.dir[axis];
    to(bounds.min[axis]).min(to(bounds.max[axis]))
}

impl Surface for Parametric {
    /// Only the nearest hit is ever reported.
    fn hits(&self, ray: &Ray, range: (f64, f64), out: &mut Vec<LocalHit>) {
        out.extend(self.closest(ray, range));
    }

    fn closest(&self, ray: &Ray, range: (f64, f64)) -> Option<LocalHit> {
        let mut nearest = super::collect::Nearest::new(super::beyond(range, LEAST));
        self.search(ray, &mut nearest);
        nearest.best()
    }

    fn bounds(&self) -> Aabb {
        container::bounds(&self.container)
    }

    fn inside(&self, _p: Vec3) -> bool {
        false
    }

    fn is_solid(&self) -> bool {
        false
    }

    fn normal(&self, _p: Vec3, hit: &LocalHit) -> Vec3 {
        let (_, du, dv) = self.slopes(Vec2::new(hit.u, hit.v));
        du.cross(dv).try_normalize().unwrap_or(Vec3::X)
    }

    fn uv(&self, _p: Vec3, hit: &LocalHit) -> Option<Vec2> {
        Some(Vec2::new(hit.u, hit.v))
    }
}
