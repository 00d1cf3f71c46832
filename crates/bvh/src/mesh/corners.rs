//! The corners of a leaf's triangles: which of them lie in one place.
use wide::u32x8;

use super::block::{MOST_CORNERS, POINTS};

/// Corners in rows of eight.
const ROWS: usize = MOST_CORNERS.div_ceil(8);

/// The corners of a few triangles, one after the other: the bits of their coordinates.
pub(super) struct Corners {
    place: [[[u32; 8]; ROWS]; 3],
    len: usize,
}

impl Corners {
    pub(super) const NONE: Corners = Corners { place: [[[0; 8]; ROWS]; 3], len: 0 };

    #[inline(always)]
    pub(super) fn push(&mut self, p: [f32; 3]) {
        for (rows, c) in self.place.iter_mut().zip(p) {
            rows[self.len / 8][self.len % 8] = c.to_bits();
        }
        self.len += 1;
    }

    /// The first of all corners that lies where this one does.
    #[inline(always)]
    fn first(&self, i: usize) -> usize {
        let own = self.place.map(|rows| u32x8::splat(rows[i / 8][i % 8]));
        let mut same = 0;
        // It is not after this one.
        for row in 0..=i / 8 {
            let equal = |axis: usize| own[axis].simd_eq(u32x8::new(self.place[axis][row]));
            same |= (equal(0) & equal(1) & equal(2)).to_bitmask() << (8 * row);
        }
        same.trailing_zeros() as usize
    }

    /// The places of the corners, each once, and for each corner which of them it is; `None` if they are too many.
    /// Nobody could foresee which corners lie in one place, so there are no branches on it.
    #[inline(always)]
    pub(super) fn points(&self) -> Option<([[f32; POINTS]; 3], [u8; MOST_CORNERS])> {
        let (mut which, mut from, mut count) = ([0; MOST_CORNERS], [0; MOST_CORNERS + 1], 0);
        for i in 0..self.len {
            let first = self.first(i);
            // What is no new place is overwritten by the next that is.
            (which[i], from[count]) = (count as u8, i);
            which[i] = which[first];
            count += usize::from(first == i);
        }
        let point = |axis: usize| {
            std::array::from_fn(|k| {
                if k < count { f32::from_bits(self.place[axis][from[k] / 8][from[k] % 8]) } else { 0.0 }
            })
        };
        (count <= POINTS).then(|| ([point(0), point(1), point(2)], which))
    }
}
