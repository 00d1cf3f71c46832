//! Bounds of lattice noise over a box.
//!
//! Within a lattice cell the noise is a weighted mean of eight linear functions, so its slope along an axis is a mean of
//! four simple ones over the other two axes; each has a range, and a mean lies between the least and the greatest mean.
use raggio_math::noise::corners;
use raggio_math::turns::floor;

use super::range::{greater, lesser};
use super::{Range, VARIABLES};

/// Boxes that reach into more cells than this are too large to tell anything.
const MOST_CELLS: u32 = 8;

/// The slopes of raw lattice noise over a box; `None` if the box is too large.
pub(super) fn slopes(at: [Range; VARIABLES]) -> Option<[Range; VARIABLES]> {
    let (x, y, z) = (Cells::along(at[0])?, Cells::along(at[1])?, Cells::along(at[2])?);
    if x.count * y.count * z.count > MOST_CELLS {
        return None;
    }
    let mut all: Option<[Range; VARIABLES]> = None;
    for i in 0..x.count {
        for j in 0..y.count {
            for k in 0..z.count {
                let (x, y, z) = (x.part(at[0], i), y.part(at[1], j), z.part(at[2], k));
                let found = Part::new([x.1, y.1, z.1]).slopes(&corners([x.0, y.0, z.0]));
                all = Some(match all {
                    None => found,
                    Some([x, y, z]) => [x.hull(found[0]), y.hull(found[1]), z.hull(found[2])],
                });
            }
        }
    }
    all
}

/// The cells that a range reaches into.
struct Cells {
    first: f64,
    count: u32,
}

impl Cells {
    /// `None` if they are far too many, or so far out that there is no telling them apart.
    fn along(r: Range) -> Option<Cells> {
        let first = floor(r.lo);
        let more = floor(r.hi) - first;
        // Not-a-number fails too.
        (more < f64::from(MOST_CELLS) && first.abs() < 1e15).then(|| Cells { first, count: more as u32 + 1 })
    }

    /// Where a cell begins, and the part of it that the range takes.
    #[inline]
    fn part(&self, r: Range, number: u32) -> (f64, Range) {
        let least = self.first + f64::from(number);
        (least, Range { lo: (r.lo - least).clamp(0.0, 1.0), hi: (r.hi - least).clamp(0.0, 1.0) })
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
    #[inline]
    fn new([x, y, z]: [Range; VARIABLES]) -> Part {
        let weight = |r: Range| {
            let at = |f: f64| f * f * (3.0 - 2.0 * f);
            Range { lo: at(r.lo), hi: at(r.hi) }
        };
        let steepness = |r: Range| {
            let at = |f: f64| 6.0 * f * (1.0 - f);
            let (a, b) = (at(r.lo), at(r.hi));
            Range { lo: lesser(a, b), hi: if r.contains(0.5) { 1.5 } else { greater(a, b) } }
        };
        Part {
            middle: [x.middle(), y.middle(), z.middle()],
            half: [0.5 * x.width(), 0.5 * y.width(), 0.5 * z.width()],
            weight: [weight(x), weight(y), weight(z)],
            steepness: [steepness(x), steepness(y), steepness(z)],
        }
    }

    /// The slopes of the noise.
    fn slopes(&self, corners: &[[f64; 4]; 8]) -> [Range; VARIABLES] {
        [self.along::<0>(corners), self.along::<1>(corners), self.along::<2>(corners)]
    }

    /// The slopes along axis `K`: a mean of those on the four edges along it.
    #[inline]
    fn along<const K: usize>(&self, corners: &[[f64; 4]; 8]) -> Range {
        let bit = |axis: usize| 4 >> axis;
        let (i, j) = ((K + 1) % VARIABLES, (K + 2) % VARIABLES);
        let edge = |near: usize| self.edge::<K>(&corners[near], &corners[near + bit(K)], near);
        let low = mean(edge(0), edge(bit(j)), self.weight[j]);
        let high = mean(edge(bit(i)), edge(bit(i) + bit(j)), self.weight[j]);
        mean(low, high, self.weight[i])
    }

    /// The slope along axis `K` of the mean of two corners that lie along it.
    #[inline(always)]
    fn edge<const K: usize>(&self, a: &[f64; 4], b: &[f64; 4], near: usize) -> Range {
        // How much more the far corner's linear function is; its way along the axis begins one unit farther.
        let (mut more, mut off) = (b[0] - a[0] - b[K + 1], 0.0);
        for axis in 0..VARIABLES {
            let begins = if near & (4 >> axis) != 0 { 1.0 } else { 0.0 };
            let steeper = b[axis + 1] - a[axis + 1];
            more += (self.middle[axis] - begins) * steeper;
            off += self.half[axis] * steeper.abs();
        }
        let (low, high, steepness) = (more - off, more + off, self.steepness[K]);
        let gradient = means(a[K + 1], b[K + 1], self.weight[K]);
        Range {
            lo: gradient.lo + low * if low < 0.0 { steepness.hi } else { steepness.lo },
            hi: gradient.hi + high * if high > 0.0 { steepness.hi } else { steepness.lo },
        }
    }
}

/// The weighted means of two numbers.
#[inline(always)]
fn means(a: f64, b: f64, weight: Range) -> Range {
    let (low, high) = (a + weight.lo * (b - a), a + weight.hi * (b - a));
    Range { lo: lesser(low, high), hi: greater(low, high) }
}

/// The weighted means of two ranges.
#[inline(always)]
fn mean(a: Range, b: Range, weight: Range) -> Range {
    Range { lo: means(a.lo, b.lo, weight).lo, hi: means(a.hi, b.hi, weight).hi }
}
