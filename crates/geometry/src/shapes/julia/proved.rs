//! Where a Julia fractal is proved to be inside or outside: a grid of cells, so that rays need not march through them.
//!
//! A ball around a number is carried along with its orbit. It holds the orbits of all numbers it started with, so where
//! the whole ball escapes all of them do, and where it never leaves the ball of escape none does. Blocks of cells are
//! asked first, the parts of those of which nothing is proved after them.
//!
//! Of cells of which the same is proved as far around, a ray leaves all at once: each has its distance in cells, the
//! greatest of the three along the axes, to the nearest one that is not like it.
use raggio_math::{Aabb, Ray, Vec3};

/// The most cells along an edge of the grid, as a power of two: a row of them is a word.
const MOST_LEVELS: u32 = 6;

/// What is proved of a part of space.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(in crate::shapes) enum Proof {
    Outside,
    Inside,
    /// Nothing.
    Open,
}

/// Nothing is proved of balls that reach farther out: their squares might be too large for a number, and a middle that is
/// infinitely far out seems to be outside however large the ball is.
pub(in crate::shapes) const HUGE: f64 = 1e100;

/// A proof for each cell of a cube about the origin.
#[derive(Clone, Debug)]
pub(super) struct Proved {
    /// Cells along an edge, as a power of two.
    levels: u32,
    /// Half the edge of the cube.
    half: f64,
    /// The edge of a cell.
    cell: f64,
    /// Cells per length.
    scale: f64,
    /// What is proved of a cell, and the distance in cells to the nearest of which that is not proved: x fastest, then y.
    cells: Vec<u8>,
    /// Everything outside it is outside.
    pub(super) hull: Aabb,
}

/// Of the numbers in the grid: the distance is below, the proof from here on.
const DISTANCE_BITS: u32 = 4;
const MOST: u8 = (1 << DISTANCE_BITS) - 1;

/// A ray on its way through the grid. Lengths are in cells, distances along the ray are the ray's.
pub(super) struct Course {
    origin: [f64; 3],
    dir: [f64; 3],
    /// How long the ray takes through one cell along each axis, with the sign of the direction.
    per_cell: [f64; 3],
    /// When it would be in the middle of the first cell along each axis.
    first: [f64; 3],
}

/// Added to a number from 0 on it leaves the number, rounded, in the lowest bits.
const ROUNDING: f64 = (1u64 << 52) as f64;

impl Proved {
    /// Looks at the cube of the given half edge, in a grid for a fractal before which so many were made ready. `proof`
    /// tells what it can of the ball with a middle and a radius.
    pub(super) fn new(half: f64, before: usize, proof: impl Fn(Vec3, f64) -> Proof) -> Self {
        // One of many is small in the picture, and its grid costs more than it spares.
        let levels = match before {
            0..8 => MOST_LEVELS,
            8..1024 => MOST_LEVELS - 1,
            _ => MOST_LEVELS - 2,
        };
        let cell = 2.0 * half / f64::from(1u32 << levels);
        let mut proved = Proved {
            levels,
            half,
            cell,
            scale: 1.0 / cell,
            cells: vec![word(Proof::Open, 0); 1 << (3 * levels)],
            hull: Aabb::EMPTY,
        };
        proved.look([0; 3], levels, &proof);
        proved.measure(Proof::Outside, !0);
        proved.measure(Proof::Inside, 0);
        proved
    }

    /// Cells along an edge.
    fn edge(&self) -> usize {
        1 << self.levels
    }

    fn look(&mut self, corner: [usize; 3], level: u32, proof: &impl Fn(Vec3, f64) -> Proof) {
        let edge = self.cell * f64::from(1u32 << level);
        let min = Vec3::from_array(corner.map(|k| k as f64 * self.cell - self.half));
        // A little more than half the diagonal, for what rounding does to points.
        let found = proof(min + Vec3::splat(0.5 * edge), 0.5001 * 3f64.sqrt() * edge);
        if found == Proof::Open && level > 0 {
            let half = 1 << (level - 1);
            for part in 0..8 {
                let step = |axis: usize| corner[axis] + half * (part >> axis & 1);
                self.look([step(0), step(1), step(2)], level - 1, proof);
            }
            return;
        }
        if found != Proof::Outside {
            self.hull = self.hull.union(&Aabb { min, max: min + Vec3::splat(edge) });
        }
        let (size, cells) = (1 << level, self.edge());
        for z in corner[2]..corner[2] + size {
            for y in corner[1]..corner[1] + size {
                let start = (z * cells + y) * cells + corner[0];
                self.cells[start..start + size].fill(word(found, 0));
            }
        }
    }

