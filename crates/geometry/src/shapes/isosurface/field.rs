//! What is known of an isosurface's function wherever rays come by: a tree of boxes, made as they are visited.
//!
//! A box knows where the function's values lie in it, and between which two linear functions the function stays. Boxes
//! without the surface are left out, those where the slopes hardly differ are not cut further. What a box knows does not
//! depend on who asks, so pictures do not depend on the order of rays.
use std::collections::HashMap;
use std::sync::atomic::{AtomicU8, AtomicU32, AtomicU64, Ordering};
use std::sync::{Arc, LazyLock, Mutex, OnceLock, PoisonError, Weak};

use once_cell::race::OnceBox;
use raggio_function::{Bounds, Function, Range};
use raggio_math::{Aabb, Vec3};

use super::super::container;
use super::search::TELLING;

/// Boxes are cut in two this many times at most.
const MOST_CUTS: u8 = 16;
/// Where a search can do without smaller boxes they are cut only if they keep being searched, up to this many times.
pub(super) const MOST_LATE_CUTS: u8 = 20;
/// After how many searches, and for the cuts beyond the usual ones.
const SEARCHES: u32 = 4;
const LATE_SEARCHES: u32 = 12;
/// Where slopes seem steeper than so many times the scene's maximal gradient their bounds are too wide to tell anything
/// soon, and boxes are cut this many times at most.
const TOO_STEEP: f64 = 1.5;
const BLIND_CUTS: u8 = 10;
/// A box is not cut where the slopes differ by less than this share of the steepest.
const ALIKE: f64 = 1.0;
/// A slope beyond the scene's by this factor is not due to rounding.
const CLEARLY: f64 = 1.001;

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

/// A box of the tree. Kept small, for there are many and rays come through most of them only on the way to others; none
/// lies across two cache lines.
#[derive(Debug)]
#[repr(C, align(32))]
pub(super) struct Cell {
    /// Where the box is cut.
    pub plane: f64,
    halves: OnceBox<[Cell; 2]>,
    known: Box<Known>,
    /// A [`Kind`]; it changes when the box is cut late, and when its halves turn out to be free.
    kind: AtomicU8,
    /// How often the whole was cut to get here.
    depth: u8,
}

/// What a walk has to know of a box.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd)]
pub(super) struct Kind(u8);

/// What is known of a box.
#[derive(Debug)]
struct Known {
    /// All values in the box.
    value: Range,
    model: Model,
    bounds: Aabb,
    /// How often it was searched, about.
    searches: AtomicU32,
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

    /// How much the value changes along a way by the middle of the slopes, and how far that may be off, where the way's
    /// parts have these sizes.
    #[inline(always)]
    pub(super) fn change(&self, way: Vec3, sizes: Vec3) -> (f64, f64) {
        (self.slope.dot(way), self.spread.dot(sizes))
    }

    /// The value by the middle of the slopes at a point of the box, and how far it is from the centre.
    #[inline(always)]
    pub(super) fn near(&self, p: Vec3) -> (f64, Vec3) {
        let d = p - self.centre;
        (self.middle + self.slope.dot(d), d)
    }

    /// How far off the value may be, so far from the centre.
    #[inline(always)]
    pub(super) fn off_at(&self, d: Vec3) -> f64 {
        self.spread.dot(d.abs())
    }

    /// Where the slope along a direction lies.
    #[inline]
    pub(super) fn along(&self, dir: Vec3) -> Range {
        let (slope, spread) = (self.slope.dot(dir), self.spread.dot(dir.abs()));
        Range { lo: slope - spread, hi: slope + spread }
    }
}

impl Kind {
    /// From here it is cut across an axis, which the last two bits tell.
    const CUT: Kind = Kind(0);
    /// From here the surface may be in it; it is not cut, but will be once it has often been searched.
    pub(super) const LATE: Kind = Kind(4);
    /// The surface may be in it; it is not cut.
    pub(super) const OPEN: Kind = Kind(8);
    /// The function is above the threshold, or below it, everywhere in it.
    const ABOVE: Kind = Kind(9);
    const BELOW: Kind = Kind(10);

