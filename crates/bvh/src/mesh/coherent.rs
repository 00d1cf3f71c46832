//! What packets need besides rows of rays: whether their rays go the same way, and the children that wait for them.
#![allow(unsafe_code)]

use std::mem::MaybeUninit;

use super::STACK;

/// How far directions may lie apart, as a share of the longest part of any. Wider packets take longer than their rays
/// one by one, unless triangles are large.
const SPREAD: f32 = 0.125;

/// Beyond these lengths inverse directions lose digits.
const LENGTHS: (f32, f32) = (1e-18, 1e18);

/// The steepest axis of directions between least and greatest ones. `None` where they do not lie in one octant, and
/// close together.
#[inline]
pub(crate) fn steep_axis(dir: &[(f32, f32); 3]) -> Option<usize> {
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
pub(crate) struct Stack<'a> {
    pub(crate) entries: &'a mut [MaybeUninit<u64>; STACK],
    pub(crate) top: usize,
}

impl Stack<'_> {
    #[inline(always)]
    pub(crate) fn pop(&mut self) -> Option<(f32, u32)> {
        self.top = self.top.checked_sub(1)?;
        // SAFETY: everything below the old top was written.
        let entry = unsafe { self.entries[self.top].assume_init() };
        Some((f32::from_bits((entry >> 32) as u32), entry as u32))
    }

    /// Pushes a child among those of the same node, which begin at `base`.
    #[inline(always)]
    pub(crate) fn push(&mut self, base: usize, t: f32, word: u32) {
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
