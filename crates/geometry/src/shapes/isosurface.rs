//! The isosurface: where a function takes a given value, within a container (shapes spec, section 7).
//!
//! A stretch of the ray is free of the surface when the function is too far from the threshold at its ends to get there
//! with the steepest slope allowed; other stretches are halved, down to the accuracy.
mod field;
mod grid;
mod search;
mod walk;

use std::sync::Arc;

use raggio_function::{Function, Range};
use raggio_math::{Aabb, Affine, Ray, Vec3, transform};
use raggio_scene::{Container, IsosurfaceEvaluate};

use self::field::Field;
use self::search::Search;
use self::walk::Walk;
use super::collect::{Collect, Nearest, searched_from};
use super::container;
use crate::{LocalHit, Surface};

const LEAST: f64 = 0.0;
/// A hit on the surface; walls of the container count from 1.
const SURFACE: u32 = 0;
/// Rays across each side of the container from which `evaluate` learns the gradient beforehand.
const PROBES: u32 = 16;

/// An isosurface, ready to be hit.
#[derive(Clone, Debug)]
pub(crate) struct Isosurface {
    function: Arc<Function>,
    container: Container,
    threshold: f64,
    accuracy: f64,
    max_gradient: f64,
    evaluate: Option<IsosurfaceEvaluate>,
    max_trace: u32,
    open: bool,
    /// What is known of the function, if anything.
    field: Option<Arc<Field>>,
    /// Accuracy counts along the world's ray, so a surface at a place that stretches does its own transforming.
    object_from_world: Affine,
    world_from_object: Affine,
}

impl Isosurface {
    /// Makes an isosurface ready at a place: rays, points and normals are then those of the world. With `evaluate` the gradient is learnt here, from rays across the container, so that
    /// the picture does not depend on the order of rays.
    pub(crate) fn new(iso: &raggio_scene::Isosurface, world_from_object: &Affine) -> Self {
        let mut surface = Isosurface {
            function: iso.function.clone(),
            container: iso.container,
            threshold: iso.threshold,
            accuracy: iso.accuracy,
            max_gradient: iso.max_gradient,
            evaluate: iso.evaluate,
            max_trace: iso.max_trace,
            open: iso.open,
            field: None,
            object_from_world: world_from_object.inverse(),
            world_from_object: *world_from_object,
        };
        if surface.evaluate.is_some() {
            surface.max_gradient = surface.learnt_gradient();
        } else {
            surface.field = Field::shared(iso);
        }
        surface
    }

    /// The scene's maximal gradient and the steeper one that was found, if there is one; and what copies share.
    pub(crate) fn too_steep(&self) -> Option<(f64, f64, usize)> {
        let field = self.field.as_ref()?;
        field.too_steep().map(|(set, found)| (set, found, Arc::as_ptr(field).addr()))
    }

    fn value(&self, p: Vec3) -> f64 {
        self.function.eval(&[p.x, p.y, p.z]) - self.threshold
    }

    /// The greatest gradient that rays along the three axes leave behind.
    fn learnt_gradient(&self) -> f64 {
        let bounds = container::bounds(&self.container);
        let mut greatest = self.max_gradient;
        for axis in 0..3 {
            for k in 0..PROBES * PROBES {
                let share = |k: u32| (f64::from(k) + 0.5) / f64::from(PROBES);
                let mut at = Vec3::splat(-1.0);
                at[(axis + 1) % 3] = share(k % PROBES);
                at[(axis + 2) % 3] = share(k / PROBES);
                let ray = Ray::new(bounds.min + at * bounds.size(), Vec3::AXES[axis]);
                let gradient = self.trace(ray, &mut Nearest::new((0.0, f64::INFINITY)));
                greatest = greatest.max(gradient);
            }
        }
        greatest
    }

    #[inline(always)]
    fn search(&self, ray: &Ray, to: &mut impl Collect) {
        self.trace(ray.transformed(&self.object_from_world), to);
    }

    /// Follows a ray of the object's coordinates; answers with the gradient as the ray leaves it.
    #[inline(always)]
    fn trace(&self, ray: Ray, to: &mut impl Collect) -> f64 {
        let inverse = ray.dir.recip();
        match container::span(&self.container, &ray, inverse) {
            Some(span) if span.1 > to.range().0 && span.0 < to.range().1 && span.1.is_finite() => {
                self.trace_within(&ray, inverse, span, to)
            }
            _ => self.max_gradient,
        }
    }

