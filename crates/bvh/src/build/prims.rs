//! Primitives while a tree is built, and the boxes that grow around them.
use raggio_math::{Aabb, Vec3};
use rayon::prelude::*;
use wide::f32x4;

/// Longer runs are shared among threads, in chunks of this.
pub(super) const CHUNK: usize = 1 << 14;

/// A box that grows. The fourth lane is not looked at.
#[derive(Clone, Copy, Debug)]
#[repr(C, align(16))]
pub(crate) struct Bounds {
    pub(crate) lo: [f32; 4],
    pub(crate) hi: [f32; 4],
}

impl Bounds {
    pub(crate) const EMPTY: Bounds = Bounds { lo: [f32::INFINITY; 4], hi: [f32::NEG_INFINITY; 4] };

    #[inline(always)]
    pub(crate) fn grow(&mut self, other: &Bounds) {
        self.lo = least(f32x4::new(other.lo), f32x4::new(self.lo)).to_array();
        self.hi = most(f32x4::new(other.hi), f32x4::new(self.hi)).to_array();
    }

    /// What is not a number makes it no larger.
    #[inline(always)]
    pub(super) fn grow_to(&mut self, point: f32x4) {
        self.grow(&Bounds { lo: point.to_array(), hi: point.to_array() });
    }

    /// A box around both.
    #[inline(always)]
    pub(super) fn joined(mut self, other: &Bounds) -> Bounds {
        self.grow(other);
        self
    }

    #[inline(always)]
    pub(super) fn half_area(&self) -> f32 {
        let d = [self.hi[0] - self.lo[0], self.hi[1] - self.lo[1], self.hi[2] - self.lo[2]];
        if d[0] < 0.0 { 0.0 } else { d[0] * d[1] + d[1] * d[2] + d[2] * d[0] }
    }

    pub(crate) fn aabb(&self) -> Aabb {
        let corner = |c: &[f32; 4]| Vec3::new(f64::from(c[0]), f64::from(c[1]), f64::from(c[2]));
        Aabb { min: corner(&self.lo), max: corner(&self.hi) }
    }
}

/// The lesser in each lane, `b` where `a` is not a number: the quick one sees to that on some processors only.
#[inline(always)]
fn least(a: f32x4, b: f32x4) -> f32x4 {
    if cfg!(target_feature = "sse") { a.fast_min(b) } else { a.min(b) }
}

/// The same for the greater.
#[inline(always)]
fn most(a: f32x4, b: f32x4) -> f32x4 {
    if cfg!(target_feature = "sse") { a.fast_max(b) } else { a.max(b) }
}

/// A primitive while the tree is built: its box, and its number in the fourth lane, where no number below 2^30 makes
/// anything but a small positive float.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Prim(Bounds);

impl Prim {
    #[inline(always)]
    pub(crate) fn new(mut bounds: Bounds, number: u32) -> Prim {
        bounds.lo[3] = f32::from_bits(number);
        // Sums of both are 1 whatever the number, so that no denormal number gets into a product.
        bounds.hi[3] = 1.0;
        Prim(bounds)
    }

    #[inline(always)]
    pub(super) fn bounds(&self) -> &Bounds {
        &self.0
    }

    pub(crate) fn number(&self) -> u32 {
        self.0.lo[3].to_bits()
    }

    #[inline(always)]
    pub(super) fn twice_centre(&self) -> f32x4 {
        f32x4::new(self.0.lo) + f32x4::new(self.0.hi)
    }
}

/// A run of primitives on its way into a child.
#[derive(Clone, Copy, Debug)]
pub(super) struct Run {
    pub(super) len: usize,
    pub(super) bounds: Bounds,
    /// Bounds of twice the centres.
    pub(super) centres: Bounds,
}

impl Run {
    const EMPTY: Run = Run { len: 0, bounds: Bounds::EMPTY, centres: Bounds::EMPTY };

    pub(super) fn of(prims: &[Prim]) -> Run {
        let one = |prims: &[Prim]| {
            let mut run = Run::EMPTY;
            prims.iter().for_each(|prim| run.add(prim));
            run
        };
        match prims.len() <= 2 * CHUNK {
            true => one(prims),
            false => prims.par_chunks(CHUNK).map(one).reduce(|| Run::EMPTY, Run::joined),
        }
    }

    #[inline(always)]
    fn add(&mut self, prim: &Prim) {
        self.bounds.grow(&prim.0);
        self.centres.grow_to(prim.twice_centre());
        self.len += 1;
    }

    fn joined(mut self, other: Run) -> Run {
        self.bounds.grow(&other.bounds);
        self.centres.grow(&other.centres);
        self.len += other.len;
        self
    }
}
