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
    pub(super) fn at(&self, ray: &Ray, inverse: Vec3, t: f64) -> (Proof, f64) {
        let place = (ray.at(t) + Vec3::splat(self.half)) * self.scale;
        // Numbers below 0 become 0.
        let of = |x: f64| (x as usize).min(CELLS - 1);
        let cell = [of(place.x), of(place.y), of(place.z)];
        let word = self.cells[(cell[2] * CELLS + cell[1]) * CELLS + cell[0]];
        let proof = match word >> LEVEL_BITS {
            w if w == Proof::Outside as u8 => Proof::Outside,
            w if w == Proof::Inside as u8 => Proof::Inside,
            _ => return (Proof::Open, t),
        };
        let size = 1usize << (word & ((1 << LEVEL_BITS) - 1));
        let face = |cell: usize, origin: f64, inverse: f64| {
            let side = (cell & !(size - 1)) + if inverse > 0.0 { size } else { 0 };
            (side as f64 * self.cell - self.half - origin) * inverse
        };
        let (o, i) = (ray.origin, inverse);
        let until = face(cell[0], o.x, i.x).min(face(cell[1], o.y, i.y)).min(face(cell[2], o.z, i.z));
        (proof, until.max(t))
    }

    /// How far the ray goes outside from a distance on; `None` if for good.
    pub(super) fn outside_until(&self, ray: &Ray, inverse: Vec3, mut t: f64, end: f64) -> Option<f64> {
        // A step over the border of a block, for what rounding does to it.
        let over = 1e-6 * self.cell;
        while t < end {
            match self.at(ray, inverse, t) {
                (Proof::Outside, until) => t = until + over,
                _ => return Some(t),
            }
        }
        None
    }
}