    /// The axis across which a box is or will be cut.
    #[inline(always)]
    pub(super) fn axis(self) -> usize {
        self.0 as usize & 3
    }

    /// One that is or will be cut.
    fn across(self, axis: usize) -> Kind {
        Kind(self.0 | axis as u8)
    }

    fn uncut(value: Range) -> Kind {
        if value.lo > 0.0 {
            Kind::ABOVE
        } else if value.hi < 0.0 {
            Kind::BELOW
        } else {
            Kind::OPEN
        }
    }
}

impl Cell {
    /// Is `sign` times the function positive in all of the box?
    #[inline]
    pub(super) fn is_positive(&self, sign: f64) -> bool {
        self.kind() == if sign > 0.0 { Kind::ABOVE } else { Kind::BELOW }
    }

    /// What the box is now: other threads may find out more at any time.
    #[inline(always)]
    pub(super) fn kind(&self) -> Kind {
        Kind(self.kind.load(Ordering::Relaxed))
    }

    /// How many boxes were made of this one, with itself.
    #[cfg(test)]
    pub(super) fn count(&self) -> usize {
        1 + self.halves.get().map_or(0, |halves| halves.iter().map(Cell::count).sum())
    }

    /// Joins halves around a point that are free alike: a walk need not look into them any more.
    fn join(&self, at: Vec3) {
        let kind = self.kind();
        let Some(halves) = self.halves.get().filter(|_| kind < Kind::OPEN) else { return };
        halves[usize::from(at[kind.axis()] >= self.plane)].join(at);
        let [low, high] = halves.each_ref().map(Cell::kind);
        if low == high && low > Kind::OPEN {
            self.kind.store(low.0, Ordering::Relaxed);
        }
    }

    #[inline]
    pub(super) fn model(&self) -> &Model {
        &self.known.model
    }

    /// Where the value at a point of the box lies.
    #[inline]
    pub(super) fn value_at(&self, p: Vec3) -> Range {
        let Known { value, model, .. } = &*self.known;
        if !value.contains(0.0) || !model.is_known() {
            return *value;
        }
        let (middle, off) = model.at(p);
        let (lo, hi) = (middle - off, middle + off);
        match self.kind() {
            // Known from the halves alone.
            Kind::ABOVE => Range { lo: f64::MIN_POSITIVE, hi: f64::INFINITY }.meet(Range { lo, hi }),
            Kind::BELOW => Range { lo: f64::NEG_INFINITY, hi: -f64::MIN_POSITIVE }.meet(Range { lo, hi }),
            _ => Range { lo, hi },
        }
    }
}

impl Known {
    /// May smaller boxes tell much more of a function that the scene says to have slopes up to `max_gradient`?
    fn is_worth_cutting(&self, depth: u8, most_cuts: u8, max_gradient: f64) -> bool {
        let Model { slope, spread, .. } = self.model;
        let steepest = (slope.abs() + spread).max_element();
        let well_known = self.model.is_known() && 2.0 * spread.element_sum() <= ALIKE * steepest;
        let most = if steepest <= TOO_STEEP * max_gradient { most_cuts } else { BLIND_CUTS };
        self.value.contains(0.0) && !well_known && depth < most
    }

    /// How the box is cut, if it is.
    fn cut(&self, axis: usize, depth: u8, max_gradient: f64) -> Option<Kind> {
        let Model { slope, spread, .. } = self.model;
        // The first point of a grid below zero is found whatever is known of smaller boxes, and what a ray meets does not
        // depend on the rays before it.
        let is_certain =
            (slope.abs() + spread).length() <= max_gradient && spread.length() < TELLING * max_gradient;
        let (most_cuts, when) =
            if is_certain { (MOST_LATE_CUTS, Kind::LATE) } else { (MOST_CUTS, Kind::CUT) };
        self.is_worth_cutting(depth, most_cuts, max_gradient).then(|| when.across(axis))
    }
}

/// Bits of a container's box, a threshold and a maximal gradient.
type Key = [u64; 8];

/// The fields in use; copies of an object share theirs, and so do objects whose functions compute the same.
static SHARED: LazyLock<Mutex<HashMap<Key, Vec<Weak<Field>>>>> = LazyLock::new(Mutex::default);

