//! Where best to cut a run of primitives: the surface area heuristic over bins.
//!
//! After Wald: "On fast Construction of SAH-based Bounding Volume Hierarchies" (2007).
use raggio_math::{Wide, wide};
use rayon::prelude::*;
use wide::{f32x4, u32x4};

use super::prims::{Bounds, CHUNK, Prim, Run};

/// What the heuristic has to know of what is built.
pub(crate) trait Cost {
    /// Bins along an axis for the shortest runs.
    const FEWEST_BINS: usize;

    /// What asking so many primitives costs.
    fn cost(count: u32) -> f32;
}

/// Most bins along an axis; a power of two.
const BINS: usize = 64;

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
    fn bins(&self, prim: &Prim) -> u32x4 {
        let place = (prim.twice_centre() - f32x4::new(self.offset)) * f32x4::new(self.scale);
        let bits: u32x4 = (place + f32x4::splat(131_072.0)).to_bits();
        bits >> 6 & u32x4::splat(BINS as u32 - 1)
    }
}

/// What has fallen into each bin of each axis. It is kept from run to run: to make one takes as long as to fill it.
#[derive(Clone)]
pub(super) struct Bins {
    reach: [[Bounds; BINS]; 3],
    count: [[u32; BINS]; 3],
}

impl Bins {
    pub(super) const EMPTY: Bins = Bins { reach: [[Bounds::EMPTY; BINS]; 3], count: [[0; BINS]; 3] };

    #[inline(always)]
    fn fill(&mut self, prims: &[Prim], binning: &Binning) {
        self.reach.iter_mut().for_each(|bins| bins[..binning.count].fill(Bounds::EMPTY));
        self.count.iter_mut().for_each(|bins| bins[..binning.count].fill(0));
        // What lies side by side in the list falls into the same bins, and would wait for each other.
        let (first, second) = prims.split_at(prims.len() / 2);
        for (a, b) in first.iter().zip(second) {
            self.add(*a, binning);
            self.add(*b, binning);
        }
        second[first.len()..].iter().for_each(|prim| self.add(*prim, binning));
    }

    #[inline(always)]
    fn add(&mut self, prim: Prim, binning: &Binning) {
        let (reach, count) = (self.reach.iter_mut(), self.count.iter_mut());
        for ((reach, count), bin) in reach.zip(count).zip(binning.bins(&prim).to_array()) {
            reach[bin as usize].grow(prim.bounds());
            count[bin as usize] += 1;
        }
    }

    fn joined(mut self, other: Bins) -> Bins {
        for (mine, other) in self.reach.iter_mut().flatten().zip(other.reach.iter().flatten()) {
            mine.grow(other);
        }
        for (mine, other) in self.count.iter_mut().flatten().zip(other.count.iter().flatten()) {
            *mine += other;
        }
        self
    }

    #[inline(always)]
    fn best_cut<C: Cost>(&self, binning: &Binning) -> Option<Cut> {
        let mut best: Option<(f32, usize, usize)> = None;
        for axis in (0..3).filter(|&axis| binning.scale[axis] > 0.0) {
            let (cost, bin) = self.cheapest::<C>(axis, binning.count);
            if cost < best.map_or(f32::INFINITY, |b| b.0) {
                best = Some((cost, axis, bin));
            }
        }
        best.map(|(_, axis, bin)| {
            let sides = [self.all(axis, 0..bin), self.all(axis, bin..binning.count)];
            Cut { axis, bin, sides }
        })
    }

    /// What has fallen into some bins.
    #[inline(always)]
    fn all(&self, axis: usize, bins: std::ops::Range<usize>) -> (Bounds, u32) {
        let (mut reach, mut count) = (Bounds::EMPTY, 0);
        for bin in bins {
            reach.grow(&self.reach[axis][bin]);
            count += self.count[axis][bin];
        }
        (reach, count)
    }

