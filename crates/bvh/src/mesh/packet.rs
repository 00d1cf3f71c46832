//! Sixteen coherent rays at once, a lane each.
//!
//! A node's eight boxes are first tested against bounds of the whole packet (interval arithmetic over origins and
//! inverse directions, after Wald et al.: "Ray Tracing Animated Scenes using Coherent Grid Traversal", 2006); leaves
//! that survive are tested ray by ray, and nodes where many do. Rays that do not go the same way are traced one by one.
//!
//! One kernel, compiled twice: for two rows of eight lanes, and for one of sixteen.
#![allow(unsafe_code)]

use super::wide::Isa;
use super::{MeshBvh, Packet, PacketHit};

/// Asks the kernel of the mesh's instructions, if there is one that can answer.
macro_rules! dispatch {
    ($bvh:expr, $question:ident($packet:expr)) => {
        // SAFETY: as in `wide`, the mesh's `Isa` is one that the machine has.
        match $bvh.isa {
            Isa::Scalar => None,
            #[cfg(target_arch = "x86_64")]
            Isa::Avx2 => unsafe { with_blocks!(&$bvh.blocks, list => avx2::$question($bvh, list, $packet)) },
            #[cfg(target_arch = "x86_64")]
            Isa::Avx512 => unsafe { with_blocks!(&$bvh.blocks, list => avx512::$question($bvh, list, $packet)) },
        }
    };
}

/// See [`MeshBvh::closest_packet`].
pub(crate) fn closest(bvh: &MeshBvh, packet: &Packet) -> PacketHit {
    dispatch!(bvh, closest(packet)).unwrap_or_else(|| {
        let mut hit = PacketHit { t: [f32::INFINITY; 16], triangle: [u32::MAX; 16] };
        for (i, ray) in packet.rays().iter().enumerate() {
            if let Some(h) = bvh.closest(ray) {
                (hit.t[i], hit.triangle[i]) = (h.t, h.triangle);
            }
        }
        hit
    })
}

/// See [`MeshBvh::any_packet`].
pub(crate) fn any(bvh: &MeshBvh, packet: &Packet) -> u16 {
    dispatch!(bvh, any(packet)).unwrap_or_else(|| {
        packet.rays().iter().enumerate().map(|(i, ray)| u16::from(bvh.any(ray)) << i).sum()
    })
}

#[cfg(target_arch = "x86_64")]
packet_kernel!(avx2, eight, "avx2,fma,bmi1,bmi2");
#[cfg(target_arch = "x86_64")]
packet_kernel!(avx512, sixteen, "avx2,fma,bmi1,bmi2,avx512f,avx512vl,avx512dq");
