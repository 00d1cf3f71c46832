//! The test of one ray against a node's eight boxes: scalar and AVX2, with the same results.
#![allow(unsafe_code)]

use raggio_math::{Ray, Vec3};
use wide::f32x4;

use crate::node::{Node, WIDTH};

/// Makes up for the roundings of `inverse` and of `(side - origin) * inverse` at both ends.
pub(crate) const SLACK: f32 = 1.000_001;

/// Inverse directions are kept finite, so that no product of zero and infinity can arise.
const MAX_INVERSE: f32 = 1e37;

/// How far the origin is moved each way, as a share of itself: four units in the last place.
const ORIGIN_REACH: f32 = 1.0 / (1 << 22) as f32;

/// How far it is moved at least, so that a ray along a side at 0 stays within for any distance.
const LEAST_REACH: f32 = 1e-28;

/// Origins and directions beyond this overflow single precision.
const FAR: f32 = 1e37;

/// By the set of axes along which a ray goes backwards: which of a node's sides it enters by; by the other axes' set,
/// which it leaves by.
static SIDES: [[usize; 3]; 8] = sides();

const fn sides() -> [[usize; 3]; 8] {
    let mut table = [[0; 3]; 8];
    let mut set = 0;
    while set < 8 {
        table[set] = [3 * (set & 1), 1 + 3 * (set >> 1 & 1), 2 + 3 * (set >> 2)];
        set += 1;
    }
    table
}

/// A ray made ready for box tests, good for any number of trees in the same space. The origin is kept rounded both ways,
/// so that each box can only seem larger.
#[derive(Clone, Copy, Debug)]
pub struct Slab {
    /// Origin as used for the sides where the ray enters.
    pub(crate) origin_near: [f32; 4],
    /// Origin as used for the sides where it leaves.
    pub(crate) origin_far: [f32; 4],
    pub(crate) inverse: [f32; 4],
    /// Which of a node's `sides` the ray enters by.
    pub(crate) near: &'static [usize; 3],
    pub(crate) far: &'static [usize; 3],
    /// Rays with an infinite or undefined part touch nothing.
    pub(crate) finite: bool,
}

/// A vector in single precision.
#[inline]
fn single(v: Vec3) -> f32x4 {
    f32x4::new([v.x as f32, v.y as f32, v.z as f32, 0.0])
}

impl Slab {
    /// Prepares a ray. Not inlined: free of branches as it is, the compiler makes slabs before it knows whether any is
    /// wanted, which cost every leaf of every shape as much as its own test.
    #[inline(never)]
    pub fn new(ray: &Ray) -> Self {
        Slab::new_here(ray)
    }

    /// [`Slab::new`] for a function that is not inlined itself.
    #[inline(always)]
    pub fn new_here(ray: &Ray) -> Self {
        let (origin, dir) = (single(ray.origin), single(ray.dir));
        // No comparison holds for what is not a number.
        let within = |v: f32x4| v.abs().simd_lt(f32x4::splat(FAR)).all();
        let sign = f32x4::splat(-0.0);
        // More than the rounding to single precision may have done. A direction of -0 counts as backwards throughout.
        let reach = origin.abs() * f32x4::splat(ORIGIN_REACH) + f32x4::splat(LEAST_REACH);
        let reach = reach | (dir & sign);
        let most = f32x4::splat(MAX_INVERSE);
        let inverse = (f32x4::ONE / dir).fast_min(most).fast_max(-most);
        let backwards = (dir.to_bitmask() & 7) as usize;
        Slab {
            origin_near: (origin + reach).to_array(),
            origin_far: (origin - reach).to_array(),
            inverse: inverse.to_array(),
            near: &SIDES[backwards],
            far: &SIDES[7 - backwards],
            finite: within(origin) && within(dir),
        }
    }

