//! Sixteen coherent rays at once, a lane each.
//!
//! A node's eight boxes are first tested against bounds of the whole packet (interval arithmetic over origins and
//! inverse directions, after Wald et al.: "Ray Tracing Animated Scenes using Coherent Grid Traversal", 2006); only
//! what survives is tested ray by ray. Rays that do not go the same way are traced one by one.
#![allow(unsafe_code)]

use super::{MeshBvh, Packet, PacketHit};

/// See [`MeshBvh::closest_packet`].
pub(crate) fn closest(bvh: &MeshBvh, packet: &Packet) -> PacketHit {
    #[cfg(target_arch = "x86_64")]
    if bvh.isa == super::wide::Isa::Avx512 {
        // SAFETY: the machine has what `Isa::Avx512` names.
        if let Some(hit) = with_blocks!(&bvh.blocks, list => unsafe { x86::closest(bvh, list, packet) }) {
            return hit;
        }
    }
    let mut hit = PacketHit { t: [f32::INFINITY; 16], triangle: [u32::MAX; 16] };
    for i in 0..16 {
        if let Some(h) = bvh.closest(&packet.ray(i)) {
            (hit.t[i], hit.triangle[i]) = (h.t, h.triangle);
        }
    }
    hit
}

/// See [`MeshBvh::any_packet`].
pub(crate) fn any(bvh: &MeshBvh, packet: &Packet) -> u16 {
    #[cfg(target_arch = "x86_64")]
    if bvh.isa == super::wide::Isa::Avx512 {
        // SAFETY: as in `closest`.
        if let Some(mask) = with_blocks!(&bvh.blocks, list => unsafe { x86::any(bvh, list, packet) }) {
            return mask;
        }
    }
    (0..16).map(|i| u16::from(bvh.any(&packet.ray(i))) << i).sum()
}

#[cfg(target_arch = "x86_64")]
mod x86 {
    use std::arch::x86_64::*;
    use std::mem::MaybeUninit;

    use crate::kernel::SLACK;
    use crate::mesh::{Block, LEAF, MeshBvh, Node, Packet, PacketHit, ROOT, STACK, block};

    /// A packet whose rays all go into the same octant, and bounds over them.
    struct Bundle {
        origin: [__m512; 3],
        inv_dir: [__m512; 3],
        t_min: __m512,
        /// Rows of `Node::bounds` that are nearer and farther on each axis.
        near: [usize; 3],
        far: [usize; 3],
        /// Extreme origins for near and for far planes, and extreme inverse directions, in eight lanes.
        origin_near: [__m256; 3],
        origin_far: [__m256; 3],
        inv_low: [__m256; 3],
        inv_high: [__m256; 3],
        t_low: __m256,
        k: [usize; 3],
        shear: [__m512; 3],
    }

    impl Bundle {
        /// `None` where the rays are not of one octant, or no axis is steep for all of them.
        #[inline]
        #[target_feature(enable = "avx2,fma,avx512f,avx512vl,avx512dq")]
        fn new(packet: &Packet) -> Option<Bundle> {
            // SAFETY: rows of 16 floats, aligned to 64 by the type.
            let load = |row: &[f32; 16]| unsafe { _mm512_load_ps(row.as_ptr()) };
            let (origin, dir) = (packet.origin.each_ref().map(load), packet.dir.each_ref().map(load));
            let zero = _mm512_setzero_ps();
            let mut negative = [false; 3];
            for axis in 0..3 {
                let below = _mm512_cmp_ps_mask::<_CMP_LT_OQ>(dir[axis], zero);
                let above = _mm512_cmp_ps_mask::<_CMP_GT_OQ>(dir[axis], zero);
                if below != 0xffff && above != 0xffff {
                    return None;
                }
                negative[axis] = below == 0xffff;
            }
            let steep: [f32; 3] = std::array::from_fn(|axis| _mm512_reduce_min_ps(_mm512_abs_ps(dir[axis])));
            let kz = if steep[0] > steep[1] { 0 } else { 1 };
            let kz = if steep[2] > steep[kz] { 2 } else { kz };
            let largest =
                (0..3).map(|axis| _mm512_reduce_max_ps(_mm512_abs_ps(dir[axis]))).fold(0.0, f32::max);
            let flattest = steep.iter().fold(f32::INFINITY, |a, &b| a.min(b));
            if steep[kz] < 0.25 * largest || flattest < 1e-12 * largest {
                return None;
            }
            let one = _mm512_set1_ps(1.0);
            let inv_dir = dir.map(|d| _mm512_div_ps(one, d));
            let k = [(kz + 1) % 3, (kz + 2) % 3, kz];
            let low = |v: __m512| _mm256_set1_ps(_mm512_reduce_min_ps(v));
            let high = |v: __m512| _mm256_set1_ps(_mm512_reduce_max_ps(v));
            let pick =
                |axis: usize, low_side: bool| if low_side { low(origin[axis]) } else { high(origin[axis]) };
            let t_min = load(&packet.t_min);
            Some(Bundle {
                near: std::array::from_fn(|axis| axis + 3 * usize::from(negative[axis])),
                far: std::array::from_fn(|axis| axis + 3 * usize::from(!negative[axis])),
                origin_near: std::array::from_fn(|axis| pick(axis, negative[axis])),
                origin_far: std::array::from_fn(|axis| pick(axis, !negative[axis])),
                inv_low: inv_dir.map(low),
                inv_high: inv_dir.map(high),
                t_low: low(t_min),
                shear: [
                    _mm512_mul_ps(dir[k[0]], inv_dir[kz]),
                    _mm512_mul_ps(dir[k[1]], inv_dir[kz]),
                    inv_dir[kz],
                ],
                origin,
                inv_dir,
                t_min,
                k,
            })
        }

