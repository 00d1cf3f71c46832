//! Where a Julia fractal is proved to be inside or outside: a grid of blocks, so that rays need not march through them.
//!
//! A ball around a number is carried along with its orbit. It holds the orbits of all numbers it started with, so where
//! the whole ball escapes all of them do, and where it never leaves the ball of escape none does.
use raggio_math::{Aabb, Ray, Vec3};

/// Cells along an edge of the grid, as a power of two.
const LEVELS: u32 = 6;
const CELLS: usize = 1 << LEVELS;

/// What is proved of a part of space.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(in crate::shapes) enum Proof {
    Outside,
    Inside,
    /// Nothing.
    Open,
}

/// A proof for each cell of a cube about the origin.
#[derive(Clone, Debug)]
pub(super) struct Proved {
    /// Half the edge of the cube.
    half: f64,
    /// The edge of a cell.
    cell: f64,
    /// Cells per length.
    scale: f64,
    /// The level of the block that a cell belongs to, plus what is proved of the block: x fastest, then y.
    cells: Vec<u8>,
    /// Everything outside it is outside.
    pub(super) hull: Aabb,
}

/// Of the numbers in the grid: the level is below, the proof from here on.
const LEVEL_BITS: u32 = 4;

impl Proved {
    /// Looks at the cube of the given half edge. `proof` tells what it can of the ball with a middle and a radius.
    pub(super) fn new(half: f64, proof: impl Fn(Vec3, f64) -> Proof) -> Self {
        let cell = 2.0 * half / CELLS as f64;
        let mut proved = Proved {
            half,
            cell,
            scale: 1.0 / cell,
            cells: vec![0; CELLS * CELLS * CELLS],
            hull: Aabb::EMPTY,
        };
        proved.look([0; 3], LEVELS, &proof);
        proved
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
        let size = 1 << level;
        let word = level as u8 | (found as u8) << LEVEL_BITS;
        for z in corner[2]..corner[2] + size {
            for y in corner[1]..corner[1] + size {
                let start = (z * CELLS + y) * CELLS + corner[0];
                self.cells[start..start + size].fill(word);
            }
        }
    }

    /// What is proved at a distance along a ray, and to what distance: as far as the block reaches. `inverse` is one
    /// over the ray's direction.
    #[inline]
    pub(super) fn at(&self, ray: &Ray, inverse: Vec3, t: f64) -> Option<(bool, f64)> {
        let place = (ray.at(t) + Vec3::splat(self.half)) * self.scale;
        // Numbers below 0 become 0.
        let cell = place.to_array().map(|x| (x as usize).min(CELLS - 1));
        let word = self.cells[(cell[2] * CELLS + cell[1]) * CELLS + cell[0]];
        let inside = match word >> LEVEL_BITS {
            w if w == Proof::Outside as u8 => false,
            w if w == Proof::Inside as u8 => true,
            _ => return None,
        };
        let size = 1usize << (word & ((1 << LEVEL_BITS) - 1));
        let mut until = f64::INFINITY;
        for axis in 0..3 {
            let face = (cell[axis] & !(size - 1)) + if inverse[axis] > 0.0 { size } else { 0 };
            until = until.min((face as f64 * self.cell - self.half - ray.origin[axis]) * inverse[axis]);
        }
        Some((inside, until.max(t)))
    }
}