    /// Cost and place of the cheapest cut of one axis; infinite where every cut leaves a side empty.
    #[inline(always)]
    fn cheapest<C: Cost>(&self, axis: usize, bins: usize) -> (f32, usize) {
        let (reaches, counts) = (&self.reach[axis][..bins], &self.count[axis][..bins]);
        let mut right_cost = [0.0f32; BINS];
        let (mut reach, mut count) = (Bounds::EMPTY, 0);
        for i in (1..bins).rev() {
            reach.grow(&reaches[i]);
            count += counts[i];
            right_cost[i] = if count == 0 { f32::INFINITY } else { reach.half_area() * C::cost(count) };
        }
        let (mut reach, mut count) = (Bounds::EMPTY, 0);
        let mut best = (f32::INFINITY, 0);
        for i in 1..bins {
            reach.grow(&reaches[i - 1]);
            count += counts[i - 1];
            if count == 0 {
                continue;
            }
            let cost = reach.half_area() * C::cost(count) + right_cost[i];
            if cost < best.0 {
                best = (cost, i);
            }
        }
        best
    }
}

/// Puts primitives into bins.
struct Fill<'a> {
    bins: &'a mut Bins,
    prims: &'a [Prim],
    binning: &'a Binning,
}

impl Wide for Fill<'_> {
    type Output = ();

    #[inline(always)]
    fn run(self) {
        self.bins.fill(self.prims, self.binning);
    }
}

/// Finds the best cut by what is in the bins.
struct Find<'a, C>(&'a Bins, &'a Binning, std::marker::PhantomData<C>);

impl<C: Cost> Wide for Find<'_, C> {
    type Output = Option<Cut>;

    #[inline(always)]
    fn run(self) -> Option<Cut> {
        self.0.best_cut::<C>(self.1)
    }
}

/// Puts what goes first first. Returns how much that is, and bounds of twice the centres of both sides.
struct Partition<'a> {
    prims: &'a mut [Prim],
    binning: &'a Binning,
    axis: usize,
    bin: usize,
}

impl Wide for Partition<'_> {
    type Output = (usize, [Bounds; 2]);

    /// Each primitive is swapped with the first of those that come after, and that stands one farther if it goes first:
    /// nobody could foresee a branch.
    #[inline(always)]
    fn run(self) -> (usize, [Bounds; 2]) {
        let mut centres = [Bounds::EMPTY; 2];
        let mut start = 0;
        for i in 0..self.prims.len() {
            let (prim, other) = (self.prims[i], self.prims[start]);
            self.prims[start] = prim;
            self.prims[i] = other;
            let first =
                self.binning.bins(&prim).simd_lt(u32x4::splat(self.bin as u32)).to_bitmask() >> self.axis & 1;
            start += first as usize;
            // What is not a number makes no box larger.
            let (c, mask) = (prim.twice_centre(), f32x4::splat(f32::from_bits(first.wrapping_neg())));
            centres[0].grow_to(c | !mask);
            centres[1].grow_to(c | mask);
        }
        (start, centres)
    }
}

/// Cuts a run in two and orders its primitives accordingly. Where no cut is better than another it is in the middle.
pub(super) fn split<C: Cost>(prims: &mut [Prim], run: &Run, by_area: bool, bins: &mut Bins) -> (Run, Run) {
    let binning = Binning::new(run, C::FEWEST_BINS);
    match (by_area && prims.len() > 2).then(|| best_cut::<C>(prims, &binning, bins)).flatten() {
        Some(cut) => partition(prims, &cut, &binning),
        None => {
            let (first, second) = prims.split_at(prims.len() / 2);
            (Run::of(first), Run::of(second))
        }
    }
}

fn best_cut<C: Cost>(prims: &[Prim], binning: &Binning, bins: &mut Bins) -> Option<Cut> {
    if prims.len() <= 2 * CHUNK {
        wide(Fill { bins, prims, binning });
    } else {
        let of = |prims: &[Prim]| {
            let mut bins = Bins::EMPTY;
            wide(Fill { bins: &mut bins, prims, binning });
            bins
        };
        *bins = prims.par_chunks(CHUNK).map(of).reduce(|| Bins::EMPTY, Bins::joined);
    }
    wide(Find::<C>(bins, binning, std::marker::PhantomData))
}

fn partition(prims: &mut [Prim], cut: &Cut, binning: &Binning) -> (Run, Run) {
    let (start, centres) = wide(Partition { prims, binning, axis: cut.axis, bin: cut.bin });
    let (first, second) = prims.split_at(start);
    let run = |side: usize, prims: &[Prim]| match cut.sides[side] {
        (bounds, count) if count as usize == prims.len() => {
            Run { len: prims.len(), bounds, centres: centres[side] }
        }
        // Centres that are not numbers have fallen into no bin that counts.
        _ => Run::of(prims),
    };
    (run(0, first), run(1, second))
}