        /// Children that some ray may enter before `t_high`, and a lower bound of where.
        #[inline]
        #[target_feature(enable = "avx2,fma,avx512f,avx512vl,avx512dq")]
        fn cull(&self, node: &Node, t_high: __m256) -> (u32, __m256) {
            // SAFETY: rows of eight floats, aligned to 32 by the type.
            let row = |r: usize| unsafe { _mm256_load_ps(node.bounds[r].as_ptr()) };
            let (mut near, mut far) = (self.t_low, t_high);
            for axis in 0..3 {
                let a = _mm256_sub_ps(row(self.near[axis]), self.origin_near[axis]);
                let b = _mm256_sub_ps(row(self.far[axis]), self.origin_far[axis]);
                let (low, high) = (self.inv_low[axis], self.inv_high[axis]);
                near = _mm256_max_ps(near, _mm256_min_ps(_mm256_mul_ps(a, low), _mm256_mul_ps(a, high)));
                let exit = _mm256_max_ps(_mm256_mul_ps(b, low), _mm256_mul_ps(b, high));
                far = _mm256_min_ps(far, _mm256_mul_ps(exit, _mm256_set1_ps(SLACK)));
            }
            (u32::from(_mm256_cmp_ps_mask::<_CMP_LE_OQ>(near, far)), near)
        }

        /// Which rays enter a child before their `t_max`.
        #[inline]
        #[target_feature(enable = "avx2,fma,avx512f,avx512vl,avx512dq")]
        fn enter(&self, node: &Node, slot: usize, t_max: __m512) -> u16 {
            let plane = |row: usize, axis: usize| {
                let side = _mm512_set1_ps(node.bounds[row][slot]);
                _mm512_mul_ps(_mm512_sub_ps(side, self.origin[axis]), self.inv_dir[axis])
            };
            let near = |axis: usize| plane(self.near[axis], axis);
            let far = |axis: usize| plane(self.far[axis], axis);
            let enter = _mm512_max_ps(_mm512_max_ps(near(0), near(1)), _mm512_max_ps(near(2), self.t_min));
            let leave = _mm512_min_ps(_mm512_min_ps(far(0), far(1)), far(2));
            let leave = _mm512_min_ps(_mm512_mul_ps(leave, _mm512_set1_ps(SLACK)), t_max);
            _mm512_cmp_ps_mask::<_CMP_LE_OQ>(enter, leave)
        }

        /// Which rays hit one triangle of a block before their `t_max`, and where.
        #[inline]
        #[target_feature(enable = "avx2,fma,avx512f,avx512vl,avx512dq")]
        fn hit<B: Block>(&self, block: &B, lane: usize, t_max: __m512) -> (u16, __m512) {
            let at = |corner: usize, k: usize| {
                let axis = self.k[k];
                _mm512_sub_ps(_mm512_set1_ps(block.corner(lane, corner)[axis]), self.origin[axis])
            };
            let sheared = |corner: usize| {
                let z = at(corner, 2);
                let x = _mm512_fnmadd_ps(self.shear[0], z, at(corner, 0));
                let y = _mm512_fnmadd_ps(self.shear[1], z, at(corner, 1));
                (x, y, z)
            };
            let (a, b, c) = (sheared(0), sheared(1), sheared(2));
            let edge = |p: (__m512, __m512, __m512), q: (__m512, __m512, __m512)| {
                _mm512_sub_ps(_mm512_mul_ps(p.0, q.1), _mm512_mul_ps(p.1, q.0))
            };
            let (u, v, w) = (edge(c, b), edge(a, c), edge(b, a));
            let zero = _mm512_setzero_ps();
            let least = _mm512_min_ps(_mm512_min_ps(u, v), w);
            let most = _mm512_max_ps(_mm512_max_ps(u, v), w);
            let one_sided =
                _mm512_cmp_ps_mask::<_CMP_GE_OQ>(least, zero) | _mm512_cmp_ps_mask::<_CMP_LE_OQ>(most, zero);
            if one_sided == 0 {
                return (0, zero);
            }
            let det = _mm512_add_ps(_mm512_add_ps(u, v), w);
            let scaled = _mm512_fmadd_ps(w, c.2, _mm512_fmadd_ps(v, b.2, _mm512_mul_ps(u, a.2)));
            let t = _mm512_div_ps(_mm512_mul_ps(scaled, self.shear[2]), det);
            let after = _mm512_mask_cmp_ps_mask::<_CMP_GE_OQ>(one_sided, t, self.t_min);
            (_mm512_mask_cmp_ps_mask::<_CMP_LE_OQ>(after, t, t_max), t)
        }
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

