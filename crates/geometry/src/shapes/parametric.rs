//! The parametric surface: three functions of u and v (shapes spec, section 7).
//!
//! Intervals tell where the functions stay over a rectangle of parameters, and their slopes; where they tell nothing, the
//! slope that the scene promises does. The place of a hit is that of the surface itself, where POV-Ray stops its halving
//! as near as the accuracy.
use std::sync::Arc;

use raggio_function::{Bounds, Function, Range};
use raggio_math::{Aabb, Ray, Vec2, Vec3};
use raggio_scene::Container;

use super::container;
use super::sheet::{Enclosure, Hits, Sheet, SheetTree};
use crate::{LocalHit, Surface};

const LEAST: f64 = 0.0;

/// A parametric surface, ready to be hit.
pub(crate) struct Parametric {
    tree: SheetTree<Functions>,
    container: Container,
    accuracy: f64,
}

/// The three coordinates.
struct Functions {
    functions: [Arc<Function>; 3],
    max_gradient: f64,
    accuracy: f64,
}

impl Functions {
    /// Where a coordinate stays if its slopes are no more than the scene promises.
    fn promised(&self, f: &Function, lo: Vec2, hi: Vec2) -> Range {
        let reach = 0.5 * self.max_gradient * (hi - lo).element_sum();
        Range::one(f.eval(&(0.5 * (lo + hi)).to_array())) + Range::within(reach)
    }

    /// Where a coordinate and its slopes stay.
    fn coordinate(&self, f: &Function, lo: Vec2, hi: Vec2) -> (Range, Range, Range) {
        let range = |axis: usize| Range::new(lo[axis], hi[axis]);
        let found = f.enclose(&[Bounds::variable(0, range(0)), Bounds::variable(1, range(1))]);
        let [du, dv, _] = found.slopes;
        if found.value.is_all() {
            return (self.promised(f, lo, hi), du, dv);
        }
        let size = 0.5 * (hi - lo);
        let middle = f.eval(&(0.5 * (lo + hi)).to_array());
        let away = du.size() * size.x + dv.size() * size.y;
        (found.value.meet(Range::one(middle) + Range::within(away)), du, dv)
    }
}

impl Sheet for Functions {
    fn point(&self, uv: Vec2) -> Vec3 {
        Vec3::from([0, 1, 2].map(|k| self.functions[k].eval(&[uv.x, uv.y])))
    }

    fn enclose(&self, lo: Vec2, hi: Vec2) -> Enclosure {
        let [x, y, z] = [0, 1, 2].map(|k| self.coordinate(&self.functions[k], lo, hi));
        Enclosure {
            bounds: Aabb { min: Vec3::new(x.0.lo, y.0.lo, z.0.lo), max: Vec3::new(x.0.hi, y.0.hi, z.0.hi) },
            du: [x.1, y.1, z.1],
            dv: [x.2, y.2, z.2],
        }
    }

    fn tolerance(&self) -> f64 {
        self.accuracy
    }
}

impl Parametric {
    /// Makes a surface ready.
    pub(crate) fn new(p: &raggio_scene::Parametric) -> Self {
        let functions =
            Functions { functions: p.functions.clone(), max_gradient: p.max_gradient, accuracy: p.accuracy };
        let tree = SheetTree::new(functions, p.uv_min.min(p.uv_max), p.uv_max.max(p.uv_min));
        Parametric { tree, container: p.container, accuracy: p.accuracy }
    }
}

impl Surface for Parametric {
    /// Only the nearest hit is ever reported.
    fn hits(&self, ray: &Ray, range: (f64, f64), out: &mut Vec<LocalHit>) {
        out.extend(self.closest(ray, range));
    }

    fn closest(&self, ray: &Ray, range: (f64, f64)) -> Option<LocalHit> {
        let (enter, leave) = container::span(&self.container, ray, ray.dir.recip())?;
        // What is nearer than the range hides what is farther, as only one hit is known of.
        let least = (enter.max(0.0) + 4.0 * self.accuracy).max(LEAST);
        let mut hits = Hits::new();
        self.tree.hits(ray, (least, leave.min(range.1)), 0, true, &mut hits);
        hits.into_iter().min_by(|a, b| a.t.total_cmp(&b.t)).filter(|hit| hit.t > range.0)
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

    /// By forward differences, as wide as the accuracy.
    fn normal(&self, _p: Vec3, hit: &LocalHit) -> Vec3 {
        let uv = Vec2::new(hit.u, hit.v);
        let p = self.tree.sheet.point(uv);
        let slope = |step: Vec2| self.tree.sheet.point(uv + step * self.accuracy) - p;
        slope(Vec2::X).cross(slope(Vec2::Y)).try_normalize().unwrap_or(Vec3::X)
    }

    fn uv(&self, _p: Vec3, hit: &LocalHit) -> Option<Vec2> {
        Some(Vec2::new(hit.u, hit.v))
    }
}
