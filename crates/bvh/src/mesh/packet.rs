//! Sixteen coherent rays at once, a lane each.
//!
//! A node's eight boxes are first tested against bounds of the whole packet (interval arithmetic over origins and
//! inverse directions, after Wald et al.: "Ray Tracing Animated Scenes using Coherent Grid Traversal", 2006); leaves
//! that survive are tested ray by ray, and nodes where many do. Rays that do not go the same way are traced one by one.
//!
//! One kernel, compiled twice: for two rows of eight lanes, and for one of sixteen.
#![allow(unsafe_code)]

use std::mem::MaybeUninit;

use super::wide::Isa;
use super::{MeshBvh, Packet, PacketHit, STACK};

/// How far directions may lie apart, as a share of the longest part of any. Wider packets take longer than their rays
/// one by one, unless triangles are large.
const SPREAD: f32 = 0.125;

/// Beyond these lengths inverse directions lose digits.
const LENGTHS: (f32, f32) = (1e-18, 1e18);

/// Asks the kernel of the mesh's instructions, if there is one that can answer.
macro_rules! dispatch {
    ($bvh:expr, $question:ident($packet:expr)) => {
        // SAFETY: as in `wide`, the mesh's `Isa` is one that the machine has.
        with_blocks!(&$bvh.blocks, list => match $bvh.isa {
            Isa::Scalar => None,
            #[cfg(target_arch = "x86_64")]
            Isa::Avx2 => unsafe { avx2::$question($bvh, list, $packet) },
            #[cfg(target_arch = "x86_64")]
            Isa::Avx512 => unsafe { avx512::$question($bvh, list, $packet) },
        })
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

/// The steepest axis of directions between least and greatest ones. `None` where they do not lie in one octant, and
/// close together.
#[inline]
fn steep_axis(dir: &[(f32, f32); 3]) -> Option<usize> {
    // On one side of 0 the least size of a part is one of its ends, on both sides it is negative.
    let steep = dir.map(|(low, high)| low.max(-high));
    let largest = dir.iter().fold(0.0, |a: f32, &(low, high)| a.max(high).max(-low));
    let flattest = steep[0].min(steep[1]).min(steep[2]);
    let spread = dir.iter().fold(0.0, |a: f32, &(low, high)| a.max(high - low));
    let even = flattest > LENGTHS.0.max(1e-12 * largest) && largest < LENGTHS.1;
    let z = if steep[0] > steep[1] { 0 } else { 1 };
    (even && spread <= SPREAD * largest).then_some(if steep[2] > steep[z] { 2 } else { z })
}

/// Children waiting, the nearest on top. The room is borrowed: as a field beside `top` it would be zeroed for each
/// packet.
struct Stack<'a> {
    entries: &'a mut [MaybeUninit<u64>; STACK],
    top: usize,
}

impl Stack<'_> {
    #[inline(always)]
    fn pop(&mut self) -> Option<(f32, u32)> {
        self.top = self.top.checked_sub(1)?;
        // SAFETY: everything below the old top was written.
        let entry = unsafe { self.entries[self.top].assume_init() };
        Some((f32::from_bits((entry >> 32) as u32), entry as u32))
    }

    /// Pushes a child among those of the same node, which begin at `base`.
    #[inline(always)]
    fn push(&mut self, base: usize, t: f32, word: u32) {
        let entry = u64::from(t.max(0.0).to_bits()) << 32 | u64::from(word);
        let mut at = self.top;
        // SAFETY: entries base..top were written.
        while at > base && unsafe { self.entries[at - 1].assume_init() } < entry {
            self.entries[at] = self.entries[at - 1];
            at -= 1;
        }
        self.entries[at].write(entry);
        self.top += 1;
    }
}

#[cfg(target_arch = "x86_64")]
packet_kernel!(avx2, eight, "avx2,fma,bmi1,bmi2");
#[cfg(target_arch = "x86_64")]
packet_kernel!(avx512, sixteen, "avx2,fma,bmi1,bmi2,avx512f,avx512vl,avx512dq");
