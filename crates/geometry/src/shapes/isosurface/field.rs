//! What is known of an isosurface's function wherever rays come by: a tree of boxes, made as they are visited.
//!
//! A box knows where the function's values and slopes lie in it. Boxes without the surface are left out, those where
//! the slopes hardly differ are not cut further. What a box knows does not depend on who asks, so pictures do not depend
//! on the order of rays.
use std::ops::ControlFlow;
use std::sync::{Arc, OnceLock};

use raggio_function::{Bounds, Function, Range};
use raggio_math::{Aabb, Ray, Vec3};
use smallvec::SmallVec;

/// Boxes are cut in two this many times at most.
const MOST_CUTS: u32 = 10;
/// A box is not cut where the slopes differ by less than this share of the steepest.
const ALIKE: f64 = 1.0;

/// Where in the container the function is tried out, as shares of its sides.
const PROBES: [[f64; 3]; 3] = [[0.3, 0.4, 0.6], [0.52, 0.81, 0.37], [0.73, 0.13, 0.86]];

/// A function over a container's box.
#[derive(Debug)]
pub(super) struct Field {
    function: Arc<Function>,
    threshold: f64,
    bounds: Aabb,
    root: OnceLock<Cell>,
}

/// A box of the tree.
#[derive(Debug)]
struct Cell {
    /// The axis to cut and where, if the box is to be cut.
    cut: Option<(usize, f64)>,
    halves: OnceLock<Box<[Cell; 2]>>,
    value: Range,
    slopes: [Range; 3],
    bounds: Aabb,
    /// How often the whole was cut to get here.
    depth: u32,
}

/// A stretch of a ray, known by its end, with what is known of the function there.
#[derive(Clone, Copy, Debug)]
pub(super) struct Stretch {
    pub to: f64,
    /// Values, less the threshold.
    pub value: Range,
    /// Slopes along the ray, for one of its parameter.
    pub slope: Range,
}

impl Field {
    /// A field, unless nothing can be told of the function anywhere.
    pub(super) fn new(function: Arc<Function>, threshold: f64, bounds: Aabb) -> Option<Self> {
        let field = Field { function, threshold, bounds, root: OnceLock::new() };
        let known = PROBES.iter().any(|&share| {
            let at = bounds.min + bounds.size() * Vec3::from(share);
            !field.cell(Aabb { min: at, max: at }, 0).value.is_all()
        });
        (known && bounds.is_finite()).then_some(field)
    }

    /// Calls `each` with the stretches of a ray between two parameters, in their order, until it breaks.
    #[inline]
    pub(super) fn walk<B>(
        &self,
        ray: &Ray,
        (mut from, mut to): (f64, f64),
        mut each: impl FnMut(Stretch) -> ControlFlow<B>,
    ) -> ControlFlow<B> {
        let inverse = ray.dir.recip();
        let mut cell = self.root.get_or_init(|| self.cell(self.bounds, 0));
        let mut waiting: SmallVec<[(&Cell, f64); MOST_CUTS as usize]> = SmallVec::new();
        loop {
            while let Some((axis, plane)) = cell.cut {
                let halves = self.halves(cell, (axis, plane));
                let (origin, dir) = (ray.origin[axis], ray.dir[axis]);
                let crossing = (plane - origin) * inverse[axis];
                let (near, far) = if dir > 0.0 { (0, 1) } else { (1, 0) };
                if dir == 0.0 {
                    cell = &halves[usize::from(origin > plane)];
                } else if crossing <= from {
                    cell = &halves[far];
                } else {
                    cell = &halves[near];
                    if crossing < to {
                        waiting.push((&halves[far], to));
                        to = crossing;
                    }
                }
            }
            let slope = (0..3).fold(Range::ZERO, |sum, k| sum + cell.slopes[k] * ray.dir[k]);
            each(Stretch { to, value: cell.value, slope })?;
            from = to;
            match waiting.pop() {
                Some(next) => (cell, to) = next,
                None => return ControlFlow::Continue(()),
            }
        }
    }

    /// The halves of a box that is to be cut.
    #[inline]
    fn halves<'a>(&self, cell: &'a Cell, (axis, plane): (usize, f64)) -> &'a [Cell; 2] {
        cell.halves.get_or_init(|| {
            let (mut low, mut high) = (cell.bounds, cell.bounds);
            low.max[axis] = plane;
            high.min[axis] = plane;
            Box::new([low, high].map(|half| self.cell(half, cell.depth + 1)))
        })
    }

    /// Bounds the function over a box.
    fn cell(&self, bounds: Aabb, depth: u32) -> Cell {
        let variable = |k: usize| Bounds::variable(k, Range::new(bounds.min[k], bounds.max[k]));
        let found = self.function.enclose(&[variable(0), variable(1), variable(2)]);
        let half = bounds.size() * 0.5;
        let mut value = found.value + Range::one(-self.threshold);
        if !value.is_all() {
            // From the middle no point is farther than half the box.
            let middle = self.function.eval(&bounds.centre().to_array()) - self.threshold;
            let away = (0..3).fold(0.0, |sum, k| sum + found.slopes[k].size() * half[k]);
            value = value.meet(Range::one(middle) + Range::within(away));
        }
        let cut = axis_to_cut(&found.slopes, half)
            .filter(|_| depth < MOST_CUTS && value.contains(0.0) && !alike(&found.slopes))
            .map(|axis| (axis, bounds.centre()[axis]));
        Cell { cut, halves: OnceLock::new(), value, slopes: found.slopes, bounds, depth }
    }
}

/// Are the slopes known so well that smaller boxes tell little more?
fn alike(slopes: &[Range; 3]) -> bool {
    let differences: f64 = slopes.iter().map(|s| s.width()).sum();
    let steepest = slopes.iter().map(|s| s.size()).fold(0.0, f64::max);
    differences <= ALIKE * steepest && steepest.is_finite()
}

/// The axis along which the function differs most; the longest, if that is not known.
fn axis_to_cut(slopes: &[Range; 3], half: Vec3) -> Option<usize> {
    let known = slopes.iter().all(|s| s.size().is_finite());
    let spread = |k: usize| if known { slopes[k].size() * half[k] } else { half[k] };
    (0..3).filter(|&k| half[k] > 0.0).max_by(|&a, &b| spread(a).total_cmp(&spread(b)))
}
