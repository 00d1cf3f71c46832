//! What is known of an isosurface's function wherever rays come by: a tree of boxes, made as they are visited.
//!
//! A box knows where the function's values lie in it, and between which two linear functions the function stays. Boxes
//! without the surface are left out, those where the slopes hardly differ are not cut further. What a box knows does not
//! depend on who asks, so pictures do not depend on the order of rays.
use std::collections::HashMap;
use std::ops::ControlFlow;
use std::sync::atomic::{AtomicU64, Ordering};
use std::sync::{Arc, LazyLock, Mutex, OnceLock, PoisonError, Weak};

use raggio_function::{Bounds, Function, Range};
use raggio_math::{Aabb, Ray, Vec3};
use smallvec::SmallVec;

use super::super::container;

/// Boxes are cut in two this many times at most.
const MOST_CUTS: u8 = 14;
/// Where slopes seem steeper than so many times the scene's maximal gradient their bounds are too wide to tell anything
/// soon, and boxes are cut this many times at most.
const TOO_STEEP: f64 = 1.5;
const BLIND_CUTS: u8 = 10;
/// A box is not cut where the slopes differ by less than this share of the steepest.
const ALIKE: f64 = 1.0;
/// A slope beyond the scene's by this factor is not due to rounding.
const CLEARLY: f64 = 1.001;
/// The axis of a box that is not cut.
const NONE: u8 = 3;

/// Where in the container the function is tried out, as shares of its sides.
const PROBES: [[f64; 3]; 3] = [[0.3, 0.4, 0.6], [0.52, 0.81, 0.37], [0.73, 0.13, 0.86]];

/// A function over a container's box.
#[derive(Debug)]
pub(super) struct Field {
    function: Arc<Function>,
    threshold: f64,
    /// What the scene says to be the steepest slope.
    max_gradient: f64,
    bounds: Aabb,
    root: OnceLock<Cell>,
    /// Bits of the steepest slope that was proved, 0 while none exceeds the scene's.
    steepest: AtomicU64,
}

/// A box of the tree.
#[derive(Debug)]
#[repr(C)]
struct Cell {
    /// Where the box is cut.
    plane: f64,
    /// Across which axis, if it is cut.
    axis: u8,
    /// How often the whole was cut to get here.
    depth: u8,
    halves: OnceLock<Box<[Cell; 2]>>,
    /// All values in the box.
    value: Range,
    model: Model,
    bounds: Aabb,
}

/// Between which linear functions a function stays in a box, less the threshold.
#[derive(Clone, Copy, Debug)]
pub(super) struct Model {
    centre: Vec3,
    /// The value in the centre.
    middle: f64,
    /// The slopes along the axes: their middles, and how far they are to either side of them.
    slope: Vec3,
    spread: Vec3,
}

impl Model {
    /// Is anything known of the slopes?
    #[inline]
    pub(super) fn is_known(&self) -> bool {
        self.spread.x + self.spread.y + self.spread.z < f64::INFINITY
    }

    /// Where the value at a point of the box lies: the middle and how far it may be off.
    #[inline]
    pub(super) fn at(&self, p: Vec3) -> (f64, f64) {
        let d = p - self.centre;
        (self.middle + self.slope.dot(d), self.spread.dot(d.abs()))
    }

    /// Where the slope along a direction lies.
    #[inline]
    pub(super) fn along(&self, dir: Vec3) -> Range {
        let (slope, spread) = (self.slope.dot(dir), self.spread.dot(dir.abs()));
        Range { lo: slope - spread, hi: slope + spread }
    }
}

impl Cell {
    /// May smaller boxes tell much more of a function that the scene says to have slopes up to `max_gradient`?
    fn is_worth_cutting(&self, max_gradient: f64) -> bool {
        let Model { slope, spread, .. } = self.model;
        let steepest = (slope.abs() + spread).max_element();
        let well_known = self.model.is_known() && 2.0 * spread.element_sum() <= ALIKE * steepest;
        let most = if steepest <= TOO_STEEP * max_gradient { MOST_CUTS } else { BLIND_CUTS };
        self.value.contains(0.0) && !well_known && self.depth < most
    }
}

/// What makes two fields the same: the function, which as long as a field lives is the only one in its place, and bits
/// of the numbers.
type Key = (usize, [u64; 8]);

/// The fields in use; copies of an object share theirs.
static SHARED: LazyLock<Mutex<HashMap<Key, Weak<Field>>>> = LazyLock::new(Mutex::default);

impl Field {
    /// A field that may be shared with copies of the same object, unless nothing can be told of the function anywhere.
    pub(super) fn shared(iso: &raggio_scene::Isosurface) -> Option<Arc<Self>> {
        let Aabb { min, max } = container::bounds(&iso.container);
        let numbers = [min.x, min.y, min.z, max.x, max.y, max.z, iso.threshold, iso.max_gradient];
        let key = (Arc::as_ptr(&iso.function).addr(), numbers.map(f64::to_bits));
        let mut shared = SHARED.lock().unwrap_or_else(PoisonError::into_inner);
        if let Some(field) = shared.get(&key).and_then(Weak::upgrade) {
            return Some(field);
        }
        let field = Arc::new(Field::new(iso)?);
        if shared.len().is_power_of_two() {
            shared.retain(|_, field| field.strong_count() > 0);
        }
        shared.insert(key, Arc::downgrade(&field));
        Some(field)
    }

