//! Up to eight boxes side by side, tested at once: for groups too small for a tree.
#![allow(unsafe_code)]

use raggio_math::Aabb;

#[cfg(target_arch = "x86_64")]
use crate::kernel::Avx2;
use crate::kernel::{Kernel, Scalar, Slab, simd_available};
use crate::node::{Node, WIDTH};
use crate::round::{down, not_before, not_behind, up};

/// A row of boxes, known by their places in it. Boxes may be empty, and infinite on any side.
#[derive(Clone)]
pub struct BoxRow {
    pub(crate) node: Node,
    /// Has the processor the wide kernel?
    #[cfg_attr(not(target_arch = "x86_64"), allow(dead_code))]
    simd: bool,
}

/// The boxes of a row that a ray touches.
pub struct Touched {
    mask: u32,
    near: [f32; WIDTH],
    far: [f32; WIDTH],
}

/// A box that a ray touches.
pub struct Touch {
    /// Its place in the row.
    pub place: usize,
    /// The part of the ray's range that may lie in it.
    pub range: (f64, f64),
}

/// Entries are not rounded down; this share makes up for it.
const SLACK: f64 = 1e-6;

impl Default for BoxRow {
    fn default() -> Self {
        BoxRow { node: Node::EMPTY, simd: simd_available() }
    }
}

impl BoxRow {
    /// The most boxes in a row.
    pub const MOST: usize = WIDTH;

    /// A row of the first [`BoxRow::MOST`] of some boxes.
    pub fn new(boxes: &[Aabb]) -> Self {
        let mut row = BoxRow::default();
        boxes.iter().take(WIDTH).enumerate().for_each(|(place, b)| row.put(place, b));
        row
    }

    /// Puts a box at a place where there is none yet.
    #[inline]
    pub fn put(&mut self, place: usize, b: &Aabb) {
        if !b.is_empty() {
            for k in 0..3 {
                self.node.bounds[k][place] = down(b.min[k]);
                self.node.bounds[k + 3][place] = up(b.max[k]);
            }
        }
    }

    /// Takes a box out.
    pub fn take_out(&mut self, place: usize) {
        for (bounds, none) in self.node.bounds.iter_mut().zip(&Node::EMPTY.bounds) {
            bounds[place] = none[place];
        }
    }

    /// Takes all boxes out.
    pub fn clear(&mut self) {
        self.node = Node::EMPTY;
    }

    /// The boxes that the ray touches within the range, whose start is taken to be at least 0. Rays with an infinite
    /// or undefined part touch nothing.
    #[inline]
    pub fn touched(&self, slab: &Slab, range: (f64, f64)) -> Touched {
        #[cfg(target_arch = "x86_64")]
        if self.simd {
            // SAFETY: `simd` says that the processor has AVX2.
            return unsafe { self.touched_avx2(slab, range) };
        }
        self.touched_by::<Scalar>(slab, range)
    }

    #[cfg(target_arch = "x86_64")]
    #[target_feature(enable = "avx2")]
    fn touched_avx2(&self, slab: &Slab, range: (f64, f64)) -> Touched {
        self.touched_by::<Avx2>(slab, range)
    }

    /// [`BoxRow::touched`] by any kernel that the processor has.
    #[inline(always)]
    fn touched_by<K: Kernel>(&self, slab: &Slab, range: (f64, f64)) -> Touched {
        let mut touched = Touched { mask: 0, near: [0.0; WIDTH], far: [0.0; WIDTH] };
        if slab.finite {
            let (t0, t1) = (not_behind(range.0), not_before(range.1));
            // SAFETY: the caller chose a kernel that the processor has.
            touched.mask = unsafe { K::test(&self.node, slab, t0, t1, &mut touched.near, &mut touched.far) };
        }
        touched
    }
}

impl Touched {
    /// The box that the ray enters first of those left, if it does so before `far`.
    #[inline]
    pub fn next(&mut self, far: f64) -> Option<Touch> {
        let mut rest = self.mask;
        if rest == 0 {
            return None;
        }
        let mut first = rest.trailing_zeros() as usize & 7;
        rest &= rest - 1;
        while rest != 0 {
            let i = rest.trailing_zeros() as usize & 7;
            rest &= rest - 1;
            if self.near[i] < self.near[first] {
                first = i;
            }
        }
        self.mask &= !(1 << first);
        let range = (f64::from(self.near[first]) * (1.0 - SLACK), far.min(f64::from(self.far[first])));
        (range.0 <= far).then_some(Touch { place: first, range })
    }

    /// Leaves out a place; says whether its box was among those left.
    #[inline]
    pub fn take(&mut self, place: usize) -> bool {
        let rest = self.mask & !(1 << place);
        std::mem::replace(&mut self.mask, rest) != rest
    }

    /// The places of all boxes touched, as bits.
    #[inline]
    pub fn places(&self) -> u32 {
        self.mask
    }

    /// The places of all boxes touched, in their order in the row.
    #[inline]
    pub fn each(self, mut visit: impl FnMut(usize)) {
        let mut rest = self.mask;
        while rest != 0 {
            visit(rest.trailing_zeros() as usize & 7);
            rest &= rest - 1;
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use raggio_math::{Ray, Vec3};

    #[test]
    fn boxes_come_in_the_order_in_which_they_are_entered() {
        let unit = |x: f64| Aabb::new(Vec3::new(x, -1.0, -1.0), Vec3::new(x + 1.0, 1.0, 1.0));
        let aside = Aabb::new(Vec3::new(0.0, 2.0, 0.0), Vec3::new(9.0, 3.0, 1.0));
        let mut half = Aabb::INFINITE;
        half.max.x = 2.5;
        let mut row = BoxRow::new(&[unit(5.0), aside, unit(2.0), Aabb::EMPTY, half, unit(-9.0)]);
        let ray = Ray::new(Vec3::ZERO, Vec3::X);
        for simd in [row.simd, false] {
            row.simd = simd;
            let order = |far: f64| {
                let mut touched = row.touched(&Slab::new(&ray), (0.5, 10.0));
                std::iter::from_fn(|| touched.next(far)).map(|t| t.place).collect::<Vec<_>>()
            };
            assert_eq!(order(10.0), [4, 2, 0]);
            assert_eq!(order(3.0), [4, 2]);
            let mut all = Vec::new();
            row.touched(&Slab::new(&ray), (0.5, 10.0)).each(|i| all.push(i));
            assert_eq!(all, [0, 2, 4]);
            assert_eq!(row.touched(&Slab::new(&ray), (0.5, 4.0)).mask, 0b10100);
        }
    }
}