    /// A ray that is in single precision already.
    #[inline(always)]
    pub(crate) fn exact(origin: [f32; 3], inverse: [f32; 3]) -> Self {
        let four = |v: [f32; 3]| [v[0], v[1], v[2], 0.0];
        let backwards = (0..3).fold(0, |set, k| set | usize::from(inverse[k] < 0.0) << k);
        Slab {
            origin_near: four(origin),
            origin_far: four(origin),
            inverse: four(inverse),
            near: &SIDES[backwards],
            far: &SIDES[7 - backwards],
            finite: true,
        }
    }
}

/// How to test eight boxes at once.
pub(crate) trait Kernel {
    /// Bits of the boxes that the ray touches between `t0` and `t1`, and where it enters and leaves each.
    ///
    /// # Safety
    /// The processor must have what the kernel uses.
    unsafe fn test(
        node: &Node,
        slab: &Slab,
        t0: f32,
        t1: f32,
        entry: &mut [f32; WIDTH],
        exit: &mut [f32; WIDTH],
    ) -> u32;
}

/// Plain Rust; works everywhere.
pub(crate) struct Scalar;

impl Kernel for Scalar {
    #[inline(always)]
    unsafe fn test(
        node: &Node,
        slab: &Slab,
        t0: f32,
        t1: f32,
        entry: &mut [f32; WIDTH],
        exit: &mut [f32; WIDTH],
    ) -> u32 {
        let mut mask = 0;
        for i in 0..WIDTH {
            let (mut near, mut far) = (t0, t1);
            for k in 0..3 {
                let a = (node.bounds[slab.near[k]][i] - slab.origin_near[k]) * slab.inverse[k];
                let b = (node.bounds[slab.far[k]][i] - slab.origin_far[k]) * slab.inverse[k] * SLACK;
                near = if a > near { a } else { near };
                far = if b < far { b } else { far };
            }
            (entry[i], exit[i]) = (near, far);
            mask |= u32::from(near <= far) << i;
        }
        mask
    }
}

/// Eight boxes in one 256-bit register per side.
#[cfg(target_arch = "x86_64")]
pub(crate) struct Avx2;

#[cfg(target_arch = "x86_64")]
impl Kernel for Avx2 {
    #[inline]
    #[target_feature(enable = "avx2")]
    unsafe fn test(
        node: &Node,
        slab: &Slab,
        t0: f32,
        t1: f32,
        entry: &mut [f32; WIDTH],
        exit: &mut [f32; WIDTH],
    ) -> u32 {
        use std::arch::x86_64::*;
        let (mut near, mut far) = (_mm256_set1_ps(t0), _mm256_set1_ps(t1));
        let slack = _mm256_set1_ps(SLACK);
        for k in 0..3 {
            let inverse = _mm256_set1_ps(slab.inverse[k]);
            // SAFETY: a slab's sides come from `SIDES`, which names no others than the six that there are; each is
            // eight floats, aligned to 32 bytes as a row of a `Node`.
            let side = |side: usize| unsafe { _mm256_load_ps(node.bounds.get_unchecked(side).as_ptr()) };
            let (enter, leave) = (side(slab.near[k]), side(slab.far[k]));
            let a = _mm256_mul_ps(_mm256_sub_ps(enter, _mm256_set1_ps(slab.origin_near[k])), inverse);
            let b = _mm256_mul_ps(_mm256_sub_ps(leave, _mm256_set1_ps(slab.origin_far[k])), inverse);
            // Both keep the second operand where one is not a number, as the scalar comparisons do.
            near = _mm256_max_ps(a, near);
            far = _mm256_min_ps(_mm256_mul_ps(b, slack), far);
        }
        // SAFETY: both have room for eight floats.
        unsafe {
            _mm256_storeu_ps(entry.as_mut_ptr(), near);
            _mm256_storeu_ps(exit.as_mut_ptr(), far);
        }
        _mm256_movemask_ps(_mm256_cmp_ps::<_CMP_LE_OQ>(near, far)) as u32
    }
}

/// Has this processor the wide kernel?
pub(crate) fn simd_available() -> bool {
    #[cfg(target_arch = "x86_64")]
    {
        std::arch::is_x86_feature_detected!("avx2")
    }
    #[cfg(not(target_arch = "x86_64"))]
    {
        false
    }
}
