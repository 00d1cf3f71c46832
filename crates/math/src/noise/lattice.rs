//! Lattice noise: a value and a gradient at each integer point, mixed between (textures spec, section 1.2).
use super::s_curve;
use super::tables::HASH;
use super::values::VALUES;
use crate::{EPS, Vec3};

/// Where a coordinate falls: the lattice cell, masked, and the distance from its lower side.
#[inline]
fn split(c: f64) -> (usize, f64) {
    let t = if c >= 0.0 { c as i64 } else { (c - (1.0 - EPS)) as i64 };
    ((t.wrapping_add(10000) & 4095) as usize, c - t as f64)
}

/// The eight corners of a cell: index into the value table and offsets of the point from each corner.
struct Cell {
    corners: [usize; 8],
    f: Vec3,
}

impl Cell {
    #[inline]
    fn at(p: Vec3) -> Cell {
        let ((ix, fx), (iy, fy), (iz, fz)) = (split(p.x), split(p.y), split(p.z));
        let h = |i: usize| usize::from(HASH[i & 8191]);
        let mut corners = [0; 8];
        for dx in 0..2 {
            let hx = h(ix + dx);
            for dy in 0..2 {
                let hy = h(hx ^ (iy + dy));
                for dz in 0..2 {
                    corners[4 * dx + 2 * dy + dz] = h(hy ^ (iz + dz)) & 255;
                }
            }
        }
        Cell { corners, f: Vec3::new(fx, fy, fz) }
    }

    /// Channel `m` at corner `(dx, dy, dz)`.
    #[inline]
    fn corner(&self, dx: usize, dy: usize, dz: usize, m: usize) -> f64 {
        let first = (self.corners[4 * dx + 2 * dy + dz] & 255) + 4 * m;
        0.5 * VALUES[first]
            + VALUES[first + 1] * (self.f.x - dx as f64)
            + VALUES[first + 2] * (self.f.y - dy as f64)
            + VALUES[first + 3] * (self.f.z - dz as f64)
    }

    /// Channel `m` mixed between the corners.
    #[inline]
    fn mix(&self, m: usize, s: Vec3) -> f64 {
        let along_z = |dx, dy| {
            let (a, b) = (self.corner(dx, dy, 0, m), self.corner(dx, dy, 1, m));
            a + s.z * (b - a)
        };
        let along_y = |dx| {
            let (a, b) = (along_z(dx, 0), along_z(dx, 1));
            a + s.y * (b - a)
        };
        let (a, b) = (along_y(0), along_y(1));
        a + s.x * (b - a)
    }

    #[inline]
    fn weights(&self) -> Vec3 {
        Vec3::new(s_curve(self.f.x), s_curve(self.f.y), s_curve(self.f.z))
    }
}

/// Raw scalar noise, about -0.95 to 0.95.
#[inline]
pub(super) fn scalar(p: Vec3) -> f64 {
    let cell = Cell::at(p);
    cell.mix(0, cell.weights())
}

/// Vector noise at a point: three channels of lattice noise, each about -1 to 1, the same for every generator.
pub fn dnoise(p: Vec3) -> Vec3 {
    let cell = Cell::at(p);
    let s = cell.weights();
    Vec3::new(cell.mix(0, s), cell.mix(1, s), cell.mix(2, s))
}
