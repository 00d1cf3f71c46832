//! The traversal with wide instructions: eight boxes at a time, four to eight triangles at a time.
//!
//! One kernel, compiled twice: for AVX2, and for AVX-512, whose 32 registers hold all of a ray.
#![allow(unsafe_code)]

use raggio_math::Ray;

use super::{MeshBvh, MeshHit, MeshRay, TriangleHit, scalar};

/// Which kernel a machine runs.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Isa {
    /// Plain Rust.
    Scalar,
    #[cfg(target_arch = "x86_64")]
    Avx2,
    #[cfg(target_arch = "x86_64")]
    Avx512,
}

impl Isa {
    /// Everything this machine can run, the best last.
    pub(crate) fn all() -> Vec<Isa> {
        #[allow(unused_mut)]
        let mut all = vec![Isa::Scalar];
        #[cfg(target_arch = "x86_64")]
        {
            let avx2 = is_x86_feature_detected!("avx2") && is_x86_feature_detected!("fma");
            if avx2 && is_x86_feature_detected!("bmi1") && is_x86_feature_detected!("bmi2") {
                all.push(Isa::Avx2);
                let wider = is_x86_feature_detected!("avx512f") && is_x86_feature_detected!("avx512vl");
                if wider && is_x86_feature_detected!("avx512dq") {
                    all.push(Isa::Avx512);
                }
            }
        }
        all
    }
}

/// Asks the kernel of the mesh's instructions and of its kind of blocks.
macro_rules! dispatch {
    ($bvh:expr, $question:ident($($argument:expr),*)) => {
        // SAFETY: `Isa::all` names only what the machine can run, and it is the only source of an `Isa`.
        with_blocks!(&$bvh.blocks, list => match $bvh.isa {
            Isa::Scalar => scalar::$question($bvh, list, $($argument),*),
            #[cfg(target_arch = "x86_64")]
            Isa::Avx2 => unsafe { avx2::$question($bvh, list, $($argument),*) },
            #[cfg(target_arch = "x86_64")]
            Isa::Avx512 => unsafe { avx512::$question($bvh, list, $($argument),*) },
        })
    };
}

/// See [`MeshBvh::closest`].
#[inline]
pub(crate) fn closest(bvh: &MeshBvh, ray: &MeshRay) -> Option<MeshHit> {
    dispatch!(bvh, closest(ray))
}

/// See [`MeshBvh::any`].
#[inline]
pub(crate) fn any(bvh: &MeshBvh, ray: &MeshRay) -> bool {
    dispatch!(bvh, any(ray))
}

/// See [`MeshBvh::nearest`].
#[inline]
pub(crate) fn nearest(
    bvh: &MeshBvh,
    ray: &Ray,
    range: (f64, f64),
    stops: impl FnMut(&TriangleHit) -> bool,
) -> Option<TriangleHit> {
    dispatch!(bvh, nearest(ray, range, stops))
}

/// See [`MeshBvh::all`].
#[inline]
pub(crate) fn all(bvh: &MeshBvh, ray: &Ray, range: (f64, f64), found: impl FnMut(TriangleHit)) {
    dispatch!(bvh, all(ray, range, found));
}

// Sixteen registers are too few for both boxes and triangles: in one function with the way through the boxes, what waits
// for a triangle waits for memory as well.
#[cfg(target_arch = "x86_64")]
kernel!(avx2, "avx2,fma,bmi1,bmi2", inline(never));
#[cfg(target_arch = "x86_64")]
kernel!(avx512, "avx2,fma,bmi1,bmi2,avx512f,avx512vl,avx512dq", inline);
