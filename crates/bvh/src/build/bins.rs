//! Boxes of primitives, and where best to cut a run of them: the surface area heuristic over bins.
//!
//! After Wald: "On fast Construction of SAH-based Bounding Volume Hierarchies" (2007).
use raggio_math::{Aabb, Vec3};
use rayon::prelude::*;

/// What the heuristic has to know of what is built.
pub(crate) trait Cost {
    /// Bins along an axis for the shortest runs.
    const FEWEST_BINS: usize;

    /// What asking so many primitives costs.
    fn cost(count: u32) -> f32;
}

/// Most bins along an axis; a power of two.
const BINS: usize = 64;
/// Longer runs are shared among threads, in chunks of this.
const CHUNK: usize = 1 << 14;

/// A box that grows. The fourth lane is not looked at.
#[derive(Clone, Copy, Debug)]
#[repr(C, align(16))]
pub(crate) struct Bounds {
    pub(crate) lo: [f32; 4],
    pub(crate) hi: [f32; 4],
}

impl Bounds {
    pub(crate) const EMPTY: Bounds = Bounds { lo: [f32::INFINITY; 4], hi: [f32::NEG_INFINITY; 4] };

    #[inline(always)]
    pub(crate) fn grow(&mut self, other: &Bounds) {
        for k in 0..4 {
            self.lo[k] = if other.lo[k] < self.lo[k] { other.lo[k] } else { self.lo[k] };
            self.hi[k] = if other.hi[k] > self.hi[k] { other.hi[k] } else { self.hi[k] };
        }
    }

    #[inline(always)]
    fn grow_to(&mut self, point: [f32; 4]) {
        self.grow(&Bounds { lo: point, hi: point });
    }

    /// A box around both.
    #[inline(always)]
    pub(super) fn joined(mut self, other: &Bounds) -> Bounds {
        self.grow(other);
        self
    }

    #[inline(always)]
    pub(super) fn half_area(&self) -> f32 {
        let d = [self.hi[0] - self.lo[0], self.hi[1] - self.lo[1], self.hi[2] - self.lo[2]];
        if d[0] < 0.0 { 0.0 } else { d[0] * d[1] + d[1] * d[2] + d[2] * d[0] }
    }

    pub(crate) fn aabb(&self) -> Aabb {
        let corner = |c: &[f32; 4]| Vec3::new(f64::from(c[0]), f64::from(c[1]), f64::from(c[2]));
        Aabb { min: corner(&self.lo), max: corner(&self.hi) }
    }
}

/// A primitive while the tree is built: its box, and its number in the fourth lane, where no number below 2^30 makes
/// anything but a small positive float.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Prim(Bounds);

impl Prim {
    #[inline(always)]
    pub(crate) fn new(mut bounds: Bounds, number: u32) -> Prim {
        bounds.lo[3] = f32::from_bits(number);
        // Sums of both are 1 whatever the number, so that no denormal number gets into a product.
        bounds.hi[3] = 1.0;
        Prim(bounds)
    }

    #[cfg(test)]
    pub(super) fn bounds(&self) -> &Bounds {
        &self.0
    }

    pub(crate) fn number(&self) -> u32 {
        self.0.lo[3].to_bits()
    }

    #[inline(always)]
    fn twice_centre(&self) -> [f32; 4] {
        let (lo, hi) = (&self.0.lo, &self.0.hi);
        [lo[0] + hi[0], lo[1] + hi[1], lo[2] + hi[2], lo[3] + hi[3]]
    }
}

/// A run of primitives on its way into a child.
#[derive(Clone, Copy, Debug)]
pub(super) struct Run {
    pub(super) len: usize,
    /// May it become a leaf?
    pub(super) leaf: bool,
    pub(super) bounds: Bounds,
    /// Bounds of twice the centres.
    centres: Bounds,
}

impl Run {
    const EMPTY: Run = Run { len: 0, leaf: false, bounds: Bounds::EMPTY, centres: Bounds::EMPTY };

