//! The corners of a leaf's triangles: which of them lie in one place.
use raggio_math::Wide;
use wide::u32x8;

use super::block::{MOST_CORNERS, POINTS};

/// Corners in rows of eight.
const ROWS: usize = MOST_CORNERS.div_ceil(8);

/// The corners of a few triangles, one after the other: the bits of their coordinates. What is not in use lies where the
/// first corner does.
pub(super) struct Corners([[[u32; 8]; ROWS]; 3]);

/// The places of corners, each once.
pub(super) struct Points {
    pub(super) place: [[f32; POINTS]; 3],
    /// For each corner which place it is.
    pub(super) which: [u8; MOST_CORNERS],
}

impl Corners {
    #[inline(always)]
    pub(super) fn all_at(p: [f32; 3]) -> Corners {
        Corners(p.map(|c| [[c.to_bits(); 8]; ROWS]))
    }

    #[inline(always)]
    pub(super) fn set(&mut self, corner: usize, p: [f32; 3]) {
        for (rows, c) in self.0.iter_mut().zip(p) {
            rows[corner / 8][corner % 8] = c.to_bits();
        }
    }

    /// The first of all corners that lies where this one does.
    #[inline(always)]
    fn first(&self, corner: usize) -> usize {
        let [x, y, z] = &self.0;
        let own = |rows: &[[u32; 8]; ROWS]| u32x8::splat(rows[corner / 8][corner % 8]);
        let (own_x, own_y, own_z) = (own(x), own(y), own(z));
        let mut same = 0;
        // It is not after this one.
        for row in 0..=corner / 8 {
            let x = own_x.simd_eq(u32x8::new(x[row]));
            let y = own_y.simd_eq(u32x8::new(y[row]));
            let z = own_z.simd_eq(u32x8::new(z[row]));
            same |= (x & y & z).to_bitmask() << (8 * row);
        }
        same.trailing_zeros() as usize
    }
}

/// `None` if they have too many places. Nobody could foresee which corners lie in one place, so there are no branches on
/// it.
impl Wide for &Corners {
    type Output = Option<Points>;

    #[inline(always)]
    fn run(self) -> Option<Points> {
        let mut points = Points { place: [[0.0; POINTS]; 3], which: [0; MOST_CORNERS] };
        let mut from = [0u8; MOST_CORNERS + 1];
        let mut count = 0;
        for corner in 0..MOST_CORNERS {
            let first = self.first(corner);
            // What is no new place is overwritten by the next that is.
            from[count] = corner as u8;
            points.which[corner] = count as u8;
            points.which[corner] = points.which[first];
            count += usize::from(first == corner);
        }
        if count > POINTS {
            return None;
        }
        for (places, rows) in points.place.iter_mut().zip(&self.0) {
            for (place, &corner) in places.iter_mut().zip(&from[..count]) {
                *place = f32::from_bits(rows[usize::from(corner / 8)][usize::from(corner % 8)]);
            }
        }
        Some(points)
    }
}
