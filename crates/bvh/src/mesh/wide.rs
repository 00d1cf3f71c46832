//! The traversal with wide instructions: eight boxes at a time, four triangles at a time.
//!
//! One kernel, compiled twice: for AVX2, and for AVX-512, whose 32 registers hold all of a ray.
#![allow(unsafe_code)]

use super::{MeshBvh, MeshHit, MeshRay, scalar};

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

/// See [`MeshBvh::closest`].
#[inline]
pub(crate) fn closest(isa: Isa, bvh: &MeshBvh, root: u32, ray: &MeshRay) -> Option<MeshHit> {
    // SAFETY: `Isa::all` names only what the machine can run, and it is the only source of an `Isa`.
    match isa {
        Isa::Scalar => scalar::closest(bvh, root, ray),
        #[cfg(target_arch = "x86_64")]
        Isa::Avx2 => unsafe { avx2::closest(bvh, root, ray) },
        #[cfg(target_arch = "x86_64")]
        Isa::Avx512 => unsafe { avx512::closest(bvh, root, ray) },
    }
}

/// See [`MeshBvh::any`].
#[inline]
pub(crate) fn any(isa: Isa, bvh: &MeshBvh, root: u32, ray: &MeshRay) -> bool {
    // SAFETY: as in `closest`.
    match isa {
        Isa::Scalar => scalar::any(bvh, root, ray),
        #[cfg(target_arch = "x86_64")]
        Isa::Avx2 => unsafe { avx2::any(bvh, root, ray) },
        #[cfg(target_arch = "x86_64")]
        Isa::Avx512 => unsafe { avx512::any(bvh, root, ray) },
    }
}

#[cfg(target_arch = "x86_64")]
kernel!(avx2, "avx2,fma,bmi1,bmi2");
#[cfg(target_arch = "x86_64")]
kernel!(avx512, "avx2,fma,bmi1,bmi2,avx512f,avx512vl,avx512dq");