    /// Walks the tree for the rays, the nearest child first or the smallest; `leaf` is shown blocks and answers with
    /// `t_max` of all rays.
    #[inline]
    #[target_feature(enable = "avx2,fma,avx512f,avx512vl,avx512dq")]
    fn walk<B: Block, const NEAREST: bool>(
        bvh: &MeshBvh,
        blocks: &[B],
        bundle: &Bundle,
        mut t_max: __m512,
        mut leaf: impl FnMut(&B, __m512) -> Option<__m512>,
    ) {
        let mut room = [MaybeUninit::uninit(); STACK];
        let mut stack = Stack { entries: &mut room, top: 0 };
        stack.push(0, 0.0, ROOT);
        let mut t_high = _mm512_reduce_max_ps(t_max);
        while let Some((t, word)) = stack.pop() {
            if t > t_high {
                continue;
            }
            if word & LEAF != 0 {
                match leaf(block(blocks, word), t_max) {
                    Some(shorter) => t_max = shorter,
                    None => return,
                }
                t_high = _mm512_reduce_max_ps(t_max);
                continue;
            }
            let node = bvh.node(word);
            let (mut mask, near) = bundle.cull(node, _mm256_set1_ps(t_high));
            let mut entries = [0.0f32; 8];
            // SAFETY: eight floats are written to an array of eight.
            unsafe { _mm256_storeu_ps(entries.as_mut_ptr(), near) };
            let base = stack.top;
            while mask != 0 {
                let slot = mask.trailing_zeros() as usize & 7;
                mask &= mask - 1;
                if bundle.enter(node, slot, t_max) != 0 {
                    // Otherwise the last is the smallest, and asked first.
                    let base = if NEAREST { base } else { stack.top };
                    stack.push(base, entries[slot], node.child[slot]);
                }
            }
        }
    }

    #[target_feature(enable = "avx2,fma,avx512f,avx512vl,avx512dq")]
    pub(super) fn closest<B: Block>(bvh: &MeshBvh, blocks: &[B], packet: &Packet) -> Option<PacketHit> {
        let bundle = Bundle::new(packet)?;
        // SAFETY: sixteen floats, aligned to 64 by the type.
        let t_max = unsafe { _mm512_load_ps(packet.t_max.as_ptr()) };
        let mut triangle = _mm512_set1_epi32(-1);
        let mut nearest = t_max;
        walk::<B, true>(bvh, blocks, &bundle, t_max, |block, mut t_max| {
            for lane in 0..block.lanes() {
                let (mask, t) = bundle.hit(block, lane, t_max);
                t_max = _mm512_mask_mov_ps(t_max, mask, t);
                triangle = _mm512_mask_set1_epi32(triangle, mask, block.triangle(lane) as i32);
            }
            nearest = t_max;
            Some(t_max)
        });
        let missed = _mm512_cmpeq_epi32_mask(triangle, _mm512_set1_epi32(-1));
        let t = _mm512_mask_mov_ps(nearest, missed, _mm512_set1_ps(f32::INFINITY));
        let mut hit = PacketHit { t: [0.0; 16], triangle: [0; 16] };
        // SAFETY: arrays of sixteen, aligned to 64 by the type.
        unsafe {
            _mm512_store_ps(hit.t.as_mut_ptr(), t);
            _mm512_store_si512(hit.triangle.as_mut_ptr().cast(), triangle);
        }
        Some(hit)
    }

    #[target_feature(enable = "avx2,fma,avx512f,avx512vl,avx512dq")]
    pub(super) fn any<B: Block>(bvh: &MeshBvh, blocks: &[B], packet: &Packet) -> Option<u16> {
        let bundle = Bundle::new(packet)?;
        // SAFETY: sixteen floats, aligned to 64 by the type.
        let t_max = unsafe { _mm512_load_ps(packet.t_max.as_ptr()) };
        let mut found = 0u16;
        let leaf = |block: &B, mut t_max| {
            for lane in 0..block.lanes() {
                let (mask, _) = bundle.hit(block, lane, t_max);
                found |= mask;
                // A ray that has hit something enters nothing any more.
                t_max = _mm512_mask_mov_ps(t_max, mask, _mm512_set1_ps(f32::NEG_INFINITY));
            }
            (found != 0xffff).then_some(t_max)
        };
        match bvh.is_outside(&packet.ray(0).origin) {
            true => walk::<B, true>(bvh, blocks, &bundle, t_max, leaf),
            false => walk::<B, false>(bvh, blocks, &bundle, t_max, leaf),
        }
        Some(found)
    }
}