    pub(super) fn of(prims: &[Prim]) -> Run {
        let one = |prims: &[Prim]| {
            let mut run = Run::EMPTY;
            prims.iter().for_each(|prim| run.add(prim));
            run
        };
        match prims.len() <= 2 * CHUNK {
            true => one(prims),
            false => prims.par_chunks(CHUNK).map(one).reduce(|| Run::EMPTY, Run::joined),
        }
    }

    #[inline(always)]
    fn add(&mut self, prim: &Prim) {
        let c = prim.twice_centre();
        self.bounds.grow(&prim.0);
        self.centres.grow(&Bounds { lo: c, hi: c });
        self.len += 1;
    }

    fn joined(mut self, other: Run) -> Run {
        self.bounds.grow(&other.bounds);
        self.centres.grow(&other.centres);
        self.len += other.len;
        self
    }
}

/// How twice a centre becomes a bin.
#[derive(Clone, Copy)]
struct Binning {
    count: usize,
    offset: [f32; 4],
    scale: [f32; 4],
}

/// Everything before `bin` along `axis` goes first.
struct Cut {
    axis: usize,
    bin: usize,
    binning: Binning,
    /// What has fallen to each side of it.
    sides: [(Bounds, u32); 2],
}

impl Binning {
    fn new(run: &Run, fewest: usize) -> Binning {
        let count = (4 + run.len / 20).clamp(fewest, BINS);
        let mut scale = [0.0; 4];
        for (k, scale) in scale.iter_mut().enumerate().take(3) {
            let size = run.centres.hi[k] - run.centres.lo[k];
            // A hair under `count`, so that the last centre falls into the last bin.
            *scale = if size > 1e-34 { 0.99 * count as f32 / size } else { 0.0 };
        }
        Binning { count, offset: run.centres.lo, scale }
    }

    /// The bin of each axis. Adding 2^17 leaves 6 binary places behind the point in a single, and the bin as a whole
    /// number before it: that is quicker than a conversion, which has to mind what does not fit. What is not a number
    /// falls into any bin that there is.
    #[inline(always)]
    fn bins(&self, prim: &Prim) -> [u32; 4] {
        [0, 1, 2, 3].map(|axis| self.bin(prim, axis))
    }

    /// The bin of one axis.
    #[inline(always)]
    fn bin(&self, prim: &Prim, axis: usize) -> u32 {
        let c = prim.0.lo[axis] + prim.0.hi[axis];
        let bin = (c - self.offset[axis]) * self.scale[axis] + 131_072.0;
        bin.to_bits() >> 6 & (BINS as u32 - 1)
    }
}

/// What has fallen into each bin of each axis. It is kept from run to run: to make one takes as long as to fill it.
#[derive(Clone)]
pub(super) struct Bins([[(Bounds, u32); BINS]; 3]);

impl Bins {
    pub(super) const EMPTY: Bins = Bins([[(Bounds::EMPTY, 0); BINS]; 3]);

    fn fill(&mut self, prims: &[Prim], binning: &Binning) {
        self.0.iter_mut().for_each(|bins| bins[..binning.count].fill((Bounds::EMPTY, 0)));
        for prim in prims {
            let places = binning.bins(prim);
            for (axis, bins) in self.0.iter_mut().enumerate() {
                let bin = &mut bins[places[axis] as usize & (BINS - 1)];
                bin.0.grow(&prim.0);
                bin.1 += 1;
            }
        }
    }

    fn of(prims: &[Prim], binning: &Binning) -> Bins {
        let mut bins = Bins::EMPTY;
        bins.fill(prims, binning);
        bins
    }

    fn joined(mut self, other: Bins) -> Bins {
        for (mine, others) in self.0.iter_mut().flatten().zip(other.0.iter().flatten()) {
            mine.0.grow(&others.0);
            mine.1 += others.1;
        }
        self
    }