    /// The same where the ray is in the container. Not inlined: many rays miss it, and need no room for a search.
    #[inline(never)]
    fn trace_within(
        &self,
        ray: &Ray,
        inverse: Vec3,
        (enter, leave): (f64, f64),
        to: &mut impl Collect,
    ) -> f64 {
        let mut search = Search::new(self, ray);
        let way = (enter.max(0.0), leave.min(to.range().1 + self.accuracy));
        let mut room;
        let mut walk = match self.field.as_deref() {
            Some(field) => {
                room = Walk::new(field, ray, inverse, way);
                Some(&mut room)
            }
            None => None,
        };
        // A ray that goes on behind a hit begins anew there, and what lies before is not counted.
        let (from, mut left) = (to.range().0, self.max_trace);
        let (start, value) = search.start(enter, walk.as_deref_mut());
        if !self.open && enter > self.accuracy && value.hi < 0.0 {
            self.push_wall(ray, enter, to);
            left = left.saturating_sub(u32::from(enter > from));
        }
        search.sign = if value.hi < 0.0 { -1.0 } else { 1.0 };
        let mut at = (start, value);
        let mut ended = false;
        while left > 0 && at.0 < leave && at.0 < to.range().1 {
            search.relax();
            let Some(t) = search.first_root(at, leave, walk.as_deref_mut()) else {
                ended = true;
                break;
            };
            to.push(LocalHit { t, part: SURFACE, ..LocalHit::default() });
            left -= u32::from(t > from);
            search.sign = -search.sign;
            let next = t + 5.0 * self.accuracy;
            if left == 0 || next >= leave || next >= to.range().1 {
                break;
            }
            if let Some(walk) = &mut walk {
                walk.go_to(next);
            }
            at = (next, Range::ALL);
        }
        if !self.open && leave < to.range().1 {
            let known = (ended && search.proved && walk.is_some()).then_some(search.sign);
            search.sign = 1.0;
            if known.unwrap_or_else(|| search.value(leave)) < 0.0 {
                self.push_wall(ray, leave, to);
            }
        }
        search.gradient
    }

    fn push_wall(&self, ray: &Ray, t: f64, to: &mut impl Collect) {
        let part = 1 + container::wall(&self.container, ray.at(t));
        to.push(LocalHit { t, part, ..LocalHit::default() });
    }
}

impl Surface for Isosurface {
    searched_from!(LEAST);

    fn bounds(&self) -> Aabb {
        container::bounds(&self.container).transformed(&self.world_from_object)
    }

    fn inside(&self, p: Vec3) -> bool {
        let p = self.object_from_world.transform_point3(p);
        container::contains(&self.container, p) && self.value(p) <= 0.0
    }

    fn normal(&self, p: Vec3, hit: &LocalHit) -> Vec3 {
        let p = self.object_from_world.transform_point3(p);
        let n = if hit.part == SURFACE {
            let here = self.value(p);
            let rise = |axis: Vec3| self.value(p + axis * self.accuracy) - here;
            Vec3::new(rise(Vec3::X), rise(Vec3::Y), rise(Vec3::Z)).try_normalize().unwrap_or(Vec3::X)
        } else {
            container::wall_normal(&self.container, hit.part - 1, p)
        };
        transform::normal_by_inverse(&self.object_from_world, n).try_normalize().unwrap_or(Vec3::X)
    }
}

#[cfg(test)]
mod tests {
    use raggio_function::{BinaryOp, Builtin, Expr, Internal};

    use super::*;

    fn binary(op: BinaryOp, a: Expr, b: Expr) -> Expr {
        Expr::Binary(op, Box::new(a), Box::new(b))
    }

