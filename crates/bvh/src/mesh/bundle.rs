//! The traversal for packets, written once for rows of any number of lanes.

/// A module `$name` with the questions of packets to a mesh, compiled for `$features` over the rows of `$lanes`.
macro_rules! packet_kernel {
    ($name:ident, $lanes:ident, $features:literal) => {
        mod $name {
            use std::arch::x86_64::*;
            use std::mem::MaybeUninit;

            use crate::kernel::SLACK;
            use crate::mesh::block::{Block, MOST_POINTS};
            use crate::mesh::coherent::{Stack, steep_axis};
            use crate::mesh::lanes::$lanes::*;
            use crate::mesh::{LEAF, MeshBvh, Node, Packet, PacketHit, ROOT, STACK, block};

            /// Rows in a packet.
            const ROWS: usize = 16 / LANES;

            /// A number for each ray of a packet.
            type Rows = [Row; ROWS];

            /// As many rays of a packet as one row holds.
            #[derive(Clone, Copy)]
            struct Rays {
                origin: [Row; 3],
                inverse: [Row; 3],
                shear: [Row; 3],
                t_min: Row,
            }

            /// A packet whose rays all go into the same octant, and bounds over them.
            struct Bundle {
                rays: [Rays; ROWS],
                /// Rows of `Node::bounds` that are nearer and farther on each axis.
                near: [usize; 3],
                far: [usize; 3],
                /// Extreme origins for near and for far planes, and extreme inverse directions, in eight lanes.
                origin_near: [__m256; 3],
                origin_far: [__m256; 3],
                inverse_low: [__m256; 3],
                inverse_high: [__m256; 3],
                t_low: __m256,
                /// Axes, one that is steep for all rays last.
                k: [usize; 3],
            }

            /// The numbers of a row of rays.
            #[inline]
            #[target_feature(enable = $features)]
            fn row(numbers: &[f32; 16], r: usize) -> Row {
                load(&numbers.as_chunks().0[r])
            }

            /// The numbers of all rays.
            #[inline]
            #[target_feature(enable = $features)]
            fn rows(numbers: &[f32; 16]) -> Rows {
                let mut rows = [row(numbers, 0); ROWS];
                for (r, each) in rows.iter_mut().enumerate().skip(1) {
                    *each = row(numbers, r);
                }
                rows
            }

            /// The least and the greatest of the numbers of all rays.
            #[inline]
            #[target_feature(enable = $features)]
            fn extremes(numbers: &[f32; 16]) -> (f32, f32) {
                let rows = rows(numbers);
                let (mut low, mut high) = (rows[0], rows[0]);
                for &row in &rows[1..] {
                    (low, high) = (min(low, row), max(high, row));
                }
                (least(low), most(high))
            }

            /// The greatest of them.
            #[inline]
            #[target_feature(enable = $features)]
            fn greatest(rows: &Rows) -> f32 {
                let mut high = rows[0];
                for &row in &rows[1..] {
                    high = max(high, row);
                }
                most(high)
            }

            /// Is all that rays are made of finite, but for their ends, which are numbers?
            #[inline]
            #[target_feature(enable = $features)]
            fn is_sound(packet: &Packet) -> bool {
                let [zero, infinity] = [all(0.0), all(f32::INFINITY)];
                let mut sound = true;
                for r in 0..ROWS {
                    let mut sum = mul(row(&packet.t_min, r), zero);
                    for axis in 0..3 {
                        sum = fmadd(row(&packet.origin[axis], r), zero, sum);
                        sum = fmadd(row(&packet.dir[axis], r), zero, sum);
                    }
                    // What is not finite makes the sum not a number.
                    let ok = and(le(sum, zero), le(row(&packet.t_max, r), infinity));
                    sound &= bits(ok).count_ones() as usize == LANES;
                }
                sound
            }

            impl Rays {
                /// One row of a packet's rays, with their axes in turn, a steep one last.
                #[inline]
                #[target_feature(enable = $features)]
                fn new(packet: &Packet, r: usize, k: &[usize; 3]) -> Rays {
                    let (origin, dir) = (&packet.origin, &packet.dir);
                    let inverse = |axis: usize| div(all(1.0), row(&dir[axis], r));
                    let inv_z = inverse(k[2]);
                    Rays {
                        origin: [row(&origin[0], r), row(&origin[1], r), row(&origin[2], r)],
                        inverse: [inverse(0), inverse(1), inverse(2)],
                        shear: [mul(row(&dir[k[0]], r), inv_z), mul(row(&dir[k[1]], r), inv_z), inv_z],
                        t_min: row(&packet.t_min, r),
                    }
                }
            }

            impl Bundle {
                /// `None` where the rays had better be traced one by one.
                #[inline]
                #[target_feature(enable = $features)]
                fn new(packet: &Packet) -> Option<Bundle> {
                    let dir = [extremes(&packet.dir[0]), extremes(&packet.dir[1]), extremes(&packet.dir[2])];
                    if !is_sound(packet) {
                        return None;
                    }
                    let z = steep_axis(&dir)?;
                    let k = [(z + 1) % 3, (z + 2) % 3, z];
                    let mut rays = [Rays::new(packet, 0, &k); ROWS];
                    for (r, each) in rays.iter_mut().enumerate().skip(1) {
                        *each = Rays::new(packet, r, &k);
                    }
                    let mut bundle = Bundle {
                        rays,
                        near: [0; 3],
                        far: [0; 3],
                        origin_near: [_mm256_setzero_ps(); 3],
                        origin_far: [_mm256_setzero_ps(); 3],
                        inverse_low: [_mm256_setzero_ps(); 3],
                        inverse_high: [_mm256_setzero_ps(); 3],
                        t_low: _mm256_set1_ps(extremes(&packet.t_min).0),
                        k,
                    };
                    for (axis, (low, high)) in dir.into_iter().enumerate() {
                        let (first, last) = extremes(&packet.origin[axis]);
                        let negative = high < 0.0;
                        let (near, far) = if negative { (first, last) } else { (last, first) };
                        bundle.near[axis] = axis + 3 * usize::from(negative);
                        bundle.far[axis] = axis + 3 * usize::from(!negative);
                        bundle.origin_near[axis] = _mm256_set1_ps(near);
                        bundle.origin_far[axis] = _mm256_set1_ps(far);
                        // What divides more comes to less, rounded or not.
                        bundle.inverse_low[axis] = _mm256_set1_ps(1.0 / high);
                        bundle.inverse_high[axis] = _mm256_set1_ps(1.0 / low);
                    }
                    Some(bundle)
                }

                /// Children that some ray may enter before `t_high`, and a lower bound of where.
                #[inline]
                #[target_feature(enable = $features)]
                fn cull(&self, node: &Node, t_high: __m256) -> (u32, __m256) {
                    // SAFETY: rows of eight floats, aligned to 32 by the type.
                    let row = |r: usize| unsafe { _mm256_load_ps(node.bounds[r].as_ptr()) };
                    let (mut near, mut far) = (self.t_low, t_high);
                    for axis in 0..3 {
                        let a = _mm256_sub_ps(row(self.near[axis]), self.origin_near[axis]);
                        let b = _mm256_sub_ps(row(self.far[axis]), self.origin_far[axis]);
                        let (low, high) = (self.inverse_low[axis], self.inverse_high[axis]);
                        near =
                            _mm256_max_ps(near, _mm256_min_ps(_mm256_mul_ps(a, low), _mm256_mul_ps(a, high)));
                        let exit = _mm256_max_ps(_mm256_mul_ps(b, low), _mm256_mul_ps(b, high));
                        far = _mm256_min_ps(far, _mm256_mul_ps(exit, _mm256_set1_ps(SLACK)));
                    }
                    (_mm256_movemask_ps(_mm256_cmp_ps::<_CMP_LE_OQ>(near, far)) as u32, near)
                }

                /// Does any ray enter a child before its `t_max`?
                #[inline]
                #[target_feature(enable = $features)]
                fn enters(&self, node: &Node, slot: usize, t_max: &Rows) -> bool {
                    for (rays, &t_max) in self.rays.iter().zip(t_max) {
                        let plane = |side: usize, axis: usize| {
                            let side = all(node.bounds[side][slot]);
                            mul(sub(side, rays.origin[axis]), rays.inverse[axis])
                        };
                        let near = |axis: usize| plane(self.near[axis], axis);
                        let far = |axis: usize| plane(self.far[axis], axis);
                        let enter = max(max(near(0), near(1)), max(near(2), rays.t_min));
                        let leave = mul(min(min(far(0), far(1)), far(2)), all(SLACK));
                        if bits(le(enter, min(leave, t_max))) != 0 {
                            return true;
                        }
                    }
                    false
                }
            }

            /// The points of a block as a row of rays sees them.
            struct Seen([MaybeUninit<[Row; 3]>; MOST_POINTS]);

            impl Rays {
                /// The points of a block as the rays see them.
                #[inline]
                #[target_feature(enable = $features)]
                fn see<B: Block>(&self, block: &B, k: &[usize; 3], seen: &mut Seen) {
                    for (i, seen) in seen.0.iter_mut().enumerate().take(B::POINTS) {
                        let point = block.point(i);
                        let at = |axis: usize| sub(all(point[k[axis]]), self.origin[k[axis]]);
                        let z = at(2);
                        seen.write([fnmadd(self.shear[0], z, at(0)), fnmadd(self.shear[1], z, at(1)), z]);
                    }
                }

                /// Which rays hit one triangle of a block before their `t_max`, and where.
                #[inline]
                #[target_feature(enable = $features)]
                fn hit<B: Block>(
                    &self,
                    block: &B,
                    lane: usize,
                    seen: &Seen,
                    t_max: Row,
                ) -> Option<(Mask, Row)> {
                    // SAFETY: all points of the block were written.
                    let corner = |i: usize| unsafe { seen.0[block.corner_point(lane, i)].assume_init_ref() };
                    let (a, b, c) = (corner(0), corner(1), corner(2));
                    // No fused operation here: a shared edge must give exact negatives on its two sides.
                    let edge = |p: &[Row; 3], q: &[Row; 3]| sub(mul(p[0], q[1]), mul(p[1], q[0]));
                    let (u, v, w) = (edge(c, b), edge(a, c), edge(b, a));
                    let zero = all(0.0);
                    let (low, high) = (min(min(u, v), w), max(max(u, v), w));
                    let one_sided = or(le(zero, low), le(high, zero));
                    if bits(one_sided) == 0 {
                        return None;
                    }
                    let det = add(add(u, v), w);
                    let scaled = fmadd(w, c[2], fmadd(v, b[2], mul(u, a[2])));
                    let t = div(mul(scaled, self.shear[2]), det);
                    // A det of 0 makes t infinite or not a number, which no comparison accepts.
                    Some((and(one_sided, and(le(self.t_min, t), le(t, t_max))), t))
                }
            }

            /// Walks the tree for the rays, the nearest child first or the smallest. `leaf` is shown blocks, puts the rays'
            /// `t_max` where hits are, and says whether to go on.
            #[inline]
            #[target_feature(enable = $features)]
            fn walk<B: Block, const NEAREST: bool>(
                bvh: &MeshBvh,
                blocks: &[B],
                bundle: &Bundle,
                t_max: &mut Rows,
                mut leaf: impl FnMut(&B, &mut Rows) -> bool,
            ) {
                let mut room = [MaybeUninit::uninit(); STACK];
                let mut stack = Stack { entries: &mut room, top: 0 };
                stack.push(0, 0.0, ROOT);
                let mut t_high = greatest(t_max);
                while let Some((t, word)) = stack.pop() {
                    if t > t_high {
                        continue;
                    }
                    if word & LEAF != 0 {
                        if !leaf(block(blocks, word), t_max) {
                            return;
                        }
                        t_high = greatest(t_max);
                        continue;
                    }
                    let node = bvh.node(word);
                    let (mut mask, near) = bundle.cull(node, _mm256_set1_ps(t_high));
                    let mut entries = [0.0f32; 8];
                    // SAFETY: eight floats are written to an array of eight.
                    unsafe { _mm256_storeu_ps(entries.as_mut_ptr(), near) };
                    let base = stack.top;
                    // A few inner nodes are looked into sooner than asked about. More may be far apart.
                    let few = mask.count_ones() < 4;
                    while mask != 0 {
                        let slot = mask.trailing_zeros() as usize & 7;
                        mask &= mask - 1;
                        let inner = node.child[slot] & LEAF == 0;
                        if few && inner || bundle.enters(node, slot, t_max) {
                            // Otherwise the last is the smallest, and asked first.
                            let base = if NEAREST { base } else { stack.top };
                            stack.push(base, entries[slot], node.child[slot]);
                        }
                    }
                }
            }

            #[target_feature(enable = $features)]
            pub(super) fn closest<B: Block>(
                bvh: &MeshBvh,
                blocks: &[B],
                packet: &Packet,
            ) -> Option<PacketHit> {
                // Taken out of its place it would be copied.
                let bundle = &Bundle::new(packet);
                let bundle = bundle.as_ref()?;
                let mut seen = Seen([MaybeUninit::uninit(); MOST_POINTS]);
                let mut triangle = [word(u32::MAX); ROWS];
                let mut t_max = rows(&packet.t_max);
                walk::<B, true>(bvh, blocks, bundle, &mut t_max, |block, t_max| {
                    for (r, rays) in bundle.rays.iter().enumerate() {
                        rays.see(block, &bundle.k, &mut seen);
                        for lane in 0..block.lanes() {
                            if let Some((mask, t)) = rays.hit(block, lane, &seen, t_max[r]) {
                                t_max[r] = select(mask, t, t_max[r]);
                                triangle[r] = select(mask, word(block.triangle(lane)), triangle[r]);
                            }
                        }
                    }
                    true
                });
                let mut hit = PacketHit { t: [f32::INFINITY; 16], triangle: [u32::MAX; 16] };
                let mut numbers = [0.0; 16];
                for r in 0..ROWS {
                    store(t_max[r], &mut hit.t.as_chunks_mut().0[r]);
                    store(triangle[r], &mut numbers.as_chunks_mut().0[r]);
                }
                for i in 0..16 {
                    hit.triangle[i] = numbers[i].to_bits();
                    if hit.triangle[i] == u32::MAX {
                        hit.t[i] = f32::INFINITY;
                    }
                }
                Some(hit)
            }

            #[target_feature(enable = $features)]
            pub(super) fn any<B: Block>(bvh: &MeshBvh, blocks: &[B], packet: &Packet) -> Option<u16> {
                // Taken out of its place it would be copied.
                let bundle = &Bundle::new(packet);
                let bundle = bundle.as_ref()?;
                let mut seen = Seen([MaybeUninit::uninit(); MOST_POINTS]);
                let mut found = 0u16;
                let mut t_max = rows(&packet.t_max);
                let leaf = |block: &B, t_max: &mut Rows| {
                    for (r, rays) in bundle.rays.iter().enumerate() {
                        rays.see(block, &bundle.k, &mut seen);
                        for lane in 0..block.lanes() {
                            if let Some((mask, _)) = rays.hit(block, lane, &seen, t_max[r]) {
                                found |= bits(mask) << (r * LANES);
                                // A ray that has hit something enters nothing any more.
                                t_max[r] = select(mask, all(f32::NEG_INFINITY), t_max[r]);
                            }
                        }
                    }
                    found != 0xffff
                };
                match bvh.is_outside(&packet.ray(0).origin) {
                    true => walk::<B, true>(bvh, blocks, bundle, &mut t_max, leaf),
                    false => walk::<B, false>(bvh, blocks, bundle, &mut t_max, leaf),
                }
                Some(found)
            }
        }
    };
}