    /// A field, unless nothing can be told of the function anywhere.
    fn new(iso: &raggio_scene::Isosurface) -> Option<Self> {
        let bounds = container::bounds(&iso.container);
        let field = Field {
            function: iso.function.clone(),
            threshold: iso.threshold,
            max_gradient: iso.max_gradient,
            bounds,
            root: OnceLock::new(),
            steepest: AtomicU64::new(0),
        };
        let known = PROBES.iter().any(|&share| {
            let at = bounds.min + bounds.size() * Vec3::from(share);
            !field.cell(Aabb { min: at, max: at }, None).value.is_all()
        });
        (known && bounds.is_finite()).then_some(field)
    }

    /// The scene's maximal gradient and the steeper slope that was found where rays came by, if one was.
    pub(super) fn too_steep(&self) -> Option<(f64, f64)> {
        let found = f64::from_bits(self.steepest.load(Ordering::Relaxed));
        (found > 0.0).then_some((self.max_gradient, found))
    }

    /// Remembers the slope that a box with the surface in it surely has, if the scene says that there is none.
    fn note_slope(&self, value: Range, slopes: &[Range; 3]) {
        let least = |s: &Range| s.lo.max(-s.hi).max(0.0);
        let steepest = slopes.iter().map(|s| least(s).powi(2)).sum::<f64>().sqrt();
        if value.contains(0.0) && steepest.is_finite() && steepest > CLEARLY * self.max_gradient {
            // Bits of positive numbers are in the order of the numbers.
            self.steepest.fetch_max(steepest.to_bits(), Ordering::Relaxed);
        }
    }

    /// Calls `each` with the stretches of a ray between two parameters where `sign` times the function may fall below
    /// zero, in their order, until it breaks.
    #[inline]
    pub(super) fn walk<B>(
        &self,
        ray: &Ray,
        sign: f64,
        (mut from, mut to): (f64, f64),
        mut each: impl FnMut((f64, f64), &Model) -> ControlFlow<B>,
    ) -> ControlFlow<B> {
        let inverse = ray.dir.recip();
        let mut cell = self.root.get_or_init(|| self.cell(self.bounds, None));
        let mut waiting: SmallVec<[(&Cell, f64); MOST_CUTS as usize]> = SmallVec::new();
        loop {
            while cell.axis != NONE {
                let axis = usize::from(cell.axis);
                let halves = self.halves(cell);
                let (origin, dir) = (ray.origin[axis], ray.dir[axis]);
                let crossing = (cell.plane - origin) * inverse[axis];
                let (near, far) = if dir > 0.0 { (0, 1) } else { (1, 0) };
                if dir == 0.0 {
                    cell = &halves[usize::from(origin > cell.plane)];
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
            let empty = if sign > 0.0 { cell.value.lo > 0.0 } else { cell.value.hi < 0.0 };
            if !empty {
                each((from, to), &cell.model)?;
            }
            from = to;
            match waiting.pop() {
                Some(next) => (cell, to) = next,
                None => return ControlFlow::Continue(()),
            }
        }
    }

    /// The halves of a box that is to be cut.
    #[inline]
    fn halves<'a>(&self, cell: &'a Cell) -> &'a [Cell; 2] {
        cell.halves.get_or_init(|| {
            let (mut low, mut high) = (cell.bounds, cell.bounds);
            low.max[usize::from(cell.axis)] = cell.plane;
            high.min[usize::from(cell.axis)] = cell.plane;
            Box::new([low, high].map(|half| self.cell(half, Some(cell))))
        })
    }

    /// Bounds the function over a box, which may be a half of another.
    fn cell(&self, bounds: Aabb, whole: Option<&Cell>) -> Cell {
        let variable = |k: usize| Bounds::variable(k, Range::new(bounds.min[k], bounds.max[k]));
        let found = self.function.enclose(&[variable(0), variable(1), variable(2)]);
        let centre = bounds.centre();
        let half = bounds.size() * 0.5;
        let model = Model {
            centre,
            middle: self.function.eval(&centre.to_array()) - self.threshold,
            slope: Vec3::from(found.slopes.map(Range::middle)),
            spread: Vec3::from(found.slopes.map(|s| 0.5 * s.width())),
        };
        let mut value = found.value + Range::one(-self.threshold);
        if !value.is_all() && model.is_known() {
            // From the middle no point is farther than half the box.
            let away = (0..3).fold(0.0, |sum, k| sum + found.slopes[k].size() * half[k]);
            value = value.meet(Range::one(model.middle) + Range::within(away));
        }
        self.note_slope(value, &found.slopes);
        let depth = whole.map_or(0, |whole| whole.depth + 1);
        let mut cell = Cell { plane: 0.0, axis: NONE, depth, halves: OnceLock::new(), value, model, bounds };
        if let Some(axis) =
            axis_to_cut(&found.slopes, half).filter(|_| cell.is_worth_cutting(self.max_gradient))
        {
            (cell.plane, cell.axis) = (centre[axis], axis as u8);
        }
        cell
    }
}

/// The axis along which the function differs most; the longest, if that is not known.
fn axis_to_cut(slopes: &[Range; 3], half: Vec3) -> Option<usize> {
    let known = slopes.iter().all(|s| s.size().is_finite());
    let spread = |k: usize| if known { slopes[k].width() * half[k] } else { half[k] };
    (0..3).filter(|&k| half[k] > 0.0).max_by(|&a, &b| spread(a).total_cmp(&spread(b)))
}