    fn best_cut<C: Cost>(&self, binning: &Binning) -> Option<Cut> {
        let mut best: Option<(f32, usize, usize)> = None;
        for (axis, bins) in self.0.iter().enumerate().filter(|(axis, _)| binning.scale[*axis] > 0.0) {
            let (cost, bin) = cheapest::<C>(&bins[..binning.count]);
            if cost < best.map_or(f32::INFINITY, |b| b.0) {
                best = Some((cost, axis, bin));
            }
        }
        best.map(|(_, axis, bin)| {
            let (left, right) = self.0[axis][..binning.count].split_at(bin);
            Cut { axis, bin, binning: *binning, sides: [all(left), all(right)] }
        })
    }
}

/// What has fallen into some bins.
fn all(bins: &[(Bounds, u32)]) -> (Bounds, u32) {
    bins.iter().fold((Bounds::EMPTY, 0), |all, bin| (all.0.joined(&bin.0), all.1 + bin.1))
}

/// Cost and place of the cheapest cut of one axis; infinite where every cut leaves a side empty.
fn cheapest<C: Cost>(bins: &[(Bounds, u32)]) -> (f32, usize) {
    let mut right_cost = [0.0f32; BINS];
    let (mut bounds, mut count) = (Bounds::EMPTY, 0);
    for (i, bin) in bins.iter().enumerate().rev() {
        bounds.grow(&bin.0);
        count += bin.1;
        right_cost[i] = if count == 0 { f32::INFINITY } else { bounds.half_area() * C::cost(count) };
    }
    let (mut bounds, mut count) = (Bounds::EMPTY, 0);
    let mut best = (f32::INFINITY, 0);
    for i in 1..bins.len() {
        bounds.grow(&bins[i - 1].0);
        count += bins[i - 1].1;
        if count == 0 {
            continue;
        }
        let cost = bounds.half_area() * C::cost(count) + right_cost[i];
        if cost < best.0 {
            best = (cost, i);
        }
    }
    best
}

/// Cuts a run in two and orders its primitives accordingly. Where no cut is better than another it is in the middle.
pub(super) fn split<C: Cost>(prims: &mut [Prim], run: &Run, by_area: bool, bins: &mut Bins) -> (Run, Run) {
    match (by_area && prims.len() > 2).then(|| best_cut::<C>(prims, run, bins)).flatten() {
        Some(cut) => partition(prims, &cut),
        None => {
            let (first, second) = prims.split_at(prims.len() / 2);
            (Run::of(first), Run::of(second))
        }
    }
}

fn best_cut<C: Cost>(prims: &[Prim], run: &Run, bins: &mut Bins) -> Option<Cut> {
    let binning = Binning::new(run, C::FEWEST_BINS);
    if run.len <= 2 * CHUNK {
        bins.fill(prims, &binning);
        return bins.best_cut::<C>(&binning);
    }
    let of = |prims: &[Prim]| Bins::of(prims, &binning);
    prims.par_chunks(CHUNK).map(of).reduce(|| Bins::EMPTY, Bins::joined).best_cut::<C>(&binning)
}

/// What goes first is put first. Each primitive is swapped with the first of those that come after, and that stands one
/// farther if it goes first: nobody could foresee a branch.
fn partition(prims: &mut [Prim], cut: &Cut) -> (Run, Run) {
    let mut centres = [Bounds::EMPTY; 2];
    let mut start = 0;
    for i in 0..prims.len() {
        let prim = prims[i];
        prims[i] = prims[start];
        prims[start] = prim;
        let first = (cut.binning.bin(&prim, cut.axis) as usize) < cut.bin;
        start += usize::from(first);
        // What is not a number makes no box larger.
        let (c, mask) = (prim.twice_centre(), u32::from(first).wrapping_neg());
        centres[0].grow_to(c.map(|c| f32::from_bits(c.to_bits() | !mask)));
        centres[1].grow_to(c.map(|c| f32::from_bits(c.to_bits() | mask)));
    }
    let (first, second) = prims.split_at(start);
    let run = |side: usize, prims: &[Prim]| match cut.sides[side] {
        (bounds, count) if count as usize == prims.len() => {
            Run { len: prims.len(), leaf: false, bounds, centres: centres[side] }
        }
        // Centres that are not numbers have fallen into no bin that counts.
        _ => Run::of(prims),
    };
    (run(0, first), run(1, second))
}
