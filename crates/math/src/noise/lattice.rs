//! Lattice noise: a value and a gradient at each integer point, mixed between (textures spec, section 1.2).
use super::s_curve;
use super::tables::HASH;
use super::values::VALUES;
use crate::{EPS, Vec3};
use wide::f64x4;

/// Added to a number below 2^51 it leaves the nearest whole number in the low bits of the sum.
const ROUND: f64 = 6_755_399_441_055_744.0;

/// Where a coordinate falls: the lattice cell, masked, and the distance from its lower side. A coordinate within `EPS`
/// below a whole number belongs to the upper cell on the negative side. Beyond 2^51 the answer means nothing.
#[inline]
fn split(c: f64) -> (usize, f64) {
    let shifted = if c < 0.0 { c + EPS } else { c };
    let rounded = shifted + ROUND;
    let whole = rounded - ROUND;
    let above = whole > shifted;
    let cell = rounded.to_bits().wrapping_add(10000).wrapping_sub(u64::from(above));
    ((cell & 4095) as usize, c - whole + if above { 1.0 } else { 0.0 })
}

/// The cell that a point lies in, with all that its channels share.
///
/// A corner holds a value and a gradient, four numbers in a row; what it adds is their product with the corner's
/// weight times (0.5, and the way from the corner). `factors` has those products for the four corners of one side
/// but for the weight and the way along x, which [`Cell::channel`] multiplies in last.
struct Cell {
    /// Indices into the values, x slowest, z fastest.
    corners: [usize; 8],
    factors: [f64x4; 4],
    fx: f64,
    sx: f64,
}

impl Cell {
    #[inline(always)]
    fn at(p: Vec3) -> Cell {
        let ((ix, fx), (iy, fy), (iz, fz)) = (split(p.x), split(p.y), split(p.z));
        let (sy, sz) = (s_curve(fy), s_curve(fz));
        let h = |i: usize| usize::from(HASH[i & 8191]);
        let (x0, x1) = (h(ix), h(ix + 1));
        let sides = [h(x0 ^ iy), h(x0 ^ (iy + 1)), h(x1 ^ iy), h(x1 ^ (iy + 1))];
        let corner = |side: usize, dz: usize| h(sides[side] ^ (iz + dz)) & 255;
        let corners = [
            corner(0, 0),
            corner(0, 1),
            corner(1, 0),
            corner(1, 1),
            corner(2, 0),
            corner(2, 1),
            corner(3, 0),
            corner(3, 1),
        ];
        let factor = |wy: f64, wz: f64, fy: f64, fz: f64| {
            let w = wy * wz;
            f64x4::new([0.5 * w, w, w * fy, w * fz])
        };
        let factors = [
            factor(1.0 - sy, 1.0 - sz, fy, fz),
            factor(1.0 - sy, sz, fy, fz - 1.0),
            factor(sy, 1.0 - sz, fy - 1.0, fz),
            factor(sy, sz, fy - 1.0, fz - 1.0),
        ];
        Cell { corners, factors, fx, sx: s_curve(fx) }
    }

    /// Channel `M` at the point. Inlined always: what the corners share then stays in registers.
    #[inline(always)]
    fn channel<const M: usize>(&self) -> f64 {
        let side = |first: usize| {
            let mut sum = f64x4::new([0.0; 4]);
            for i in 0..4 {
                let at = (self.corners[first + i] & 255) + 4 * M;
                let row = f64x4::new([VALUES[at], VALUES[at + 1], VALUES[at + 2], VALUES[at + 3]]);
                sum += row * self.factors[i];
            }
            sum.to_array()
        };
        let ([value, x, y, z], [value1, x1, y1, z1]) = (side(0), side(4));
        let near = (value + y) + (z + x * self.fx);
        let far = (value1 + y1) + (z1 + x1 * (self.fx - 1.0));
        near + self.sx * (far - near)
    }
}

/// Raw scalar noise, about -0.95 to 0.95.
#[inline]
pub(super) fn scalar(p: Vec3) -> f64 {
    Cell::at(p).channel::<0>()
}

/// Vector noise at a point: three channels of lattice noise, each about -1 to 1, the same for every generator.
pub fn dnoise(p: Vec3) -> Vec3 {
    let cell = Cell::at(p);
    Vec3::new(cell.channel::<0>(), cell.channel::<1>(), cell.channel::<2>())
}
