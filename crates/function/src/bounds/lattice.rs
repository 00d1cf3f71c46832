//! Bounds of lattice noise over a box.
//!
//! Within a lattice cell the noise is a weighted mean of eight linear functions, so its slope along an axis is a mean of
//! four simple ones over the other two axes; each has a range, and a mean lies between the least and the greatest mean.
use raggio_math::noise::corners;

use super::range::{greater, lesser};
use super::{Range, VARIABLES};

/// Boxes that reach into more cells than this are too large to tell anything.
const MOST_CELLS: f64 = 8.0;

/// The slopes of raw lattice noise over a box; `None` if the box is too large.
pub(super) fn slopes(at: [Range; VARIABLES]) -> Option<[Range; VARIABLES]> {
    let first = at.map(|r| r.lo.floor());
    let count: [f64; VARIABLES] = std::array::from_fn(|k| at[k].hi.floor() - first[k] + 1.0);
    // Not-a-number fails too.
    if !(count.iter().product::<f64>() <= MOST_CELLS && first.iter().all(|c| c.abs() < 1e15)) {
        return None;
    }
    let mut all: Option<[Range; VARIABLES]> = None;
    let mut cell = [0.0; VARIABLES];
    loop {
        let least: [f64; VARIABLES] = std::array::from_fn(|k| first[k] + cell[k]);
        let part = |k: usize| {
            let within = |v: f64| (v - least[k]).clamp(0.0, 1.0);
            Range { lo: within(at[k].lo), hi: within(at[k].hi) }
        };
        let found = Part::new(std::array::from_fn(part)).slopes(&corners(least));
        all = Some(all.map_or(found, |all| std::array::from_fn(|k| all[k].hull(found[k]))));
        // The next cell, counting like an odometer.
        let Some(k) = (0..VARIABLES).find(|&k| cell[k] + 1.0 < count[k]) else { return all };
        cell[..k].fill(0.0);
        cell[k] += 1.0;
    }
}

/// A part of a cell.
struct Part {
    /// Its middle and half its size, as ways from the cell's least corner.
    middle: [f64; VARIABLES],
    half: [f64; VARIABLES],
    /// The weights of the far corners.
    weight: [Range; VARIABLES],
    /// The slopes of the weights, never negative.
    steepness: [Range; VARIABLES],
}

impl Part {
    fn new(part: [Range; VARIABLES]) -> Part {
        let steepness = |f: f64| 6.0 * f * (1.0 - f);
        Part {
            middle: part.map(Range::middle),
            half: part.map(|r| 0.5 * r.width()),
            weight: part.map(|r| r.rising(|f| f * f * (3.0 - 2.0 * f))),
            steepness: part.map(|r| {
                let ends = r.rising(steepness);
                Range { lo: ends.lo, hi: if r.contains(0.5) { 1.5 } else { ends.hi } }
            }),
        }
    }

    /// The slopes of the noise.
    fn slopes(&self, corners: &[[f64; 4]; 8]) -> [Range; VARIABLES] {
        std::array::from_fn(|k| {
            let (i, j) = ((k + 1) % VARIABLES, (k + 2) % VARIABLES);
            let bit = |axis: usize| 4 >> axis;
            let of = |a: usize, b: usize| {
                let near = a * bit(i) + b * bit(j);
                self.edge(k, &corners[near], &corners[near + bit(k)], near)
            };
            let along_j = |a: usize| mean(of(a, 0), of(a, 1), self.weight[j]);
            mean(along_j(0), along_j(1), self.weight[i])
        })
    }

    /// The slope along axis `k` of the mean of two corners that lie along it.
    #[inline]
    fn edge(&self, k: usize, a: &[f64; 4], b: &[f64; 4], near: usize) -> Range {
        // How much more the far corner's linear function is; its way along k begins one unit farther.
        let (mut more, mut off) = (b[0] - a[0] - b[k + 1], 0.0);
        for axis in 0..VARIABLES {
            let begins = f64::from(u8::from(near & (4 >> axis) != 0));
            let steeper = b[axis + 1] - a[axis + 1];
            more += (self.middle[axis] - begins) * steeper;
            off += self.half[axis] * steeper.abs();
        }
        let (low, high, steepness) = (more - off, more + off, self.steepness[k]);
        let gradient =
            mean(Range { lo: a[k + 1], hi: a[k + 1] }, Range { lo: b[k + 1], hi: b[k + 1] }, self.weight[k]);
        Range {
            lo: gradient.lo + low * if low < 0.0 { steepness.hi } else { steepness.lo },
            hi: gradient.hi + high * if high > 0.0 { steepness.hi } else { steepness.lo },
        }
    }
}

/// The weighted means of two ranges.
#[inline]
fn mean(a: Range, b: Range, weight: Range) -> Range {
    let at = |a: f64, b: f64, w: f64| a + w * (b - a);
    Range {
        lo: lesser(at(a.lo, b.lo, weight.lo), at(a.lo, b.lo, weight.hi)),
        hi: greater(at(a.hi, b.hi, weight.lo), at(a.hi, b.hi, weight.hi)),
    }
}
