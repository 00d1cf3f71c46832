//! The scattered points of crackle, one in each unit cell. Those around a cell are kept while neighbours ask for them.
use std::cell::RefCell;

use raggio_math::Vec3;
use raggio_math::noise::{hash3, random3};

/// The point of the cell whose lower corner is given.
#[inline]
pub(super) fn point_in(cell: Vec3) -> Vec3 {
    cell + Vec3::from(random3(hash3(cell.x as i64, cell.y as i64, cell.z as i64)))
}

/// Numbers that are worked out together.
const LANES: usize = 4;
/// The 27 cells around one, filled up to whole groups.
const PLACES: usize = 28;

/// What is worked out for all points around a cell; infinite at the place too many.
pub(super) type Each = [f64; PLACES];

/// The points of a cell and of the 26 that touch it, x slowest, z fastest.
pub(super) struct Around {
    cell: Vec3,
    x: Each,
    y: Each,
    z: Each,
}

/// How many cells each thread remembers; about as much memory as a first-level cache holds.
const KEPT: usize = 32;

thread_local! {
    static CACHE: RefCell<[Around; KEPT]> = const { RefCell::new([Around::UNKNOWN; KEPT]) };
}

impl Around {
    /// The cell of no point: NaN equals nothing.
    const UNKNOWN: Around = Around {
        cell: Vec3::NAN,
        x: [f64::INFINITY; PLACES],
        y: [f64::INFINITY; PLACES],
        z: [f64::INFINITY; PLACES],
    };

    /// Asks the points around a cell.
    #[inline]
    pub fn ask<R>(cell: Vec3, question: impl FnOnce(&Around) -> R) -> R {
        let (x, y, z) = (cell.x as i64, cell.y as i64, cell.z as i64);
        let slot = (x ^ y.wrapping_mul(5) ^ z.wrapping_mul(11)) as usize % KEPT;
        CACHE.with_borrow_mut(|cache| {
            let around = &mut cache[slot];
            if around.cell != cell {
                around.fill(cell);
            }
            question(around)
        })
    }

    #[cold]
    fn fill(&mut self, cell: Vec3) {
        self.cell = cell;
        for i in 0..27 {
            let step = Vec3::new((i / 9) as f64, (i / 3 % 3) as f64, (i % 3) as f64) - Vec3::ONE;
            let point = point_in(cell + step);
            (self.x[i], self.y[i], self.z[i]) = (point.x, point.y, point.z);
        }
    }

    /// A number for each way from a point to `q`.
    #[inline]
    pub fn each(&self, q: Vec3, number: impl Fn(Vec3) -> f64) -> Each {
        let mut all = [f64::INFINITY; PLACES];
        for (i, value) in all.iter_mut().enumerate() {
            *value = number(q - Vec3::new(self.x[i], self.y[i], self.z[i]));
        }
        all
    }

    /// The ways from all points to `q`.
    pub fn ways(&self, q: Vec3) -> impl Iterator<Item = Vec3> {
        (0..27).map(move |i| q - Vec3::new(self.x[i], self.y[i], self.z[i]))
    }

    /// The point at a place.
    pub fn point(&self, i: usize) -> Vec3 {
        Vec3::new(self.x[i], self.y[i], self.z[i])
    }

    /// The point with the least number, the first of several.
    pub fn point_of(&self, least: f64, all: &Each) -> Vec3 {
        self.point(all.iter().position(|&v| v == least).unwrap_or(0))
    }
}

/// The `N` least numbers, ascending.
#[inline]
pub(super) fn least<const N: usize>(all: &Each) -> [f64; N] {
    // In each lane on its own, without branches, and then the lanes together.
    let mut lanes = [[f64::INFINITY; LANES]; N];
    for group in all.as_chunks::<LANES>().0 {
        let mut rest = *group;
        for kept in &mut lanes {
            for k in 0..LANES {
                (kept[k], rest[k]) = in_order(kept[k], rest[k]);
            }
        }
    }
    let mut least = [f64::INFINITY; N];
    for value in lanes.as_flattened() {
        let mut rest = *value;
        for kept in &mut least {
            (*kept, rest) = in_order(*kept, rest);
        }
    }
    least
}

/// The lower and the higher of two numbers, in the form that compilers make into the two instructions.
#[inline(always)]
pub(super) fn in_order(a: f64, b: f64) -> (f64, f64) {
    (if a < b { a } else { b }, if a > b { a } else { b })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_least_come_in_order() {
        let all: Each = std::array::from_fn(|i| ((i * 17 + 5) % PLACES) as f64);
        assert_eq!(least::<3>(&all), [0.0, 1.0, 2.0]);
        assert_eq!(least::<1>(&all), [0.0]);
    }

    #[test]
    fn remembered_cells_are_told_apart() {
        for i in 0..500 {
            let cell = Vec3::new(f64::from(i % 7), f64::from(-i), f64::from(i / 3));
            let middle = Around::ask(cell, |around| Vec3::new(around.x[13], around.y[13], around.z[13]));
            assert_eq!(middle, point_in(cell));
        }
    }
}
