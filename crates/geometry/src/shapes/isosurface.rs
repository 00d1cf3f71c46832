//! The isosurface: where a function takes a given value, within a container (shapes spec, section 7).
//!
//! A stretch of the ray is free of the surface when the function is too far from the threshold at its ends to get there
//! with the steepest slope allowed; other stretches are halved, down to the accuracy.
use std::sync::Arc;

use raggio_function::Function;
use raggio_math::{Aabb, Affine, Ray, Vec3, transform};
use raggio_scene::{Container, IsosurfaceEvaluate};

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
    /// Accuracy counts along the world's ray, so a surface at a place that stretches does its own transforming.
    object_from_world: Affine,
    world_from_object: Affine,
}

/// The function along a ray, above the threshold or, with the sign turned, below it.
struct Search<'a> {
    surface: &'a Isosurface,
    /// In the object's coordinates; its direction is as long as a world unit is there.
    ray: Ray,
    stretch: f64,
    sign: f64,
    gradient: f64,
}

impl Search<'_> {
    fn value(&self, t: f64) -> f64 {
        self.sign * self.surface.value(self.ray.at(t))
    }

    /// The first point below zero between two samples, to the accuracy.
    fn first(&mut self, a: (f64, f64), b: (f64, f64)) -> Option<f64> {
        let length = b.0 - a.0;
        if length < self.surface.accuracy {
            return (b.1 < 0.0).then_some(b.0);
        }
        self.learn((b.1 - a.1).abs() / (self.stretch * length));
        if a.1 + b.1 >= self.gradient * self.stretch * length {
            return None;
        }
        let middle = 0.5 * (a.0 + b.0);
        // So far away that numbers are coarser than the accuracy.
        if !(a.0 < middle && middle < b.0) {
            return (b.1 < 0.0).then_some(b.0);
        }
        let middle = (middle, self.value(middle));
        self.first(a, middle).or_else(|| self.first(middle, b))
    }

    /// `evaluate`: a steeper slope than expected raises the gradient.
    fn learn(&mut self, slope: f64) {
        if let Some(IsosurfaceEvaluate { increase, .. }) = self.surface.evaluate
            && slope.is_finite()
            && self.gradient < slope * increase
        {
            self.gradient = slope * increase * increase;
        }
    }

    /// `evaluate`: a gradient above the minimum sinks from search to search.
    fn relax(&mut self) {
        if let Some(IsosurfaceEvaluate { minimum, decrease, .. }) = self.surface.evaluate
            && self.gradient > minimum
        {
            self.gradient *= decrease;
        }
    }
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
            object_from_world: world_from_object.inverse(),
            world_from_object: *world_from_object,
        };
        if surface.evaluate.is_some() {
            surface.max_gradient = surface.learnt_gradient();
        }
        surface
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

    fn search(&self, ray: &Ray, to: &mut impl Collect) {
        self.trace(ray.transformed(&self.object_from_world), to);
    }

    /// Follows a ray of the object's coordinates; answers with the gradient as the ray leaves it.
    fn trace(&self, ray: Ray, to: &mut impl Collect) -> f64 {
        let stretch = ray.dir.length();
        let mut search = Search { surface: self, ray, stretch, sign: 1.0, gradient: self.max_gradient };
        let span = container::span(&self.container, &ray)
            .filter(|s| s.1 > to.range().0 && s.0 < to.range().1 && s.1.is_finite());
        let Some((enter, leave)) = span else { return self.max_gradient };
        let mut left = self.max_trace;
        let last = search.value(leave);
        if !self.open && last < 0.0 {
            self.push_wall(&ray, leave, to);
        }
        let mut at = (enter.max(0.0), search.value(enter.max(0.0)));
        if !self.open && enter > self.accuracy && at.1 < 0.0 {
            self.push_wall(&ray, enter, to);
            left = left.saturating_sub(1);
        }
        // A ray that starts on the surface must not meet it again at once.
        if at.1.abs() < 4.0 * search.gradient * self.accuracy && at.0 < self.accuracy {
            at.0 = 5.0 * self.accuracy;
            at.1 = search.value(at.0);
        }
        if at.1 < 0.0 {
            search.sign = -1.0;
        }
        while left > 0 && at.0 < leave && at.0 < to.range().1 {
            search.relax();
            let end = (leave, search.sign * last);
            let Some(t) = search.first((at.0, search.value(at.0)), end) else { break };
            to.push(LocalHit { t, part: SURFACE, ..LocalHit::default() });
            left -= 1;
            search.sign = -search.sign;
            at.0 = t + 5.0 * self.accuracy;
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