    /// A wavy ball with noise: `sqrt(x*x + y*y + z*z) - 0.8 + sin(6*atan2(x, z))*0.05 + noise*0.1`.
    fn rock() -> raggio_scene::Isosurface {
        use BinaryOp::{Add, Mul};
        let xyz = || (0..3).map(Expr::Slot).collect::<Vec<_>>();
        let r2 =
            xyz().into_iter().map(|e| Expr::Call(Builtin::Sqr, vec![e])).reduce(|a, b| binary(Add, a, b));
        let r = Expr::Call(Builtin::Sqrt, r2.into_iter().collect());
        let angle = Expr::Call(Builtin::Atan2, vec![Expr::Slot(0), Expr::Slot(2)]);
        let wave = Expr::Call(Builtin::Sin, vec![binary(Mul, angle, Expr::Const(6.0))]);
        let noise = Expr::Internal(Internal::NOISE, xyz());
        let bumps = binary(Add, binary(Mul, wave, Expr::Const(0.05)), binary(Mul, noise, Expr::Const(0.1)));
        raggio_scene::Isosurface {
            function: Arc::new(Function::new(3, binary(Add, r, bumps))),
            container: Container::Box { min: Vec3::splat(-1.0), max: Vec3::splat(1.0) },
            threshold: 0.8,
            accuracy: 0.001,
            max_gradient: 8.0,
            evaluate: None,
            max_trace: 4,
            open: false,
        }
    }

    #[test]
    fn a_gradient_that_is_too_low_is_noticed_where_rays_come_by() {
        let plane = |max_gradient| raggio_scene::Isosurface {
            function: Arc::new(Function::new(3, binary(BinaryOp::Mul, Expr::Slot(1), Expr::Const(3.0)))),
            threshold: 0.0,
            max_gradient,
            ..rock()
        };
        let found = |max_gradient| {
            let surface = Isosurface::new(&plane(max_gradient), &Affine::IDENTITY);
            assert_eq!(surface.too_steep(), None);
            surface.closest(&Ray::new(Vec3::Y * 3.0, -Vec3::Y), (0.0, 10.0)).expect("a hit");
            surface.too_steep().map(|(set, found, _)| (set, found))
        };
        assert_eq!(found(3.0), None);
        let (set, steepest) = found(1.0).expect("a warning");
        assert!(set == 1.0 && (steepest - 3.0).abs() < 1e-9, "{steepest}");
    }

    /// Rays from around the ball to aims spread over it.
    fn rays() -> impl Iterator<Item = Ray> {
        (0..400).map(|i| {
            let (a, b) = (f64::from(i) * 2.4, f64::from(i) * 0.37);
            let origin = Vec3::new(a.cos(), (b * 1.7).sin(), a.sin()) * 2.5;
            let aim = Vec3::new(b.sin(), (a * 0.3).cos(), (b * 0.9).cos()) * 0.7;
            Ray::new(origin, (aim - origin).normalize())
        })
    }

    fn all_hits(surface: &Isosurface, ray: &Ray) -> Vec<LocalHit> {
        let mut out = Vec::new();
        surface.hits(ray, (0.0, f64::INFINITY), &mut out);
        out
    }

    #[test]
    fn what_is_learnt_late_changes_nothing() {
        // The steepest slope is about 1.9.
        for accuracy in [0.001, 0.1] {
            let surface =
                Isosurface::new(&raggio_scene::Isosurface { accuracy, ..rock() }, &Affine::IDENTITY);
            let boxes = || surface.field.as_ref().map_or(0, |field| field.root().count());
            let early: Vec<_> = rays().map(|ray| all_hits(&surface, &ray)).collect();
            let known_early = boxes();
            for _ in 0..40 {
                for (ray, hits) in rays().zip(&early) {
                    assert_eq!(all_hits(&surface, &ray), *hits);
                }
            }
            assert!(boxes() > known_early, "no box was cut late");
        }
    }

    #[test]
    fn what_is_known_of_the_function_changes_no_hit() {
        let known = Isosurface::new(&rock(), &Affine::IDENTITY);
        assert!(known.field.is_some());
        let unknown = Isosurface { field: None, ..known.clone() };
        let (mut hits, mut differing) = (0, 0);
        for (i, ray) in rays().enumerate() {
            let (found, expected) = (all_hits(&known, &ray), all_hits(&unknown, &ray));
            assert_eq!(found.len(), expected.len(), "ray {i}");
            for (f, e) in found.iter().zip(&expected) {
                // A search that begins a little below zero may end one step sooner or later.
                assert!((f.t - e.t).abs() < 0.001 && f.part == e.part, "ray {i}: {f:?} instead of {e:?}");
                differing += usize::from((f.t - e.t).abs() > 1e-9);
            }
            let nearest = |surface: &Isosurface| surface.closest(&ray, (0.0, 2.0)).map(|hit| hit.part);
            assert_eq!(nearest(&known), nearest(&unknown));
            hits += found.len();
        }
        assert!(hits > 400 && differing < 4, "{differing} of {hits} hits differ");
    }
}