    /// Measures the distances of the cells of which `proof` holds; `beyond` has all bits set if it does outside the grid.
    /// The cells lose those at their rim again and again, a row at a time.
    fn measure(&mut self, proof: Proof, beyond: u64) {
        let edge = self.edge();
        let row = |cells: &[u8]| {
            cells.iter().rev().fold(0, |row, &w| row << 1 | u64::from(w >> DISTANCE_BITS == proof as u8))
        };
        let mut rows: Vec<u64> = self.cells.chunks(edge).map(row).collect();
        for distance in 1..=MOST {
            if rows.iter().all(|&row| row == 0) {
                return;
            }
            let inner = without_rim(rows.clone(), edge, beyond);
            let kept = if distance < MOST { &inner[..] } else { &[] };
            let lost =
                rows.iter().zip(kept.iter().chain(std::iter::repeat(&0))).map(|(row, kept)| row & !kept);
            for (cells, mut lost) in self.cells.chunks_mut(edge).zip(lost) {
                while lost != 0 {
                    cells[lost.trailing_zeros() as usize] |= distance;
                    lost &= lost - 1;
                }
            }
            rows = inner;
        }
    }

    /// A ray as [`Proved::at`] needs it.
    pub(super) fn course(&self, ray: &Ray) -> Course {
        let (origin, dir) = ((ray.origin + Vec3::splat(self.half)) * self.scale, ray.dir * self.scale);
        let (origin, dir) = (origin.to_array(), dir.to_array());
        let axis = |of: fn(f64, f64) -> f64| [0, 1, 2].map(|k| of(origin[k], dir[k]));
        Course {
            origin,
            dir,
            per_cell: axis(|_, dir| if dir == 0.0 { 0.0 } else { 1.0 / dir }),
            // Where it goes along the other axes only, it never leaves a cell along this one.
            first: axis(|origin, dir| if dir == 0.0 { f64::INFINITY } else { (0.5 - origin) / dir }),
        }
    }

    /// What is proved at a distance along a ray, and to what distance.
    #[inline(always)]
    pub(super) fn at(&self, course: &Course, t: f64) -> (Proof, f64) {
        let last = self.edge() - 1;
        let place = |k: usize| {
            let x = course.origin[k] + t * course.dir[k] - 0.5;
            let x = if x > 0.0 { x } else { 0.0 };
            (if x < last as f64 { x } else { last as f64 }) + ROUNDING
        };
        let cell = [place(0), place(1), place(2)];
        let index = |k: usize| (cell[k].to_bits() as usize & last) << (self.levels * k as u32);
        let word = self.cells[index(2) | index(1) | index(0)];
        let proof = match word >> DISTANCE_BITS {
            w if w == Proof::Outside as u8 => Proof::Outside,
            w if w == Proof::Inside as u8 => Proof::Inside,
            _ => return (Proof::Open, t),
        };
        let reach = f64::from(word & MOST) - 0.5;
        let leaves = |k: usize| {
            course.first[k] + (cell[k] - ROUNDING) * course.per_cell[k] + reach * course.per_cell[k].abs()
        };
        let less = |a: f64, b: f64| if a < b { a } else { b };
        let until = less(leaves(0), less(leaves(1), leaves(2)));
        (proof, if until > t { until } else { t })
    }

    /// How far the ray goes outside from a distance on; `None` if for good.
    pub(super) fn outside_until(&self, course: &Course, mut t: f64, end: f64) -> Option<f64> {
        // A step over the border of a cell, for what rounding does to it.
        let over = 1e-6 * self.cell;
        while t < end {
            match self.at(course, t) {
                (Proof::Outside, until) => t = until + over,
                _ => return Some(t),
            }
        }
        None
    }
}

fn word(proof: Proof, distance: u8) -> u8 {
    (proof as u8) << DISTANCE_BITS | distance
}

/// The cells whose neighbours, those across edges and corners too, are in the rows like themselves.
fn without_rim(mut rows: Vec<u64>, edge: usize, beyond: u64) -> Vec<u64> {
    for row in &mut rows {
        let (last, first) = (beyond << (edge - 1), beyond & 1);
        *row &= (*row >> 1 | last) & (*row << 1 | first);
    }
    for step in [1, edge] {
        let before = rows.clone();
        for (at, row) in rows.iter_mut().enumerate() {
            let along = at / step % edge;
            let lower = if along > 0 { before[at - step] } else { beyond };
            let upper = if along < edge - 1 { before[at + step] } else { beyond };
            *row &= lower & upper;
        }
    }
    rows
}