impl Field {
    /// A field that may be shared with objects of the same form, unless nothing can be told of the function anywhere.
    pub(super) fn shared(iso: &raggio_scene::Isosurface) -> Option<Arc<Self>> {
        let Aabb { min, max } = container::bounds(&iso.container);
        let numbers = [min.x, min.y, min.z, max.x, max.y, max.z, iso.threshold, iso.max_gradient];
        let mut shared = SHARED.lock().unwrap_or_else(PoisonError::into_inner);
        if shared.len().is_power_of_two() {
            shared.retain(|_, fields| fields.iter().any(|field| field.strong_count() > 0));
        }
        let alike = shared.entry(numbers.map(f64::to_bits)).or_default();
        alike.retain(|field| field.strong_count() > 0);
        let known = alike.iter().filter_map(Weak::upgrade);
        for field in known {
            if Arc::ptr_eq(&field.function, &iso.function) || field.function.same(&iso.function) {
                return Some(field);
            }
        }
        let field = Arc::new(Field::new(iso)?);
        alike.push(Arc::downgrade(&field));
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
            !field.cell(Aabb { min: at, max: at }, 0).known.value.is_all()
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

    /// The box of the whole.
    #[inline]
    pub(super) fn root(&self) -> &Cell {
        self.root.get_or_init(|| self.cell(self.bounds, 0))
    }

    /// The halves of a box that is cut.
    #[inline(always)]
    pub(super) fn halves<'a>(&self, cell: &'a Cell) -> &'a [Cell; 2] {
        match cell.halves.get() {
            Some(halves) => halves,
            None => self.cut(cell),
        }
    }

    /// Takes note that the function was searched for roots in a box; cuts it if that is often done.
    #[inline]
    pub(super) fn note_search(&self, cell: &Cell) {
        let kind = cell.kind();
        if kind < Kind::OPEN {
            // Threads may lose each other's counts.
            let searches = cell.known.searches.load(Ordering::Relaxed) + 1;
            cell.known.searches.store(searches, Ordering::Relaxed);
            if searches == if cell.depth < MOST_CUTS { SEARCHES } else { LATE_SEARCHES } {
                self.cut(cell);
                // Unless the halves have been joined.
                let cut = Kind::CUT.across(kind.axis());
                let _ = cell.kind.compare_exchange(kind.0, cut.0, Ordering::Relaxed, Ordering::Relaxed);
            }
        }
    }

    /// Cuts a box.
    #[cold]
    #[inline(never)]
    fn cut<'a>(&self, cell: &'a Cell) -> &'a [Cell; 2] {
        let halves = cell.halves.get_or_init(|| {
            let (mut low, mut high) = (cell.known.bounds, cell.known.bounds);
            let axis = cell.kind().axis();
            low.max[axis] = cell.plane;
            high.min[axis] = cell.plane;
            Box::new([low, high].map(|bounds| self.cell(bounds, cell.depth + 1)))
        });
        self.root().join(cell.known.bounds.centre());
        halves
    }

    /// Bounds the function over a box that comes from cutting the whole `depth` times.
    fn cell(&self, bounds: Aabb, depth: u8) -> Cell {
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
        let known = Box::new(Known { value, model, bounds, searches: AtomicU32::new(0) });
        let cut = axis_to_cut(&found.slopes, half).and_then(|axis| known.cut(axis, depth, self.max_gradient));
        Cell {
            plane: cut.map_or(0.0, |kind| centre[kind.axis()]),
            halves: OnceBox::new(),
            known,
            kind: AtomicU8::new(cut.unwrap_or_else(|| Kind::uncut(value)).0),
            depth,
        }
    }
}

/// The axis along which the function differs most; the longest, if that is not known.
fn axis_to_cut(slopes: &[Range; 3], half: Vec3) -> Option<usize> {
    let known = slopes.iter().all(|s| s.size().is_finite());
    let spread = |k: usize| if known { slopes[k].width() * half[k] } else { half[k] };
    (0..3).filter(|&k| half[k] > 0.0).max_by(|&a, &b| spread(a).total_cmp(&spread(b)))
}
